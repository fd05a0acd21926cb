// Begin/End and the current vertex attributes (GL 1.5 §2.6, §2.7).
//
// Commands store into VertexState; complete primitives are batched and handed to the pipeline.
#pragma once

#include <GL/gl.h>

#include <array>

namespace terrazzo::gl {

// The values a vertex takes that gives none of its own (GL 1.5 §2.7); saved by glPushAttrib(GL_CURRENT_BIT).
struct CurrentAttributes {
    std::array<GLfloat, 4> color{1, 1, 1, 1};
};

struct VertexState {
    CurrentAttributes current;
};

}  // namespace terrazzo::gl
