// Texture sampling (GL 1.5 §3.8.7-§3.8.8): the filtered texel of 16 pixels.
//
// Eight-bit textures that repeat or clamp to their edge are sampled in fixed point as the reference does it:
// coordinates round(s * size * 256), weights of eight bits, each lerp rounded to eight bits, x before y. All
// others are sampled in floats.
#pragma once

#include "raster/pixel/color.h"
#include "raster/state.h"
#include "simd/math.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

// Two 16-bit numbers a lane: v0 + round(weight * (v1 - v0) / 256), both numbers of a lane with the lane's
// weight. `weight` holds weight * 128 twice a lane, 0 <= weight < 256.
TERRAZZO_INLINE I32x16 lerp_pairs(I32x16 v0, I32x16 v1, I32x16 weight) {
    I32x16 r;
#if HWY_TARGET == HWY_SCALAR
    TERRAZZO_FOR_PARTS {
        const uint32_t a = static_cast<uint32_t>(hn::GetLane(v0.part[p])),
                       b = static_cast<uint32_t>(hn::GetLane(v1.part[p]));
        const int32_t w = hn::GetLane(weight.part[p]) & 0xffff;
        uint32_t both = 0;
        for (int half = 0; half < 32; half += 16) {
            const int32_t low = static_cast<int32_t>(a >> half & 0xffff),
                          high = static_cast<int32_t>(b >> half & 0xffff);
            both |= static_cast<uint32_t>(low + ((w * (high - low) + 0x4000) >> 15)) << half;
        }
        r.part[p] = hn::Set(TagI(), static_cast<int32_t>(both));
    }
#else
    using Tag16 = hn::Repartition<int16_t, TagI>;
    TERRAZZO_FOR_PARTS {
        const auto a = hn::BitCast(Tag16(), v0.part[p]), b = hn::BitCast(Tag16(), v1.part[p]);
        const auto step = hn::MulFixedPoint15(hn::Sub(b, a), hn::BitCast(Tag16(), weight.part[p]));
        r.part[p] = hn::BitCast(TagI(), hn::Add(a, step));
    }
#endif
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
TERRAZZO_INLINE I32x16 join_pairs(TexelPairs t) {
    return t.rb | shift_left<8>(t.ga);
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

// The texels at columns x.first and x.second of a row, whose first texel each lane's `row` counts from the
// image's.
TERRAZZO_INLINE I32x16Pair fetch_neighbours(const MipLevel& level, const FixedAxis& x, I32x16 row,
                                            bool adjacent) {
    const int32_t* const texels = static_cast<const int32_t*>(level.texels);
    if (adjacent) return gather_pairs(texels, row + x.first);
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
    // Where no lane wraps round or is clamped, the two columns are neighbours in memory and one load gets
    // both.
    const bool adjacent = bits_of(x.second == x.first + I32x16(1)) == 0xffff;
    const I32x16Pair low = fetch_neighbours(level, x, multiply_small(y.first, pitch), adjacent);
    const I32x16Pair high = fetch_neighbours(level, x, multiply_small(y.second, pitch), adjacent);
    const I32x16 wx = pair_weights(x.weight);
    return lerp_pairs(lerp_pairs(split_pairs(low.first), split_pairs(low.second), wx),
                      lerp_pairs(split_pairs(high.first), split_pairs(high.second), wx),
                      pair_weights(y.weight));
}

// The same for one level that repeats both ways, LINEAR: the hot case. What all tiles share is read once,
// because the compiler has to expect that a store to a tile changes it.
class RepeatedBilinear {
  public:
    TERRAZZO_INLINE RepeatedBilinear() = default;
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
    bool m_masks_wrap = false;
};

TERRAZZO_INLINE TexelPairs sample_fixed(const Sampler& sampler, const MipLevel& level, Filter filter,
                                        F32x16 s, F32x16 t) {
    if (sampler.dimensions == 2) return sample_fixed_2d(sampler.wrap_s, sampler.wrap_t, level, filter, s, t);
    const FixedAxis x = fixed_axis(sampler.wrap_s, filter, s, level.width);
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
        const F32x16 whole = floor(coordinate), fraction = coordinate - whole;
        const Mask16 odd = (whole - F32x16(2.0f) * floor(whole * F32x16(0.5f))) == F32x16(1.0f);
        coordinate = select(odd, F32x16(1.0f) - fraction, fraction);
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

TERRAZZO_INLINE Color fetch_float(const Sampler& sampler, const MipLevel& level, I32x16 x, I32x16 y,
                                  Mask16 inside) {
    const I32x16 index = y * I32x16(level.pitch) + x;
    Color c;
    if (sampler.storage == TexelStorage::kRgba8) {
        const Color8 texel = unpack_rgba8(gather(static_cast<const int32_t*>(level.texels), index));
        c = {from_unorm8(texel.r), from_unorm8(texel.g), from_unorm8(texel.b), from_unorm8(texel.a)};
    } else {
        const float* const texels = static_cast<const float*>(level.texels);
        const I32x16 first = shift_left<2>(index);
        c = {gather(texels, first), gather(texels + 1, first), gather(texels + 2, first),
             gather(texels + 3, first)};
    }
    const float* const b = sampler.border_color;
    return {select(inside, c.r, b[0]), select(inside, c.g, b[1]), select(inside, c.b, b[2]),
            select(inside, c.a, b[3])};
}

TERRAZZO_INLINE Color lerp(Color a, Color b, F32x16 t) {
    return {a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b), a.a + t * (b.a - a.a)};
}

TERRAZZO_NOINLINE Color sample_float(const Sampler& sampler, const MipLevel& level, Filter filter, F32x16 s,
                                     F32x16 t) {
    const FloatAxis x = float_axis(sampler.wrap_s, filter, s, level.width);
    FloatAxis y{I32x16(0), I32x16(0), mask_from_bits(0xffff), mask_from_bits(0xffff), F32x16(0.0f)};
    if (sampler.dimensions == 2) y = float_axis(sampler.wrap_t, filter, t, level.height);
    const Color c00 = fetch_float(sampler, level, x.first, y.first, x.first_inside & y.first_inside);
    if (filter == Filter::kNearest) return c00;
    const Color c10 = fetch_float(sampler, level, x.second, y.first, x.second_inside & y.first_inside);
    const Color low = lerp(c00, c10, x.weight);
    if (sampler.dimensions == 1) return low;
    const Color c01 = fetch_float(sampler, level, x.first, y.second, x.first_inside & y.second_inside);
    const Color c11 = fetch_float(sampler, level, x.second, y.second, x.second_inside & y.second_inside);
    return lerp(low, lerp(c01, c11, x.weight), y.weight);
}

TERRAZZO_INLINE bool samples_fixed(const Sampler& sampler) {
    const auto plain = [](Wrap wrap) { return wrap == Wrap::kRepeat || wrap == Wrap::kClampToEdge; };
    return sampler.storage == TexelStorage::kRgba8 && plain(sampler.wrap_s) &&
           (sampler.dimensions == 1 || plain(sampler.wrap_t));
}

TERRAZZO_NOINLINE Color sample_level(const Sampler& sampler, int level, Filter filter, F32x16 s, F32x16 t) {
    const MipLevel& mip = sampler.levels[static_cast<size_t>(level)];
    if (!samples_fixed(sampler)) return sample_float(sampler, mip, filter, s, t);
    const Color8 c = to_color8(sample_fixed(sampler, mip, filter, s, t));
    return {from_unorm8(c.r), from_unorm8(c.g), from_unorm8(c.b), from_unorm8(c.a)};
}

// log2 of the scale factor, one value for each 2x2 quad of the tile (GL 1.5 §3.8.8 with the reference's
// differences: to the right and upwards from the quad's first pixel, log2 linear between powers of two).
struct QuadLod {
    float lambda[4];
};

inline float fast_log2(float x) {
    uint32_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    const float exponent = static_cast<float>(static_cast<int32_t>(bits >> 23) - 127);
    bits = (bits & 0x7fffffu) | 0x3f800000u;
    float mantissa;
    std::memcpy(&mantissa, &bits, sizeof mantissa);
    return exponent + (mantissa - 1.0f);
}

TERRAZZO_NOINLINE QuadLod quad_lod(const Sampler& sampler, F32x16 s, F32x16 t) {
    alignas(64) float u[16], v[16];
    store(s * F32x16(static_cast<float>(sampler.levels[0].width)), u);
    store(t * F32x16(static_cast<float>(sampler.levels[0].height)), v);
    QuadLod lod;
    for (int q = 0; q < 4; ++q) {
        const int i = (q >> 1) * 8 + (q & 1) * 2;
        float dx = u[i + 1] - u[i], dy = u[i + 4] - u[i];
        float rho_x = dx * dx, rho_y = dy * dy;
        if (sampler.dimensions == 2) {
            dx = v[i + 1] - v[i], dy = v[i + 4] - v[i];
            rho_x += dx * dx, rho_y += dy * dy;
        }
        const float rho2 = rho_x > rho_y ? rho_x : rho_y;
        float lambda = 0.5f * fast_log2(rho2) + sampler.lod_bias;
        lambda = lambda < sampler.min_lod   ? sampler.min_lod
                 : lambda > sampler.max_lod ? sampler.max_lod
                                            : lambda;
        lod.lambda[q] = lambda;
    }
    return lod;
}

// The pixels of quads 0..3 as tile masks.
inline constexpr uint16_t kQuadMask[4] = {0x0033, 0x00cc, 0x3300, 0xcc00};

TERRAZZO_INLINE Color select(Mask16 mask, const Color& yes, const Color& no) {
    return {select(mask, yes.r, no.r), select(mask, yes.g, no.g), select(mask, yes.b, no.b),
            select(mask, yes.a, no.a)};
}

// Mip-mapped minification of the quads in `minified`, by distinct level.
TERRAZZO_NOINLINE Color sample_mipmapped(const Sampler& sampler, const QuadLod& lod, F32x16 s, F32x16 t,
                                         uint32_t active) {
    const int last = sampler.level_count - 1;
    Color result{0.0f, 0.0f, 0.0f, 0.0f};
    uint32_t todo = active;
    for (int q = 0; q < 4; ++q) {
        if (!(todo & kQuadMask[q])) continue;
        const float lambda = lod.lambda[q];
        int level;
        uint32_t same = kQuadMask[q];
        if (sampler.mip_filter == MipFilter::kNearest) {
            const auto nearest = [&](float l) {
                return std::clamp(static_cast<int>(std::floor(l + 0.5f)), 0, last);
            };
            level = nearest(lambda);
            for (int other = q + 1; other < 4; ++other)
                if (nearest(lod.lambda[other]) == level) same |= kQuadMask[other];
            result =
                select(mask_from_bits(same), sample_level(sampler, level, sampler.min_filter, s, t), result);
        } else {
            const auto below = [&](float l) { return std::clamp(static_cast<int>(std::floor(l)), 0, last); };
            level = below(lambda);
            alignas(64) float weights[16] = {};
            for (int other = q; other < 4; ++other) {
                const float l = lod.lambda[other];
                if (below(l) != level) continue;
                same |= kQuadMask[other];
                const float fraction = l < 0 || level == last ? 0.0f : l - static_cast<float>(level);
                const float weight = static_cast<float>(static_cast<int>(fraction * 256.0f));
                for (int i = 0; i < 16; ++i)
                    if (kQuadMask[other] >> i & 1) weights[i] = weight;
            }
            const int next = std::min(level + 1, last);
            Color mixed;
            if (samples_fixed(sampler)) {
                const TexelPairs a = sample_fixed(sampler, sampler.levels[static_cast<size_t>(level)],
                                                  sampler.min_filter, s, t);
                const TexelPairs b = sample_fixed(sampler, sampler.levels[static_cast<size_t>(next)],
                                                  sampler.min_filter, s, t);
                const Color8 c = to_color8(lerp_pairs(a, b, pair_weights(truncate_to_int(load(weights)))));
                mixed = {from_unorm8(c.r), from_unorm8(c.g), from_unorm8(c.b), from_unorm8(c.a)};
            } else {
                mixed = lerp(sample_level(sampler, level, sampler.min_filter, s, t),
                             sample_level(sampler, next, sampler.min_filter, s, t),
                             load(weights) * F32x16(1.0f / 256.0f));
            }
            result = select(mask_from_bits(same), mixed, result);
        }
        todo &= ~same;
    }
    return result;
}

// The filtered texel at texture coordinates (s, t) of each pixel in `mask`.
TERRAZZO_NOINLINE Color sample_texture(const Sampler& sampler, F32x16 s, F32x16 t, uint32_t mask) {
    const bool filters_agree =
        sampler.mip_filter == MipFilter::kNone && sampler.min_filter == sampler.mag_filter;
    if (filters_agree) return sample_level(sampler, 0, sampler.mag_filter, s, t);
    const QuadLod lod = quad_lod(sampler, s, t);
    uint32_t magnified = 0;
    for (int q = 0; q < 4; ++q)
        if (!(lod.lambda[q] > 0)) magnified |= kQuadMask[q];
    Color magnification{0.0f, 0.0f, 0.0f, 0.0f}, minification = magnification;
    if (magnified & mask) magnification = sample_level(sampler, 0, sampler.mag_filter, s, t);
    if (~magnified & mask) {
        minification = sampler.mip_filter == MipFilter::kNone
                           ? sample_level(sampler, 0, sampler.min_filter, s, t)
                           : sample_mipmapped(sampler, lod, s, t, mask & ~magnified);
    }
    return select(mask_from_bits(magnified), magnification, minification);
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
