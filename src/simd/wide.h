// Sixteen lanes at a time: value types over Google Highway for code that is compiled once per instruction
// set.
//
// F32x16, I32x16 and Mask16 hold one lane per pixel of a 4x4 tile, or per vertex or triangle of a batch; they
// are made of as many native vectors as the instruction set needs (one on AVX-512, sixteen scalars on none).
// Nothing here approximates or reassociates, and only fused_multiply_add fuses: every instruction set
// computes the same bits (promise P3).
//
// A file that includes this is compiled by src/meson.build once per instruction set, with TERRAZZO_ISA naming
// it, and keeps all its code in namespace TERRAZZO_ISA_NAMESPACE so that no two compilations share a symbol.
#pragma once

#include <hwy/highway.h>

#include <cstdint>
#include <cstring>

#ifndef TERRAZZO_ISA
#error "compile per instruction set: see src/meson.build"
#endif

#define TERRAZZO_CONCAT_(a, b) a##b
#define TERRAZZO_CONCAT(a, b) TERRAZZO_CONCAT_(a, b)
#define TERRAZZO_ISA_NAMESPACE TERRAZZO_CONCAT(isa_, TERRAZZO_ISA)
#if HWY_TARGET == HWY_SCALAR
#define TERRAZZO_INLINE inline
#else
#define TERRAZZO_INLINE inline __attribute__((always_inline))
#endif
// The same of a lambda, behind its parameters.
#define TERRAZZO_INLINE_LAMBDA __attribute__((always_inline))
// For what runs rarely or long: compiled once, however many kernels call it.
#define TERRAZZO_NOINLINE inline __attribute__((noinline))
// Sixteen copies of everything would only be slow to compile.
#if HWY_TARGET == HWY_SCALAR
#define TERRAZZO_FOR_PARTS for (int p = 0; p < kParts; ++p)
#else
#define TERRAZZO_FOR_PARTS _Pragma("GCC unroll 16") for (int p = 0; p < kParts; ++p)
#endif

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR
inline constexpr int kNativeLanes = 1;
#else
inline constexpr int kNativeLanes = HWY_LANES(float) < 16 ? HWY_LANES(float) : 16;
#endif
inline constexpr int kParts = 16 / kNativeLanes;
inline constexpr bool kMasksAreRegisters = HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX3;

using TagF = hn::CappedTag<float, kNativeLanes>;
using TagI = hn::CappedTag<int32_t, kNativeLanes>;
using TagU = hn::CappedTag<uint32_t, kNativeLanes>;
using NativeF = hn::Vec<TagF>;
using NativeI = hn::Vec<TagI>;
using NativeMask = hn::Mask<TagF>;

struct Mask16 {
    NativeMask part[kParts];
};

struct F32x16 {
    NativeF part[kParts];

    F32x16() = default;
    TERRAZZO_INLINE F32x16(float value) { TERRAZZO_FOR_PARTS part[p] = hn::Set(TagF(), value); }
};

struct I32x16 {
    NativeI part[kParts];

    I32x16() = default;
    TERRAZZO_INLINE I32x16(int32_t value) { TERRAZZO_FOR_PARTS part[p] = hn::Set(TagI(), value); }
};

#define TERRAZZO_BINARY(Type, name, operation)                              \
    TERRAZZO_INLINE Type name(Type a, Type b) {                             \
        Type r;                                                             \
        TERRAZZO_FOR_PARTS r.part[p] = hn::operation(a.part[p], b.part[p]); \
        return r;                                                           \
    }
TERRAZZO_BINARY(F32x16, operator+, Add)
TERRAZZO_BINARY(F32x16, operator-, Sub)
TERRAZZO_BINARY(F32x16, operator*, Mul)
#if !HWY_ARCH_ARM_V7 || HWY_TARGET == HWY_SCALAR
TERRAZZO_BINARY(F32x16, operator/, Div)
#endif
TERRAZZO_BINARY(I32x16, operator+, Add)
TERRAZZO_BINARY(I32x16, operator-, Sub)
TERRAZZO_BINARY(I32x16, operator*, Mul)
TERRAZZO_BINARY(I32x16, operator&, And)
TERRAZZO_BINARY(I32x16, operator|, Or)
TERRAZZO_BINARY(I32x16, operator^, Xor)
TERRAZZO_BINARY(I32x16, min, Min)
TERRAZZO_BINARY(I32x16, max, Max)
TERRAZZO_BINARY(Mask16, operator&, And)
TERRAZZO_BINARY(Mask16, operator|, Or)
#undef TERRAZZO_BINARY

#define TERRAZZO_COMPARE(Type, name, operation)                                                     \
    TERRAZZO_INLINE Mask16 name(Type a, Type b) {                                                   \
        Mask16 r;                                                                                   \
        TERRAZZO_FOR_PARTS r.part[p] = hn::RebindMask(TagF(), hn::operation(a.part[p], b.part[p])); \
        return r;                                                                                   \
    }
