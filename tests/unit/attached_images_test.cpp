// Textures attached to frame buffer objects: every format that can be drawn to, every kind of image, slices
// of 3D textures, cube maps' faces, levels, borders. What is drawn reaches its texels, and no others change;
// bits, depths and stencil values are those of the attachment from the first query on.
#define GL_GLEXT_PROTOTYPES
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "attach_picture.h"
#include "gl/generated/commands.h"
#include "gl_fixture.h"

namespace terrazzo::gl {
namespace {

constexpr GLint kColorFormats[] = {GL_R3_G3_B2, GL_RGB,      GL_RGB4,   GL_RGB5,  GL_RGB8,  GL_RGB10,
                                   GL_RGB12,    GL_RGB16,    GL_RGBA,   GL_RGBA2, GL_RGBA4, GL_RGB5_A1,
                                   GL_RGBA8,    GL_RGB10_A2, GL_RGBA12, GL_RGBA16};

struct ImageKind {
    const char* name;
    GLenum target, image;
    int dimensions;
    GLint level, layer, border;
};
constexpr ImageKind kKinds[] = {
    {"1D", GL_TEXTURE_1D, GL_TEXTURE_1D, 1, 0, 0, 0},
    {"1D with border", GL_TEXTURE_1D, GL_TEXTURE_1D, 1, 0, 0, 1},
    {"2D", GL_TEXTURE_2D, GL_TEXTURE_2D, 2, 0, 0, 0},
    {"2D, level 2", GL_TEXTURE_2D, GL_TEXTURE_2D, 2, 2, 0, 0},
    {"2D with border", GL_TEXTURE_2D, GL_TEXTURE_2D, 2, 0, 0, 1},
    {"face +x", GL_TEXTURE_CUBE_MAP, GL_TEXTURE_CUBE_MAP_POSITIVE_X, 2, 0, 0, 0},
    {"face -z", GL_TEXTURE_CUBE_MAP, GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, 2, 0, 0, 0},
    {"3D, first slice", GL_TEXTURE_3D, GL_TEXTURE_3D, 3, 0, 0, 0},
    {"3D, slice 2", GL_TEXTURE_3D, GL_TEXTURE_3D, 3, 0, 2, 0},
    {"3D, slice 1 of level 1", GL_TEXTURE_3D, GL_TEXTURE_3D, 3, 1, 1, 0},
    {"3D, a slice of the border", GL_TEXTURE_3D, GL_TEXTURE_3D, 3, 0, 0, 1},
    {"3D with border, slice 2", GL_TEXTURE_3D, GL_TEXTURE_3D, 3, 0, 2, 1},
};
constexpr int kSize = 8, kDepth = 4;

struct Size {
    int width, height = 1, depth = 1;
    std::size_t texels() const { return static_cast<std::size_t>(width * height * depth); }
};
Size size_of(const ImageKind& kind) {
    const int size = (kind.level ? 4 : kSize) + 2 * kind.border;
    return {size, kind.dimensions > 1 ? size : 1,
            kind.dimensions > 2 ? (kind.level ? 2 : kDepth) + 2 * kind.border : 1};
}

class AttachedImagesTest : public GlTest {
  protected:
    AttachedImagesTest() {
        raster::TargetFormat window;
        window.depth_bits = 24;
        window.stencil_bits = 8;
        attach_picture(ctx(), 4, 4, window);
        glEnable(GL_SCISSOR_TEST);
        glScissor(1, 0, 2, 1);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    }

    void specify(const ImageKind& kind, GLint format, GLenum client_format, GLenum type, const void* texels) {
        const Size size = size_of(kind);
        glBindTexture(kind.target, 1);
        if (kind.dimensions == 1)
            glTexImage1D(kind.image, kind.level, format, size.width, kind.border, client_format, type,
                         texels);
        if (kind.dimensions == 2)
            glTexImage2D(kind.image, kind.level, format, size.width, size.height, kind.border, client_format,
                         type, texels);
        if (kind.dimensions == 3)
            glTexImage3D(kind.image, kind.level, format, size.width, size.height, size.depth, kind.border,
                         client_format, type, texels);
        ASSERT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    }

    void attach(const ImageKind& kind, GLenum point) {
        glBindFramebuffer(GL_FRAMEBUFFER, 1);
        if (kind.dimensions == 1) glFramebufferTexture1D(GL_FRAMEBUFFER, point, kind.image, 1, kind.level);
        if (kind.dimensions == 2) glFramebufferTexture2D(GL_FRAMEBUFFER, point, kind.image, 1, kind.level);
        if (kind.dimensions == 3)
            glFramebufferTexture3D(GL_FRAMEBUFFER, point, kind.image, 1, kind.level, kind.layer);
        ASSERT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_COMPLETE}) << kind.name;
    }

