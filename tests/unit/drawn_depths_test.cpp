// Depth textures that were drawn to: what is sampled, read and copied is what was drawn last, whatever
// happened to the texture, its attachments and their contexts in between, and it is the same as of a texture
// whose texels were given in rows.
#define GL_GLEXT_PROTOTYPES
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <random>
#include <vector>

#include "attach_picture.h"
#include "gl/generated/commands.h"
#include "gl_fixture.h"

namespace terrazzo::gl {
namespace {

// Three bins across and two up, none of the last ones whole.
constexpr int kWidth = 150, kHeight = 100;

struct Box {
    int x = 0, y = 0, width = kWidth, height = kHeight;
};

// Depths in steps of 255ths, which eight bits show as they are.
using Steps = std::vector<int>;

void fill(Steps& map, const Box& box, int step) {
    for (int y = box.y; y < box.y + box.height; ++y)
        std::fill_n(map.begin() + y * kWidth + box.x, box.width, step);
}

GLfloat depth_of(int step) {
    return static_cast<GLfloat>(step) / 255;
}

void draw_quad(GLfloat z, GLfloat s = 1, GLfloat t = 1) {
    const GLfloat corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    glBegin(GL_QUADS);
    for (const auto& corner : corners) {
        glTexCoord3f(s * corner[0], t * corner[1], corner[0]);
        glVertex3f(2 * corner[0] - 1, 2 * corner[1] - 1, 2 * z - 1);
    }
    glEnd();
}

void use_box(const Box& box) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(box.x, box.y, box.width, box.height);
}

void clear_depths(const Box& box, int step) {
    use_box(box);
    glClearDepth(static_cast<GLdouble>(step) / 255);
    glClear(GL_DEPTH_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
}

void draw_depths(const Box& box, int step, GLenum func = GL_ALWAYS) {
    use_box(box);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(func);
    draw_quad(depth_of(step));
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
}

void specify(GLuint texture, GLint format, int step = 0, int width = kWidth, int height = kHeight) {
    const std::vector<GLfloat> depths(static_cast<std::size_t>(width * height), depth_of(step));
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void attach(GLuint object, GLuint texture, GLenum point = GL_DEPTH_ATTACHMENT, GLint level = 0) {
    glBindFramebuffer(GL_FRAMEBUFFER, object);
    glFramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, texture, level);
    ASSERT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_COMPLETE});
}

Steps read_reds() {
    std::vector<GLubyte> rgba(4 * kWidth * kHeight);
    glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    Steps out(kWidth * kHeight);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = rgba[4 * i];
    return out;
}

// Draws the map to the window, texel for pixel.
void show(GLuint texture, const Box& box = {}) {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glBindTexture(GL_TEXTURE_2D, texture);
    glEnable(GL_TEXTURE_2D);
    use_box(box);
    draw_quad(0.5f);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_TEXTURE_2D);
}

Steps shown(GLuint texture) {
    show(texture);
    return read_reds();
}

Steps texels(GLuint texture) {
    std::vector<GLfloat> depths(kWidth * kHeight);
    glBindTexture(GL_TEXTURE_2D, texture);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    Steps out(depths.size());
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<int>(depths[i] * 255 + 0.5f);
    return out;
}

class DrawnDepthsTest : public GlTest {
  protected:
    DrawnDepthsTest() {
        attach_picture(ctx(), kWidth, kHeight);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    }
    ~DrawnDepthsTest() override { EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}); }
};

constexpr GLuint kMap = 1, kOther = 2;
constexpr Box kMiddle{40, 30, 70, 50};

TEST_F(DrawnDepthsTest, EachDrawingIsSeen) {
    specify(kMap, GL_DEPTH_COMPONENT24);
    Steps expected(kWidth * kHeight);
    for (int round = 1; round < 6; ++round) {
        attach(1, kMap);
        clear_depths({}, 40 * round);
        fill(expected, {}, 40 * round);
        if (round % 2) {
            draw_depths(kMiddle, 10 * round);
            fill(expected, kMiddle, 10 * round);
        }
        EXPECT_EQ(shown(kMap), expected) << round;
    }
}

