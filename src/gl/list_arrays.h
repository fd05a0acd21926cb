// The record of a draw of vertex arrays in a display list (GL 1.5 §5.4): the arrays' elements as they were
// when the list was compiled.
//
// Behind the record stand the indices, if there are any, and the elements: for each one the components of all
// arrays, as floats.
#pragma once

#include <array>
#include <cstdint>

#include "gl/generated/records.h"
#include "gl/list_record.h"
#include "gl/vertex.h"

namespace terrazzo::gl {

struct ArraysRecord {
    static constexpr Opcode kOpcode = Opcode::kArrays;

    struct Stream {
        std::uint8_t attribute;
        std::uint8_t components;
        std::uint16_t offset;  // bytes from the start of an element
    };

    RecordHeader header;
    GLenum mode;
    std::uint32_t vertex_count;
    std::uint32_t index_count;  // 0: the elements are drawn in their order; else as many as vertices
    std::uint32_t stride;       // bytes
    std::uint16_t stream_count;
    pipeline::AttributeMask fourth_is_one;  // as in pipeline::VertexInput
    std::array<Stream, pipeline::kAttributeCount> streams;

    const std::uint32_t* indices() const { return reinterpret_cast<const std::uint32_t*>(this + 1); }
    const float* elements() const { return reinterpret_cast<const float*>(indices() + index_count); }
};

void play_arrays(Context& ctx, const ArraysRecord& record);

}  // namespace terrazzo::gl
