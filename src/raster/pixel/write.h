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

// Whether every channel is known to lie in [0, 1]: a clamped constant, as it is or times a texel.
template <class Key>
TERRAZZO_INLINE bool is_bounded(Key key) {
    const FragmentKey& k = key.value;
    return !k.interpolated_color && !k.separate_specular && k.fog == FogMode::kNone &&
           k.texture != TextureKind::kGeneral;
}

template <class Key>
TERRAZZO_INLINE I32x16 quantize(Key key, F32x16 f) {
    return is_bounded(key) ? round_to_int(f * F32x16(255.0f)) : to_unorm8(f);
}

// What an RGBA8 pixel that holds `old` is to hold; `old` is looked at only where the state makes it matter.
template <class Key>
TERRAZZO_INLINE I32x16 finish_rgba8(Key key, const FragmentState& state, const Color& color, I32x16 old) {
    const FragmentKey& k = key.value;
    Color8 c{quantize(key, color.r), quantize(key, color.g), quantize(key, color.b), quantize(key, color.a)};
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
TERRAZZO_INLINE void write_packed_rgba8(I32x16 packed, uint32_t mask, Bin& bin, int tile) {
    store_pixels(packed, mask, reinterpret_cast<uint32_t*>(bin.color) + tile * kTilePixels);
}

// The formats no hot path uses: a pixel's channels as floats in memory, blended as floats.
struct TileColors {
    alignas(64) float channel[4][16];
};
inline void decode_tile(ColorFormat format, const std::byte* tile, TileColors& out) {
    for (int i = 0; i < 16; ++i) {
        if (format == ColorFormat::kRgba16) {
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

// 5-6-5 pixels live as eight bits a channel while they are worked on: widened by repeating their top bits,
// cut off again at the end (doc/reference.md §4).
inline I32x16 load_rgb565(const std::byte* tile) {
    alignas(64) uint32_t wide[16];
    for (int i = 0; i < 16; ++i) {
        uint16_t v;
        std::memcpy(&v, tile + i * 2, sizeof v);
        const uint32_t r = v >> 11, g = v >> 5 & 63, b = v & 31;
        wide[i] = (r << 3 | r >> 2) | (g << 2 | g >> 4) << 8 | (b << 3 | b >> 2) << 16 | 0xff000000u;
    }
    return load(wide);
}

template <class Key>
TERRAZZO_NOINLINE void write_rgb565(Key key, const FragmentState& state, const Color& color, uint32_t mask,
                                    std::byte* tile) {
    alignas(64) uint32_t pixels[16];
    store(finish_rgba8(key, state, color, load_rgb565(tile)), pixels);
    for (int i = 0; i < 16; ++i) {
        if (!(mask >> i & 1)) continue;
        const uint32_t p = pixels[i];
        const uint16_t packed =
            static_cast<uint16_t>((p >> 3 & 31) << 11 | (p >> 10 & 63) << 5 | (p >> 19 & 31));
        std::memcpy(tile + i * 2, &packed, sizeof packed);
    }
}

// Sixteen bits or a float a channel, blended as floats.
template <class Key>
TERRAZZO_NOINLINE void write_wide_format(Key key, const FragmentState& state, const Color& color,
                                         uint32_t mask, std::byte* tile) {
    constexpr float kMaximum = 65535.0f;
    const FragmentKey& k = key.value;
    const bool is_float = k.color_format == ColorFormat::kRgba32F;
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
    for (int c = 0; c < 4; ++c) {
        if (!(k.color_mask >> c & 1)) continue;
        alignas(64) float floats[16];
        alignas(64) int32_t integers[16];
        store(out[c], floats);
        I32x16 v = to_unorm(out[c], kMaximum);
        if (k.logic_op)
            v = apply_logic_op(state.logic_op, v, to_unorm(in.destination[c], kMaximum)) & I32x16(65535);
        store(v, integers);
        for (int i = 0; i < 16; ++i) {
            if (!(mask >> i & 1)) continue;
            if (is_float) {
                std::memcpy(tile + i * 16 + c * 4, &floats[i], sizeof(float));
            } else {
                const uint16_t value = static_cast<uint16_t>(integers[i]);
                std::memcpy(tile + i * 8 + c * 2, &value, sizeof value);
            }
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
    } else if (k.color_format == ColorFormat::kRgb565) {
        write_rgb565(key, state, color, mask, pixels);
    } else {
        write_wide_format(key, state, color, mask, pixels);
    }
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
