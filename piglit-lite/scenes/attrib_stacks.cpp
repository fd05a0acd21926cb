// Chapter: attribute stacks, queries of state, enables and hints (GL 1.5 §6.1).
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

constexpr GLenum kCapabilities[] = {GL_LINE_STIPPLE,
                                    GL_CULL_FACE,
                                    GL_LIGHTING,
                                    GL_LIGHT0,
                                    GL_LIGHT3,
                                    GL_FOG,
                                    GL_DEPTH_TEST,
                                    GL_STENCIL_TEST,
                                    GL_NORMALIZE,
                                    GL_CLIP_PLANE0,
                                    GL_CLIP_PLANE1,
                                    GL_ALPHA_TEST,
                                    GL_BLEND,
                                    GL_COLOR_LOGIC_OP,
                                    GL_DITHER,
                                    GL_SCISSOR_TEST,
                                    GL_TEXTURE_1D,
                                    GL_TEXTURE_2D,
                                    GL_TEXTURE_GEN_S,
                                    GL_TEXTURE_GEN_T,
                                    GL_POLYGON_STIPPLE,
                                    GL_POLYGON_OFFSET_FILL,
                                    GL_POLYGON_OFFSET_LINE,
                                    GL_POLYGON_OFFSET_POINT,
                                    GL_COLOR_MATERIAL,
                                    GL_POINT_SMOOTH,
                                    GL_LINE_SMOOTH,
                                    GL_POLYGON_SMOOTH};

void note_floats(const Gl& gl, Notes& notes, const std::string& when, GLenum name, int count,
                 double tolerance = 1e-6) {
    GLfloat values[16] = {};
    gl.GetFloatv(name, values);
    for (int i = 0; i < count; ++i)
        notes.value(when + " " + std::to_string(name) + "[" + std::to_string(i) + "]", values[i], tolerance);
}

// Sets something in every group of attributes, to one of two sets of values.
void scribble(const Gl& gl, bool second) {
    const float f = second ? 0.25F : 0;
    const auto pick = [second](auto a, auto b) { return static_cast<GLenum>(second ? b : a); };
    const auto sign = [second](auto a, auto b) { return static_cast<GLint>(second ? b : a); };
    const auto enable = [&](GLenum capability, bool inverse = false) {
        if (second != inverse)
            gl.Disable(capability);
        else
            gl.Enable(capability);
    };
    const GLfloat colour[] = {0.3F + f, 0.4F + f, 0.5F + f, 0.6F + f};
    gl.Color4fv(colour);
    gl.Normal3f(1, f, 0);
    gl.TexCoord2f(4 + f, 5);
    gl.EdgeFlag(second);
    gl.PointSize(6 + f);
    gl.LineWidth(5 + f);
    gl.LineStipple(sign(3, 2), static_cast<GLushort>(sign(0x1234, 0x4321)));
    gl.PolygonMode(GL_FRONT_AND_BACK, pick(GL_LINE, GL_POINT));
    gl.CullFace(pick(GL_FRONT, GL_FRONT_AND_BACK));
    gl.FrontFace(pick(GL_CW, GL_CCW));
    gl.PolygonOffset(2 + f, 3 + f);
    gl.ShadeModel(pick(GL_FLAT, GL_SMOOTH));
    gl.Lightfv(GL_LIGHT3, GL_DIFFUSE, colour);
    gl.Materialfv(GL_FRONT, GL_SPECULAR, colour);
    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, sign(1, 0));
    gl.Fogf(GL_FOG_DENSITY, 0.3F + f);
    gl.Fogfv(GL_FOG_COLOR, colour);
    gl.DepthFunc(pick(GL_GREATER, GL_NEVER));
    gl.DepthMask(second);
    gl.ClearDepth(0.4F + f);
    gl.StencilFunc(pick(GL_NOTEQUAL, GL_LESS), sign(4, 7), pick(0x3F, 0x1F));
    gl.StencilOp(pick(GL_INCR, GL_ZERO), pick(GL_DECR, GL_KEEP), pick(GL_INVERT, GL_REPLACE));
    gl.StencilMask(pick(0x55, 0xAA));
    gl.ClearStencil(sign(9, 12));
    gl.Viewport(sign(10, 11), 20, sign(100, 90), 120);
    gl.DepthRange(0.2F + f, 0.7F);
    gl.MatrixMode(pick(GL_TEXTURE, GL_PROJECTION));
    const GLdouble plane[] = {1 + f, 2, 3, 4};
    gl.ClipPlane(GL_CLIP_PLANE1, plane);
    gl.AlphaFunc(pick(GL_LESS, GL_GEQUAL), 0.3F + f);
    gl.BlendFunc(pick(GL_DST_COLOR, GL_ONE), pick(GL_SRC_ALPHA, GL_ZERO));
    gl.LogicOp(pick(GL_NAND, GL_XOR));
    gl.ColorMask(1, second, 1, 0);
    gl.ClearColor(0.1F + f, 0.2F, 0.3F, 0.4F);
    gl.Scissor(sign(3, 5), 4, 50, 60);
    gl.Hint(GL_FOG_HINT, pick(GL_NICEST, GL_FASTEST));
    gl.Hint(GL_PERSPECTIVE_CORRECTION_HINT, pick(GL_FASTEST, GL_NICEST));
    gl.ListBase(pick(44, 55));
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, sign(GL_DECAL, GL_BLEND));
    gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, sign(GL_SPHERE_MAP, GL_OBJECT_LINEAR));
    gl.PixelZoom(2 + f, 3);
    gl.PixelTransferf(GL_RED_SCALE, 4 + f);
    for (const GLenum capability : kCapabilities) enable(capability, capability % 2 == 0);
}

