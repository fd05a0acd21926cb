// Frame buffer objects: what shows in textures when they are left, changed or deleted; windows in the
// meantime.
#include <gtest/gtest.h>

#include <array>

#include "attach_picture.h"
#include "gl/framebuffer_object.h"
#include "gl/generated/commands.h"
#include "gl_fixture.h"

namespace terrazzo::gl {
namespace {

constexpr int kSize = 8;

class FramebufferObjectsTest : public GlTest {
  protected:
    FramebufferObjectsTest() {
        attach_picture(ctx(), kSize, kSize);
        gen_textures(ctx(), 1, &m_texture);
        bind_texture(ctx(), GL_TEXTURE_2D, m_texture);
        specify();
        bind_framebuffer(ctx(), GL_FRAMEBUFFER, 5);
        framebuffer_texture_2d(ctx(), GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_texture, 0);
        EXPECT_EQ(check_framebuffer_status(ctx(), GL_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_COMPLETE});
    }

    void specify() {
        const std::array<GLubyte, 4 * kSize * kSize> black{};
        tex_image_2d(ctx(), GL_TEXTURE_2D, 0, GL_RGBA, kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     black.data());
    }

    void fill(GLfloat red) {
        clear_color(ctx(), red, 0, 0, 1);
        clear(ctx(), GL_COLOR_BUFFER_BIT);
    }

