// The end of a fragment: blending or logic op, the colour mask, and the store into the tile in its format.
#pragma once

#include "raster/pixel/blend.h"
#include "raster/target.h"

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
    if (mask == 0xffff) {
        store(packed, pixels);
    } else {
        store_masked(mask_from_bits(mask), packed, pixels);
    }
}

template <class Key>
TERRAZZO_INLINE void write_rgba8(Key key, const FragmentState& state, const Color& color, uint32_t mask,
                                 std::byte* tile) {
    const FragmentKey& k = key.value;
    uint32_t* const pixels = reinterpret_cast<uint32_t*>(tile);
    Color8 c{to_unorm8(color.r), to_unorm8(color.g), to_unorm8(color.b), to_unorm8(color.a)};
    const bool reads = k.blend != BlendKind::kNone || k.logic_op || k.color_mask != 0xf;
    const I32x16 old = reads ? load(pixels) : I32x16(0);
    if (k.blend != BlendKind::kNone) {
        Color8 d = unpack_rgba8(old);
        if (!state.has_destination_alpha) d.a = I32x16(255);
        const BlendInput<Channel8> in{{c.r, c.g, c.b, c.a}, {d.r, d.g, d.b, d.a}};
        I32x16 out[4];
        if (k.blend == BlendKind::kAlpha) {
            blend_alpha(in, out);
        } else if (k.blend == BlendKind::kAdditive) {
            blend_additive(in, out);
        } else {
            blend_general<Channel8>(state, in, out);
        }
        c = {out[0], out[1], out[2], out[3]};
    }
    I32x16 packed = pack_rgba8(c);
    if (k.logic_op) packed = apply_logic_op(state.logic_op, packed, old);
    if (k.color_mask != 0xf) {
        const I32x16 writable(byte_mask(k.color_mask));
        packed = (packed & writable) | (old & (writable ^ I32x16(-1)));
    }
    store_pixels(packed, mask, pixels);
}

// Pixels that need no more than to be stored.
TERRAZZO_INLINE void write_packed_rgba8(I32x16 packed, uint32_t mask, Bin& bin, int tile) {
    store_pixels(packed, mask, reinterpret_cast<uint32_t*>(bin.color) + tile * kTilePixels);
}

// The formats no hot path uses: a pixel's channels as floats in memory, blended as floats.
struct TileColors {
    alignas(64) float channel[4][16];
};
inline void decode_tile(ColorFormat format, const std::byte* tile, TileColors& out) {
    for (int i = 0; i < 16; ++i) {
        if (format == ColorFormat::kRgb565) {
            uint16_t v;
            std::memcpy(&v, tile + i * 2, sizeof v);
            out.channel[0][i] = static_cast<float>(v >> 11) * (1.0f / 31.0f);
            out.channel[1][i] = static_cast<float>(v >> 5 & 63) * (1.0f / 63.0f);
            out.channel[2][i] = static_cast<float>(v & 31) * (1.0f / 31.0f);
            out.channel[3][i] = 1.0f;
        } else if (format == ColorFormat::kRgba16) {
            uint16_t v[4];
            std::memcpy(v, tile + i * 8, sizeof v);
            for (int c = 0; c < 4; ++c) out.channel[c][i] = static_cast<float>(v[c]) * (1.0f / 65535.0f);
        } else {
            float v[4];
            std::memcpy(v, tile + i * 16, sizeof v);
            for (int c = 0; c < 4; ++c) out.channel[c][i] = v[c];
        }
    }
}

// Channel maxima of the integer formats.
struct ChannelLimits {
    float maximum[4];
};
inline ChannelLimits channel_limits(ColorFormat format) {
    if (format == ColorFormat::kRgb565) return {{31, 63, 31, 1}};
    return {{65535, 65535, 65535, 65535}};
}

inline void encode_pixel(ColorFormat format, const int32_t (&v)[4], std::byte* out) {
    if (format == ColorFormat::kRgb565) {
        const uint16_t packed = static_cast<uint16_t>(v[0] << 11 | v[1] << 5 | v[2]);
        std::memcpy(out, &packed, sizeof packed);
    } else {
        const uint16_t packed[4] = {static_cast<uint16_t>(v[0]), static_cast<uint16_t>(v[1]),
                                    static_cast<uint16_t>(v[2]), static_cast<uint16_t>(v[3])};
        std::memcpy(out, packed, sizeof packed);
    }
}

template <class Key>
TERRAZZO_NOINLINE void write_other_format(Key key, const FragmentState& state, const Color& color,
                                          uint32_t mask, std::byte* tile) {
    const FragmentKey& k = key.value;
    const bool is_float = k.color_format == ColorFormat::kRgba32F;
    const ChannelLimits limits = channel_limits(k.color_format);
    TileColors old;
    decode_tile(k.color_format, tile, old);
    BlendInput<ChannelF> in;
    const F32x16 source[4] = {color.r, color.g, color.b, color.a};
    for (int c = 0; c < 4; ++c) {
        in.source[c] = is_float ? source[c] : clamp(source[c], F32x16(0.0f), F32x16(1.0f));
        in.destination[c] = load(old.channel[c]);
    }
    if (!state.has_destination_alpha) in.destination[3] = F32x16(1.0f);
    F32x16 out[4] = {in.source[0], in.source[1], in.source[2], in.source[3]};
    if (k.blend != BlendKind::kNone) blend_general<ChannelF>(state, in, out);

    const int stride = bytes_per_pixel(k.color_format);
    alignas(64) float floats[4][16];
    alignas(64) int32_t integers[4][16];
    for (int c = 0; c < 4; ++c) {
        if (is_float) {
            store(out[c], floats[c]);
            continue;
        }
        I32x16 v = to_unorm(out[c], limits.maximum[c]);
        if (k.logic_op) {
            const I32x16 bits(static_cast<int32_t>(limits.maximum[c]));
            v = apply_logic_op(state.logic_op, v, to_unorm(in.destination[c], limits.maximum[c])) & bits;
        }
        store(v, integers[c]);
    }
    for (int i = 0; i < 16; ++i) {
        if (!(mask >> i & 1)) continue;
        std::byte* const pixel = tile + i * stride;
        if (is_float) {
            float v[4];
            for (int c = 0; c < 4; ++c) v[c] = k.color_mask >> c & 1 ? floats[c][i] : old.channel[c][i];
            std::memcpy(pixel, v, sizeof v);
        } else {
            int32_t v[4];
            for (int c = 0; c < 4; ++c)
                v[c] = k.color_mask >> c & 1
                           ? integers[c][i]
                           : static_cast<int32_t>(old.channel[c][i] * limits.maximum[c] + 0.5f);
            encode_pixel(k.color_format, v, pixel);
        }
    }
}

template <class Key>
TERRAZZO_INLINE void write_color(Key key, const FragmentState& state, const Color& color, uint32_t mask,
                                 Bin& bin, int tile) {
    const FragmentKey& k = key.value;
    if (k.color_mask == 0) return;
    std::byte* const pixels = bin.color + static_cast<size_t>(tile) * kTilePixels *
                                              static_cast<size_t>(bytes_per_pixel(k.color_format));
    if (k.color_format == ColorFormat::kRgba8) {
        write_rgba8(key, state, color, mask, pixels);
    } else {
        write_other_format(key, state, color, mask, pixels);
    }
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
