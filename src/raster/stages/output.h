// The last stage of a batch: alpha test, the depth and stencil tests that have to wait for it, blending,
// logic op, colour mask and the store, entry after entry (GL 1.5 §4.1).
#pragma once

#include "raster/pixel/key.h"
#include "raster/pixel/write.h"
#include "raster/stages/test.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

// The colours that arrive: those of the stage before, or texels as they are.
TERRAZZO_INLINE const Batch::Words* source_pixels(const FragmentState& state, Batch& batch) {
    if (!state.stages.shows_texels) return batch.colors;
    return reinterpret_cast<const Batch::Words*>(texels_of(state, state.textures[0], batch, 0));
}

TERRAZZO_INLINE Mask16 alpha_passes(Compare func, I32x16 packed, I32x16 reference) {
    return compare(func, shift_right_logical<24>(packed), reference);
}

// RGBA8, every channel written, and nothing after the depth test but this.
template <bool kAlphaTest, BlendKind kBlend>
void rgba8_output_stage(const FragmentState& state, Bin& bin, Batch& batch) {
    const Batch::Words* const source = source_pixels(state, batch);
    uint32_t* const plane = reinterpret_cast<uint32_t*>(bin.color);
    const I32x16 reference = to_unorm8(F32x16(state.alpha_reference));
    const Compare func = state.key.alpha_func;
    const I32x16 opaque(state.has_destination_alpha ? 0 : kAlphaByte);
    for (int i = 0; i < batch.count; ++i) {
        I32x16 pixels = load(source[i]);
        uint32_t mask = batch.masks[i];
        if (kAlphaTest) {
            mask &= bits_of(alpha_passes(func, pixels, reference));
            batch.masks[i] = static_cast<uint16_t>(mask);
        }
        uint32_t* const stored = plane + batch.tiles[i] * kTilePixels;
        if (kBlend == BlendKind::kAlpha) pixels = mix_by_alpha(pixels, load(stored) | opaque);
        if (kBlend == BlendKind::kAdditive) pixels = add_bytes(pixels, load(stored) | opaque);
        store_pixels(pixels, mask, stored);
    }
}

TERRAZZO_INLINE I32x16 load_pixels(ColorFormat format, const std::byte* pixels) {
    return format == ColorFormat::kRgba8 ? load(reinterpret_cast<const uint32_t*>(pixels))
                                         : load_rgb565(pixels);
}

// Any state of a buffer with eight bits a channel, chosen as it runs.
class PackedOutput {
  public:
    TERRAZZO_INLINE PackedOutput(const FragmentState& state, Batch& batch)
        : m_state(state),
          m_batch(batch),
          m_source(source_pixels(state, batch)),
          m_reference(to_unorm8(F32x16(state.alpha_reference))),
          m_constant(quantize_rgba8(uniform_color(state.blend_color))),
          m_opaque(state.has_destination_alpha ? 0 : kAlphaByte),
          m_writable(byte_mask(state.key.color_mask)) {}

    // The pixels that pass the alpha test: compared in eight bits where the buffer has eight bits of alpha.
    TERRAZZO_INLINE uint32_t passing(int entry) const {
        const FragmentKey& k = m_state.key;
        if (k.color_format == ColorFormat::kRgba8)
            return bits_of(alpha_passes(k.alpha_func, load(m_source[entry]), m_reference));
        return bits_of(compare(k.alpha_func, load(m_batch.alphas()[entry]), F32x16(m_state.alpha_reference)));
    }
    TERRAZZO_INLINE void write(int entry, uint32_t mask, const Bin& bin, int tile) const {
        const FragmentKey& k = m_state.key;
        I32x16 pixels = load(m_source[entry]);
        std::byte* const to = bin.color + static_cast<size_t>(tile) * kTilePixels *
                                              static_cast<size_t>(bytes_per_pixel(k.color_format));
        const I32x16 old = load_pixels(k.color_format, to);
        if (k.blend != BlendKind::kNone) pixels = blend_packed(m_state, {pixels, old | m_opaque, m_constant});
        if (k.logic_op) pixels = apply_logic_op(m_state.logic_op, pixels, old);
        pixels = (pixels & m_writable) | (old & (m_writable ^ I32x16(-1)));
        if (k.color_format == ColorFormat::kRgba8) {
            store_pixels(pixels, mask, reinterpret_cast<uint32_t*>(to));
        } else {
            store_rgb565(pixels, mask, to);
        }
    }
    // Where nothing is read and all of a pixel written: what goes there.
    TERRAZZO_INLINE bool stores_only() const {
        const FragmentKey& k = m_state.key;
        return k.color_format == ColorFormat::kRgba8 && k.blend == BlendKind::kNone && !k.logic_op &&
               k.color_mask == 0xf;
    }
    TERRAZZO_INLINE I32x16 pixels(int entry) const { return load(m_source[entry]); }

