// The commands that the player knows; see state_player.h.
#include "state_player.h"

#include <cstdint>
#include <iterator>

namespace terrazzo::test {
namespace {

using Player = StatePlayer;
using Enumerants = std::vector<Player::Enumerant>;

#define TERRAZZO_E(name) \
    Player::Enumerant {  \
        name, #name      \
    }

// Enumerants that no command of the player takes, in any version of GL.
const Enumerants kInvalid = {TERRAZZO_E(GL_TRIANGLE_FAN), TERRAZZO_E(GL_2_BYTES),
                             TERRAZZO_E(GL_VENDOR),       TERRAZZO_E(GL_FEEDBACK),
                             {0x1234, "0x1234"},          {0xffffffffu, "0xffffffff"}};

const Enumerants kCapabilities = {TERRAZZO_E(GL_ALPHA_TEST),
                                  TERRAZZO_E(GL_BLEND),
                                  TERRAZZO_E(GL_CLIP_PLANE0),
                                  TERRAZZO_E(GL_CLIP_PLANE5),
                                  TERRAZZO_E(GL_COLOR_LOGIC_OP),
                                  TERRAZZO_E(GL_COLOR_MATERIAL),
                                  TERRAZZO_E(GL_CULL_FACE),
                                  TERRAZZO_E(GL_DEPTH_TEST),
                                  TERRAZZO_E(GL_DITHER),
                                  TERRAZZO_E(GL_FOG),
                                  TERRAZZO_E(GL_INDEX_LOGIC_OP),
                                  TERRAZZO_E(GL_LIGHT0),
                                  TERRAZZO_E(GL_LIGHT7),
                                  TERRAZZO_E(GL_LIGHTING),
                                  TERRAZZO_E(GL_LINE_SMOOTH),
                                  TERRAZZO_E(GL_LINE_STIPPLE),
                                  TERRAZZO_E(GL_MULTISAMPLE),
                                  TERRAZZO_E(GL_SAMPLE_ALPHA_TO_COVERAGE),
                                  TERRAZZO_E(GL_SAMPLE_ALPHA_TO_ONE),
                                  TERRAZZO_E(GL_SAMPLE_COVERAGE),
                                  TERRAZZO_E(GL_NORMALIZE),
                                  TERRAZZO_E(GL_POINT_SMOOTH),
                                  TERRAZZO_E(GL_POINT_SPRITE),
                                  TERRAZZO_E(GL_POLYGON_OFFSET_FILL),
                                  TERRAZZO_E(GL_POLYGON_OFFSET_LINE),
                                  TERRAZZO_E(GL_POLYGON_OFFSET_POINT),
                                  TERRAZZO_E(GL_POLYGON_SMOOTH),
                                  TERRAZZO_E(GL_POLYGON_STIPPLE),
                                  TERRAZZO_E(GL_RESCALE_NORMAL),
                                  TERRAZZO_E(GL_SCISSOR_TEST),
                                  TERRAZZO_E(GL_STENCIL_TEST),
                                  TERRAZZO_E(GL_TEXTURE_1D),
                                  TERRAZZO_E(GL_TEXTURE_2D),
                                  TERRAZZO_E(GL_TEXTURE_3D),
                                  TERRAZZO_E(GL_TEXTURE_CUBE_MAP),
                                  TERRAZZO_E(GL_TEXTURE_GEN_Q),
                                  TERRAZZO_E(GL_TEXTURE_GEN_R),
                                  TERRAZZO_E(GL_TEXTURE_GEN_S),
                                  TERRAZZO_E(GL_TEXTURE_GEN_T)};

const Enumerants kEvaluators = {TERRAZZO_E(GL_AUTO_NORMAL), TERRAZZO_E(GL_MAP1_VERTEX_3),
                                TERRAZZO_E(GL_MAP2_COLOR_4), TERRAZZO_E(GL_MAP2_TEXTURE_COORD_2)};

const Enumerants kComparisons = {TERRAZZO_E(GL_NEVER),  TERRAZZO_E(GL_LESS),    TERRAZZO_E(GL_EQUAL),
                                 TERRAZZO_E(GL_LEQUAL), TERRAZZO_E(GL_GREATER), TERRAZZO_E(GL_NOTEQUAL),
                                 TERRAZZO_E(GL_GEQUAL), TERRAZZO_E(GL_ALWAYS)};

const Enumerants kFaces = {TERRAZZO_E(GL_FRONT), TERRAZZO_E(GL_BACK), TERRAZZO_E(GL_FRONT_AND_BACK)};

const Enumerants kBlendFactors = {TERRAZZO_E(GL_ZERO),      TERRAZZO_E(GL_ONE),
                                  TERRAZZO_E(GL_SRC_COLOR), TERRAZZO_E(GL_ONE_MINUS_SRC_COLOR),
                                  TERRAZZO_E(GL_DST_COLOR), TERRAZZO_E(GL_ONE_MINUS_DST_COLOR),
                                  TERRAZZO_E(GL_SRC_ALPHA), TERRAZZO_E(GL_ONE_MINUS_SRC_ALPHA),
                                  TERRAZZO_E(GL_DST_ALPHA), TERRAZZO_E(GL_ONE_MINUS_DST_ALPHA)};

const Enumerants kStencilOperations = {TERRAZZO_E(GL_KEEP), TERRAZZO_E(GL_ZERO), TERRAZZO_E(GL_REPLACE),
                                       TERRAZZO_E(GL_INCR), TERRAZZO_E(GL_DECR), TERRAZZO_E(GL_INVERT)};

const Enumerants kLogicOperations = {TERRAZZO_E(GL_CLEAR), TERRAZZO_E(GL_COPY), TERRAZZO_E(GL_XOR),
                                     TERRAZZO_E(GL_NAND),  TERRAZZO_E(GL_SET),  TERRAZZO_E(GL_OR_INVERTED)};

const Enumerants kBuffers = {
    TERRAZZO_E(GL_NONE),       TERRAZZO_E(GL_FRONT),       TERRAZZO_E(GL_BACK),
    TERRAZZO_E(GL_LEFT),       TERRAZZO_E(GL_RIGHT),       TERRAZZO_E(GL_FRONT_AND_BACK),
    TERRAZZO_E(GL_FRONT_LEFT), TERRAZZO_E(GL_FRONT_RIGHT), TERRAZZO_E(GL_BACK_LEFT),
    TERRAZZO_E(GL_BACK_RIGHT), TERRAZZO_E(GL_AUX0),        TERRAZZO_E(GL_AUX3)};

// The reference also reads from GL_NONE and GL_FRONT_AND_BACK, which GL 1.5 §4.3.2 does not know.
const Enumerants kReadBuffers = {
    TERRAZZO_E(GL_FRONT),      TERRAZZO_E(GL_BACK),        TERRAZZO_E(GL_LEFT),      TERRAZZO_E(GL_RIGHT),
    TERRAZZO_E(GL_FRONT_LEFT), TERRAZZO_E(GL_FRONT_RIGHT), TERRAZZO_E(GL_BACK_LEFT), TERRAZZO_E(GL_AUX0)};

const Enumerants kHints = {TERRAZZO_E(GL_PERSPECTIVE_CORRECTION_HINT), TERRAZZO_E(GL_POINT_SMOOTH_HINT),
                           TERRAZZO_E(GL_LINE_SMOOTH_HINT), TERRAZZO_E(GL_POLYGON_SMOOTH_HINT),
                           TERRAZZO_E(GL_FOG_HINT)};

const Enumerants kLights = {TERRAZZO_E(GL_LIGHT0), TERRAZZO_E(GL_LIGHT1), TERRAZZO_E(GL_LIGHT7)};

const Enumerants kLightVectors = {TERRAZZO_E(GL_AMBIENT), TERRAZZO_E(GL_DIFFUSE), TERRAZZO_E(GL_SPECULAR),
                                  TERRAZZO_E(GL_POSITION), TERRAZZO_E(GL_SPOT_DIRECTION)};

const Enumerants kLightScalars = {TERRAZZO_E(GL_SPOT_EXPONENT), TERRAZZO_E(GL_SPOT_CUTOFF),
                                  TERRAZZO_E(GL_CONSTANT_ATTENUATION), TERRAZZO_E(GL_LINEAR_ATTENUATION),
                                  TERRAZZO_E(GL_QUADRATIC_ATTENUATION)};

const Enumerants kMaterialVectors = {TERRAZZO_E(GL_AMBIENT),
                                     TERRAZZO_E(GL_DIFFUSE),
                                     TERRAZZO_E(GL_SPECULAR),
                                     TERRAZZO_E(GL_EMISSION),
                                     TERRAZZO_E(GL_AMBIENT_AND_DIFFUSE),
                                     TERRAZZO_E(GL_COLOR_INDEXES)};

const Enumerants kMaterialColors = {TERRAZZO_E(GL_AMBIENT), TERRAZZO_E(GL_DIFFUSE), TERRAZZO_E(GL_SPECULAR),
                                    TERRAZZO_E(GL_EMISSION), TERRAZZO_E(GL_AMBIENT_AND_DIFFUSE)};

const Enumerants kCoordinates = {TERRAZZO_E(GL_S), TERRAZZO_E(GL_T), TERRAZZO_E(GL_R), TERRAZZO_E(GL_Q)};

const Enumerants kClipPlanes = {TERRAZZO_E(GL_CLIP_PLANE0), TERRAZZO_E(GL_CLIP_PLANE1),
                                TERRAZZO_E(GL_CLIP_PLANE5)};

const GLbitfield kAttributeBits[] = {GL_ACCUM_BUFFER_BIT, GL_COLOR_BUFFER_BIT,   GL_CURRENT_BIT,
                                     GL_DEPTH_BUFFER_BIT, GL_ENABLE_BIT,         GL_EVAL_BIT,
                                     GL_FOG_BIT,          GL_HINT_BIT,           GL_LIGHTING_BIT,
                                     GL_LINE_BIT,         GL_LIST_BIT,           GL_PIXEL_MODE_BIT,
                                     GL_POINT_BIT,        GL_POLYGON_BIT,        GL_POLYGON_STIPPLE_BIT,
                                     GL_SCISSOR_BIT,      GL_STENCIL_BUFFER_BIT, GL_TEXTURE_BIT,
                                     GL_TRANSFORM_BIT,    GL_VIEWPORT_BIT,       GL_ALL_ATTRIB_BITS};

struct Command {
    const char* name;
    void (*play)(Player& p);
};

// Enumerants as the values that parameter commands take.
GLfloat enumerant_number(Player& p, const Enumerants& valid) {
    return static_cast<GLfloat>(p.enumerant(valid));
}

void play_window_position(Player& p) {
    const auto v = p.moderate_numbers(3);
    if (p.pick(2)) return p.gl().WindowPos3f(v[0], v[1], v[2]);
    p.gl().WindowPos2i(p.integer(), 7);
}

void play_evaluator(Player& p) {
    const auto v = p.moderate_numbers(4);
    const auto segments = static_cast<GLint>(p.pick(6));
    p.note(std::to_string(segments));
    switch (p.pick(4)) {
        case 0:
            return p.gl().MapGrid1f(segments, v[0], v[1]);
        case 1:
            return p.gl().MapGrid2f(segments, v[0], v[1], 3, v[2], v[3]);
        case 2:
            return p.gl().Enable(p.enumerant(kEvaluators));
    }
    p.gl().Disable(p.enumerant(kEvaluators));
}

// Never selection or feedback for long: other commands mean something else then.
void play_render_mode(Player& p) {
    static GLuint names[64];
    static GLfloat values[64];
    const auto size = static_cast<GLsizei>(p.pick(60)) - 4;
    p.note(std::to_string(size));
    if (p.pick(2)) {
        p.gl().SelectBuffer(size, names);
        if (size <= 0) return;
        p.gl().RenderMode(GL_SELECT);
        for (unsigned i = p.pick(4); i > 0; --i) p.gl().PushName(i);
        for (unsigned i = p.pick(5); i > 0; --i) p.gl().PopName();
    } else {
        p.gl().FeedbackBuffer(size, GL_2D + p.pick(6), values);
        if (size <= 0) return;
    }
    p.gl().RenderMode(GL_RENDER);
}

void play_fog(Player& p) {
    const GLenum pname = p.enumerant({TERRAZZO_E(GL_FOG_DENSITY), TERRAZZO_E(GL_FOG_START),
                                      TERRAZZO_E(GL_FOG_END), TERRAZZO_E(GL_FOG_INDEX)});
    if (p.pick(2)) {
        p.gl().Fogf(pname, p.number());
    } else {
        p.gl().Fogi(pname, p.integer());
    }
}

void play_fog_mode(Player& p) {
    p.gl().Fogf(GL_FOG_MODE,
                enumerant_number(p, {TERRAZZO_E(GL_LINEAR), TERRAZZO_E(GL_EXP), TERRAZZO_E(GL_EXP2)}));
}

// PopAttrib does not restore these two in the reference, so they stay as they are while something is saved.
void play_fog_sources(Player& p) {
    const GLfloat source =
        enumerant_number(p, {TERRAZZO_E(GL_FOG_COORDINATE), TERRAZZO_E(GL_FRAGMENT_DEPTH)});
    const unsigned choice = p.pick(3);
    p.note(std::to_string(choice));
    GLint depth = 0;
    p.gl().GetIntegerv(GL_ATTRIB_STACK_DEPTH, &depth);
    if (depth > 0) return;
    if (choice == 0) return p.gl().Fogf(GL_FOG_COORDINATE_SOURCE, source);
    choice == 1 ? p.gl().Enable(GL_COLOR_SUM) : p.gl().Disable(GL_COLOR_SUM);
}

void play_point_parameter(Player& p) {
    if (p.pick(2)) return p.gl().PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, p.numbers(3).data());
    p.gl().PointParameterf(p.enumerant({TERRAZZO_E(GL_POINT_SIZE_MIN), TERRAZZO_E(GL_POINT_SIZE_MAX),
                                        TERRAZZO_E(GL_POINT_FADE_THRESHOLD_SIZE)}),
                           p.number());
}

void play_light_vector(Player& p) {
    const GLenum light = p.enumerant(kLights);
    const GLenum pname = p.enumerant(kLightVectors);
    p.gl().Lightfv(light, pname, p.numbers(4).data());
}

void play_light_integers(Player& p) {
    const GLenum light = p.enumerant(kLights);
    const GLenum pname = p.enumerant(kLightVectors);
    const GLint values[4] = {p.integer(), p.integer(), p.integer(), p.integer()};
    p.gl().Lightiv(light, pname, values);
}

void play_light_scalar(Player& p) {
    const GLenum light = p.enumerant(kLights);
    const GLenum pname = p.enumerant(kLightScalars);
    const GLfloat special[] = {45, 90, 91, 128, 129, 180, -0.5f};
    const GLfloat value = p.pick(2) ? special[p.pick(7)] : p.number();
    p.note(std::to_string(value));
    p.gl().Lightf(light, pname, value);
}

void play_light_model(Player& p) {
    switch (p.pick(4)) {
        case 0:
            return p.gl().LightModelfv(GL_LIGHT_MODEL_AMBIENT, p.numbers(4).data());
        case 1:
            return p.gl().LightModelf(GL_LIGHT_MODEL_LOCAL_VIEWER, p.number());
        case 2:
            return p.gl().LightModeli(GL_LIGHT_MODEL_TWO_SIDE, p.integer());
    }
    p.gl().LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                       static_cast<GLint>(p.enumerant(
                           {TERRAZZO_E(GL_SINGLE_COLOR), TERRAZZO_E(GL_SEPARATE_SPECULAR_COLOR)})));
}

