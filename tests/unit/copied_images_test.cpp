// CopyTexImage and CopyTexSubImage: for every internal format and target the texels are those of an upload of
// what the frame buffer holds (GL 1.5 §3.8.2); depth comes with stencil where the format has both.
#define GL_GLEXT_PROTOTYPES
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "attach_picture.h"
#include "gl/generated/commands.h"
#include "gl_fixture.h"

namespace terrazzo::gl {
namespace {

constexpr int kSize = 8;
constexpr GLint kFormats[] = {GL_ALPHA,
                              GL_ALPHA4,
                              GL_ALPHA8,
                              GL_ALPHA12,
                              GL_ALPHA16,
                              GL_LUMINANCE,
                              GL_LUMINANCE4,
                              GL_LUMINANCE8,
                              GL_LUMINANCE12,
                              GL_LUMINANCE16,
                              GL_LUMINANCE_ALPHA,
                              GL_LUMINANCE4_ALPHA4,
                              GL_LUMINANCE6_ALPHA2,
                              GL_LUMINANCE8_ALPHA8,
                              GL_LUMINANCE12_ALPHA4,
                              GL_LUMINANCE12_ALPHA12,
                              GL_LUMINANCE16_ALPHA16,
                              GL_INTENSITY,
                              GL_INTENSITY4,
                              GL_INTENSITY8,
                              GL_INTENSITY12,
                              GL_INTENSITY16,
                              GL_R3_G3_B2,
                              GL_RGB,
                              GL_RGB4,
                              GL_RGB5,
                              GL_RGB8,
                              GL_RGB10,
                              GL_RGB12,
                              GL_RGB16,
                              GL_RGBA,
                              GL_RGBA2,
                              GL_RGBA4,
                              GL_RGB5_A1,
                              GL_RGBA8,
                              GL_RGB10_A2,
                              GL_RGBA12,
                              GL_RGBA16,
                              GL_COMPRESSED_ALPHA,
                              GL_COMPRESSED_LUMINANCE,
                              GL_COMPRESSED_LUMINANCE_ALPHA,
                              GL_COMPRESSED_INTENSITY,
                              GL_COMPRESSED_RGB,
                              GL_COMPRESSED_RGBA};
constexpr GLint kDepthFormats[] = {GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24,
                                   GL_DEPTH_COMPONENT32};

class CopiedImagesTest : public GlTest {
  protected:
    CopiedImagesTest() { attach(8); }

    void attach(int stencil_bits) {
        raster::TargetFormat format;
        format.depth_bits = 24;
        format.stencil_bits = static_cast<std::uint8_t>(stencil_bits);
        attach_picture(ctx(), kSize, kSize, format);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    }

    // Values that every format keeps: 0 and all bits.
    void paint() {
        glEnable(GL_SCISSOR_TEST);
        for (int i = 0; i < kSize * kSize; ++i) {
            glScissor(i % kSize, i / kSize, 1, 1);
            const auto bit = [&](int b) { return static_cast<GLfloat>((i * 37 + 11) >> b & 1); };
            glClearColor(bit(0), bit(1), bit(2), bit(3));
            glClearDepth(static_cast<double>(bit(4)));
            glClearStencil(i * 29 & 255);
            glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        }
        glDisable(GL_SCISSOR_TEST);
    }

    template <typename Value>
    std::vector<Value> window(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type,
                              int components) {
        std::vector<Value> out(static_cast<std::size_t>(width * height * components));
        glReadPixels(x, y, width, height, format, type, out.data());
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        return out;
    }

