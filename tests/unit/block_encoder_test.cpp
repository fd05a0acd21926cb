// S3TC by every way in: uploads, parts, copies and generated mipmaps are compressed; what
// GetCompressedTexImage gives, CompressedTexImage makes the same texture of.
#define GL_GLEXT_PROTOTYPES
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "attach_picture.h"
#include "gl/block_compression.h"
#include "gl/generated/commands.h"
#include "gl_fixture.h"

namespace terrazzo::gl {
namespace {

constexpr GLenum kFormats[] = {GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GL_COMPRESSED_RGBA_S3TC_DXT1_EXT,
                               GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT};
using Texels = std::vector<GLubyte>;

class BlockEncoderTest : public GlTest {
  protected:
    BlockEncoderTest() { attach_picture(ctx(), 16, 16); }

    void upload(GLenum format, int width, int height, const Texels& texels) {
        glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width, height, 0, GL_RGBA,
                     GL_UNSIGNED_BYTE, texels.data());
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    }
    GLint parameter(GLenum pname, GLint level = 0) {
        GLint value = -1;
        glGetTexLevelParameteriv(GL_TEXTURE_2D, level, pname, &value);
        return value;
    }
    Texels texels(int width, int height, GLint level = 0) {
        Texels out(static_cast<std::size_t>(4 * width * height));
        glGetTexImage(GL_TEXTURE_2D, level, GL_RGBA, GL_UNSIGNED_BYTE, out.data());
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        return out;
    }
    std::vector<std::byte> blocks(GLint level = 0) {
        std::vector<std::byte> out(
            static_cast<std::size_t>(parameter(GL_TEXTURE_COMPRESSED_IMAGE_SIZE, level)));
        glGetCompressedTexImage(GL_TEXTURE_2D, level, out.data());
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        return out;
    }
};

// A slope of colours and alphas, which four colours a block follow well.
Texels slope(int width, int height) {
    Texels out;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int value : {16 * x + y, 255 - 10 * x, 40 + 3 * y, x < width / 2 ? 255 : 30 + 9 * y})
                out.push_back(static_cast<GLubyte>(std::clamp(value, 0, 255)));
    return out;
}

TEST_F(BlockEncoderTest, UploadsAreCompressedAndComeBack) {
    for (const GLenum format : kFormats) {
        for (const auto& [width, height] : {std::pair{16, 16}, {5, 7}, {4, 4}, {2, 1}, {1, 1}, {13, 4}}) {
            const Texels given = slope(width, height);
            upload(format, width, height, given);
            EXPECT_EQ(parameter(GL_TEXTURE_COMPRESSED), GL_TRUE);
            EXPECT_EQ(parameter(GL_TEXTURE_INTERNAL_FORMAT), static_cast<GLint>(format));
            const int size = find_block_format(format)->block_bytes * ((width + 3) / 4) * ((height + 3) / 4);
            ASSERT_EQ(parameter(GL_TEXTURE_COMPRESSED_IMAGE_SIZE), size);
            const Texels kept = texels(width, height);
            const auto compressed = blocks();
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
            glCompressedTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, size, compressed.data());
            EXPECT_EQ(texels(width, height), kept);
            EXPECT_EQ(blocks(), compressed);
        }
    }
}

