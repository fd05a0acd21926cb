// GetFramebufferAttachmentParameteriv: of the window system's frame buffer, of objects, and its errors.
#include <gtest/gtest.h>

#include <array>
#include <optional>

#include "attach_picture.h"
#include "gl/framebuffer_object.h"
#include "gl/generated/commands.h"
#include "gl_fixture.h"

namespace terrazzo::gl {
namespace {

constexpr std::array<GLenum, 6> kSizes = {
    GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE,   GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE,
    GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE,  GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE,
    GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE};

class FramebufferQueryTest : public GlTest {
  protected:
    static constexpr GLint kUntouched = -77;

    // Expects no error.
    GLint ask(GLenum attachment, GLenum pname, GLenum target = GL_FRAMEBUFFER) {
        GLint value = kUntouched;
        get_framebuffer_attachment_parameteriv(ctx(), target, attachment, pname, &value);
        EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR}) << std::hex << attachment << " " << pname;
        return value;
    }
    GLenum error(GLenum attachment, GLenum pname, GLenum target = GL_FRAMEBUFFER) {
        GLint value = kUntouched;
        get_framebuffer_attachment_parameteriv(ctx(), target, attachment, pname, &value);
        EXPECT_EQ(value, kUntouched) << "an error writes nothing";
        return take_error();
    }
    std::array<GLint, 6> sizes(GLenum attachment) {
        std::array<GLint, 6> out{};
        for (std::size_t i = 0; i < 6; ++i) out[i] = ask(attachment, kSizes[i]);
        return out;
    }
    void expect_missing(GLenum attachment) {
        SCOPED_TRACE(testing::Message() << std::hex << attachment);
        EXPECT_EQ(ask(attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE), GL_NONE);
        EXPECT_EQ(ask(attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME), 0);
        for (const GLenum pname : kSizes) EXPECT_EQ(error(attachment, pname), GLenum{GL_INVALID_OPERATION});
        for (const GLenum pname :
             {GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE,
              GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE,
              GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER})
            EXPECT_EQ(error(attachment, pname), GLenum{GL_INVALID_OPERATION});
        EXPECT_EQ(error(attachment, GL_RENDERBUFFER_WIDTH), GLenum{GL_INVALID_ENUM});
    }
    void attach_window(Buffering buffering, const raster::TargetFormat& format) {
        const auto drawable = std::make_shared<Drawable>(buffering);
        drawable->allocate(8, 8, format);
        attach_drawables(ctx(), drawable, drawable);
    }
};