TERRAZZO_COMPARE(F32x16, operator<, Lt)
TERRAZZO_COMPARE(F32x16, operator<=, Le)
TERRAZZO_COMPARE(F32x16, operator>, Gt)
TERRAZZO_COMPARE(F32x16, operator>=, Ge)
TERRAZZO_COMPARE(F32x16, operator==, Eq)
TERRAZZO_COMPARE(I32x16, operator<, Lt)
TERRAZZO_COMPARE(I32x16, operator>, Gt)
TERRAZZO_COMPARE(I32x16, operator==, Eq)
#undef TERRAZZO_COMPARE

TERRAZZO_INLINE Mask16 operator~(Mask16 a) {
    Mask16 r;
    TERRAZZO_FOR_PARTS r.part[p] = hn::Not(a.part[p]);
    return r;
}
// True where either is NaN; Highway's own answers differ there from one instruction set to the next.
TERRAZZO_INLINE Mask16 operator!=(F32x16 a, F32x16 b) {
    return ~(a == b);
}
TERRAZZO_INLINE Mask16 operator!=(I32x16 a, I32x16 b) {
    return ~(a == b);
}
TERRAZZO_INLINE Mask16 operator<=(I32x16 a, I32x16 b) {
    return ~(a > b);
}
TERRAZZO_INLINE Mask16 operator>=(I32x16 a, I32x16 b) {
    return ~(a < b);
}

// The smaller (larger) of two floats; the second where either is NaN: x86's rule, kept on every instruction
// set.
TERRAZZO_INLINE F32x16 min(F32x16 a, F32x16 b) {
    F32x16 r;
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR
    TERRAZZO_FOR_PARTS r.part[p] = hn::Min(a.part[p], b.part[p]);
#else
    TERRAZZO_FOR_PARTS r.part[p] = hn::IfThenElse(hn::Lt(a.part[p], b.part[p]), a.part[p], b.part[p]);
#endif
    return r;
}
TERRAZZO_INLINE F32x16 max(F32x16 a, F32x16 b) {
    F32x16 r;
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR
    TERRAZZO_FOR_PARTS r.part[p] = hn::Max(a.part[p], b.part[p]);
#else
    TERRAZZO_FOR_PARTS r.part[p] = hn::IfThenElse(hn::Gt(a.part[p], b.part[p]), a.part[p], b.part[p]);
#endif
    return r;
}
// Into [low, high]; NaN becomes `low`.
TERRAZZO_INLINE F32x16 clamp(F32x16 v, F32x16 low, F32x16 high) {
    return min(max(v, low), high);
}
TERRAZZO_INLINE I32x16 clamp(I32x16 v, I32x16 low, I32x16 high) {
    return min(max(v, low), high);
}

#define TERRAZZO_UNARY_F(name, operation)                        \
    TERRAZZO_INLINE F32x16 name(F32x16 a) {                      \
        F32x16 r;                                                \
        TERRAZZO_FOR_PARTS r.part[p] = hn::operation(a.part[p]); \
        return r;                                                \
    }
TERRAZZO_UNARY_F(operator-, Neg)
TERRAZZO_UNARY_F(abs, Abs)
#if !HWY_ARCH_ARM_V7 || HWY_TARGET == HWY_SCALAR
TERRAZZO_UNARY_F(sqrt, Sqrt)
#endif
#undef TERRAZZO_UNARY_F

TERRAZZO_INLINE F32x16 floor(F32x16 a) {
    F32x16 r;
#if HWY_TARGET == HWY_SCALAR
    TERRAZZO_FOR_PARTS r.part[p] = hn::Set(TagF(), __builtin_floorf(hn::GetLane(a.part[p])));
#else
    TERRAZZO_FOR_PARTS r.part[p] = hn::Floor(a.part[p]);
#endif
    return r;
}

template <int kBits>
TERRAZZO_INLINE I32x16 shift_left(I32x16 a) {
    I32x16 r;
    TERRAZZO_FOR_PARTS r.part[p] = hn::ShiftLeft<kBits>(a.part[p]);
    return r;
}
// Arithmetic: the sign is kept.
template <int kBits>
TERRAZZO_INLINE I32x16 shift_right(I32x16 a) {
    I32x16 r;
    TERRAZZO_FOR_PARTS r.part[p] = hn::ShiftRight<kBits>(a.part[p]);
    return r;
}
// Zeros come in at the top.
template <int kBits>
TERRAZZO_INLINE I32x16 shift_right_logical(I32x16 a) {
    I32x16 r;
    TERRAZZO_FOR_PARTS r.part[p] = hn::BitCast(TagI(), hn::ShiftRight<kBits>(hn::BitCast(TagU(), a.part[p])));
    return r;
}

TERRAZZO_INLINE F32x16 select(Mask16 mask, F32x16 yes, F32x16 no) {
    F32x16 r;
    TERRAZZO_FOR_PARTS r.part[p] = hn::IfThenElse(mask.part[p], yes.part[p], no.part[p]);
    return r;
}
TERRAZZO_INLINE I32x16 select(Mask16 mask, I32x16 yes, I32x16 no) {
    I32x16 r;
    TERRAZZO_FOR_PARTS r.part[p] =
        hn::IfThenElse(hn::RebindMask(TagI(), mask.part[p]), yes.part[p], no.part[p]);
    return r;
}