    void leave() {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        const GLuint object = 1, texture = 1;
        glDeleteFramebuffers(1, &object);
        glDeleteTextures(1, &texture);
        ASSERT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    }

    GLint get(GLenum name) {
        GLint value = -1;
        glGetIntegerv(name, &value);
        return value;
    }
    GLint attachment(GLenum point, GLenum name) {
        GLint value = -1;
        glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, point, name, &value);
        return value;
    }
};

// Whether texel `i` of the image is in the box that is drawn to.
bool is_drawn(const ImageKind& kind, std::size_t i) {
    const Size size = size_of(kind);
    const auto row = i / static_cast<std::size_t>(size.width),
               column = i % static_cast<std::size_t>(size.width);
    return row == static_cast<std::size_t>(kind.layer * size.height) && (column == 1 || column == 2);
}

TEST_F(AttachedImagesTest, ColoursAreDrawnWhereTheyBelong) {
    for (const GLint format : kColorFormats) {
        for (const ImageKind& kind : kKinds) {
            std::vector<GLushort> given(4 * size_of(kind).texels());
            for (std::size_t i = 0; i < given.size(); ++i) given[i] = static_cast<GLushort>(i * 40503u);
            specify(kind, format, GL_RGBA, GL_UNSIGNED_SHORT, given.data());
            std::vector<GLfloat> before(given.size()), after(given.size());
            glGetTexImage(kind.image, kind.level, GL_RGBA, GL_FLOAT, before.data());
            attach(kind, GL_COLOR_ATTACHMENT0);
            const GLenum kBits[] = {GL_RED_BITS, GL_GREEN_BITS, GL_BLUE_BITS, GL_ALPHA_BITS};
            for (GLenum c = 0; c < 4; ++c)
                EXPECT_EQ(get(kBits[c]),
                          attachment(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE + c))
                    << kind.name << " 0x" << std::hex << format;
            EXPECT_EQ(get(GL_DEPTH_BITS), 0) << "the window's";
            EXPECT_EQ(get(GL_STENCIL_BITS), 0);
            glClearColor(1, 0, 1, 0);
            glClear(GL_COLOR_BUFFER_BIT);
            GLfloat pixel[4] = {};
            glReadPixels(2, 0, 1, 1, GL_RGBA, GL_FLOAT, pixel);
            glBindFramebuffer(GL_FRAMEBUFFER, 0);
            glGetTexImage(kind.image, kind.level, GL_RGBA, GL_FLOAT, after.data());
            GLint alpha_size = 0;
            glGetTexLevelParameteriv(kind.image, kind.level, GL_TEXTURE_ALPHA_SIZE, &alpha_size);
            const GLfloat drawn[4] = {1, 0, 1, alpha_size ? 0.0f : 1.0f};
            for (std::size_t i = 0; i < after.size(); ++i) {
                const GLfloat expected = is_drawn(kind, i / 4) ? drawn[i % 4] : before[i];
                ASSERT_EQ(after[i], expected)
                    << kind.name << " 0x" << std::hex << format << " component " << std::dec << i;
            }
            for (int c = 0; c < 4; ++c) EXPECT_EQ(pixel[c], drawn[c]) << kind.name;
            leave();
        }
    }
}

