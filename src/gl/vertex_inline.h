// The commands called once per vertex, small enough to be inlined into the generated thunks.
#pragma once

#include <cstring>

#include "gl/context.h"

namespace terrazzo::gl {

// What a command does when it cannot be done with by storing values. These throw nothing, and the inlined
// parts end with a call of them, so that the usual way through needs no stack frame.
void set_attribute_slowly(Context& ctx, int attribute, GLfloat x, GLfloat y, GLfloat z, GLfloat w) noexcept;
void vertex4f_slowly(Context& ctx, GLfloat x, GLfloat y, GLfloat z, GLfloat w) noexcept;

inline void set_attribute(Context& ctx, int attribute, GLfloat x, GLfloat y, GLfloat z, GLfloat w) {
    VertexBatch& batch = ctx.vertex.batch;
    if ((pipeline::bit(attribute) & pipeline::kHomogeneous) && w != 1)
        batch.fourth |= pipeline::bit(attribute);
    if (batch.count != 0 && !(batch.mask & pipeline::bit(attribute))) [[unlikely]] {
        return set_attribute_slowly(ctx, attribute, x, y, z, w);
    }
    // One store, because the next vertex takes the value with one load: four stores would not be forwarded to
    // it.
    using Four = GLfloat __attribute__((vector_size(16)));
    const Four value = {x, y, z, w};
    std::memcpy(ctx.vertex.current.values[static_cast<std::size_t>(attribute)].data(), &value, sizeof value);
}

inline void vertex4f(Context& ctx, GLfloat x, GLfloat y, GLfloat z, GLfloat w) {
    VertexBatch& batch = ctx.vertex.batch;
    if (batch.end - batch.next < static_cast<std::ptrdiff_t>(batch.stride)) [[unlikely]] {
        return vertex4f_slowly(ctx, x, y, z, w);
    }
    float* out = batch.next;
    out[0] = x, out[1] = y, out[2] = z, out[3] = w;
    for (std::uint32_t i = 0; i < batch.stream_count; ++i) {
        out += 4;
        std::memcpy(out, ctx.vertex.current.values[batch.streams[i]].data(), 4 * sizeof(float));
    }
    batch.next += batch.stride;
    ++batch.count;
    if (w != 1) batch.fourth |= pipeline::bit(pipeline::kPosition);
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
// An invalid unit's effect is undefined; the reference takes the number's last bits too.
inline void multi_tex_coord4f(Context& ctx, GLenum target, GLfloat s, GLfloat t, GLfloat r, GLfloat q) {
    static_assert(kMaxTextureUnits == 8 && GL_TEXTURE0 % 8 == 0);
    set_attribute(ctx, pipeline::kTexture0 + static_cast<int>(target & 7), s, t, r, q);
}
inline void secondary_color3f(Context& ctx, GLfloat r, GLfloat g, GLfloat b) {
    set_attribute(ctx, pipeline::kSecondaryColor, r, g, b, 1);
}
inline void fog_coordf(Context& ctx, GLfloat coordinate) {
    set_attribute(ctx, pipeline::kFogCoordinate, coordinate, 0, 0, 1);
}
inline void edge_flag(Context& ctx, GLboolean flag) {
    set_attribute(ctx, pipeline::kEdgeFlag, flag ? 1.0f : 0.0f, 0, 0, 1);
}
inline void indexf(Context& ctx, GLfloat c) {
    ctx.vertex.current.index = c;
}

}  // namespace terrazzo::gl