void play_material(Player& p) {
    const GLenum face = p.enumerant(kFaces);
    const GLenum pname = p.enumerant(kMaterialVectors);
    p.gl().Materialfv(face, pname, p.numbers(4).data());
}

void play_shininess(Player& p) {
    const GLenum face = p.enumerant(kFaces);
    p.gl().Materialf(face, GL_SHININESS, p.number());
}

GLenum unit(Player& p) {
    const GLenum number = p.pick(8);
    p.note(std::to_string(number));
    return GL_TEXTURE0 + number;
}

// Units beyond those of fixed function exist there for shaders.
void play_active_texture(Player& p) {
    p.gl().ActiveTexture(p.pick(8) ? unit(p) : p.enumerant({TERRAZZO_E(GL_TEXTURE)}));
}

void play_texgen(Player& p) {
    const GLenum coordinate = p.enumerant(kCoordinates);
    if (p.pick(3) == 0) {
        return p.gl().TexGenf(coordinate, GL_TEXTURE_GEN_MODE,
                              enumerant_number(p, {TERRAZZO_E(GL_OBJECT_LINEAR), TERRAZZO_E(GL_EYE_LINEAR),
                                                   TERRAZZO_E(GL_SPHERE_MAP), TERRAZZO_E(GL_REFLECTION_MAP),
                                                   TERRAZZO_E(GL_NORMAL_MAP)}));
    }
    const GLenum pname = p.enumerant({TERRAZZO_E(GL_OBJECT_PLANE), TERRAZZO_E(GL_EYE_PLANE)});
    p.gl().TexGenfv(coordinate, pname, p.numbers(4).data());
}

