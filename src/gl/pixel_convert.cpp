// Conversion of rows: components are widened or narrowed in one loop and put in their channels in another, so
// that each loop is small and there are (types + formats) of them, not (types x formats).
#include "gl/pixel_convert.h"

#include "gl/pixel_component.h"
#include "gl/pixel_order.h"

namespace terrazzo::gl {
namespace {

// The bit of pixel `index` in a bitmap row (GL 1.5 §3.6.4, UNPACK_LSB_FIRST).
uint8_t bit_mask(int index, bool lsb_first) {
    return static_cast<uint8_t>(lsb_first ? 1 << (index & 7) : 0x80 >> (index & 7));
}

// The loops have the usual byte order as a constant.

template <typename T, typename Convert, typename U>
void load_components(const uint8_t* source, bool swap_bytes, int count, Convert convert, U* components) {
    if (swap_bytes) {
        for (int i = 0; i < count; ++i) components[i] = convert(load_component<T>(source, i, true));
    } else {
        for (int i = 0; i < count; ++i) components[i] = convert(load_component<T>(source, i, false));
    }
}

template <typename U, typename Convert>
void store_components(const U* components, int count, bool swap_bytes, Convert convert,
                      uint8_t* destination) {
    if (swap_bytes) {
        for (int i = 0; i < count; ++i) store_component(convert(components[i]), destination, i, true);
    } else {
        for (int i = 0; i < count; ++i) store_component(convert(components[i]), destination, i, false);
    }
}

}  // namespace

void bytes_from_floats(const float* __restrict values, int count, uint8_t* __restrict bytes) {
    for (int i = 0; i < count; ++i) bytes[i] = from_float<uint8_t>(values[i]);
}

bool has_8_bit_components(GLenum type) {
    if (type == GL_UNSIGNED_BYTE) return true;
    const PackedType* packed = find_packed_type(type);
    return packed && packed->bits[0] <= 8;
}

namespace {

// Pixels of three or four fields of at most 8 bits to four bytes each, a missing fourth component being 255.
template <PackedType kPacked>
void unpack_to_bytes(const uint8_t* __restrict source, bool swap_bytes, int count,
                     uint8_t* __restrict components) {
    for (int i = 0; i < count; ++i) {
        const unsigned pixel = load_component<PackedInteger<kPacked.bytes>>(source, i, swap_bytes);
        uint32_t word = kPacked.components == 4 ? 0 : 0xffu << shift_of_byte(3);
        [&]<size_t... c>(std::index_sequence<c...>) {
            ((word |=
              resize_unorm(pixel >> kPacked.shift[c] & ((1u << kPacked.bits[c]) - 1), kPacked.bits[c], 8)
              << shift_of_byte(c)),
             ...);
        }
        (std::make_index_sequence<kPacked.components>());
        std::memcpy(components + 4 * i, &word, sizeof word);
    }
}

}  // namespace

void unpack_rgba8(GLenum format, GLenum type, bool swap_bytes, const void* source, int count, uint8_t* rgba) {
    const auto* bytes = static_cast<const uint8_t*>(source);
    Order order;
    if (are_bytes(format, type, swap_bytes, order)) {
        return components_to_rgba<uint8_t>(bytes, order, 255, count, rgba);
    }
    // Four components in any case, the fourth of three being alpha.
    if (order == Order::kRgb) order = Order::kRgba;
    if (order == Order::kBgr) order = Order::kBgra;
    uint8_t components[4 * kPixelChunk];
    with_packed_type(type, [&]<PackedType kPacked>() {
        if constexpr (kPacked.bits[0] <= 8) unpack_to_bytes<kPacked>(bytes, swap_bytes, count, components);
    });
    components_to_rgba<uint8_t>(components, order, 255, count, rgba);
}

void unpack_rgba_float(GLenum format, GLenum type, bool swap_bytes, const void* source, int count,
                       float* rgba) {
    const auto* bytes = static_cast<const uint8_t*>(source);
    const bool in_place = order_of(format) == Order::kRgba;
    float scratch[4 * kPixelChunk];
    float* const components = in_place ? rgba : scratch;
    if (find_packed_type(type)) {
        with_packed_type(type, [&]<PackedType kPacked>() {
            unpack_fields<kPacked>(bytes, swap_bytes, count, components, []<unsigned kBits>(unsigned field) {
                return static_cast<float>(field) * (1.0f / static_cast<float>((1u << kBits) - 1));
            });
        });
    } else {
        with_type(type, [&]<typename T>(T) {
            load_components<T>(bytes, swap_bytes, count * component_count(format), to_float<T>, components);
        });
    }
    if (!in_place) components_to_rgba(components, order_of(format), 1.0f, count, rgba);
}

void unpack_indices(GLenum type, bool swap_bytes, bool lsb_first, const void* source, int first_bit,
                    int count, uint32_t* indices) {
    const auto* bytes = static_cast<const uint8_t*>(source);
    if (type == GL_BITMAP) {
        for (int i = 0; i < count; ++i) {
            const int bit = first_bit + i;
            indices[i] = (bytes[bit >> 3] & bit_mask(bit, lsb_first)) != 0;
        }
        return;
    }
    with_type(type,
              [&]<typename T>(T) { load_components<T>(bytes, swap_bytes, count, to_index<T>, indices); });
}

void unpack_depths(GLenum type, bool swap_bytes, const void* source, int count, float* depths) {
    const auto* bytes = static_cast<const uint8_t*>(source);
    with_type(type, [&]<typename T>(T) {
        const auto convert = [](T value) {
            if constexpr (std::is_same_v<T, float>) {
                return value;
            } else if constexpr (std::is_signed_v<T>) {
                constexpr double kRange = std::numeric_limits<std::make_unsigned_t<T>>::max();
                return static_cast<float>((2 * static_cast<double>(value) + 1) / kRange);
            } else {
                constexpr double kRange = std::numeric_limits<T>::max();
                return static_cast<float>(static_cast<double>(value) / kRange);
            }
        };
        load_components<T>(bytes, swap_bytes, count, convert, depths);
    });
}

void unpack_depths_and_stencils(bool swap_bytes, const void* source, int count, uint32_t* depths,
                                uint32_t* stencils) {
    for (int i = 0; i < count; ++i) {
        const auto both = load_component<uint32_t>(static_cast<const uint8_t*>(source), i, swap_bytes);
        depths[i] = both >> 8;
        stencils[i] = both & 255;
    }
}

void pack_rgba8(GLenum format, GLenum type, bool swap_bytes, const uint8_t* rgba, int count,
                void* destination) {
    auto* bytes = static_cast<uint8_t*>(destination);
    Order order;
    if (are_bytes(format, type, swap_bytes, order)) return rgba_to_components(rgba, order, count, bytes);
    uint8_t components[4 * kPixelChunk];
    rgba_to_components(rgba, order, count, components);
    if (find_packed_type(type)) {
        return with_packed_type(type, [&]<PackedType kPacked>() {
            pack_fields<kPacked>(components, swap_bytes, count, bytes, []<unsigned kBits>(unsigned value) {
                return resize_unorm(value, 8, kBits);
            });
        });
    }
    with_type(type, [&]<typename T>(T) {
        store_components(components, count * component_count(format), swap_bytes, from_8_bits<T>, bytes);
    });
}

void pack_rgba_float(GLenum format, GLenum type, bool swap_bytes, const float* rgba, int count,
                     void* destination) {
    auto* bytes = static_cast<uint8_t*>(destination);
    float components[4 * kPixelChunk];
    rgba_to_components(rgba, order_of(format), count, components);
    if (find_packed_type(type)) {
        return with_packed_type(type, [&]<PackedType kPacked>() {
            pack_fields<kPacked>(components, swap_bytes, count, bytes,
                                 []<unsigned kBits>(float value) { return unorm_from_float(value, kBits); });
        });
    }
    with_type(type, [&]<typename T>(T) {
        store_components(components, count * component_count(format), swap_bytes, from_float<T>, bytes);
    });
}

void pack_indices(GLenum type, bool swap_bytes, bool lsb_first, const uint32_t* indices, int count,
                  void* destination, int first_bit) {
    auto* bytes = static_cast<uint8_t*>(destination);
    if (type == GL_BITMAP) {
        for (int i = 0; i < count; ++i) {
            const int bit = first_bit + i;
            const uint8_t mask = bit_mask(bit, lsb_first);
            uint8_t& byte = bytes[bit >> 3];
            byte = static_cast<uint8_t>((indices[i] & 1) ? byte | mask : byte & ~mask);
        }
        return;
    }
    with_type(type,
              [&]<typename T>(T) { store_components(indices, count, swap_bytes, from_index<T>, bytes); });
}

void pack_depths_and_stencils(bool swap_bytes, const uint32_t* depths, const uint32_t* stencils, int count,
                              void* destination) {
    for (int i = 0; i < count; ++i)
        store_component(depths[i] << 8 | (stencils[i] & 255), static_cast<uint8_t*>(destination), i,
                        swap_bytes);
}

void pack_depths(GLenum type, bool swap_bytes, const float* depths, int count, void* destination) {
    auto* bytes = static_cast<uint8_t*>(destination);
    with_type(type,
              [&]<typename T>(T) { store_components(depths, count, swap_bytes, from_depth<T>, bytes); });
}

}  // namespace terrazzo::gl
