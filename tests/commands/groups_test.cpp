// Which attribute group holds which state (GL 1.5 tables 6.5 to 6.34): every state variable is changed under
// every single bit of PushAttrib and PushClientAttrib, and comes back with those of its groups and no other.
#include <gtest/gtest.h>

#include <functional>

#include "state_dump.h"
#include "state_fixture.h"

namespace terrazzo::test {
namespace {

using Gl = kit::Gl;

struct State {
    const char* name;
    GLbitfield groups;
    std::function<void(const Gl& gl)> change;
};

constexpr GLfloat kVector[4] = {0.125f, 0.25f, 0.375f, 0.75f};
constexpr GLdouble kPlane[4] = {1, 2, 3, 4};
constexpr GLubyte kPattern[128] = {0x5a, 0x81};
constexpr GLfloat kValues[64] = {0.5f, 0.25f, 1, 0.125f};

// Every capability and its group beside the one of enables.
struct Capability {
    GLenum name;
    GLbitfield group;
};
constexpr Capability kCapabilities[] = {
    {GL_ALPHA_TEST, GL_COLOR_BUFFER_BIT},
    {GL_BLEND, GL_COLOR_BUFFER_BIT},
    {GL_DITHER, GL_COLOR_BUFFER_BIT},
    {GL_COLOR_LOGIC_OP, GL_COLOR_BUFFER_BIT},
    {GL_INDEX_LOGIC_OP, GL_COLOR_BUFFER_BIT},
    {GL_CLIP_PLANE0, GL_TRANSFORM_BIT},
    {GL_CLIP_PLANE3, GL_TRANSFORM_BIT},
    {GL_CLIP_PLANE5, GL_TRANSFORM_BIT},
    {GL_NORMALIZE, GL_TRANSFORM_BIT},
    {GL_RESCALE_NORMAL, GL_TRANSFORM_BIT},
    {GL_DEPTH_CLAMP, GL_TRANSFORM_BIT},
    {GL_LIGHTING, GL_LIGHTING_BIT},
    {GL_COLOR_MATERIAL, GL_LIGHTING_BIT},
    {GL_LIGHT0, GL_LIGHTING_BIT},
    {GL_LIGHT4, GL_LIGHTING_BIT},
    {GL_LIGHT7, GL_LIGHTING_BIT},
    {GL_FOG, GL_FOG_BIT},
    {GL_COLOR_SUM, GL_FOG_BIT},
    {GL_CULL_FACE, GL_POLYGON_BIT},
    {GL_POLYGON_SMOOTH, GL_POLYGON_BIT},
    {GL_POLYGON_STIPPLE, GL_POLYGON_BIT},
    {GL_POLYGON_OFFSET_FILL, GL_POLYGON_BIT},
    {GL_POLYGON_OFFSET_LINE, GL_POLYGON_BIT},
    {GL_POLYGON_OFFSET_POINT, GL_POLYGON_BIT},
    {GL_LINE_SMOOTH, GL_LINE_BIT},
    {GL_LINE_STIPPLE, GL_LINE_BIT},
    {GL_POINT_SMOOTH, GL_POINT_BIT},
    {GL_POINT_SPRITE, GL_POINT_BIT},
    {GL_DEPTH_TEST, GL_DEPTH_BUFFER_BIT},
    {GL_STENCIL_TEST, GL_STENCIL_BUFFER_BIT},
    {GL_SCISSOR_TEST, GL_SCISSOR_BIT},
    {GL_MULTISAMPLE, GL_MULTISAMPLE_BIT},
    {GL_SAMPLE_ALPHA_TO_COVERAGE, GL_MULTISAMPLE_BIT},
    {GL_SAMPLE_ALPHA_TO_ONE, GL_MULTISAMPLE_BIT},
    {GL_SAMPLE_COVERAGE, GL_MULTISAMPLE_BIT},
    {GL_AUTO_NORMAL, GL_EVAL_BIT},
    {GL_MAP1_COLOR_4, GL_EVAL_BIT},
    {GL_MAP1_VERTEX_4, GL_EVAL_BIT},
    {GL_MAP2_INDEX, GL_EVAL_BIT},
    {GL_MAP2_TEXTURE_COORD_3, GL_EVAL_BIT},
    {GL_TEXTURE_1D, GL_TEXTURE_BIT},
    {GL_TEXTURE_2D, GL_TEXTURE_BIT},
    {GL_TEXTURE_3D, GL_TEXTURE_BIT},
    {GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BIT},
    {GL_TEXTURE_GEN_S, GL_TEXTURE_BIT},
    {GL_TEXTURE_GEN_T, GL_TEXTURE_BIT},
    {GL_TEXTURE_GEN_R, GL_TEXTURE_BIT},
    {GL_TEXTURE_GEN_Q, GL_TEXTURE_BIT},
};

void on_unit(const Gl& gl, GLenum unit, const std::function<void()>& change) {
    GLint active = 0;
    gl.GetIntegerv(GL_ACTIVE_TEXTURE, &active);
    gl.ActiveTexture(unit);
    change();
    gl.ActiveTexture(static_cast<GLenum>(active));
}

const State kServerStates[] = {
    {"color", GL_CURRENT_BIT, [](auto& gl) { gl.Color4fv(kVector); }},
    {"index", GL_CURRENT_BIT, [](auto& gl) { gl.Indexf(7); }},
    {"texture coordinates 0", GL_CURRENT_BIT, [](auto& gl) { gl.TexCoord4fv(kVector); }},
    {"texture coordinates 7", GL_CURRENT_BIT, [](auto& gl) { gl.MultiTexCoord4fv(GL_TEXTURE7, kVector); }},
    {"normal", GL_CURRENT_BIT, [](auto& gl) { gl.Normal3fv(kVector); }},
    {"fog coordinate", GL_CURRENT_BIT, [](auto& gl) { gl.FogCoordf(0.5f); }},
    {"secondary color", GL_CURRENT_BIT, [](auto& gl) { gl.SecondaryColor3fv(kVector); }},
    {"edge flag", GL_CURRENT_BIT, [](auto& gl) { gl.EdgeFlag(0); }},
    {"raster position", GL_CURRENT_BIT, [](auto& gl) { gl.RasterPos3f(0.5f, 0.25f, 0.125f); }},
    {"raster position, invalid", GL_CURRENT_BIT, [](auto& gl) { gl.RasterPos2f(5, 5); }},

    {"matrix mode", GL_TRANSFORM_BIT, [](auto& gl) { gl.MatrixMode(GL_PROJECTION); }},
    {"clip plane 0", GL_TRANSFORM_BIT, [](auto& gl) { gl.ClipPlane(GL_CLIP_PLANE0, kPlane); }},
    {"clip plane 4", GL_TRANSFORM_BIT, [](auto& gl) { gl.ClipPlane(GL_CLIP_PLANE4, kPlane); }},
    {"clip origin", GL_TRANSFORM_BIT, [](auto& gl) { gl.ClipControl(GL_UPPER_LEFT, GL_NEGATIVE_ONE_TO_ONE); }},
    {"clip depths", GL_TRANSFORM_BIT, [](auto& gl) { gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE); }},
    {"modelview matrix", 0, [](auto& gl) { gl.Translatef(1, 2, 3); }},
    {"texture matrix", 0,
     [](auto& gl) {
         GLint mode = 0;
         gl.GetIntegerv(GL_MATRIX_MODE, &mode);
         gl.MatrixMode(GL_TEXTURE);
         gl.Scalef(2, 3, 4);
         gl.MatrixMode(static_cast<GLenum>(mode));
     }},
    {"matrix stack", 0, [](auto& gl) { gl.PushMatrix(); }},

