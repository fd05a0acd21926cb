// Conversion of pixel rows: what goes in and out again is the same, for all formats and types; the extremes
// of types; bits of bitmaps.
#include "gl/pixel_convert.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "gl/client_pixel.h"

namespace terrazzo::gl {
namespace {

using testing::ElementsAre;
using Bytes = std::vector<uint8_t>;

constexpr GLenum kFormats[] = {GL_RED,  GL_GREEN,    GL_BLUE,      GL_ALPHA,          GL_RGB, GL_RGBA, GL_BGR,
                               GL_BGRA, GL_ABGR_EXT, GL_LUMINANCE, GL_LUMINANCE_ALPHA};
constexpr GLenum kTypes[] = {GL_UNSIGNED_BYTE,
                             GL_BYTE,
                             GL_UNSIGNED_SHORT,
                             GL_SHORT,
                             GL_UNSIGNED_INT,
                             GL_INT,
                             GL_FLOAT,
                             GL_UNSIGNED_BYTE_3_3_2,
                             GL_UNSIGNED_BYTE_2_3_3_REV,
                             GL_UNSIGNED_SHORT_5_6_5,
                             GL_UNSIGNED_SHORT_5_6_5_REV,
                             GL_UNSIGNED_SHORT_4_4_4_4,
                             GL_UNSIGNED_SHORT_4_4_4_4_REV,
                             GL_UNSIGNED_SHORT_5_5_5_1,
                             GL_UNSIGNED_SHORT_1_5_5_5_REV,
                             GL_UNSIGNED_INT_8_8_8_8,
                             GL_UNSIGNED_INT_8_8_8_8_REV,
                             GL_UNSIGNED_INT_10_10_10_2,
                             GL_UNSIGNED_INT_2_10_10_10_REV};

template <typename Check>
void for_each_legal_pair(Check check) {
    for (GLenum format : kFormats) {
        for (GLenum type : kTypes) {
            if (check_client_pixel(format, type).code == GL_NO_ERROR) check(format, type);
        }
    }
}

// Random pixels that survive the way through a float: 32-bit integers lose their low bits to it and the most
// negative integers stand for the same -1 as their neighbours.
Bytes random_pixels(GLenum format, GLenum type, int count, bool swap_bytes, std::mt19937& random) {
    Bytes pixels(static_cast<size_t>(count) * bytes_per_pixel(format, type));
    for (uint8_t& byte : pixels) byte = static_cast<uint8_t>(random());
    const size_t size = element_size(type);
    for (size_t i = 0; i + size <= pixels.size(); i += size) {
        const bool is_signed = type == GL_BYTE || type == GL_SHORT || type == GL_INT;
        const size_t high = swap_bytes ? i : i + size - 1;
        if (type == GL_FLOAT) {
            const float value = std::uniform_real_distribution<float>(-2, 2)(random);
            std::memcpy(&pixels[i], &value, size);
            if (swap_bytes) std::reverse(&pixels[i], &pixels[i] + size);
        } else if (is_signed && pixels[high] == 0x80) {
            pixels[high] = 0x81;
        }
    }
    return pixels;
}

TEST(PixelConvert, FloatsGiveBackWhatTheyCameFrom) {
    std::mt19937 random(1);
    for_each_legal_pair([&](GLenum format, GLenum type) {
        for (bool swap_bytes : {false, true}) {
            const Bytes pixels = random_pixels(format, type, kPixelChunk, swap_bytes, random);
            float rgba[4 * kPixelChunk];
            Bytes again(pixels.size(), 0xcd);
            unpack_rgba_float(format, type, swap_bytes, pixels.data(), kPixelChunk, rgba);
            pack_rgba_float(format, type, swap_bytes, rgba, kPixelChunk, again.data());
            if (type == GL_UNSIGNED_INT || type == GL_INT) {
                // 24 bits of a float: half a unit of the 25th, and as much again from the scale.
                for (size_t i = 0; i < pixels.size(); i += 4) {
                    uint32_t a, b;
                    std::memcpy(&a, &pixels[i], 4);
                    std::memcpy(&b, &again[i], 4);
                    if (swap_bytes) a = __builtin_bswap32(a), b = __builtin_bswap32(b);
                    const double difference =
                        type == GL_INT ? double(int32_t(a)) - int32_t(b) : double(a) - b;
                    ASSERT_LE(std::fabs(difference), 512) << std::hex << format << ' ' << type;
                }
                continue;
            }
            EXPECT_EQ(pixels, again) << std::hex << format << " / " << type << " swapped " << swap_bytes;
        }
    });
}

TEST(PixelConvert, BytesGiveBackWhatTheyCameFrom) {
    std::mt19937 random(2);
    for_each_legal_pair([&](GLenum format, GLenum type) {
        if (!has_8_bit_components(type)) return;
        for (bool swap_bytes : {false, true}) {
            const Bytes pixels = random_pixels(format, type, kPixelChunk, swap_bytes, random);
            uint8_t rgba[4 * kPixelChunk];
            Bytes again(pixels.size(), 0xcd);
            unpack_rgba8(format, type, swap_bytes, pixels.data(), kPixelChunk, rgba);
            pack_rgba8(format, type, swap_bytes, rgba, kPixelChunk, again.data());
            EXPECT_EQ(pixels, again) << std::hex << format << " / " << type << " swapped " << swap_bytes;
        }
    });
}

// All 256 bytes through every type and back.
TEST(PixelConvert, EveryTypeOfEightBitsAndMoreHoldsAByte) {
    uint8_t rgba[4 * kPixelChunk];
    for (int i = 0; i < 4 * kPixelChunk; ++i) rgba[i] = static_cast<uint8_t>(i / 4);
    for (GLenum type : {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_SHORT, GL_UNSIGNED_INT, GL_INT, GL_FLOAT,
                        GL_UNSIGNED_INT_8_8_8_8, GL_UNSIGNED_INT_8_8_8_8_REV}) {
        Bytes client(16 * kPixelChunk);
        pack_rgba8(GL_RGBA, type, false, rgba, kPixelChunk, client.data());
        float values[4 * kPixelChunk];
        unpack_rgba_float(GL_RGBA, type, false, client.data(), kPixelChunk, values);
        for (int i = 0; i < 4 * kPixelChunk; ++i) {
            ASSERT_EQ(unorm_from_float(values[i], 8), rgba[i]) << std::hex << type;
        }
    }
}

TEST(PixelConvert, MissingComponents) {
    const uint8_t pixel[] = {10, 20};
    uint8_t rgba[4];
    unpack_rgba8(GL_GREEN, GL_UNSIGNED_BYTE, false, pixel, 1, rgba);
    EXPECT_THAT(rgba, ElementsAre(0, 10, 0, 255));
    unpack_rgba8(GL_ALPHA, GL_UNSIGNED_BYTE, false, pixel, 1, rgba);
    EXPECT_THAT(rgba, ElementsAre(0, 0, 0, 10));
    unpack_rgba8(GL_LUMINANCE, GL_UNSIGNED_BYTE, false, pixel, 1, rgba);
    EXPECT_THAT(rgba, ElementsAre(10, 10, 10, 255));
    unpack_rgba8(GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, false, pixel, 1, rgba);
    EXPECT_THAT(rgba, ElementsAre(10, 10, 10, 20));
}

TEST(PixelConvert, PackedFieldsLieWhereTheSpecificationHasThem) {
    // GL 1.5 table 3.8: 5 bits of red are the highest, or the lowest with _REV.
    const uint16_t red = 0x1f << 11, red_reversed = 0x1f;
    float rgba[4];
    unpack_rgba_float(GL_RGB, GL_UNSIGNED_SHORT_5_6_5, false, &red, 1, rgba);
    EXPECT_THAT(rgba, ElementsAre(1, 0, 0, 1));
    unpack_rgba_float(GL_RGB, GL_UNSIGNED_SHORT_5_6_5_REV, false, &red_reversed, 1, rgba);
    EXPECT_THAT(rgba, ElementsAre(1, 0, 0, 1));
    const uint16_t blue_first = 0xf000;
    unpack_rgba_float(GL_BGRA, GL_UNSIGNED_SHORT_4_4_4_4, false, &blue_first, 1, rgba);
    EXPECT_THAT(rgba, ElementsAre(0, 0, 1, 0));
    const uint32_t two_bits_of_alpha = 0xc0000000u;
    unpack_rgba_float(GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV, false, &two_bits_of_alpha, 1, rgba);
    EXPECT_THAT(rgba, ElementsAre(0, 0, 0, 1));
}

TEST(PixelConvert, IntegersSaturate) {
    const float infinity = std::numeric_limits<float>::infinity();
    const float rgba[] = {-infinity, infinity, std::nanf(""), 1.5f};
    uint8_t bytes[4];
    pack_rgba_float(GL_RGBA, GL_UNSIGNED_BYTE, false, rgba, 1, bytes);
    EXPECT_THAT(bytes, ElementsAre(0, 255, 0, 255));
    int8_t signed_bytes[4];
    pack_rgba_float(GL_RGBA, GL_BYTE, false, rgba, 1, signed_bytes);
    EXPECT_THAT(signed_bytes, ElementsAre(-127, 127, 0, 127));
    uint32_t integers[4];
    pack_rgba_float(GL_RGBA, GL_UNSIGNED_INT, false, rgba, 1, integers);
    EXPECT_THAT(integers, ElementsAre(0u, 0xffffffffu, 0u, 0xffffffffu));
    int32_t signed_integers[4];
    pack_rgba_float(GL_RGBA, GL_INT, false, rgba, 1, signed_integers);
    EXPECT_THAT(signed_integers, ElementsAre(-0x7fffffff, 0x7fffffff, 0, 0x7fffffff));
    uint32_t packed;
    pack_rgba_float(GL_RGBA, GL_UNSIGNED_INT_10_10_10_2, false, rgba, 1, &packed);
    EXPECT_EQ(packed, 1023u << 12 | 3u);
}

TEST(PixelConvert, ResizedIntegersComeBack) {
    for (unsigned bits = 1; bits < 8; ++bits) {
        for (unsigned value = 0; value < 1u << bits; ++value) {
            EXPECT_EQ(resize_unorm(resize_unorm(value, bits, 8), 8, bits), value);
            EXPECT_EQ(resize_unorm(resize_unorm(value, bits, 16), 16, bits), value);
        }
    }
    EXPECT_EQ(resize_unorm(255, 8, 10), 1023u);
    EXPECT_EQ(resize_unorm(0xab, 8, 16), 0xababu);
}

TEST(PixelConvert, NarrowingRoundsToNearest) {
    for (unsigned bits = 1; bits < 8; ++bits) {
        const double maximum = (1u << bits) - 1;
        for (unsigned value = 0; value < 256; ++value) {
            EXPECT_LE(std::fabs(resize_unorm(value, 8, bits) - value * maximum / 255), 0.5);
        }
    }
}

TEST(PixelConvert, BitmapsInBothOrders) {
    const uint8_t bits[] = {0b10110001, 0b01000000};
    uint32_t indices[5];
    unpack_indices(GL_BITMAP, false, false, bits, 5, 5, indices);  // from the sixth bit, highest first
    EXPECT_THAT(indices, ElementsAre(0, 0, 1, 0, 1));
    unpack_indices(GL_BITMAP, false, true, bits, 5, 5, indices);
    EXPECT_THAT(indices, ElementsAre(1, 0, 1, 0, 0));
}

TEST(PixelConvert, PackedBitmapsLeaveOtherBits) {
    const uint32_t indices[] = {1, 2, 3};  // the lowest bit counts
    uint8_t bytes[] = {0xff, 0x00};
    pack_indices(GL_BITMAP, false, false, indices, 3, bytes, 6);
    EXPECT_THAT(bytes, ElementsAre(0b11111110, 0b10000000));
    uint8_t reversed[] = {0xff, 0x00};
    pack_indices(GL_BITMAP, false, true, indices, 3, reversed, 6);
    EXPECT_THAT(reversed, ElementsAre(0b01111111, 0b00000001));
}

TEST(PixelConvert, IndicesOfAllTypes) {
    const float values[] = {3.9f, -2.0f, std::nanf(""), 1e20f};
    uint32_t indices[4];
    unpack_indices(GL_FLOAT, false, false, values, 0, 4, indices);
    EXPECT_THAT(indices, ElementsAre(3u, 0xfffffffeu, 0u, 0xffffffffu));
    const int8_t negative[] = {-1};
    unpack_indices(GL_BYTE, false, false, negative, 0, 1, indices);
    EXPECT_EQ(indices[0], 0xffffffffu);
    // GL 1.5 table 4.6: signed types take the positive range.
    const uint32_t big[] = {0x1234ff};
    int8_t byte;
    pack_indices(GL_BYTE, false, false, big, 1, &byte, 0);
    EXPECT_EQ(byte, 0x7f);
    uint16_t swapped;
    pack_indices(GL_UNSIGNED_SHORT, true, false, big, 1, &swapped, 0);
    EXPECT_EQ(swapped, 0xff34);
}

TEST(PixelConvert, DepthExtremes) {
    const float depths[] = {0.0f, 1.0f};
    uint32_t integers[2];
    pack_depths(GL_UNSIGNED_INT, false, depths, 2, integers);
    EXPECT_THAT(integers, ElementsAre(0u, 0xffffffffu));
    uint16_t shorts[2];
    pack_depths(GL_UNSIGNED_SHORT, false, depths, 2, shorts);
    EXPECT_THAT(shorts, ElementsAre(0, 0xffff));
    int16_t signed_shorts[2];
    pack_depths(GL_SHORT, false, depths, 2, signed_shorts);
    EXPECT_THAT(signed_shorts, ElementsAre(0, 0x7fff));
    int8_t bytes[2];
    pack_depths(GL_BYTE, false, depths, 2, bytes);
    EXPECT_THAT(bytes, ElementsAre(0, 0x7f));
}

}  // namespace
}  // namespace terrazzo::gl
