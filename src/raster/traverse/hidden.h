// Blocks that cannot be seen are not shaded [Frolov 2020 §2.4]: bounds of the depths that each tile and each
// bin hold are compared with a bound of what a primitive would write there.
//
// Bounds are window z as floats; infinite where nothing is known. They are kept by the traversal alone, a row
// of tiles at a time: where a primitive covers a tile and its depth test lets nearer fragments pass, no pixel
// is farther afterwards than the primitive. A block is skipped where every one of its fragments would fail
// the depth test, so pictures do not depend on any of this.
#pragma once

#include <algorithm>
#include <limits>

#include "raster/primitive.h"
#include "raster/target/target.h"
#include "simd/wide.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

TERRAZZO_INLINE float depth_maximum(int depth_bits) {
    return depth_bits == 16 ? 65535.0f : 16777215.0f;
}

// Whether a fragment that lies behind all of a tile leaves no trace.
TERRAZZO_INLINE bool discards_hidden(const FragmentKey& key) {
    return key.depth_test && !key.stencil_test && !key.depth_clamp && key.image != PixelImage::kDepth &&
           (key.depth_func == Compare::kLess || key.depth_func == Compare::kLessEqual);
}
// Whether each fragment of such a state leaves its pixel's depth at most its own.
TERRAZZO_INLINE bool hides_what_follows(const FragmentKey& key) {
    return key.depth_write && !key.depth_clamp && key.alpha_func == Compare::kAlways &&
           !key.polygon_stipple && key.coverage == Coverage::kNone && key.sample_mask == 0xf &&
           !key.alpha_to_coverage && key.image != PixelImage::kDepth;
}
// Whether a fragment may leave a depth that is farther than the one before.
TERRAZZO_INLINE bool raises_depth(const FragmentKey& key) {
    return key.depth_write && key.depth_func >= Compare::kGreater;
}

// One primitive's depths against a bin's bounds.
class BlockDepths {
  public:
    // Fragments of a tile lie up to `extent` pixels right of and below the first.
    TERRAZZO_INLINE BlockDepths(const Primitive& primitive, const Bin& bin, float extent)
        : m_dadx(primitive.dadx()[0]), m_dady(primitive.dady()[0]), m_bounds(bin.farthest) {
        const FragmentKey& key = primitive.state->key;
        // Where the first sample decides for all of a pixel's, the others may stay farther away.
        const bool all_tested = bin.depth_alike == nullptr || primitive.state->multisample;
        m_lowers = all_tested && hides_what_follows(key) && primitive.data != RectangleData::kMasks;
        const float a0 = primitive.a0()[0], offset = key.depth_offset ? primitive.depth_offset : 0.0f;
        const float x = static_cast<float>(bin.x), y = static_cast<float>(bin.y);
        // Eight times what the sums here and the fragments' own can err, and two steps of the buffer for its
        // rounding. Infinities and NaN make every comparison below false.
        const float terms = __builtin_fabsf(a0) + __builtin_fabsf(m_dadx) * (x + kBinSize) +
                            __builtin_fabsf(m_dady) * (y + kBinSize) + __builtin_fabsf(offset);
        const float slack = terms * 0x1p-19f + 2.0f / depth_maximum(primitive.state->depth_bits);
        const float first = a0 + m_dadx * x + m_dady * y + offset;
        m_nearest = first + extent * (std::min(m_dadx, 0.0f) + std::min(m_dady, 0.0f)) - slack;
        m_farthest = first + extent * (std::max(m_dadx, 0.0f) + std::max(m_dady, 0.0f)) + slack;
        m_along = to_float(lane_numbers()) * F32x16(m_dadx * kTileSize);
    }

    // Whether all tiles of the columns and rows first to last lie behind `bound`.
    TERRAZZO_INLINE bool behind(float bound, int first_column, int last_column, int first_row,
                                int last_row) const {
        const float x = static_cast<float>(kTileSize * (m_dadx > 0 ? first_column : last_column));
        const float y = static_cast<float>(kTileSize * (m_dady > 0 ? first_row : last_row));
        return m_nearest + m_dadx * x + m_dady * y > bound;
    }
    // One bit for each tile of a row that is hidden. Those of `covered` that are not hide what comes later.
    TERRAZZO_INLINE uint32_t hidden_tiles(int row, uint32_t covered) {
        float* const bounds = m_bounds + row * kTilesAcross;
        const F32x16 old = load(bounds);
        const float down = m_dady * static_cast<float>(kTileSize * row);
        const uint32_t hidden = bits_of(m_along + F32x16(m_nearest + down) > old);
        if (m_lowers && covered != 0) {
            // Depths are cut off at 0 and 1 before they are compared: bounds stay between them. In this order
            // a NaN stays one.
            const F32x16 bound = max(F32x16(0.0f), m_along + F32x16(m_farthest + down));
            const Mask16 lower = (bound < old) & (bound < F32x16(1.0f)) & mask_from_bits(covered & ~hidden);
            store(select(lower, bound, old), bounds);
        }
        return hidden;
    }

  private:
    float m_dadx, m_dady, m_nearest, m_farthest;
    float* m_bounds;
    bool m_lowers;
    F32x16 m_along;
};

// Lets the depths of some rows of tiles be anything.
TERRAZZO_NOINLINE void forget_bounds(Bin& bin, int first_row, int last_row) {
    constexpr float kUnknown = std::numeric_limits<float>::infinity();
    for (int row = first_row; row <= last_row; ++row)
        store(F32x16(kUnknown), bin.farthest + row * kTilesAcross);
    bin.state->farthest = kUnknown;
}

// Brings the bin's bound up to date with its tiles'.
TERRAZZO_NOINLINE void lower_bin_bound(Bin& bin) {
    F32x16 farthest = load(bin.farthest);
    for (int row = 1; row < kBinSize / kTileSize; ++row)
        farthest = max(farthest, load(bin.farthest + row * kTilesAcross));
    // Bounds are never negative, so that their order is that of their bits.
    bin.state->farthest = __builtin_bit_cast(float, largest_lane(as_int(farthest)));
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