    {"viewport", GL_VIEWPORT_BIT, [](auto& gl) { gl.Viewport(1, 2, 3, 4); }},
    {"depth range", GL_VIEWPORT_BIT, [](auto& gl) { gl.DepthRange(0.25, 0.5); }},

    {"fog color", GL_FOG_BIT, [](auto& gl) { gl.Fogfv(GL_FOG_COLOR, kVector); }},
    {"fog density", GL_FOG_BIT, [](auto& gl) { gl.Fogf(GL_FOG_DENSITY, 2); }},
    {"fog start", GL_FOG_BIT, [](auto& gl) { gl.Fogf(GL_FOG_START, 2); }},
    {"fog end", GL_FOG_BIT, [](auto& gl) { gl.Fogf(GL_FOG_END, 2); }},
    {"fog index", GL_FOG_BIT, [](auto& gl) { gl.Fogf(GL_FOG_INDEX, 2); }},
    {"fog mode", GL_FOG_BIT, [](auto& gl) { gl.Fogi(GL_FOG_MODE, GL_LINEAR); }},
    {"fog source", GL_FOG_BIT, [](auto& gl) { gl.Fogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE); }},
    {"fog distance", GL_FOG_BIT, [](auto& gl) { gl.Fogi(GL_FOG_DISTANCE_MODE_NV, GL_EYE_RADIAL_NV); }},

