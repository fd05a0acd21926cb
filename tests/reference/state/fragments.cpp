// What fragments go through, and the buffers that they go to (GL 1.5 §4.1, §4.2).
#include "commands.h"

namespace terrazzo::test {
namespace {

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

const Command kCommands[] = {
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
    {"glStencilFuncSeparateATI",
     [](Player& p) {
         const GLenum front = p.enumerant(kComparisons), back = p.enumerant(kComparisons);
         const GLint reference = p.integer();
         p.gl().StencilFuncSeparateATI(front, back, reference, p.bits());
     }},
    {"glStencilOpSeparateATI",
     [](Player& p) {
         const GLenum face = p.enumerant(kFaces);
         const GLenum fail = p.enumerant(kStencilOperations), depth_fail = p.enumerant(kStencilOperations);
         p.gl().StencilOpSeparateATI(face, fail, depth_fail, p.enumerant(kStencilOperations));
     }},
    // Active for the command alone: the reference's PopAttrib forgets the face unless the capability changes.
    {"glActiveStencilFaceEXT",
     [](Player& p) {
         p.gl().ActiveStencilFaceEXT(p.enumerant({TERRAZZO_E(GL_FRONT), TERRAZZO_E(GL_BACK)}));
         const GLenum func = p.enumerant(kComparisons);
         const GLint reference = p.integer();
         p.gl().StencilFunc(func, reference, p.bits());
         p.gl().StencilMask(p.bits());
         p.gl().ActiveStencilFaceEXT(GL_FRONT);
     }},
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
    {"blend", play_blend_separate},
};

}  // namespace

std::span<const Command> fragments_commands() {
    return kCommands;
}

}  // namespace terrazzo::test
