// Conversion of rows: components are widened or narrowed in one loop and put in their channels in another, so
// that each loop is small and there are (types + formats) of them, not (types x formats).
#include "gl/pixel_convert.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "gl/client_pixel.h"

namespace terrazzo::gl {
namespace {

using Bytes = uint8_t*;
using ConstBytes = const uint8_t*;

// Where each of R, G, B, A comes from: a component of the client's pixel or a constant.
using Channels = std::array<uint8_t, 4>;
constexpr uint8_t kZero = 4, kOne = 5;

constexpr Channels kIdentity{0, 1, 2, 3};

Channels channels_of(GLenum format) {
    switch (format) {
        case GL_RED:
            return {0, kZero, kZero, kOne};
        case GL_GREEN:
            return {kZero, 0, kZero, kOne};
        case GL_BLUE:
            return {kZero, kZero, 0, kOne};
        case GL_ALPHA:
            return {kZero, kZero, kZero, 0};
        case GL_RGB:
            return {0, 1, 2, kOne};
        case GL_BGR:
            return {2, 1, 0, kOne};
        case GL_BGRA:
            return {2, 1, 0, 3};
        case GL_ABGR_EXT:
            return {3, 2, 1, 0};
        case GL_LUMINANCE:
            return {0, 0, 0, kOne};
        case GL_LUMINANCE_ALPHA:
            return {0, 0, 0, 1};
        default:
            return kIdentity;
    }
}

// The channel of RGBA that each component of a client pixel takes.
Channels components_of(GLenum format) {
    switch (format) {
        case GL_GREEN:
            return {1};
        case GL_BLUE:
            return {2};
        case GL_ALPHA:
            return {3};
        case GL_BGR:
            return {2, 1, 0};
        case GL_BGRA:
            return {2, 1, 0, 3};
        case GL_ABGR_EXT:
            return {3, 2, 1, 0};
        case GL_LUMINANCE_ALPHA:
            return {0, 3};
        default:
            return kIdentity;
    }
}

template <int kComponents, typename T>
void spread(const T* components, Channels channels, T one, int count, T* rgba) {
    T pixel[6] = {};
    pixel[kOne] = one;
    for (int i = 0; i < count; ++i, components += kComponents, rgba += 4) {
        for (int c = 0; c < kComponents; ++c) pixel[c] = components[c];
        for (int c = 0; c < 4; ++c) rgba[c] = pixel[channels[static_cast<size_t>(c)]];
    }
}

template <typename T>
void components_to_rgba(const T* components, GLenum format, T one, int count, T* rgba) {
    const Channels channels = channels_of(format);
    switch (component_count(format)) {
        case 1:
            spread<1>(components, channels, one, count, rgba);
            break;
        case 2:
            spread<2>(components, channels, one, count, rgba);
            break;
        case 3:
            spread<3>(components, channels, one, count, rgba);
            break;
        default:
            spread<4>(components, channels, one, count, rgba);
            break;
    }
}

template <typename T>
void rgba_to_components(const T* rgba, GLenum format, int count, T* components) {
    const Channels source = components_of(format);
    const int n = component_count(format);
    for (int i = 0; i < count; ++i, rgba += 4) {
        for (int c = 0; c < n; ++c) *components++ = rgba[source[static_cast<size_t>(c)]];
    }
}

uint8_t byte_swapped(uint8_t value) {
    return value;
}
uint16_t byte_swapped(uint16_t value) {
    return __builtin_bswap16(value);
}
uint32_t byte_swapped(uint32_t value) {
    return __builtin_bswap32(value);
}

template <typename T>
using Bits =
    std::conditional_t<sizeof(T) == 1, uint8_t, std::conditional_t<sizeof(T) == 2, uint16_t, uint32_t>>;

template <typename T>
T load(ConstBytes source, int index, bool swap_bytes) {
    Bits<T> bits;
    std::memcpy(&bits, source + static_cast<size_t>(index) * sizeof(T), sizeof(T));
    return std::bit_cast<T>(swap_bytes ? byte_swapped(bits) : bits);
}

template <typename T>
void store(T value, Bytes destination, int index, bool swap_bytes) {
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
T from_unit(double value) {
    if constexpr (std::is_same_v<T, float>) {
        return static_cast<float>(value);
    } else {
        constexpr double kMaximum = std::numeric_limits<T>::max();
        constexpr double kMinimum = std::is_signed_v<T> ? -kMaximum : 0.0;
        if (!(value == value)) return 0;
        return static_cast<T>(std::llrint(std::clamp(value * kMaximum, kMinimum, kMaximum)));
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

uint32_t load_packed(ConstBytes source, int bytes, int index, bool swap_bytes) {
    if (bytes == 1) return load<uint8_t>(source, index, false);
    if (bytes == 2) return load<uint16_t>(source, index, swap_bytes);
    return load<uint32_t>(source, index, swap_bytes);
}

void store_packed(uint32_t value, Bytes destination, int bytes, int index, bool swap_bytes) {
    if (bytes == 1) {
        store(static_cast<uint8_t>(value), destination, index, false);
    } else if (bytes == 2) {
        store(static_cast<uint16_t>(value), destination, index, swap_bytes);
    } else {
        store(value, destination, index, swap_bytes);
    }
}

// Calls `put(component index, field, bits)` for every field of `count` packed pixels.
template <typename Put>
void for_each_field(const PackedType& packed, ConstBytes source, bool swap_bytes, int count, Put put) {
    int component = 0;
    for (int i = 0; i < count; ++i) {
        const uint32_t pixel = load_packed(source, packed.bytes, i, swap_bytes);
        for (int c = 0; c < packed.components; ++c, ++component) {
            const unsigned bits = packed.bits[c];
            put(component, (pixel >> packed.shift[c]) & ((1u << bits) - 1), bits);
        }
    }
}

// `field(component index, bits)` gives the fields of `count` packed pixels.
template <typename Field>
void pack_fields(const PackedType& packed, Field field, bool swap_bytes, int count, Bytes destination) {
    int component = 0;
    for (int i = 0; i < count; ++i) {
        uint32_t pixel = 0;
        for (int c = 0; c < packed.components; ++c, ++component) {
            pixel |= field(component, packed.bits[c]) << packed.shift[c];
        }
        store_packed(pixel, destination, packed.bytes, i, swap_bytes);
    }
}

// The bit of pixel `index` in a bitmap row (GL 1.5 §3.6.4, UNPACK_LSB_FIRST).
uint8_t bit_mask(int index, bool lsb_first) {
    return static_cast<uint8_t>(lsb_first ? 1 << (index & 7) : 0x80 >> (index & 7));
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

}  // namespace

unsigned unorm_from_float(float value, unsigned bits) {
    const float maximum = static_cast<float>((1u << bits) - 1);
    if (!(value > 0.0f)) return 0;
    return static_cast<unsigned>(std::lrint(std::min(value, 1.0f) * maximum));
}

bool has_8_bit_components(GLenum type) {
    if (type == GL_UNSIGNED_BYTE) return true;
    const PackedType* packed = find_packed_type(type);
    return packed && packed->bits[0] <= 8;
}

void unpack_rgba8(GLenum format, GLenum type, bool swap_bytes, const void* source, int count, uint8_t* rgba) {
    const auto bytes = static_cast<ConstBytes>(source);
    const PackedType* packed = find_packed_type(type);
    if (!packed) {
        if (format == GL_RGBA) {
            std::memcpy(rgba, bytes, static_cast<size_t>(count) * 4);
        } else {
            components_to_rgba<uint8_t>(bytes, format, 255, count, rgba);
        }
        return;
    }
    uint8_t components[4 * kPixelChunk];
    for_each_field(*packed, bytes, swap_bytes, count, [&](int component, unsigned field, unsigned bits) {
        components[component] = static_cast<uint8_t>(resize_unorm(field, bits, 8));
    });
    components_to_rgba<uint8_t>(components, format, 255, count, rgba);
}

void unpack_rgba_float(GLenum format, GLenum type, bool swap_bytes, const void* source, int count,
                       float* rgba) {
    const auto bytes = static_cast<ConstBytes>(source);
    float components[4 * kPixelChunk];
    if (const PackedType* packed = find_packed_type(type)) {
        for_each_field(*packed, bytes, swap_bytes, count, [&](int component, unsigned field, unsigned bits) {
            components[component] = static_cast<float>(field) * (1.0f / static_cast<float>((1u << bits) - 1));
        });
    } else {
        const int elements = count * component_count(format);
        with_type(type, [&]<typename T>(T) {
            for (int i = 0; i < elements; ++i) components[i] = to_float(load<T>(bytes, i, swap_bytes));
        });
    }
    components_to_rgba(components, format, 1.0f, count, rgba);
}

void unpack_indices(GLenum type, bool swap_bytes, bool lsb_first, const void* source, int first_bit,
                    int count, uint32_t* indices) {
    const auto bytes = static_cast<ConstBytes>(source);
    if (type == GL_BITMAP) {
        for (int i = 0; i < count; ++i) {
            const int bit = first_bit + i;
            indices[i] = (bytes[bit >> 3] & bit_mask(bit, lsb_first)) != 0;
        }
        return;
    }
    with_type(type, [&]<typename T>(T) {
        for (int i = 0; i < count; ++i) indices[i] = to_index(load<T>(bytes, i, swap_bytes));
    });
}

void pack_rgba8(GLenum format, GLenum type, bool swap_bytes, const uint8_t* rgba, int count,
                void* destination) {
    const auto bytes = static_cast<Bytes>(destination);
    if (format == GL_RGBA && type == GL_UNSIGNED_BYTE) {
        std::memcpy(bytes, rgba, static_cast<size_t>(count) * 4);
        return;
    }
    uint8_t components[4 * kPixelChunk];
    rgba_to_components(rgba, format, count, components);
    if (const PackedType* packed = find_packed_type(type)) {
        const auto field = [&](int component, unsigned bits) {
            return resize_unorm(components[component], 8, bits);
        };
        pack_fields(*packed, field, swap_bytes, count, bytes);
        return;
    }
    const int elements = count * component_count(format);
    with_type(type, [&]<typename T>(T) {
        for (int i = 0; i < elements; ++i) store(from_8_bits<T>(components[i]), bytes, i, swap_bytes);
    });
}

void pack_rgba_float(GLenum format, GLenum type, bool swap_bytes, const float* rgba, int count,
                     void* destination) {
    const auto bytes = static_cast<Bytes>(destination);
    float components[4 * kPixelChunk];
    rgba_to_components(rgba, format, count, components);
    if (const PackedType* packed = find_packed_type(type)) {
        const auto field = [&](int component, unsigned bits) {
            return unorm_from_float(components[component], bits);
        };
        pack_fields(*packed, field, swap_bytes, count, bytes);
        return;
    }
    const int elements = count * component_count(format);
    with_type(type, [&]<typename T>(T) {
        for (int i = 0; i < elements; ++i) {
            store(from_unit<T>(static_cast<double>(components[i])), bytes, i, swap_bytes);
        }
    });
}

void pack_indices(GLenum type, bool swap_bytes, bool lsb_first, const uint32_t* indices, int count,
                  void* destination, int first_bit) {
    const auto bytes = static_cast<Bytes>(destination);
    if (type == GL_BITMAP) {
        for (int i = 0; i < count; ++i) {
            const int bit = first_bit + i;
            const uint8_t mask = bit_mask(bit, lsb_first);
            uint8_t& byte = bytes[bit >> 3];
            byte = static_cast<uint8_t>((indices[i] & 1) ? byte | mask : byte & ~mask);
        }
        return;
    }
    with_type(type, [&]<typename T>(T) {
        for (int i = 0; i < count; ++i) store(from_index<T>(indices[i]), bytes, i, swap_bytes);
    });
}

void pack_depths(GLenum type, bool swap_bytes, const float* depths, int count, void* destination) {
    const auto bytes = static_cast<Bytes>(destination);
    with_type(type, [&]<typename T>(T) {
        for (int i = 0; i < count; ++i) store(from_depth<T>(depths[i]), bytes, i, swap_bytes);
    });
}

}  // namespace terrazzo::gl
