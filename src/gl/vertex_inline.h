// The commands called once per vertex, small enough to be inlined into the generated thunks.
#pragma once

#include <cstring>

#include "gl/context.h"

namespace terrazzo::gl {

inline void set_attribute(Context& ctx, int attribute, GLfloat x, GLfloat y, GLfloat z, GLfloat w) {
    const VertexBatch& batch = ctx.vertex.batch;
    if (batch.count != 0 && !(batch.mask & pipeline::bit(attribute))) stream_attribute(ctx, attribute);
    ctx.vertex.current.values[static_cast<std::size_t>(attribute)] = {x, y, z, w};
}

inline void vertex4f(Context& ctx, GLfloat x, GLfloat y, GLfloat z, GLfloat w) {
    VertexBatch& batch = ctx.vertex.batch;
    if (batch.end - batch.next < static_cast<std::ptrdiff_t>(batch.stride)) grow_batch(ctx);
    float* out = batch.next;
    out[0] = x, out[1] = y, out[2] = z, out[3] = w;
    for (std::uint32_t i = 0; i < batch.stream_count; ++i) {
        out += 4;
        std::memcpy(out, ctx.vertex.current.values[batch.streams[i]].data(), 4 * sizeof(float));
    }
    batch.next += batch.stride;
    ++batch.count;
    batch.w_is_one = batch.w_is_one && w == 1.0f;
}

inline void color4f(Context& ctx, GLfloat r, GLfloat g, GLfloat b, GLfloat a) {
    set_attribute(ctx, pipeline::kColor, r, g, b, a);
}
inline void normal3f(Context& ctx, GLfloat x, GLfloat y, GLfloat z) {
    set_attribute(ctx, pipeline::kNormal, x, y, z, 1);
}
inline void tex_coord4f(Context& ctx, GLfloat s, GLfloat t, GLfloat r, GLfloat q) {
    set_attribute(ctx, pipeline::kTexture0, s, t, r, q);
}
inline void edge_flag(Context& ctx, GLboolean flag) {
    set_attribute(ctx, pipeline::kEdgeFlag, flag ? 1.0f : 0.0f, 0, 0, 1);
}
inline void indexf(Context& ctx, GLfloat c) {
    ctx.vertex.current.index = c;
}

}  // namespace terrazzo::gl