void play_combiner(Player& p) {
    const GLenum operands[2] = {p.enumerant({TERRAZZO_E(GL_SRC_COLOR), TERRAZZO_E(GL_ONE_MINUS_SRC_COLOR)}),
                                p.enumerant({TERRAZZO_E(GL_SRC_ALPHA), TERRAZZO_E(GL_ONE_MINUS_SRC_ALPHA)})};
    const GLenum source = p.enumerant(
        {TERRAZZO_E(GL_TEXTURE), TERRAZZO_E(GL_PREVIOUS), TERRAZZO_E(GL_CONSTANT), TERRAZZO_E(GL_ONE),
         TERRAZZO_E(GL_PRIMARY_COLOR), TERRAZZO_E(GL_ZERO), TERRAZZO_E(GL_TEXTURE7)});
    const GLenum function =
        p.enumerant({TERRAZZO_E(GL_REPLACE), TERRAZZO_E(GL_MODULATE), TERRAZZO_E(GL_ADD),
                     TERRAZZO_E(GL_ADD_SIGNED), TERRAZZO_E(GL_INTERPOLATE), TERRAZZO_E(GL_SUBTRACT),
                     TERRAZZO_E(GL_DOT3_RGB), TERRAZZO_E(GL_DOT3_RGBA), TERRAZZO_E(GL_DOT3_RGB_EXT),
                     TERRAZZO_E(GL_MODULATE_ADD_ATI), TERRAZZO_E(GL_DECAL)});
    const unsigned number = p.pick(3), scale = p.pick(5);
    p.note(std::to_string(number) + ' ' + std::to_string(scale));
    const auto set = [&](GLenum pname, GLenum value) {
        p.gl().TexEnvf(GL_TEXTURE_ENV, pname, static_cast<GLfloat>(value));
    };
    switch (p.pick(8)) {
        case 0:
            return set(GL_COMBINE_RGB, function);
        case 1:
            return set(GL_COMBINE_ALPHA, function);
        case 2:
            return set(GL_SRC0_RGB + number, source);
        case 3:
            return set(GL_SRC0_ALPHA + number, source);
        case 4:
            return set(GL_OPERAND0_RGB + number, operands[scale & 1]);
        case 5:
            return set(GL_OPERAND0_ALPHA + number, operands[scale & 1]);
        case 6:
            return set(GL_RGB_SCALE, scale);
    }
    set(GL_ALPHA_SCALE, scale);
}