// Back to state in which a plain rectangle shows.
void calm(const Gl& gl) {
    for (const GLenum capability : kCapabilities) gl.Disable(capability);
    gl.ColorMask(1, 1, 1, 1);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    gl.Viewport(0, 0, kSize, kSize);
    gl.DepthRange(0, 1);
}

void note_state(const Gl& gl, Notes& notes, const std::string& when) {
    const struct {
        GLenum name;
        int count;
    } values[] = {{GL_CURRENT_COLOR, 4},
                  {GL_CURRENT_NORMAL, 3},
                  {GL_CURRENT_TEXTURE_COORDS, 4},
                  {GL_POINT_SIZE, 1},
                  {GL_LINE_WIDTH, 1},
                  {GL_LINE_STIPPLE_REPEAT, 1},
                  {GL_LINE_STIPPLE_PATTERN, 1},
                  {GL_POLYGON_MODE, 2},
                  {GL_CULL_FACE_MODE, 1},
                  {GL_FRONT_FACE, 1},
                  {GL_POLYGON_OFFSET_FACTOR, 1},
                  {GL_POLYGON_OFFSET_UNITS, 1},
                  {GL_SHADE_MODEL, 1},
                  {GL_LIGHT_MODEL_TWO_SIDE, 1},
                  {GL_LIGHT_MODEL_LOCAL_VIEWER, 1},
                  {GL_LIGHT_MODEL_AMBIENT, 4},
                  {GL_COLOR_MATERIAL_FACE, 1},
                  {GL_COLOR_MATERIAL_PARAMETER, 1},
                  {GL_FOG_DENSITY, 1},
                  {GL_FOG_COLOR, 4},
                  {GL_FOG_MODE, 1},
                  {GL_FOG_START, 1},
                  {GL_FOG_END, 1},
                  {GL_DEPTH_FUNC, 1},
                  {GL_DEPTH_WRITEMASK, 1},
                  {GL_DEPTH_CLEAR_VALUE, 1},
                  {GL_STENCIL_FUNC, 1},
                  {GL_STENCIL_REF, 1},
                  {GL_STENCIL_VALUE_MASK, 1},
                  {GL_STENCIL_WRITEMASK, 1},
                  {GL_STENCIL_CLEAR_VALUE, 1},
                  {GL_STENCIL_FAIL, 1},
                  {GL_STENCIL_PASS_DEPTH_FAIL, 1},
                  {GL_STENCIL_PASS_DEPTH_PASS, 1},
                  {GL_VIEWPORT, 4},
                  {GL_DEPTH_RANGE, 2},
                  {GL_MATRIX_MODE, 1},
                  {GL_MODELVIEW_STACK_DEPTH, 1},
                  {GL_PROJECTION_STACK_DEPTH, 1},
                  {GL_TEXTURE_STACK_DEPTH, 1},
                  {GL_ALPHA_TEST_FUNC, 1},
                  {GL_ALPHA_TEST_REF, 1},
                  {GL_BLEND_SRC, 1},
                  {GL_BLEND_DST, 1},
                  {GL_LOGIC_OP_MODE, 1},
                  {GL_COLOR_WRITEMASK, 4},
                  {GL_COLOR_CLEAR_VALUE, 4},
                  {GL_SCISSOR_BOX, 4},
                  {GL_FOG_HINT, 1},
                  {GL_PERSPECTIVE_CORRECTION_HINT, 1},
                  {GL_LINE_SMOOTH_HINT, 1},
                  {GL_POINT_SMOOTH_HINT, 1},
                  {GL_POLYGON_SMOOTH_HINT, 1},
                  {GL_LIST_BASE, 1},
                  {GL_ZOOM_X, 1},
                  {GL_ZOOM_Y, 1},
                  {GL_RED_SCALE, 1},
                  {GL_EDGE_FLAG, 1},
                  {GL_ATTRIB_STACK_DEPTH, 1},
                  {GL_CLIENT_ATTRIB_STACK_DEPTH, 1},
                  {GL_RENDER_MODE, 1}};
    for (const auto& value : values) note_floats(gl, notes, when, value.name, value.count);
    for (const GLenum capability : kCapabilities)
        notes.value(when + " enabled " + std::to_string(capability), gl.IsEnabled(capability));
    GLint mode = 0;
    gl.GetTexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, &mode);
    notes.value(when + " environment", mode);
    gl.GetTexGeniv(GL_S, GL_TEXTURE_GEN_MODE, &mode);
    notes.value(when + " generation", mode);
    GLfloat colour[4];
    gl.GetLightfv(GL_LIGHT3, GL_DIFFUSE, colour);
    notes.values(when + " light", colour, 1e-6);
    gl.GetMaterialfv(GL_FRONT, GL_SPECULAR, colour);
    notes.values(when + " material", colour, 1e-6);
    GLdouble plane[4];
    gl.GetClipPlane(GL_CLIP_PLANE1, plane);
    notes.values(when + " plane", plane, 1e-6);
}

