// Texture sampling (GL 1.5 §3.8.7-§3.8.8): the filtered texel of 16 pixels.
//
// Eight-bit textures that repeat or clamp to their edge are sampled in fixed point as the reference does it:
// coordinates round(s * size * 256), weights of eight bits, each lerp rounded to eight bits, x before y
// before z. All others are sampled in floats. Cube maps: cube.h.
#pragma once

#include "raster/fragment_state.h"
#include "raster/pixel/color.h"
#include "raster/pixel/compare.h"
#include "raster/target/target.h"
#include "simd/math.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

// Texture coordinates, those that the texture has.
struct TexturePoint {
    F32x16 s, t, r;
};

// Two 16-bit numbers a lane: v0 + round(weight * (v1 - v0) / 256), both numbers of a lane with the lane's
// weight. `weight` holds weight * 128 twice a lane, 0 <= weight < 256.
TERRAZZO_INLINE NativeI lerp_native(NativeI v0, NativeI v1, NativeI weight) {
#if HWY_TARGET == HWY_SCALAR
    const uint32_t a = static_cast<uint32_t>(hn::GetLane(v0)), b = static_cast<uint32_t>(hn::GetLane(v1));
    const int32_t w = hn::GetLane(weight) & 0xffff;
    uint32_t both = 0;
    for (int half = 0; half < 32; half += 16) {
        const int32_t low = static_cast<int32_t>(a >> half & 0xffff),
                      high = static_cast<int32_t>(b >> half & 0xffff);
        both |= static_cast<uint32_t>(low + ((w * (high - low) + 0x4000) >> 15)) << half;
    }
    return hn::Set(TagI(), static_cast<int32_t>(both));
#else
    using Tag16 = hn::Repartition<int16_t, TagI>;
    const auto a = hn::BitCast(Tag16(), v0), b = hn::BitCast(Tag16(), v1);
    const auto step = hn::MulFixedPoint15(hn::Sub(b, a), hn::BitCast(Tag16(), weight));
    return hn::BitCast(TagI(), hn::Add(a, step));
#endif
}
TERRAZZO_INLINE I32x16 lerp_pairs(I32x16 v0, I32x16 v1, I32x16 weight) {
    I32x16 r;
    TERRAZZO_FOR_PARTS r.part[p] = lerp_native(v0.part[p], v1.part[p], weight.part[p]);
    return r;
}

// The red and blue, and the green and alpha, of packed texels: two 16-bit numbers a lane.
struct TexelPairs {
    I32x16 rb, ga;
};
TERRAZZO_INLINE TexelPairs split_pairs(I32x16 packed) {
    const I32x16 even(0x00ff00ff);
    return {packed & even, shift_right_logical<8>(packed) & even};
}
TERRAZZO_INLINE TexelPairs lerp_pairs(TexelPairs a, TexelPairs b, I32x16 weight) {
    return {lerp_pairs(a.rb, b.rb, weight), lerp_pairs(a.ga, b.ga, weight)};
}
TERRAZZO_INLINE Color8 to_color8(TexelPairs t) {
    const I32x16 low(0xffff);
    return {t.rb & low, t.ga & low, shift_right_logical<16>(t.rb), shift_right_logical<16>(t.ga)};
}
// Eight-bit weights in the form lerp_pairs takes.
TERRAZZO_INLINE I32x16 pair_weights(I32x16 weight) {
    const I32x16 w = shift_left<7>(weight);
    return w | shift_left<16>(w);
}

TERRAZZO_INLINE bool is_power_of_two(int32_t n) {
    return (n & (n - 1)) == 0;
}

// One coordinate turned into the two texels it lies between, and the weight of the second in 256ths.
struct FixedAxis {
    I32x16 first, second, weight;
};

TERRAZZO_INLINE I32x16 wrap_index(Wrap wrap, I32x16 i, int32_t size) {
    if (wrap == Wrap::kRepeat) {
        if (is_power_of_two(size)) return i & I32x16(size - 1);
        // The coordinate was brought to [0, 1) already, so one period either way is enough.
        i = select(i < I32x16(0), i + I32x16(size), i);
        return select(i > I32x16(size - 1), i - I32x16(size), i);
    }
    return clamp(i, I32x16(0), I32x16(size - 1));
}

TERRAZZO_INLINE F32x16 bounded(F32x16 v, float limit) {
    return clamp(v, F32x16(-limit), F32x16(limit));
}

