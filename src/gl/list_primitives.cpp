// Plays batches of primitives: straight to the pipeline, or call by call where the batch is not on its own.
#include "gl/list_primitives.h"

#include "gl/call.h"
#include "gl/draw.h"
#include "gl/vertex_inline.h"

namespace terrazzo::gl {
namespace {

void call_attribute(Context& ctx, int attribute, const std::array<GLfloat, 4>& v) {
    const Dispatch& gl = *ctx.dispatch.execute;
    switch (attribute) {
        case pipeline::kNormal:
            return gl.Normal3f(&ctx, v[0], v[1], v[2]);
        case pipeline::kColor:
            return gl.Color4f(&ctx, v[0], v[1], v[2], v[3]);
        case pipeline::kEdgeFlag:
            return gl.EdgeFlag(&ctx, v[0] != 0);
        case pipeline::kTexture0:
            return gl.TexCoord4f(&ctx, v[0], v[1], v[2], v[3]);
        case pipeline::kSecondaryColor:
            return gl.SecondaryColor3f(&ctx, v[0], v[1], v[2]);
        case pipeline::kFogCoordinate:
            return gl.FogCoordf(&ctx, v[0]);
        case pipeline::kPosition:
            return gl.Vertex4f(&ctx, v[0], v[1], v[2], v[3]);
    }
    const auto unit = static_cast<GLenum>(attribute - pipeline::kTexture0);
    gl.MultiTexCoord4f(&ctx, GL_TEXTURE0 + unit, v[0], v[1], v[2], v[3]);
}

std::array<GLfloat, 4> value_of(const PrimitivesRecord& record, const PrimitivesRecord::Stream& stream,
                                std::uint32_t vertex) {
    const auto* bytes =
        reinterpret_cast<const std::byte*>(record.vertices()) + std::size_t{vertex} * record.stride;
    std::array<GLfloat, 4> value{0, 0, 0, 1};
    std::memcpy(value.data(), bytes + stream.offset, stream.components * sizeof(GLfloat));
    return value;
}

// The list was called between Begin and End: what its commands mean there they say themselves, one by one.
void play_calls(Context& ctx, const PrimitivesRecord& record) {
    for (std::uint32_t i = 0; i < record.before_count; ++i) {
        call_attribute(ctx, static_cast<int>(record.before()[i].attribute), record.before()[i].value);
    }
    for (std::uint32_t r = 0; r < record.run_count; ++r) {
        const PrimitiveRun& run = record.runs()[r];
        ctx.dispatch.execute->Begin(&ctx, run.mode);
        for (std::uint32_t v = run.first; v < run.first + run.count; ++v) {
            // The position comes first in a vertex and last in the calls.
            for (std::uint32_t s = 1; s <= record.stream_count; ++s) {
                const auto& stream = record.streams[s % record.stream_count];
                call_attribute(ctx, stream.attribute, value_of(record, stream, v));
            }
        }
        ctx.dispatch.execute->End(&ctx);
    }
    for (std::uint32_t i = 0; i < record.after_count; ++i) {
        call_attribute(ctx, static_cast<int>(record.after()[i].attribute), record.after()[i].value);
    }
}

void set_attributes(Context& ctx, const AttributeValue* values, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto& v = values[i].value;
        set_attribute(ctx, static_cast<int>(values[i].attribute), v[0], v[1], v[2], v[3]);
    }
}

// Without drawing, where that is refused, the attributes are set all the same.
void play_batch(Context& ctx, const PrimitivesRecord& record, bool draw) {
    flush_vertices(ctx);
    set_attributes(ctx, record.before(), record.before_count);
    pipeline::VertexInput input;
    input.constants = ctx.vertex.current.values;
    const auto* bytes = reinterpret_cast<const std::byte*>(record.vertices());
    for (std::uint32_t s = 0; s < record.stream_count; ++s) {
        const auto& stream = record.streams[s];
        input.streamed |= pipeline::bit(stream.attribute);
        input.streams[stream.attribute] = {bytes + stream.offset, record.stride,
                                           pipeline::ComponentType::kFloat32, stream.components, false};
    }
    // Runs, and the attributes after them, were commands of their own: one that memory is missing for keeps
    // nothing else back.
    for (std::uint32_t r = 0; draw && r < record.run_count; ++r) {
        const PrimitiveRun& run = record.runs()[r];
        input.fourth_is_one = ~run.fourth;
        guarded(ctx, [&] { draw_primitives(ctx, run.mode, input, {run.first, run.count, nullptr}); });
    }
    set_attributes(ctx, record.after(), record.after_count);
}

}  // namespace

void play_primitives(Context& ctx, const PrimitivesRecord& record) {
    if (ctx.vertex.open) {
        play_calls(ctx, record);
    } else {
        guarded(ctx, [&] { play_batch(ctx, record, check_framebuffer(ctx)); });
    }
    if (record.index_set) indexf(ctx, record.index);
}

}  // namespace terrazzo::gl
