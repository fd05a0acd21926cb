// Parts of validate() that have files of their own.
#pragma once

#include "pipeline/vertex_input.h"
#include "pipeline/vertex_state.h"

namespace terrazzo::gl {

struct Context;

// Lighting and what becomes of normals. `vertex` has its texture coordinates already, and the modelview
// matrix is settled: both say which space lighting happens in.
void make_lighting(const Context& ctx, const pipeline::VertexInput& input, pipeline::VertexState& vertex);

}  // namespace terrazzo::gl