// A coordinate in 256ths of a texel, never NaN. Beyond 2^30 a repeating texture is noise and a clamped one is
// at its edge. Where the index cannot be masked, it is brought to the first period.
TERRAZZO_INLINE F32x16 in_sub_texels(bool first_period, F32x16 coordinate, int32_t size) {
    const float scale = static_cast<float>(size) * 256.0f;
    if (!first_period) return bounded(coordinate * F32x16(scale), 1073741824.0f);
    return clamp((coordinate - floor(coordinate)) * F32x16(scale), F32x16(0.0f), F32x16(scale));
}

TERRAZZO_INLINE FixedAxis fixed_axis(Wrap wrap, Filter filter, F32x16 coordinate, int32_t size) {
    F32x16 scaled = in_sub_texels(wrap == Wrap::kRepeat && !is_power_of_two(size), coordinate, size);
    FixedAxis axis;
    if (filter == Filter::kNearest) {
        axis.first = wrap_index(wrap, shift_right<8>(truncate_to_int(floor(scaled))), size);
        axis.second = axis.first;
        axis.weight = I32x16(0);
        return axis;
    }
    const I32x16 u = round_to_int(scaled) - I32x16(128);
    const I32x16 i = shift_right<8>(u);
    axis.weight = u & I32x16(255);
    axis.first = wrap_index(wrap, i, size);
    axis.second = wrap_index(wrap, i + I32x16(1), size);
    return axis;
}

TERRAZZO_INLINE I32x16 fetch_rgba8(const MipLevel& level, I32x16 x, I32x16 y) {
    return gather(static_cast<const int32_t*>(level.texels), y * I32x16(level.pitch) + x);
}

// Whether no lane wraps round or is clamped: the two columns are neighbours in memory, and one load gets
// both.
TERRAZZO_INLINE bool are_neighbours(const FixedAxis& x) {
    return bits_of(x.second == x.first + I32x16(1)) == 0xffff;
}
// The texels at columns x.first and x.second of a row, whose first texel each lane's `row` counts from the
// image's.
TERRAZZO_INLINE I32x16Pair fetch_neighbours(const MipLevel& level, const FixedAxis& x, I32x16 row,
                                            bool adjacent) {
    const int32_t* const texels = static_cast<const int32_t*>(level.texels);
    if (adjacent) return gather_pairs_from_memory(texels, row + x.first);
    return {gather(texels, row + x.first), gather(texels, row + x.second)};
}

// Fixed-point sampling of one level of an eight-bit 2D texture.
TERRAZZO_INLINE TexelPairs sample_fixed_2d(Wrap wrap_s, Wrap wrap_t, const MipLevel& level, Filter filter,
                                           F32x16 s, F32x16 t) {
    const FixedAxis x = fixed_axis(wrap_s, filter, s, level.width);
    const FixedAxis y = fixed_axis(wrap_t, filter, t, level.height);
    const I32x16 pitch(level.pitch);
    if (filter == Filter::kNearest)
        return split_pairs(
            gather(static_cast<const int32_t*>(level.texels), multiply_small(y.first, pitch) + x.first));
    const bool adjacent = are_neighbours(x);
    const I32x16Pair low = fetch_neighbours(level, x, multiply_small(y.first, pitch), adjacent);
    const I32x16Pair high = fetch_neighbours(level, x, multiply_small(y.second, pitch), adjacent);
    const I32x16 wx = pair_weights(x.weight);
    return lerp_pairs(lerp_pairs(split_pairs(low.first), split_pairs(low.second), wx),
                      lerp_pairs(split_pairs(high.first), split_pairs(high.second), wx),
                      pair_weights(y.weight));
}

// The same for one level that repeats both ways, LINEAR, for who samples a tile at a time; batches:
// stages/footprint.h.
class RepeatedBilinear {
  public:
    TERRAZZO_INLINE explicit RepeatedBilinear(const MipLevel& level)
        : m_level(level), m_masks_wrap(is_power_of_two(level.width) && is_power_of_two(level.height)) {}

