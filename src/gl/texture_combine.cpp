// The parameters of the texture environment GL_COMBINE (GL 1.5 §3.8.13, tables 3.24-3.26), with the functions
// and sources of ATI_texture_env_combine3 and the dot products of EXT_texture_env_dot3.
#include <GL/gl.h>
#include <GL/glext.h>

#include <utility>

#include "gl/change.h"
#include "gl/texture_env.h"

namespace terrazzo::gl {
namespace {

bool is_function_of_both(GLenum function) {
    switch (function) {
        case GL_REPLACE:
        case GL_MODULATE:
        case GL_ADD:
        case GL_ADD_SIGNED:
        case GL_INTERPOLATE:
        case GL_SUBTRACT:
        case GL_MODULATE_ADD_ATI:
        case GL_MODULATE_SIGNED_ADD_ATI:
        case GL_MODULATE_SUBTRACT_ATI:
            return true;
    }
    return false;
}

bool is_dot_product(GLenum function) {
    return function == GL_DOT3_RGB || function == GL_DOT3_RGBA || function == GL_DOT3_RGB_EXT ||
           function == GL_DOT3_RGBA_EXT;
}

bool is_source(GLenum source) {
    switch (source) {
        case GL_TEXTURE:
        case GL_CONSTANT:
        case GL_PRIMARY_COLOR:
        case GL_PREVIOUS:
        case GL_ZERO:
        case GL_ONE:
            return true;
    }
    return source - GL_TEXTURE0 < static_cast<GLenum>(kMaxTextureUnits);
}

bool is_alpha_operand(GLenum operand) {
    return operand == GL_SRC_ALPHA || operand == GL_ONE_MINUS_SRC_ALPHA;
}

bool is_color_operand(GLenum operand) {
    return operand == GL_SRC_COLOR || operand == GL_ONE_MINUS_SRC_COLOR || is_alpha_operand(operand);
}

// Where a parameter lives: one of the two pointers, or none.
template <typename Env>
struct Slot {
    decltype(&std::declval<Env&>().rgb.function) enumerant = nullptr;
    decltype(&std::declval<Env&>().rgb.scale) scale = nullptr;
    bool (*allowed)(GLenum) = nullptr;
};

template <typename Env>
Slot<Env> slot_of(Env& env, GLenum pname) {
    if (pname - GL_SRC0_RGB < 3) return {&env.rgb.sources[pname - GL_SRC0_RGB], nullptr, is_source};
    if (pname - GL_SRC0_ALPHA < 3) return {&env.alpha.sources[pname - GL_SRC0_ALPHA], nullptr, is_source};
    if (pname - GL_OPERAND0_RGB < 3)
        return {&env.rgb.operands[pname - GL_OPERAND0_RGB], nullptr, is_color_operand};
    if (pname - GL_OPERAND0_ALPHA < 3)
        return {&env.alpha.operands[pname - GL_OPERAND0_ALPHA], nullptr, is_alpha_operand};
    switch (pname) {
        case GL_COMBINE_RGB:
            return {&env.rgb.function, nullptr,
                    [](GLenum f) { return is_function_of_both(f) || is_dot_product(f); }};
        case GL_COMBINE_ALPHA:
            return {&env.alpha.function, nullptr, is_function_of_both};
        case GL_RGB_SCALE:
            return {nullptr, &env.rgb.scale};
        case GL_ALPHA_SCALE:
            return {nullptr, &env.alpha.scale};
    }
    return {};
}

}  // namespace

bool set_combine_parameter(Context& ctx, TextureEnv& env, GLenum pname, const GLfloat* params) {
    const Slot<TextureEnv> slot = slot_of(env, pname);
    if (!slot.scale && !slot.enumerant) return false;
    const GLfloat value = *params;
    if (slot.scale) {
        if (value != 1 && value != 2 && value != 4) {
            record_error(ctx, GL_INVALID_VALUE, "the scale is not 1, 2 or 4");
        } else {
            change(ctx, Dirty::kTexture, *slot.scale, value);
        }
        return true;
    }
    const bool is_enumerant = value >= 0 && value < 65536 && slot.allowed(static_cast<GLenum>(value));
    if (!is_enumerant) {
        record_error(ctx, GL_INVALID_ENUM, "no such function, source or operand");
    } else {
        change(ctx, Dirty::kTexture, *slot.enumerant, value);
    }
    return true;
}

bool get_combine_parameter(const TextureEnv& env, GLenum pname, GLfloat& value) {
    const Slot<const TextureEnv> slot = slot_of(env, pname);
    if (slot.scale) value = *slot.scale;
    if (slot.enumerant) value = static_cast<GLfloat>(*slot.enumerant);
    return slot.scale || slot.enumerant;
}

}  // namespace terrazzo::gl
