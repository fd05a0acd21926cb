// Anisotropic filtering (EXT_texture_filter_anisotropic) as the reference does it: the average of the texels
// of one level under a pixel's footprint, an ellipse, each weighted by how near it is to the centre
// [Heckbert 1989, Fundamentals of Texture Mapping and Image Warping, p. 59].
//
// The level is that of the shorter of the two derivatives; filters and the degree of anisotropy do not count.
// doc/reference.md §4 has the roundings.
#pragma once

#include "raster/sample/ellipse_weights.h"
#include "raster/sample/filter.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

// How s and t change from a quad's first pixel to the next ones across and along, in texels.
struct Derivatives {
    F32x16 s_x, s_y, t_x, t_y;

    TERRAZZO_INLINE Derivatives(const TexturePoint& at, const MipLevel& base) {
        const F32x16 width(static_cast<float>(base.width)), height(static_cast<float>(base.height));
        s_x = first_of_quad((swap_columns(at.s) - at.s) * width);
        s_y = first_of_quad((swap_rows(at.s) - at.s) * width);
        t_x = first_of_quad((swap_columns(at.t) - at.t) * height);
        t_y = first_of_quad((swap_rows(at.t) - at.t) * height);
    }
    TERRAZZO_INLINE void scale(F32x16 factor) {
        s_x = s_x * factor, s_y = s_y * factor, t_x = t_x * factor, t_y = t_y * factor;
    }
};

// The points (x, y) from the centre with a*x*x + b*x*y + c*y*y < 1024, and half the box round them.
struct Ellipse {
    F32x16 a, b, c, half_width, half_height;
};

// Footprints of more than some 16000 texels are made smaller, or a single pixel could take minutes.
TERRAZZO_INLINE void limit_footprint(Derivatives& d) {
    constexpr float kLongest = 4096.0f, kLargest = 16777216.0f;
    for (F32x16* const slope : {&d.s_x, &d.s_y, &d.t_x, &d.t_y}) *slope = bounded(*slope, kLongest);
    const F32x16 one(1.0f), width = d.s_x * d.s_x + d.s_y * d.s_y + one,
                            height = d.t_x * d.t_x + d.t_y * d.t_y + one,
                            excess = width * height / F32x16(kLargest);
    if (!any(excess > one)) return;
    d.scale(one / sqrt(sqrt(max(excess, one))));
}

TERRAZZO_INLINE Ellipse ellipse_of(const Derivatives& d) {
    const F32x16 one(1.0f), two(2.0f), four(4.0f);
    Ellipse e;
    e.a = d.t_x * d.t_x + d.t_y * d.t_y + one;
    e.b = (d.s_x * d.t_x + d.s_y * d.t_y) * F32x16(-2.0f);
    e.c = d.s_x * d.s_x + d.s_y * d.s_y + one;
    const F32x16 bb = e.b * e.b, ac = e.a * e.c;
    const F32x16 f = ac - bb / four, determinant = four * ac - bb;
    e.half_width = two / determinant * sqrt(determinant * e.c * f);
    e.half_height = two / determinant * sqrt(e.a * determinant * f);
    const F32x16 to_table = F32x16(static_cast<float>(kEllipseWeightCount - 1)) / f;
    e.a = e.a * to_table, e.b = e.b * to_table, e.c = e.c * to_table;
    return e;
}

// The texel of an index along an axis. The reference goes through a coordinate, whose rounding shows where
// the size is no power of two.
TERRAZZO_INLINE FloatAxis texel_axis(Wrap wrap, I32x16 index, int32_t size) {
    return float_axis(wrap, Filter::kNearest, to_float(index) / F32x16(static_cast<float>(size)), size);
}
TERRAZZO_INLINE I32x16 plain_texel_index(Wrap wrap, I32x16 index, int32_t size) {
    return is_power_of_two(size) ? wrap_index(wrap, index, size) : texel_axis(wrap, index, size).first;
}

