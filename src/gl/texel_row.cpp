// Quantising and spreading texels.
#include "gl/texel_row.h"

#include <array>
#include <cstring>

#include "gl/pixel_convert.h"

namespace terrazzo::gl {
namespace {

using pipeline::BaseFormat;
using pipeline::TexelStorage;
using pipeline::TextureImage;

// For every size, the 8-bit value that stands for an 8-bit component after it was kept with that many bits.
using QuantizeTable = std::array<uint8_t, 256>;
constexpr std::array<QuantizeTable, 9> make_quantize_tables() {
    std::array<QuantizeTable, 9> tables{};
    for (unsigned bits = 1; bits <= 8; ++bits) {
        for (unsigned value = 0; value < 256; ++value) {
            tables[bits][value] = static_cast<uint8_t>(resize_unorm(resize_unorm(value, 8, bits), bits, 8));
        }
    }
    return tables;
}
constexpr std::array<QuantizeTable, 9> kQuantize = make_quantize_tables();

// Which channel of the group each stored channel takes; kZero and kOne are constants.
using Channels = std::array<uint8_t, 4>;
constexpr uint8_t kZero = 4, kOne = 5;

Channels stored_channels(BaseFormat base) {
    switch (base) {
        case BaseFormat::kAlpha:
            return {kZero, kZero, kZero, 3};
        case BaseFormat::kLuminance:
            return {0, 0, 0, kOne};
        case BaseFormat::kLuminanceAlpha:
            return {0, 0, 0, 3};
        case BaseFormat::kIntensity:
            return {0, 0, 0, 0};
        case BaseFormat::kRgb:
            return {0, 1, 2, kOne};
        case BaseFormat::kRgba:
        case BaseFormat::kDepth:
            break;
    }
    return {0, 1, 2, 3};
}

// GL 1.5 table 6.1 applied to stored channels.
Channels loaded_channels(BaseFormat base) {
    switch (base) {
        case BaseFormat::kLuminance:
        case BaseFormat::kIntensity:
            return {0, kZero, kZero, kOne};
        case BaseFormat::kLuminanceAlpha:
            return {0, kZero, kZero, 3};
        case BaseFormat::kAlpha:
        case BaseFormat::kRgb:
        case BaseFormat::kRgba:
        case BaseFormat::kDepth:
            break;
    }
    return {0, 1, 2, 3};
}

template <typename T>
void spread(Channels channels, T one, const T* source, int count, T* destination) {
    T pixel[6] = {};
    pixel[kOne] = one;
    for (int i = 0; i < count; ++i, source += 4, destination += 4) {
        for (size_t c = 0; c < 4; ++c) pixel[c] = source[c];
        for (size_t c = 0; c < 4; ++c) destination[c] = pixel[channels[c]];
    }
}

// Converts the channels that the format keeps; the others are not looked at when the texel is spread.
template <typename T, typename U, typename Convert>
void convert_channels(const TexelFormat& format, const T* rgba, int count, U* converted, Convert convert) {
    for (int i = 0; i < 4 * count; ++i) {
        const unsigned bits = format.bits[i & 3];
        converted[i] = bits == 0 ? U{0} : static_cast<U>(convert(rgba[i], bits));
    }
}

bool keeps_all_bits(const TexelFormat& format) {
    for (unsigned char bits : format.bits) {
        if (bits != 0 && bits != 8) return false;
    }
    return true;
}

// A float texel is the integer that a texture of this format holds, divided by the largest.
float float_texel(unsigned integer, unsigned bits) {
    return static_cast<float>(integer) * (1.0f / static_cast<float>((1u << bits) - 1));
}

}  // namespace

void store_texels(const TexelFormat& format, const uint8_t* rgba, int count, TextureImage& image, int x,
                  int y) {
    const Channels channels = stored_channels(format.base_format);
    if (image.storage == TexelStorage::kRgba32F) {
        float texels[4 * kPixelChunk];
        convert_channels(format, rgba, count, texels, [](unsigned value, unsigned bits) {
            return float_texel(resize_unorm(value, 8, bits), bits);
        });
        spread(channels, 1.0f, texels, count, image.rgba32f(x, y));
        return;
    }
    uint8_t* texels = image.rgba8(x, y);
    if (!keeps_all_bits(format)) {
        uint8_t quantized[4 * kPixelChunk];
        convert_channels(format, rgba, count, quantized,
                         [](unsigned value, unsigned bits) { return kQuantize[bits][value]; });
        spread<uint8_t>(channels, 255, quantized, count, texels);
    } else if (format.base_format == BaseFormat::kRgba) {
        std::memcpy(texels, rgba, static_cast<size_t>(count) * 4);
    } else {
        spread<uint8_t>(channels, 255, rgba, count, texels);
    }
}

void store_texels(const TexelFormat& format, const float* rgba, Rounding rounding, int count,
                  TextureImage& image, int x, int y) {
    const Channels channels = stored_channels(format.base_format);
    if (image.storage == TexelStorage::kRgba32F) {
        float texels[4 * kPixelChunk];
        convert_channels(format, rgba, count, texels, [](float value, unsigned bits) {
            return float_texel(unorm_from_float(value, bits), bits);
        });
        spread(channels, 1.0f, texels, count, image.rgba32f(x, y));
        return;
    }
    uint8_t bytes[4 * kPixelChunk];
    if (rounding == Rounding::kThroughBytes) {
        for (int i = 0; i < 4 * count; ++i) bytes[i] = static_cast<uint8_t>(unorm_from_float(rgba[i], 8));
        return store_texels(format, bytes, count, image, x, y);
    }
    convert_channels(format, rgba, count, bytes, [](float value, unsigned bits) {
        return resize_unorm(unorm_from_float(value, bits), bits, 8);
    });
    spread<uint8_t>(channels, 255, bytes, count, image.rgba8(x, y));
}

void load_texels(const TexelFormat& format, const TextureImage& image, int x, int y, int count,
                 uint8_t* rgba) {
    spread<uint8_t>(loaded_channels(format.base_format), 255, image.rgba8(x, y), count, rgba);
}

void load_texels(const TexelFormat& format, const TextureImage& image, int x, int y, int count, float* rgba) {
    const Channels channels = loaded_channels(format.base_format);
    if (image.storage == TexelStorage::kRgba32F) {
        spread(channels, 1.0f, image.rgba32f(x, y), count, rgba);
        return;
    }
    float texels[4 * kPixelChunk];
    const uint8_t* stored = image.rgba8(x, y);
    convert_channels(format, stored, count, texels,
                     [](unsigned value, unsigned bits) { return float_texel(value >> (8 - bits), bits); });
    // Channels that the format lacks are constants, which `spread` must take from what is stored.
    for (int i = 0; i < 4 * count; ++i) {
        if (format.bits[i & 3] == 0) texels[i] = stored[i] == 0 ? 0.0f : 1.0f;
    }
    spread(channels, 1.0f, texels, count, rgba);
}

}  // namespace terrazzo::gl
