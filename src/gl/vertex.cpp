// Begin, End, Rect and the batch of immediate vertices; see vertex.h.
#include "gl/vertex.h"

#include <algorithm>
#include <exception>

#include "gl/call.h"
#include "gl/draw.h"
#include "gl/generated/commands.h"
#include "gl/vertex_inline.h"
#include "simd/traps.h"

namespace terrazzo::gl {
namespace {

// A batch this long goes to the pipeline at the next End. Longer batches leave the processor's second-level
// cache before they are drawn: 300 000 vertices with colour and normal took 28 ns each in batches of 49152,
// 14 ns in these.
constexpr std::uint32_t kLongBatch = 4096;
// The reference draws separate primitives in pieces of so many vertices from the start of their run, and cuts
// all quads of a piece alike (doc/reference.md §3.1).
constexpr std::uint32_t kPiece = 4096;
// So long a run is drawn before it ends: of separate primitives, in whole pieces, and of connected ones,
// where it costs more.
constexpr std::uint32_t kLongestRun = 2 * kPiece;
constexpr std::uint32_t kLongestConnectedBatch = 49152;
// A batch that could not be drawn so often is given up, or a context whose batch is too large for the memory
// there is would be stuck with it.
constexpr int kMostFailures = 16;
// Above this, a constant attribute that changes outside Begin and End starts a new batch instead of a stream.
constexpr std::uint32_t kWorthKeeping = 256;

// Vertices of one primitive in modes whose primitives share none, so that runs of them may be joined; else 0.
std::uint32_t vertices_of_independent(GLenum mode) {
    switch (mode) {
        case GL_POINTS:
            return 1;
        case GL_LINES:
            return 2;
        case GL_TRIANGLES:
            return 3;
        case GL_QUADS:
            return 4;
    }
    return 0;
}

// The run that one of `mode` beginning at vertex `first` becomes part of; null when it stands alone.
// Positions whose w is one are drawn another way, which may round another way: how a primitive is drawn must
// not depend on what else was collected, or a display list would differ from its commands.
PrimitiveRun* run_to_join(std::vector<PrimitiveRun>& runs, GLenum mode, std::uint32_t first,
                          pipeline::AttributeMask fourth) {
    const std::uint32_t vertices = vertices_of_independent(mode);
    if (vertices == 0 || runs.empty()) return nullptr;
    PrimitiveRun& last = runs.back();
    const bool joins = last.mode == mode && last.first + last.count == first && last.count % vertices == 0 &&
                       last.fourth == fourth;
    return joins ? &last : nullptr;
}

// How many vertices the batch may hold until the open run is broken.
std::uint32_t longest_batch(VertexState& vertex) {
    if (!vertex.open || vertices_of_independent(vertex.mode) == 0) return kLongestConnectedBatch;
    const PrimitiveRun* joined =
        run_to_join(vertex.batch.runs, vertex.mode, vertex.open_first, vertex.batch.fourth);
    return (joined ? joined->first : vertex.open_first) + kLongestRun;
}

void set_layout(VertexState& vertex) {
    VertexBatch& batch = vertex.batch;
    float* const data = batch.data.data();
    const std::size_t longest = static_cast<std::size_t>(longest_batch(vertex)) * batch.stride;
    batch.next = data + static_cast<std::size_t>(batch.count) * batch.stride;
    batch.end = data + std::min(batch.data.size(), longest);
    if (vertex.is_lost) batch.end = batch.next;  // nothing more is collected
}

void clear_batch(VertexState& vertex) {
    VertexBatch& batch = vertex.batch;
    batch.count = 0;
    batch.stride = 4;
    batch.mask = 0;
    batch.stream_count = 0;
    batch.runs.clear();
    batch.failures = 0;
    set_layout(vertex);
}

// Takes the batch back to its first `count` vertices.
void truncate_batch(VertexState& vertex, std::uint32_t count) {
    VertexBatch& batch = vertex.batch;
    while (!batch.runs.empty() && batch.runs.back().first >= count) batch.runs.pop_back();
    if (!batch.runs.empty()) {
        PrimitiveRun& last = batch.runs.back();
        last.count = std::min(last.count, count - last.first);
    }
    batch.count = count;
    set_layout(vertex);
}

// Draws all runs and forgets them. Where memory is short those that have not been drawn stay.
void draw_runs(Context& ctx) {
    VertexBatch& batch = ctx.vertex.batch;
    pipeline::VertexInput input;
    input.constants = ctx.vertex.current.values;
    input.streamed = batch.mask | pipeline::bit(pipeline::kPosition);
    const auto* const bytes = reinterpret_cast<const std::byte*>(batch.data.data());
    const auto stride = static_cast<std::uint32_t>(batch.stride * sizeof(float));
    input.streams[pipeline::kPosition] = {bytes, stride, pipeline::ComponentType::kFloat32, 4, false};
    for (std::uint32_t i = 0; i < batch.stream_count; ++i)
        input.streams[batch.streams[i]] = {bytes + 4 * sizeof(float) * (i + 1), stride,
                                           pipeline::ComponentType::kFloat32, 4, false};
    struct Flight {
        VertexBatch& batch;
        std::ptrdiff_t drawn = 0;
        explicit Flight(VertexBatch& all) : batch(all) { batch.in_flight = true; }
        ~Flight() {
            batch.runs.erase(batch.runs.begin(), batch.runs.begin() + drawn);
            batch.in_flight = false;
        }
    } flight(batch);
    for (const PrimitiveRun& run : batch.runs) {
        input.fourth_is_one = ~run.fourth;
        draw_primitives(ctx, run.mode, input,
                        {run.first, run.count, nullptr, true, run.continues, run.is_continued});
        ++flight.drawn;
    }
}

// How many of a run's vertices can be drawn now, and which of them the rest of the run needs again.
struct Break {
    std::uint32_t drawn;
    std::uint32_t keep_first;  // 1 where the run's first vertex is needed again
    std::uint32_t keep_last;   // the last this many vertices are
};
Break break_run(GLenum mode, std::uint32_t count) {
    switch (mode) {
        case GL_LINE_STRIP:
        case GL_LINE_LOOP:
            return {count, 0, 1};
        case GL_TRIANGLE_STRIP:
        case GL_QUAD_STRIP:
            return {count & ~1u, 0, 2 + (count & 1)};  // an even number keeps the orientation
        case GL_TRIANGLE_FAN:
        case GL_POLYGON:
            return {count, 1, 1};
    }
    const std::uint32_t rest = count % vertices_of_independent(mode);
    return {count - rest, 0, rest};
}

// Draws all but what the last run, one of quads, has beyond its whole pieces: that begins the next batch.
void draw_whole_pieces(Context& ctx) {
    VertexBatch& batch = ctx.vertex.batch;
    const std::uint32_t rest = batch.runs.back().count % kPiece;
    const pipeline::AttributeMask fourth = batch.runs.back().fourth;
    batch.runs.back().count -= rest;
    try {
        draw_runs(ctx);
    } catch (...) {
        batch.runs.back().count += rest;
        throw;
    }
    const std::size_t floats = static_cast<std::size_t>(rest) * batch.stride;
    std::copy_n(batch.next - floats, floats, batch.data.data());
    batch.count = rest;
    batch.failures = 0;
    add_run(batch.runs, {.mode = GL_QUADS, .first = 0, .count = rest, .fourth = fourth});  // there is room
    set_layout(ctx.vertex);
}

// Draws what the open run has so far and goes on with the vertices that are needed again.
void break_open_run(Context& ctx) {
    VertexState& vertex = ctx.vertex;
    VertexBatch& batch = vertex.batch;
    const std::uint32_t count = batch.count - vertex.open_first;
    const Break parts = break_run(vertex.mode, count);
    const float* const run = batch.data.data() + static_cast<std::size_t>(vertex.open_first) * batch.stride;
    std::vector<float> kept;
    const auto keep = [&](std::uint32_t first, std::uint32_t vertices) {
        kept.insert(kept.end(), run + first * batch.stride, run + (first + vertices) * batch.stride);
    };
    keep(0, parts.keep_first);
    keep(count - parts.keep_last, parts.keep_last);
    if (vertex.mode == GL_LINE_LOOP) {
        vertex.loop_start.assign(run, run + batch.stride);
        vertex.mode = GL_LINE_STRIP;
    }
    add_run(batch.runs,
            {vertex.mode, vertex.open_first, parts.drawn, vertex.open_continues, true, batch.fourth});
    vertex.open_continues = true;
    draw_runs(ctx);
    std::copy(kept.begin(), kept.end(), batch.data.begin());
    batch.count = static_cast<std::uint32_t>(kept.size() / batch.stride);
    vertex.open_first = 0;
    set_layout(vertex);
}

// Makes room for one more vertex.
void grow_batch(Context& ctx) {
    VertexBatch& batch = ctx.vertex.batch;
    if (batch.count >= longest_batch(ctx.vertex)) break_open_run(ctx);
    if (batch.end - batch.next >= static_cast<std::ptrdiff_t>(batch.stride)) return;
    batch.data.resize(std::max<std::size_t>(batch.data.size() * 2, 4096));
    set_layout(ctx.vertex);
}

// Makes a run of what has come since Begin.
void close_run(Context& ctx) {
    VertexState& vertex = ctx.vertex;
    VertexBatch& batch = vertex.batch;
    if (!vertex.loop_start.empty()) {
        // Streams that were added since the loop was broken begin with the value that all vertices before
        // had.
        const auto known = static_cast<std::ptrdiff_t>(vertex.loop_start.size());
        const auto first_vertex = batch.data.begin();
        vertex.loop_start.insert(vertex.loop_start.end(), first_vertex + known, first_vertex + batch.stride);
        if (batch.end - batch.next < static_cast<std::ptrdiff_t>(batch.stride)) grow_batch(ctx);
        std::copy(vertex.loop_start.begin(), vertex.loop_start.end(), batch.next);
        batch.next += batch.stride;
        ++batch.count;
    }
    add_run(batch.runs, {vertex.mode, vertex.open_first, batch.count - vertex.open_first,
                         vertex.open_continues, false, batch.fourth});
}

// Those that vertices take which give none of their own.
pipeline::AttributeMask fourth_of_current(const VertexState& vertex) {
    pipeline::AttributeMask fourth = 0;
    if (vertex.batch.fourth == 0) return fourth;  // as it is with most programs
    for (int a = pipeline::kTexture0; a < pipeline::kTexture0 + kMaxTextureUnits; ++a)
        if (vertex.current.values[static_cast<std::size_t>(a)][3] != 1) fourth |= pipeline::bit(a);
    return fourth;
}

void leave_primitives(VertexState& vertex) {
    vertex.open = vertex.is_lost = false;
    set_layout(vertex);
}

}  // namespace

void add_run(std::vector<PrimitiveRun>& runs, const PrimitiveRun& run) {
    if (run.count == 0) return;
    if (PrimitiveRun* last = run_to_join(runs, run.mode, run.first, run.fourth)) {
        last->count += run.count;
    } else {
        runs.push_back(run);
    }
}

void flush_vertices(Context& ctx) {
    VertexState& vertex = ctx.vertex;
    if (vertex.batch.count == 0 || vertex.open || vertex.batch.in_flight) return;
    const WithoutTraps without_traps;
    try {
        draw_runs(ctx);
    } catch (...) {
        if (++vertex.batch.failures == kMostFailures) {
            clear_batch(vertex);
            record_error(ctx, GL_OUT_OF_MEMORY, "not enough memory for the primitives since the last change");
        }
        throw;
    }
    clear_batch(vertex);
}

void stream_attribute(Context& ctx, int attribute) {
    VertexBatch& batch = ctx.vertex.batch;
    if (!ctx.vertex.open && batch.count > kWorthKeeping) return flush_vertices(ctx);
    const std::uint32_t old_stride = batch.stride, stride = old_stride + 4;
    const std::size_t needed = static_cast<std::size_t>(batch.count + 1) * stride;
    if (batch.data.size() < needed) batch.data.resize(std::max(needed, batch.data.size() * 2));
    const auto& constant = ctx.vertex.current.values[static_cast<std::size_t>(attribute)];
    for (std::uint32_t i = batch.count; i-- > 0;) {
        float* const to = batch.data.data() + static_cast<std::size_t>(i) * stride;
        std::memmove(to, batch.data.data() + static_cast<std::size_t>(i) * old_stride,
                     old_stride * sizeof(float));
        std::copy(constant.begin(), constant.end(), to + old_stride);
    }
    batch.stride = stride;
    batch.streams[batch.stream_count++] = static_cast<std::uint8_t>(attribute);
    batch.mask |= pipeline::bit(attribute);
    set_layout(ctx.vertex);
}

void lose_open_primitives(Context& ctx) noexcept {
    if (!ctx.vertex.open || ctx.vertex.is_lost) return;
    ctx.vertex.is_lost = true;
    truncate_batch(ctx.vertex, ctx.vertex.open_first);
}

void set_attribute_slowly(Context& ctx, int attribute, GLfloat x, GLfloat y, GLfloat z, GLfloat w) noexcept {
    guarded(ctx, [&] {
        try {
            stream_attribute(ctx, attribute);
        } catch (...) {
            lose_open_primitives(ctx);
            throw;
        }
        ctx.vertex.current.values[static_cast<std::size_t>(attribute)] = {x, y, z, w};
    });
}

void vertex4f_slowly(Context& ctx, GLfloat x, GLfloat y, GLfloat z, GLfloat w) noexcept {
    if (ctx.vertex.is_lost) return;
    guarded(ctx, [&] {
        try {
            grow_batch(ctx);
        } catch (...) {
            lose_open_primitives(ctx);
            throw;
        }
        vertex4f(ctx, x, y, z, w);
    });
}

bool open_primitive(Context& ctx, GLenum mode) {
    if (mode > GL_POLYGON) return record_error(ctx, GL_INVALID_ENUM, "no such primitive"), false;
    if (!check_framebuffer(ctx)) return false;
    ctx.vertex.mode = mode;
    ctx.vertex.open_first = ctx.vertex.batch.count;
    ctx.vertex.open = true;
    ctx.vertex.is_lost = false;
    ctx.vertex.open_continues = false;
    ctx.vertex.batch.fourth = fourth_of_current(ctx.vertex);
    ctx.vertex.loop_start.clear();
    set_layout(ctx.vertex);
    set_inside_begin_end(ctx, true);
    return true;
}

void begin(Context& ctx, GLenum mode) {
    open_primitive(ctx, mode);
}

void end(Context& ctx) {
    VertexState& vertex = ctx.vertex;
    set_inside_begin_end(ctx, false);
    try {
        if (!vertex.is_lost) close_run(ctx);
    } catch (...) {
        lose_open_primitives(ctx);
        leave_primitives(vertex);
        throw;
    }
    leave_primitives(vertex);
    if (vertex.batch.count < kLongBatch) return;
    const std::vector<PrimitiveRun>& runs = vertex.batch.runs;
    try {
        !runs.empty() && runs.back().mode == GL_QUADS ? draw_whole_pieces(ctx) : flush_vertices(ctx);
    } catch (const std::exception&) {
        // What End has to do is done: the batch waits.
    }
}

void rectf(Context& ctx, GLfloat x1, GLfloat y1, GLfloat x2, GLfloat y2) {
    if (!open_primitive(ctx, GL_QUADS)) return;
    vertex4f(ctx, x1, y1, 0, 1);
    vertex4f(ctx, x2, y1, 0, 1);
    vertex4f(ctx, x2, y2, 0, 1);
    vertex4f(ctx, x1, y2, 0, 1);
    end(ctx);
}

}  // namespace terrazzo::gl