    TERRAZZO_INLINE TexelPairs at(F32x16 s, F32x16 t) const {
        const I32x16 u = sub_texels(s, m_level.width), v = sub_texels(t, m_level.height);
        const I32x16 x = wrapped(shift_right<8>(u), m_level.width),
                     y = wrapped(shift_right<8>(v), m_level.height);
        const I32x16 last_x(m_level.width - 1), last_y(m_level.height - 1), pitch(m_level.pitch);
        const I32x16 next_y = select(y == last_y, I32x16(0), y + I32x16(1));
        const I32x16 low_row = multiply_small(y, pitch) + x, high_row = multiply_small(next_y, pitch) + x;
        // The second column is the next in memory, unless it is the row's first again.
        I32x16Pair low, high;
        if (!any(x == last_x)) {
            low = gather_pairs(texels(), low_row);
            high = gather_pairs(texels(), high_row);
        } else {
            const I32x16 step = select(x == last_x, I32x16(1 - m_level.width), I32x16(1));
            low = {gather(texels(), low_row), gather(texels(), low_row + step)};
            high = {gather(texels(), high_row), gather(texels(), high_row + step)};
        }
        const I32x16 wx = pair_weights(u & I32x16(255));
        return lerp_pairs(lerp_pairs(split_pairs(low.first), split_pairs(low.second), wx),
                          lerp_pairs(split_pairs(high.first), split_pairs(high.second), wx),
                          pair_weights(v & I32x16(255)));
    }

  private:
    // From the centre of the first texel.
    TERRAZZO_INLINE I32x16 sub_texels(F32x16 coordinate, int32_t size) const {
        return round_to_int(in_sub_texels(!m_masks_wrap, coordinate, size)) - I32x16(128);
    }
    // For sizes that are no powers of two, the coordinate is in [0, 1] already.
    TERRAZZO_INLINE I32x16 wrapped(I32x16 i, int32_t size) const {
        return m_masks_wrap ? i & I32x16(size - 1) : select(i < I32x16(0), i + I32x16(size), i);
    }
    const int32_t* texels() const { return static_cast<const int32_t*>(m_level.texels); }

    MipLevel m_level;
    bool m_masks_wrap;
};

// The same of one image of a 3D texture, which begins `slice` texels after the first.
TERRAZZO_INLINE TexelPairs sample_fixed_slice(const MipLevel& level, const FixedAxis& x, const FixedAxis& y,
                                              I32x16 slice, bool linear) {
    const I32x16 pitch(level.pitch), low_row = y.first * pitch + slice;
    if (!linear) return split_pairs(gather(static_cast<const int32_t*>(level.texels), low_row + x.first));
    const bool adjacent = are_neighbours(x);
    const I32x16 weight = pair_weights(x.weight);
    const auto mixed = [&](I32x16 row) TERRAZZO_INLINE_LAMBDA {
        const I32x16Pair pair = fetch_neighbours(level, x, row, adjacent);
        return lerp_pairs(split_pairs(pair.first), split_pairs(pair.second), weight);
    };
    return lerp_pairs(mixed(low_row), mixed(y.second * pitch + slice), pair_weights(y.weight));
}

TERRAZZO_NOINLINE TexelPairs sample_fixed_3d(const Sampler& sampler, const MipLevel& level, Filter filter,
                                             const TexturePoint& at) {
    const FixedAxis x = fixed_axis(sampler.wrap_s, filter, at.s, level.width);
    const FixedAxis y = fixed_axis(sampler.wrap_t, filter, at.t, level.height);
    const FixedAxis z = fixed_axis(sampler.wrap_r, filter, at.r, level.depth);
    const bool linear = filter == Filter::kLinear;
    const I32x16 slice(level.slice);
    const TexelPairs first = sample_fixed_slice(level, x, y, z.first * slice, linear);
    if (!linear) return first;
    return lerp_pairs(first, sample_fixed_slice(level, x, y, z.second * slice, linear),
                      pair_weights(z.weight));
}

TERRAZZO_INLINE TexelPairs sample_fixed(const Sampler& sampler, const MipLevel& level, Filter filter,
                                        const TexturePoint& at) {
    if (sampler.dimensions == 2) {
        const bool repeats = sampler.wrap_s == Wrap::kRepeat && sampler.wrap_t == Wrap::kRepeat;
        if (repeats && filter == Filter::kLinear) return RepeatedBilinear(level).at(at.s, at.t);
        return sample_fixed_2d(sampler.wrap_s, sampler.wrap_t, level, filter, at.s, at.t);
    }
    if (sampler.dimensions == 3) return sample_fixed_3d(sampler, level, filter, at);
    const FixedAxis x = fixed_axis(sampler.wrap_s, filter, at.s, level.width);
    const I32x16 row(0);
    const TexelPairs first = split_pairs(fetch_rgba8(level, x.first, row));
    if (filter == Filter::kNearest) return first;
    return lerp_pairs(first, split_pairs(fetch_rgba8(level, x.second, row)), pair_weights(x.weight));
}