    {"shade model", GL_LIGHTING_BIT, [](auto& gl) { gl.ShadeModel(GL_FLAT); }},
    {"color material", GL_LIGHTING_BIT, [](auto& gl) { gl.ColorMaterial(GL_BACK, GL_AMBIENT); }},
    {"front material", GL_LIGHTING_BIT, [](auto& gl) { gl.Materialfv(GL_FRONT, GL_EMISSION, kVector); }},
    {"back material", GL_LIGHTING_BIT, [](auto& gl) { gl.Materialfv(GL_BACK, GL_SPECULAR, kVector); }},
    {"shininess", GL_LIGHTING_BIT, [](auto& gl) { gl.Materialf(GL_BACK, GL_SHININESS, 3); }},
    {"material indices", GL_LIGHTING_BIT, [](auto& gl) { gl.Materialfv(GL_FRONT, GL_COLOR_INDEXES, kVector); }},
    {"model ambient", GL_LIGHTING_BIT, [](auto& gl) { gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, kVector); }},
    {"model viewer", GL_LIGHTING_BIT, [](auto& gl) { gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1); }},
    {"model sides", GL_LIGHTING_BIT, [](auto& gl) { gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1); }},
    {"model control", GL_LIGHTING_BIT,
     [](auto& gl) { gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR); }},
    {"light ambient", GL_LIGHTING_BIT, [](auto& gl) { gl.Lightfv(GL_LIGHT2, GL_AMBIENT, kVector); }},
    {"light position", GL_LIGHTING_BIT, [](auto& gl) { gl.Lightfv(GL_LIGHT6, GL_POSITION, kVector); }},
    {"light direction", GL_LIGHTING_BIT, [](auto& gl) { gl.Lightfv(GL_LIGHT0, GL_SPOT_DIRECTION, kVector); }},
    {"light cutoff", GL_LIGHTING_BIT, [](auto& gl) { gl.Lightf(GL_LIGHT7, GL_SPOT_CUTOFF, 30); }},
    {"light attenuation", GL_LIGHTING_BIT, [](auto& gl) { gl.Lightf(GL_LIGHT3, GL_LINEAR_ATTENUATION, 2); }},

    {"point size", GL_POINT_BIT, [](auto& gl) { gl.PointSize(3); }},
    {"point minimum", GL_POINT_BIT, [](auto& gl) { gl.PointParameterf(GL_POINT_SIZE_MIN, 3); }},
    {"point maximum", GL_POINT_BIT, [](auto& gl) { gl.PointParameterf(GL_POINT_SIZE_MAX, 3); }},
    {"point threshold", GL_POINT_BIT, [](auto& gl) { gl.PointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 3); }},
    {"point attenuation", GL_POINT_BIT,
     [](auto& gl) { gl.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, kVector); }},
    {"line width", GL_LINE_BIT, [](auto& gl) { gl.LineWidth(3); }},
    {"line stipple", GL_LINE_BIT, [](auto& gl) { gl.LineStipple(3, 0x1234); }},
    {"cull face", GL_POLYGON_BIT, [](auto& gl) { gl.CullFace(GL_FRONT); }},
    {"front face", GL_POLYGON_BIT, [](auto& gl) { gl.FrontFace(GL_CW); }},
    {"front mode", GL_POLYGON_BIT, [](auto& gl) { gl.PolygonMode(GL_FRONT, GL_LINE); }},
    {"back mode", GL_POLYGON_BIT, [](auto& gl) { gl.PolygonMode(GL_BACK, GL_POINT); }},
    {"offset factor", GL_POLYGON_BIT, [](auto& gl) { gl.PolygonOffset(1, 0); }},
    {"offset units", GL_POLYGON_BIT, [](auto& gl) { gl.PolygonOffset(0, 1); }},
    {"polygon stipple", GL_POLYGON_STIPPLE_BIT, [](auto& gl) { gl.PolygonStipple(kPattern); }},
    {"sample coverage", GL_MULTISAMPLE_BIT, [](auto& gl) { gl.SampleCoverage(0.5f, 0); }},
    {"sample inversion", GL_MULTISAMPLE_BIT, [](auto& gl) { gl.SampleCoverage(1, 1); }},

    {"active texture", GL_TEXTURE_BIT, [](auto& gl) { gl.ActiveTexture(GL_TEXTURE3); }},
    {"binding", GL_TEXTURE_BIT, [](auto& gl) { gl.BindTexture(GL_TEXTURE_2D, 5); }},
    {"binding on unit 4", GL_TEXTURE_BIT,
     [](auto& gl) { on_unit(gl, GL_TEXTURE4, [&] { gl.BindTexture(GL_TEXTURE_3D, 6); }); }},
    {"wrap", GL_TEXTURE_BIT, [](auto& gl) { gl.TexParameteri(GL_TEXTURE_1D, GL_TEXTURE_WRAP_S, GL_CLAMP); }},
    {"filter", GL_TEXTURE_BIT,
     [](auto& gl) { gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_NEAREST); }},
    {"border", GL_TEXTURE_BIT, [](auto& gl) { gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, kVector); }},
    {"priority", GL_TEXTURE_BIT, [](auto& gl) { gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_PRIORITY, 0.5f); }},
    {"comparison", GL_TEXTURE_BIT,
     [](auto& gl) { gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL); }},
    {"environment mode", GL_TEXTURE_BIT,
     [](auto& gl) { gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL); }},
    {"environment color on unit 7", GL_TEXTURE_BIT,
     [](auto& gl) { on_unit(gl, GL_TEXTURE7, [&] { gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, kVector); }); }},
    {"combine", GL_TEXTURE_BIT, [](auto& gl) { gl.TexEnvi(GL_TEXTURE_ENV, GL_OPERAND2_ALPHA, GL_ONE_MINUS_SRC_ALPHA); }},
    {"bias of detail", GL_TEXTURE_BIT,
     [](auto& gl) { gl.TexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 2); }},
    {"coordinate replacement", GL_POINT_BIT, [](auto& gl) { gl.TexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, 1); }},
    {"generation mode", GL_TEXTURE_BIT, [](auto& gl) { gl.TexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP); }},
    {"generation plane", GL_TEXTURE_BIT,
     [](auto& gl) { on_unit(gl, GL_TEXTURE1, [&] { gl.TexGenfv(GL_Q, GL_EYE_PLANE, kVector); }); }},

    {"scissor box", GL_SCISSOR_BIT, [](auto& gl) { gl.Scissor(1, 2, 3, 4); }},
    {"alpha function", GL_COLOR_BUFFER_BIT, [](auto& gl) { gl.AlphaFunc(GL_LESS, 0); }},
    {"alpha reference", GL_COLOR_BUFFER_BIT, [](auto& gl) { gl.AlphaFunc(GL_ALWAYS, 0.5f); }},
    {"stencil function", GL_STENCIL_BUFFER_BIT, [](auto& gl) { gl.StencilFunc(GL_LESS, 0, ~0u); }},
    {"stencil reference", GL_STENCIL_BUFFER_BIT, [](auto& gl) { gl.StencilFunc(GL_ALWAYS, 5, ~0u); }},
    {"stencil value mask", GL_STENCIL_BUFFER_BIT, [](auto& gl) { gl.StencilFunc(GL_ALWAYS, 0, 7); }},
    {"stencil fail", GL_STENCIL_BUFFER_BIT, [](auto& gl) { gl.StencilOp(GL_INCR, GL_KEEP, GL_KEEP); }},
    {"stencil depth fail", GL_STENCIL_BUFFER_BIT, [](auto& gl) { gl.StencilOp(GL_KEEP, GL_DECR, GL_KEEP); }},
    {"stencil pass", GL_STENCIL_BUFFER_BIT, [](auto& gl) { gl.StencilOp(GL_KEEP, GL_KEEP, GL_ZERO); }},
    {"stencil mask", GL_STENCIL_BUFFER_BIT, [](auto& gl) { gl.StencilMask(3); }},
    {"stencil clear", GL_STENCIL_BUFFER_BIT, [](auto& gl) { gl.ClearStencil(3); }},
    {"depth function", GL_DEPTH_BUFFER_BIT, [](auto& gl) { gl.DepthFunc(GL_GREATER); }},
    {"depth mask", GL_DEPTH_BUFFER_BIT, [](auto& gl) { gl.DepthMask(0); }},
    {"depth clear", GL_DEPTH_BUFFER_BIT, [](auto& gl) { gl.ClearDepth(0.5); }},
    {"blend source", GL_COLOR_BUFFER_BIT, [](auto& gl) { gl.BlendFunc(GL_DST_COLOR, GL_ZERO); }},
    {"blend destination", GL_COLOR_BUFFER_BIT, [](auto& gl) { gl.BlendFunc(GL_ONE, GL_SRC_COLOR); }},
    {"blend of alpha", GL_COLOR_BUFFER_BIT,
     [](auto& gl) { gl.BlendFuncSeparate(GL_ONE, GL_ZERO, GL_ZERO, GL_ONE); }},
    {"blend equation", GL_COLOR_BUFFER_BIT, [](auto& gl) { gl.BlendEquation(GL_MIN); }},
    {"blend color", GL_COLOR_BUFFER_BIT, [](auto& gl) { gl.BlendColor(1, 0.5f, 0.25f, 0.125f); }},
    {"logic operation", GL_COLOR_BUFFER_BIT, [](auto& gl) { gl.LogicOp(GL_XOR); }},
    {"draw buffer", GL_COLOR_BUFFER_BIT, [](auto& gl) { gl.DrawBuffer(GL_NONE); }},
    {"color mask", GL_COLOR_BUFFER_BIT, [](auto& gl) { gl.ColorMask(1, 0, 1, 1); }},
    {"index mask", GL_COLOR_BUFFER_BIT, [](auto& gl) { gl.IndexMask(7); }},
    {"color clear", GL_COLOR_BUFFER_BIT, [](auto& gl) { gl.ClearColor(0.5f, 0.25f, 0, 1); }},
    {"index clear", GL_COLOR_BUFFER_BIT, [](auto& gl) { gl.ClearIndex(7); }},
    {"accumulation clear", GL_ACCUM_BUFFER_BIT, [](auto& gl) { gl.ClearAccum(0.5f, 0.25f, 0, 1); }},

    {"read buffer", GL_PIXEL_MODE_BIT, [](auto& gl) { gl.ReadBuffer(GL_LEFT); }},
    {"pixel zoom", GL_PIXEL_MODE_BIT, [](auto& gl) { gl.PixelZoom(2, 3); }},
    {"scale", GL_PIXEL_MODE_BIT, [](auto& gl) { gl.PixelTransferf(GL_GREEN_SCALE, 2); }},
    {"bias", GL_PIXEL_MODE_BIT, [](auto& gl) { gl.PixelTransferf(GL_ALPHA_BIAS, 2); }},
    {"depth scale", GL_PIXEL_MODE_BIT, [](auto& gl) { gl.PixelTransferf(GL_DEPTH_SCALE, 2); }},
    {"map of colors", GL_PIXEL_MODE_BIT, [](auto& gl) { gl.PixelTransferi(GL_MAP_COLOR, 1); }},
    {"map of stencil", GL_PIXEL_MODE_BIT, [](auto& gl) { gl.PixelTransferi(GL_MAP_STENCIL, 1); }},
    {"index shift", GL_PIXEL_MODE_BIT, [](auto& gl) { gl.PixelTransferi(GL_INDEX_SHIFT, 1); }},
    {"index offset", GL_PIXEL_MODE_BIT, [](auto& gl) { gl.PixelTransferi(GL_INDEX_OFFSET, 1); }},
    {"pixel map", 0, [](auto& gl) { gl.PixelMapfv(GL_PIXEL_MAP_R_TO_R, 2, kValues); }},

    {"evaluator grid 1", GL_EVAL_BIT, [](auto& gl) { gl.MapGrid1f(3, 0, 2); }},
    {"evaluator grid 2", GL_EVAL_BIT, [](auto& gl) { gl.MapGrid2f(3, 0, 2, 4, 1, 3); }},
    {"evaluator map", 0, [](auto& gl) { gl.Map1f(GL_MAP1_VERTEX_3, 0, 2, 3, 2, kValues); }},
    {"perspective hint", GL_HINT_BIT, [](auto& gl) { gl.Hint(GL_PERSPECTIVE_CORRECTION_HINT, GL_FASTEST); }},
    {"fog hint", GL_HINT_BIT, [](auto& gl) { gl.Hint(GL_FOG_HINT, GL_NICEST); }},
    {"point hint", GL_HINT_BIT, [](auto& gl) { gl.Hint(GL_POINT_SMOOTH_HINT, GL_NICEST); }},
    {"line hint", GL_HINT_BIT, [](auto& gl) { gl.Hint(GL_LINE_SMOOTH_HINT, GL_NICEST); }},
    {"polygon hint", GL_HINT_BIT, [](auto& gl) { gl.Hint(GL_POLYGON_SMOOTH_HINT, GL_NICEST); }},
    {"mipmap hint", GL_HINT_BIT, [](auto& gl) { gl.Hint(GL_GENERATE_MIPMAP_HINT, GL_NICEST); }},
    {"compression hint", GL_HINT_BIT, [](auto& gl) { gl.Hint(GL_TEXTURE_COMPRESSION_HINT, GL_NICEST); }},
    {"list base", GL_LIST_BIT, [](auto& gl) { gl.ListBase(9); }},

    {"client pixel store", 0, [](auto& gl) { gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 9); }},
    {"client arrays", 0, [](auto& gl) { gl.EnableClientState(GL_NORMAL_ARRAY); }},
    {"array buffer", 0, [](auto& gl) { gl.BindBuffer(GL_ARRAY_BUFFER, 3); }},
    {"feedback buffer", 0,
     [](auto& gl) {
         static GLfloat values[4];
         gl.FeedbackBuffer(4, GL_3D, values);
     }},
};