void play_texture_environment(Player& p) {
    if (p.pick(2)) return p.gl().TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, p.numbers(4).data());
    const GLenum target = p.enumerant({TERRAZZO_E(GL_TEXTURE_ENV)});
    p.gl().TexEnvi(target, GL_TEXTURE_ENV_MODE,
                   static_cast<GLint>(
                       p.enumerant({TERRAZZO_E(GL_MODULATE), TERRAZZO_E(GL_DECAL), TERRAZZO_E(GL_BLEND),
                                    TERRAZZO_E(GL_REPLACE), TERRAZZO_E(GL_ADD), TERRAZZO_E(GL_COMBINE)})));
}

// Matrices are kept moderate. When one becomes singular by rounding, the inverse that the reference finds
// depends on what it had looked at before: PopAttrib, for one, may work out an inverse that nothing asked
// for.
void play_clip_plane(Player& p) {
    const GLenum plane = p.enumerant(kClipPlanes);
    const auto values = p.moderate_numbers(4);
    const GLdouble equation[4] = {values[0], values[1], values[2], values[3]};
    p.gl().ClipPlane(plane, equation);
}

void play_volume(Player& p) {
    GLdouble side[6];
    for (GLdouble& value : side) value = p.moderate_number();
    if (p.pick(2)) {
        p.gl().Frustum(side[0], side[1], side[2], side[3], side[4], side[5]);
    } else {
        p.gl().Ortho(side[0], side[1], side[2], side[3], side[4], side[5]);
    }
}

void play_polygon_stipple(Player& p) {
    // Large enough for what play_pixel_store may ask to skip.
    std::vector<GLubyte> pattern(2048);
    for (GLubyte& byte : pattern) byte = static_cast<GLubyte>(p.bits());
    p.gl().PolygonStipple(pattern.data());
}

void play_matrix(Player& p) {
    const auto values = p.moderate_numbers(16);
    if (p.pick(2)) {
        p.gl().MultMatrixf(values.data());
    } else {
        p.gl().LoadMatrixf(values.data());
    }
}

// The reference forgets, when a stack entry is popped, that groups which this entry had not saved were
// changed, and then leaves them as they are when the entry below is popped. So what is nested saves
// everything. Nor does it restore which lights are enabled for GL_ENABLE_BIT, as GL 1.5 table 6.12 has it.
void play_push_attrib(Player& p) {
    GLint depth = 0;
    p.gl().GetIntegerv(GL_ATTRIB_STACK_DEPTH, &depth);
    GLbitfield mask = 0;
    for (unsigned i = p.pick(4) + 1; i > 0; --i) mask |= kAttributeBits[p.pick(std::size(kAttributeBits))];
    if (depth > 0) mask = GL_ALL_ATTRIB_BITS;
    if (mask & GL_ENABLE_BIT) mask |= GL_LIGHTING_BIT;
    p.note(std::to_string(mask));
    p.gl().PushAttrib(mask);
}

void play_current_value(Player& p) {
    const auto v = p.numbers(4);
    const GLuint bits = p.bits();
    p.note(std::to_string(bits));
    const auto b = static_cast<GLbyte>(bits);
    const auto s = static_cast<GLshort>(bits);
    const auto i = static_cast<GLint>(bits);
    switch (p.pick(22)) {
        case 14:
            return p.gl().MultiTexCoord4f(GL_TEXTURE0 + p.pick(8), v[0], v[1], v[2], v[3]);
        case 15:
            return p.gl().MultiTexCoord1d(GL_TEXTURE0 + p.pick(8), v[0]);
        case 16:
            return p.gl().MultiTexCoord3s(GL_TEXTURE0 + p.pick(8), s, 7, -1);
        case 17:
            return p.gl().SecondaryColor3f(v[0], v[1], v[2]);
        case 18:
            return p.gl().SecondaryColor3b(b, 1, -128);
        case 19:
            return p.gl().SecondaryColor3us(static_cast<GLushort>(s), 1, 65535);
        case 20:
            return p.gl().FogCoordf(v[0]);
        case 21:
            return p.gl().FogCoordd(v[0]);
        case 0:
            return p.gl().Color4f(v[0], v[1], v[2], v[3]);
        case 1:
            return p.gl().Color3b(b, 1, -128);
        case 2:
            return p.gl().Color4ub(static_cast<GLubyte>(b), 1, 254, 255);
        case 3:
            return p.gl().Color3s(s, 1, -32768);
        case 4:
            return p.gl().Color4us(static_cast<GLushort>(s), 1, 2, 65535);
        case 5:
            return p.gl().Color3i(i, 1, -1);
        case 6:
            return p.gl().Color3ui(bits, 1, 0xffffffffu);
        case 7:
            return p.gl().Color3d(v[0], v[1], v[2]);
        case 8:
            return p.gl().Normal3f(v[0], v[1], v[2]);
        case 9:
            return p.gl().Normal3s(s, 0, -1);
        case 10:
            return p.gl().TexCoord4f(v[0], v[1], v[2], v[3]);
        case 11:
            return p.gl().TexCoord2s(s, 7);
        case 12:
            return p.gl().EdgeFlag(p.flag());
    }
    p.gl().Indexf(v[0]);
}

