// One component of a client pixel, in all its types: loading and storing in either byte order, and conversion
// to and from floats, bytes, indices and depths (GL 1.5 tables 2.9, 4.6, 4.7).
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <type_traits>
#include <utility>

#include "gl/client_pixel.h"
#include "gl/pixel_convert.h"

namespace terrazzo::gl {

inline uint8_t byte_swapped(uint8_t value) {
    return value;
}
inline uint16_t byte_swapped(uint16_t value) {
    return __builtin_bswap16(value);
}
inline uint32_t byte_swapped(uint32_t value) {
    return __builtin_bswap32(value);
}

template <typename T>
using Bits =
    std::conditional_t<sizeof(T) == 1, uint8_t, std::conditional_t<sizeof(T) == 2, uint16_t, uint32_t>>;

template <typename T>
T load_component(const uint8_t* source, int index, bool swap_bytes) {
    Bits<T> bits;
    std::memcpy(&bits, source + static_cast<size_t>(index) * sizeof(T), sizeof(T));
    return std::bit_cast<T>(swap_bytes ? byte_swapped(bits) : bits);
}

template <typename T>
void store_component(T value, uint8_t* destination, int index, bool swap_bytes) {
    auto bits = std::bit_cast<Bits<T>>(value);
    if (swap_bytes) bits = byte_swapped(bits);
    std::memcpy(destination + static_cast<size_t>(index) * sizeof(T), &bits, sizeof(T));
}

// Calls `body` with a value of the C type that `type` (unpacked, not a bitmap) stands for.
template <typename Body>
void with_type(GLenum type, Body body) {
    switch (type) {
        case GL_BYTE:
            body(int8_t{});
            break;
        case GL_UNSIGNED_SHORT:
            body(uint16_t{});
            break;
        case GL_SHORT:
            body(int16_t{});
            break;
        case GL_UNSIGNED_INT:
            body(uint32_t{});
            break;
        case GL_INT:
            body(int32_t{});
            break;
        case GL_FLOAT:
            body(float{});
            break;
        default:
            body(uint8_t{});
            break;
    }
}

template <typename T>
float to_float(T value) {
    if constexpr (std::is_same_v<T, float>) {
        return value;
    } else {
        // The reference multiplies by the reciprocal; so do we, for the last bit.
        constexpr float kScale = 1.0f / static_cast<float>(std::numeric_limits<T>::max());
        return std::max(static_cast<float>(value) * kScale, -1.0f);
    }
}

template <typename T>
T from_float(float value) {
    if constexpr (std::is_same_v<T, float>) {
        return value;
    } else if constexpr (sizeof(T) <= 2) {
        constexpr float kMaximum = std::numeric_limits<T>::max();
        float bounded = clamp_to_unit(value);
        if constexpr (std::is_signed_v<T>) bounded -= clamp_to_unit(-value);
        return static_cast<T>(round_to_int(bounded * kMaximum));
    } else {
        constexpr double kMaximum = std::numeric_limits<T>::max();
        double bounded = static_cast<double>(clamp_to_unit(value));
        if constexpr (std::is_signed_v<T>) bounded -= static_cast<double>(clamp_to_unit(-value));
        return static_cast<T>(std::llrint(bounded * kMaximum));
    }
}

// An 8-bit component in type T, with integer arithmetic only: wider types repeat its bits.
template <typename T>
T from_8_bits(unsigned value) {
    if constexpr (std::is_same_v<T, float>) {
        return static_cast<float>(value) * (1.0f / 255.0f);
    } else if constexpr (std::is_same_v<T, int8_t>) {
        return static_cast<int8_t>(resize_unorm(value, 8, 7));
    } else {
        const unsigned repeated = value * 0x01010101u;
        constexpr unsigned kDrop = 32 - std::numeric_limits<T>::digits;
        return static_cast<T>(repeated >> kDrop);
    }
}

template <typename T>
uint32_t to_index(T value) {
    // A float beyond the integers has no meaning as an index, but must not be undefined behaviour.
    if constexpr (std::is_same_v<T, float>) {
        if (!(value == value)) return 0;
        const double bounded = std::clamp(static_cast<double>(value), -2147483648.0, 4294967295.0);
        return static_cast<uint32_t>(static_cast<int64_t>(bounded));
    } else {
        return static_cast<uint32_t>(value);
    }
}

template <typename T>
T from_index(uint32_t index) {
    if constexpr (std::is_same_v<T, float>) {
        return static_cast<float>(index);
    } else {
        return static_cast<T>(index & static_cast<uint32_t>(std::numeric_limits<T>::max()));
    }
}

// As the reference rounds depths: only 16 unsigned bits to nearest, short signed types by the formula of
// GL 1.5 table 4.7 and the others downwards.
template <typename T>
T from_depth(float depth) {
    if constexpr (std::is_same_v<T, float>) {
        return depth;
    } else if constexpr (std::is_same_v<T, uint16_t>) {
        return static_cast<uint16_t>(std::lrint(depth * 65535.0f));
    } else if constexpr (std::is_same_v<T, int8_t> || std::is_same_v<T, int16_t>) {
        constexpr float kMaximum = std::numeric_limits<std::make_unsigned_t<T>>::max();
        return static_cast<T>((static_cast<int>(depth * kMaximum) - 1) / 2);
    } else {
        constexpr double kMaximum = std::numeric_limits<T>::max();
        return static_cast<T>(static_cast<double>(depth) * kMaximum);
    }
}

template <int kBytes>
using PackedInteger =
    std::conditional_t<kBytes == 1, uint8_t, std::conditional_t<kBytes == 2, uint16_t, uint32_t>>;

// Calls `body` with `type`, a packed one, as a template argument: its fields become constants.
template <typename Body>
void with_packed_type(GLenum type, Body body) {
    const auto try_one = [&]<size_t kIndex>() {
        if (kPackedTypes[kIndex].type == type) body.template operator()<kPackedTypes[kIndex]>();
    };
    [&]<size_t... kIndices>(std::index_sequence<kIndices...>) {
        (try_one.template operator()<kIndices>(), ...);
    }
    (std::make_index_sequence<std::size(kPackedTypes)>());
}

// `convert<bits>(field)` makes a component of a field.
template <PackedType kPacked, typename T, typename Convert>
void unpack_fields(const uint8_t* source, bool swap_bytes, int count, T* components, Convert convert) {
    for (int i = 0; i < count; ++i, components += kPacked.components) {
        const unsigned pixel = load_component<PackedInteger<kPacked.bytes>>(source, i, swap_bytes);
        [&]<size_t... c>(std::index_sequence<c...>) {
            ((components[c] = static_cast<T>(convert.template operator()<kPacked.bits[c]>(
                  pixel >> kPacked.shift[c] & ((1u << kPacked.bits[c]) - 1)))),
             ...);
        }
        (std::make_index_sequence<kPacked.components>());
    }
}

// `convert<bits>(component)` makes a field of a component.
template <PackedType kPacked, typename T, typename Convert>
void pack_fields(const T* components, bool swap_bytes, int count, uint8_t* destination, Convert convert) {
    for (int i = 0; i < count; ++i, components += kPacked.components) {
        unsigned pixel = 0;
        [&]<size_t... c>(std::index_sequence<c...>) {
            ((pixel |= convert.template operator()<kPacked.bits[c]>(components[c]) << kPacked.shift[c]), ...);
        }
        (std::make_index_sequence<kPacked.components>());
        store_component(static_cast<PackedInteger<kPacked.bytes>>(pixel), destination, i, swap_bytes);
    }
}

}  // namespace terrazzo::gl
