// Begin/End geometry on its way into a display list: collected as batches of vertices, not as one record per
// call.
//
// Runs of Begin, vertices and attributes, and End become one Primitives record (list_primitives.h) that goes
// to the pipeline as a whole. That needs complete runs whose attributes are known from the first vertex on,
// or not set at all; whatever else a list holds (vertices without Begin, an attribute that first appears in
// the middle of a run, other commands between Begin and End) is recorded call by call, which says the same.
#pragma once

#include <GL/gl.h>

#include <array>
#include <cstdint>
#include <vector>

#include "gl/vertex.h"

namespace terrazzo::gl {

class DisplayList;

class ListVertices {
  public:
    // The commands of the same names; `list` takes what cannot be collected. All throw std::bad_alloc.
    void begin(DisplayList& list, GLenum mode);
    void end(DisplayList& list);
    void vertex(DisplayList& list, const std::array<GLfloat, 4>& position);
    void attribute(DisplayList& list, int attribute, const std::array<GLfloat, 4>& value);
    void index(DisplayList& list, GLfloat value);

    // Records what has been collected, before a command of another kind is recorded or the list ends.
    void finish(DisplayList& list);

    bool open() const {
        return m_open || m_call_by_call;
    }  // between Begin and End, as far as the list can tell

    // Forgets everything.
    void reset() { *this = {}; }

  private:
    void start_batch();
    void note_fourth(int attribute, const std::array<GLfloat, 4>& value);
    void add_stream(int attribute);
    void record_attributes(DisplayList& list, pipeline::AttributeMask mask) const;
    void record_open_run(DisplayList& list);
    void record_batch(DisplayList& list);

    // Vertex i begins at m_data[i * m_stride]: the position, then the streams in order, four floats each.
    std::vector<float> m_data;
    std::uint32_t m_count = 0;
    std::uint32_t m_stride = 4;
    std::vector<std::uint8_t> m_streams;
    std::vector<PrimitiveRun> m_runs;
    pipeline::AttributeMask m_streamed = 0;  // have a stream
    pipeline::AttributeMask m_constant = 0;  // set before the first vertex, without a stream: m_first
    pipeline::AttributeMask m_set = 0;       // set at all: m_last
    pipeline::AttributeMask m_changed = 0;   // set since the last vertex
    std::array<std::array<GLfloat, 4>, pipeline::kAttributeCount> m_first{}, m_last{};
    bool m_index_set = false;
    GLfloat m_index = 0;

    bool m_open = false;                   // a run is being collected
    pipeline::AttributeMask m_fourth = 0;  // as VertexBatch::fourth
    GLenum m_mode = 0;
    std::uint32_t m_open_first = 0;
    bool m_call_by_call = false;  // until End
};

}  // namespace terrazzo::gl