// Values and materials, with commands among them that are not allowed there. No vertices: what is drawn is
// for other tests, and the reference would compile shaders for every state.
void play_primitive(Player& p) {
    p.gl().Begin(p.pick(10) ? p.pick(10) : p.enumerant({TERRAZZO_E(GL_QUADS)}));
    for (unsigned i = p.pick(6); i > 0; --i) {
        switch (p.pick(4)) {
            case 0:
                p.gl().Enable(p.enumerant(kCapabilities));
                break;
            case 1:
                p.gl().PopMatrix();
                break;
            case 2:
                play_material(p);
                break;
            default:
                play_current_value(p);
        }
    }
    p.gl().End();
}

const Enumerants kArrays = {TERRAZZO_E(GL_VERTEX_ARRAY),          TERRAZZO_E(GL_NORMAL_ARRAY),
                            TERRAZZO_E(GL_COLOR_ARRAY),           TERRAZZO_E(GL_INDEX_ARRAY),
                            TERRAZZO_E(GL_TEXTURE_COORD_ARRAY),   TERRAZZO_E(GL_EDGE_FLAG_ARRAY),
                            TERRAZZO_E(GL_SECONDARY_COLOR_ARRAY), TERRAZZO_E(GL_FOG_COORDINATE_ARRAY)};

void play_query(Player& p) {
    const GLuint name = p.pick(3);
    GLuint result = 0;
    const unsigned choice = p.pick(6);
    p.note(std::to_string(name) + ' ' + std::to_string(choice));
    const Enumerants target = {TERRAZZO_E(GL_SAMPLES_PASSED)};
    switch (choice) {
        case 0:
        case 1:
            return p.gl().BeginQuery(p.enumerant(target), name);
        case 2:
            return p.gl().EndQuery(p.enumerant(target));
        case 3:
            return p.gl().DeleteQueries(1, &name);
        case 4:
            p.gl().GetQueryObjectuiv(name, p.enumerant({TERRAZZO_E(GL_QUERY_RESULT)}), &result);
            return p.note("result " + std::to_string(result));
    }
    p.note(std::to_string(p.gl().IsQuery(name)));
}

// Pointers are never read: arrays are set and enabled, but nothing is drawn from them. The reference stores
// some negative strides although it records the error, so there are none here.
void play_array(Player& p) {
    const GLint size = p.pick(4) == 0 ? GL_BGRA : static_cast<GLint>(p.pick(6));
    const GLsizei stride = static_cast<GLsizei>(p.pick(40));
    const void* pointer = reinterpret_cast<const void*>(std::uintptr_t{p.pick(64)} * 8);
    p.note(std::to_string(size) + ' ' + std::to_string(stride));
    const GLenum type =
        p.enumerant({TERRAZZO_E(GL_FLOAT), TERRAZZO_E(GL_SHORT), TERRAZZO_E(GL_BYTE),
                     TERRAZZO_E(GL_UNSIGNED_BYTE), TERRAZZO_E(GL_UNSIGNED_SHORT), TERRAZZO_E(GL_DOUBLE)});
    switch (p.pick(8)) {
        case 5:
            return p.gl().FogCoordPointer(type, stride, pointer);
        case 6:
            // The reference takes four components as well.
            return p.gl().SecondaryColorPointer(size == 4 ? 3 : size, type, stride, pointer);
        case 0:
            return p.gl().VertexPointer(size, type, stride, pointer);
        case 1:
            return p.gl().NormalPointer(type, stride, pointer);
        case 2:
            return p.gl().ColorPointer(size, type, stride, pointer);
        case 3:
            return p.gl().IndexPointer(type, stride, pointer);
        case 4:
            return p.gl().TexCoordPointer(size, type, stride, pointer);
    }
    p.gl().EdgeFlagPointer(stride, pointer);
}

// Objects keep to names that the program chooses: the libraries need not make the same ones.
void play_buffer(Player& p) {
    const GLuint name = p.pick(4);
    p.note(std::to_string(name));
    const GLenum target = p.enumerant({TERRAZZO_E(GL_ARRAY_BUFFER), TERRAZZO_E(GL_ELEMENT_ARRAY_BUFFER),
                                       TERRAZZO_E(GL_PIXEL_UNPACK_BUFFER)});
    const GLintptr offset = static_cast<GLintptr>(p.pick(40)) - 4;
    const GLsizeiptr size = static_cast<GLsizeiptr>(p.pick(40)) - 4;
    GLubyte bytes[64] = {};
    const unsigned choice = p.pick(10);
    p.note(std::to_string(choice) + ' ' + std::to_string(offset) + ' ' + std::to_string(size));
    switch (choice) {
        case 0:
        case 1:
        case 2:
            return p.gl().BindBuffer(target, name);
        case 3:
            return p.gl().DeleteBuffers(1, &name);
        case 4:
            return p.gl().BufferSubData(target, offset, size, bytes);
        case 5:
            return p.gl().GetBufferSubData(target, offset, size, bytes);
        case 6:
            p.gl().MapBuffer(target, p.enumerant({TERRAZZO_E(GL_READ_ONLY), TERRAZZO_E(GL_WRITE_ONLY),
                                                  TERRAZZO_E(GL_READ_WRITE)}));
            return;
        case 7:
            p.gl().UnmapBuffer(target);
            return;
    }
    p.gl().BufferData(
        target, size, p.pick(2) ? bytes : nullptr,
        p.enumerant({TERRAZZO_E(GL_STATIC_DRAW), TERRAZZO_E(GL_STREAM_READ), TERRAZZO_E(GL_DYNAMIC_COPY)}));
}

void play_interleaved_arrays(Player& p) {
    const GLsizei stride = static_cast<GLsizei>(p.pick(100)) - 4;
    p.note(std::to_string(stride));
    // The reference leaves these arrays as they are; GL 1.5 §2.8 disables them.
    p.gl().DisableClientState(GL_SECONDARY_COLOR_ARRAY);
    p.gl().DisableClientState(GL_FOG_COORDINATE_ARRAY);
    const GLenum format = p.pick(8) ? GL_V2F + p.pick(14) : p.enumerant({TERRAZZO_E(GL_T2F_V3F)});
    p.gl().InterleavedArrays(format, stride, nullptr);
}

