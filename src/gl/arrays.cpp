// Commands of vertex arrays (GL 1.5 §2.8, §2.9).
#include "gl/arrays.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>
#include <type_traits>
#include <vector>

#include "gl/context.h"
#include "gl/convert.h"
#include "gl/draw.h"
#include "gl/generated/commands.h"
#include "gl/translate.h"
#include "gl/vertex_inline.h"

namespace terrazzo::gl {
namespace {

GLsizei size_of_type(GLenum type) {
    switch (type) {
        case GL_BYTE:
        case GL_UNSIGNED_BYTE:
            return 1;
        case GL_SHORT:
        case GL_UNSIGNED_SHORT:
            return 2;
        case GL_DOUBLE:
            return 8;
    }
    return 4;
}

std::size_t packed_size(const ClientArray& array) {
    return static_cast<std::size_t>(array.size * size_of_type(array.type));
}

bool is_one_of(GLenum type, std::initializer_list<GLenum> allowed) {
    return std::find(allowed.begin(), allowed.end(), type) != allowed.end();
}

// Checks and stores what a glXxxPointer command was given; false where that was wrong.
bool set_pointer(Context& ctx, ClientArray& array, GLint size, GLint low, GLint high, GLenum type,
                 std::initializer_list<GLenum> types, GLsizei stride, const GLvoid* pointer) {
    if (stride < 0) return record_error(ctx, GL_INVALID_VALUE, "stride is negative"), false;
    if (!is_one_of(type, types)) return record_error(ctx, GL_INVALID_ENUM, "no type for this array"), false;
    if (size < low || size > high)
        return record_error(ctx, GL_INVALID_VALUE, "no array has elements of this size"), false;
    array = {array.enabled, size, type, stride, pointer, ctx.arrays.array_buffer};
    return true;
}

// The same for colours of three to `high` components, or of GL_BGRA (ARB_vertex_array_bgra).
void set_color_pointer(Context& ctx, ClientArray& array, GLint size, GLint high, GLenum type, GLsizei stride,
                       const GLvoid* pointer) {
    const std::initializer_list<GLenum> types = {GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT,
                                                 GL_INT,  GL_UNSIGNED_INT,  GL_FLOAT, GL_DOUBLE};
    const bool bgra = size == GL_BGRA;
    if (bgra && type != GL_UNSIGNED_BYTE && is_one_of(type, types))
        return record_error(ctx, GL_INVALID_OPERATION, "only unsigned bytes are GL_BGRA");
    const bool valid =
        set_pointer(ctx, array, bgra ? 4 : size, 3, bgra ? 4 : high, type, types, stride, pointer);
    if (valid) array.bgra = bgra;
}

void set_enabled(Context& ctx, GLenum name, bool enabled) {
    ClientArray* const array = find_client_array(ctx.arrays, name);
    if (!array) return record_error(ctx, GL_INVALID_ENUM, "no such array");
    array->enabled = enabled;
}

// The enabled arrays as streams; other attributes stay what they were.
pipeline::VertexInput input_of(const Context& ctx, const EnabledArrays& arrays) {
    pipeline::VertexInput input;
    input.constants = ctx.vertex.current.values;
    for (const ReadableArray& a : arrays) {
        input.streamed |= pipeline::bit(a.attribute);
        input.streams[static_cast<std::size_t>(a.attribute)] = {a.bytes.data,
                                                                static_cast<std::uint32_t>(a.stride),
                                                                translate_type(a.array->type),
                                                                static_cast<std::uint8_t>(a.array->size),
                                                                a.normalized,
                                                                a.array->bgra};
    }
    return input;
}

std::uint32_t element_of(const pipeline::VertexRange& range, std::uint32_t i) {
    return range.indices ? range.indices[i] : range.first + i;
}

template <typename Number>
bool is_fourth_one_of(const pipeline::AttributeStream& stream, const pipeline::VertexRange& range) {
    const std::byte* const fourth = stream.data + 3 * sizeof(Number);
    for (std::uint32_t i = 0; i < range.count; ++i) {
        Number value;
        std::memcpy(&value, fourth + std::size_t{element_of(range, i)} * stream.stride, sizeof value);
        if (static_cast<float>(value) != 1.0f) return false;
    }
    return true;
}

bool is_fourth_one(const pipeline::AttributeStream& stream, const pipeline::VertexRange& range) {
    switch (stream.type) {
        case pipeline::ComponentType::kInt16:
            return is_fourth_one_of<std::int16_t>(stream, range);
        case pipeline::ComponentType::kInt32:
            return is_fourth_one_of<std::int32_t>(stream, range);
        case pipeline::ComponentType::kFloat32:
            return is_fourth_one_of<float>(stream, range);
        case pipeline::ComponentType::kFloat64:
            return is_fourth_one_of<double>(stream, range);
        default:
            return false;  // no type of positions or texture coordinates
    }
}

// A draw that reaches beyond the end of a buffer: the vertices are copied one by one, zeros where there is
// nothing to copy.
void draw_copied(Context& ctx, GLenum mode, const pipeline::VertexRange& range, const EnabledArrays& arrays) {
    if (range.count > kMostVerticesBeyond) throw std::bad_alloc();
    pipeline::VertexInput input = input_of(ctx, arrays);
    std::vector<std::vector<std::byte>> copies;
    for (const ReadableArray& a : arrays) {
        pipeline::AttributeStream& stream = input.streams[static_cast<std::size_t>(a.attribute)];
        const std::size_t size = packed_size(*a.array);
        std::vector<std::byte>& copy = copies.emplace_back(range.count * size);
        for (std::uint32_t i = 0; i < range.count; ++i) {
            const std::size_t element = element_of(range, i);
            if (element < a.count) std::memcpy(&copy[i * size], stream.data + element * a.stride, size);
        }
        stream.data = copy.data();
        stream.stride = static_cast<std::uint32_t>(size);
    }
    const pipeline::VertexRange copied{0, range.count, nullptr, range.in_order};
    input.fourth_is_one = find_fourth_ones(input, copied);
    draw_primitives(ctx, mode, input, copied);
}

void draw_range(Context& ctx, GLenum mode, const pipeline::VertexRange& range) {
    if (!check_framebuffer(ctx)) return;
    flush_vertices(ctx);
    const EnabledArrays arrays(ctx);
    if (arrays.any_mapped()) return record_error(ctx, GL_INVALID_OPERATION, "an array's buffer is mapped");
    if (!arrays.has_position()) return;
    if (!is_inside(range, arrays)) return draw_copied(ctx, mode, range, arrays);
    pipeline::VertexInput input = input_of(ctx, arrays);
    input.fourth_is_one = find_fourth_ones(input, range);
    draw_primitives(ctx, mode, input, range);
}

bool check_mode_and_count(Context& ctx, GLenum mode, GLsizei count) {
    if (mode > GL_POLYGON) return record_error(ctx, GL_INVALID_ENUM, "no such primitive"), false;
    if (count < 0) return record_error(ctx, GL_INVALID_VALUE, "count is negative"), false;
    return true;
}

bool is_index_type(GLenum type) {
    return is_one_of(type, {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT});
}

bool check_index_type(Context& ctx, GLenum type) {
    if (is_index_type(type)) return true;
    record_error(ctx, GL_INVALID_ENUM, "no type of indices");
    return false;
}

template <typename Index>
std::vector<std::uint32_t> widen(const std::byte* indices, GLsizei count) {
    std::vector<Index> copy(static_cast<std::size_t>(count));
    std::memcpy(copy.data(), indices, copy.size() * sizeof(Index));
    return {copy.begin(), copy.end()};
}

void draw_indexed(Context& ctx, GLenum mode, GLsizei given_count, GLenum type, const GLvoid* indices) {
    const ReadableIndices found = find_indices(ctx, given_count, type, indices);
    const auto& [bytes, count] = found;
    if (bytes.mapped) return record_error(ctx, GL_INVALID_OPERATION, "the element buffer is mapped");
    if (count == 0) return;
    const bool aligned = reinterpret_cast<std::uintptr_t>(bytes.data) % alignof(std::uint32_t) == 0;
    // Indices are looked at before they are used: another context must not change them in between.
    const bool may_change = bytes.keep && ctx.shared.use_count() > 1;
    if (type == GL_UNSIGNED_INT && aligned && !may_change)
        return draw_range(
            ctx, mode,
            {0, static_cast<std::uint32_t>(count), reinterpret_cast<const std::uint32_t*>(bytes.data)});
    const std::vector<std::uint32_t> wide = found.widened(type);
    draw_range(ctx, mode, {0, static_cast<std::uint32_t>(count), wide.data()});
}

template <typename Component>
GLfloat component(const std::byte* from, int index, bool normalizes) {
    Component value;
    std::memcpy(&value, from + static_cast<std::size_t>(index) * sizeof value, sizeof value);
    if constexpr (std::is_integral_v<Component>) {
        if (normalizes) return normalised(value);
    }
    return static_cast<GLfloat>(value);
}

// As the command for one such component would take it.
GLfloat component(GLenum type, const std::byte* from, int index, bool normalizes) {
    switch (type) {
        case GL_BYTE:
            return component<GLbyte>(from, index, normalizes);
        case GL_UNSIGNED_BYTE:
            return component<GLubyte>(from, index, normalizes);
        case GL_SHORT:
            return component<GLshort>(from, index, normalizes);
        case GL_UNSIGNED_SHORT:
            return component<GLushort>(from, index, normalizes);
        case GL_INT:
            return component<GLint>(from, index, normalizes);
        case GL_UNSIGNED_INT:
            return component<GLuint>(from, index, normalizes);
        case GL_DOUBLE:
            return component<GLdouble>(from, index, normalizes);
    }
    return component<GLfloat>(from, index, normalizes);
}

struct InterleavedFormat {
    GLint texture_size, color_size;
    GLenum color_type;
    bool normal;
    GLint vertex_size;
    GLsizei color_offset, normal_offset, vertex_offset, stride;  // bytes
};

// GL 1.5 table 2.5, in the order of the enumerants from GL_V2F on.
constexpr InterleavedFormat kInterleaved[] = {
    {0, 0, 0, false, 2, 0, 0, 0, 8},                   // V2F
    {0, 0, 0, false, 3, 0, 0, 0, 12},                  // V3F
    {0, 4, GL_UNSIGNED_BYTE, false, 2, 0, 0, 4, 12},   // C4UB_V2F
    {0, 4, GL_UNSIGNED_BYTE, false, 3, 0, 0, 4, 16},   // C4UB_V3F
    {0, 3, GL_FLOAT, false, 3, 0, 0, 12, 24},          // C3F_V3F
    {0, 0, 0, true, 3, 0, 0, 12, 24},                  // N3F_V3F
    {0, 4, GL_FLOAT, true, 3, 0, 16, 28, 40},          // C4F_N3F_V3F
    {2, 0, 0, false, 3, 0, 0, 8, 20},                  // T2F_V3F
    {4, 0, 0, false, 4, 0, 0, 16, 32},                 // T4F_V4F
    {2, 4, GL_UNSIGNED_BYTE, false, 3, 8, 0, 12, 24},  // T2F_C4UB_V3F
    {2, 3, GL_FLOAT, false, 3, 8, 0, 20, 32},          // T2F_C3F_V3F
    {2, 0, 0, true, 3, 0, 8, 20, 32},                  // T2F_N3F_V3F
    {2, 4, GL_FLOAT, true, 3, 8, 24, 36, 48},          // T2F_C4F_N3F_V3F
    {4, 4, GL_FLOAT, true, 4, 16, 32, 44, 60},         // T4F_C4F_N3F_V4F
};

}  // namespace

ClientArray* find_client_array(ArrayState& arrays, GLenum name) {
    switch (name) {
        case GL_VERTEX_ARRAY:
            return &arrays.vertex;
        case GL_NORMAL_ARRAY:
            return &arrays.normal;
        case GL_COLOR_ARRAY:
            return &arrays.color;
        case GL_SECONDARY_COLOR_ARRAY:
            return &arrays.secondary_color;
        case GL_FOG_COORDINATE_ARRAY:
            return &arrays.fog_coordinate;
        case GL_INDEX_ARRAY:
            return &arrays.index;
        case GL_EDGE_FLAG_ARRAY:
            return &arrays.edge_flag;
        case GL_TEXTURE_COORD_ARRAY:
            return &arrays.texture[arrays.active_texture];
    }
    return nullptr;
}

Rule check_multi_draw(GLenum mode, const GLsizei* count, GLsizei drawcount, GLenum index_type) {
    if (mode > GL_POLYGON) return {GL_INVALID_ENUM, "no such primitive"};
    if (drawcount < 0) return {GL_INVALID_VALUE, "drawcount is negative"};
    if (!is_index_type(index_type)) return {GL_INVALID_ENUM, "no type of indices"};
    if (std::any_of(count, count + drawcount, [](GLsizei n) { return n < 0; }))
        return {GL_INVALID_VALUE, "a count is negative"};
    return {};
}

pipeline::AttributeMask find_fourth_ones(const pipeline::VertexInput& input,
                                         const pipeline::VertexRange& range) {
    pipeline::AttributeMask ones = 0;
    for (int attribute = 0; attribute < pipeline::kAttributeCount; ++attribute) {
        if (!(input.streamed & pipeline::kHomogeneous & pipeline::bit(attribute))) continue;
        const pipeline::AttributeStream& stream = input.streams[static_cast<std::size_t>(attribute)];
        if (stream.components < 4 || is_fourth_one(stream, range)) ones |= pipeline::bit(attribute);
    }
    return ones;
}

bool is_inside(const pipeline::VertexRange& range, const EnabledArrays& arrays) {
    if (arrays.shortest() > UINT32_MAX || range.count == 0) return true;
    if (!range.indices) return std::uint64_t{range.first} + range.count <= arrays.shortest();
    return *std::max_element(range.indices, range.indices + range.count) < arrays.shortest();
}

std::vector<std::uint32_t> ReadableIndices::widened(GLenum type) const {
    if (count == 0) return {};
    if (type == GL_UNSIGNED_BYTE) return widen<std::uint8_t>(bytes.data, count);
    if (type == GL_UNSIGNED_SHORT) return widen<std::uint16_t>(bytes.data, count);
    return widen<std::uint32_t>(bytes.data, count);
}

std::array<GLfloat, 4> ReadableArray::element(GLuint i) const {
    std::array<GLfloat, 4> out{0, 0, 0, 1};
    const std::size_t index = i;
    for (int c = 0; c < array->size; ++c) {
        out[static_cast<std::size_t>(c)] =
            index < count ? component(array->type, bytes.data + index * stride, c, normalized) : 0;
    }
    if (array->bgra) std::swap(out[0], out[2]);
    if (attribute == pipeline::kSecondaryColor) out[3] = 1;
    return out;
}

ReadableArray EnabledArrays::readable(const Context& ctx, int attribute, const ClientArray& array,
                                      bool normalized) {
    ReadableArray out{attribute, normalized, &array, find_bytes(ctx, array.buffer.get(), array.pointer),
                      0,         0};
    const std::size_t packed = packed_size(array);
    out.stride = array.stride ? static_cast<std::size_t>(array.stride) : packed;
    out.count = out.bytes.size;
    if (array.buffer) out.count = out.bytes.size < packed ? 0 : (out.bytes.size - packed) / out.stride + 1;
    m_any_mapped = m_any_mapped || out.bytes.mapped;
    return out;
}

EnabledArrays::EnabledArrays(const Context& ctx) {
    for_each_array(ctx.arrays, [&](int attribute, const ClientArray& array, bool normalized) {
        if (!array.enabled || !array.exists()) return;
        ReadableArray& added = m_arrays[static_cast<std::size_t>(m_count++)];
        added = readable(ctx, attribute, array, normalized);
        m_shortest = std::min(m_shortest, added.count);
    });
    const ClientArray& index = ctx.arrays.index;
    if (index.enabled && index.exists()) m_index = readable(ctx, 0, index, false);
}

ReadableIndices find_indices(const Context& ctx, GLsizei count, GLenum type, const void* indices) {
    ReadableIndices out{find_bytes(ctx, ctx.arrays.element_buffer.get(), indices), count};
    if (!out.bytes.data) out.count = 0;
    const std::size_t whole = out.bytes.size / static_cast<std::size_t>(size_of_type(type));
    if (static_cast<std::size_t>(out.count) > whole) out.count = static_cast<GLsizei>(whole);
    return out;
}

void vertex_pointer(Context& ctx, GLint size, GLenum type, GLsizei stride, const void* pointer) {
    set_pointer(ctx, ctx.arrays.vertex, size, 2, 4, type, {GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE}, stride,
                pointer);
}

void normal_pointer(Context& ctx, GLenum type, GLsizei stride, const void* pointer) {
    set_pointer(ctx, ctx.arrays.normal, 3, 3, 3, type, {GL_BYTE, GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE},
                stride, pointer);
}

void color_pointer(Context& ctx, GLint size, GLenum type, GLsizei stride, const void* pointer) {
    set_color_pointer(ctx, ctx.arrays.color, size, 4, type, stride, pointer);
}

void index_pointer(Context& ctx, GLenum type, GLsizei stride, const void* pointer) {
    set_pointer(ctx, ctx.arrays.index, 1, 1, 1, type,
                {GL_UNSIGNED_BYTE, GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE}, stride, pointer);
}

void tex_coord_pointer(Context& ctx, GLint size, GLenum type, GLsizei stride, const void* pointer) {
    set_pointer(ctx, ctx.arrays.texture[ctx.arrays.active_texture], size, 1, 4, type,
                {GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE}, stride, pointer);
}

void edge_flag_pointer(Context& ctx, GLsizei stride, const void* pointer) {
    set_pointer(ctx, ctx.arrays.edge_flag, 1, 1, 1, GL_UNSIGNED_BYTE, {GL_UNSIGNED_BYTE}, stride, pointer);
}

void secondary_color_pointer(Context& ctx, GLint size, GLenum type, GLsizei stride, const void* pointer) {
    set_color_pointer(ctx, ctx.arrays.secondary_color, size, 3, type, stride, pointer);
}

void fog_coord_pointer(Context& ctx, GLenum type, GLsizei stride, const void* pointer) {
    set_pointer(ctx, ctx.arrays.fog_coordinate, 1, 1, 1, type, {GL_FLOAT, GL_DOUBLE}, stride, pointer);
}

void client_active_texture(Context& ctx, GLenum texture) {
    if (texture - GL_TEXTURE0 >= static_cast<GLenum>(kMaxTextureUnits))
        return record_error(ctx, GL_INVALID_ENUM, "no such texture unit");
    ctx.arrays.active_texture = texture - GL_TEXTURE0;
}

void enable_client_state(Context& ctx, GLenum array) {
    set_enabled(ctx, array, true);
}
void disable_client_state(Context& ctx, GLenum array) {
    set_enabled(ctx, array, false);
}

void array_element(Context& ctx, GLint i) {
    if (i < 0) return record_error(ctx, GL_INVALID_VALUE, "the element is negative");
    const EnabledArrays arrays(ctx);
    if (arrays.any_mapped()) return record_error(ctx, GL_INVALID_OPERATION, "an array's buffer is mapped");
    for (const ReadableArray& array : arrays) {
        const std::array<GLfloat, 4> v = array.element(static_cast<GLuint>(i));
        if (array.attribute != pipeline::kPosition) {
            set_attribute(ctx, array.attribute, v[0], v[1], v[2], v[3]);
        } else if (ctx.vertex.open) {
            vertex4f(ctx, v[0], v[1], v[2], v[3]);
        }
    }
    if (arrays.index()) ctx.vertex.current.index = arrays.index()->element(static_cast<GLuint>(i))[0];
}

void draw_arrays(Context& ctx, GLenum mode, GLint first, GLsizei count) {
    if (!check_mode_and_count(ctx, mode, count)) return;
    if (first < 0) return record_error(ctx, GL_INVALID_VALUE, "first is negative");
    draw_range(ctx, mode,
               {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count), nullptr, true});
}