  private:
    const FragmentState& m_state;
    Batch& m_batch;
    const Batch::Words* m_source;
    I32x16 m_reference, m_constant, m_opaque, m_writable;
};

// The same of 16 bits or a float a channel.
class WideOutput {
  public:
    TERRAZZO_INLINE WideOutput(const FragmentState& state, Batch& batch) : m_state(state), m_batch(batch) {}

    TERRAZZO_INLINE uint32_t passing(int entry) const {
        const F32x16 alpha = load(m_batch.wide_colors[entry][3]);
        return bits_of(compare(m_state.key.alpha_func, alpha, F32x16(m_state.alpha_reference)));
    }
    TERRAZZO_INLINE void write(int entry, uint32_t mask, const Bin& bin, int tile) const {
        const auto& c = m_batch.wide_colors[entry];
        write_color(RuntimeKey{m_state.key}, m_state, {load(c[0]), load(c[1]), load(c[2]), load(c[3])}, mask,
                    bin, tile);
    }
    static constexpr bool stores_only() { return false; }
    static TERRAZZO_INLINE I32x16 pixels(int) { return I32x16(0); }

  private:
    const FragmentState& m_state;
    Batch& m_batch;
};

template <class Output>
void general_output_stage(const FragmentState& state, Bin& bin, Batch& batch) {
    const FragmentKey& k = state.key;
    const RuntimeKey key{k};
    const Output output(state, batch);
    const bool late = !tests_early(k) && (k.depth_test || k.stencil_test);
    for (int i = 0; i < batch.count; ++i) {
        uint32_t mask = batch.masks[i];
        const int tile = batch.tiles[i];
        if (k.alpha_func != Compare::kAlways) mask &= output.passing(i);
        if (late && mask != 0)
            mask = depth_stencil_test(key, state, state.depth_bits, *batch.primitives[i],
                                      planes_of(batch, bin, i), bin, tile, mask);
        batch.masks[i] = static_cast<uint16_t>(mask);
        if (mask != 0 && k.color_mask != 0) output.write(i, mask, bin, tile);
    }
}

TERRAZZO_INLINE Stage choose_output_stage(const FragmentState& state) {
    const FragmentKey& k = state.key;
    if (has_wide_channels(k.color_format)) return general_output_stage<WideOutput>;
    const bool tests_late = !tests_early(k) && (k.depth_test || k.stencil_test);
    if (k.color_format != ColorFormat::kRgba8 || k.color_mask != 0xf || k.logic_op || tests_late)
        return general_output_stage<PackedOutput>;
    const bool alpha = k.alpha_func != Compare::kAlways;
    switch (k.blend) {
        case BlendKind::kNone:
            return alpha ? rgba8_output_stage<true, BlendKind::kNone>
                         : rgba8_output_stage<false, BlendKind::kNone>;
        case BlendKind::kAlpha:
            return alpha ? rgba8_output_stage<true, BlendKind::kAlpha>
                         : rgba8_output_stage<false, BlendKind::kAlpha>;
        case BlendKind::kAdditive:
            return alpha ? rgba8_output_stage<true, BlendKind::kAdditive>
                         : rgba8_output_stage<false, BlendKind::kAdditive>;
        case BlendKind::kGeneral:
            break;
    }
    return general_output_stage<PackedOutput>;
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