// Loads and stores of 16 consecutive values; `_u` takes any alignment, the others 64 bytes.
TERRAZZO_INLINE F32x16 load(const float* from) {
    F32x16 r;
    TERRAZZO_FOR_PARTS r.part[p] = hn::Load(TagF(), from + p * kNativeLanes);
    return r;
}
TERRAZZO_INLINE F32x16 load_u(const float* from) {
    F32x16 r;
    TERRAZZO_FOR_PARTS r.part[p] = hn::LoadU(TagF(), from + p * kNativeLanes);
    return r;
}
TERRAZZO_INLINE I32x16 load(const int32_t* from) {
    I32x16 r;
    TERRAZZO_FOR_PARTS r.part[p] = hn::Load(TagI(), from + p * kNativeLanes);
    return r;
}
TERRAZZO_INLINE I32x16 load(const uint32_t* from) {
    return load(reinterpret_cast<const int32_t*>(from));
}
TERRAZZO_INLINE I32x16 load_u(const int32_t* from) {
    I32x16 r;
    TERRAZZO_FOR_PARTS r.part[p] = hn::LoadU(TagI(), from + p * kNativeLanes);
    return r;
}
TERRAZZO_INLINE void store(F32x16 v, float* to) {
    TERRAZZO_FOR_PARTS hn::Store(v.part[p], TagF(), to + p * kNativeLanes);
}
TERRAZZO_INLINE void store(I32x16 v, int32_t* to) {
    TERRAZZO_FOR_PARTS hn::Store(v.part[p], TagI(), to + p * kNativeLanes);
}
TERRAZZO_INLINE void store(I32x16 v, uint32_t* to) {
    store(v, reinterpret_cast<int32_t*>(to));
}
// Stores the lanes of `mask` and leaves the others as they are in memory, which no other thread writes
// meanwhile: before AVX-512 all of it is stored again. Masked stores take tens of steps on many processors
// with AVX2, and there are none in SSE.
TERRAZZO_INLINE void store_masked(Mask16 mask, I32x16 v, uint32_t* to) {
    int32_t* const out = reinterpret_cast<int32_t*>(to);
    TERRAZZO_FOR_PARTS {
        const auto lanes = hn::RebindMask(TagI(), mask.part[p]);
        int32_t* const part = out + p * kNativeLanes;
        if constexpr (kNativeLanes == 16) {
            hn::BlendedStore(v.part[p], lanes, TagI(), part);
        } else {
            hn::Store(hn::IfThenElse(lanes, v.part[p], hn::Load(TagI(), part)), TagI(), part);
        }
    }
}

// Sixteen bytes; those stored are numbers from 0 to 255.
TERRAZZO_INLINE I32x16 load_bytes(const uint8_t* from) {
    I32x16 r;
#if HWY_TARGET == HWY_SCALAR
    TERRAZZO_FOR_PARTS r.part[p] = hn::Set(TagI(), from[p]);
#else
    using TagBytes = hn::Rebind<uint8_t, TagI>;
    TERRAZZO_FOR_PARTS r.part[p] = hn::PromoteTo(TagI(), hn::LoadU(TagBytes(), from + p * kNativeLanes));
#endif
    return r;
}
TERRAZZO_INLINE void store_bytes(I32x16 v, uint8_t* to) {
#if HWY_TARGET == HWY_SCALAR
    TERRAZZO_FOR_PARTS to[p] = static_cast<uint8_t>(hn::GetLane(v.part[p]));
#else
    using TagBytes = hn::Rebind<uint8_t, TagI>;
    TERRAZZO_FOR_PARTS hn::StoreU(hn::DemoteTo(TagBytes(), v.part[p]), TagBytes(), to + p * kNativeLanes);
#endif
}

// The same of sixteen numbers from 0 to 65535, at even addresses.
TERRAZZO_INLINE I32x16 load_shorts(const uint16_t* from) {
    I32x16 r;
#if HWY_TARGET == HWY_SCALAR
    TERRAZZO_FOR_PARTS r.part[p] = hn::Set(TagI(), from[p]);
#else
    using TagShorts = hn::Rebind<uint16_t, TagI>;
    TERRAZZO_FOR_PARTS r.part[p] = hn::PromoteTo(TagI(), hn::LoadU(TagShorts(), from + p * kNativeLanes));
#endif
    return r;
}
TERRAZZO_INLINE void store_shorts(I32x16 v, uint16_t* to) {
#if HWY_TARGET == HWY_SCALAR
    TERRAZZO_FOR_PARTS to[p] = static_cast<uint16_t>(hn::GetLane(v.part[p]));
#else
    using TagShorts = hn::Rebind<uint16_t, TagI>;
    TERRAZZO_FOR_PARTS hn::StoreU(hn::DemoteTo(TagShorts(), v.part[p]), TagShorts(), to + p * kNativeLanes);
#endif
}