// The same for everything else: floats, and texels outside the image take the border colour.
struct FloatAxis {
    I32x16 first, second;
    Mask16 first_inside, second_inside;
    F32x16 weight;
};

TERRAZZO_INLINE FloatAxis float_axis(Wrap wrap, Filter filter, F32x16 coordinate, int32_t size) {
    const float length = static_cast<float>(size);
    if (wrap == Wrap::kRepeat) {
        coordinate = coordinate - floor(coordinate);
    } else if (wrap == Wrap::kMirroredRepeat) {
        // Twice the distance from the nearest even number's half, without a rounding.
        const F32x16 half = coordinate * F32x16(0.5f);
        const F32x16 apart = half - to_float(round_to_int(bounded(half, 1073741824.0f)));
        coordinate = abs(apart + apart);
    } else if (wrap == Wrap::kClamp) {
        coordinate = clamp(coordinate, F32x16(0.0f), F32x16(1.0f));
    }
    F32x16 scaled = bounded(coordinate * F32x16(length), 16777216.0f);
    if (filter == Filter::kLinear) scaled = scaled - F32x16(0.5f);
    const F32x16 base = floor(scaled);
    FloatAxis axis;
    axis.weight = scaled - base;
    axis.first = truncate_to_int(base);
    axis.second = axis.first + I32x16(1);
    const bool border = wrap == Wrap::kClampToBorder || (wrap == Wrap::kClamp && filter == Filter::kLinear);
    const I32x16 last(size - 1);
    axis.first_inside = axis.second_inside = mask_from_bits(0xffff);
    if (border) {
        axis.first_inside = ~(axis.first < I32x16(0)) & ~(axis.first > last);
        axis.second_inside = ~(axis.second < I32x16(0)) & ~(axis.second > last);
    } else if (wrap == Wrap::kRepeat) {
        axis.first = select(axis.first < I32x16(0), last, axis.first);
        axis.second = select(axis.second > last, I32x16(0), axis.second);
    }
    axis.first = clamp(axis.first, I32x16(0), last);
    axis.second = clamp(axis.second, I32x16(0), last);
    return axis;
}

// An axis that a texture does not have.
TERRAZZO_INLINE FloatAxis no_axis() {
    return {I32x16(0), I32x16(0), mask_from_bits(0xffff), mask_from_bits(0xffff), F32x16(0.0f)};
}

// The texels at columns x.first and x.second of a row, whose first texel each lane's `row` counts from the
// level's.
TERRAZZO_INLINE I32x16Pair fetch_row_pair(const MipLevel& level, I32x16 row, const FloatAxis& x) {
    const int32_t* const texels = static_cast<const int32_t*>(level.texels);
    // Neighbours, but where coordinates wrap round or are clamped.
    if (!any(x.second != x.first + I32x16(1))) return gather_pairs_from_memory(texels, row + x.first);
    return {gather(texels, row + x.first), gather(texels, row + x.second)};
}

TERRAZZO_INLINE Color with_border(const Sampler& sampler, Mask16 inside, const Color& c) {
    const float* const b = sampler.border_color;
    return {select(inside, c.r, b[0]), select(inside, c.g, b[1]), select(inside, c.b, b[2]),
            select(inside, c.a, b[3])};
}

TERRAZZO_NOINLINE Color fetch_floats(const MipLevel& level, I32x16 index) {
    const F32x16Four four = gather_fours(static_cast<const float*>(level.texels), index);
    return {four.value[0], four.value[1], four.value[2], four.value[3]};
}

TERRAZZO_INLINE Color color_of_rgba8(I32x16 texel) {
    return from_color8(unpack_rgba8(texel));
}

// The texel `index` texels after the first.
TERRAZZO_INLINE Color fetch_float(const Sampler& sampler, const MipLevel& level, I32x16 index) {
    if (sampler.storage != TexelStorage::kRgba8) return fetch_floats(level, index);
    return color_of_rgba8(gather(static_cast<const int32_t*>(level.texels), index));
}

TERRAZZO_INLINE Color lerp(Color a, Color b, F32x16 t) {
    return {a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b), a.a + t * (b.a - a.a)};
}