// Texels of one level by their indices: eight-bit ones of a 2D texture without a border ...
class PlainTexels {
  public:
    struct Row {
        I32x16 start;
    };
    TERRAZZO_INLINE PlainTexels(const Sampler& sampler, const MipLevel& level)
        : m_level(level), m_wrap_s(sampler.wrap_s), m_wrap_t(sampler.wrap_t) {}
    TERRAZZO_INLINE Row row(I32x16 index) const {
        return {plain_texel_index(m_wrap_t, index, m_level.height) * I32x16(m_level.pitch)};
    }
    TERRAZZO_INLINE Color at(const Row& row, I32x16 index) const {
        const I32x16 column = plain_texel_index(m_wrap_s, index, m_level.width);
        return from_color8(
            unpack_rgba8(gather(static_cast<const int32_t*>(m_level.texels), row.start + column)));
    }

  private:
    MipLevel m_level;
    Wrap m_wrap_s, m_wrap_t;
};

// ... and all others. Of 3D textures it is the nearest slice.
class AnyTexels {
  public:
    struct Row {
        I32x16 start;
        Mask16 inside;
    };
    TERRAZZO_INLINE AnyTexels(const Sampler& sampler, const MipLevel& level, const TexturePoint& point)
        : m_sampler(sampler), m_level(level), m_r(point.r), m_slice(no_axis()) {
        if (sampler.dimensions == 3)
            m_slice = float_axis(sampler.wrap_r, Filter::kNearest, point.r, level.depth);
    }
    TERRAZZO_INLINE Row row(I32x16 index) const {
        const FloatAxis y =
            m_sampler.dimensions == 1 ? no_axis() : texel_axis(m_sampler.wrap_t, index, m_level.height);
        if (m_sampler.storage == TexelStorage::kDepth) return {depth_row(m_level, y.first), y.first_inside};
        return {y.first * I32x16(m_level.pitch) + m_slice.first * I32x16(m_level.slice),
                y.first_inside & m_slice.first_inside};
    }
    TERRAZZO_INLINE Color at(const Row& row, I32x16 index) const {
        const FloatAxis x = texel_axis(m_sampler.wrap_s, index, m_level.width);
        const Mask16 inside = x.first_inside & row.inside;
        if (m_sampler.storage != TexelStorage::kDepth)
            return with_border(m_sampler, inside, fetch_float(m_sampler, m_level, row.start + x.first));
        const I32x16 texel =
            gather(static_cast<const int32_t*>(m_level.texels), row.start + depth_column(m_level, x.first));
        return depth_color(m_sampler, depth_value(m_sampler, texel, inside, m_r));
    }

  private:
    const Sampler& m_sampler;
    const MipLevel& m_level;
    F32x16 m_r;
    FloatAxis m_slice;
};

// The weighted average of the texels that the ellipse round (u, v) holds, for the pixels in `lanes`. The
// distance of the next texel in a row comes from two additions, whose rounding errors are the reference's.
template <class Texels>
TERRAZZO_INLINE Color average(const Ellipse& e, F32x16 u, F32x16 v, Mask16 lanes, const Texels& texels) {
    const F32x16 zero(0.0f), two(2.0f), border(static_cast<float>(kEllipseWeightCount));
    const auto whole = [](F32x16 x) { return truncate_to_int(bounded(x, 1073741824.0f)); };
    const I32x16 first_u = whole(floor(u - e.half_width)), last_u = whole(-floor(-(u + e.half_width)));
    const I32x16 first_v = whole(floor(v - e.half_height)), last_v = whole(-floor(-(v + e.half_height)));
    const F32x16 x = to_float(first_u) - u, second_difference = e.a * two;
    const F32x16 row_difference = (x * two + F32x16(1.0f)) * e.a, row_distance = x * x * e.a;
    const int rows = largest_lane(select(lanes, last_v - first_v, I32x16(-1)));
    Color sum{zero, zero, zero, zero};
    F32x16 weights = zero;
    for (int i = 0; i <= rows; ++i) {
        const I32x16 row_index = first_v + I32x16(i);
        const Mask16 in_box = ~(row_index > last_v) & lanes;
        const F32x16 y = to_float(row_index) - v;
        F32x16 difference = y * e.b + row_difference;
        F32x16 distance = (e.c * y + e.b * x) * y + row_distance;
        const auto row = texels.row(row_index);
        for (I32x16 column = first_u;; column = column + I32x16(1)) {
            const Mask16 in_row = in_box & ~(column > last_u), near = distance < border;
            const Mask16 inside = in_row & near;
            if (any(inside)) {
                const I32x16 index = max(truncate_to_int(select(inside, distance, zero)), I32x16(0));
                const F32x16 weight = select(inside, gather(kEllipseWeights.of_distance, index), zero);
                const Color texel = texels.at(row, column);
                sum.r = sum.r + texel.r * weight;
                sum.g = sum.g + texel.g * weight;
                sum.b = sum.b + texel.b * weight;
                sum.a = sum.a + texel.a * weight;
                weights = weights + weight;
            }
            // Pixels that the ellipse's border recedes from get no more texels of this row.
            if (!any(in_row & (near | (difference < zero)))) break;
            distance = distance + difference;
            difference = difference + second_difference;
        }
    }
    return {sum.r / weights, sum.g / weights, sum.b / weights, sum.a / weights};
}