void play_pixel_store(Player& p) {
    const GLenum pname = p.enumerant(
        {TERRAZZO_E(GL_UNPACK_SWAP_BYTES), TERRAZZO_E(GL_UNPACK_LSB_FIRST), TERRAZZO_E(GL_UNPACK_ROW_LENGTH),
         TERRAZZO_E(GL_UNPACK_SKIP_ROWS), TERRAZZO_E(GL_UNPACK_SKIP_PIXELS), TERRAZZO_E(GL_UNPACK_ALIGNMENT),
         TERRAZZO_E(GL_UNPACK_IMAGE_HEIGHT), TERRAZZO_E(GL_UNPACK_SKIP_IMAGES),
         TERRAZZO_E(GL_PACK_SWAP_BYTES), TERRAZZO_E(GL_PACK_LSB_FIRST), TERRAZZO_E(GL_PACK_ROW_LENGTH),
         TERRAZZO_E(GL_PACK_SKIP_ROWS), TERRAZZO_E(GL_PACK_SKIP_PIXELS), TERRAZZO_E(GL_PACK_ALIGNMENT),
         TERRAZZO_E(GL_PACK_IMAGE_HEIGHT), TERRAZZO_E(GL_PACK_SKIP_IMAGES)});
    // Small, because glPolygonStipple reads its pattern by them.
    const GLint value = static_cast<GLint>(p.pick(12)) - 2;
    p.note(std::to_string(value));
    p.gl().PixelStorei(pname, value);
}

void play_pixel_transfer(Player& p) {
    const GLenum pname =
        p.enumerant({TERRAZZO_E(GL_MAP_COLOR), TERRAZZO_E(GL_MAP_STENCIL), TERRAZZO_E(GL_RED_SCALE),
                     TERRAZZO_E(GL_RED_BIAS), TERRAZZO_E(GL_GREEN_SCALE), TERRAZZO_E(GL_BLUE_BIAS),
                     TERRAZZO_E(GL_ALPHA_SCALE), TERRAZZO_E(GL_DEPTH_SCALE), TERRAZZO_E(GL_DEPTH_BIAS)});
    if (p.pick(3)) return p.gl().PixelTransferf(pname, p.moderate_number());
    const GLenum integer = p.enumerant({TERRAZZO_E(GL_INDEX_SHIFT), TERRAZZO_E(GL_INDEX_OFFSET)});
    const GLint value = static_cast<GLint>(p.pick(64)) - 32;
    p.note(std::to_string(value));
    p.gl().PixelTransferi(integer, value);
}

void play_pixel_map(Player& p) {
    constexpr GLsizei kSizes[] = {1, 2, 8, 16, 0, -1, 512};  // the reference lets I_TO_I have any
    const GLsizei size = kSizes[p.pick(std::size(kSizes))];
    p.note(std::to_string(size));
    const std::vector<GLfloat> values(512, 0.5f);
    p.gl().PixelMapfv(GL_PIXEL_MAP_I_TO_I + p.pick(10), size, values.data());
}

void play_texture(Player& p) {
    const GLenum target = p.enumerant({TERRAZZO_E(GL_TEXTURE_1D), TERRAZZO_E(GL_TEXTURE_2D),
                                       TERRAZZO_E(GL_TEXTURE_3D), TERRAZZO_E(GL_TEXTURE_CUBE_MAP)});
    switch (p.pick(8)) {
        case 0: {
            const GLuint kind = target == GL_TEXTURE_1D         ? 1
                                : target == GL_TEXTURE_3D       ? 2
                                : target == GL_TEXTURE_CUBE_MAP ? 3
                                                                : 4;
            return p.gl().BindTexture(target, p.pick(3) * 4 + (p.pick(8) ? kind : p.pick(5)));
        }
        case 1: {
            const GLuint names[2] = {p.pick(12), p.pick(12)};
            return p.gl().DeleteTextures(2, names);
        }
        case 4:
            return p.gl().TexParameteri(
                target, GL_DEPTH_TEXTURE_MODE,
                static_cast<GLint>(
                    p.enumerant({TERRAZZO_E(GL_LUMINANCE), TERRAZZO_E(GL_INTENSITY), TERRAZZO_E(GL_ALPHA)})));
        case 5:
            return p.gl().TexParameteri(
                target, GL_TEXTURE_COMPARE_MODE,
                static_cast<GLint>(p.enumerant({TERRAZZO_E(GL_NONE), TERRAZZO_E(GL_COMPARE_R_TO_TEXTURE)})));
        case 6:
            return p.gl().TexParameteri(target, GL_TEXTURE_COMPARE_FUNC,
                                        static_cast<GLint>(p.enumerant(kComparisons)));
        case 2:
            return p.gl().TexParameterfv(target, GL_TEXTURE_BORDER_COLOR, p.moderate_numbers(4).data());
        case 3:
            return p.gl().TexParameteri(
                target, GL_TEXTURE_WRAP_S,
                static_cast<GLint>(p.enumerant(
                    {TERRAZZO_E(GL_CLAMP), TERRAZZO_E(GL_REPEAT), TERRAZZO_E(GL_CLAMP_TO_EDGE)})));
    }
    p.gl().TexParameteri(
        target, GL_TEXTURE_MIN_FILTER,
        static_cast<GLint>(p.enumerant({TERRAZZO_E(GL_NEAREST), TERRAZZO_E(GL_LINEAR_MIPMAP_LINEAR)})));
}

void play_blend_separate(Player& p) {
    const Enumerants equations = {TERRAZZO_E(GL_FUNC_ADD), TERRAZZO_E(GL_FUNC_SUBTRACT), TERRAZZO_E(GL_MIN),
                                  TERRAZZO_E(GL_MAX), TERRAZZO_E(GL_FUNC_REVERSE_SUBTRACT)};
    const auto v = p.numbers(4);
    switch (p.pick(3)) {
        case 0:
            return p.gl().BlendColor(v[0], v[1], v[2], v[3]);
        case 1:
            return p.gl().BlendEquation(p.enumerant(equations));
    }
    const GLenum source = p.enumerant(kBlendFactors), destination = p.enumerant(kBlendFactors);
    const GLenum source_alpha = p.enumerant(kBlendFactors);
    p.gl().BlendFuncSeparate(source, destination, source_alpha, p.enumerant({TERRAZZO_E(GL_CONSTANT_ALPHA)}));
}