void draw_elements(Context& ctx, GLenum mode, GLsizei count, GLenum type, const void* indices) {
    if (!check_mode_and_count(ctx, mode, count) || !check_index_type(ctx, type)) return;
    draw_indexed(ctx, mode, count, type, indices);
}

void draw_range_elements(Context& ctx, GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type,
                         const void* indices) {
    if (!check_mode_and_count(ctx, mode, count)) return;
    if (end < start) return record_error(ctx, GL_INVALID_VALUE, "end is before start");
    if (!check_index_type(ctx, type)) return;
    draw_indexed(ctx, mode, count, type, indices);
}

void multi_draw_arrays(Context& ctx, GLenum mode, const GLint* first, const GLsizei* count,
                       GLsizei drawcount) {
    if (const Rule rule = check_multi_draw(mode, count, drawcount); rule.code != GL_NO_ERROR)
        return record_error(ctx, rule.code, rule.words);
    for (GLsizei i = 0; i < drawcount; ++i)
        if (count[i] > 0) draw_arrays(ctx, mode, first[i], count[i]);
}

void multi_draw_elements(Context& ctx, GLenum mode, const GLsizei* count, GLenum type,
                         const void* const* indices, GLsizei drawcount) {
    if (const Rule rule = check_multi_draw(mode, count, drawcount, type); rule.code != GL_NO_ERROR)
        return record_error(ctx, rule.code, rule.words);
    for (GLsizei i = 0; i < drawcount; ++i)
        if (count[i] > 0) draw_elements(ctx, mode, count[i], type, indices[i]);
}