    int red_of_texture() {
        std::array<GLubyte, 4 * kSize * kSize> texels{};
        get_tex_image(ctx(), GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
        return texels[0];
    }

    int red_of_pixel() {
        GLubyte rgba[4] = {};
        read_pixels(ctx(), 1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
        EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
        return rgba[0];
    }

    GLuint m_texture = 0;
};

TEST_F(FramebufferObjectsTest, TexturesShowWhatWasDrawnWhenTheObjectIsLeft) {
    fill(1);
    EXPECT_EQ(red_of_pixel(), 255);
    bind_framebuffer(ctx(), GL_FRAMEBUFFER, 0);
    EXPECT_EQ(red_of_texture(), 255);
    EXPECT_EQ(red_of_pixel(), 0) << "the window is another buffer";
    bind_framebuffer(ctx(), GL_FRAMEBUFFER, 5);
    EXPECT_EQ(red_of_pixel(), 255);
}

TEST_F(FramebufferObjectsTest, HaveNoAccumulationBuffer) {
    const auto red_bits = [&] {
        GLint bits = -1;
        get_integerv(ctx(), GL_ACCUM_RED_BITS, &bits);
        return bits;
    };
    ctx().config.accum_bits = 16;
    EXPECT_EQ(red_bits(), 0);
    bind_framebuffer(ctx(), GL_FRAMEBUFFER, 0);
    EXPECT_EQ(red_bits(), 16);
}

TEST_F(FramebufferObjectsTest, FlushDoesNotLoseWhatTexturesShow) {
    fill(1);
    flush(ctx());
    finish(ctx());
    bind_framebuffer(ctx(), GL_FRAMEBUFFER, 0);
    EXPECT_EQ(red_of_texture(), 255);
}

TEST_F(FramebufferObjectsTest, NewTexelsAreDrawnOver) {
    fill(1);
    bind_framebuffer(ctx(), GL_FRAMEBUFFER, 0);
    specify();
    bind_framebuffer(ctx(), GL_FRAMEBUFFER, 5);
    EXPECT_EQ(red_of_pixel(), 0);
}

TEST_F(FramebufferObjectsTest, TexturesThatAreDrawnToTakeAndGiveTexels) {
    fill(1);
    EXPECT_EQ(red_of_texture(), 255);
    const std::array<GLubyte, 4> texel = {64, 0, 0, 255};
    fill(0.5F);
    tex_sub_image_2d(ctx(), GL_TEXTURE_2D, 0, 1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, texel.data());
    EXPECT_EQ(red_of_pixel(), 64);
    EXPECT_EQ(red_of_texture(), 128) << "beside it";
    fill(1);
    copy_tex_sub_image_2d(ctx(), GL_TEXTURE_2D, 0, 1, 1, 0, 0, 1, 1);
    EXPECT_EQ(red_of_pixel(), 255);
    EXPECT_EQ(red_of_texture(), 255);
}

// GL 1.5 §3.6.4: a centre on the border of two zoomed pixels belongs to the upper and the right one.
TEST_F(FramebufferObjectsTest, ZoomedRectanglesFollowTheRule) {
    const std::array<GLubyte, 4 * 4> reds = {10, 0, 0, 255, 20, 0, 0, 255, 30, 0, 0, 255, 40, 0, 0, 255};
    const auto row_of_reds = [&](GLfloat corner, GLfloat zoom) {
        fill(0);
        window_pos3f(ctx(), corner, 0, 0);
        pixel_zoom(ctx(), zoom, 1);
        draw_pixels(ctx(), 4, 1, GL_RGBA, GL_UNSIGNED_BYTE, reds.data());
        std::array<GLubyte, 4 * kSize> row{};
        read_pixels(ctx(), 0, 0, kSize, 1, GL_RGBA, GL_UNSIGNED_BYTE, row.data());
        std::array<int, kSize> out{};
        for (std::size_t x = 0; x < kSize; ++x) out[x] = row[4 * x];
        return out;
    };
    EXPECT_EQ(row_of_reds(1, 1.5F), (std::array{0, 10, 20, 20, 30, 40, 40, 0}));
    EXPECT_EQ(row_of_reds(7, -1.5F), (std::array{0, 40, 30, 30, 20, 10, 10, 0}));
    EXPECT_EQ(row_of_reds(2, 0.5F), (std::array{0, 0, 20, 40, 0, 0, 0, 0}));
}

TEST_F(FramebufferObjectsTest, DeletedTexturesAndObjectsLeave) {
    fill(1);
    delete_textures(ctx(), 1, &m_texture);
    EXPECT_EQ(check_framebuffer_status(ctx(), GL_FRAMEBUFFER),
              GLenum{GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT});
    fill(0);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_FRAMEBUFFER_OPERATION});
    const GLuint name = 5;
    delete_framebuffers(ctx(), 1, &name);
    fill(0.5f);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
    EXPECT_EQ(red_of_pixel(), 128);
}

TEST_F(FramebufferObjectsTest, ObjectsShareRenderbuffers) {
    GLuint names[2];
    gen_renderbuffers(ctx(), 2, names);
    bind_renderbuffer(ctx(), GL_RENDERBUFFER, names[0]);
    renderbuffer_storage(ctx(), GL_RENDERBUFFER, GL_RGBA8, kSize, kSize);
    for (GLuint object : {7u, 8u}) {
        bind_framebuffer(ctx(), GL_FRAMEBUFFER, object);
        framebuffer_renderbuffer(ctx(), GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, names[0]);
    }
    fill(1);
    bind_framebuffer(ctx(), GL_FRAMEBUFFER, 7);
    EXPECT_EQ(red_of_pixel(), 255);
    // New storage while it is attached; then another size beside it.
    renderbuffer_storage(ctx(), GL_RENDERBUFFER, GL_RGBA8, kSize, kSize);
    EXPECT_EQ(red_of_pixel(), 0);
    bind_renderbuffer(ctx(), GL_RENDERBUFFER, names[1]);
    renderbuffer_storage(ctx(), GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, kSize + 1, kSize);
    framebuffer_renderbuffer(ctx(), GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, names[1]);
    EXPECT_EQ(check_framebuffer_status(ctx(), GL_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_COMPLETE});
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
}

TEST_F(FramebufferObjectsTest, WithoutAColourBufferNoneIsTouched) {
    bind_framebuffer(ctx(), GL_FRAMEBUFFER, 9);
    bind_renderbuffer(ctx(), GL_RENDERBUFFER, 1);
    renderbuffer_storage(ctx(), GL_RENDERBUFFER, GL_DEPTH_COMPONENT16, kSize, kSize);
    framebuffer_renderbuffer(ctx(), GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, 1);
    fill(1);
    rectf(ctx(), -1, -1, 1, 1);
    finish(ctx());
    GLubyte rgba[4] = {};
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
    read_pixels(ctx(), 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
    bind_framebuffer(ctx(), GL_FRAMEBUFFER, 0);
    EXPECT_EQ(red_of_pixel(), 0);
}

// What draws by itself stops where Begin is refused: no vertices are left behind for what is drawn next.
TEST_F(FramebufferObjectsTest, NothingIsCollectedWhileTheObjectIsIncomplete) {
    const GLfloat points[] = {-1, -1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0};
    map1f(ctx(), GL_MAP1_VERTEX_3, 0, 1, 3, 2, points);
    map2f(ctx(), GL_MAP2_VERTEX_3, 0, 1, 3, 2, 0, 1, 6, 2, points);
    map_grid1f(ctx(), 4, 0, 1);
    map_grid2f(ctx(), 4, 0, 1, 4, 0, 1);
    enable(ctx(), GL_MAP1_VERTEX_3);
    enable(ctx(), GL_MAP2_VERTEX_3);
    new_list(ctx(), 1, GL_COMPILE);
    glColor3f(0, 1, 0);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 3; ++i) glVertex2f(static_cast<GLfloat>(i), 0);
    glEnd();
    end_list(ctx());
    std::array<GLuint, 64> hits{};
    select_buffer(ctx(), static_cast<GLsizei>(hits.size()), hits.data());
    const auto draws = {
        +[](Context& c) { rectf(c, -1, -1, 1, 1); },
        +[](Context& c) { eval_mesh1(c, GL_POINT, 0, 4); },
        +[](Context& c) { eval_mesh1(c, GL_LINE, 0, 4); },
        +[](Context& c) { eval_mesh2(c, GL_POINT, 0, 4, 0, 4); },
        +[](Context& c) { eval_mesh2(c, GL_LINE, 0, 4, 0, 4); },
        +[](Context& c) { eval_mesh2(c, GL_FILL, 0, 4, 0, 4); },
        +[](Context& c) { call_list(c, 1); },
    };
    for (const GLenum mode : {GL_RENDER, GL_SELECT}) {
        render_mode(ctx(), mode);
        int number = 0;
        for (const auto& draw : draws) {
            bind_framebuffer(ctx(), GL_FRAMEBUFFER, 0);
            for (int i = 0; i < 3; ++i) rectf(ctx(), -1, -1, 1, 1);
            finish(ctx());  // a run would begin behind these
            bind_framebuffer(ctx(), GL_FRAMEBUFFER, 6);
            draw(ctx());
            EXPECT_EQ(take_error(), GLenum{GL_INVALID_FRAMEBUFFER_OPERATION}) << number;
            EXPECT_FALSE(ctx().vertex.open) << number;
            EXPECT_EQ(ctx().vertex.batch.count, 0u) << number;
            EXPECT_TRUE(ctx().vertex.batch.runs.empty()) << number;
            ++number;
        }
        finish(ctx());
        EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
    }
    EXPECT_EQ(ctx().vertex.current.color()[1], 1) << "the list's colour";
    EXPECT_EQ(ctx().vertex.current.color()[0], 0) << "the list's colour";
}

}  // namespace
}  // namespace terrazzo::gl