    std::vector<GLfloat> texels(GLenum target, GLenum format, std::size_t count) {
        std::vector<GLfloat> out(count);
        glGetTexImage(target, 0, format, GL_FLOAT, out.data());
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        return out;
    }
};

TEST_F(CopiedImagesTest, ImagesAreWhatUploadsAre) {
    paint();
    const GLenum kTargets[] = {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_CUBE_MAP_POSITIVE_X,
                               GL_TEXTURE_CUBE_MAP_NEGATIVE_Y};
    const auto compare = [&](GLint format, GLenum target, GLint border, GLenum client) {
        const bool one = target == GL_TEXTURE_1D;
        const GLsizei size = 4 + 2 * border, height = one ? 1 : size;
        const bool is_depth = client == GL_DEPTH_COMPONENT;
        const auto pixels = window<GLfloat>(1, 2, size, height, client, GL_FLOAT, is_depth ? 1 : 4);
        if (one)
            glTexImage1D(target, 0, format, size, border, client, GL_FLOAT, pixels.data());
        else
            glTexImage2D(target, 0, format, size, height, border, client, GL_FLOAT, pixels.data());
        const auto expected = texels(target, client, pixels.size());
        one ? glCopyTexImage1D(target, 0, static_cast<GLenum>(format), 1, 2, size, border)
            : glCopyTexImage2D(target, 0, static_cast<GLenum>(format), 1, 2, size, height, border);
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        EXPECT_EQ(texels(target, client, pixels.size()), expected)
            << std::hex << "0x" << format << " to 0x" << target << " border " << border;
    };
    for (const GLenum target : kTargets) {
        for (const GLint border : {0, 1}) {
            for (const GLint format : kFormats) compare(format, target, border, GL_RGBA);
            if (target == GL_TEXTURE_1D || target == GL_TEXTURE_2D)
                for (const GLint format : kDepthFormats) compare(format, target, border, GL_DEPTH_COMPONENT);
        }
    }
}

// What no command writes is what zeros would make: black, and opaque where the format has no alpha. A
// combiner sees it.
TEST_F(CopiedImagesTest, TexelsThatNothingGivesAreThoseOfZeros) {
    glEnable(GL_TEXTURE_2D);
    for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, name, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    for (const GLenum name : {GL_COMBINE_RGB, GL_COMBINE_ALPHA}) glTexEnvi(GL_TEXTURE_ENV, name, GL_REPLACE);
    const auto drawn = [&] {
        glClearColor(0.5f, 0.5f, 0.5f, 0.5f);
        glClear(GL_COLOR_BUFFER_BIT);
        glBegin(GL_QUADS);
        for (const auto& [s, t] : {std::array{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}}) {
            glTexCoord2f(s, t);
            glVertex2f(2 * s - 1, 2 * t - 1);
        }
        glEnd();
        return window<GLubyte>(7, 7, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, 4);
    };
    const std::vector<GLubyte> zeros(4 * 10 * 10);
    for (const GLint format : kFormats) {
        for (const GLint border : {0, 1}) {
            const GLsizei size = 4 + 2 * border;
            const auto specify = [&](const void* texels) {
                glTexImage2D(GL_TEXTURE_2D, 0, format, size, size, border, GL_RGBA, GL_UNSIGNED_BYTE, texels);
                return drawn();
            };
            const auto expected = specify(zeros.data());
            EXPECT_EQ(specify(nullptr), expected) << std::hex << "0x" << format;
            glCopyTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLenum>(format), 6, 6, size, size, border);
            EXPECT_EQ(drawn(), expected) << "beyond the window, " << std::hex << "0x" << format;
        }
    }
}

TEST_F(CopiedImagesTest, PartsAreWhatUploadsAre) {
    paint();
    const auto pixels = window<GLfloat>(3, 1, 2, 2, GL_RGBA, GL_FLOAT, 4);
    const std::vector<GLfloat> some(4 * 64, 0.5f);
    for (const GLint format : kFormats) {
        glTexImage3D(GL_TEXTURE_3D, 0, format, 4, 4, 4, 0, GL_RGBA, GL_FLOAT, some.data());
        glTexSubImage3D(GL_TEXTURE_3D, 0, 1, 2, 3, 2, 2, 1, GL_RGBA, GL_FLOAT, pixels.data());
        const auto expected = texels(GL_TEXTURE_3D, GL_RGBA, some.size());
        glTexImage3D(GL_TEXTURE_3D, 0, format, 4, 4, 4, 0, GL_RGBA, GL_FLOAT, some.data());
        glCopyTexSubImage3D(GL_TEXTURE_3D, 0, 1, 2, 3, 3, 1, 2, 2);
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        EXPECT_EQ(texels(GL_TEXTURE_3D, GL_RGBA, some.size()), expected) << std::hex << "0x" << format;
    }
}

TEST_F(CopiedImagesTest, DepthAndStencilComeTogether) {
    paint();
    const auto packed = [&] {
        std::vector<GLuint> out(kSize * kSize);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, out.data());
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        return out;
    };
    const auto expected = window<GLuint>(0, 0, kSize, kSize, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, 1);
    for (const GLint format : {GL_DEPTH_STENCIL, GL_DEPTH24_STENCIL8}) {
        glCopyTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLenum>(format), 0, 0, kSize, kSize, 0);
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        EXPECT_EQ(packed(), expected);
        const std::vector<GLuint> nothing(kSize * kSize);
        glTexImage2D(GL_TEXTURE_2D, 0, format, kSize, kSize, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8,
                     nothing.data());
        glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 2, 3, 2, 3, 4, 4);
        const auto part = packed();
        for (std::size_t i = 0; i < part.size(); ++i) {
            const bool inside = i % kSize >= 2 && i % kSize < 6 && i / kSize >= 3 && i / kSize < 7;
            EXPECT_EQ(part[i], inside ? expected[i] : 0u) << i;
        }
    }
    glPixelTransferi(GL_INDEX_OFFSET, 3);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, 0, 0, kSize, kSize, 0);
    glPixelTransferi(GL_INDEX_OFFSET, 0);
    EXPECT_EQ(packed()[1] & 255, (expected[1] + 3) & 255) << "through pixel transfer";
}

TEST_F(CopiedImagesTest, BothBuffersMustBeThere) {
    attach(0);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, 0, 0, 4, 4, 0);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 0, 0, 4, 4, 0);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    const std::array<GLuint, 16> nothing{};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, 4, 4, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8,
                 nothing.data());
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 4, 4);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
}

}  // namespace
}  // namespace terrazzo::gl