void interleaved_arrays(Context& ctx, GLenum format, GLsizei stride, const void* pointer) {
    if (format < GL_V2F || format > GL_T4F_C4F_N3F_V4F)
        return record_error(ctx, GL_INVALID_ENUM, "no such interleaved format");
    if (stride < 0) return record_error(ctx, GL_INVALID_VALUE, "stride is negative");
    const InterleavedFormat& f = kInterleaved[format - GL_V2F];
    const GLsizei step = stride ? stride : f.stride;
    ArrayState& arrays = ctx.arrays;
    const auto at = [&](GLint size, GLenum type, GLsizei offset) {
        const auto bytes = reinterpret_cast<std::uintptr_t>(pointer) + static_cast<std::uintptr_t>(offset);
        ClientArray array{true, size, type, step, reinterpret_cast<const void*>(bytes), arrays.array_buffer};
        // Behind a null pointer there is nothing to read, at an offset from it neither.
        array.lost = !pointer && !array.buffer;
        return array;
    };
    ClientArray& texture = arrays.texture[arrays.active_texture];
    arrays.edge_flag.enabled = arrays.index.enabled = false;
    arrays.secondary_color.enabled = arrays.fog_coordinate.enabled = false;
    texture.enabled = f.texture_size != 0;
    if (texture.enabled) texture = at(f.texture_size, GL_FLOAT, 0);
    arrays.color.enabled = f.color_size != 0;
    if (arrays.color.enabled) arrays.color = at(f.color_size, f.color_type, f.color_offset);
    arrays.normal.enabled = f.normal;
    if (f.normal) arrays.normal = at(3, GL_FLOAT, f.normal_offset);
    arrays.vertex = at(f.vertex_size, GL_FLOAT, f.vertex_offset);
}

// EXT_compiled_vertex_array. Draws read what they use when they are called, locked or not: shading the whole
// range once would need all state that shading depends on to be watched, and saves only what several draws
// share.
void lock_arrays_ext(Context& ctx, GLint first, GLsizei count) {
    if (first < 0) return record_error(ctx, GL_INVALID_VALUE, "first is negative");
    if (count <= 0) return record_error(ctx, GL_INVALID_VALUE, "count is not positive");
    if (ctx.arrays.lock_count != 0)
        return record_error(ctx, GL_INVALID_OPERATION, "arrays are locked already");
    ctx.arrays.lock_first = first;
    ctx.arrays.lock_count = count;
}

void unlock_arrays_ext(Context& ctx) {
    if (ctx.arrays.lock_count == 0) return record_error(ctx, GL_INVALID_OPERATION, "no arrays are locked");
    ctx.arrays.lock_first = 0;
    ctx.arrays.lock_count = 0;
}

}  // namespace terrazzo::gl