void mark(const Gl& gl) {
    pixel_projection(gl);
    gl.Color3f(0.4F, 0.8F, 0.6F);
    rectangle(gl, 30, 30, 226, 226);
}

}  // namespace

SCENE(state_initial_values, "every queried value of a new context") {
    note_state(gl, notes, "initial");
    for (const GLenum matrix : {GL_MODELVIEW_MATRIX, GL_PROJECTION_MATRIX, GL_TEXTURE_MATRIX})
        note_floats(gl, notes, "initial", matrix, 16);
    mark(gl);
}

SCENE(state_get_conversions, "one value asked for as boolean, integer, float and double") {
    gl.ClearColor(0.5F, 1, 0, 0.25F);
    gl.DepthRange(0.25, 0.75);
    gl.PolygonOffset(1.5F, -2.5F);
    const GLfloat ambient[] = {0.1F, 0.6F, 1, 0};
    gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
    for (const GLenum name :
         {GL_COLOR_CLEAR_VALUE, GL_DEPTH_RANGE, GL_POLYGON_OFFSET_FACTOR, GL_LIGHT_MODEL_AMBIENT,
          GL_DEPTH_FUNC, GL_LINE_WIDTH, GL_CURRENT_COLOR, GL_VIEWPORT, GL_LIGHTING}) {
        GLboolean booleans[4] = {};
        GLint integers[4] = {};
        GLfloat floats[4] = {};
        GLdouble doubles[4] = {};
        gl.GetBooleanv(name, booleans);
        gl.GetIntegerv(name, integers);
        gl.GetFloatv(name, floats);
        gl.GetDoublev(name, doubles);
        const std::string text = std::to_string(name);
        notes.values("boolean " + text, booleans);
        // Colours become integers over the whole 32-bit range; their low byte is float rounding.
        notes.values("integer " + text, integers, 256);
        notes.values("float " + text, floats, 1e-6);
        notes.values("double " + text, doubles, 1e-6);
    }
    mark(gl);
}

SCENE(state_each_attribute_group, "each bit of PushAttrib restores its own group and nothing else") {
    // Not nested in another push: Mesa 22.3's outer PopAttrib forgets what changed under an inner one.
    for (int bit = 0; bit < 20; ++bit) {
        if (1U << bit == GL_ACCUM_BUFFER_BIT || 1U << bit == GL_EVAL_BIT) continue;
        // Mesa 22.3's enable group leaves the lights out; the unit tests hold ours to the specification.
        if (1U << bit == GL_ENABLE_BIT) continue;
        scribble(gl, false);
        gl.PushAttrib(1U << bit);
        scribble(gl, true);
        gl.PopAttrib();
        note_state(gl, notes, "group " + std::to_string(bit));
    }
    scribble(gl, false);
    gl.PushAttrib(GL_ALL_ATTRIB_BITS);
    scribble(gl, true);
    gl.PopAttrib();
    note_state(gl, notes, "all groups");
    calm(gl);
    mark(gl);
}

