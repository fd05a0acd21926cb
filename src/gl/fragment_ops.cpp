// Commands of the per-fragment operations (GL 1.5 §4.1, §4.2.2).
#include "gl/fragment_ops.h"

#include "gl/change.h"
#include "gl/generated/commands.h"

namespace terrazzo::gl {
namespace {

bool is_comparison(GLenum func) {
    return func >= GL_NEVER && func <= GL_ALWAYS;
}

bool is_stencil_operation(GLenum op) {
    switch (op) {
        case GL_KEEP:
        case GL_ZERO:
        case GL_REPLACE:
        case GL_INCR:
        case GL_DECR:
        case GL_INVERT:
        case GL_INCR_WRAP:
        case GL_DECR_WRAP:
            return true;
    }
    return false;
}

bool is_blend_factor(GLenum factor) {
    switch (factor) {
        case GL_ZERO:
        case GL_ONE:
        case GL_SRC_COLOR:
        case GL_ONE_MINUS_SRC_COLOR:
        case GL_DST_COLOR:
        case GL_ONE_MINUS_DST_COLOR:
        case GL_SRC_ALPHA:
        case GL_ONE_MINUS_SRC_ALPHA:
        case GL_DST_ALPHA:
        case GL_ONE_MINUS_DST_ALPHA:
        case GL_CONSTANT_COLOR:
        case GL_ONE_MINUS_CONSTANT_COLOR:
        case GL_CONSTANT_ALPHA:
        case GL_ONE_MINUS_CONSTANT_ALPHA:
            return true;
    }
    return false;
}

bool is_source_factor(GLenum factor) {
    return is_blend_factor(factor) || factor == GL_SRC_ALPHA_SATURATE;
}

bool is_blend_equation(GLenum mode) {
    switch (mode) {
        case GL_FUNC_ADD:
        case GL_FUNC_SUBTRACT:
        case GL_FUNC_REVERSE_SUBTRACT:
        case GL_MIN:
        case GL_MAX:
            return true;
    }
    return false;
}

}  // namespace

void scissor(Context& ctx, GLint x, GLint y, GLsizei width, GLsizei height) {
    if (width < 0 || height < 0) return record_error(ctx, GL_INVALID_VALUE, "width or height is negative");
    ScissorState& scissor = ctx.fragment_ops.scissor;
    if (x == scissor.x && y == scissor.y && width == scissor.width && height == scissor.height) return;
    begin_change(ctx, Dirty::kFragment);
    scissor = {scissor.enabled, x, y, width, height};
}

void alpha_func(Context& ctx, GLenum func, GLfloat ref) {
    if (!is_comparison(func)) return record_error(ctx, GL_INVALID_ENUM, "no such comparison");
    change(ctx, Dirty::kFragment, ctx.fragment_ops.color.alpha_test.func, func);
    change(ctx, Dirty::kFragment, ctx.fragment_ops.color.alpha_test.reference, ref);
}

void stencil_func(Context& ctx, GLenum func, GLint ref, GLuint mask) {
    if (!is_comparison(func)) return record_error(ctx, GL_INVALID_ENUM, "no such comparison");
    StencilState& stencil = ctx.fragment_ops.stencil;
    change(ctx, Dirty::kFragment, stencil.func, func);
    change(ctx, Dirty::kFragment, stencil.reference, ref);
    change(ctx, Dirty::kFragment, stencil.value_mask, mask);
}

void stencil_op(Context& ctx, GLenum fail, GLenum zfail, GLenum zpass) {
    if (!is_stencil_operation(fail) || !is_stencil_operation(zfail) || !is_stencil_operation(zpass)) {
        return record_error(ctx, GL_INVALID_ENUM, "no such stencil operation");
    }
    StencilState& stencil = ctx.fragment_ops.stencil;
    change(ctx, Dirty::kFragment, stencil.fail, fail);
    change(ctx, Dirty::kFragment, stencil.depth_fail, zfail);
    change(ctx, Dirty::kFragment, stencil.depth_pass, zpass);
}

void stencil_mask(Context& ctx, GLuint mask) {
    change(ctx, Dirty::kFragment, ctx.fragment_ops.stencil.write_mask, mask);
}

void depth_func(Context& ctx, GLenum func) {
    if (!is_comparison(func)) return record_error(ctx, GL_INVALID_ENUM, "no such comparison");
    change(ctx, Dirty::kFragment, ctx.fragment_ops.depth.func, func);
}

void depth_mask(Context& ctx, GLboolean flag) {
    change(ctx, Dirty::kFragment, ctx.fragment_ops.depth.write_mask, flag != GL_FALSE);
}

void blend_func(Context& ctx, GLenum sfactor, GLenum dfactor) {
    blend_func_separate(ctx, sfactor, dfactor, sfactor, dfactor);
}

void blend_func_separate(Context& ctx, GLenum sfactor_rgb, GLenum dfactor_rgb, GLenum sfactor_alpha,
                         GLenum dfactor_alpha) {
    const bool ok = is_source_factor(sfactor_rgb) && is_source_factor(sfactor_alpha) &&
                    is_blend_factor(dfactor_rgb) && is_blend_factor(dfactor_alpha);
    if (!ok) return record_error(ctx, GL_INVALID_ENUM, "no such blend factor");
    BlendState& blend = ctx.fragment_ops.color.blend;
    change(ctx, Dirty::kFragment, blend.source_rgb, sfactor_rgb);
    change(ctx, Dirty::kFragment, blend.source_alpha, sfactor_alpha);
    change(ctx, Dirty::kFragment, blend.destination_rgb, dfactor_rgb);
    change(ctx, Dirty::kFragment, blend.destination_alpha, dfactor_alpha);
}

void blend_equation(Context& ctx, GLenum mode) {
    blend_equation_separate(ctx, mode, mode);
}

void blend_equation_separate(Context& ctx, GLenum mode_rgb, GLenum mode_alpha) {
    if (!is_blend_equation(mode_rgb) || !is_blend_equation(mode_alpha)) {
        return record_error(ctx, GL_INVALID_ENUM, "no such blend equation");
    }
    change(ctx, Dirty::kFragment, ctx.fragment_ops.color.blend.equation_rgb, mode_rgb);
    change(ctx, Dirty::kFragment, ctx.fragment_ops.color.blend.equation_alpha, mode_alpha);
}

void blend_color(Context& ctx, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha) {
    change(ctx, Dirty::kFragment, ctx.fragment_ops.color.blend.color, std::array{red, green, blue, alpha});
}

void logic_op(Context& ctx, GLenum opcode) {
    if (opcode < GL_CLEAR || opcode > GL_SET)
        return record_error(ctx, GL_INVALID_ENUM, "no such logic operation");
    change(ctx, Dirty::kFragment, ctx.fragment_ops.color.logic_op.op, opcode);
}

void color_mask(Context& ctx, GLboolean red, GLboolean green, GLboolean blue, GLboolean alpha) {
    change(ctx, Dirty::kFragment, ctx.fragment_ops.color.write_mask,
           std::array{red != GL_FALSE, green != GL_FALSE, blue != GL_FALSE, alpha != GL_FALSE});
}

void index_mask(Context& ctx, GLuint mask) {
    change(ctx, Dirty::kFragment, ctx.fragment_ops.color.index_write_mask, mask);
}

}  // namespace terrazzo::gl
