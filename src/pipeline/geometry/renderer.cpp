// The orchestrator; see renderer.h. The walk of a triangle goes on in assemble.cpp.
#include "pipeline/geometry/renderer.h"

#include <algorithm>
#include <cstring>
#include <new>

#include "pipeline/schedule/float_environment.h"
#include "pipeline/schedule/statistics.h"

namespace terrazzo::pipeline {

// Has `add` queue something, all of it or nothing. Where there is no memory for it that of the frame serves,
// which is drawn for that.
template <typename Add>
void Renderer::queue(Add add) {
    if (m_frame.full()) m_frame.draw();
    const Frame::Mark before = m_frame.mark();
    const uint32_t stipple_counter = m_stipple_counter;
    try {
        return add();
    } catch (const std::bad_alloc&) {
        const bool whole = m_frame.still_holds(before);
        m_frame.take_back(before);
        m_stipple_counter = stipple_counter;
        if (!whole || m_frame.empty()) throw;
    }
    m_frame.draw();
    const Frame::Mark nothing = m_frame.mark();
    try {
        add();
    } catch (const std::bad_alloc&) {
        m_frame.take_back(nothing);
        m_stipple_counter = stipple_counter;
        throw;
    }
}

void Renderer::set_target(std::shared_ptr<raster::Target> target, DrawnColors colors) {
    if (target != m_frame.target() || colors != m_frame.colors()) m_frame.begin(std::move(target), colors);
}

void Renderer::draw(const DrawState& state, const VertexInput& input, PrimitiveMode mode,
                    const VertexRange& range) {
    if (m_frame.target() == nullptr) return;
    const FloatEnvironment environment;
    const StageTimer timer(statistics.vertex_nanoseconds);
    const Pieces pieces(mode, range, m_piece_sizes);
    queue([&] { draw_pieces(state, input, pieces); });
}

void Renderer::draw_pieces(const DrawState& state, const VertexInput& input, const Pieces& pieces) {
    uint32_t next = 0;
    if (m_parallel.is_worthwhile(state, pieces))
        next = m_parallel.draw(m_frame, m_vertices, state, input, pieces);
    const uint32_t count = pieces.count();
    if (next == count) return;
    PrimitiveAssembler assembler(m_frame.lists(), m_vertices, m_stipple_counter, state, input);
    for (; next < count; ++next) {
        // The frame may be drawn and begun again between pieces; what this draw needs is kept by each anew.
        if (m_frame.full()) m_frame.draw();
        m_frame.keep(state.fragment);
        assembler.draw(pieces[next]);
    }
}

void Renderer::observe(const DrawState& state, const VertexInput& input, PrimitiveMode mode,
                       const VertexRange& range, PrimitiveObserver& observer) {
    const FloatEnvironment environment;
    PrimitiveAssembler assembler(m_frame.lists(), m_vertices, m_stipple_counter, state, input, &observer);
    const Pieces pieces(mode, range, m_piece_sizes);
    const uint32_t count = pieces.count();
    for (uint32_t i = 0; i < count; ++i) assembler.draw(pieces[i]);
}

void Renderer::draw(const RasterState& raster, const std::shared_ptr<const FragmentBlock>& fragment,
                    const PixelRect& rect) {
    if (m_frame.target() == nullptr) return;
    queue([&] { add(raster, fragment, rect); });
}

void Renderer::add(const RasterState& raster, const std::shared_ptr<const FragmentBlock>& fragment,
                   const PixelRect& rect) {
    const int32_t x0 = std::max(rect.x0, raster.x0), x1 = std::min(rect.x1, raster.x1);
    const int32_t y0 = std::max(rect.y0, raster.y0), y1 = std::min(rect.y1, raster.y1);
    if (x0 >= x1 || y0 >= y1) return;
    m_frame.keep(fragment);
    const raster::FragmentState& state = fragment->point;
    const int plane_count = 2 + state.varyings.count;
    using raster::Primitive;
    Primitive* const p = new (m_frame.lists().arena().allocate(Primitive::size_of(plane_count))) Primitive;
    p->state = &state;
    p->x0 = static_cast<int16_t>(x0), p->x1 = static_cast<int16_t>(x1);
    p->y0 = static_cast<int16_t>(y0), p->y1 = static_cast<int16_t>(y1);
    p->edge_count = 0;
    p->plane_count = static_cast<uint8_t>(plane_count);
    p->back_facing = p->steep = false;
    p->is_cut = true;
    p->depth_offset = 0;
    p->data = rect.data;
    p->tile_data = rect.tile_data;
    if (rect.owner) {
        m_frame.keep(rect.owner, rect.data_bytes);
    } else if (rect.data != raster::RectangleData::kNone) {
        p->tile_data.tiles = std::memcpy(m_frame.lists().arena().allocate(rect.data_bytes),
                                         rect.tile_data.tiles, rect.data_bytes);
    }
    float* const planes = p->planes();
    std::fill_n(planes, 3 * plane_count, 0.0f);
    planes[0] = rect.z;
    planes[1] = 1;
    std::copy_n(rect.varyings.begin(), state.varyings.count, planes + 2);
    m_frame.lists().add(*p);
}

void Renderer::clear(const raster::BinClear& clear) {
    if (m_frame.target() == nullptr) return;
    queue([&] { m_frame.add(clear); });
}

void Renderer::finish() {
    m_frame.draw();
}

void Renderer::finish(raster::PixelLayout layout, std::byte* row0, std::ptrdiff_t stride) {
    if (m_frame.target() == nullptr) return;
    const auto group = raster::rows_share_cache_lines(stride) ? Frame::Group::kRow : Frame::Group::kBin;
    m_frame.draw(group, [&](int first, int count) {
        raster::resolve_bins(*m_frame.target(), first, count, layout, row0, stride);
    });
}

}  // namespace terrazzo::pipeline
