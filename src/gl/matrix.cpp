// Commands of the matrix stacks and the user clip planes (GL 1.5 §2.11.2, §2.12).
//
// The arithmetic is matrix_math's. Pushing and popping a matrix that is not changed in between is no change
// for queued vertices, so both compare.
#include "gl/matrix.h"

#include <cstring>

#include "gl/change.h"
#include "gl/generated/commands.h"

namespace terrazzo::gl {
namespace {

MatrixStack& current_stack(Context& ctx) {
    switch (ctx.matrix.transform.matrix_mode) {
        case GL_PROJECTION:
            return ctx.matrix.projection;
        case GL_TEXTURE:
            return ctx.matrix.texture[ctx.texture.active_unit];
    }
    return ctx.matrix.modelview;
}

StackMatrix& changing_matrix(Context& ctx) {
    begin_change(ctx, Dirty::kTransform);
    return current_stack(ctx).top();
}

bool same_bits(const Matrix4& a, const Matrix4& b) {
    return std::memcmp(a.m, b.m, sizeof a.m) == 0;
}

Matrix4 matrix_at(const GLfloat* m) {
    Matrix4 result;
    std::memcpy(result.m, m, sizeof result.m);
    return result;
}

ClipPlane* find_clip_plane(Context& ctx, GLenum plane) {
    if (plane - GL_CLIP_PLANE0 < static_cast<GLenum>(kMaxClipPlanes)) {
        return &ctx.matrix.transform.clip_planes[plane - GL_CLIP_PLANE0];
    }
    record_error(ctx, GL_INVALID_ENUM, "no such clip plane");
    return nullptr;
}

}  // namespace

std::array<GLfloat, 4> plane_to_eye(MatrixState& matrix, const GLfloat plane[4]) {
    StackMatrix& modelview = matrix.modelview.top();
    settle(modelview);
    std::array<GLfloat, 4> eye_plane;
    transform_row(eye_plane.data(), plane, modelview.inverse);
    return eye_plane;
}

void matrix_mode(Context& ctx, GLenum mode) {
    if (mode != GL_MODELVIEW && mode != GL_PROJECTION && mode != GL_TEXTURE) {
        return record_error(ctx, GL_INVALID_ENUM, "no such matrix stack");
    }
    ctx.matrix.transform.matrix_mode = mode;
}

void clip_control(Context& ctx, GLenum origin, GLenum depth) {
    if (origin != GL_LOWER_LEFT && origin != GL_UPPER_LEFT)
        return record_error(ctx, GL_INVALID_ENUM, "no such clip origin");
    if (depth != GL_NEGATIVE_ONE_TO_ONE && depth != GL_ZERO_TO_ONE)
        return record_error(ctx, GL_INVALID_ENUM, "no such clip depth mode");
    TransformState& transform = ctx.matrix.transform;
    if (transform.clip_origin == origin && transform.clip_depth_mode == depth) return;
    // The origin turns the front side round.
    begin_change(ctx, Dirty::kTransform);
    begin_change(ctx, Dirty::kRasterization);
    transform.clip_origin = origin;
    transform.clip_depth_mode = depth;
}

void push_matrix(Context& ctx) {
    MatrixStack& stack = current_stack(ctx);
    if (static_cast<int>(stack.entries.size()) == stack.max_depth) {
        return record_error(ctx, GL_STACK_OVERFLOW, "the matrix stack is full");
    }
    settle(stack.top());
    stack.entries.push_back(stack.top());
}

void pop_matrix(Context& ctx) {
    MatrixStack& stack = current_stack(ctx);
    if (stack.entries.size() == 1) {
        return record_error(ctx, GL_STACK_UNDERFLOW, "the matrix stack has one matrix left");
    }
    const StackMatrix& below = stack.entries[stack.entries.size() - 2];
    if (!same_bits(below.value, stack.top().value)) begin_change(ctx, Dirty::kTransform);
    stack.entries.pop_back();
}

void load_identity(Context& ctx) {
    load_identity(changing_matrix(ctx));
}

void load_matrixf(Context& ctx, const GLfloat* m) {
    load(changing_matrix(ctx), matrix_at(m));
}

void mult_matrixf(Context& ctx, const GLfloat* m) {
    multiply(changing_matrix(ctx), matrix_at(m));
}

void rotatef(Context& ctx, GLfloat angle, GLfloat x, GLfloat y, GLfloat z) {
    rotate(changing_matrix(ctx), angle, x, y, z);
}

void scalef(Context& ctx, GLfloat x, GLfloat y, GLfloat z) {
    scale(changing_matrix(ctx), x, y, z);
}

void translatef(Context& ctx, GLfloat x, GLfloat y, GLfloat z) {
    translate(changing_matrix(ctx), x, y, z);
}

void frustum(Context& ctx, GLdouble left, GLdouble right, GLdouble bottom, GLdouble top, GLdouble zNear,
             GLdouble zFar) {
    if (zNear <= 0 || zFar <= 0 || zNear == zFar || left == right || bottom == top) {
        return record_error(ctx, GL_INVALID_VALUE, "a distance is not positive, or the volume is empty");
    }
    frustum(changing_matrix(ctx), left, right, bottom, top, zNear, zFar);
}

void ortho(Context& ctx, GLdouble left, GLdouble right, GLdouble bottom, GLdouble top, GLdouble zNear,
           GLdouble zFar) {
    if (left == right || bottom == top || zNear == zFar) {
        return record_error(ctx, GL_INVALID_VALUE, "the volume is empty");
    }
    ortho(changing_matrix(ctx), left, right, bottom, top, zNear, zFar);
}

void clip_plane(Context& ctx, GLenum plane, const GLdouble* equation) {
    ClipPlane* target = find_clip_plane(ctx, plane);
    if (!target) return;
    std::array<GLfloat, 4> object_plane;
    for (int i = 0; i < 4; ++i) object_plane[i] = static_cast<GLfloat>(equation[i]);
    change(ctx, Dirty::kTransform, target->eye_plane, plane_to_eye(ctx.matrix, object_plane.data()));
}

void get_clip_plane(Context& ctx, GLenum plane, GLdouble* equation) {
    const ClipPlane* source = find_clip_plane(ctx, plane);
    if (!source) return;
    for (int i = 0; i < 4; ++i) equation[i] = source->eye_plane[i];
}

}  // namespace terrazzo::gl