TEST_F(DrawnDepthsTest, WhatIsNotDrawnOverStays) {
    specify(kMap, GL_DEPTH_COMPONENT24, 7);
    Steps expected(kWidth * kHeight, 7);
    int step = 50;
    for (const Box& box : {Box{0, 0, 64, 64}, Box{3, 3, 1, 1}, Box{149, 99, 1, 1}, Box{60, 60, 8, 8}}) {
        attach(1, kMap);
        draw_depths(box, ++step);
        fill(expected, box, step);
        EXPECT_EQ(shown(kMap), expected);
        attach(1, kMap);
        clear_depths(box, ++step);
        fill(expected, box, step);
        EXPECT_EQ(shown(kMap), expected);
    }
}

// A frame of draws that sample the map, more drawing to the map, more samples: each sees its own.
TEST_F(DrawnDepthsTest, QueuedDrawsSeeWhatWasThere) {
    specify(kMap, GL_DEPTH_COMPONENT24);
    const Box left{0, 0, 75, kHeight}, right{75, 0, 75, kHeight};
    attach(1, kMap);
    clear_depths({}, 100);
    show(kMap, left);
    attach(1, kMap);
    clear_depths({}, 200);
    show(kMap, right);
    Steps expected(kWidth * kHeight, 200);
    fill(expected, left, 100);
    EXPECT_EQ(read_reds(), expected);
}

// Undefined in GL 3.0 §4.4.2; here the texels of before the object was bound, as long as it is.
TEST_F(DrawnDepthsTest, WhileItIsAttachedTheMapIsSampledAsItWas) {
    specify(kMap, GL_DEPTH_COMPONENT24);
    glBindTexture(GL_TEXTURE_2D, kOther);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kWidth, kHeight, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    attach(1, kMap);
    clear_depths({}, 100);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    attach(1, kOther, GL_COLOR_ATTACHMENT0);
    clear_depths({}, 200);
    glFinish();
    glBindTexture(GL_TEXTURE_2D, kMap);
    glEnable(GL_TEXTURE_2D);
    draw_depths({}, 220, GL_ALWAYS);
    EXPECT_EQ(read_reds(), Steps(kWidth * kHeight, 100));
    EXPECT_EQ(shown(kMap), Steps(kWidth * kHeight, 220));
}

TEST_F(DrawnDepthsTest, SizesAndFormatsChange) {
    for (const GLint format : {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32}) {
        specify(kMap, format, 3, 70, 200);
        attach(1, kMap);
        glViewport(0, 0, 70, 200);
        clear_depths({0, 0, 70, 200}, 30);
        glViewport(0, 0, kWidth, kHeight);
        EXPECT_EQ(shown(kMap), Steps(kWidth * kHeight, 30));
        specify(kMap, format, 60);
        EXPECT_EQ(shown(kMap), Steps(kWidth * kHeight, 60));
        attach(1, kMap);
        draw_depths(kMiddle, 90);
        Steps expected(kWidth * kHeight, 60);
        fill(expected, kMiddle, 90);
        EXPECT_EQ(shown(kMap), expected);
    }
}

TEST_F(DrawnDepthsTest, OutliveObjectsAndAttachments) {
    specify(kMap, GL_DEPTH_COMPONENT24);
    attach(1, kMap);
    clear_depths({}, 100);
    const GLuint object = 1;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &object);
    EXPECT_EQ(shown(kMap), Steps(kWidth * kHeight, 100));
    attach(2, kMap);
    draw_depths(kMiddle, 50);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, 0, 0);
    specify(kOther, GL_DEPTH_COMPONENT24, 9);
    attach(2, kOther);
    draw_depths(kMiddle, 20);
    Steps expected(kWidth * kHeight, 100);
    fill(expected, kMiddle, 50);
    EXPECT_EQ(shown(kMap), expected);
    show(kMap);
    const GLuint map = kMap;
    glDeleteTextures(1, &map);
    EXPECT_EQ(read_reds(), expected) << "queued draws keep what they sample";
}

