// A primitive after set-up: a convex polygon of up to four edges within a pixel rectangle, with one plane a
// varying.
//
// Written by src/pipeline/setup, read by the traversal and the pixel kernels; plain data in the frame's
// memory. The header is followed by 3 * (2 + varyings.count) floats, rounded up to 16 bytes: a0 of every
// plane, then d/dx of every plane, then d/dy. Plane 0 is z, plane 1 is 1/w, then the varyings (multiplied by
// 1/w where perspective).
#pragma once

#include <cstdint>

#include "raster/fragment_state.h"

namespace terrazzo::raster {

// The half plane E(x, y) = c + step_x * x + step_y * y >= 0 over pixel coordinates x, y: the pixel centre is
// inside. Fixed point with 8 sub-pixel bits; the fill rule is folded into c, and c has been divided by 256
// (rounded down), which does not move the sign at any pixel because a step by one pixel changes E by a
// multiple of 256 sub-pixel units. Where FragmentState::multisample is set coordinates are those of pixels'
// corners and c is left undivided, to be stepped to each sample.
struct Edge {
    int64_t c;
    int32_t step_x;  // E(x + 1, y) - E(x, y)
    int32_t step_y;

    // From corner a to corner b of a positive outline, in 8-bit sub-pixels.
    [[gnu::always_inline]] static Edge between(int32_t ax, int32_t ay, int32_t bx, int32_t by,
                                               bool row0_is_top, bool multisample) {
        const int32_t dcdx = ay - by, dcdy = ax - bx;
        int64_t c = int64_t{dcdx} * ax - int64_t{dcdy} * ay;
        // Pixels exactly on a left edge, or on the edge that is lower in GL's orientation, are inside.
        if (dcdx < 0 || (dcdx == 0 && (row0_is_top ? dcdy < 0 : dcdy > 0))) ++c;
        // E > 0 becomes E - 1 >= 0; then pixel steps, which are multiples of 256, let the low bits go.
        return {(c - 1) >> (multisample ? 0 : 8), -dcdx, dcdy};
    }
};

// What a rectangle carries for each of its pixels, tile by tile as the target has them: bits that say which
// pixels there are, or colours, depths, stencil values.
struct TileData {
    const void* tiles;
    int32_t first_column, first_row;  // of the first tile, counted in the target
    int32_t across;                   // tiles from one row of them to the next

    [[gnu::always_inline]] size_t index(int column, int row) const {
        return static_cast<size_t>(row - first_row) * static_cast<size_t>(across) +
               static_cast<size_t>(column - first_column);
    }
};

enum class RectangleData : uint8_t {
    kNone,
    kMasks,   // 16 bits a tile: the pixels that there are
    kPixels,  // what FragmentKey::image says
};

struct Primitive {
    const FragmentState* state;
    int16_t x0, y0, x1, y1;  // pixels, x1 and y1 exclusive; already clipped to the scissor and the target
    uint8_t edge_count;      // 0 (the whole rectangle), 3 or 4
    uint8_t plane_count;     // 2 + varyings.count
    bool back_facing;
    bool steep;  // planes so steep that their rounding shows: interpolated as exactly as the reference does
    float depth_offset;  // added to z of each fragment where the key says so
    RectangleData data;  // other than kNone only where edge_count is 0
    bool is_cut;         // the rectangle may leave out pixels that the edges enclose
    union {
        Edge edges[4];
        TileData tile_data;
    };

    [[gnu::always_inline]] const float* a0() const { return reinterpret_cast<const float*>(this + 1); }
    [[gnu::always_inline]] const float* dadx() const { return a0() + plane_count; }
    [[gnu::always_inline]] const float* dady() const { return a0() + 2 * plane_count; }
    float* planes() { return reinterpret_cast<float*>(this + 1); }

    static constexpr uint32_t size_of(int plane_count) {
        const uint32_t bytes = sizeof(Primitive) + 3u * sizeof(float) * static_cast<uint32_t>(plane_count);
        return (bytes + 15u) & ~15u;
    }
};
static_assert(sizeof(Primitive) == (sizeof(void*) == 8 ? 96 : 88));

}  // namespace terrazzo::raster
