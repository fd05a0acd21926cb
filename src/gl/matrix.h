// Coordinate transformation state (GL 1.5 §2.11, §2.12; tables 6.9, 6.10): matrix stacks, user clip planes,
// and what happens to normals on their way to eye space.
//
// Matrices are column-major as GL hands them over: element (row, column) is m[4 * column + row].
#pragma once

#include <GL/gl.h>

#include <array>
#include <vector>

#include "gl/limits.h"

namespace terrazzo::gl {

struct Matrix {
    std::array<GLfloat, 16> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
};

// Never empty; the current matrix is the last entry.
struct MatrixStack {
    explicit MatrixStack(int depth) : max_depth(depth) {}

    Matrix& top() { return entries.back(); }
    const Matrix& top() const { return entries.back(); }

    std::vector<Matrix> entries = std::vector<Matrix>(1);
    int max_depth;
};

struct ClipPlane {
    bool enabled = false;
    std::array<GLfloat, 4> eye_plane{};  // inside is dot(eye_plane, eye position) >= 0
};

// The part that glPushAttrib(GL_TRANSFORM_BIT) saves.
struct TransformState {
    GLenum matrix_mode = GL_MODELVIEW;
    std::array<ClipPlane, kMaxClipPlanes> clip_planes;
    bool normalize = false;
    bool rescale_normal = false;
};

struct MatrixState {
    MatrixStack modelview{kMaxModelviewDepth};
    MatrixStack projection{kMaxProjectionDepth};
    std::vector<MatrixStack> texture =
        std::vector<MatrixStack>(kMaxTextureUnits, MatrixStack(kMaxTextureMatrixDepth));
    TransformState transform;
};

}  // namespace terrazzo::gl
