// Selection and feedback (GL 1.5 §5.2, §5.3; tables 6.33): the modes in which primitives become records in
// the client's memory instead of pixels.
#pragma once

#include <GL/gl.h>

#include <array>
#include <cstddef>

#include "gl/limits.h"
#include "pipeline/geometry/renderer.h"

namespace terrazzo::gl {

struct Context;

struct SelectionState {
    GLuint* buffer = nullptr;
    GLsizei size = 0;
    std::size_t written = 0;  // values, with those there was no room for
    GLint hits = 0;
    bool hit = false;  // since the last record
    GLfloat lowest_z = 1, highest_z = 0;
    std::array<GLuint, kMaxNameStackDepth> names{};
    int depth = 0;
};

struct FeedbackState {
    GLfloat* buffer = nullptr;
    GLsizei size = 0;
    GLenum type = GL_2D;
    std::size_t written = 0;  // as above
};

struct RenderModeState {
    GLenum mode = GL_RENDER;
    SelectionState selection;
    FeedbackState feedback;
};

// What draw_primitives() does in these modes. Throws std::bad_alloc.
void capture_primitives(Context& ctx, GLenum mode, const pipeline::VertexInput& input,
                        const pipeline::VertexRange& range);

// What a bitmap or pixel rectangle at the current raster position leaves behind (`token` in feedback).
void capture_raster(Context& ctx, GLenum token);

// Selection: something is drawn at this depth.
void note_hit(Context& ctx, GLfloat z);

}  // namespace terrazzo::gl
