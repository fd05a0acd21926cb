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
            tables[bits][value] =
                static_cast<uint8_t>(expand_to_8_bits(reduce_from_8_bits(value, bits), bits));
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

// Table 6.1 applied to stored channels.
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

template <typename T, typename Convert>
void spread(Channels channels, T one, const T* source, int count, T* destination, Convert convert) {
    T pixel[6] = {};
    pixel[kOne] = one;
    for (int i = 0; i < count; ++i, source += 4, destination += 4) {
        for (size_t c = 0; c < 4; ++c) pixel[c] = convert(c, source[c]);
        for (size_t c = 0; c < 4; ++c) destination[c] = pixel[channels[c]];
    }
}

bool keeps_all_bits(const TexelFormat& format) {
    for (unsigned char bits : format.bits) {
        if (bits != 0 && bits != 8) return false;
    }
    return true;
}

// The integer behind a float texel was stored divided by the same maximum, so this division gives the same
// float.
float quantized(float value, unsigned bits) {
    if (bits == 0) return 0.0f;
    return static_cast<float>(unorm_from_float(value, bits)) / static_cast<float>((1u << bits) - 1);
}

}  // namespace

void store_texels(const TexelFormat& format, const uint8_t* rgba, int count, TextureImage& image, int x,
                  int y) {
    if (image.storage == TexelStorage::kRgba32F) {
        float wide[4 * kPixelChunk];
        for (int i = 0; i < 4 * count; ++i) wide[i] = static_cast<float>(rgba[i]) * (1.0f / 255.0f);
        store_texels(format, wide, count, image, x, y);
        return;
    }
    uint8_t* texels = image.rgba8(x, y);
    if (!keeps_all_bits(format)) {
        spread<uint8_t>(stored_channels(format.base_format), 255, rgba, count, texels,
                        [&](size_t c, uint8_t value) { return kQuantize[format.bits[c]][value]; });
    } else if (format.base_format == BaseFormat::kRgba) {
        std::memcpy(texels, rgba, static_cast<size_t>(count) * 4);
    } else {
        spread<uint8_t>(stored_channels(format.base_format), 255, rgba, count, texels,
                        [](size_t, uint8_t value) { return value; });
    }
}

void store_texels(const TexelFormat& format, const float* rgba, int count, TextureImage& image, int x,
                  int y) {
    const Channels channels = stored_channels(format.base_format);
    if (image.storage == TexelStorage::kRgba32F) {
        spread(channels, 1.0f, rgba, count, image.rgba32f(x, y),
               [&](size_t c, float value) { return quantized(value, format.bits[c]); });
        return;
    }
    uint8_t narrow[4 * kPixelChunk];
    for (int i = 0; i < 4 * count; ++i) {
        const unsigned bits = format.bits[i & 3];
        narrow[i] = bits == 0 ? uint8_t{0}
                              : static_cast<uint8_t>(expand_to_8_bits(unorm_from_float(rgba[i], bits), bits));
    }
    spread<uint8_t>(channels, 255, narrow, count, image.rgba8(x, y),
                    [](size_t, uint8_t value) { return value; });
}

void load_texels(const TexelFormat& format, const TextureImage& image, int x, int y, int count,
                 uint8_t* rgba) {
    spread<uint8_t>(loaded_channels(format.base_format), 255, image.rgba8(x, y), count, rgba,
                    [](size_t, uint8_t value) { return value; });
}

void load_texels(const TexelFormat& format, const TextureImage& image, int x, int y, int count, float* rgba) {
    const Channels channels = loaded_channels(format.base_format);
    if (image.storage == TexelStorage::kRgba32F) {
        spread(channels, 1.0f, image.rgba32f(x, y), count, rgba, [](size_t, float value) { return value; });
        return;
    }
    // A channel that the format lacks holds 0 or 255 and reads as 8 bits.
    float wide[4 * kPixelChunk];
    const uint8_t* texels = image.rgba8(x, y);
    for (int i = 0; i < 4 * count; ++i) {
        const unsigned bits = format.bits[i & 3] == 0 ? 8 : format.bits[i & 3];
        const unsigned code = texels[i] >> (8 - bits);
        wide[i] = static_cast<float>(code) * (1.0f / static_cast<float>((1u << bits) - 1));
    }
    spread(channels, 1.0f, wide, count, rgba, [](size_t, float value) { return value; });
}

}  // namespace terrazzo::gl
