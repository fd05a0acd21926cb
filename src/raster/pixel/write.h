// The end of a fragment: blending or logic op, the colour mask, and the store into the tile in its format.
#pragma once

#include "raster/pixel/blend.h"
#include "raster/pixel/blend_packed.h"
#include "raster/target/target.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

// Each bit of the result from the bits of s and d by the operation's truth table (GL 1.5 table 4.2).
TERRAZZO_INLINE I32x16 apply_logic_op(LogicOp op, I32x16 s, I32x16 d) {
    const I32x16 ones(-1);
    I32x16 r(0);
    if (op & 1) r = r | ((s ^ ones) & (d ^ ones));
    if (op & 2) r = r | ((s ^ ones) & d);
    if (op & 4) r = r | (s & (d ^ ones));
    if (op & 8) r = r | (s & d);
    return r;
}

// Expands the four bits of a colour mask to the bytes of a packed RGBA8 pixel.
TERRAZZO_INLINE int32_t byte_mask(uint32_t color_mask) {
    return static_cast<int32_t>(((color_mask & 1) * 0xffu) | ((color_mask >> 1 & 1) * 0xff00u) |
                                ((color_mask >> 2 & 1) * 0xff0000u) | ((color_mask >> 3 & 1) * 0xff000000u));
}

TERRAZZO_INLINE void store_pixels(I32x16 packed, uint32_t mask, uint32_t* pixels) {
    // Where a masked store is as fast, a branch that nobody can predict would only cost.
    if (!kMasksAreRegisters && mask == 0xffff) {
        store(packed, pixels);
    } else {
        store_masked(mask_from_bits(mask), packed, pixels);
    }
}

// What an RGBA8 pixel that holds `old` is to hold; `old` is looked at only where the state makes it matter.
template <class Key>
TERRAZZO_INLINE I32x16 finish_rgba8(Key key, const FragmentState& state, const Color& color, I32x16 old) {
    const FragmentKey& k = key.value;
    I32x16 packed = quantize_rgba8(color);
    if (k.blend != BlendKind::kNone) {
        const I32x16 there = state.has_destination_alpha ? old : old | I32x16(kAlphaByte);
        if (k.blend == BlendKind::kAlpha) {
            packed = mix_by_alpha(packed, there);
        } else if (k.blend == BlendKind::kAdditive) {
            packed = add_bytes(packed, there);
        } else {
            packed = blend_packed(state, {packed, there, quantize_rgba8(uniform_color(state.blend_color))});
        }
    }
    if (k.logic_op) packed = apply_logic_op(state.logic_op, packed, old);
    if (k.color_mask != 0xf) {
        const I32x16 writable(byte_mask(k.color_mask));
        packed = (packed & writable) | (old & (writable ^ I32x16(-1)));
    }
    return packed;
}

template <class Key>
TERRAZZO_INLINE void write_rgba8(Key key, const FragmentState& state, const Color& color, uint32_t mask,
                                 std::byte* tile) {
    const FragmentKey& k = key.value;
    uint32_t* const pixels = reinterpret_cast<uint32_t*>(tile);
    const bool reads = k.blend != BlendKind::kNone || k.logic_op || k.color_mask != 0xf;
    store_pixels(finish_rgba8(key, state, color, reads ? load(pixels) : I32x16(0)), mask, pixels);
}

// Pixels that need no more than to be stored.
TERRAZZO_INLINE void write_packed_rgba8(I32x16 packed, uint32_t mask, const Bin& bin, int tile) {
    store_pixels(packed, mask, reinterpret_cast<uint32_t*>(bin.color) + tile * kTilePixels);
}

// 5-6-5 pixels live as eight bits a channel while they are worked on: widened by repeating their top bits,
// cut off again at the end (doc/reference.md §4).
TERRAZZO_INLINE I32x16 load_rgb565(const std::byte* tile) {
    const I32x16 v = load_shorts(reinterpret_cast<const uint16_t*>(tile));
    const I32x16 r = shift_right_logical<11>(v), g = shift_right_logical<5>(v) & I32x16(63),
                 b = v & I32x16(31);
    return shift_left<3>(r) | shift_right_logical<2>(r) | shift_left<10>(g) |
           (shift_left<4>(g) & I32x16(0x300)) | shift_left<19>(b) | (shift_left<14>(b) & I32x16(0x70000)) |
           I32x16(static_cast<int32_t>(0xff000000u));
}
TERRAZZO_INLINE void store_rgb565(I32x16 pixels, uint32_t mask, std::byte* tile) {
    uint16_t* const to = reinterpret_cast<uint16_t*>(tile);
    const I32x16 packed = (shift_left<8>(pixels) & I32x16(0xf800)) |
                          (shift_right_logical<5>(pixels) & I32x16(0x7e0)) |
                          (shift_right_logical<19>(pixels) & I32x16(0x1f));
    store_shorts(select(mask_from_bits(mask), packed, load_shorts(to)), to);
}