TEST_F(AttachedImagesTest, DepthsAndStencilValuesAreDrawnWhereTheyBelong) {
    struct DepthFormat {
        GLint format;
        GLint bits, stencil_bits;
    };
    constexpr DepthFormat kFormats[] = {{GL_DEPTH_COMPONENT16, 16, 0},
                                        {GL_DEPTH_COMPONENT24, 24, 0},
                                        {GL_DEPTH_COMPONENT32, 32, 0},
                                        {GL_DEPTH24_STENCIL8, 24, 8}};
    for (const DepthFormat& f : kFormats) {
        for (const ImageKind& kind : kKinds) {
            if (kind.dimensions == 3 || kind.target == GL_TEXTURE_CUBE_MAP)
                continue;  // no depth textures there
            std::vector<GLuint> given(size_of(kind).texels()), before(given.size()), after(given.size());
            for (std::size_t i = 0; i < given.size(); ++i) given[i] = static_cast<GLuint>(i * 2654435761u);
            const bool packed = f.stencil_bits != 0;
            const GLenum format = packed ? GL_DEPTH_STENCIL : GL_DEPTH_COMPONENT,
                         type = packed ? GL_UNSIGNED_INT_24_8 : GL_UNSIGNED_INT;
            specify(kind, f.format, format, type, given.data());
            glGetTexImage(kind.image, kind.level, format, type, before.data());
            glBindFramebuffer(GL_FRAMEBUFFER, 1);
            glDrawBuffer(GL_NONE);
            glReadBuffer(GL_NONE);
            attach(kind, GL_DEPTH_ATTACHMENT);
            if (packed) attach(kind, GL_STENCIL_ATTACHMENT);
            EXPECT_EQ(get(GL_DEPTH_BITS), f.bits) << kind.name;
            EXPECT_EQ(get(GL_STENCIL_BITS), f.stencil_bits) << kind.name;
            EXPECT_EQ(attachment(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE), f.bits);
            for (const GLenum bits : {GL_RED_BITS, GL_GREEN_BITS, GL_BLUE_BITS, GL_ALPHA_BITS})
                EXPECT_EQ(get(bits), 0) << "there is no colour";
            glClearDepth(1);
            glClearStencil(0xff);
            glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
            GLfloat depth = 0;
            glReadPixels(2, 0, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
            EXPECT_EQ(depth, 1) << kind.name;
            glBindFramebuffer(GL_FRAMEBUFFER, 0);
            glGetTexImage(kind.image, kind.level, format, type, after.data());
            for (std::size_t i = 0; i < after.size(); ++i)
                ASSERT_EQ(after[i], is_drawn(kind, i) ? 0xffffffffu : before[i])
                    << kind.name << " " << f.bits << " bits, texel " << i;
            leave();
        }
    }
}

// Nothing is drawn before the queries: they are the attachments', not the window's or those of before.
TEST_F(AttachedImagesTest, QueriesFollowTheAttachmentsAtOnce) {
    const auto expect_bits = [&](std::array<GLint, 6> expected, const char* what) {
        constexpr GLenum kNames[] = {GL_RED_BITS,   GL_GREEN_BITS, GL_BLUE_BITS,
                                     GL_ALPHA_BITS, GL_DEPTH_BITS, GL_STENCIL_BITS};
        for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(get(kNames[i]), expected[i]) << what << " " << i;
        EXPECT_EQ(get(GL_DOUBLEBUFFER), 0);
        EXPECT_EQ(get(GL_STEREO), 0);
    };
    const auto renderbuffer = [&](GLuint name, GLenum format, GLenum point, GLsizei samples) {
        glBindRenderbuffer(GL_RENDERBUFFER, name);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, 8, 8);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, name);
    };
    expect_bits({8, 8, 8, 8, 24, 8}, "window");
    glBindFramebuffer(GL_FRAMEBUFFER, 1);
    expect_bits({0, 0, 0, 0, 0, 0}, "nothing attached");
    renderbuffer(1, GL_RGB, GL_COLOR_ATTACHMENT0, 0);
    expect_bits({8, 8, 8, 0, 0, 0}, "RGB");
    renderbuffer(2, GL_DEPTH_COMPONENT16, GL_DEPTH_ATTACHMENT, 0);
    expect_bits({8, 8, 8, 0, 16, 0}, "16 bits of depth");
    renderbuffer(2, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT, 0);
    expect_bits({8, 8, 8, 0, 24, 8}, "depth and stencil");
    EXPECT_EQ(get(GL_SAMPLES), 0);
    renderbuffer(1, GL_RGBA16, GL_COLOR_ATTACHMENT0, 4);
    expect_bits({0, 0, 0, 0, 0, 0}, "samples that do not agree");
    renderbuffer(2, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT, 4);
    expect_bits({16, 16, 16, 16, 24, 8}, "multisampled");
    EXPECT_EQ(get(GL_SAMPLES), 4);
    EXPECT_EQ(get(GL_SAMPLE_BUFFERS), 1);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, 0);
    expect_bits({0, 0, 0, 0, 24, 8}, "no colour");
    EXPECT_EQ(get(GL_DRAW_BUFFER), GL_COLOR_ATTACHMENT0);
    EXPECT_EQ(get(GL_READ_BUFFER), GL_COLOR_ATTACHMENT0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    expect_bits({8, 8, 8, 8, 24, 8}, "window again");
    EXPECT_EQ(get(GL_SAMPLES), 0);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

}  // namespace
}  // namespace terrazzo::gl
