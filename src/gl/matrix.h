// Coordinate transformation state (GL 1.5 §2.11, §2.12; tables 6.9, 6.10): matrix stacks, user clip planes,
// and what happens to normals on their way to eye space.
#pragma once

#include <GL/gl.h>

#include <array>
#include <vector>

#include "gl/limits.h"
#include "gl/matrix_math.h"

namespace terrazzo::gl {

// Never empty; the current matrix is the last entry.
struct MatrixStack {
    explicit MatrixStack(int depth) : max_depth(depth) {}

    StackMatrix& top() { return entries.back(); }
    const StackMatrix& top() const { return entries.back(); }

    std::vector<StackMatrix> entries{StackMatrix{}};
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
    GLenum clip_origin = GL_LOWER_LEFT;  // ARB_clip_control
    GLenum clip_depth_mode = GL_NEGATIVE_ONE_TO_ONE;
    bool depth_clamp = false;  // ARB_depth_clamp
};

struct MatrixState {
    MatrixStack modelview{kMaxModelviewDepth};
    MatrixStack projection{kMaxProjectionDepth};
    std::vector<MatrixStack> texture =
        std::vector<MatrixStack>(kMaxTextureUnits, MatrixStack(kMaxTextureMatrixDepth));
    TransformState transform;
};

// A plane given in object coordinates, in the eye coordinates of the current model-view matrix: the row
// vector times the inverse (GL 1.5 §2.11.4, §2.12).
std::array<GLfloat, 4> plane_to_eye(MatrixState& matrix, const GLfloat plane[4]);

}  // namespace terrazzo::gl
