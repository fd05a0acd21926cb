// The orchestrator; see renderer.h. The walk of a triangle goes on in assemble.cpp.
#include "pipeline/renderer.h"

#include "pipeline/assemble.h"

namespace terrazzo::pipeline {

void Renderer::set_target(std::shared_ptr<raster::Target> target) {
    if (target != m_frame.target()) m_frame.begin(std::move(target));
}

void Renderer::draw(const DrawState& state, const VertexInput& input, PrimitiveMode mode, const VertexRange& range) {
    if (m_frame.target() == nullptr) return;
    PrimitiveAssembler(m_frame, m_vertices, m_pivot, state, input).draw(mode, range);
}

void Renderer::clear(const raster::BinClear& clear) {
    if (m_frame.target() == nullptr) return;
    if (m_frame.full()) m_frame.draw();
    m_frame.add(clear);
}

void Renderer::finish() { m_frame.draw(); }

}  // namespace terrazzo::pipeline