SCENE(state_push_pop_pictures, "the same mark before, under and after pushed state") {
    pixel_projection(gl);
    for_cells(3, 3, [&](int cell, float x, float y, float w, float h) {
        if (cell % 3 == 1) {
            gl.PushAttrib(GL_ALL_ATTRIB_BITS);
            gl.Enable(GL_BLEND);
            gl.BlendFunc(GL_ONE, GL_ONE);
            gl.ShadeModel(GL_FLAT);
            gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
            gl.LineWidth(4);
            gl.ColorMask(1, 1, 0, 1);
        }
        gl.Begin(GL_QUADS);
        gl.Color4fv(hue(static_cast<float>(cell) / 9).data()), gl.Vertex2f(x + 8, y + 8);
        gl.Color4fv(hue(static_cast<float>(cell) / 9 + 0.2F).data()), gl.Vertex2f(x + w - 8, y + 8);
        gl.Color4fv(hue(static_cast<float>(cell) / 9 + 0.4F).data()), gl.Vertex2f(x + w - 8, y + h - 8);
        gl.Color4fv(hue(static_cast<float>(cell) / 9 + 0.6F).data()), gl.Vertex2f(x + 8, y + h - 8);
        gl.End();
        if (cell % 3 == 1) gl.PopAttrib();
    });
}

SCENE(state_stack_limits, "the attribute stacks fill, overflow and underflow with the specified errors") {
    int pushes = 0, pops = 0;
    while (gl.GetError() == GL_NO_ERROR && pushes < 100) gl.PushAttrib(GL_CURRENT_BIT), ++pushes;
    do gl.PopAttrib(), ++pops;
    while (gl.GetError() == GL_NO_ERROR && pops < 100);
    notes.value("balance", pushes - pops);
    pushes = pops = 0;
    while (gl.GetError() == GL_NO_ERROR && pushes < 100)
        gl.PushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS), ++pushes;
    do gl.PopClientAttrib(), ++pops;
    while (gl.GetError() == GL_NO_ERROR && pops < 100);
    notes.value("client balance", pushes - pops);
    mark(gl);
}

SCENE(state_client_attributes, "PushClientAttrib saves pixel store and vertex array state") {
    pixel_projection(gl);
    const float good[][2] = {{30, 30}, {226, 60}, {128, 226}}, bad[][2] = {{0, 0}, {9, 0}, {0, 9}};
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.VertexPointer(2, GL_FLOAT, 0, good);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 2);
    gl.PushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
    gl.VertexPointer(2, GL_FLOAT, 0, bad);
    gl.EnableClientState(GL_COLOR_ARRAY);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 8);
    gl.PixelStorei(GL_PACK_SKIP_ROWS, 3);
    gl.PopClientAttrib();
    gl.Color4fv(hue(0.4F).data());
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    for (const GLenum name :
         {GL_UNPACK_ALIGNMENT, GL_PACK_SKIP_ROWS, GL_VERTEX_ARRAY_SIZE, GL_VERTEX_ARRAY_STRIDE}) {
        GLint value = 0;
        gl.GetIntegerv(name, &value);
        notes.value("value " + std::to_string(name), value);
    }
    notes.value("colour array", gl.IsEnabled(GL_COLOR_ARRAY));
    GLvoid* pointer = nullptr;
    gl.GetPointerv(GL_VERTEX_ARRAY_POINTER, &pointer);
    notes.value("pointer restored", pointer == static_cast<const void*>(good));
}

