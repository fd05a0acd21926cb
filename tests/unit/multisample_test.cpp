// Multisampled windows and objects: what is read back of them, what belongs to samples and what to pixels,
// and the rules in which the reference differs from GL 1.5.
#include <gtest/gtest.h>

#include <array>

#include "attach_picture.h"
#include "gl/framebuffer_object.h"
#include "gl/generated/commands.h"
#include "gl_fixture.h"

namespace terrazzo::gl {
namespace {

constexpr int kSize = 16;

raster::TargetFormat four_samples(raster::ColorFormat color = raster::ColorFormat::kRgba8) {
    raster::TargetFormat format;
    format.color = color;
    format.samples = 4;
    return format;
}

class MultisampleTest : public GlTest {
  protected:
    MultisampleTest() { attach(four_samples()); }

    void attach(const raster::TargetFormat& format) {
        attach_picture(ctx(), kSize, kSize, format);
        matrix_mode(ctx(), GL_PROJECTION);
        load_identity(ctx());
        ortho(ctx(), 0, kSize, 0, kSize, -1, 1);
        clear(ctx(), GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }

    // A rectangle of one colour.
    void fill(float red, float x0, float x1, float z = 0, float alpha = 1) {
        glColor4f(red, 0, 0, alpha);
        glBegin(GL_QUADS);
        glVertex3f(x0, 0, z);
        glVertex3f(x1, 0, z);
        glVertex3f(x1, kSize, z);
        glVertex3f(x0, kSize, z);
        glEnd();
    }

    int red(int x, int y = 5) {
        GLubyte rgba[4] = {};
        read_pixels(ctx(), x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
        EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
        return rgba[0];
    }
};

TEST_F(MultisampleTest, PixelsAreTheMeansOfTheirSamples) {
    GLint samples = 0;
    get_integerv(ctx(), GL_SAMPLES, &samples);
    EXPECT_EQ(samples, 4);
    fill(1, 3.5f, 8.2f);  // of pixel 3 the samples at .875 and .625, of pixel 8 the one at .125
    EXPECT_EQ(red(2), 0);
    EXPECT_EQ(red(3), 128);
    EXPECT_EQ(red(4), 255);
    EXPECT_EQ(red(8), 64);
    EXPECT_EQ(red(9), 0);
}

TEST_F(MultisampleTest, EveryWayOfReadingResolves) {
    fill(1, 3.5f, 8);
    std::array<GLubyte, 4 * kSize> row{};
    read_pixels(ctx(), 0, 7, kSize, 1, GL_RGBA, GL_UNSIGNED_BYTE, row.data());
    EXPECT_EQ(row[4 * 3], 128);
    GLfloat one[4];
    read_pixels(ctx(), 3, 7, 1, 1, GL_RGBA, GL_FLOAT, one);
    EXPECT_NEAR(one[0], 0.5, 0.51 / 255);
    GLuint texture;
    gen_textures(ctx(), 1, &texture);
    bind_texture(ctx(), GL_TEXTURE_2D, texture);
    copy_tex_image_2d(ctx(), GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, kSize, kSize, 0);
    std::array<GLubyte, 4 * kSize * kSize> texels{};
    get_tex_image(ctx(), GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    EXPECT_EQ(texels[4 * (5 * kSize + 3)], 128);
    raster_pos4f(ctx(), 8, 0, 0, 1);
    copy_pixels(ctx(), 0, 0, 8, kSize, GL_COLOR);
    EXPECT_EQ(red(11), 128);
    EXPECT_EQ(red(12), 255);
}

TEST_F(MultisampleTest, DrawnPixelRectanglesHaveSamplesLikeOthers) {
    const std::array<GLubyte, 4 * kSize* kSize> white = [] {
        std::array<GLubyte, 4 * kSize * kSize> texels{};
        texels.fill(255);
        return texels;
    }();
    enable(ctx(), GL_SAMPLE_COVERAGE);
    sample_coverage(ctx(), 0.25f, false);
    raster_pos4f(ctx(), 0, 0, 0, 1);
    draw_pixels(ctx(), kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
    EXPECT_EQ(red(3), 64);
    sample_coverage(ctx(), 0.25f, true);
    draw_pixels(ctx(), kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
    EXPECT_EQ(red(3), 255);
}

TEST_F(MultisampleTest, AlphaBecomesOneBeforeItIsTested) {
    enable(ctx(), GL_SAMPLE_ALPHA_TO_ONE);
    enable(ctx(), GL_ALPHA_TEST);
    alpha_func(ctx(), GL_GREATER, 0.5f);
    fill(1, 0, kSize, 0, 0.25f);
    EXPECT_EQ(red(3), 255);
    disable(ctx(), GL_SAMPLE_ALPHA_TO_ONE);
    fill(0.5f, 0, kSize, 0, 0.25f);
    EXPECT_EQ(red(3), 255);
    disable(ctx(), GL_ALPHA_TEST);
    enable(ctx(), GL_SAMPLE_ALPHA_TO_COVERAGE);
    fill(0, 0, kSize, 0, 0.5f);
    EXPECT_EQ(red(3), 128);
}

TEST_F(MultisampleTest, WithoutMultisamplingAllSamplesGetTheDepth) {
    enable(ctx(), GL_DEPTH_TEST);
    fill(1, 3.5f, 8, 0.5f);  // half of pixel 3
    disable(ctx(), GL_MULTISAMPLE);
    fill(0.5f, 0, kSize, 0.75f);
    EXPECT_EQ(red(3), 128);
    enable(ctx(), GL_MULTISAMPLE);
    fill(0, 0, kSize, 0.6f);  // behind all of it
    EXPECT_EQ(red(3), 128);
    EXPECT_EQ(red(5), 128);
}

TEST_F(MultisampleTest, StateChangesBetweenQueuedDraws) {
    enable(ctx(), GL_SAMPLE_COVERAGE);
    sample_coverage(ctx(), 0.5f, false);
    fill(1, 0, 4);
    sample_coverage(ctx(), 1, false);
    fill(1, 4, 8);
    disable(ctx(), GL_MULTISAMPLE);
    fill(1, 8.6f, 12);  // the centre of pixel 8 is outside
    EXPECT_EQ(red(2), 128);
    EXPECT_EQ(red(5), 255);
    EXPECT_EQ(red(8), 0);
    EXPECT_EQ(red(9), 255);
}

TEST_F(MultisampleTest, PartialClearsReachAllSamples) {
    fill(1, 3.5f, 8);
    enable(ctx(), GL_SCISSOR_TEST);
    scissor(ctx(), 3, 4, 2, 4);
    clear_color(ctx(), 0.2f, 0, 0, 1);
    clear(ctx(), GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(red(3, 5), 51);
    EXPECT_EQ(red(4, 5), 51);
    EXPECT_EQ(red(3, 9), 128);
    color_mask(ctx(), false, true, true, true);
    scissor(ctx(), 0, 0, kSize, kSize);
    clear(ctx(), GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(red(3, 9), 128);
}

TEST_F(MultisampleTest, OtherFormatsResolveToo) {
    for (const raster::ColorFormat format :
         {raster::ColorFormat::kRgb565, raster::ColorFormat::kRgba16, raster::ColorFormat::kRgba32F}) {
        attach(four_samples(format));
        fill(1, 3.5f, 8);
        EXPECT_NEAR(red(3), 127.5, format == raster::ColorFormat::kRgb565 ? 5 : 1);
        EXPECT_EQ(red(4), 255);
    }
}

TEST_F(MultisampleTest, AccumulationReadsMeansAndReturnsThemToAllSamples) {
    const std::unique_ptr<Context> other = create_context(Config{.accum_bits = 16}, nullptr);
    make_current(other.get());
    attach_picture(*other, kSize, kSize, four_samples());
    Context& c = *other;
    clear_color(c, 1, 0, 0, 1);
    enable(c, GL_SCISSOR_TEST);
    scissor(c, 0, 0, 8, kSize);
    clear(c, GL_COLOR_BUFFER_BIT);
    disable(c, GL_SCISSOR_TEST);
    accum(c, GL_LOAD, 0.5f);
    accum(c, GL_RETURN, 1);
    GLubyte rgba[4] = {};
    read_pixels(c, 3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    EXPECT_NEAR(rgba[0], 127.5, 1);
    make_current(&ctx());
}

TEST_F(MultisampleTest, RenderbuffersOfSeveralSamples) {
    bind_renderbuffer(ctx(), GL_RENDERBUFFER, 7);
    renderbuffer_storage_multisample(ctx(), GL_RENDERBUFFER, 5, GL_RGBA8, kSize, kSize);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_VALUE});
    renderbuffer_storage_multisample(ctx(), GL_RENDERBUFFER, 2, GL_RGBA8, kSize, kSize);
    GLint samples = 0;
    get_renderbuffer_parameteriv(ctx(), GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &samples);
    EXPECT_EQ(samples, 4);
    bind_framebuffer(ctx(), GL_FRAMEBUFFER, 3);
    framebuffer_renderbuffer(ctx(), GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, 7);
    bind_renderbuffer(ctx(), GL_RENDERBUFFER, 8);
    renderbuffer_storage(ctx(), GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, kSize, kSize);
    framebuffer_renderbuffer(ctx(), GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, 8);
    EXPECT_EQ(check_framebuffer_status(ctx(), GL_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE});
    renderbuffer_storage_multisample(ctx(), GL_RENDERBUFFER, 4, GL_DEPTH_COMPONENT24, kSize, kSize);
    EXPECT_EQ(check_framebuffer_status(ctx(), GL_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_COMPLETE});
    GLubyte rgba[4];
    read_pixels(ctx(), 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
}

// Of windows every read resolves; of multisampled objects none does (ARB_framebuffer_object: ReadPixels,
// CopyPixels and copies to textures are GL_INVALID_OPERATION), a blit alone.
TEST_F(MultisampleTest, PixelsOfObjectsAreReadByBlitsAlone) {
    bind_renderbuffer(ctx(), GL_RENDERBUFFER, 7);
    renderbuffer_storage_multisample(ctx(), GL_RENDERBUFFER, 4, GL_RGBA8, kSize, kSize);
    bind_renderbuffer(ctx(), GL_RENDERBUFFER, 8);
    renderbuffer_storage_multisample(ctx(), GL_RENDERBUFFER, 4, GL_DEPTH24_STENCIL8, kSize, kSize);
    bind_framebuffer(ctx(), GL_FRAMEBUFFER, 3);
    framebuffer_renderbuffer(ctx(), GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, 7);
    framebuffer_renderbuffer(ctx(), GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, 8);
    clear(ctx(), GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    fill(1, 3.5f, 8);
    const auto refused = [&](const char* what, auto call) {
        call();
        EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION}) << what;
    };
    std::array<GLuint, 4> memory{5, 5, 5, 5};
    const auto read = [&](GLenum format, GLenum type) {
        refused("ReadPixels", [&] { read_pixels(ctx(), 4, 4, 1, 1, format, type, memory.data()); });
    };
    read(GL_RGBA, GL_UNSIGNED_BYTE);
    read(GL_RGBA, GL_FLOAT);
    read(GL_DEPTH_COMPONENT, GL_UNSIGNED_INT);
    read(GL_STENCIL_INDEX, GL_UNSIGNED_INT);
    read(GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8);
    EXPECT_EQ(memory, (std::array<GLuint, 4>{5, 5, 5, 5}));
    raster_pos4f(ctx(), 0, 0, 0, 1);
    for (const GLenum type : {GL_COLOR, GL_DEPTH, GL_STENCIL})
        refused("CopyPixels", [&] { copy_pixels(ctx(), 4, 4, 1, 1, type); });
    for (const GLenum format : {GL_RGBA, GL_RGB, GL_DEPTH_COMPONENT})
        refused("CopyTexImage", [&] { copy_tex_image_2d(ctx(), GL_TEXTURE_2D, 0, format, 0, 0, 8, 8, 0); });
    tex_image_2d(ctx(), GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    refused("CopyTexSubImage", [&] { copy_tex_sub_image_2d(ctx(), GL_TEXTURE_2D, 0, 0, 0, 0, 0, 8, 8); });
    bind_framebuffer(ctx(), GL_DRAW_FRAMEBUFFER, 0);
    blit_framebuffer(ctx(), 0, 0, kSize, kSize, 0, 0, kSize, kSize, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    bind_framebuffer(ctx(), GL_READ_FRAMEBUFFER, 0);
    EXPECT_EQ(red(3), 128);
    EXPECT_EQ(red(4), 255);
}

TEST_F(MultisampleTest, CopiesToTexturesResolve) {
    fill(1, 3.5f, 8);
    const auto texel = [&](int x) {
        std::array<GLubyte, 4 * kSize * kSize> texels{};
        get_tex_image(ctx(), GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
        return int{texels[static_cast<std::size_t>(4 * (5 * kSize + x))]};
    };
    for (const GLenum format : {GL_RGBA, GL_RGB, GL_LUMINANCE, GL_INTENSITY, GL_RGB5_A1}) {
        copy_tex_image_2d(ctx(), GL_TEXTURE_2D, 0, format, 0, 0, kSize, kSize, 0);
        EXPECT_EQ(texel(2), 0) << format;
        EXPECT_NEAR(texel(3), 128, format == GL_RGB5_A1 ? 4 : 0) << format;
        EXPECT_EQ(texel(4), 255) << format;
    }
    tex_image_2d(ctx(), GL_TEXTURE_2D, 0, GL_RGBA, kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    copy_tex_sub_image_2d(ctx(), GL_TEXTURE_2D, 0, 1, 0, 0, 0, kSize - 1, kSize);
    EXPECT_EQ(texel(4), 128);
    EXPECT_EQ(texel(5), 255);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
}

// GL 1.5 §4.3.2 leaves open which of the samples' depths and stencil values: the first one's, as in the
// reference.
TEST_F(MultisampleTest, DepthAndStencilOfWindowsAreRead) {
    enable(ctx(), GL_DEPTH_TEST);
    enable(ctx(), GL_STENCIL_TEST);
    stencil_func(ctx(), GL_ALWAYS, 9, ~0u);
    stencil_op(ctx(), GL_KEEP, GL_KEEP, GL_REPLACE);
    fill(1, 4, 8, 0.5f);
    const auto depth = [&](int x) {
        GLfloat value = 0;
        read_pixels(ctx(), x, 5, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &value);
        return value;
    };
    const auto stencil = [&](int x) {
        GLubyte value = 0;
        read_pixels(ctx(), x, 5, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &value);
        return int{value};
    };
    EXPECT_NEAR(depth(5), 0.25, 1e-6);
    EXPECT_EQ(depth(9), 1);
    EXPECT_EQ(stencil(5), 9);
    EXPECT_EQ(stencil(9), 0);
    copy_tex_image_2d(ctx(), GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 0, 0, kSize, kSize, 0);
    std::array<GLfloat, kSize * kSize> texels{};
    get_tex_image(ctx(), GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, texels.data());
    EXPECT_NEAR(texels[5 * kSize + 5], 0.25, 1e-6);
    EXPECT_EQ(texels[5 * kSize + 9], 1);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
}

// Objects take part of their attachments, or planes that another object has drawn to: marks of tiles that are
// alike go with the planes.
TEST_F(MultisampleTest, RenderbuffersKeepTheirSamplesBetweenObjects) {
    bind_renderbuffer(ctx(), GL_RENDERBUFFER, 7);
    renderbuffer_storage_multisample(ctx(), GL_RENDERBUFFER, 4, GL_RGBA8, kSize, kSize);
    for (const GLuint object : {3u, 4u}) {
        bind_framebuffer(ctx(), GL_FRAMEBUFFER, object);
        framebuffer_renderbuffer(ctx(), GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, 7);
    }
    bind_framebuffer(ctx(), GL_FRAMEBUFFER, 3);
    clear(ctx(), GL_COLOR_BUFFER_BIT);
    fill(1, 3.5f, 8);
    bind_framebuffer(ctx(), GL_FRAMEBUFFER, 4);
    enable(ctx(), GL_BLEND);
    blend_func(ctx(), GL_ONE, GL_ONE);
    fill(0.25f, 0, kSize);
    disable(ctx(), GL_BLEND);
    bind_framebuffer(ctx(), GL_DRAW_FRAMEBUFFER, 0);
    blit_framebuffer(ctx(), 0, 0, kSize, kSize, 0, 0, kSize, kSize, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    bind_framebuffer(ctx(), GL_READ_FRAMEBUFFER, 0);
    EXPECT_EQ(red(2), 64);
    EXPECT_NEAR(red(3), 159.5, 1);  // two samples of 255 and two of 64
    EXPECT_EQ(red(4), 255);
}

}  // namespace
}  // namespace terrazzo::gl
