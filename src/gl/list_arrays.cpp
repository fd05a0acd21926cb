// Records and plays draws of vertex arrays; see list_arrays.h.
#include "gl/list_arrays.h"

#include <algorithm>
#include <new>
#include <utility>

#include "gl/call.h"
#include "gl/draw.h"
#include "gl/generated/compile.h"
#include "gl/list_recorder.h"

namespace terrazzo::gl {
namespace {

constexpr const char* kMapped = "a buffer of the arrays is mapped";

bool is_index_type(GLenum type) {
    return type == GL_UNSIGNED_BYTE || type == GL_UNSIGNED_SHORT || type == GL_UNSIGNED_INT;
}

void record_draw_error(Context& ctx, GLenum code, const char* rule) {
    record_list_error(ctx, Allowed::kOutsideBeginEnd, code, rule);
}

// A draw without vertices, which is an error where draws are not allowed.
void record_empty_draw(Context& ctx) {
    record_draw_error(ctx, GL_NO_ERROR, "");
}

// The error that a draw of arrays makes whenever the list is called; GL_NO_ERROR and "" for none.
std::pair<GLenum, const char*> error_of_draw(const Context& ctx, GLenum mode, GLsizei count) {
    if (ctx.lists.vertices.open()) return {GL_INVALID_OPERATION, "not allowed between glBegin and glEnd"};
    if (mode > GL_POLYGON) return {GL_INVALID_ENUM, "no such primitive"};
    if (count < 0) return {GL_INVALID_VALUE, "count is negative"};
    return {GL_NO_ERROR, ""};
}

// Drawing without indices is faster, so elements are repeated for each vertex; not where one byte of indices
// would become hundreds. Returns the elements to record, none where all are, and leaves what names them in
// `indices`.
std::vector<std::uint32_t> share_elements(std::vector<std::uint32_t>& indices) {
    constexpr std::size_t kFew = std::size_t{1} << 20, kWorthRepeating = 8;
    if (indices.size() <= kFew) return std::exchange(indices, {});
    std::vector<std::uint32_t> elements = indices;
    std::ranges::sort(elements);
    elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
    if (indices.size() <= kWorthRepeating * elements.size()) return std::exchange(indices, {});
    for (std::uint32_t& index : indices)
        index = static_cast<std::uint32_t>(std::ranges::lower_bound(elements, index) - elements.begin());
    return elements;
}

// The layout of elements, the position last.
void add_streams(ArraysRecord& record, const EnabledArrays& arrays) {
    for (const ReadableArray& array : arrays) {
        const auto components = static_cast<std::uint8_t>(array.array->size);
        record.streams[record.stream_count++] = {static_cast<std::uint8_t>(array.attribute), components,
                                                 static_cast<std::uint16_t>(record.stride)};
        record.stride += components * static_cast<std::uint32_t>(sizeof(float));
    }
}

// The elements as streams; other attributes have no value yet.
pipeline::VertexInput input_of(const ArraysRecord& record) {
    pipeline::VertexInput input;
    const auto* const bytes = reinterpret_cast<const std::byte*>(record.elements());
    for (std::uint32_t s = 0; s < record.stream_count; ++s) {
        const ArraysRecord::Stream& stream = record.streams[s];
        input.streamed |= pipeline::bit(stream.attribute);
        input.streams[stream.attribute] = {bytes + stream.offset, record.stride,
                                           pipeline::ComponentType::kFloat32, stream.components, false};
    }
    input.fourth_is_one = record.fourth_is_one;
    return input;
}

// Records a draw of the range's vertices; `indices` is empty for consecutive elements.
void append_arrays(DisplayList& list, GLenum mode, pipeline::VertexRange range, const EnabledArrays& arrays,
                   std::vector<std::uint32_t> indices) {
    if (!indices.empty()) range.indices = indices.data();
    if (range.count > kMostVerticesBeyond && !is_inside(range, arrays)) throw std::bad_alloc();
    const std::vector<std::uint32_t> named = share_elements(indices);
    const std::uint32_t count = named.empty() ? range.count : static_cast<std::uint32_t>(named.size());
    ArraysRecord layout{};
    layout.mode = mode;
    layout.vertex_count = range.count;
    layout.index_count = static_cast<std::uint32_t>(indices.size());
    add_streams(layout, arrays);
    auto& made = list.append<ArraysRecord>(indices.size() * sizeof(std::uint32_t) +
                                           std::size_t{count} * layout.stride);
    layout.header = made.header;
    made = layout;
    auto* const to = reinterpret_cast<std::uint32_t*>(&made + 1);
    auto* out = reinterpret_cast<float*>(std::ranges::copy(indices, to).out);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t element = named.empty() ? range.first + i : named[i];
        for (const ReadableArray& array : arrays)
            out = std::copy_n(array.element(element).begin(), array.array->size, out);
    }
    made.fourth_is_one = find_fourth_ones(input_of(made), {0, count});
}

// Throws nothing, as all that records; so the indices are fetched inside.
template <typename FetchIndices>
void record_range(Context& ctx, GLenum mode, const pipeline::VertexRange& range, FetchIndices fetch_indices) {
    const EnabledArrays arrays(ctx);
    if (arrays.any_mapped()) return record_draw_error(ctx, GL_INVALID_OPERATION, kMapped);
    if (range.count == 0 || !arrays.has_position()) return record_empty_draw(ctx);
    record(ctx, [&](DisplayList& list) { append_arrays(list, mode, range, arrays, fetch_indices()); });
}

void record_draw_arrays(Context& ctx, GLenum mode, GLint first, GLsizei count) {
    if (first < 0) return record_draw_error(ctx, GL_INVALID_VALUE, "first is negative");
    const auto [error, rule] = error_of_draw(ctx, mode, count);
    if (error != GL_NO_ERROR) return record_draw_error(ctx, error, rule);
    record_range(ctx, mode, {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count)},
                 [] { return std::vector<std::uint32_t>(); });
}

