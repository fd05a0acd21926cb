// The way of a draw: from vertices to primitives in the bins of a frame, and of a frame to pixels.
//
// One renderer belongs to one context and is used by one thread at a time. Draws are queued; `finish` makes
// them pixels. Texture images and other objects that a draw's states point at are kept by the frame until
// then.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "pipeline/geometry/assemble/assemble.h"
#include "pipeline/geometry/draw_state.h"
#include "pipeline/geometry/parallel_draw.h"
#include "pipeline/geometry/primitive_observer.h"
#include "pipeline/geometry/vertex_input.h"
#include "pipeline/schedule/fragment_block.h"
#include "pipeline/schedule/frame.h"
#include "raster/target/copy_out.h"

namespace terrazzo::pipeline {

// A rectangle of pixels that share their varyings, as bitmaps and pixel rectangles are (GL 1.5 §3.6.4, §3.7).
struct PixelRect {
    int32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // in raster rows, x1 and y1 exclusive; may leave the target
    float z = 0;
    std::array<float, raster::kMaxPlanes> varyings{};  // in the order of raster::Varyings
    raster::RectangleData data = raster::RectangleData::kNone;
    raster::TileData tile_data{};
    size_t data_bytes = 0;
    // Keeps the tiles; null: they are copied.
    std::shared_ptr<const void> owner;
};

class Renderer {
  public:
    // Draws from now on go to these colour buffers of `target`, which has them; queued ones are finished
    // first. Null releases it. Throws std::bad_alloc and changes nothing then.
    void set_target(std::shared_ptr<raster::Target> target, DrawnColors colors);
    const std::shared_ptr<raster::Target>& target() const { return m_frame.target(); }
    DrawnColors colors() const { return m_frame.colors(); }

    // Queues a draw; the frame keeps what the draw's fragments need, the vertices are used up at once. Throws
    // std::bad_alloc, and nothing of the draw is queued then. Draws the frame early whenever it has grown
    // full, or where there is no memory for more: what is larger than a frame may have been drawn in part.
    void draw(const DrawState& state, const VertexInput& input, PrimitiveMode mode, const VertexRange& range);
    // Shows a draw's primitives to an observer instead. Throws std::bad_alloc.
    void observe(const DrawState& state, const VertexInput& input, PrimitiveMode mode,
                 const VertexRange& range, PrimitiveObserver& observer);
    // Queues a rectangle of pixels with the fragment state of points. Throws std::bad_alloc, and nothing is
    // queued then.
    void draw(const RasterState& raster, const std::shared_ptr<const FragmentBlock>& fragment,
              const PixelRect& rect);
    // Queues a clear. Throws std::bad_alloc, and nothing is queued then.
    void clear(const raster::BinClear& clear);
    // Draws everything that is queued. Throws std::bad_alloc where draws go to both colour buffers, and
    // changes nothing then.
    void finish();
    // The same, with the picture copied out (raster/target/copy_out.h) bin by bin as it is finished.
    void finish(raster::PixelLayout layout, std::byte* row0, std::ptrdiff_t stride);

    // For tests: cuts draws in another way, which shows (pieces.h), and says which go to all threads.
    void set_pieces(const PieceSizes& sizes, uint32_t worth_waking) {
        m_piece_sizes = sizes;
        m_parallel.set_worth_waking(worth_waking);
    }

  private:
    template <typename Add>
    void queue(Add add);
    void add(const RasterState& raster, const std::shared_ptr<const FragmentBlock>& fragment,
             const PixelRect& rect);

    void draw_pieces(const DrawState& state, const VertexInput& input, const Pieces& pieces);

    Frame m_frame;
    PieceVertices m_vertices;
    ParallelDraw m_parallel;
    PieceSizes m_piece_sizes;
    uint32_t m_stipple_counter = 0;
};

}  // namespace terrazzo::pipeline
