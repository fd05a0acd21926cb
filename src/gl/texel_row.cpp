// Quantising and spreading texels.
#include "gl/texel_row.h"

#include <algorithm>
#include <array>

#include "gl/channels.h"
#include "gl/client_pixel.h"
#include "gl/convert.h"
#include "gl/pixel_component.h"
#include "gl/pixel_convert.h"
#include "gl/pixel_transfer.h"

namespace terrazzo::gl {
namespace {

using raster::BaseFormat;
using raster::TexelStorage;
using raster::TextureImage;

// For every size, the 8-bit value that stands for an 8-bit component after it was kept with that many bits.
using QuantizeTable = std::array<uint8_t, 256>;
using QuantizeTables = std::array<QuantizeTable, 9>;

template <typename Narrow>
constexpr QuantizeTables make_quantize_tables(Narrow narrow) {
    QuantizeTables tables{};
    for (unsigned bits = 1; bits <= 8; ++bits) {
        for (unsigned value = 0; value < 256; ++value) {
            tables[bits][value] = static_cast<uint8_t>(resize_unorm(narrow(value, bits), bits, 8));
        }
    }
    return tables;
}
constexpr QuantizeTables kQuantize =
    make_quantize_tables([](unsigned value, unsigned bits) { return resize_unorm(value, 8, bits); });

// How the reference narrows what it draws, and copies are drawn: bits are dropped, with some care where more
// are lost than kept; only 4 bits are rounded to nearest.
constexpr unsigned narrow_drawn(unsigned value, unsigned bits) {
    const unsigned lost = 8 - bits;
    if (bits == 4) return resize_unorm(value, 8, bits);
    if (lost <= bits) return value >> lost;
    return ((value >> bits) * ((1u << bits) - 1) + (1u << (lost - 1))) >> lost;
}
constexpr QuantizeTables kQuantizeDrawn = make_quantize_tables(narrow_drawn);

// Groups to texels as sampling sees them.
template <typename T>
void groups_to_texels(BaseFormat base, T one, const T* rgba, int count, T* texels) {
    switch (base) {
        case BaseFormat::kAlpha:
            return spread<4, Channels{kZero, kZero, kZero, 3}>(rgba, one, count, texels);
        case BaseFormat::kLuminance:
            return spread<4, Channels{0, 0, 0, kOne}>(rgba, one, count, texels);
        case BaseFormat::kLuminanceAlpha:
            return spread<4, Channels{0, 0, 0, 3}>(rgba, one, count, texels);
        case BaseFormat::kIntensity:
            return spread<4, Channels{0, 0, 0, 0}>(rgba, one, count, texels);
        case BaseFormat::kRgb:
            return spread<4, Channels{0, 1, 2, kOne}>(rgba, one, count, texels);
        case BaseFormat::kRgba:
        case BaseFormat::kDepth:
            std::copy_n(rgba, 4 * count, texels);
    }
}

// GL 1.5 table 6.1.
template <typename T>
void texels_to_groups(BaseFormat base, T one, const T* texels, int count, T* rgba) {
    switch (base) {
        case BaseFormat::kLuminance:
        case BaseFormat::kIntensity:
            return spread<4, Channels{0, kZero, kZero, kOne}>(texels, one, count, rgba);
        case BaseFormat::kLuminanceAlpha:
            return spread<4, Channels{0, kZero, kZero, 3}>(texels, one, count, rgba);
        case BaseFormat::kAlpha:
        case BaseFormat::kRgb:
        case BaseFormat::kRgba:
        case BaseFormat::kDepth:
            std::copy_n(texels, 4 * count, rgba);
    }
}

bool keeps_all_bits(const TexelFormat& format) {
    return std::all_of(format.bits.begin(), format.bits.end(),
                       [](unsigned char bits) { return bits == 0 || bits == 8; });
}

// What integers of a format's sizes are multiplied and divided by.
struct Scales {
    explicit Scales(const TexelFormat& format) {
        for (size_t c = 0; c < 4; ++c) {
            maximum[c] = static_cast<float>((1u << format.bits[c]) - 1);
            reciprocal[c] = format.bits[c] == 0 ? 0.0f : 1.0f / maximum[c];
        }
    }
    float maximum[4], reciprocal[4];
};

// A float texel is the integer that a texture of this format holds, divided by the largest.
void quantize(const TexelFormat& format, const float* __restrict rgba, int count,
              float* __restrict quantized) {
    const Scales scales(format);
    for (int i = 0; i < 4 * count; i += 4) {
        for (int c = 0; c < 4; ++c) {
            const int integer = round_to_int(clamp_to_unit(rgba[i + c]) * scales.maximum[c]);
            quantized[i + c] = static_cast<float>(integer) * scales.reciprocal[c];
        }
    }
}

void widen(const TexelFormat& format, const uint8_t* __restrict rgba, int count, float* __restrict texels) {
    const Scales scales(format);
    for (int i = 0; i < 4 * count; ++i) {
        const unsigned bits = format.bits[i & 3];
        texels[i] =
            static_cast<float>(bits == 0 ? 0 : resize_unorm(rgba[i], 8, bits)) * scales.reciprocal[i & 3];
    }
}

void quantize(const QuantizeTables& tables, const TexelFormat& format, const uint8_t* __restrict rgba,
              int count, uint8_t* __restrict quantized) {
    const QuantizeTable &red = tables[format.bits[0]], &green = tables[format.bits[1]];
    const QuantizeTable &blue = tables[format.bits[2]], &alpha = tables[format.bits[3]];
    for (int i = 0; i < 4 * count; i += 4) {
        quantized[i] = red[rgba[i]];
        quantized[i + 1] = green[rgba[i + 1]];
        quantized[i + 2] = blue[rgba[i + 2]];
        quantized[i + 3] = alpha[rgba[i + 3]];
    }
}

}  // namespace

bool stores_groups(const TexelFormat& texel, GLenum format, GLenum type) {
    if (texel.storage != TexelStorage::kRgba8) return false;
    if (format == GL_BGR) format = GL_RGB;
    if (format == GL_BGRA || format == GL_ABGR_EXT) format = GL_RGBA;
    if (format != texel.base) return false;
    const PackedType* packed = find_packed_type(type);
    return keeps_all_bits(texel) ||
           (packed && std::equal(packed->bits, packed->bits + packed->components, texel.bits.begin()));
}

bool holds_all_values(const TexelFormat& texel, GLenum type) {
    return type == GL_UNSIGNED_SHORT &&
           std::all_of(texel.bits.begin(), texel.bits.end(),
                       [](unsigned char bits) { return bits == 0 || bits == 16; });
}

void store_texels(const TexelFormat& format, const uint8_t* rgba, Rounding rounding, int count,
                  TextureImage& image, int x, int y, int z) {
    if (image.storage == TexelStorage::kRgba32F) {
        float texels[4 * kPixelChunk];
        widen(format, rgba, count, texels);
        return groups_to_texels(format.base_format, 1.0f, texels, count, image.rgba32f(x, y, z));
    }
    if (keeps_all_bits(format)) {
        return groups_to_texels<uint8_t>(format.base_format, 255, rgba, count, image.rgba8(x, y, z));
    }
    uint8_t quantized[4 * kPixelChunk];
    quantize(rounding == Rounding::kAsDrawn ? kQuantizeDrawn : kQuantize, format, rgba, count, quantized);
    groups_to_texels<uint8_t>(format.base_format, 255, quantized, count, image.rgba8(x, y, z));
}

void store_texels(const TexelFormat& format, const float* rgba, Rounding rounding, int count,
                  TextureImage& image, int x, int y, int z) {
    if (image.storage == TexelStorage::kRgba32F) {
        if (rounding == Rounding::kNone)
            return groups_to_texels(format.base_format, 1.0f, rgba, count, image.rgba32f(x, y, z));
        if (format.base_format == BaseFormat::kRgba)
            return quantize(format, rgba, count, image.rgba32f(x, y, z));
        float texels[4 * kPixelChunk];
        quantize(format, rgba, count, texels);
        return groups_to_texels(format.base_format, 1.0f, texels, count, image.rgba32f(x, y, z));
    }
    uint8_t bytes[4 * kPixelChunk];
    if (rounding == Rounding::kThroughBytes || keeps_all_bits(format)) {
        bytes_from_floats(rgba, 4 * count, bytes);
        return store_texels(format, bytes, Rounding::kThroughBytes, count, image, x, y, z);
    }
    const Scales scales(format);
    for (int i = 0; i < 4 * count; ++i) {
        const unsigned bits = format.bits[i & 3];
        const auto integer = static_cast<unsigned>(clamp_to_unit(rgba[i]) * scales.maximum[i & 3] + 0.5f);
        bytes[i] = static_cast<uint8_t>(bits == 0 ? 0 : resize_unorm(integer, bits, 8));
    }
    groups_to_texels<uint8_t>(format.base_format, 255, bytes, count, image.rgba8(x, y, z));
}

void load_texels(const TexelFormat& format, const TextureImage& image, int x, int y, int z, int count,
                 uint8_t* rgba) {
    texels_to_groups<uint8_t>(format.base_format, 255, image.rgba8(x, y, z), count, rgba);
}

void load_texels(const TexelFormat& format, const TextureImage& image, int x, int y, int z, int count,
                 float* rgba) {
    if (image.storage == TexelStorage::kRgba32F) {
        return texels_to_groups(format.base_format, 1.0f, image.rgba32f(x, y, z), count, rgba);
    }
    float texels[4 * kPixelChunk];
    const uint8_t* stored = image.rgba8(x, y, z);
    for (int i = 0; i < 4 * count; ++i) {
        // Channels that the format lacks hold 0 or 255, which is 0 or 1 in any number of bits.
        const unsigned bits = format.bits[i & 3] == 0 ? 1 : format.bits[i & 3];
        texels[i] =
            static_cast<float>(stored[i] >> (8 - bits)) * (1.0f / static_cast<float>((1u << bits) - 1));
    }
    texels_to_groups(format.base_format, 1.0f, texels, count, rgba);
}

// The reference's ways: integers of 16 and 32 bits to those sizes without floats; all others cut off what a
// float times the largest value has behind the point.
void store_depths(const PixelState& state, GLenum type, int bits, const uint8_t* source, int count,
                  uint32_t* depths) {
    const bool swap_bytes = state.unpack.swap_bytes;
    const bool integers = type == GL_UNSIGNED_SHORT || type == GL_UNSIGNED_INT;
    if (integers && bits != 24 && !swap_bytes && !changes_depths(state)) {
        const unsigned size = type == GL_UNSIGNED_SHORT ? 16 : 32;
        for (int i = 0; i < count; ++i) {
            const uint32_t value = size == 16 ? load_component<uint16_t>(source, i, false)
                                              : load_component<uint32_t>(source, i, false);
            depths[i] = resize_depth(value, size, static_cast<unsigned>(bits));
        }
        return;
    }
    float values[kPixelChunk];
    with_type(type, [&]<typename T>(T) {
        for (int i = 0; i < count; ++i) {
            const T value = load_component<T>(source, i, swap_bytes);
            if constexpr (std::is_same_v<T, float>) {
                values[i] = value;
            } else {
                values[i] = value == 0 ? 0.0f : normalised(value);
            }
        }
    });
    if (changes_depths(state)) transfer_depths(state, values, count);
    for (int i = 0; i < count; ++i) depths[i] = depth_integer(values[i], bits);
}

uint32_t depth_integer(float depth, int bits) {
    const double largest = static_cast<double>((uint64_t{1} << bits) - 1);
    depth = clamp_to_unit(depth);
    return bits == 32 ? static_cast<uint32_t>(depth * largest)
                      : static_cast<uint32_t>(depth * static_cast<float>(largest));
}

uint32_t resize_depth(uint32_t value, unsigned from, unsigned to) {
    if (to <= from) return value >> (from - to);
    return value << (to - from) | value >> (2 * from - to);
}

}  // namespace terrazzo::gl
