// Begin/End and the current vertex attributes (GL 1.5 §2.6, §2.7).
//
// Vertices are collected in a batch that outlives End: runs of primitives that were specified under the same
// state go to the pipeline together, when something is about to change (`begin_change`) or must be seen. A
// batch holds a stream for each attribute that changed since its first vertex; all others are constant.
//
// Where memory is short a primitive is drawn whole or not at all: Begin to End of which a vertex or an
// attribute gets lost leaves nothing behind, and GL_OUT_OF_MEMORY is recorded. A batch that cannot go to the
// pipeline waits for the next occasion; whatever wanted it gone fails until then.
#pragma once

#include <GL/gl.h>

#include <array>
#include <cstdint>
#include <vector>

#include "pipeline/geometry/vertex_input.h"

namespace terrazzo::gl {

struct Context;

// The values a vertex takes that gives none of its own (GL 1.5 §2.7); saved by glPushAttrib(GL_CURRENT_BIT).
struct CurrentAttributes {
    CurrentAttributes() {
        values.fill({0, 0, 0, 1});
        values[pipeline::kNormal] = {0, 0, 1, 1};
        values[pipeline::kColor] = {1, 1, 1, 1};
        values[pipeline::kEdgeFlag] = {1, 0, 0, 1};
    }
    const std::array<GLfloat, 4>& color() const { return values[pipeline::kColor]; }

    // The material entries are meaningful only while a batch streams them.
    std::array<std::array<GLfloat, 4>, pipeline::kAttributeCount> values;
    GLfloat index = 1;
};

struct PrimitiveRun {
    GLenum mode;
    std::uint32_t first, count;
    // Of a strip, loop or polygon that was drawn in parts: not the first one, not the last one.
    bool continues = false, is_continued = false;
    pipeline::AttributeMask fourth = 0;  // as VertexBatch::fourth
};

// Adds a run of vertices, as part of the last one where that draws the same.
void add_run(std::vector<PrimitiveRun>& runs, const PrimitiveRun& run);

struct VertexBatch {
    // Vertex i begins at data[i * stride]: the position, then `streams[0]`, `streams[1]`, ..., four floats
    // each.
    std::vector<float> data;
    float* next = nullptr;  // where the next vertex goes
    float* end = nullptr;
    std::uint32_t count = 0;
    std::uint32_t stride = 4;
    pipeline::AttributeMask mask = 0;  // attributes in `streams`
    std::uint32_t stream_count = 0;
    std::array<std::uint8_t, pipeline::kAttributeCount> streams{};
    // Attributes of pipeline::kHomogeneous whose fourth component has been other than 1 since Begin.
    pipeline::AttributeMask fourth = 0;
    std::vector<PrimitiveRun> runs;
    bool in_flight = false;  // on its way to the pipeline, which may change what is drawn to
    int failures = 0;        // how often it could not go there
};

struct VertexState {
    CurrentAttributes current;
    VertexBatch batch;
    GLenum mode = GL_POINTS;        // of the open Begin
    std::uint32_t open_first = 0;   // where its run starts
    bool open = false;              // between Begin and End
    bool is_lost = false;           // ... and memory has been missing for what was given since
    bool open_continues = false;    // ... and part of what it began has been drawn
    std::vector<float> loop_start;  // first vertex of a line loop whose run had to be broken
};

// Hands the collected vertices to the pipeline; not between Begin and End. Throws std::bad_alloc: those that
// have not been handed over stay.
void flush_vertices(Context& ctx);

// Begin, for commands of ours that draw by themselves. False where it is refused, and the error is recorded:
// then neither vertices nor End may follow.
bool open_primitive(Context& ctx, GLenum mode);

// Gives the batch a stream for an attribute that was constant so far. Throws std::bad_alloc and changes
// nothing then.
void stream_attribute(Context& ctx, int attribute);

// Memory has been missing for a command between Begin and End: the primitives go.
void lose_open_primitives(Context& ctx) noexcept;

}  // namespace terrazzo::gl