TERRAZZO_NOINLINE Color average_of_plain(const Sampler& sampler, const MipLevel& level, const Ellipse& e,
                                         F32x16 u, F32x16 v, Mask16 lanes) {
    return average(e, u, v, lanes, PlainTexels(sampler, level));
}
TERRAZZO_NOINLINE Color average_of_any(const Sampler& sampler, const MipLevel& level, const Ellipse& e,
                                       const TexturePoint& at, F32x16 u, F32x16 v, Mask16 lanes) {
    return average(e, u, v, lanes, AnyTexels(sampler, level, at));
}

TERRAZZO_INLINE Color average_of_level(const Sampler& sampler, int number, const Derivatives& base,
                                       const TexturePoint& at, Mask16 lanes) {
    const MipLevel& level = sampler.levels[static_cast<size_t>(number)];
    const F32x16 share(1.0f / static_cast<float>(1 << number)), half(0.5f);
    Derivatives d = base;
    d.scale(share);
    limit_footprint(d);
    const Ellipse e = ellipse_of(d);
    // Not the level's own size, which is rounded where the base's is odd.
    const F32x16 width(static_cast<float>(sampler.levels[0].width)),
        height(static_cast<float>(sampler.levels[0].height));
    const F32x16 u = at.s * (width * share) - half, v = at.t * (height * share) - half;
    return samples_fixed(sampler) && sampler.dimensions == 2
               ? average_of_plain(sampler, level, e, u, v, lanes)
               : average_of_any(sampler, level, e, at, u, v, lanes);
}

TERRAZZO_NOINLINE Color sample_anisotropic(const Sampler& sampler, const TexturePoint& at, uint32_t mask) {
    const Derivatives base(at, sampler.levels[0]);
    const F32x16 across = base.s_x * base.s_x + base.t_x * base.t_x,
                 along = base.s_y * base.s_y + base.t_y * base.t_y;
    const F32x16 lambda = lambda_of(sampler, min(across, along), false);
    const F32x16 last(static_cast<float>(sampler.level_count - 1));
    const I32x16 levels = truncate_to_int(clamp(lambda, F32x16(0.0f), last));
    alignas(64) int32_t level_of[16];
    store(levels, level_of);
    Color result{0.0f, 0.0f, 0.0f, 0.0f};
    for (uint32_t todo = mask; todo != 0;) {
        const int level = level_of[std::countr_zero(todo)];
        const Mask16 same = levels == I32x16(level);
        const Color texel = average_of_level(sampler, level, base, at, same & mask_from_bits(todo));
        todo &= ~bits_of(same);
        result = select(same, texel, result);
    }
    return result;
}

// The filtered texel of each pixel in `mask`, of textures that are no cube maps.
TERRAZZO_NOINLINE Color sample_texture(const Sampler& sampler, const TexturePoint& at, uint32_t mask) {
    if (sampler.anisotropic) return sample_anisotropic(sampler, at, mask);
    if (filters_agree(sampler)) return sample_level(sampler, 0, sampler.mag_filter, at);
    return sample_at_lambda(sampler, level_of_detail(sampler, at), at, mask);
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
