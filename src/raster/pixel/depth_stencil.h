// Stencil and depth test of a tile (GL 1.5 §4.1.5, §4.1.6), in that order: the bits of the mask that survive,
// with both buffers brought up to date.
#pragma once

#include "raster/pixel/compare.h"
#include "raster/pixel/interpolate.h"
#include "raster/traverse/hidden.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

// z in [0, 1] to the buffer's integers, rounded to nearest.
TERRAZZO_INLINE I32x16 quantize_depth(F32x16 z, int depth_bits) {
    return to_unorm(z, depth_maximum(depth_bits));
}

TERRAZZO_INLINE I32x16 apply(StencilOp op, I32x16 old, const StencilFace& face) {
    switch (op) {
        case StencilOp::kKeep:
            break;
        case StencilOp::kZero:
            return I32x16(0);
        case StencilOp::kReplace:
            return I32x16(face.reference);
        case StencilOp::kIncrement:
            return min(old + I32x16(1), I32x16(255));
        case StencilOp::kDecrement:
            return max(old - I32x16(1), I32x16(0));
        case StencilOp::kInvert:
            return old ^ I32x16(255);
        case StencilOp::kIncrementWrap:
            return (old + I32x16(1)) & I32x16(255);
        case StencilOp::kDecrementWrap:
            return (old - I32x16(1)) & I32x16(255);
    }
    return old;
}

TERRAZZO_NOINLINE void update_stencil(StencilOp op, I32x16 old, const StencilFace& face, uint32_t mask,
                                      uint8_t* to) {
    if (op == StencilOp::kKeep || mask == 0) return;
    const I32x16 writable(face.write_mask);
    const I32x16 value = (apply(op, old, face) & writable) | (old & (writable ^ I32x16(255)));
    // What others of the tile's pixels have become meanwhile stays.
    store_bytes(select(mask_from_bits(mask), value, load_bytes(to)), to);
}

// Returns the bits of `mask` whose fragments pass both tests.
template <class Key>
TERRAZZO_INLINE uint32_t depth_stencil_test(Key key, const FragmentState& state, int depth_bits,
                                            const Primitive& primitive, const Interpolator& at,
                                            const Bin& bin, int tile, uint32_t mask) {
    const FragmentKey& k = key.value;
    uint8_t* const stencil = k.stencil_test ? bin.stencil + tile * kTilePixels : nullptr;
    const StencilFace& face = state.stencil[primitive.back_facing ? 1 : 0];
    I32x16 old_stencil(0);
    if (k.stencil_test) {
        old_stencil = load_bytes(stencil);
        const I32x16 relevant(face.compare_mask);
        const uint32_t pass =
            bits_of(compare(face.func, I32x16(face.reference) & relevant, old_stencil & relevant)) & mask;
        update_stencil(face.fail, old_stencil, face, mask & ~pass, stencil);
        mask = pass;
        if (mask == 0) return 0;
    }
    if (k.depth_test) {
        I32x16 depth(0);
        if (k.image == PixelImage::kDepth) {
            depth = load(at.image_tile<uint32_t, 16>(primitive));
        } else {
            F32x16 z = at.depth();
            if (k.depth_offset) z = z + F32x16(primitive.depth_offset);
            if (k.depth_clamp) z = clamp(z, F32x16(state.depth_range[0]), F32x16(state.depth_range[1]));
            depth = quantize_depth(z, depth_bits);
        }
        uint32_t* const stored = bin.depth + tile * kTilePixels;
        const uint32_t pass = bits_of(compare(k.depth_func, depth, load(stored))) & mask;
        if (k.stencil_test) update_stencil(face.depth_fail, old_stencil, face, mask & ~pass, stencil);
        mask = pass;
        if (mask == 0) return 0;
        if (k.depth_write) store_masked(mask_from_bits(mask), depth, stored);
    }
    if (k.stencil_test) update_stencil(face.pass, old_stencil, face, mask, stencil);
    return mask;
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