SCENE(state_errors, "commands refused by the specification: which error, and the state unchanged") {
    const auto expect = [&](const char* name) { notes.value(name, gl.GetError()); };
    gl.Enable(0x1234), expect("Enable of an unknown capability");
    gl.MatrixMode(GL_FOG), expect("MatrixMode of FOG");
    gl.DepthFunc(GL_ONE), expect("DepthFunc of ONE");
    gl.LineWidth(0), expect("LineWidth 0");
    gl.LineWidth(-1), expect("LineWidth negative");
    gl.PointSize(0), expect("PointSize 0");
    gl.Viewport(0, 0, -1, 5), expect("negative viewport");
    gl.Scissor(0, 0, 5, -5), expect("negative scissor");
    gl.Clear(0x80000000U), expect("Clear of unknown bits");
    gl.BlendFunc(GL_LESS, GL_ONE), expect("BlendFunc of LESS");
    gl.ShadeModel(GL_LINE), expect("ShadeModel of LINE");
    gl.CullFace(GL_CW), expect("CullFace of CW");
    gl.FrontFace(GL_FRONT), expect("FrontFace of FRONT");
    gl.PolygonMode(GL_FRONT, GL_SMOOTH), expect("PolygonMode of SMOOTH");
    gl.LogicOp(GL_BLEND), expect("LogicOp of BLEND");
    gl.AlphaFunc(GL_ONE, 0), expect("AlphaFunc of ONE");
    gl.StencilOp(GL_ONE, GL_KEEP, GL_KEEP), expect("StencilOp of ONE");
    gl.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 100), expect("cut-off 100");
    gl.Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, 129), expect("exponent 129");
    gl.Materialf(GL_FRONT, GL_SHININESS, -1), expect("shininess negative");
    gl.Fogf(GL_FOG_DENSITY, -0.1F), expect("density negative");
    gl.Fogi(GL_FOG_MODE, GL_LINES), expect("fog mode of LINES");
    gl.Frustum(-1, 1, -1, 1, 0, 5), expect("Frustum with near 0");
    gl.Ortho(1, 1, 0, 1, 0, 1), expect("Ortho of no width");
    gl.Begin(0x99), expect("Begin of an unknown mode");
    gl.End(), expect("End without Begin");
    gl.EndList(), expect("EndList without NewList");
    gl.NewList(0, GL_COMPILE), expect("NewList 0");
    gl.GenLists(-1), expect("GenLists negative");
    gl.DrawArrays(GL_TRIANGLES, 0, -1), expect("DrawArrays of a negative count");
    gl.DrawElements(GL_TRIANGLES, 3, GL_FLOAT, nullptr), expect("DrawElements of FLOAT");
    gl.VertexPointer(5, GL_FLOAT, 0, nullptr), expect("VertexPointer of size 5");
    gl.VertexPointer(3, GL_BYTE, 0, nullptr), expect("VertexPointer of BYTE");
    gl.ColorPointer(3, GL_FLOAT, -4, nullptr), expect("ColorPointer of a negative stride");
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, -1, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr),
        expect("TexImage2D negative");
    gl.TexImage2D(GL_TEXTURE_2D, 0, 77, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr),
        expect("TexImage2D of format 77");
    gl.TexImage2D(GL_TEXTURE_2D, -1, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr),
        expect("TexImage2D level -1");
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 2, GL_RGBA, GL_UNSIGNED_BYTE, nullptr),
        expect("TexImage2D border 2");
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5, nullptr),
        expect("RGBA as 5_6_5");
    gl.TexSubImage2D(GL_TEXTURE_2D, 3, 0, 0, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE, nullptr),
        expect("TexSubImage2D of no image");
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR_MIPMAP_LINEAR),
        expect("mipmapped magnification");
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_LINEAR), expect("environment LINEAR");
    gl.TexGeni(GL_R, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP), expect("sphere map of R");
    gl.PixelStorei(GL_PACK_ALIGNMENT, 3), expect("alignment 3");
    gl.PixelStorei(GL_UNPACK_ROW_LENGTH, -1), expect("row length negative");
    gl.ReadPixels(0, 0, -1, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr), expect("ReadPixels negative");
    gl.ReadPixels(0, 0, 1, 1, GL_LINES, GL_UNSIGNED_BYTE, nullptr), expect("ReadPixels of LINES");
    gl.Hint(GL_FOG_HINT, GL_FOG), expect("hint FOG");
    gl.PopMatrix(), expect("PopMatrix of one");
    const GLdouble equation[] = {1, 0, 0, 0};
    gl.ClipPlane(GL_LIGHT0, equation), expect("ClipPlane of LIGHT0");
    gl.DrawBuffer(GL_BACK), expect("DrawBuffer BACK");
    gl.ReadBuffer(GL_AUX0), expect("ReadBuffer AUX0");
    gl.Begin(GL_TRIANGLES);
    gl.Enable(GL_FOG);
    gl.LoadIdentity();
    gl.End(), expect("commands between Begin and End");
    notes.value("fog still off", gl.IsEnabled(GL_FOG));
    note_state(gl, notes, "after errors");
    mark(gl);
}
