// The record of a batch of complete primitives in a display list.
//
// Behind the record stand the runs, the attributes that the batch sets before and after it, and the vertices:
// for each vertex its position and the streamed attributes, as many components of each as differ from 0, 0, 1
// somewhere.
#pragma once

#include <array>
#include <cstdint>

#include "gl/generated/records.h"
#include "gl/list_record.h"
#include "gl/vertex.h"

namespace terrazzo::gl {

struct AttributeValue {
    std::uint32_t attribute;
    std::array<GLfloat, 4> value;
};

struct PrimitivesRecord {
    static constexpr Opcode kOpcode = Opcode::kPrimitives;

    struct Stream {
        std::uint8_t attribute;
        std::uint8_t components;
        std::uint16_t offset;  // bytes from the start of a vertex
    };

    RecordHeader header;
    std::uint32_t run_count;
    std::uint32_t before_count;  // attributes set before the first vertex
    std::uint32_t after_count;   // attributes to be left as they were set last
    std::uint32_t vertex_count;
    std::uint32_t stride;  // bytes
    std::uint16_t stream_count;
    bool index_set;  // the current colour index is left at `index`
    GLfloat index;
    std::array<Stream, pipeline::kAttributeCount> streams;

    const PrimitiveRun* runs() const { return reinterpret_cast<const PrimitiveRun*>(this + 1); }
    const AttributeValue* before() const {
        return reinterpret_cast<const AttributeValue*>(runs() + run_count);
    }
    const AttributeValue* after() const { return before() + before_count; }
    const float* vertices() const { return reinterpret_cast<const float*>(after() + after_count); }
};

void play_primitives(Context& ctx, const PrimitivesRecord& record);

}  // namespace terrazzo::gl