template <class Key>
TERRAZZO_NOINLINE void write_rgb565(Key key, const FragmentState& state, const Color& color, uint32_t mask,
                                    std::byte* tile) {
    store_rgb565(finish_rgba8(key, state, color, load_rgb565(tile)), mask, tile);
}

// What is to be stored of a tile whose pixels have four wide channels: the new ones where the masks have
// them.
template <class Channel>
TERRAZZO_INLINE void keep_unwritten(uint32_t mask, uint32_t color_mask, const Channel (&old)[4],
                                    Channel (&out)[4]) {
    const Mask16 pixels = mask_from_bits(mask);
    for (int c = 0; c < 4; ++c) out[c] = color_mask >> c & 1 ? select(pixels, out[c], old[c]) : old[c];
}

template <class Key>
TERRAZZO_NOINLINE void write_rgba16(Key key, const FragmentState& state, const Color& color, uint32_t mask,
                                    std::byte* tile) {
    const FragmentKey& k = key.value;
    uint16_t* const stored = reinterpret_cast<uint16_t*>(tile);
    I32x16 old[4];
    load_channels(stored, old);
    BlendInput<Channel16> in;
    const F32x16 source[4] = {color.r, color.g, color.b, color.a};
    for (int c = 0; c < 4; ++c) {
        in.source[c] = to_unorm(source[c], 65535.0f);
        in.destination[c] = old[c];
    }
    if (!state.has_destination_alpha) in.destination[3] = Channel16::one();
    I32x16 out[4] = {in.source[0], in.source[1], in.source[2], in.source[3]};
    if (k.blend != BlendKind::kNone) blend_general<Channel16>(state, in, out);
    if (k.logic_op)
        for (int c = 0; c < 4; ++c)
            out[c] = apply_logic_op(state.logic_op, out[c], in.destination[c]) & I32x16(65535);
    keep_unwritten(mask, k.color_mask, old, out);
    store_channels(out, stored);
}

template <class Key>
TERRAZZO_NOINLINE void write_rgba32f(Key key, const FragmentState& state, const Color& color, uint32_t mask,
                                     std::byte* tile) {
    const FragmentKey& k = key.value;
    float* const stored = reinterpret_cast<float*>(tile);
    F32x16 old[4];
    load_channels(stored, old);
    BlendInput<ChannelF> in{{color.r, color.g, color.b, color.a}, {old[0], old[1], old[2], old[3]}};
    if (!state.has_destination_alpha) in.destination[3] = ChannelF::one();
    F32x16 out[4] = {color.r, color.g, color.b, color.a};
    if (k.blend != BlendKind::kNone) blend_general<ChannelF>(state, in, out);
    keep_unwritten(mask, k.color_mask, old, out);
    store_channels(out, stored);
}

template <class Key>
TERRAZZO_INLINE void write_color(Key key, const FragmentState& state, const Color& color, uint32_t mask,
                                 const Bin& bin, int tile) {
    const FragmentKey& k = key.value;
    if (k.color_mask == 0) return;
    std::byte* const pixels = bin.color + static_cast<size_t>(tile) * kTilePixels *
                                              static_cast<size_t>(bytes_per_pixel(k.color_format));
    switch (k.color_format) {
        case ColorFormat::kRgba8:
            return write_rgba8(key, state, color, mask, pixels);
        case ColorFormat::kRgb565:
            return write_rgb565(key, state, color, mask, pixels);
        case ColorFormat::kRgba16:
            return write_rgba16(key, state, color, mask, pixels);
        case ColorFormat::kRgba32F:
            return write_rgba32f(key, state, color, mask, pixels);
    }
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