TEST_F(DrawnDepthsTest, DepthAndStencilOfOneTexture) {
    glBindTexture(GL_TEXTURE_2D, kMap);
    std::vector<GLuint> pairs(kWidth * kHeight, 0x0000'0011);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, kWidth, kHeight, 0, GL_DEPTH_STENCIL,
                 GL_UNSIGNED_INT_24_8, pairs.data());
    const auto expect = [&](GLuint depth, GLuint stencil, const char* what) {
        glBindTexture(GL_TEXTURE_2D, kMap);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, pairs.data());
        EXPECT_EQ(std::count(pairs.begin(), pairs.end(), depth << 8 | stencil), kWidth * kHeight) << what;
    };
    attach(1, kMap);
    clear_depths({}, 255);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    expect(0xffffff, 0x11, "depth alone");
    attach(2, kMap, GL_DEPTH_STENCIL_ATTACHMENT);
    glClearStencil(0x22);
    glClear(GL_STENCIL_BUFFER_BIT);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    expect(0xffffff, 0x22, "stencil alone, of both");
    attach(2, kMap, GL_DEPTH_STENCIL_ATTACHMENT);
    clear_depths({}, 0);
    glClearStencil(0x33);
    glClear(GL_STENCIL_BUFFER_BIT);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    expect(0, 0x33, "both");
    attach(3, kMap, GL_STENCIL_ATTACHMENT);
    glClearStencil(0x44);
    glClear(GL_STENCIL_BUFFER_BIT);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    expect(0, 0x44, "stencil attached alone");
}

// What is known of a block's depths is forgotten when others give it new ones.
TEST_F(DrawnDepthsTest, NewTexelsHideNothing) {
    specify(kMap, GL_DEPTH_COMPONENT24, 255);
    attach(1, kMap);
    draw_depths({}, 50, GL_LESS);
    const std::vector<GLfloat> far(kWidth * kHeight, 1.0f);
    glBindTexture(GL_TEXTURE_2D, kMap);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kWidth, kHeight, GL_DEPTH_COMPONENT, GL_FLOAT, far.data());
    draw_depths({}, 150, GL_LESS);
    EXPECT_EQ(shown(kMap), Steps(kWidth * kHeight, 150));
}

TEST_F(DrawnDepthsTest, BlitSamplesHideNothing) {
    const auto make = [](GLuint object, int step) {
        glBindRenderbuffer(GL_RENDERBUFFER, object);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, 4, GL_DEPTH_COMPONENT24, kWidth, kHeight);
        glBindFramebuffer(GL_FRAMEBUFFER, object);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, object);
        clear_depths({}, 255);
        draw_depths({}, step, GL_LESS);
    };
    make(1, 200);
    make(2, 50);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 1);
    glBlitFramebuffer(0, 0, kWidth, kHeight, 0, 0, kWidth, kHeight, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    GLuint query = 0, samples = 0;
    glGenQueries(1, &query);
    glBeginQuery(GL_SAMPLES_PASSED, query);
    draw_depths({}, 150, GL_LESS);
    glEndQuery(GL_SAMPLES_PASSED);
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &samples);
    EXPECT_EQ(samples, 4u * kWidth * kHeight);
}

TEST_F(DrawnDepthsTest, ContextsOfAGroupSeeWhatEachOtherDraws) {
    const auto second = create_context(Config{}, &ctx());
    attach_picture(*second, kWidth, kHeight);
    specify(kMap, GL_DEPTH_COMPONENT24);
    const auto in_second = [&](auto work) {
        make_current(second.get());
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        work();
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        make_current(&ctx());
    };
    const auto draw = [](int step) {
        attach(1, kMap);
        clear_depths({}, step);
        draw_depths(kMiddle, step + 1);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
    };
    const auto expected = [](int step) {
        Steps steps(kWidth * kHeight, step);
        fill(steps, kMiddle, step + 1);
        return steps;
    };
    for (int step = 10; step < 200; step += 60) {
        draw(step);
        in_second([&] { EXPECT_EQ(shown(kMap), expected(step)); });
        in_second([&] { show(kMap); });  // queued
        draw(step + 20);
        in_second([&] { EXPECT_EQ(read_reds(), expected(step)); });
        in_second([&] { EXPECT_EQ(shown(kMap), expected(step + 20)); });
        in_second([&] { draw(step + 40); });
        EXPECT_EQ(shown(kMap), expected(step + 40));
    }
    make_current(&ctx());
}