// The largest error of a channel that is kept.
int largest_error(const Texels& a, const Texels& b, bool with_alpha) {
    int largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (i % 4 != 3 || with_alpha) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

TEST_F(BlockEncoderTest, TexelsAreNearWhatWasGiven) {
    const Texels given = slope(16, 16);
    for (const GLenum format : kFormats) {
        if (format == GL_COMPRESSED_RGBA_S3TC_DXT1_EXT) continue;  // black where it is transparent
        upload(format, 16, 16, given);
        EXPECT_LE(largest_error(given, texels(16, 16), false), 12) << std::hex << format;
    }
    upload(GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, 16, 16, given);
    EXPECT_LE(largest_error(given, texels(16, 16), true), 12);
    upload(GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 16, 16, given);
    EXPECT_LE(largest_error(given, texels(16, 16), true), 12);
}

// What 5-6-5 holds comes back as it was: one colour, two, and four in a row.
TEST_F(BlockEncoderTest, BlocksOfColoursThatFitAreExact) {
    const auto fill = [](auto color_of) {
        Texels out;
        for (int i = 0; i < 16; ++i)
            for (const int c : color_of(i)) out.push_back(static_cast<GLubyte>(c));
        return out;
    };
    const std::array<int, 4> red{255, 0, 0, 255}, blue{0, 0, 255, 255};
    for (const GLenum format : kFormats) {
        for (const Texels& given : {fill([&](int) { return red; }),
                                    fill([&](int i) { return i % 3 ? red : blue; }), fill([](int i) {
                                        return std::array{0, i % 2 * 255, 0, 255};
                                    })}) {
            upload(format, 4, 4, given);
            EXPECT_EQ(texels(4, 4), given) << std::hex << format;
        }
    }
}

TEST_F(BlockEncoderTest, ASingleBitOfAlphaIsKept) {
    Texels given;
    for (int i = 0; i < 16; ++i) {
        const bool opaque = i % 5 != 0;
        for (const int c : {opaque ? 255 : 17, opaque ? 255 : 200, 0, opaque ? 200 : 127})
            given.push_back(static_cast<GLubyte>(c));
    }
    upload(GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, 4, 4, given);
    const Texels kept = texels(4, 4);
    for (std::size_t i = 0; i < 16; ++i) {
        const bool opaque = i % 5 != 0;
        EXPECT_EQ(kept[4 * i + 3], opaque ? 255 : 0) << i;
        EXPECT_EQ(kept[4 * i], opaque ? 255 : 0) << i;
    }
    for (std::size_t i = 0; i < 16; ++i) given[4 * i + 3] = 0;
    upload(GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, 4, 4, given);
    for (const GLubyte c : texels(4, 4)) EXPECT_EQ(c, 0);
    upload(GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 4, 4, given);
    EXPECT_EQ(texels(4, 4)[3], 255) << "without alpha nothing is transparent";
}

// Both of the ways that a block of alphas has.
TEST_F(BlockEncoderTest, AlphaRampsHoldTheirEnds) {
    for (const std::array<int, 4> alphas :
         {std::array{0, 255, 100, 110}, {0, 255, 0, 255}, {7, 8, 9, 10}, {0, 0, 0, 0}}) {
        Texels given;
        for (int i = 0; i < 16; ++i)
            for (const int c : {10, 20, 30, alphas[static_cast<std::size_t>(i % 4)]})
                given.push_back(static_cast<GLubyte>(c));
        upload(GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 4, 4, given);
        const Texels kept = texels(4, 4);
        for (std::size_t i = 3; i < kept.size(); i += 4) EXPECT_NEAR(kept[i], given[i], 1) << alphas[0];
    }
}

TEST_F(BlockEncoderTest, PartsAreWholeBlocks) {
    for (const GLenum format : kFormats) {
        upload(format, 10, 8, slope(10, 8));
        const Texels before = texels(10, 8);
        const Texels white(400, 255);
        const auto part = [&](GLint x, GLint y, GLsizei width, GLsizei height) {
            glTexSubImage2D(GL_TEXTURE_2D, 0, x, y, width, height, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
            return glGetError();
        };
        EXPECT_EQ(part(2, 0, 4, 4), GLenum{GL_INVALID_OPERATION});
        EXPECT_EQ(part(0, 1, 4, 4), GLenum{GL_INVALID_OPERATION});
        EXPECT_EQ(part(0, 0, 3, 4), GLenum{GL_INVALID_OPERATION});
        EXPECT_EQ(part(4, 4, 4, 3), GLenum{GL_INVALID_OPERATION});
        glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 1, 0, 0, 0, 4, 4);
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
        EXPECT_EQ(texels(10, 8), before);
        EXPECT_EQ(part(8, 4, 2, 4), GLenum{GL_NO_ERROR});
        EXPECT_EQ(parameter(GL_TEXTURE_COMPRESSED), GL_TRUE);
        Texels expected = before;
        for (int y = 4; y < 8; ++y)
            for (int x = 8; x < 10; ++x) std::fill_n(expected.begin() + 4 * (10 * y + x), 4, GLubyte{255});
        EXPECT_EQ(texels(10, 8), expected) << std::hex << format;
        const auto compressed = blocks();
        glCompressedTexImage2D(GL_TEXTURE_2D, 0, format, 10, 8, 0, static_cast<GLsizei>(compressed.size()),
                               compressed.data());
        EXPECT_EQ(texels(10, 8), expected) << std::hex << format;
    }
}

TEST_F(BlockEncoderTest, CopiesAreCompressed) {
    glClearColor(1, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    for (const GLenum format : kFormats) {
        glCopyTexImage2D(GL_TEXTURE_2D, 0, format, 0, 0, 8, 8, 0);
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        EXPECT_EQ(parameter(GL_TEXTURE_COMPRESSED), GL_TRUE);
        glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     slope(8, 8).data());
        glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 0, 0, 4, 4);
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        const Texels kept = texels(8, 8);
        const GLubyte magenta[] = {255, 0, 255, 255};
        EXPECT_TRUE(std::equal(magenta, magenta + 4, kept.begin() + 4 * (8 * 5 + 6))) << std::hex << format;
        EXPECT_FALSE(blocks().empty());
    }
}

TEST_F(BlockEncoderTest, GeneratedLevelsAreCompressed) {
    for (const GLenum format : kFormats) {
        glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
        upload(format, 8, 8, slope(8, 8));
        for (GLint level = 0; level <= 3; ++level) {
            EXPECT_EQ(parameter(GL_TEXTURE_COMPRESSED, level), GL_TRUE) << level;
            EXPECT_EQ(parameter(GL_TEXTURE_INTERNAL_FORMAT, level), static_cast<GLint>(format)) << level;
            EXPECT_EQ(blocks(level).size(),
                      static_cast<std::size_t>(level == 0 ? 4 : 1) *
                          static_cast<std::size_t>(find_block_format(format)->block_bytes));
        }
    }
}

TEST_F(BlockEncoderTest, BordersAndOtherDimensionsAreNotCompressed) {
    const Texels some(4096, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 6, 6, 1, GL_RGB, GL_UNSIGNED_BYTE,
                 some.data());
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 0, 0, 6, 6, 1);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    glTexImage1D(GL_TEXTURE_1D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 8, 0, GL_RGB, GL_UNSIGNED_BYTE,
                 some.data());
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
    glTexImage3D(GL_TEXTURE_3D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 4, 4, 4, 0, GL_RGB, GL_UNSIGNED_BYTE,
                 some.data());
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
}

}  // namespace
}  // namespace terrazzo::gl