// The two texels of a row mixed; those that are not `inside` the image in y and z, or not in x, are border.
template <bool kBorders>
TERRAZZO_INLINE Color mix_row(const Sampler& sampler, const MipLevel& level, const FloatAxis& x, I32x16 row,
                              Mask16 inside) {
    Color first, second;
    if (sampler.storage == TexelStorage::kRgba8) {
        const I32x16Pair pair = fetch_row_pair(level, row, x);
        first = color_of_rgba8(pair.first), second = color_of_rgba8(pair.second);
    } else {
        first = fetch_floats(level, row + x.first), second = fetch_floats(level, row + x.second);
    }
    if constexpr (kBorders) {
        first = with_border(sampler, x.first_inside & inside, first);
        second = with_border(sampler, x.second_inside & inside, second);
    }
    return lerp(first, second, x.weight);
}

// Of one image of a 3D texture, or the only one; it begins `slice` texels after the first.
template <bool kBorders>
TERRAZZO_INLINE Color sample_float_slice(const Sampler& sampler, const MipLevel& level, Filter filter,
                                         const FloatAxis& x, const FloatAxis& y, I32x16 slice,
                                         Mask16 slice_inside) {
    const I32x16 low_row = y.first * I32x16(level.pitch) + slice;
    const Mask16 low_inside = y.first_inside & slice_inside;
    if (filter == Filter::kNearest) {
        const Color texel = fetch_float(sampler, level, low_row + x.first);
        return kBorders ? with_border(sampler, x.first_inside & low_inside, texel) : texel;
    }
    const Color low = mix_row<kBorders>(sampler, level, x, low_row, low_inside);
    if (sampler.dimensions == 1) return low;
    const I32x16 high_row = y.second * I32x16(level.pitch) + slice;
    return lerp(low, mix_row<kBorders>(sampler, level, x, high_row, y.second_inside & slice_inside),
                y.weight);
}

TERRAZZO_INLINE Mask16 both_inside(const FloatAxis& axis) {
    return axis.first_inside & axis.second_inside;
}

#if HWY_TARGET != HWY_SCALAR
// The bilinear texels of an image all of whose texels are inside, pixel after pixel: the four channels of one
// are a vector, as they are together in memory. `texel` loads one.
template <class LoadTexel>
TERRAZZO_INLINE Color mix_by_pixels(const MipLevel& level, const FloatAxis& x, const FloatAxis& y,
                                    LoadTexel texel) {
    using TagFour = hn::FixedTag<float, 4>;
    const I32x16 pitch(level.pitch), low = multiply_small(y.first, pitch),
                                     high = multiply_small(y.second, pitch);
    alignas(64) int32_t low_first[16], low_second[16], high_first[16], high_second[16];
    store(low + x.first, low_first), store(low + x.second, low_second);
    store(high + x.first, high_first), store(high + x.second, high_second);
    alignas(64) float x_weights[16], y_weights[16], mixed[64];
    store(x.weight, x_weights), store(y.weight, y_weights);
    const auto mix = [](auto a, auto b, auto weight)
                         TERRAZZO_INLINE_LAMBDA { return hn::Add(a, hn::Mul(weight, hn::Sub(b, a))); };
    for (int i = 0; i < kTilePixels; ++i) {
        const auto x_weight = hn::Set(TagFour(), x_weights[i]);
        const auto of_low = mix(texel(low_first[i]), texel(low_second[i]), x_weight);
        const auto of_high = mix(texel(high_first[i]), texel(high_second[i]), x_weight);
        hn::Store(mix(of_low, of_high, hn::Set(TagFour(), y_weights[i])), TagFour(), mixed + 4 * i);
    }
    const F32x16Four channels = gather_fours(mixed, lane_numbers());
    return {channels.value[0], channels.value[1], channels.value[2], channels.value[3]};
}

TERRAZZO_NOINLINE Color mix_floats_by_pixels(const MipLevel& level, const FloatAxis& x, const FloatAxis& y) {
    const float* const texels = static_cast<const float*>(level.texels);
    return mix_by_pixels(level, x, y, [&](int32_t index) TERRAZZO_INLINE_LAMBDA {
        return hn::LoadU(hn::FixedTag<float, 4>(), texels + 4 * static_cast<std::ptrdiff_t>(index));
    });
}
TERRAZZO_NOINLINE Color mix_bytes_by_pixels(const MipLevel& level, const FloatAxis& x, const FloatAxis& y) {
    const uint8_t* const texels = static_cast<const uint8_t*>(level.texels);
    const auto scale = hn::Set(hn::FixedTag<float, 4>(), 1.0f / 255.0f);
    return mix_by_pixels(level, x, y, [&](int32_t index) TERRAZZO_INLINE_LAMBDA {
        const auto bytes =
            hn::LoadU(hn::FixedTag<uint8_t, 4>(), texels + 4 * static_cast<std::ptrdiff_t>(index));
        const auto integers = hn::PromoteTo(hn::FixedTag<int32_t, 4>(), bytes);
        return hn::Mul(hn::ConvertTo(hn::FixedTag<float, 4>(), integers), scale);
    });
}
#endif

