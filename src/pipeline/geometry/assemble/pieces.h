// The pieces in which a draw is shaded and assembled, cut where primitives end.
//
// Input: a draw's kind and range. Output: runs of whole primitives, and which of the range's positions they
// use. A piece is drawn without looking at others.
#pragma once

#include <algorithm>
#include <cstdint>

#include "pipeline/geometry/vertex_input.h"

namespace terrazzo::pipeline {

// Vertices of one piece of an indexed draw: enough to shade most that are used again only once.
inline constexpr uint32_t kIndexedPiece = 12288;

// Primitives [first, last) of the range.
struct Piece {
    PrimitiveMode mode;
    const VertexRange& range;
    uint32_t first, last;
};

class Pieces {
  public:
    // The range must outlive the pieces.
    Pieces(PrimitiveMode mode, const VertexRange& range);

    uint32_t count() const { return m_primitives / m_step + (m_primitives % m_step != 0); }
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