TEST_F(FramebufferQueryTest, TheWindowsBuffersAreTheDefault) {
    attach_window(Buffering::kDouble, {raster::ColorFormat::kRgba8, true, 24, 8});
    for (const GLenum target : {GL_FRAMEBUFFER, GL_DRAW_FRAMEBUFFER, GL_READ_FRAMEBUFFER})
        for (const GLenum buffer : {GL_FRONT, GL_FRONT_LEFT, GL_BACK, GL_BACK_LEFT, GL_DEPTH, GL_STENCIL}) {
            EXPECT_EQ(ask(buffer, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, target), GL_FRAMEBUFFER_DEFAULT);
            EXPECT_EQ(ask(buffer, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, target), 0);
        }
    EXPECT_EQ(sizes(GL_BACK_LEFT), (std::array{8, 8, 8, 8, 0, 0}));
    EXPECT_EQ(sizes(GL_DEPTH), (std::array{0, 0, 0, 0, 24, 0}));
    EXPECT_EQ(sizes(GL_STENCIL), (std::array{0, 0, 0, 0, 0, 8}));
    EXPECT_EQ(ask(GL_BACK, GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING), GL_LINEAR);
    EXPECT_EQ(ask(GL_BACK, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE), GL_UNSIGNED_NORMALIZED);
    EXPECT_EQ(ask(GL_DEPTH, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE), GL_UNSIGNED_NORMALIZED);
    EXPECT_EQ(ask(GL_STENCIL, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE), GL_INDEX);
    expect_missing(GL_FRONT_RIGHT);
    expect_missing(GL_BACK_RIGHT);
    EXPECT_EQ(error(GL_BACK, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL), GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(error(GL_BACK, GL_RENDERBUFFER_WIDTH), GLenum{GL_INVALID_ENUM});
    for (const GLenum other : {GL_AUX0, GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT,
                               GL_DEPTH_STENCIL_ATTACHMENT, GL_NONE})
        EXPECT_EQ(error(other, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE), GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(error(GL_BACK, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, GL_RENDERBUFFER),
              GLenum{GL_INVALID_ENUM});
}

TEST_F(FramebufferQueryTest, OtherWindowsSayWhatTheyLack) {
    expect_missing(GL_FRONT);  // no window at all
    attach_window(Buffering::kSingle, {raster::ColorFormat::kRgb565, false, 0, 0});
    EXPECT_EQ(sizes(GL_FRONT), (std::array{5, 6, 5, 0, 0, 0}));
    expect_missing(GL_BACK);
    expect_missing(GL_DEPTH);
    expect_missing(GL_STENCIL);
    attach_window(Buffering::kSingleByEitherName, {raster::ColorFormat::kRgba32F, true, 16, 0});
    EXPECT_EQ(sizes(GL_BACK), (std::array{32, 32, 32, 32, 0, 0}));
    EXPECT_EQ(ask(GL_FRONT, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE), GL_FLOAT);
    EXPECT_EQ(ask(GL_DEPTH, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE), 16);
}

TEST_F(FramebufferQueryTest, DrawnAndReadWindowsAreAskedApart) {
    const auto draw = std::make_shared<Drawable>(Buffering::kDouble),
               read = std::make_shared<Drawable>(Buffering::kSingle);
    draw->allocate(8, 8, {raster::ColorFormat::kRgba8, true, 24, 8});
    read->allocate(8, 8, {raster::ColorFormat::kRgba8, true, 16, 0});
    attach_drawables(ctx(), draw, read);
    const auto depth = [&](GLenum target) {
        return ask(GL_DEPTH, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, target);
    };
    EXPECT_EQ(depth(GL_FRAMEBUFFER), 24);
    EXPECT_EQ(depth(GL_DRAW_FRAMEBUFFER), 24);
    EXPECT_EQ(depth(GL_READ_FRAMEBUFFER), 16);
    bind_framebuffer(ctx(), GL_DRAW_FRAMEBUFFER, 3);
    EXPECT_EQ(error(GL_DEPTH, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE), GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(depth(GL_READ_FRAMEBUFFER), 16) << "the window is still read from";
}

TEST_F(FramebufferQueryTest, OfAnObject) {
    GLuint texture = 0, buffer = 0;
    gen_textures(ctx(), 1, &texture);
    bind_texture(ctx(), GL_TEXTURE_2D, texture);
    tex_image_2d(ctx(), GL_TEXTURE_2D, 0, GL_RGB8, 8, 8, 0, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
    gen_renderbuffers(ctx(), 1, &buffer);
    bind_renderbuffer(ctx(), GL_RENDERBUFFER, buffer);
    renderbuffer_storage(ctx(), GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, 8, 8);
    bind_framebuffer(ctx(), GL_FRAMEBUFFER, 5);
    expect_missing(GL_COLOR_ATTACHMENT0);
    expect_missing(GL_DEPTH_STENCIL_ATTACHMENT);
    framebuffer_texture_2d(ctx(), GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    framebuffer_renderbuffer(ctx(), GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, buffer);
    EXPECT_EQ(ask(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE), GL_TEXTURE);
    EXPECT_EQ(ask(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME), static_cast<GLint>(texture));
    EXPECT_EQ(sizes(GL_COLOR_ATTACHMENT0), (std::array{8, 8, 8, 0, 0, 0}));
    EXPECT_EQ(ask(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL), 0);
    for (const GLenum point : {GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT, GL_DEPTH_STENCIL_ATTACHMENT}) {
        EXPECT_EQ(ask(point, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE), GL_RENDERBUFFER);
        EXPECT_EQ(sizes(point), (std::array{0, 0, 0, 0, 24, 8}));
        EXPECT_EQ(error(point, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL), GLenum{GL_INVALID_ENUM});
    }
    EXPECT_EQ(error(GL_DEPTH_STENCIL_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE),
              GLenum{GL_INVALID_OPERATION});
    framebuffer_renderbuffer(ctx(), GL_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, GL_RENDERBUFFER, 0);
    EXPECT_EQ(error(GL_DEPTH_STENCIL_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE),
              GLenum{GL_INVALID_OPERATION});
    EXPECT_EQ(error(GL_COLOR_ATTACHMENT0 + 1, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE),
              GLenum{GL_INVALID_OPERATION});
    EXPECT_EQ(error(GL_BACK, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE), GLenum{GL_INVALID_ENUM});
}

// A texture with depth and stencil attached by one call or by two.
TEST_F(FramebufferQueryTest, OneImageIsDepthAndStencilByBothRoutes) {
    attach_picture(ctx(), 8, 8);
    GLuint object = 5;
    for (const GLenum target : {GL_TEXTURE_2D, GL_TEXTURE_CUBE_MAP})
        for (const GLint format : {GL_DEPTH_STENCIL, GL_DEPTH24_STENCIL8}) {
            const bool is_cube = target == GL_TEXTURE_CUBE_MAP;
            const GLenum face = is_cube ? GL_TEXTURE_CUBE_MAP_NEGATIVE_Y : target;
            GLuint texture = 0;
            gen_textures(ctx(), 1, &texture);
            bind_texture(ctx(), target, texture);
            for (GLenum i = 0; i < (is_cube ? 6u : 1u); ++i)
                tex_image_2d(ctx(), is_cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + i : target, 0, format, 8, 8, 0,
                             GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, nullptr);
            ASSERT_EQ(take_error(), GLenum{GL_NO_ERROR});
            for (const bool together : {true, false}) {
                bind_framebuffer(ctx(), GL_FRAMEBUFFER, object++);
                if (together) {
                    framebuffer_texture_2d(ctx(), GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, face, texture,
                                           0);
                } else {
                    for (const GLenum point : {GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT})
                        framebuffer_texture_2d(ctx(), GL_FRAMEBUFFER, point, face, texture, 0);
                }
                for (const GLenum point :
                     {GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT, GL_DEPTH_STENCIL_ATTACHMENT}) {
                    EXPECT_EQ(ask(point, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE), GL_TEXTURE);
                    EXPECT_EQ(ask(point, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME), static_cast<GLint>(texture));
                    EXPECT_EQ(ask(point, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE),
                              is_cube ? static_cast<GLint>(face) : 0);
                    EXPECT_EQ(sizes(point), (std::array{0, 0, 0, 0, 24, 8}));
                }
                EXPECT_EQ(check_framebuffer_status(ctx(), GL_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_COMPLETE});
                draw_buffer(ctx(), GL_NONE);
                clear_depth(ctx(), 0.5);
                clear_stencil(ctx(), 7);
                clear(ctx(), GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
            }
            bind_framebuffer(ctx(), GL_FRAMEBUFFER, 0);
            GLuint texels[64] = {};
            get_tex_image(ctx(), face, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, texels);
            EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
            EXPECT_NEAR(texels[9] >> 8, 0x7fffff, 1);
            EXPECT_EQ(texels[9] & 0xff, 7u);
        }
}

}  // namespace
}  // namespace terrazzo::gl