void record_draw_elements(Context& ctx, GLenum mode, GLsizei count, GLenum type, const void* indices) {
    if (!is_index_type(type)) return record_draw_error(ctx, GL_INVALID_ENUM, "no type of indices");
    const auto [error, rule] = error_of_draw(ctx, mode, count);
    if (error != GL_NO_ERROR) return record_draw_error(ctx, error, rule);
    const ReadableIndices found = find_indices(ctx, count, type, indices);
    if (found.bytes.mapped) return record_draw_error(ctx, GL_INVALID_OPERATION, kMapped);
    record_range(ctx, mode, {0, static_cast<std::uint32_t>(found.count)},
                 [&] { return found.widened(type); });
}

void draw(Context& ctx, const ArraysRecord& record) {
    if (!check_framebuffer(ctx)) return;
    flush_vertices(ctx);
    pipeline::VertexInput input = input_of(record);
    input.constants = ctx.vertex.current.values;
    draw_primitives(ctx, record.mode, input,
                    {0, record.vertex_count, record.index_count ? record.indices() : nullptr});
}

// Calls draw(i) for each draw of a MultiDraw command, unless `rule` says why none is made.
template <typename Draw>
void record_draws(Context& ctx, const Rule& rule, GLsizei count, Draw draw) {
    if (rule.code != GL_NO_ERROR) return record_draw_error(ctx, rule.code, rule.words);
    record_empty_draw(ctx);  // all of them may be
    for (GLsizei i = 0; i < count; ++i) draw(i);
}

}  // namespace

// The current values stay what they were, as in the reference; GL leaves them indeterminate.
void play_arrays(Context& ctx, const ArraysRecord& record) {
    if (ctx.vertex.open) {
        return record_error(ctx, GL_INVALID_OPERATION,
                            "vertex arrays are not drawn between glBegin and glEnd");
    }
    guarded(ctx, [&] { draw(ctx, record); });
}

