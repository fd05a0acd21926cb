// The pieces in which a draw is shaded and assembled, cut where primitives end.
//
// Input: a draw's kind and range. Output: runs of whole primitives, and which of the range's positions they
// use. But for the stipple that runs on along a strip of lines, a piece is drawn without looking at others:
// on several threads at a time, too. The cuts show (doc/reference.md §3.1), so they do not depend on the
// threads.
#pragma once

#include <algorithm>
#include <cstdint>

#include "pipeline/geometry/vertex_input.h"

namespace terrazzo::pipeline {

// How many vertices a piece has, less those that would be part of a primitive.
struct PieceSizes {
    static constexpr uint32_t kMost = 12288;

    // Enough to shade most that are used again only once.
    uint32_t indexed = kMost;
    // Where vertices come without indices these are the pieces in which the reference draws: it treats all of
    // a piece alike if one vertex of it is clipped (doc/reference.md §3.1).
    uint32_t consecutive = 4096;
    uint32_t long_fan = 1024;  // of fans and polygons that do not fit into one piece
};

// Primitives [first, last) of the range.
struct Piece {
    PrimitiveMode mode;
    const VertexRange& range;
    uint32_t first, last;
};

class Pieces {
  public:
    // The range must outlive the pieces.
    Pieces(PrimitiveMode mode, const VertexRange& range, const PieceSizes& sizes);

    uint32_t count() const { return m_primitives / m_step + (m_primitives % m_step != 0); }
    // Primitives of all pieces but the first.
    uint32_t primitives_beyond_first() const { return m_primitives - std::min(m_step, m_primitives); }
    Piece operator[](uint32_t i) const {
        const uint32_t first = i * m_step;
        return {m_mode, m_range, first, first + std::min(m_step, m_primitives - first)};
    }

  private:
    const PrimitiveMode m_mode;
    const VertexRange& m_range;
    const uint32_t m_primitives, m_step;
};

// Positions [first, end) of the range that a piece's primitives use, besides the pivot.
struct Positions {
    uint32_t first, end;
};
Positions positions_of(const Piece& piece);

// Whether all primitives use the first vertex: the centre of a fan, the start of a loop.
bool has_pivot(PrimitiveMode mode);

}  // namespace terrazzo::pipeline
