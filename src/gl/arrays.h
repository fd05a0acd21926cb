// Vertex arrays (GL 1.5 §2.8, §2.9.1): the pointers a client has set and which of them are enabled; saved by
// glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT).
#pragma once

#include <GL/gl.h>

#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "gl/buffers.h"
#include "gl/client_pixel.h"
#include "gl/limits.h"
#include "pipeline/geometry/renderer.h"
#include "pipeline/geometry/vertex_input.h"

namespace terrazzo::gl {

struct ClientArray {
    bool enabled = false;
    GLint size = 4;
    GLenum type = GL_FLOAT;
    GLsizei stride = 0;               // as the client gave it; 0 stands for tightly packed
    const GLvoid* pointer = nullptr;  // an offset where there is a buffer
    std::shared_ptr<BufferObject> buffer;
    bool bgra = false;  // four unsigned bytes, blue first: its size is GL_BGRA for the client
    // The buffer has been deleted, or there was none: the offset that is left must not be taken for a
    // pointer.
    bool lost = false;

    // A null pointer is no array.
    bool exists() const { return !lost && (pointer != nullptr || buffer); }
};

struct ArrayState {
    ArrayState() {
        normal.size = 3;
        secondary_color.size = 3;
        fog_coordinate.size = index.size = edge_flag.size = 1;
        edge_flag.type = GL_UNSIGNED_BYTE;
    }

    ClientArray vertex, normal, color, secondary_color, fog_coordinate, index, edge_flag;
    std::array<ClientArray, kMaxTextureUnits> texture;
    unsigned active_texture =
        0;  // the unit glTexCoordPointer and glEnableClientState(GL_TEXTURE_COORD_ARRAY) act on
    std::shared_ptr<BufferObject> array_buffer;  // what the next pointer is an offset into
    std::shared_ptr<BufferObject> element_buffer;
    // EXT_compiled_vertex_array: elements that the client promises not to change; a count of 0 for none.
    GLint lock_first = 0;
    GLsizei lock_count = 0;
};

// Calls visit(attribute, array, normalized) for each array that the pipeline reads, the position last; index
// arrays, which RGBA mode ignores, are left out. `normalized` integers stand for [0, 1] or [-1, 1].
template <typename Arrays, typename Visit>
void for_each_array(Arrays& arrays, Visit visit) {
    visit(pipeline::kNormal, arrays.normal, true);
    visit(pipeline::kColor, arrays.color, true);
    visit(pipeline::kSecondaryColor, arrays.secondary_color, true);
    visit(pipeline::kFogCoordinate, arrays.fog_coordinate, false);
    visit(pipeline::kEdgeFlag, arrays.edge_flag, false);
    for (int unit = 0; unit < kMaxTextureUnits; ++unit)
        visit(pipeline::kTexture0 + unit, arrays.texture[static_cast<std::size_t>(unit)], false);
    visit(pipeline::kPosition, arrays.vertex, false);
}

// Unbinds the buffers for which is_deleted(buffer) says so; their arrays are lost.
template <typename IsDeleted>
void forget_buffers(ArrayState& arrays, IsDeleted is_deleted) {
    const auto forget = [&](std::shared_ptr<BufferObject>& binding) {
        const bool deleted = binding && is_deleted(std::as_const(*binding));
        if (deleted) binding.reset();
        return deleted;
    };
    for_each_array(arrays, [&](int, ClientArray& array, bool) { array.lost |= forget(array.buffer); });
    arrays.index.lost |= forget(arrays.index.buffer);
    forget(arrays.array_buffer);
    forget(arrays.element_buffer);
}

// The array that glEnableClientState calls `name`, null when there is none.
ClientArray* find_client_array(ArrayState& arrays, GLenum name);

// An array's elements where they stand in memory.
struct ReadableArray {
    int attribute = 0;
    bool normalized = false;
    const ClientArray* array = nullptr;
    ReadableBytes bytes;
    std::size_t stride = 0;
    std::size_t count = 0;  // whole elements within the buffer; no bound for client arrays

    // Element `i` as floats, missing components as 0, 0, 0, 1; zeros past the end of a buffer.
    std::array<GLfloat, 4> element(GLuint i) const;
};

// The enabled arrays that exist, the position last; their buffers' stores stay while this lives.
class EnabledArrays {
  public:
    explicit EnabledArrays(const Context& ctx);

    auto begin() const { return m_arrays.begin(); }
    auto end() const { return m_arrays.begin() + m_count; }
    bool has_position() const { return m_count > 0 && (end() - 1)->attribute == pipeline::kPosition; }
    bool any_mapped() const { return m_any_mapped; }
    // The least number of elements that an array has.
    std::size_t shortest() const { return m_shortest; }

    // The current index's array; null where there is none.
    const ReadableArray* index() const { return m_index.array ? &m_index : nullptr; }

  private:
    ReadableArray readable(const Context& ctx, int attribute, const ClientArray& array, bool normalized);

    std::array<ReadableArray, 6 + kMaxTextureUnits> m_arrays;
    std::ptrdiff_t m_count = 0;
    std::size_t m_shortest = static_cast<std::size_t>(-1);
    bool m_any_mapped = false;
    ReadableArray m_index;
};

// What MultiDrawArrays and MultiDrawElements ask of their arguments before anything is drawn. GL 1.5 §2.8
// would pass over negative counts; like the reference, and the draws that a count stands for, ours takes them
// for errors.
Rule check_multi_draw(GLenum mode, const GLsizei* count, GLsizei drawcount,
                      GLenum index_type = GL_UNSIGNED_BYTE);

// A draw of more vertices than this, some of them beyond the end of a buffer, is GL_OUT_OF_MEMORY, in display
// lists as outside: a wrong count must not take all memory. What is within buffers or the client's arrays is
// in memory already.
inline constexpr std::size_t kMostVerticesBeyond = std::size_t{1} << 24;

// The streams of four components whose last is 1 in all vertices of the range; see pipeline::VertexInput.
pipeline::AttributeMask find_fourth_ones(const pipeline::VertexInput& input,
                                         const pipeline::VertexRange& range);

// Whether all elements of the range are in the arrays' buffers.
bool is_inside(const pipeline::VertexRange& range, const EnabledArrays& arrays);

// The indices of a draw: `count` of them or as many as the bound element buffer holds.
struct ReadableIndices {
    ReadableBytes bytes;
    GLsizei count = 0;

    // All of them, whatever their type is.
    std::vector<std::uint32_t> widened(GLenum type) const;
};
ReadableIndices find_indices(const Context& ctx, GLsizei count, GLenum type, const void* indices);

}  // namespace terrazzo::gl