// Tiles and rows give the same pixels, however they are sampled.
class SampledDepths : public DrawnDepthsTest {
  protected:
    // Draws slopes to a level of one texture, and gives the same texels to another.
    void make_both(GLint format, int width, int height, GLint border, GLint level) {
        const bool packed = format == GL_DEPTH24_STENCIL8;
        const GLenum client = packed ? GL_DEPTH_STENCIL : GL_DEPTH_COMPONENT;
        const GLenum type = packed ? GL_UNSIGNED_INT_24_8 : GL_UNSIGNED_INT;
        const auto size_at = [&](int size, int l) { return std::max(1, size >> l) + 2 * border; };
        for (int l = 0; std::max(width, height) >> l; ++l) {
            std::vector<GLuint> texels(static_cast<std::size_t>(size_at(width, l) * size_at(height, l)));
            for (GLuint& texel : texels) texel = static_cast<GLuint>(m_engine());
            for (const GLuint texture : {kMap, kOther}) {
                glBindTexture(GL_TEXTURE_2D, texture);
                glTexImage2D(GL_TEXTURE_2D, l, format, size_at(width, l), size_at(height, l), border, client,
                             type, texels.data());
            }
        }
        const int across = size_at(width, level), up = size_at(height, level);
        attach(1, kMap, GL_DEPTH_ATTACHMENT, level);
        glViewport(0, 0, across, up);
        glClearDepth(1);
        glClear(GL_DEPTH_BUFFER_BIT);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LESS);
        glBegin(GL_TRIANGLES);
        for (int i = 0; i < 60; ++i) glVertex3f(random(-1, 1), random(-1, 1), random(-1, 1));
        glEnd();
        glDisable(GL_DEPTH_TEST);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        std::vector<GLuint> texels(static_cast<std::size_t>(across * up));
        glBindTexture(GL_TEXTURE_2D, kMap);
        glGetTexImage(GL_TEXTURE_2D, level, client, type, texels.data());
        glBindTexture(GL_TEXTURE_2D, kOther);
        glTexSubImage2D(GL_TEXTURE_2D, level, -border, -border, across, up, client, type, texels.data());
        glViewport(0, 0, kWidth, kHeight);
    }

    std::vector<GLubyte> sample(GLuint texture, GLenum filter, GLenum wrap, GLenum compare, float anisotropy,
                                GLint level) {
        glBindTexture(GL_TEXTURE_2D, texture);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(filter));
        const bool linear = filter != GL_NEAREST && filter != GL_NEAREST_MIPMAP_NEAREST;
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, linear ? GL_LINEAR : GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, static_cast<GLint>(wrap));
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, static_cast<GLint>(wrap));
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, static_cast<GLint>(compare));
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
        glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_INTENSITY);
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, anisotropy);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, level);
        glEnable(GL_TEXTURE_2D);
        draw_quad(0.5f, 2.6f, 1.7f);
        glDisable(GL_TEXTURE_2D);
        std::vector<GLubyte> rgba(4 * kWidth * kHeight);
        glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
        return rgba;
    }

    void expect_equal(GLint level) {
        for (const GLenum filter : {GL_NEAREST, GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR})
            for (const GLenum wrap : {GL_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT})
                for (const GLenum compare : {GL_NONE, GL_COMPARE_R_TO_TEXTURE})
                    for (const float anisotropy : {1.0f, 4.0f}) {
                        const auto drawn = sample(kMap, filter, wrap, compare, anisotropy, level),
                                   given = sample(kOther, filter, wrap, compare, anisotropy, level);
                        EXPECT_EQ(drawn, given)
                            << filter << ' ' << wrap << ' ' << compare << ' ' << anisotropy;
                        EXPECT_NE(std::count(drawn.begin(), drawn.end(), drawn[0]), 4 * kWidth * kHeight);
                    }
    }

    GLfloat random(GLfloat low, GLfloat high) {
        return low + (high - low) * static_cast<GLfloat>(m_engine() >> 8) * 0x1p-24f;
    }
    std::mt19937 m_engine{5};
};

TEST_F(SampledDepths, AreTheSameInTilesAndRows) {
    for (const GLint format : {GL_DEPTH_COMPONENT16, GL_DEPTH24_STENCIL8}) {
        make_both(format, 128, 256, 0, 0);
        expect_equal(0);
        make_both(format, 100, 70, 0, 0);
        expect_equal(0);
    }
}

