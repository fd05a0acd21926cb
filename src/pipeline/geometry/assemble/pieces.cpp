// Cutting a draw into pieces; see pieces.h.
#include "pipeline/geometry/assemble/pieces.h"

namespace terrazzo::pipeline {

namespace {

// How many primitives `count` vertices make.
uint32_t primitive_count(PrimitiveMode mode, uint32_t count) {
    const auto beyond = [&](uint32_t used) { return count > used ? count - used : 0; };
    switch (mode) {
        case PrimitiveMode::kPoints:
            return count;
        case PrimitiveMode::kLines:
            return count / 2;
        case PrimitiveMode::kLineLoop:
            return count >= 2 ? count : 0;
        case PrimitiveMode::kLineStrip:
            return beyond(1);
        case PrimitiveMode::kTriangles:
            return count / 3;
        case PrimitiveMode::kTriangleStrip:
        case PrimitiveMode::kTriangleFan:
        case PrimitiveMode::kPolygon:
            return beyond(2);
        case PrimitiveMode::kQuads:
            return count / 4;
        case PrimitiveMode::kQuadStrip:
            return beyond(2) / 2;
    }
    return 0;
}

// Of all pieces but the last.
uint32_t primitives_of_piece(PrimitiveMode mode, const VertexRange& range, const PieceSizes& sizes) {
    const uint32_t vertices = range.indices ? sizes.indexed : sizes.consecutive;
    switch (mode) {
        case PrimitiveMode::kTriangles:
            return vertices / 3;
        case PrimitiveMode::kQuads:
            return vertices / 4;
        case PrimitiveMode::kLines:
            return vertices / 2;
        case PrimitiveMode::kQuadStrip:
            return (vertices - 2) / 2;
        case PrimitiveMode::kTriangleFan:
        case PrimitiveMode::kPolygon:
            return (!range.indices && range.count > sizes.consecutive ? sizes.long_fan : vertices) - 2;
        case PrimitiveMode::kPoints:
        case PrimitiveMode::kLineStrip:
        case PrimitiveMode::kLineLoop:
        case PrimitiveMode::kTriangleStrip:
            break;
    }
    return vertices - 2;
}

}  // namespace

Pieces::Pieces(PrimitiveMode mode, const VertexRange& range, const PieceSizes& sizes)
    : m_mode(mode),
      m_range(range),
      m_primitives(primitive_count(mode, range.count)),
      m_step(primitives_of_piece(mode, range, sizes)) {}

bool has_pivot(PrimitiveMode mode) {
    return mode == PrimitiveMode::kTriangleFan || mode == PrimitiveMode::kPolygon ||
           mode == PrimitiveMode::kLineLoop;
}

Positions positions_of(const Piece& piece) {
    const uint32_t first = piece.first, last = piece.last;
    switch (piece.mode) {
        case PrimitiveMode::kPoints:
            return {first, last};
        case PrimitiveMode::kLines:
            return {2 * first, 2 * last};
        case PrimitiveMode::kLineLoop:
            return {first, std::min(last + 1, piece.range.count)};
        case PrimitiveMode::kLineStrip:
            return {first, last + 1};
        case PrimitiveMode::kTriangles:
            return {3 * first, 3 * last};
        case PrimitiveMode::kTriangleStrip:
            return {first, last + 2};
        case PrimitiveMode::kTriangleFan:
        case PrimitiveMode::kPolygon:
            return {first + 1, last + 2};
        case PrimitiveMode::kQuads:
            return {4 * first, 4 * last};
        case PrimitiveMode::kQuadStrip:
            return {2 * first, 2 * last + 2};
    }
    return {0, 0};
}

}  // namespace terrazzo::pipeline