// The channels of sixteen pixels that have four each, apart: lane i of channel c is at 4 * i + c in memory.
TERRAZZO_INLINE void load_channels(const float* from, F32x16 (&to)[4]) {
    TERRAZZO_FOR_PARTS hn::LoadInterleaved4(TagF(), from + 4 * kNativeLanes * p, to[0].part[p], to[1].part[p],
                                            to[2].part[p], to[3].part[p]);
}
TERRAZZO_INLINE void store_channels(const F32x16 (&from)[4], float* to) {
    TERRAZZO_FOR_PARTS hn::StoreInterleaved4(from[0].part[p], from[1].part[p], from[2].part[p],
                                             from[3].part[p], TagF(), to + 4 * kNativeLanes * p);
}
TERRAZZO_INLINE void load_channels(const uint16_t* from, I32x16 (&to)[4]) {
    using TagShorts = hn::Rebind<uint16_t, TagI>;
    TERRAZZO_FOR_PARTS {
        hn::Vec<TagShorts> channels[4];
        hn::LoadInterleaved4(TagShorts(), from + 4 * kNativeLanes * p, channels[0], channels[1], channels[2],
                             channels[3]);
        for (int c = 0; c < 4; ++c) to[c].part[p] = hn::PromoteTo(TagI(), channels[c]);
    }
}
// Numbers from 0 to 65535.
TERRAZZO_INLINE void store_channels(const I32x16 (&from)[4], uint16_t* to) {
    using TagShorts = hn::Rebind<uint16_t, TagI>;
    TERRAZZO_FOR_PARTS hn::StoreInterleaved4(
        hn::DemoteTo(TagShorts(), from[0].part[p]), hn::DemoteTo(TagShorts(), from[1].part[p]),
        hn::DemoteTo(TagShorts(), from[2].part[p]), hn::DemoteTo(TagShorts(), from[3].part[p]), TagShorts(),
        to + 4 * kNativeLanes * p);
}

#if HWY_ARCH_ARM_V7 && HWY_TARGET != HWY_SCALAR
// ARMv7's vectors only estimate quotients and roots; its scalar unit rounds them as everybody does.
TERRAZZO_INLINE F32x16 operator/(F32x16 a, F32x16 b) {
    alignas(64) float x[16], y[16];
    store(a, x), store(b, y);
    for (int i = 0; i < 16; ++i) x[i] /= y[i];
    return load(x);
}
TERRAZZO_INLINE F32x16 sqrt(F32x16 a) {
    alignas(64) float x[16];
    store(a, x);
    for (float& value : x) value = __builtin_sqrtf(value);
    return load(x);
}
#endif

TERRAZZO_INLINE F32x16 to_float(I32x16 a) {
    F32x16 r;
    TERRAZZO_FOR_PARTS r.part[p] = hn::ConvertTo(TagF(), a.part[p]);
    return r;
}
// x86 has instructions for these two that are only undefined where the callers never go, out of int32's
// range; Highway's portable versions pay five more to be defined there.
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR
#if HWY_TARGET <= HWY_AVX3
#define TERRAZZO_X86(name) _mm512_##name
#elif HWY_TARGET <= HWY_AVX2
#define TERRAZZO_X86(name) _mm256_##name
#else
#define TERRAZZO_X86(name) _mm_##name
#endif
#endif

// To the nearest integer, ties to even; |a| must be below 2^31 (the callers clamp).
TERRAZZO_INLINE I32x16 round_to_int(F32x16 a) {
    I32x16 r;
#if HWY_TARGET == HWY_SCALAR
    TERRAZZO_FOR_PARTS r.part[p] =
        hn::Set(TagI(), static_cast<int32_t>(__builtin_rintf(hn::GetLane(a.part[p]))));
#elif defined(TERRAZZO_X86)
    TERRAZZO_FOR_PARTS r.part[p].raw = TERRAZZO_X86(cvtps_epi32)(a.part[p].raw);
#else
    TERRAZZO_FOR_PARTS r.part[p] = hn::NearestInt(a.part[p]);
#endif
    return r;
}
// Towards zero; |a| must be below 2^31.
TERRAZZO_INLINE I32x16 truncate_to_int(F32x16 a) {
    I32x16 r;
#if defined(TERRAZZO_X86)
    TERRAZZO_FOR_PARTS r.part[p].raw = TERRAZZO_X86(cvttps_epi32)(a.part[p].raw);
#else
    TERRAZZO_FOR_PARTS r.part[p] = hn::ConvertTo(TagI(), a.part[p]);
#endif
    return r;
}

// a * b of numbers from 0 to 32767.
TERRAZZO_INLINE I32x16 multiply_small(I32x16 a, I32x16 b) {
#if defined(TERRAZZO_X86)
    // One multiply-add of 16-bit pairs, a third of a full product's time.
    I32x16 r;
    TERRAZZO_FOR_PARTS r.part[p].raw = TERRAZZO_X86(madd_epi16)(a.part[p].raw, b.part[p].raw);
    return r;
#else
    return a * b;
#endif
}