constexpr GLbitfield kPixelStore = GL_CLIENT_PIXEL_STORE_BIT, kArrays = GL_CLIENT_VERTEX_ARRAY_BIT;
const State kClientStates[] = {
    {"pack swap", kPixelStore, [](auto& gl) { gl.PixelStorei(GL_PACK_SWAP_BYTES, 1); }},
    {"pack order", kPixelStore, [](auto& gl) { gl.PixelStorei(GL_PACK_LSB_FIRST, 1); }},
    {"pack row", kPixelStore, [](auto& gl) { gl.PixelStorei(GL_PACK_ROW_LENGTH, 5); }},
    {"pack rows", kPixelStore, [](auto& gl) { gl.PixelStorei(GL_PACK_SKIP_ROWS, 5); }},
    {"pack pixels", kPixelStore, [](auto& gl) { gl.PixelStorei(GL_PACK_SKIP_PIXELS, 5); }},
    {"pack images", kPixelStore, [](auto& gl) { gl.PixelStorei(GL_PACK_SKIP_IMAGES, 5); }},
    {"pack height", kPixelStore, [](auto& gl) { gl.PixelStorei(GL_PACK_IMAGE_HEIGHT, 5); }},
    {"pack alignment", kPixelStore, [](auto& gl) { gl.PixelStorei(GL_PACK_ALIGNMENT, 1); }},
    {"unpack swap", kPixelStore, [](auto& gl) { gl.PixelStorei(GL_UNPACK_SWAP_BYTES, 1); }},
    {"unpack order", kPixelStore, [](auto& gl) { gl.PixelStorei(GL_UNPACK_LSB_FIRST, 1); }},
    {"unpack row", kPixelStore, [](auto& gl) { gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 5); }},
    {"unpack rows", kPixelStore, [](auto& gl) { gl.PixelStorei(GL_UNPACK_SKIP_ROWS, 5); }},
    {"unpack pixels", kPixelStore, [](auto& gl) { gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 5); }},
    {"unpack images", kPixelStore, [](auto& gl) { gl.PixelStorei(GL_UNPACK_SKIP_IMAGES, 5); }},
    {"unpack height", kPixelStore, [](auto& gl) { gl.PixelStorei(GL_UNPACK_IMAGE_HEIGHT, 5); }},
    {"unpack alignment", kPixelStore, [](auto& gl) { gl.PixelStorei(GL_UNPACK_ALIGNMENT, 8); }},
    {"pack buffer", kPixelStore, [](auto& gl) { gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 3); }},
    {"unpack buffer", kPixelStore, [](auto& gl) { gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 3); }},
    {"vertex array", kArrays, [](auto& gl) { gl.EnableClientState(GL_VERTEX_ARRAY); }},
    {"normal array", kArrays, [](auto& gl) { gl.EnableClientState(GL_NORMAL_ARRAY); }},
    {"color array", kArrays, [](auto& gl) { gl.EnableClientState(GL_COLOR_ARRAY); }},
    {"index array", kArrays, [](auto& gl) { gl.EnableClientState(GL_INDEX_ARRAY); }},
    {"coordinates array", kArrays, [](auto& gl) { gl.EnableClientState(GL_TEXTURE_COORD_ARRAY); }},
    {"edge flag array", kArrays, [](auto& gl) { gl.EnableClientState(GL_EDGE_FLAG_ARRAY); }},
    {"secondary array", kArrays, [](auto& gl) { gl.EnableClientState(GL_SECONDARY_COLOR_ARRAY); }},
    {"fog array", kArrays, [](auto& gl) { gl.EnableClientState(GL_FOG_COORDINATE_ARRAY); }},
    {"active client texture", kArrays, [](auto& gl) { gl.ClientActiveTexture(GL_TEXTURE2); }},
    {"vertex pointer", kArrays, [](auto& gl) { gl.VertexPointer(2, GL_SHORT, 12, kValues); }},
    {"normal pointer", kArrays, [](auto& gl) { gl.NormalPointer(GL_BYTE, 12, kValues); }},
    {"color pointer", kArrays, [](auto& gl) { gl.ColorPointer(3, GL_UNSIGNED_BYTE, 12, kValues); }},
    {"index pointer", kArrays, [](auto& gl) { gl.IndexPointer(GL_SHORT, 12, kValues); }},
    {"coordinates pointer", kArrays, [](auto& gl) { gl.TexCoordPointer(2, GL_SHORT, 12, kValues); }},
    {"edge flag pointer", kArrays, [](auto& gl) { gl.EdgeFlagPointer(12, kValues); }},
    {"secondary pointer", kArrays, [](auto& gl) { gl.SecondaryColorPointer(3, GL_SHORT, 12, kValues); }},
    {"fog pointer", kArrays, [](auto& gl) { gl.FogCoordPointer(GL_FLOAT, 12, kValues); }},
    {"array buffer", kArrays, [](auto& gl) { gl.BindBuffer(GL_ARRAY_BUFFER, 3); }},
    {"element buffer", kArrays, [](auto& gl) { gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, 3); }},
    {"color", 0, [](auto& gl) { gl.Color4fv(kVector); }},
    {"texture", 0, [](auto& gl) { gl.ActiveTexture(GL_TEXTURE2); }},
};