TEST_F(SampledDepths, AreTheSameAtOtherLevelsAndWithBorders) {
    make_both(GL_DEPTH24_STENCIL8, 256, 256, 0, 1);
    expect_equal(0);
    expect_equal(1);
    make_both(GL_DEPTH24_STENCIL8, 128, 128, 1, 0);
    expect_equal(0);
}

TEST_F(SampledDepths, GoIntoSmallerLevels) {
    specify(kMap, GL_DEPTH_COMPONENT24);
    attach(1, kMap);
    clear_depths({}, 100);
    glBindTexture(GL_TEXTURE_2D, kMap);
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, 2);
    EXPECT_EQ(shown(kMap), Steps(kWidth * kHeight, 100));
}

// Whatever programs do to a map, in any order, beside a model of it.
class MapModel {
  public:
    explicit MapModel(unsigned seed) : m_engine(seed), m_steps(kWidth * kHeight) {
        specify(kMap, GL_DEPTH_COMPONENT24);
    }

    void step() {
        const Box box = below(3) == 0 ? Box{} : random_box();
        const int depth = below(4) == 0 ? 255 : below(256);
        switch (below(12)) {
            case 0:
            case 1:
                bind();
                clear_depths({}, depth);
                return fill(m_steps, {}, depth);
            case 2:
                bind();
                clear_depths(box, depth);
                return fill(m_steps, box, depth);
            case 3:
            case 4:
                bind();
                draw_depths(box, depth);
                return fill(m_steps, box, depth);
            case 5: {
                const std::vector<GLfloat> given(kWidth * kHeight, depth_of(depth));
                glBindTexture(GL_TEXTURE_2D, kMap);
                glTexSubImage2D(GL_TEXTURE_2D, 0, box.x, box.y, box.width, box.height, GL_DEPTH_COMPONENT,
                                GL_FLOAT, given.data());
                return fill(m_steps, box, depth);
            }
            case 6:
                bind();
                return glFlush();
            case 7:
                EXPECT_EQ(texels(kMap), m_steps);
                return;
            case 8: {
                bind();
                std::vector<GLfloat> depths(kWidth * kHeight);
                glReadPixels(0, 0, kWidth, kHeight, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
                for (std::size_t i = 0; i < depths.size(); ++i)
                    ASSERT_EQ(static_cast<int>(depths[i] * 255 + 0.5f), m_steps[i]) << i;
                return;
            }
            case 9:
                copy_part(box);
                return;
            default:
                EXPECT_EQ(shown(kMap), m_steps);
        }
    }

  private:
    int below(int count) { return static_cast<int>(m_engine() % static_cast<unsigned>(count)); }
    Box random_box() {
        Box box;
        box.x = below(kWidth), box.y = below(kHeight);
        box.width = 1 + below(kWidth - box.x), box.height = 1 + below(kHeight - box.y);
        return box;
    }
    // One of two objects, or none, and then one.
    void bind() {
        if (below(4) == 0) glBindFramebuffer(GL_FRAMEBUFFER, 0);
        attach(1 + static_cast<GLuint>(below(2)), kMap);
    }
    // A part of the map to another place of it.
    void copy_part(const Box& box) {
        bind();
        const int x = below(kWidth - box.width + 1), y = below(kHeight - box.height + 1);
        glBindTexture(GL_TEXTURE_2D, kMap);
        glCopyTexSubImage2D(GL_TEXTURE_2D, 0, x, y, box.x, box.y, box.width, box.height);
        const Steps before = m_steps;
        for (int j = 0; j < box.height; ++j)
            std::copy_n(before.begin() + (box.y + j) * kWidth + box.x, box.width,
                        m_steps.begin() + (y + j) * kWidth + x);
    }

    std::mt19937 m_engine;
    Steps m_steps;
};

TEST_F(DrawnDepthsTest, AnyOrderOfCommandsAgreesWithAModel) {
    const char* const wanted = std::getenv("TERRAZZO_MAP_SEED");
    const unsigned seed = wanted ? static_cast<unsigned>(std::strtoul(wanted, nullptr, 10)) : 20u;
    std::cout << "TERRAZZO_MAP_SEED=" << seed << '\n';
    MapModel model(seed);
    for (int i = 0; i < 600 && !HasFailure(); ++i) {
        SCOPED_TRACE(i);
        model.step();
    }
}

}  // namespace
}  // namespace terrazzo::gl
