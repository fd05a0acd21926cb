// From footprints to filtered texels: loads and the reference's two or three lerps of eight bits each, a
// native vector at a time, so that all of it stays in registers.
#pragma once

#include "raster/batch.h"
#include "raster/sample/filter.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

// TexelPairs of one native vector.
struct NativeTexels {
    NativeI rb, ga;
};
TERRAZZO_INLINE NativeTexels split_texels(NativeI packed) {
    const auto even = hn::And(packed, hn::Set(TagI(), 0x00ff00ff));
#if HWY_TARGET == HWY_SCALAR
    return {even, hn::And(hn::ShiftRight<8>(packed), hn::Set(TagI(), 0x00ff00ff))};
#else
    using Tag16 = hn::Repartition<uint16_t, TagI>;
    return {even, hn::BitCast(TagI(), hn::ShiftRight<8>(hn::BitCast(Tag16(), packed)))};
#endif
}
TERRAZZO_INLINE NativeI join_texels(NativeTexels t) {
    return hn::Or(t.rb, hn::ShiftLeft<8>(t.ga));
}
// `weight` in 256ths, as lerp_pairs takes it: times 128, twice a lane.
TERRAZZO_INLINE NativeTexels lerp_texels(NativeTexels a, NativeTexels b, NativeI weight) {
    return {lerp_native(a.rb, b.rb, weight), lerp_native(a.ga, b.ga, weight)};
}
TERRAZZO_INLINE NativeI twice_a_lane(NativeI weight) {
    const auto w = hn::ShiftLeft<7>(weight);
    return hn::Or(w, hn::ShiftLeft<16>(w));
}

// The lower (0) or upper (2) half of each lane in both halves.
template <uint8_t kFirstByte>
TERRAZZO_INLINE NativeI half_twice(NativeI v) {
#if HWY_TARGET == HWY_SCALAR
    const uint32_t half = static_cast<uint32_t>(hn::GetLane(v)) >> 8 * kFirstByte & 0xffff;
    return hn::Set(TagI(), static_cast<int32_t>(half | half << 16));
#else
    using TagBytes = hn::Repartition<uint8_t, TagI>;
    constexpr uint8_t k0 = kFirstByte, k1 = kFirstByte + 1;
    alignas(16) static constexpr uint8_t kOrder[16] = {k0,      k1,      k0,      k1,     k0 + 4, k1 + 4,
                                                       k0 + 4,  k1 + 4,  k0 + 8,  k1 + 8, k0 + 8, k1 + 8,
                                                       k0 + 12, k1 + 12, k0 + 12, k1 + 12};
    return hn::BitCast(TagI(),
                       hn::TableLookupBytes(hn::BitCast(TagBytes(), v), hn::LoadDup128(TagBytes(), kOrder)));
#endif
}

TERRAZZO_INLINE NativeTexels mix_four(NativePair low, NativePair high, NativeI weights) {
    const auto x = half_twice<0>(weights), y = half_twice<2>(weights);
    return lerp_texels(lerp_texels(split_texels(low.first), split_texels(low.second), x),
                       lerp_texels(split_texels(high.first), split_texels(high.second), x), y);
}

// Pairs of which some begin a row anew with their second texel.
TERRAZZO_NOINLINE NativePair load_wrapped_pairs(const Batch::Footprint& from, const int32_t* index,
                                                int first) {
    alignas(64) int32_t left[kNativeLanes], right[kNativeLanes];
    for (int i = 0; i < kNativeLanes; ++i) {
        const int32_t* const texel = from.base + index[first + i];
        left[i] = texel[0];
        right[i] = texel[from.wraps >> (first + i) & 1 ? from.wrap_step : 1];
    }
    return {hn::Load(TagI(), left), hn::Load(TagI(), right)};
}

// The bilinear texels of lanes p * kNativeLanes and on.
TERRAZZO_INLINE NativeTexels fetch_linear(const Batch::Footprint& from, int p) {
    const int first = p * kNativeLanes;
    const auto weights = hn::Load(TagI(), reinterpret_cast<const int32_t*>(from.weights) + first);
    if (from.wraps != 0) [[unlikely]]
        return mix_four(load_wrapped_pairs(from, from.low, first), load_wrapped_pairs(from, from.high, first),
                        weights);
    return mix_four(load_pairs(from.base, from.low + first), load_pairs(from.base, from.high + first),
                    weights);
}

TERRAZZO_INLINE NativeI fetch_nearest(const Batch::Footprint& from, int p) {
    alignas(64) int32_t texels[kNativeLanes];
    for (int i = 0; i < kNativeLanes; ++i) texels[i] = from.base[from.low[p * kNativeLanes + i]];
    return hn::Load(TagI(), texels);
}

TERRAZZO_INLINE void store_texels(NativeI packed, int p, uint32_t* to) {
    hn::Store(packed, TagI(), reinterpret_cast<int32_t*>(to) + p * kNativeLanes);
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