// base[index] a lane, index in elements.
#if defined(TERRAZZO_X86) && HWY_TARGET <= HWY_AVX2
// Loads of single words, into registers: gather instructions take up to seven times as many steps on AMD's
// processors, and microcode has made them slow on many of Intel's.
TERRAZZO_INLINE I32x16 gather(const int32_t* base, I32x16 index) {
    alignas(64) int32_t at[16];
    store(index, at);
    // Or gcc takes the words out of the vector again, one by one.
    __asm__("" : "+m"(at));
    const auto four = [&](int i) TERRAZZO_INLINE_LAMBDA {
        const auto word = [&](int j) TERRAZZO_INLINE_LAMBDA {
            return _mm_castsi128_ps(_mm_loadu_si32(base + at[i + j]));
        };
        const __m128 two = _mm_insert_ps(word(0), word(1), 0x10);
        return _mm_insert_ps(_mm_insert_ps(two, word(2), 0x20), word(3), 0x30);
    };
    const auto eight = [&](int i) TERRAZZO_INLINE_LAMBDA {
        return _mm256_insertf128_ps(_mm256_castps128_ps256(four(i)), four(i + 4), 1);
    };
    I32x16 r;
#if HWY_TARGET <= HWY_AVX3
    const __m512 low = _mm512_castps256_ps512(eight(0));
    r.part[0].raw = _mm512_castps_si512(_mm512_insertf32x8(low, eight(8), 1));
#else
    TERRAZZO_FOR_PARTS r.part[p].raw = _mm256_castps_si256(eight(8 * p));
#endif
    return r;
}
TERRAZZO_INLINE F32x16 gather(const float* base, I32x16 index) {
    // The words are loaded as what may alias anything.
    const I32x16 bits = gather(reinterpret_cast<const int32_t*>(base), index);
    F32x16 r;
    TERRAZZO_FOR_PARTS r.part[p] = hn::BitCast(TagF(), bits.part[p]);
    return r;
}
#else
TERRAZZO_INLINE F32x16 gather(const float* base, I32x16 index) {
    F32x16 r;
    TERRAZZO_FOR_PARTS r.part[p] = hn::GatherIndex(TagF(), base, index.part[p]);
    return r;
}
TERRAZZO_INLINE I32x16 gather(const int32_t* base, I32x16 index) {
    I32x16 r;
    TERRAZZO_FOR_PARTS r.part[p] = hn::GatherIndex(TagI(), base, index.part[p]);
    return r;
}
#endif

// base[index[i]] and base[index[i] + 1] for the lanes i of one native vector; `index` was written long enough
// ago to be read word by word. Loads of eight bytes and a transposition: two thirds to half of what gathers
// take on the processors measured.
struct NativePair {
    NativeI first, second;
};
TERRAZZO_INLINE NativePair load_pairs(const int32_t* base, const int32_t* index) {
#if defined(TERRAZZO_X86)
    const auto two = [&](int i, int j) TERRAZZO_INLINE_LAMBDA {
        const auto* const low = reinterpret_cast<const __m128i*>(base + index[i]);
        const auto* const high = reinterpret_cast<const __m64*>(base + index[j]);
        return _mm_loadh_pi(_mm_castsi128_ps(_mm_loadl_epi64(low)), high);
    };
    NativePair r;
#if HWY_TARGET <= HWY_AVX3
    const auto blocks = [&](int i) TERRAZZO_INLINE_LAMBDA {
        const __m256 low = _mm256_insertf128_ps(_mm256_castps128_ps256(two(i, i + 1)), two(i + 4, i + 5), 1);
        const __m256 high =
            _mm256_insertf128_ps(_mm256_castps128_ps256(two(i + 8, i + 9)), two(i + 12, i + 13), 1);
        return _mm512_insertf32x8(_mm512_castps256_ps512(low), high, 1);
    };
    const __m512 even = blocks(0), odd = blocks(2);
    r.first.raw = _mm512_castps_si512(_mm512_shuffle_ps(even, odd, 0x88));
    r.second.raw = _mm512_castps_si512(_mm512_shuffle_ps(even, odd, 0xdd));
#elif HWY_TARGET <= HWY_AVX2
    const auto blocks = [&](int i) TERRAZZO_INLINE_LAMBDA {
        return _mm256_insertf128_ps(_mm256_castps128_ps256(two(i, i + 1)), two(i + 4, i + 5), 1);
    };
    const __m256 even = blocks(0), odd = blocks(2);
    r.first.raw = _mm256_castps_si256(_mm256_shuffle_ps(even, odd, 0x88));
    r.second.raw = _mm256_castps_si256(_mm256_shuffle_ps(even, odd, 0xdd));
#else
    const __m128 even = two(0, 1), odd = two(2, 3);
    r.first.raw = _mm_castps_si128(_mm_shuffle_ps(even, odd, 0x88));
    r.second.raw = _mm_castps_si128(_mm_shuffle_ps(even, odd, 0xdd));
#endif
    return r;
#elif HWY_TARGET == HWY_SCALAR
    return {hn::Set(TagI(), base[index[0]]), hn::Set(TagI(), base[index[0] + 1])};
#else
    using TagTwo = hn::Half<TagI>;
    static_assert(kNativeLanes == 4);
    const auto two = [&](int i, int j) {
        return hn::Combine(TagI(), hn::LoadU(TagTwo(), base + index[j]),
                           hn::LoadU(TagTwo(), base + index[i]));
    };
    const auto even = two(0, 1), odd = two(2, 3);
    return {hn::ConcatEven(TagI(), odd, even), hn::ConcatOdd(TagI(), odd, even)};
#endif
}

