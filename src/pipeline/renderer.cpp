// The orchestrator; see renderer.h. The walk of a triangle goes on in assemble.cpp.
#include "pipeline/renderer.h"

#include "pipeline/assemble.h"
#include "pipeline/float_environment.h"

namespace terrazzo::pipeline {

void Renderer::set_target(std::shared_ptr<raster::Target> target) {
    if (target != m_frame.target()) m_frame.begin(std::move(target));
}

void Renderer::draw(const DrawState& state, const VertexInput& input, PrimitiveMode mode,
                    const VertexRange& range) {
    if (m_frame.target() == nullptr) return;
    const FloatEnvironment environment;
    PrimitiveAssembler(m_frame, m_vertices, m_pivot, m_stipple_counter, state, input).draw(mode, range);
}

void Renderer::clear(const raster::BinClear& clear) {
    if (m_frame.target() == nullptr) return;
    if (m_frame.full()) m_frame.draw();
    m_frame.add(clear);
}

void Renderer::finish() {
    m_frame.draw();
}

void Renderer::finish(PixelLayout layout, std::byte* row0, std::ptrdiff_t stride) {
    if (m_frame.target() == nullptr) return;
    m_frame.draw([&](int bin) { resolve_bin(*m_frame.target(), bin, layout, row0, stride); });
}

}  // namespace terrazzo::pipeline