TERRAZZO_NOINLINE Color sample_float(const Sampler& sampler, const MipLevel& level, Filter filter,
                                     const TexturePoint& at) {
    const FloatAxis x = float_axis(sampler.wrap_s, filter, at.s, level.width);
    FloatAxis y = no_axis();
    if (sampler.dimensions > 1) y = float_axis(sampler.wrap_t, filter, at.t, level.height);
    if (sampler.dimensions < 3) {
        const Mask16 all = mask_from_bits(0xffff);
        if (bits_of(both_inside(x) & both_inside(y)) == 0xffff) {
#if HWY_TARGET != HWY_SCALAR
            if (sampler.dimensions == 2 && filter == Filter::kLinear)
                return sampler.storage == TexelStorage::kRgba8 ? mix_bytes_by_pixels(level, x, y)
                                                               : mix_floats_by_pixels(level, x, y);
#endif
            return sample_float_slice<false>(sampler, level, filter, x, y, I32x16(0), all);
        }
        return sample_float_slice<true>(sampler, level, filter, x, y, I32x16(0), all);
    }
    const FloatAxis z = float_axis(sampler.wrap_r, filter, at.r, level.depth);
    const auto slice = [&](I32x16 number, Mask16 inside) {
        return sample_float_slice<true>(sampler, level, filter, x, y, number * I32x16(level.slice), inside);
    };
    const Color first = slice(z.first, z.first_inside);
    if (filter == Filter::kNearest) return first;
    return lerp(first, slice(z.second, z.second_inside), z.weight);
}

// A texel of a depth texture as a float, with the reference's roundings: of 32 bits 23 count.
TERRAZZO_INLINE F32x16 depth_of_texel(const Sampler& sampler, I32x16 integer, Mask16 inside) {
    F32x16 depth;
    if (sampler.depth_bits == 32) {
        const I32x16 above_one = shift_right_logical<9>(integer) | I32x16(0x3f800000);
        depth = (as_float(above_one) - F32x16(1.0f)) * F32x16(static_cast<float>(8388608.0 / 8388607.0));
    } else {
        const float scale = static_cast<float>(sampler.depth_bits == 16 ? 1.0 / 65535.0 : 1.0 / 16777215.0);
        depth = to_float(integer) * F32x16(scale);
    }
    return select(inside, depth, F32x16(sampler.border_color[0]));
}

// Where a texel of a depth texture is: the sum of what its column and its row contribute, since pixel_index()
// keeps their bits apart.
TERRAZZO_INLINE I32x16 depth_column(const MipLevel& level, I32x16 x) {
    if (level.bins_across == 0) return x;
    static_assert(kBinSize == 64 && kTileSize == 4);
    return (shift_left<6>(x) & I32x16(~(kBinPixels - 1))) | (shift_left<2>(x) & I32x16(0xf0)) |
           (x & I32x16(3));
}
TERRAZZO_INLINE I32x16 depth_row(const MipLevel& level, I32x16 y) {
    if (level.bins_across == 0) return y * I32x16(level.pitch);
    const I32x16 bins = shift_right<6>(y) * I32x16(level.bins_across * kBinPixels);
    return bins + ((shift_left<6>(y) & I32x16(0xf00)) | (shift_left<2>(y) & I32x16(0xc)));
}

// The depth, or the result of comparing r with it.
TERRAZZO_INLINE F32x16 depth_value(const Sampler& sampler, I32x16 texel, Mask16 inside, F32x16 r) {
    const F32x16 zero(0.0f), one(1.0f), depth = depth_of_texel(sampler, texel, inside);
    if (!sampler.compares) return depth;
    return select(compare(sampler.compare_func, clamp(r, zero, one), depth), one, zero);
}

TERRAZZO_INLINE Color depth_color(const Sampler& sampler, F32x16 value) {
    const F32x16 zero(0.0f);
    switch (sampler.depth_mode) {
        case BaseFormat::kIntensity:
            return {value, value, value, value};
        case BaseFormat::kAlpha:
            return {zero, zero, zero, value};
        default:
            return {value, value, value, F32x16(1.0f)};
    }
}