// Arguments are drawn in statements of their own where a command takes several: the order in which C++
// evaluates arguments is not defined, and both programs must make the same calls.
const Command kCommands[] = {
    {"glEnable", [](Player& p) { p.gl().Enable(p.enumerant(kCapabilities)); }},
    {"glEnable", [](Player& p) { p.gl().Enable(p.enumerant(kCapabilities)); }},
    {"glDisable", [](Player& p) { p.gl().Disable(p.enumerant(kCapabilities)); }},
    {"glMatrixMode",
     [](Player& p) {
         p.gl().MatrixMode(
             p.enumerant({TERRAZZO_E(GL_MODELVIEW), TERRAZZO_E(GL_PROJECTION), TERRAZZO_E(GL_TEXTURE)}));
     }},
    {"glPushMatrix", [](Player& p) { p.gl().PushMatrix(); }},
    {"glPopMatrix", [](Player& p) { p.gl().PopMatrix(); }},
    {"glLoadIdentity", [](Player& p) { p.gl().LoadIdentity(); }},
    {"glRotatef",
     [](Player& p) {
         const auto v = p.moderate_numbers(4);
         p.gl().Rotatef(v[0], v[1], v[2], v[3]);
     }},
    {"glTranslatef",
     [](Player& p) {
         const auto v = p.moderate_numbers(3);
         p.gl().Translatef(v[0], v[1], v[2]);
     }},
    {"glScaled",
     [](Player& p) {
         const auto v = p.moderate_numbers(3);
         p.gl().Scaled(v[0], v[1], v[2]);
     }},
    {"glFrustum or glOrtho", play_volume},
    {"glMultMatrixf or glLoadMatrixf", play_matrix},
    {"glClipPlane", play_clip_plane},
    {"glViewport",
     [](Player& p) {
         const GLint v[4] = {p.integer(), p.integer(), p.integer(), p.integer()};
         p.gl().Viewport(v[0], v[1], v[2], v[3]);
     }},
    {"glDepthRange",
     [](Player& p) {
         const auto v = p.numbers(2);
         p.gl().DepthRange(v[0], v[1]);
     }},
    {"glFog", play_fog},
    {"glFog mode", play_fog_mode},
    {"glFogfv(GL_FOG_COLOR)", [](Player& p) { p.gl().Fogfv(GL_FOG_COLOR, p.numbers(4).data()); }},
    {"glLightfv", play_light_vector},
    {"glLightiv", play_light_integers},
    {"glLightf", play_light_scalar},
    {"glLightModel", play_light_model},
    {"glMaterialfv", play_material},
    {"glMaterialf(GL_SHININESS)", play_shininess},
    {"glColorMaterial",
     [](Player& p) {
         const GLenum face = p.enumerant(kFaces);
         p.gl().ColorMaterial(face, p.enumerant(kMaterialColors));
     }},
    {"glShadeModel",
     [](Player& p) {
         p.gl().ShadeModel(p.enumerant({TERRAZZO_E(GL_FLAT), TERRAZZO_E(GL_SMOOTH)}));
     }},
    {"glPointSize", [](Player& p) { p.gl().PointSize(p.number()); }},
    {"glPointParameter", play_point_parameter},
    {"colour sum and source of fog coordinates", play_fog_sources},
    // Not of a unit: the reference's PopAttrib makes that one 0.
    {"glTexParameteri(GL_GENERATE_MIPMAP)",
     [](Player& p) { p.gl().TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, p.flag()); }},
    {"texture bias",
     [](Player& p) { p.gl().TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, p.moderate_number()); }},
    {"degree of anisotropy",
     [](Player& p) {
         p.gl().TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, p.moderate_number());
     }},
    {"sprite",
     [](Player& p) {
         const GLint value = static_cast<GLint>(p.pick(5)) - 1;
         p.note(std::to_string(value));
         p.gl().TexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, value);
     }},
    {"glSampleCoverage",
     [](Player& p) {
         const GLfloat value = p.number();
         p.gl().SampleCoverage(value, p.flag());
     }},
    {"glLineWidth", [](Player& p) { p.gl().LineWidth(p.number()); }},
    {"glLineStipple",
     [](Player& p) {
         const GLint factor = p.integer();
         p.gl().LineStipple(factor, static_cast<GLushort>(p.bits()));
     }},
    {"glPolygonMode",
     [](Player& p) {
         const GLenum face = p.enumerant(kFaces);
         p.gl().PolygonMode(face,
                            p.enumerant({TERRAZZO_E(GL_POINT), TERRAZZO_E(GL_LINE), TERRAZZO_E(GL_FILL)}));
     }},
    {"glPolygonOffset",
     [](Player& p) {
         const auto v = p.numbers(2);
         p.gl().PolygonOffset(v[0], v[1]);
     }},
    {"glPolygonStipple", play_polygon_stipple},
    {"glCullFace", [](Player& p) { p.gl().CullFace(p.enumerant(kFaces)); }},
    {"glFrontFace",
     [](Player& p) {
         p.gl().FrontFace(p.enumerant({TERRAZZO_E(GL_CW), TERRAZZO_E(GL_CCW)}));
     }},
    {"glActiveTexture", play_active_texture},
    {"glClientActiveTexture",
     [](Player& p) {
         p.gl().ClientActiveTexture(p.pick(8) ? unit(p) : p.enumerant({TERRAZZO_E(GL_TEXTURE)}));
     }},
    {"glTexGen", play_texgen},
    {"glTexEnv", play_texture_environment},
    {"combiner", play_combiner},
    {"glScissor",
     [](Player& p) {
         const GLint v[4] = {p.integer(), p.integer(), p.integer(), p.integer()};
         p.gl().Scissor(v[0], v[1], v[2], v[3]);
     }},
    {"glAlphaFunc",
     [](Player& p) {
         const GLenum func = p.enumerant(kComparisons);
         p.gl().AlphaFunc(func, p.number());
     }},
    {"glStencilFunc",
     [](Player& p) {
         const GLenum func = p.enumerant(kComparisons);
         const GLint reference = p.integer();
         p.gl().StencilFunc(func, reference, p.bits());
     }},
    {"glStencilOp",
     [](Player& p) {
         const GLenum fail = p.enumerant(kStencilOperations), depth_fail = p.enumerant(kStencilOperations);
         p.gl().StencilOp(fail, depth_fail, p.enumerant(kStencilOperations));
     }},
    {"glStencilMask", [](Player& p) { p.gl().StencilMask(p.bits()); }},
    {"glDepthFunc", [](Player& p) { p.gl().DepthFunc(p.enumerant(kComparisons)); }},
    {"glDepthMask", [](Player& p) { p.gl().DepthMask(p.flag()); }},
    {"glBlendFunc",
     [](Player& p) {
         const GLenum source =
             p.pick(8) ? p.enumerant(kBlendFactors) : p.enumerant({TERRAZZO_E(GL_SRC_ALPHA_SATURATE)});
         p.gl().BlendFunc(source, p.enumerant(kBlendFactors));
     }},
    {"glLogicOp", [](Player& p) { p.gl().LogicOp(p.enumerant(kLogicOperations)); }},
    {"glColorMask",
     [](Player& p) {
         const GLboolean v[4] = {p.flag(), p.flag(), p.flag(), static_cast<GLboolean>(p.pick(256))};
         p.gl().ColorMask(v[0], v[1], v[2], v[3]);
     }},
    {"glIndexMask", [](Player& p) { p.gl().IndexMask(p.bits()); }},
    {"glClearColor",
     [](Player& p) {
         const auto v = p.numbers(4);
         p.gl().ClearColor(v[0], v[1], v[2], v[3]);
     }},
    // The reference keeps the index as an unsigned integer.
    {"glClearIndex", [](Player& p) { p.gl().ClearIndex(static_cast<GLfloat>(p.pick(300))); }},
    {"glClearDepth", [](Player& p) { p.gl().ClearDepth(p.number()); }},
    {"glClearStencil", [](Player& p) { p.gl().ClearStencil(p.integer()); }},
    {"glClearAccum",
     [](Player& p) {
         const auto v = p.numbers(4);
         p.gl().ClearAccum(v[0], v[1], v[2], v[3]);
     }},
    {"glDrawBuffer", [](Player& p) { p.gl().DrawBuffer(p.enumerant(kBuffers)); }},
    {"glReadBuffer", [](Player& p) { p.gl().ReadBuffer(p.enumerant(kReadBuffers)); }},
    {"glHint",
     [](Player& p) {
         const GLenum target = p.enumerant(kHints);
         p.gl().Hint(target,
                     p.enumerant({TERRAZZO_E(GL_FASTEST), TERRAZZO_E(GL_NICEST), TERRAZZO_E(GL_DONT_CARE)}));
     }},
    {"glPushAttrib", play_push_attrib},
    {"current value", play_current_value},
    {"glWindowPos", play_window_position},
    {"evaluator", play_evaluator},
    {"glRenderMode", play_render_mode},
    {"glBegin...glEnd", play_primitive},
    {"array pointer", play_array},
    {"buffer object", play_buffer},
    {"query", play_query},
    {"glInterleavedArrays", play_interleaved_arrays},
    {"glEnableClientState", [](Player& p) { p.gl().EnableClientState(p.enumerant(kArrays)); }},
    {"glDisableClientState", [](Player& p) { p.gl().DisableClientState(p.enumerant(kArrays)); }},
    {"glPixelStorei", play_pixel_store},
    {"glPixelTransferf", play_pixel_transfer},
    {"glPixelMapfv", play_pixel_map},
    {"glPixelZoom",
     [](Player& p) {
         const auto v = p.numbers(2);
         p.gl().PixelZoom(v[0], v[1]);
     }},
    {"texture", play_texture},
    {"blend", play_blend_separate},
    {"glListBase", [](Player& p) { p.gl().ListBase(p.pick(9)); }},
    {"glPopAttrib", [](Player& p) { p.gl().PopAttrib(); }},
    {"glPushClientAttrib", [](Player& p) { p.gl().PushClientAttrib(p.pick(4)); }},
    {"glPopClientAttrib", [](Player& p) { p.gl().PopClientAttrib(); }},
};

}  // namespace

