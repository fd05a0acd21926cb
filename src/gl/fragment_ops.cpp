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

// Assigns to `member` of the faces that a command without a face sets.
template <typename Value>
void set_active(Context& ctx, Value StencilFace::*member, Value value) {
    StencilState& stencil = ctx.fragment_ops.stencil;
    if (stencil.active_face == GL_BACK)
        return change(ctx, Dirty::kFragment, stencil.two_side_back.*member, value);
    change(ctx, Dirty::kFragment, stencil.front.*member, value);
    change(ctx, Dirty::kFragment, stencil.back.*member, value);
}

// The same of those that `face` names.
template <typename Value>
void set_face(Context& ctx, GLenum face, Value StencilFace::*member, Value value) {
    StencilState& stencil = ctx.fragment_ops.stencil;
    if (face != GL_BACK) change(ctx, Dirty::kFragment, stencil.front.*member, value);
    if (face != GL_FRONT) change(ctx, Dirty::kFragment, stencil.back.*member, value);
}

bool is_face(GLenum face) {
    return face == GL_FRONT || face == GL_BACK || face == GL_FRONT_AND_BACK;
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
    set_active(ctx, &StencilFace::func, func);
    set_active(ctx, &StencilFace::reference, ref);
    set_active(ctx, &StencilFace::value_mask, mask);
}

void stencil_op(Context& ctx, GLenum fail, GLenum zfail, GLenum zpass) {
    if (!is_stencil_operation(fail) || !is_stencil_operation(zfail) || !is_stencil_operation(zpass)) {
        return record_error(ctx, GL_INVALID_ENUM, "no such stencil operation");
    }
    set_active(ctx, &StencilFace::fail, fail);
    set_active(ctx, &StencilFace::depth_fail, zfail);
    set_active(ctx, &StencilFace::depth_pass, zpass);
}

void stencil_mask(Context& ctx, GLuint mask) {
    set_active(ctx, &StencilFace::write_mask, mask);
}

void active_stencil_face_ext(Context& ctx, GLenum face) {
    if (face != GL_FRONT && face != GL_BACK)
        return record_error(ctx, GL_INVALID_ENUM, "face is neither GL_FRONT nor GL_BACK");
    ctx.fragment_ops.stencil.active_face = face;
}

void stencil_func_separate(Context& ctx, GLenum face, GLenum func, GLint ref, GLuint mask) {
    if (!is_face(face)) return record_error(ctx, GL_INVALID_ENUM, "no such face");
    if (!is_comparison(func)) return record_error(ctx, GL_INVALID_ENUM, "no such comparison");
    set_face(ctx, face, &StencilFace::func, func);
    set_face(ctx, face, &StencilFace::reference, ref);
    set_face(ctx, face, &StencilFace::value_mask, mask);
}

void stencil_func_separate_ati(Context& ctx, GLenum frontfunc, GLenum backfunc, GLint ref, GLuint mask) {
    if (!is_comparison(frontfunc) || !is_comparison(backfunc))
        return record_error(ctx, GL_INVALID_ENUM, "no such comparison");
    stencil_func_separate(ctx, GL_FRONT, frontfunc, ref, mask);
    stencil_func_separate(ctx, GL_BACK, backfunc, ref, mask);
}

void stencil_op_separate(Context& ctx, GLenum face, GLenum sfail, GLenum dpfail, GLenum dppass) {
    if (!is_face(face)) return record_error(ctx, GL_INVALID_ENUM, "no such face");
    if (!is_stencil_operation(sfail) || !is_stencil_operation(dpfail) || !is_stencil_operation(dppass))
        return record_error(ctx, GL_INVALID_ENUM, "no such stencil operation");
    set_face(ctx, face, &StencilFace::fail, sfail);
    set_face(ctx, face, &StencilFace::depth_fail, dpfail);
    set_face(ctx, face, &StencilFace::depth_pass, dppass);
}

void stencil_mask_separate(Context& ctx, GLenum face, GLuint mask) {
    if (!is_face(face)) return record_error(ctx, GL_INVALID_ENUM, "no such face");
    set_face(ctx, face, &StencilFace::write_mask, mask);
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
