// Legal pairs of format and type, and where pixels lie in client memory (GL 1.5 §3.6.4).
#include "gl/client_pixel.h"

#include <gtest/gtest.h>

namespace terrazzo::gl {
namespace {

TEST(ClientPixel, PackedTypesNeedTheirFormat) {
    EXPECT_EQ(check_client_pixel(GL_RGB, GL_UNSIGNED_SHORT_5_6_5).code, GLenum{GL_NO_ERROR});
    EXPECT_EQ(check_client_pixel(GL_BGR, GL_UNSIGNED_SHORT_5_6_5).code, GLenum{GL_INVALID_OPERATION});
    EXPECT_EQ(check_client_pixel(GL_RGBA, GL_UNSIGNED_BYTE_3_3_2).code, GLenum{GL_INVALID_OPERATION});
    EXPECT_EQ(check_client_pixel(GL_BGRA, GL_UNSIGNED_INT_2_10_10_10_REV).code, GLenum{GL_NO_ERROR});
    EXPECT_EQ(check_client_pixel(GL_RGB, GL_UNSIGNED_INT_8_8_8_8).code, GLenum{GL_INVALID_OPERATION});
    EXPECT_EQ(check_client_pixel(GL_LUMINANCE, GL_UNSIGNED_SHORT_4_4_4_4).code, GLenum{GL_INVALID_OPERATION});
}

TEST(ClientPixel, BitmapsHoldIndices) {
    EXPECT_EQ(check_client_pixel(GL_COLOR_INDEX, GL_BITMAP).code, GLenum{GL_NO_ERROR});
    EXPECT_EQ(check_client_pixel(GL_STENCIL_INDEX, GL_BITMAP).code, GLenum{GL_NO_ERROR});
    EXPECT_EQ(check_client_pixel(GL_LUMINANCE, GL_BITMAP).code, GLenum{GL_INVALID_ENUM});
}

TEST(ClientPixel, UnknownFormatsAndTypes) {
    EXPECT_EQ(check_client_pixel(0, GL_UNSIGNED_BYTE).code, GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(check_client_pixel(0, GL_UNSIGNED_SHORT_5_6_5).code, GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(check_client_pixel(GL_DEPTH_STENCIL, GL_UNSIGNED_SHORT_5_6_5).code, GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(check_client_pixel(GL_INTENSITY, GL_UNSIGNED_BYTE).code, GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(check_client_pixel(GL_RGBA, GL_DOUBLE).code, GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(check_client_pixel(GL_RGBA, 0).code, GLenum{GL_INVALID_ENUM});
}

struct LayoutCase {
    const char* name;
    PixelStore store;
    GLsizei width;
    GLenum format, type;
    ImageLayout expected;
};

PixelStore store(GLint alignment, GLint row_length = 0, GLint skip_rows = 0, GLint skip_pixels = 0) {
    PixelStore modes;
    modes.alignment = alignment;
    modes.row_length = row_length;
    modes.skip_rows = skip_rows;
    modes.skip_pixels = skip_pixels;
    return modes;
}

// Worked by hand from equations 3.13 and 3.14.
const LayoutCase kLayouts[] = {
    {"rows of 9 bytes end at 12", store(4), 3, GL_RGB, GL_UNSIGNED_BYTE, {0, 0, 12}},
    {"rows of 9 bytes unaligned", store(1), 3, GL_RGB, GL_UNSIGNED_BYTE, {0, 0, 9}},
    {"rows of 18 bytes end at 24", store(8), 3, GL_RGB, GL_UNSIGNED_SHORT, {0, 0, 24}},
    {"elements of 4 bytes are aligned to no less", store(2), 3, GL_RED, GL_FLOAT, {0, 0, 12}},
    {"a packed pixel is one element", store(4), 3, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, {0, 0, 8}},
    {"a row of its own length", store(4, 10), 3, GL_RGBA, GL_UNSIGNED_BYTE, {0, 0, 40}},
    {"two rows and three pixels on", store(4, 10, 2, 3), 3, GL_RGBA, GL_UNSIGNED_BYTE, {92, 0, 40}},
    {"17 bits end at 4 bytes", store(4), 17, GL_COLOR_INDEX, GL_BITMAP, {0, 0, 4}},
    {"17 bits end at 3 bytes", store(1), 17, GL_COLOR_INDEX, GL_BITMAP, {0, 0, 3}},
    {"one row and 13 bits on", store(1, 20, 1, 13), 5, GL_COLOR_INDEX, GL_BITMAP, {4, 5, 3}},
};

TEST(ClientPixel, ImageLayout) {
    for (const LayoutCase& test : kLayouts) {
        const ImageLayout layout = image_layout(test.store, test.width, test.format, test.type);
        EXPECT_EQ(layout.offset, test.expected.offset) << test.name;
        EXPECT_EQ(layout.first_bit, test.expected.first_bit) << test.name;
        EXPECT_EQ(layout.row_stride, test.expected.row_stride) << test.name;
    }
}

}  // namespace
}  // namespace terrazzo::gl