constexpr GLbitfield kAllGroups = 0xfffff | GL_MULTISAMPLE_BIT;

class Groups : public StateTest {
  protected:
    void prepare() {
        // Then enabling GL_COLOR_MATERIAL changes no material.
        const GLfloat white[] = {1, 1, 1, 1};
        gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, white);
    }

    // Each group of the state alone brings it back, and all others together do not.
    template <typename Push, typename Pop>
    void expect_groups(const State& state, GLbitfield all, Push push, Pop pop) {
        for (GLbitfield bits = all; bits != 0; bits &= bits - 1) {
            const GLbitfield bit = bits & ~(bits - 1);
            if (state.groups & bit) expect_restored(state, bit, true, push, pop);
        }
        expect_restored(state, all & ~state.groups, false, push, pop);
    }

  private:
    template <typename Push, typename Pop>
    void expect_restored(const State& state, GLbitfield mask, bool restored, Push push, Pop pop) {
        const kit::OffscreenContext fresh(library(), {.width = 64, .height = 32});
        prepare();
        const auto before = dump_everything(gl);
        push(mask);
        state.change(gl);
        pop();
        const auto changes = changed(before, dump_everything(gl));
        EXPECT_EQ(changes.empty(), restored)
            << state.name << " under " << mask << (restored ? " stays: " + changes.front() : " is restored");
        EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR}) << state.name;
    }
};

TEST_F(Groups, RestoreWhatIsTheirsAndNothingElse) {
    const auto push = [&](GLbitfield bit) { gl.PushAttrib(bit); };
    const auto pop = [&] { gl.PopAttrib(); };
    for (const State& state : kServerStates) expect_groups(state, kAllGroups, push, pop);
    for (const auto& [name, group] : kCapabilities) {
        const auto toggle = [capability = name](const Gl& table) {
            if (table.IsEnabled(capability))
                table.Disable(capability);
            else
                table.Enable(capability);
        };
        expect_groups(
            {("capability " + std::to_string(name)).c_str(), GLbitfield(group | GL_ENABLE_BIT), toggle},
            kAllGroups, push, pop);
    }
}

TEST_F(Groups, OfClientsRestoreWhatIsTheirsAndNothingElse) {
    for (const State& state : kClientStates) {
        expect_groups(
            state, kArrays | kPixelStore, [&](GLbitfield bit) { gl.PushClientAttrib(bit); },
            [&] { gl.PopClientAttrib(); });
    }
}

}  // namespace
}  // namespace terrazzo::test