// Depth textures (GL 1.5 §3.8.14): filtered depths, or filtered results of comparisons.
TERRAZZO_NOINLINE Color sample_depth(const Sampler& sampler, const MipLevel& level, Filter filter,
                                     const TexturePoint& at) {
    const FloatAxis x = float_axis(sampler.wrap_s, filter, at.s, level.width);
    FloatAxis y = no_axis();
    if (sampler.dimensions > 1) y = float_axis(sampler.wrap_t, filter, at.t, level.height);
    const auto* const texels = static_cast<const int32_t*>(level.texels);
    const I32x16 first_column = depth_column(level, x.first);
    if (filter == Filter::kNearest) {
        const I32x16 texel = gather(texels, depth_row(level, y.first) + first_column);
        return depth_color(sampler, depth_value(sampler, texel, x.first_inside & y.first_inside, at.r));
    }
    // Results are weighed as sums of two products, depths by differences.
    const I32x16 second_column = depth_column(level, x.second);
    const auto along_x = [&](I32x16 y_index, Mask16 inside) TERRAZZO_INLINE_LAMBDA {
        const I32x16 row = depth_row(level, y_index);
        const I32x16Pair pair = level.bins_across == 0 ? fetch_row_pair(level, row, x)
                                                       : I32x16Pair{gather(texels, row + first_column),
                                                                    gather(texels, row + second_column)};
        const F32x16 first = depth_value(sampler, pair.first, x.first_inside & inside, at.r),
                     second = depth_value(sampler, pair.second, x.second_inside & inside, at.r);
        return sampler.compares ? first * (F32x16(1.0f) - x.weight) + second * x.weight
                                : first + x.weight * (second - first);
    };
    F32x16 value = along_x(y.first, y.first_inside);
    if (sampler.dimensions > 1) value = value + y.weight * (along_x(y.second, y.second_inside) - value);
    return depth_color(sampler, value);
}

TERRAZZO_INLINE bool samples_fixed(const Sampler& sampler) {
    const auto plain = [](Wrap wrap) { return wrap == Wrap::kRepeat || wrap == Wrap::kClampToEdge; };
    return sampler.storage == TexelStorage::kRgba8 && !sampler.in_floats && plain(sampler.wrap_s) &&
           (sampler.dimensions < 2 || plain(sampler.wrap_t)) &&
           (sampler.dimensions < 3 || plain(sampler.wrap_r));
}

TERRAZZO_NOINLINE Color sample_level(const Sampler& sampler, int level, Filter filter,
                                     const TexturePoint& at) {
    const MipLevel& mip = sampler.levels[static_cast<size_t>(level)];
    if (sampler.storage == TexelStorage::kDepth) return sample_depth(sampler, mip, filter, at);
    if (!samples_fixed(sampler)) return sample_float(sampler, mip, filter, at);
    return from_color8(to_color8(sample_fixed(sampler, mip, filter, at)));
}

// log2, linear between powers of two as the reference has it.
TERRAZZO_INLINE F32x16 fast_log2(F32x16 x) {
    const I32x16 bits = as_int(x);
    const F32x16 exponent = to_float(shift_right_logical<23>(bits) - I32x16(127));
    const F32x16 mantissa = as_float((bits & I32x16(0x7fffff)) | I32x16(0x3f800000));
    return exponent + (mantissa - F32x16(1.0f));
}

// What each 2x2 quad of the tile has in its first column and row, in all its pixels.
TERRAZZO_INLINE F32x16 first_of_quad(F32x16 v) {
    v = select(mask_from_bits(0xaaaa), swap_columns(v), v);
    return select(mask_from_bits(0xf0f0), swap_rows(v), v);
}

// lambda of the squared scale factor rho. Where it is one value for each 2x2 quad of the tile, what counts is
// in its first column and row.
TERRAZZO_INLINE F32x16 lambda_of(const Sampler& sampler, F32x16 squared_rho, bool by_quads) {
    F32x16 lambda = F32x16(0.5f) * fast_log2(squared_rho) + F32x16(sampler.lod_bias);
    if (by_quads) lambda = first_of_quad(lambda);
    const F32x16 low(sampler.min_lod), high(sampler.max_lod);
    return select(lambda < low, low, select(lambda > high, high, lambda));
}