std::string StatePlayer::play() {
    const Command& command = kCommands[pick(std::size(kCommands))];
    m_text = command.name;
    command.play(*this);
    return m_text;
}

GLenum StatePlayer::enumerant(const std::vector<Enumerant>& valid) {
    const auto& source = pick(12) == 0 ? kInvalid : valid;
    const Enumerant& chosen = source[pick(static_cast<unsigned>(source.size()))];
    note(chosen.name);
    return chosen.value;
}

GLfloat StatePlayer::number() {
    if (pick(16)) return moderate_number();
    note("1e10");
    return 1e10f;
}

GLfloat StatePlayer::moderate_number() {
    constexpr GLfloat kSpecial[] = {0, 1, -1, 0.5f, 2, 90, 128, 255, 1e-5f, -300};
    const bool special = pick(2) == 0;
    const GLfloat value =
        special ? kSpecial[pick(std::size(kSpecial))] : static_cast<GLfloat>(pick(20001)) / 4096.0f - 2.0f;
    note(std::to_string(value));
    return value;
}

GLint StatePlayer::integer() {
    constexpr GLint kSpecial[] = {0, 1, -1, 2, 255, 256, 257, 16384, 16385, 2147483647, -2147483647 - 1};
    const GLint value = pick(2) ? kSpecial[pick(std::size(kSpecial))] : static_cast<GLint>(pick(600)) - 100;
    note(std::to_string(value));
    return value;
}

std::vector<GLfloat> StatePlayer::numbers(int count) {
    std::vector<GLfloat> values;
    for (int i = 0; i < count; ++i) values.push_back(number());
    return values;
}

std::vector<GLfloat> StatePlayer::moderate_numbers(int count) {
    std::vector<GLfloat> values;
    for (int i = 0; i < count; ++i) values.push_back(moderate_number());
    return values;
}

void StatePlayer::note(const std::string& argument) {
    m_text += ' ' + argument;
}

}  // namespace terrazzo::test
