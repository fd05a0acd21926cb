// Texels: what uploads, partial uploads and copies store, with borders, indices, pixel transfer and pixel
// store modes that the reference cannot be compared in.
#include <gmock/gmock.h>

#include <algorithm>
#include <vector>

#include "gl/client_pixel.h"
#include "gl/generated/commands.h"
#include "gl/surface.h"
#include "gl_fixture.h"
#include "attach_picture.h"

namespace terrazzo::gl {
namespace {

using testing::Each;
using testing::ElementsAre;
using Bytes = std::vector<uint8_t>;

class TextureImages : public GlTest {
  protected:
    // The level's texels with its border, in R, G, B, A.
    Bytes texels(GLenum target = GL_TEXTURE_2D) {
        const TextureLevel& level = bound_texture(ctx(), target)->levels[0];
        Bytes bytes(4 * static_cast<size_t>(level.width * level.height));
        pixel_storei(ctx(), GL_PACK_ALIGNMENT, 1);
        get_tex_image(ctx(), target, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
        EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
        return bytes;
    }

    Bytes reds() {
        const Bytes all = texels();
        Bytes red;
        for (size_t i = 0; i < all.size(); i += 4) red.push_back(all[i]);
        return red;
    }

    void upload(GLsizei width, GLsizei height, GLenum format, GLenum type, const void* pixels,
                GLint internal_format = GL_RGBA8) {
        tex_image_2d(ctx(), GL_TEXTURE_2D, 0, internal_format, width, height, 0, format, type, pixels);
        EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
    }

    const uint8_t* stored(int x, int y) {
        return bound_texture(ctx(), GL_TEXTURE_2D)->levels[0].image->rgba8(x, y);
    }
};

TEST_F(TextureImages, BaseFormatsAreStoredAsSamplingSeesThem) {
    const uint8_t pixel[] = {10, 20, 30, 40};
    const auto stored_as = [&](GLint internal_format) {
        upload(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel, internal_format);
        const uint8_t* texel = stored(0, 0);
        return Bytes(texel, texel + 4);
    };
    EXPECT_THAT(stored_as(GL_ALPHA), ElementsAre(0, 0, 0, 40));
    EXPECT_THAT(stored_as(GL_LUMINANCE), ElementsAre(10, 10, 10, 255));
    EXPECT_THAT(stored_as(GL_LUMINANCE_ALPHA), ElementsAre(10, 10, 10, 40));
    EXPECT_THAT(stored_as(GL_INTENSITY), ElementsAre(10, 10, 10, 10));
    EXPECT_THAT(stored_as(GL_RGB), ElementsAre(10, 20, 30, 255));
    EXPECT_THAT(stored_as(GL_RGBA), ElementsAre(10, 20, 30, 40));
}

TEST_F(TextureImages, DeepFormatsAreFloats) {
    const uint16_t pixel[] = {1, 256, 65535, 32768};
    upload(1, 1, GL_RGBA, GL_UNSIGNED_SHORT, pixel, GL_RGBA16);
    const float* texel = bound_texture(ctx(), GL_TEXTURE_2D)->levels[0].image->rgba32f(0, 0);
    EXPECT_FLOAT_EQ(texel[0], 1.0f / 65535.0f);
    EXPECT_FLOAT_EQ(texel[1], 256.0f / 65535.0f);
    EXPECT_FLOAT_EQ(texel[2], 1.0f);
    EXPECT_FLOAT_EQ(texel[3], 32768.0f / 65535.0f);
}

TEST_F(TextureImages, FloatsRoundOnceAndUpInTheMiddle) {
    const float middle = 0.5f / 7.0f;
    const float pixels[] = {middle, 5 * middle, 1, 0, middle - 0.001f, 5 * middle - 0.001f, 1, 0};
    upload(2, 1, GL_RGBA, GL_FLOAT, pixels, GL_R3_G3_B2);
    EXPECT_THAT(texels(), ElementsAre(36, 109, 255, 255, 0, 73, 255, 255));
}

TEST_F(TextureImages, WithoutPixelsTheImageIsBlack) {
    upload(3, 2, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    EXPECT_THAT(texels(), Each(0));
}

TEST_F(TextureImages, BordersSurroundTheImage) {
    Bytes pixels(4 * 6 * 5);
    for (size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<uint8_t>(i);
    tex_image_2d(ctx(), GL_TEXTURE_2D, 0, GL_RGBA8, 6, 5, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    const TextureLevel& level = bound_texture(ctx(), GL_TEXTURE_2D)->levels[0];
    EXPECT_EQ(level.image->width, 4);
    EXPECT_EQ(level.image->height, 3);
    EXPECT_EQ(stored(-1, -1)[0], 0);
    EXPECT_EQ(stored(0, 0)[0], 4 * (6 + 1));
    EXPECT_EQ(stored(4, 3)[3], 4 * 30 - 1);
    EXPECT_EQ(texels(), pixels);
    // Offsets count from the interior: -1 is the border.
    const uint8_t corner[] = {1, 2, 3, 4};
    tex_sub_image_2d(ctx(), GL_TEXTURE_2D, 0, -1, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, corner);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
    EXPECT_EQ(stored(-1, 3)[2], 3);
}

TEST_F(TextureImages, OneDimensionalBordersAreAtTheEnds) {
    const uint8_t pixels[] = {10, 20, 30, 40};
    tex_image_1d(ctx(), GL_TEXTURE_1D, 0, GL_LUMINANCE, 4, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, pixels);
    const TextureLevel& level = bound_texture(ctx(), GL_TEXTURE_1D)->levels[0];
    EXPECT_EQ(level.image->width, 2);
    EXPECT_EQ(level.image->height, 1);
    EXPECT_EQ(level.image->rgba8(-1, 0)[0], 10);
    EXPECT_EQ(level.image->rgba8(2, 0)[0], 40);
}

TEST_F(TextureImages, PartialUploadsLeaveTheRest) {
    upload(4, 4, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    const uint8_t pixels[] = {1, 2, 3, 4};
    pixel_storei(ctx(), GL_UNPACK_ALIGNMENT, 1);
    tex_sub_image_2d(ctx(), GL_TEXTURE_2D, 0, 1, 2, 2, 2, GL_RED, GL_UNSIGNED_BYTE, pixels);
    EXPECT_THAT(reds(), ElementsAre(0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 0, 0, 3, 4, 0));
}

TEST_F(TextureImages, SwappedBytesAndSkippedPixels) {
    // Rows of 3 pixels, of which row 1, pixels 1 and 2 are wanted; big-endian on a little-endian host and
    // vice versa.
    uint16_t pixels[6] = {0, 0, 0, 0, __builtin_bswap16(0x8080), __builtin_bswap16(0xffff)};
    pixel_storei(ctx(), GL_UNPACK_SWAP_BYTES, 1);
    pixel_storei(ctx(), GL_UNPACK_ROW_LENGTH, 3);
    pixel_storei(ctx(), GL_UNPACK_SKIP_ROWS, 1);
    pixel_storei(ctx(), GL_UNPACK_SKIP_PIXELS, 1);
    pixel_storei(ctx(), GL_UNPACK_ALIGNMENT, 1);
    upload(2, 1, GL_RED, GL_UNSIGNED_SHORT, pixels);
    EXPECT_THAT(reds(), ElementsAre(0x80, 0xff));
}

TEST_F(TextureImages, IndicesAreLookedUp) {
    const GLfloat red[] = {0, 0.2f, 0.4f, 0.6f}, alpha[] = {1, 0};
    pixel_mapfv(ctx(), GL_PIXEL_MAP_I_TO_R, 4, red);
    pixel_mapfv(ctx(), GL_PIXEL_MAP_I_TO_A, 2, alpha);
    pixel_transferf(ctx(), GL_INDEX_SHIFT, 1);
    pixel_transferf(ctx(), GL_INDEX_OFFSET, 1);
    pixel_transferf(ctx(), GL_RED_SCALE, 0);  // colours that were indices are not scaled (GL 1.5 figure 3.7)
    const uint8_t indices[] = {0, 1, 2};      // 2 i + 1, of which the map takes the lowest bits: 1, 3, 1
    upload(3, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, indices);
    EXPECT_THAT(texels(), ElementsAre(51, 0, 0, 0, 153, 0, 0, 0, 51, 0, 0, 0));
    pixel_transferf(ctx(), GL_INDEX_SHIFT, -1);
    pixel_transferf(ctx(), GL_INDEX_OFFSET, 0);
    upload(3, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, indices);
    EXPECT_THAT(reds(), ElementsAre(0, 0, 51));
}

TEST_F(TextureImages, BitmapsWithModes) {
    const GLfloat red[] = {0, 1};
    pixel_mapfv(ctx(), GL_PIXEL_MAP_I_TO_R, 2, red);
    // Two rows of 11 bits in 2 bytes each, lowest bit first; from pixel 3 of row 1 on.
    const uint8_t bits[] = {0xff, 0xff, 0b01101000, 0b00000101, 0b10010000, 0b00000000};
    pixel_storei(ctx(), GL_UNPACK_LSB_FIRST, 1);
    pixel_storei(ctx(), GL_UNPACK_ALIGNMENT, 2);
    pixel_storei(ctx(), GL_UNPACK_ROW_LENGTH, 11);
    pixel_storei(ctx(), GL_UNPACK_SKIP_ROWS, 1);
    pixel_storei(ctx(), GL_UNPACK_SKIP_PIXELS, 3);
    upload(7, 2, GL_COLOR_INDEX, GL_BITMAP, bits);
    EXPECT_THAT(reds(), ElementsAre(255, 0, 255, 255, 0, 255, 0, 0, 255, 0, 0, 255, 0, 0));
}

TEST_F(TextureImages, PixelTransferOfRowsWithGaps) {
    pixel_transferf(ctx(), GL_RED_SCALE, 0.5f);
    pixel_transferf(ctx(), GL_RED_BIAS, 0.25f);
    pixel_storei(ctx(), GL_UNPACK_ALIGNMENT, 4);
    pixel_storei(ctx(), GL_UNPACK_SKIP_PIXELS, 1);
    const uint8_t pixels[] = {9, 0, 255, 9, 9, 51, 102, 9};
    upload(2, 2, GL_RED, GL_UNSIGNED_BYTE, pixels);
    EXPECT_THAT(reds(), ElementsAre(64, 191, 89, 115));
}

TEST_F(TextureImages, ColorMapsComeAfterScaleAndBias) {
    const GLfloat map[] = {1, 0};  // position 0.5 rounds to even: 0
    pixel_mapfv(ctx(), GL_PIXEL_MAP_R_TO_R, 2, map);
    pixel_transferf(ctx(), GL_MAP_COLOR, 1);
    pixel_transferf(ctx(), GL_RED_SCALE, 2);
    const float pixels[] = {-1, 0.2f, 0.3f, 7};
    upload(4, 1, GL_RED, GL_FLOAT, pixels);
    EXPECT_THAT(reds(), ElementsAre(255, 255, 0, 0));
}

TEST_F(TextureImages, PackModesLeaveBytesBetweenRows) {
    const uint8_t pixels[] = {1, 2, 3, 4};
    pixel_storei(ctx(), GL_UNPACK_ALIGNMENT, 1);
    upload(2, 2, GL_LUMINANCE, GL_UNSIGNED_BYTE, pixels, GL_LUMINANCE8);
    pixel_storei(ctx(), GL_PACK_ALIGNMENT, 2);
    pixel_storei(ctx(), GL_PACK_ROW_LENGTH, 5);
    pixel_storei(ctx(), GL_PACK_SKIP_ROWS, 1);
    pixel_storei(ctx(), GL_PACK_SKIP_PIXELS, 2);
    Bytes out(18, 0xcd);
    get_tex_image(ctx(), GL_TEXTURE_2D, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, out.data());
    EXPECT_THAT(out, ElementsAre(0xcd, 0xcd, 0xcd, 0xcd, 0xcd, 0xcd, 0xcd, 0xcd, 1, 2, 0xcd, 0xcd, 0xcd, 0xcd,
                                 3, 4, 0xcd, 0xcd));
}

// A window whose pixel (x, y) has red 10 x and green 10 y.
class Copies : public TextureImages {
  protected:
    static constexpr int kSize = 8;

    Copies() {
        attach_picture(ctx(), kSize, kSize);
        raster::Target& target = *ctx().renderer.target();
        target.materialize(0);
        const raster::Bin bin = target.bin(0);
        for (int y = 0; y < kSize; ++y) {
            for (int x = 0; x < kSize; ++x) {
                const int row = kSize - 1 - y;  // row 0 of a window is its top row
                std::byte* pixel = bin.color + 4 * raster::pixel_index(x, row);
                pixel[0] = static_cast<std::byte>(10 * x);
                pixel[1] = static_cast<std::byte>(10 * y);
                pixel[2] = static_cast<std::byte>(200);
                pixel[3] = static_cast<std::byte>(100);
            }
        }
    }
};

TEST_F(Copies, RowsGoUp) {
    copy_tex_image_2d(ctx(), GL_TEXTURE_2D, 0, GL_RGBA, 2, 3, 2, 2, 0);
    EXPECT_THAT(texels(),
                ElementsAre(20, 30, 200, 100, 30, 30, 200, 100, 20, 40, 200, 100, 30, 40, 200, 100));
}

TEST_F(Copies, BeyondTheWindowIsBlackInNewImagesAndUntouchedInOldOnes) {
    copy_tex_image_2d(ctx(), GL_TEXTURE_2D, 0, GL_RGB, kSize - 1, -1, 2, 2, 0);
    EXPECT_THAT(reds(), ElementsAre(0, 0, 70, 0));
    const uint8_t ones[] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
    upload(2, 2, GL_RGBA, GL_UNSIGNED_BYTE, ones);
    copy_tex_sub_image_2d(ctx(), GL_TEXTURE_2D, 0, 0, 0, -1, kSize - 1, 2, 2);
    EXPECT_THAT(reds(), ElementsAre(1, 0, 1, 1));
    copy_tex_sub_image_2d(ctx(), GL_TEXTURE_2D, 0, 0, 0, 0x7fffffff, -0x7fffffff, 2, 2);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
    EXPECT_THAT(reds(), ElementsAre(1, 0, 1, 1));
}

TEST_F(Copies, GoThroughPixelTransfer) {
    pixel_transferf(ctx(), GL_RED_BIAS, 0.2f);
    pixel_transferf(ctx(), GL_BLUE_SCALE, 2);
    copy_tex_image_2d(ctx(), GL_TEXTURE_2D, 0, GL_RGB, 1, 0, 2, 1, 0);
    EXPECT_THAT(texels(), ElementsAre(61, 0, 255, 255, 71, 0, 255, 255));
}

TEST_F(Copies, DropBitsThatTheFormatDoesNotKeep) {
    copy_tex_image_2d(ctx(), GL_TEXTURE_2D, 0, GL_RGB5, 0, 0, kSize, 1, 0);
    // The 5 highest bits of 10 x, then repeated; 10 x * 31 / 255 is 2.43 for x = 2 and 4.86 for x = 4.
    EXPECT_THAT(reds(), ElementsAre(0, 8, 16, 24, 41, 49, 57, 66));
}

TEST_F(Copies, LuminanceOfACopyIsRed) {
    copy_tex_image_1d(ctx(), GL_TEXTURE_1D, 0, GL_LUMINANCE, 5, 5, 2, 0);
    EXPECT_THAT(texels(GL_TEXTURE_1D), ElementsAre(50, 0, 0, 255, 60, 0, 0, 255));
}

TEST_F(Copies, ReadPixelsLeavesWhatIsOutside) {
    Bytes out(9, 0xcd);
    pixel_storei(ctx(), GL_PACK_ALIGNMENT, 1);
    read_pixels(ctx(), -1, -1, 3, 3, GL_RED, GL_UNSIGNED_BYTE, out.data());
    EXPECT_THAT(out, ElementsAre(0xcd, 0xcd, 0xcd, 0xcd, 0, 10, 0xcd, 0, 10));
    std::fill(out.begin(), out.end(), 0xcd);
    read_pixels(ctx(), 0x7fffffff, 0, 3, 3, GL_RED, GL_UNSIGNED_BYTE, out.data());
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
    EXPECT_THAT(out, Each(0xcd));
}

TEST_F(Copies, ReadLuminanceIsTheSumClamped) {
    uint8_t out[2];
    pixel_storei(ctx(), GL_PACK_ALIGNMENT, 1);
    read_pixels(ctx(), 4, 0, 2, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, out);
    EXPECT_THAT(out, ElementsAre(240, 250));
    read_pixels(ctx(), 5, 7, 2, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, out);
    EXPECT_THAT(out, ElementsAre(255, 255));
}

TEST_F(Copies, ReadStencilThroughTheMap) {
    raster::Target& target = *ctx().renderer.target();
    const raster::Bin bin = target.bin(0);
    bin.stencil[raster::pixel_index(0, kSize - 1)] = 3;
    bin.stencil[raster::pixel_index(1, kSize - 1)] = 4;
    const GLfloat map[] = {10, 20, 30, 41};
    pixel_mapfv(ctx(), GL_PIXEL_MAP_S_TO_S, 4, map);
    pixel_transferf(ctx(), GL_MAP_STENCIL, 1);
    uint8_t out[2];
    read_pixels(ctx(), 0, 0, 2, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, out);
    EXPECT_THAT(out, ElementsAre(41, 10));
    uint8_t bits = 0;
    read_pixels(ctx(), 0, 0, 2, 1, GL_STENCIL_INDEX, GL_BITMAP, &bits);
    EXPECT_EQ(bits, 0b10000000);
}

TEST_F(Copies, ReadDepthThroughScaleAndBias) {
    raster::Target& target = *ctx().renderer.target();
    const raster::Bin bin = target.bin(0);
    bin.depth[raster::pixel_index(0, kSize - 1)] = 0xffffff;
    bin.depth[raster::pixel_index(1, kSize - 1)] = 0x800000;
    GLuint integers[2];
    read_pixels(ctx(), 0, 0, 2, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, integers);
    EXPECT_THAT(integers, ElementsAre(0xffffffffu, 0x80000080u));
    pixel_transferf(ctx(), GL_DEPTH_SCALE, 2);
    pixel_transferf(ctx(), GL_DEPTH_BIAS, -0.75f);
    GLfloat depths[2];
    read_pixels(ctx(), 0, 0, 2, 1, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
    EXPECT_EQ(depths[0], 1.0f);
    EXPECT_NEAR(depths[1], 0.25f, 1e-6f);
}

}  // namespace
}  // namespace terrazzo::gl