void Compile::ArrayElement(Context& ctx, GLint i) {
    if (i < 0) return error(ctx, Allowed::kAnywhere, GL_INVALID_VALUE, "the element is negative");
    const EnabledArrays arrays(ctx);
    if (arrays.any_mapped()) return error(ctx, Allowed::kAnywhere, GL_INVALID_OPERATION, kMapped);
    for (const ReadableArray& array : arrays) {
        const std::array<GLfloat, 4> v = array.element(static_cast<GLuint>(i));
        switch (array.attribute) {
            case pipeline::kNormal:
                Normal3f(ctx, v[0], v[1], v[2]);
                break;
            case pipeline::kColor:
                Color4f(ctx, v[0], v[1], v[2], v[3]);
                break;
            case pipeline::kEdgeFlag:
                EdgeFlag(ctx, v[0] != 0);
                break;
            case pipeline::kTexture0:
                TexCoord4f(ctx, v[0], v[1], v[2], v[3]);
                break;
            case pipeline::kSecondaryColor:
                SecondaryColor3f(ctx, v[0], v[1], v[2]);
                break;
            case pipeline::kFogCoordinate:
                FogCoordf(ctx, v[0]);
                break;
            case pipeline::kPosition:
                Vertex4f(ctx, v[0], v[1], v[2], v[3]);
                break;
            default:
                MultiTexCoord4f(ctx, static_cast<GLenum>(GL_TEXTURE0 + array.attribute - pipeline::kTexture0),
                                v[0], v[1], v[2], v[3]);
        }
    }
    if (arrays.index()) Indexf(ctx, arrays.index()->element(i)[0]);
}

void Compile::DrawArrays(Context& ctx, GLenum mode, GLint first, GLsizei count) {
    record_draw_arrays(ctx, mode, first, count);
    if (ctx.lists.execute_too) ctx.dispatch.execute->DrawArrays(&ctx, mode, first, count);
}

void Compile::DrawElements(Context& ctx, GLenum mode, GLsizei count, GLenum type, const void* indices) {
    record_draw_elements(ctx, mode, count, type, indices);
    if (ctx.lists.execute_too) ctx.dispatch.execute->DrawElements(&ctx, mode, count, type, indices);
}

void Compile::DrawRangeElements(Context& ctx, GLenum mode, GLuint start, GLuint end, GLsizei count,
                                GLenum type, const void* indices) {
    if (end < start) {
        record_draw_error(ctx, GL_INVALID_VALUE, "end is before start");
    } else {
        record_draw_elements(ctx, mode, count, type, indices);
    }
    if (ctx.lists.execute_too)
        ctx.dispatch.execute->DrawRangeElements(&ctx, mode, start, end, count, type, indices);
}

void Compile::MultiDrawArrays(Context& ctx, GLenum mode, const GLint* first, const GLsizei* count,
                              GLsizei drawcount) {
    record_draws(ctx, check_multi_draw(mode, count, drawcount), drawcount, [&](GLsizei i) {
        if (count[i] > 0) record_draw_arrays(ctx, mode, first[i], count[i]);
    });
    if (ctx.lists.execute_too) ctx.dispatch.execute->MultiDrawArrays(&ctx, mode, first, count, drawcount);
}

void Compile::MultiDrawElements(Context& ctx, GLenum mode, const GLsizei* count, GLenum type,
                                const void* const* indices, GLsizei drawcount) {
    record_draws(ctx, check_multi_draw(mode, count, drawcount, type), drawcount, [&](GLsizei i) {
        if (count[i] > 0) record_draw_elements(ctx, mode, count[i], type, indices[i]);
    });
    if (ctx.lists.execute_too)
        ctx.dispatch.execute->MultiDrawElements(&ctx, mode, count, type, indices, drawcount);
}

}  // namespace terrazzo::gl