// base[index] and base[index + 1] a lane.
struct I32x16Pair {
    I32x16 first, second;
};
TERRAZZO_INLINE I32x16Pair gather_pairs(const int32_t* base, I32x16 index) {
    I32x16Pair r;
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET <= HWY_AVX3
    // Half as many loads as two gathers of single words.
    const __m512i low = _mm512_i32gather_epi64(_mm512_castsi512_si256(index.part[0].raw), base, 4);
    const __m512i high = _mm512_i32gather_epi64(_mm512_extracti64x4_epi64(index.part[0].raw, 1), base, 4);
    const __m512i even = _mm512_setr_epi32(0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
    r.first.part[0].raw = _mm512_permutex2var_epi32(low, even, high);
    r.second.part[0].raw = _mm512_permutex2var_epi32(low, _mm512_add_epi32(even, _mm512_set1_epi32(1)), high);
#else
    alignas(64) int32_t at[16], first[16], second[16];
    store(index, at);
    for (int i = 0; i < 16; ++i) first[i] = base[at[i]], second[i] = base[at[i] + 1];
    r.first = load(first);
    r.second = load(second);
#endif
    return r;
}

// The same by load_pairs, for who has nothing else to do meanwhile: better than gathers, and worse than
// words that the compiler picks itself where other work can go on beside the loads.
TERRAZZO_INLINE I32x16Pair gather_pairs_from_memory(const int32_t* base, I32x16 index) {
    alignas(64) int32_t at[16];
    store(index, at);
    // Or gcc takes the words out of the vector again, one by one.
    __asm__ volatile("" : "+m"(at));
    I32x16Pair r;
    TERRAZZO_FOR_PARTS {
        const NativePair pair = load_pairs(base, at + p * kNativeLanes);
        r.first.part[p] = pair.first;
        r.second.part[p] = pair.second;
    }
    return r;
}

// The four floats from base[4 * index] on a lane, the same number of each lane together.
struct F32x16Four {
    F32x16 value[4];
};
TERRAZZO_INLINE F32x16Four gather_fours(const float* base, I32x16 index) {
    F32x16Four r;
#if defined(TERRAZZO_X86)
    alignas(64) int32_t at[16];
    store(index, at);
    __asm__ volatile("" : "+m"(at));
    TERRAZZO_FOR_PARTS {
        const auto four = [&](int i) TERRAZZO_INLINE_LAMBDA {
            return _mm_loadu_ps(base + 4 * static_cast<std::ptrdiff_t>(at[p * kNativeLanes + i]));
        };
#if HWY_TARGET <= HWY_AVX3
        const auto row = [&](int i) TERRAZZO_INLINE_LAMBDA {
            const __m256 low = _mm256_insertf128_ps(_mm256_castps128_ps256(four(i)), four(i + 4), 1);
            const __m256 high = _mm256_insertf128_ps(_mm256_castps128_ps256(four(i + 8)), four(i + 12), 1);
            return _mm512_insertf32x8(_mm512_castps256_ps512(low), high, 1);
        };
#elif HWY_TARGET <= HWY_AVX2
        const auto row = [&](int i) TERRAZZO_INLINE_LAMBDA {
            return _mm256_insertf128_ps(_mm256_castps128_ps256(four(i)), four(i + 4), 1);
        };
#else
        const auto row = four;
#endif
        // Four by four, transposed.
        const auto v0 = row(0), v1 = row(1), v2 = row(2), v3 = row(3);
        const auto t0 = TERRAZZO_X86(unpacklo_ps)(v0, v1), t1 = TERRAZZO_X86(unpackhi_ps)(v0, v1),
                   t2 = TERRAZZO_X86(unpacklo_ps)(v2, v3), t3 = TERRAZZO_X86(unpackhi_ps)(v2, v3);
        r.value[0].part[p].raw = TERRAZZO_X86(shuffle_ps)(t0, t2, 0x44);
        r.value[1].part[p].raw = TERRAZZO_X86(shuffle_ps)(t0, t2, 0xee);
        r.value[2].part[p].raw = TERRAZZO_X86(shuffle_ps)(t1, t3, 0x44);
        r.value[3].part[p].raw = TERRAZZO_X86(shuffle_ps)(t1, t3, 0xee);
    }
#else
    const I32x16 first = shift_left<2>(index);
    for (int i = 0; i < 4; ++i) r.value[i] = gather(base + i, first);
#endif
    return r;
}

TERRAZZO_INLINE I32x16 as_int(F32x16 a) {
    I32x16 r;
    TERRAZZO_FOR_PARTS r.part[p] = hn::BitCast(TagI(), a.part[p]);
    return r;
}
TERRAZZO_INLINE F32x16 as_float(I32x16 a) {
    F32x16 r;
    TERRAZZO_FOR_PARTS r.part[p] = hn::BitCast(TagF(), a.part[p]);
    return r;
}

// Bit i of the result is lane i.
TERRAZZO_INLINE uint32_t bits_of(Mask16 mask) {
#if HWY_TARGET == HWY_SCALAR
    uint32_t bits = 0;
    TERRAZZO_FOR_PARTS bits |= (mask.part[p].bits ? 1u : 0u) << p;
    return bits;
#elif HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX3
    return mask.part[0].raw;
#else
    uint32_t bits = 0;
    TERRAZZO_FOR_PARTS {
        uint8_t bytes[8] = {};
        hn::StoreMaskBits(TagF(), mask.part[p], bytes);
        bits |= static_cast<uint32_t>(bytes[0]) << (p * kNativeLanes);
    }
    return bits;
#endif
}
TERRAZZO_INLINE Mask16 mask_from_bits(uint32_t bits) {
    Mask16 r;
#if HWY_TARGET == HWY_SCALAR
    TERRAZZO_FOR_PARTS r.part[p] = hn::Mask1<float>::FromBool((bits >> p & 1) != 0);
#elif HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX3
    r.part[0].raw = static_cast<__mmask16>(bits);
#else
    TERRAZZO_FOR_PARTS {
        const uint8_t bytes[8] = {
            static_cast<uint8_t>(bits >> (p * kNativeLanes) & ((1u << kNativeLanes) - 1))};
        r.part[p] = hn::LoadMaskBits(TagF(), bytes);
    }
#endif
    return r;
}
TERRAZZO_INLINE bool any(Mask16 mask) {
    return bits_of(mask) != 0;
}
// Bit i is set where lane i is negative.
TERRAZZO_INLINE uint32_t sign_bits(I32x16 v) {
#if defined(TERRAZZO_X86) && HWY_TARGET > HWY_AVX3
    // Their instruction looks at the sign alone: nothing needs to be compared.
    uint32_t bits = 0;
    TERRAZZO_FOR_PARTS bits |=
        static_cast<uint32_t>(TERRAZZO_X86(movemask_ps)(hn::BitCast(TagF(), v.part[p]).raw))
        << (p * kNativeLanes);
    return bits;
#else
    return bits_of(v < I32x16(0));
#endif
}

TERRAZZO_INLINE int32_t largest_lane(I32x16 v) {
#if HWY_TARGET == HWY_SCALAR
    int32_t largest = hn::GetLane(v.part[0]);
    for (int p = 1; p < kParts; ++p)
        largest = largest > hn::GetLane(v.part[p]) ? largest : hn::GetLane(v.part[p]);
    return largest;
#else
    NativeI largest = v.part[0];
    for (int p = 1; p < kParts; ++p) largest = hn::Max(largest, v.part[p]);
    return hn::GetLane(hn::MaxOfLanes(TagI(), largest));
#endif
}

// 0, 1, 2, ... 15.
TERRAZZO_INLINE I32x16 lane_numbers() {
    alignas(64) static constexpr int32_t kNumbers[16] = {0, 1, 2,  3,  4,  5,  6,  7,
                                                         8, 9, 10, 11, 12, 13, 14, 15};
    return load(kNumbers);
}
// Of a 4x4 tile: each pixel's neighbour in its 2x2 quad, across and along.
TERRAZZO_INLINE F32x16 swap_columns(F32x16 v) {
    F32x16 r;
#if HWY_TARGET == HWY_SCALAR
    TERRAZZO_FOR_PARTS r.part[p] = v.part[p ^ 1];
#else
    TERRAZZO_FOR_PARTS r.part[p] = hn::Shuffle2301(v.part[p]);
#endif
    return r;
}
TERRAZZO_INLINE F32x16 swap_rows(F32x16 v) {
    F32x16 r;
    if constexpr (kNativeLanes <= 4) {
        TERRAZZO_FOR_PARTS r.part[p] = v.part[p ^ (4 / kNativeLanes)];
    } else {
#if HWY_TARGET != HWY_SCALAR
        TERRAZZO_FOR_PARTS r.part[p] = hn::SwapAdjacentBlocks(v.part[p]);
#endif
    }
    return r;
}

// Column and row of each lane in a 4x4 tile.
TERRAZZO_INLINE I32x16 lane_x() {
    return lane_numbers() & I32x16(3);
}
TERRAZZO_INLINE I32x16 lane_y() {
    return shift_right<2>(lane_numbers());
}

#if HWY_TARGET != HWY_SCALAR && HWY_HAVE_FLOAT64
// Doubles in vectors as wide as the floats': two cover what one of floats does. (Highway's scalar doubles
// become floats with infinities cut off.)
using TagHalfF = hn::Half<TagF>;
using TagHalfI = hn::Half<TagI>;
using TagWide = hn::Rebind<double, TagHalfF>;
using NativeWide = hn::Vec<TagWide>;
#endif

// a * b + c rounded once, in arithmetic that rounds every step. The product is exact in double; a sum that
// was rounded to half-way between two floats is moved off it, to where the exact sum lies.
TERRAZZO_INLINE float fused_multiply_add(float a, float b, float c) {
    const double product = static_cast<double>(a) * b;
    const double sum = product + c;
    uint64_t bits;
    std::memcpy(&bits, &sum, sizeof bits);
    if ((bits & 0x1fffffff) != 0x10000000) return static_cast<float>(sum);
    // What the sum leaves out [Knuth, TAOCP 2, 4.2.2 theorem B].
    const double of_c = sum - product;
    const double rest = (product - (sum - of_c)) + (c - of_c);
    if (rest != 0) {
        bits += (rest > 0) == (sum > 0) ? 1u : ~uint64_t{0};
        double moved;
        std::memcpy(&moved, &bits, sizeof moved);
        return static_cast<float>(moved);
    }
    return static_cast<float>(sum);
}

#if HWY_NATIVE_FMA
TERRAZZO_INLINE F32x16 fused_multiply_add(F32x16 a, F32x16 b, F32x16 c) {
    F32x16 r;
    TERRAZZO_FOR_PARTS r.part[p] = hn::MulAdd(a.part[p], b.part[p], c.part[p]);
    return r;
}
#else
TERRAZZO_NOINLINE F32x16 fused_lane_by_lane(F32x16 a, F32x16 b, F32x16 c) {
    alignas(64) float x[16], y[16], z[16];
    store(a, x), store(b, y), store(c, z);
    for (int i = 0; i < 16; ++i) z[i] = fused_multiply_add(x[i], y[i], z[i]);
    return load(z);
}
#if HWY_TARGET != HWY_SCALAR && HWY_HAVE_FLOAT64
// Collects whether any sum lies half-way between two floats.
class Ties {
  public:
    TERRAZZO_INLINE void add(NativeWide sum) {
        const auto low = hn::And(hn::BitCast(Tag(), sum), hn::Set(Tag(), 0x1fffffff));
        m_found = hn::Or(m_found, hn::VecFromMask(Tag(), hn::Eq(low, hn::Set(Tag(), 0x10000000))));
    }
    TERRAZZO_INLINE bool found() const { return !hn::AllTrue(Tag(), hn::Eq(m_found, hn::Zero(Tag()))); }

  private:
    using Tag = hn::Repartition<uint64_t, TagWide>;
    hn::Vec<Tag> m_found = hn::Zero(Tag());
};
TERRAZZO_INLINE F32x16 fused_multiply_add(F32x16 a, F32x16 b, F32x16 c) {
    F32x16 r;
    Ties ties;
    TERRAZZO_FOR_PARTS {
        const auto half = [&](auto take) {
            const auto sum = hn::Add(hn::Mul(take(a.part[p]), take(b.part[p])), take(c.part[p]));
            ties.add(sum);
            return hn::DemoteTo(TagHalfF(), sum);
        };
        const auto low =
            half([](NativeF v) { return hn::PromoteTo(TagWide(), hn::LowerHalf(TagHalfF(), v)); });
        const auto high =
            half([](NativeF v) { return hn::PromoteTo(TagWide(), hn::UpperHalf(TagHalfF(), v)); });
        r.part[p] = hn::Combine(TagF(), high, low);
    }
    if (ties.found()) return fused_lane_by_lane(a, b, c);
    return r;
}
#else
TERRAZZO_INLINE F32x16 fused_multiply_add(F32x16 a, F32x16 b, F32x16 c) {
    return fused_lane_by_lane(a, b, c);
}
#endif
#endif

// a*b - c*d of integers below 2^25, with the right sign (zero included) and the precision of a float.
TERRAZZO_INLINE F32x16 cross(I32x16 a, I32x16 b, I32x16 c, I32x16 d) {
    F32x16 r;
#if HWY_TARGET != HWY_SCALAR && HWY_HAVE_FLOAT64
    TERRAZZO_FOR_PARTS {
        const auto low = [](NativeI v) { return hn::PromoteTo(TagWide(), hn::LowerHalf(TagHalfI(), v)); };
        const auto high = [](NativeI v) { return hn::PromoteTo(TagWide(), hn::UpperHalf(TagHalfI(), v)); };
        const auto l =
            hn::Sub(hn::Mul(low(a.part[p]), low(b.part[p])), hn::Mul(low(c.part[p]), low(d.part[p])));
        const auto h =
            hn::Sub(hn::Mul(high(a.part[p]), high(b.part[p])), hn::Mul(high(c.part[p]), high(d.part[p])));
        r.part[p] = hn::Combine(TagF(), hn::DemoteTo(TagHalfF(), h), hn::DemoteTo(TagHalfF(), l));
    }
#else
    alignas(64) int32_t w[16], x[16], y[16], z[16];
    alignas(64) float out[16];
    store(a, w), store(b, x), store(c, y), store(d, z);
    for (int i = 0; i < 16; ++i)
        out[i] = static_cast<float>(static_cast<double>(int64_t{w[i]} * x[i] - int64_t{y[i]} * z[i]));
    r = load(out);
#endif
    return r;
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
