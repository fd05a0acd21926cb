// Where a filter finds its texels: 8-bit textures whose coordinates repeat or are clamped to the edge, in the
// reference's fixed point (pixel/sample.h). Addresses and weights are worked out for a whole batch before the
// first texel is fetched, so that no load waits for its address.
#pragma once

#include "raster/batch.h"
#include "raster/sample/filter.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

// Along one axis: the first of two neighbouring texels, the one after it, the weight of that in 256ths, and
// where the two are the last and the first of a row.
struct PairAxis {
    I32x16 first, next, weight;
    Mask16 wraps;
};

// `first_period`: as in_sub_texels has it.
TERRAZZO_INLINE PairAxis pair_axis(Wrap wrap, bool first_period, F32x16 coordinate, int32_t size) {
    const I32x16 u = round_to_int(in_sub_texels(first_period, coordinate, size)) - I32x16(128);
    const I32x16 i = shift_right<8>(u), last(size - 1);
    PairAxis axis;
    axis.weight = u & I32x16(255);
    if (wrap == Wrap::kRepeat) {
        axis.first = first_period ? select(i < I32x16(0), i + I32x16(size), i) : i & last;
        axis.wraps = axis.first == last;
        axis.next = select(axis.wraps, I32x16(0), axis.first + I32x16(1));
    } else {
        // Beyond the edge both are the texel at the edge: the second has no weight, whatever it is.
        axis.weight = select((i < I32x16(0)) | (i >= last), I32x16(0), axis.weight);
        axis.first = clamp(i, I32x16(0), last);
        axis.next = clamp(i + I32x16(1), I32x16(0), last);
        axis.wraps = mask_from_bits(0);
    }
    return axis;
}

// Where the index of a repeating coordinate cannot be masked. Of two repeating axes both are masked, or none.
struct Periods {
    bool s, t;

    TERRAZZO_INLINE Periods(const Sampler& sampler, const MipLevel& level) {
        const bool s_repeats = sampler.wrap_s == Wrap::kRepeat,
                   t_repeats = sampler.dimensions > 1 && sampler.wrap_t == Wrap::kRepeat;
        const bool s_masks = is_power_of_two(level.width), t_masks = is_power_of_two(level.height);
        s = s_repeats && !(s_masks && (!t_repeats || t_masks));
        t = t_repeats && !(t_masks && (!s_repeats || s_masks));
    }
};

TERRAZZO_INLINE void store_footprint(const MipLevel& level, const PairAxis& x, I32x16 y, I32x16 next_y,
                                     I32x16 y_weight, Batch::Footprint& to) {
    const I32x16 pitch(level.pitch);
    store(multiply_small(y, pitch) + x.first, to.low);
    store(multiply_small(next_y, pitch) + x.first, to.high);
    store(shift_left<7>(x.weight) | shift_left<23>(y_weight), to.weights);
    to.base = static_cast<const int32_t*>(level.texels);
    to.wraps = static_cast<uint16_t>(bits_of(x.wraps));
    to.wrap_step = 1 - level.width;
}

// LINEAR, of one or two dimensions.
TERRAZZO_INLINE void linear_footprint(const Sampler& sampler, const MipLevel& level, F32x16 s, F32x16 t,
                                      Batch::Footprint& to) {
    const Periods periods(sampler, level);
    const PairAxis x = pair_axis(sampler.wrap_s, periods.s, s, level.width);
    if (sampler.dimensions == 1) return store_footprint(level, x, I32x16(0), I32x16(0), I32x16(0), to);
    const PairAxis y = pair_axis(sampler.wrap_t, periods.t, t, level.height);
    store_footprint(level, x, y.first, y.next, y.weight, to);
}

// The same where both axes repeat and have sizes that are powers of two: most textures.
TERRAZZO_INLINE void masked_footprint(const MipLevel& level, F32x16 s, F32x16 t, Batch::Footprint& to) {
    const PairAxis x = pair_axis(Wrap::kRepeat, false, s, level.width);
    const PairAxis y = pair_axis(Wrap::kRepeat, false, t, level.height);
    const I32x16 next = (y.first + I32x16(1)) & I32x16(level.height - 1);
    store_footprint(level, x, y.first, next, y.weight, to);
}
TERRAZZO_INLINE bool is_masked(const Sampler& sampler) {
    return sampler.dimensions == 2 && sampler.wrap_s == Wrap::kRepeat && sampler.wrap_t == Wrap::kRepeat &&
           is_power_of_two(sampler.levels[0].width) && is_power_of_two(sampler.levels[0].height);
}

// NEAREST: the only texel is the first one.
TERRAZZO_INLINE void nearest_footprint(const Sampler& sampler, const MipLevel& level, F32x16 s, F32x16 t,
                                       Batch::Footprint& to) {
    const FixedAxis x = fixed_axis(sampler.wrap_s, Filter::kNearest, s, level.width);
    I32x16 index = x.first;
    if (sampler.dimensions > 1) {
        const FixedAxis y = fixed_axis(sampler.wrap_t, Filter::kNearest, t, level.height);
        index = index + multiply_small(y.first, I32x16(level.pitch));
    }
    store(index, to.low);
    to.base = static_cast<const int32_t*>(level.texels);
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
