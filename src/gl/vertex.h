// Begin/End and the current vertex attributes (GL 1.5 §2.6, §2.7).
//
// Commands store into VertexState; complete primitives are batched and handed to the pipeline.
#pragma once

#include <GL/gl.h>

namespace terrazzo::gl {

struct VertexState {};

}  // namespace terrazzo::gl