// log2 of the scale factor of each pixel (GL 1.5 §3.8.8 with the reference's difference: to the right and
// upwards from the quad's first pixel).
TERRAZZO_NOINLINE F32x16 level_of_detail(const Sampler& sampler, const TexturePoint& at) {
    F32x16 rho_x(0.0f), rho_y(0.0f);
    const auto add = [&](F32x16 coordinate, int32_t size) {
        const F32x16 u = coordinate * F32x16(static_cast<float>(size));
        const F32x16 du_dx = swap_columns(u) - u, du_dy = swap_rows(u) - u;
        rho_x = rho_x + du_dx * du_dx, rho_y = rho_y + du_dy * du_dy;
    };
    add(at.s, sampler.levels[0].width);
    if (sampler.dimensions > 1) add(at.t, sampler.levels[0].height);
    if (sampler.dimensions > 2) add(at.r, sampler.levels[0].depth);
    return lambda_of(sampler, select(rho_x > rho_y, rho_x, rho_y), true);
}

TERRAZZO_INLINE Color select(Mask16 mask, const Color& yes, const Color& no) {
    return {select(mask, yes.r, no.r), select(mask, yes.g, no.g), select(mask, yes.b, no.b),
            select(mask, yes.a, no.a)};
}

// The texels of two neighbouring levels mixed, the second with `weight` 256ths.
TERRAZZO_INLINE Color mix_levels(const Sampler& sampler, int level, I32x16 weight, const TexturePoint& at) {
    const int next = std::min(level + 1, sampler.level_count - 1);
    if (!samples_fixed(sampler)) {
        return lerp(sample_level(sampler, level, sampler.min_filter, at),
                    sample_level(sampler, next, sampler.min_filter, at),
                    to_float(weight) * F32x16(1.0f / 256.0f));
    }
    const auto texels = [&](int l) {
        return sample_fixed(sampler, sampler.levels[static_cast<size_t>(l)], sampler.min_filter, at);
    };
    const TexelPairs first = texels(level), second = texels(next);
    return from_color8(to_color8(lerp_pairs(first, second, pair_weights(weight))));
}

// Minified from one level on; `weight` of the next, where the filter mixes two.
TERRAZZO_NOINLINE Color sample_minified(const Sampler& sampler, int level, I32x16 weight,
                                        const TexturePoint& at) {
    return sampler.mip_filter == MipFilter::kLinear ? mix_levels(sampler, level, weight, at)
                                                    : sample_level(sampler, level, sampler.min_filter, at);
}

// Mip-mapped minification of the pixels in `active`, level by level; most tiles have one.
TERRAZZO_NOINLINE Color sample_mipmapped(const Sampler& sampler, F32x16 lambda, const TexturePoint& at,
                                         uint32_t active) {
    const bool linear = sampler.mip_filter == MipFilter::kLinear;
    const F32x16 l = clamp(lambda, F32x16(0.0f), F32x16(static_cast<float>(sampler.level_count - 1)));
    const F32x16 base = floor(linear ? l : l + F32x16(0.5f));
    const I32x16 levels = truncate_to_int(base), weight = truncate_to_int((l - base) * F32x16(256.0f));
    alignas(64) int32_t level_of[16];
    store(levels, level_of);
    Color result{0.0f, 0.0f, 0.0f, 0.0f};
    for (uint32_t todo = active; todo != 0;) {
        const int level = level_of[std::countr_zero(todo)];
        const Mask16 same = levels == I32x16(level);
        const Color texel = sample_minified(sampler, level, weight, at);
        todo &= ~bits_of(same);
        result = select(same, texel, result);
    }
    return result;
}

// Whether no level needs to be chosen, and no filter.
TERRAZZO_INLINE bool filters_agree(const Sampler& sampler) {
    return sampler.mip_filter == MipFilter::kNone && sampler.min_filter == sampler.mag_filter;
}

// The filtered texel at `lambda` of each pixel in `mask`.
TERRAZZO_INLINE Color sample_at_lambda(const Sampler& sampler, F32x16 lambda, const TexturePoint& at,
                                       uint32_t mask) {
    const Mask16 minified = lambda > F32x16(0.0f);
    const uint32_t small = bits_of(minified) & mask, large = mask & ~small;
    const auto minification = [&] {
        return sampler.mip_filter == MipFilter::kNone ? sample_level(sampler, 0, sampler.min_filter, at)
                                                      : sample_mipmapped(sampler, lambda, at, small);
    };
    if (large == 0) return minification();
    const Color magnification = sample_level(sampler, 0, sampler.mag_filter, at);
    return small == 0 ? magnification : select(minified, minification(), magnification);
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
