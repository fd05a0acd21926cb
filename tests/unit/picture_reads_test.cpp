// What ReadPixels takes straight from the tiles is what it gives by way of other types; what BlitFramebuffer
// moves whole is what it moves pixel by pixel: of any part of a picture, drawn on, only cleared, or both.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "attach_picture.h"
#include "gl/framebuffer_object.h"
#include "gl/generated/commands.h"
#include "gl_fixture.h"

namespace terrazzo::gl {
namespace {

// Three by two bins, of which the last are cut.
constexpr int kWidth = 150, kHeight = 90;

struct Rect {
    int x, y, width, height;
};
constexpr Rect kRects[] = {{0, 0, kWidth, kHeight}, {1, 2, 3, 5},     {61, 60, 10, 9},   {3, 0, 66, 1},
                           {64, 0, 64, 64},         {-5, -3, 20, 20}, {140, 80, 40, 40}, {66, 3, 1, 80},
                           {200, 0, 5, 5},          {5, 5, 0, 3}};

class PictureReadsTest : public GlTest {
  protected:
    void attach(const raster::TargetFormat& format) {
        attach_picture(ctx(), kWidth, kHeight, format);
        pixel_storei(ctx(), GL_PACK_ALIGNMENT, 1);
    }

    // Columns of all colours and slopes of depth in the middle; the last bins are only cleared.
    void draw() {
        clear_color(ctx(), 0.2f, 0.4f, 0.9f, 0.7f);
        clear_depth(ctx(), 0.75);
        clear_stencil(ctx(), 0x5a);
        clear(ctx(), GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        matrix_mode(ctx(), GL_PROJECTION);
        load_identity(ctx());
        ortho(ctx(), 0, kWidth, 0, kHeight, -1, 1);
        enable(ctx(), GL_DEPTH_TEST);
        glBegin(GL_QUADS);
        for (int i = 0; i < 40; ++i) {
            const float x = 12.0f + 2.3f * static_cast<float>(i), z = 0.9f * static_cast<float>(i % 7) / 7;
            glColor4f(static_cast<float>(i) / 40, static_cast<float>(i % 5) / 5, 0.3f,
                      static_cast<float>(i % 3) / 3);
            glVertex3f(x, 7.5f, z);
            glVertex3f(x + 2.4f, 7.5f, z);
            glVertex3f(x + 2.4f, 80.3f, -z);
            glVertex3f(x, 80.3f, -z);
        }
        glEnd();
        disable(ctx(), GL_DEPTH_TEST);
    }

    template <typename T>
    std::vector<T> read(const Rect& rect, GLenum format, GLenum type, std::size_t per_pixel) {
        std::vector<T> pixels(static_cast<std::size_t>(rect.width * rect.height) * per_pixel, T{0x33});
        read_pixels(ctx(), rect.x, rect.y, rect.width, rect.height, format, type, pixels.data());
        EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
        return pixels;
    }

    // Of a pixel in the window: the others are left alone.
    static bool is_inside(const Rect& rect, std::size_t pixel) {
        const int x = rect.x + static_cast<int>(pixel) % rect.width,
                  y = rect.y + static_cast<int>(pixel) / rect.width;
        return x >= 0 && y >= 0 && x < kWidth && y < kHeight;
    }

    // `channels`: which of red, green, blue, alpha are in a pixel's bytes, in the order of their addresses.
    void expect_bytes(const Rect& rect, GLenum format, GLenum type,
                      const std::vector<std::size_t>& channels) {
        const auto floats = read<float>(rect, GL_RGBA, GL_FLOAT, 4);
        const auto bytes = read<GLubyte>(rect, format, type, channels.size());
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            const std::size_t pixel = i / channels.size();
            const float wanted = floats[4 * pixel + channels[i % channels.size()]] * 255;
            // Means of samples have their fractions as floats.
            wrong += is_inside(rect, pixel) ? std::fabs(static_cast<float>(bytes[i]) - wanted) > 0.501f
                                            : bytes[i] != 0x33;
        }
        EXPECT_EQ(wrong, 0u) << std::hex << format << ' ' << type << std::dec << " at " << rect.x << ' '
                             << rect.y;
    }

    void expect_colours() {
        for (const Rect& rect : kRects) {
            expect_bytes(rect, GL_RGBA, GL_UNSIGNED_BYTE, {0, 1, 2, 3});
            expect_bytes(rect, GL_BGRA, GL_UNSIGNED_BYTE, {2, 1, 0, 3});
            expect_bytes(rect, GL_RGB, GL_UNSIGNED_BYTE, {0, 1, 2});
            expect_bytes(rect, GL_BGR, GL_UNSIGNED_BYTE, {2, 1, 0});
            expect_bytes(rect, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, {2, 1, 0, 3});
            expect_bytes(rect, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8, {3, 0, 1, 2});
            expect_bytes(rect, GL_RGBA, GL_UNSIGNED_INT_8_8_8_8, {3, 2, 1, 0});
        }
    }

    // With 24 bits, and beside what comes with stencil values.
    void expect_depths(bool has_any_slope = true) {
        for (const Rect& rect : kRects) {
            const auto both = read<GLuint>(rect, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, 1);
            const auto floats = read<float>(rect, GL_DEPTH_COMPONENT, GL_FLOAT, 1);
            const auto integers = read<GLuint>(rect, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 1);
            std::size_t wrong = 0, drawn = 0;
            for (std::size_t i = 0; i < both.size(); ++i) {
                if (!is_inside(rect, i)) {
                    wrong += floats[i] != 0x33 || integers[i] != 0x33;
                    continue;
                }
                const GLuint depth = both[i] >> 8;
                drawn += depth != static_cast<GLuint>(std::lrint(0.75 * 16777215));
                wrong += floats[i] != static_cast<float>(depth * (1.0 / 16777215.0)) ||
                         integers[i] != (depth << 8 | depth >> 16);
            }
            EXPECT_EQ(wrong, 0u) << rect.x << ' ' << rect.y;
            if (rect.width == kWidth) {
                EXPECT_EQ(drawn > 0, has_any_slope);
            }
        }
    }
};

TEST_F(PictureReadsTest, WindowsGiveTheSameBytesInEveryOrder) {
    attach({});
    draw();
    expect_colours();
    expect_depths();
}

TEST_F(PictureReadsTest, WindowsThatAreOnlyCleared) {
    attach({});
    draw();
    clear(ctx(), GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    expect_colours();
    expect_depths(false);
    EXPECT_EQ(read<GLubyte>({3, 3, 1, 1}, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, 1)[0], 0x5a);
}

TEST_F(PictureReadsTest, WindowsWithoutAlpha) {
    raster::TargetFormat format;
    format.has_alpha = false;
    attach(format);
    draw();
    expect_colours();
    EXPECT_EQ(read<GLubyte>({100, 50, 1, 1}, GL_RGBA, GL_UNSIGNED_BYTE, 4)[3], 255);
}

TEST_F(PictureReadsTest, WindowsOfFourSamples) {
    raster::TargetFormat format;
    format.samples = 4;
    attach(format);
    draw();
    expect_colours();
    expect_depths();
}

TEST_F(PictureReadsTest, DepthsOfSixteenBits) {
    raster::TargetFormat format;
    format.depth_bits = 16;
    format.stencil_bits = 0;
    attach(format);
    draw();
    const Rect all = kRects[0];
    const auto words = read<GLushort>(all, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, 1);
    const auto floats = read<float>(all, GL_DEPTH_COMPONENT, GL_FLOAT, 1);
    const auto integers = read<GLuint>(all, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 1);
    for (std::size_t i = 0; i < words.size(); ++i) {
        ASSERT_EQ(integers[i], words[i] * 0x10001u);
        ASSERT_EQ(floats[i], static_cast<float>(words[i] * (1.0 / 65535.0)));
    }
}

TEST_F(PictureReadsTest, WhatIsTransferredOrSwappedTakesTheOtherWay) {
    attach({});
    draw();
    const Rect rect{10, 5, 7, 7};
    const auto plain = read<float>(rect, GL_DEPTH_COMPONENT, GL_FLOAT, 1);
    pixel_transferf(ctx(), GL_DEPTH_SCALE, 0.5f);
    const auto scaled = read<float>(rect, GL_DEPTH_COMPONENT, GL_FLOAT, 1);
    pixel_transferf(ctx(), GL_DEPTH_SCALE, 1);
    for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_NEAR(scaled[i], plain[i] / 2, 1e-6);
    const auto rgb = read<GLubyte>(rect, GL_RGB, GL_UNSIGNED_BYTE, 3);
    pixel_transferf(ctx(), GL_RED_SCALE, 0);
    const auto without_red = read<GLubyte>(rect, GL_RGB, GL_UNSIGNED_BYTE, 3);
    pixel_transferf(ctx(), GL_RED_SCALE, 1);
    EXPECT_NE(rgb[0], 0);
    EXPECT_EQ(without_red[0], 0);
    EXPECT_EQ(without_red[1], rgb[1]);
    pixel_storei(ctx(), GL_PACK_SWAP_BYTES, 1);
    const auto swapped = read<GLuint>(rect, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 1);
    pixel_storei(ctx(), GL_PACK_SWAP_BYTES, 0);
    // By way of floats, which have the upper 24 bits.
    const auto integers = read<GLuint>(rect, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 1);
    for (std::size_t i = 0; i < integers.size(); ++i)
        EXPECT_EQ(__builtin_bswap32(swapped[i]) >> 8, integers[i] >> 8);
}

TEST_F(PictureReadsTest, RowsGoWhereThePackStateSays) {
    attach({});
    draw();
    const auto all = read<GLubyte>(kRects[0], GL_RGB, GL_UNSIGNED_BYTE, 3);
    pixel_storei(ctx(), GL_PACK_ROW_LENGTH, 50);
    pixel_storei(ctx(), GL_PACK_SKIP_PIXELS, 7);
    pixel_storei(ctx(), GL_PACK_SKIP_ROWS, 2);
    std::vector<GLubyte> pixels(50 * 30 * 3, 0x33), wanted = pixels;
    read_pixels(ctx(), 40, 50, 30, 20, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    for (std::size_t row = 0; row < 20; ++row)
        std::memcpy(&wanted[3 * ((row + 2) * 50 + 7)], &all[3 * ((row + 50) * kWidth + 40)], 3 * 30);
    EXPECT_EQ(pixels, wanted);
}

class BlitTest : public PictureReadsTest {
  protected:
    BlitTest() { attach({}); }

    GLuint make_object(GLsizei samples) {
        GLuint object, names[2];
        gen_framebuffers(ctx(), 1, &object);
        bind_framebuffer(ctx(), GL_FRAMEBUFFER, object);
        gen_renderbuffers(ctx(), 2, names);
        bind_renderbuffer(ctx(), GL_RENDERBUFFER, names[0]);
        renderbuffer_storage_multisample(ctx(), GL_RENDERBUFFER, samples, GL_RGBA8, kWidth, kHeight);
        framebuffer_renderbuffer(ctx(), GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, names[0]);
        bind_renderbuffer(ctx(), GL_RENDERBUFFER, names[1]);
        renderbuffer_storage_multisample(ctx(), GL_RENDERBUFFER, samples, GL_DEPTH24_STENCIL8, kWidth,
                                         kHeight);
        framebuffer_renderbuffer(ctx(), GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                                 names[1]);
        return object;
    }

    void fill_with_grey(GLuint object) {
        bind_framebuffer(ctx(), GL_FRAMEBUFFER, object);
        clear_color(ctx(), 0.5f, 0.5f, 0.5f, 0.5f);
        clear_depth(ctx(), 0.25);
        clear(ctx(), GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    }

    struct Picture {
        std::vector<GLubyte> colours;
        std::vector<GLuint> depths;
        bool operator==(const Picture&) const = default;
    };
    Picture read_all(GLuint object) {
        bind_framebuffer(ctx(), GL_FRAMEBUFFER, object);
        return {read<GLubyte>(kRects[0], GL_RGBA, GL_UNSIGNED_BYTE, 4),
                read<GLuint>(kRects[0], GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, 1)};
    }

    void blit(GLuint from, GLuint to, const Rect& box, int to_x, bool turned, GLenum filter = GL_NEAREST) {
        bind_framebuffer(ctx(), GL_READ_FRAMEBUFFER, from);
        bind_framebuffer(ctx(), GL_DRAW_FRAMEBUFFER, to);
        for (const GLbitfield planes : {GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT}) {
            const int low = box.y, high = box.y + box.height;
            blit_framebuffer(ctx(), box.x, low, box.x + box.width, high, to_x, turned ? high : low,
                             to_x + box.width, turned ? low : high, planes,
                             planes == GL_COLOR_BUFFER_BIT ? filter : GL_NEAREST);
            EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
        }
    }

    // What an object shows, by way of other columns of another: no tile can be moved as it is.
    Picture seen(GLuint from) {
        const GLuint other = make_object(0);
        blit(from, other, {0, 0, kWidth - 1, kHeight}, 1, false);
        const Picture right = read_all(other);
        blit(from, other, {1, 0, kWidth - 1, kHeight}, 0, false);
        Picture picture = read_all(other);
        for (std::size_t pixel = picture.depths.size(); pixel-- > 0;) {
            const bool is_last = pixel % kWidth == kWidth - 1;
            const Picture& source = is_last ? picture : right;
            const std::size_t at = is_last ? pixel - 1 : pixel + 1;
            picture.depths[pixel] = source.depths[at];
            std::copy_n(&source.colours[4 * at], 4, &picture.colours[4 * pixel]);
        }
        return picture;
    }
};

TEST_F(BlitTest, WholeRectanglesAreWhatTheirPixelsAre) {
    for (const GLsizei samples : {0, 4}) {
        const GLuint from = make_object(samples);
        draw();
        const Picture source = seen(from);
        EXPECT_NE(source.colours[4 * (50 * kWidth + 70)], source.colours[4 * (50 * kWidth + 75)]);
        const GLuint object = make_object(0);
        for (const GLuint to : {GLuint{0}, object})
            for (const Rect& box :
                 {Rect{0, 0, kWidth, kHeight}, {10, 3, 70, 40}, {61, 60, 10, 9}, {120, 0, 30, 90}})
                for (const bool turned : {false, true}) {
                    fill_with_grey(to);
                    blit(from, to, box, box.x, turned);
                    const Picture ours = read_all(to);
                    std::size_t wrong = 0;
                    for (std::size_t pixel = 0; pixel < ours.depths.size(); ++pixel) {
                        const int x = static_cast<int>(pixel) % kWidth, y = static_cast<int>(pixel) / kWidth;
                        const bool inside =
                            x >= box.x && x < box.x + box.width && y >= box.y && y < box.y + box.height;
                        const auto at = static_cast<std::size_t>(
                            (turned ? 2 * box.y + box.height - 1 - y : y) * kWidth + x);
                        wrong +=
                            inside
                                ? ours.depths[pixel] >> 8 != source.depths[at] >> 8 ||
                                      std::memcmp(&ours.colours[4 * pixel], &source.colours[4 * at], 4) != 0
                                : ours.depths[pixel] >> 8 != 4194304 || ours.colours[4 * pixel] != 128;
                    }
                    EXPECT_EQ(wrong, 0u) << samples << " samples, to " << to << ' ' << box.x << ' ' << turned;
                }
    }
}

TEST_F(BlitTest, WhatIsClearedIsClearedThere) {
    const GLuint from = make_object(4);
    fill_with_grey(from);
    const GLuint to = make_object(0);
    draw();
    enable(ctx(), GL_SCISSOR_TEST);
    scissor(ctx(), 20, 10, 100, 60);
    blit(from, to, kRects[0], 0, false);
    disable(ctx(), GL_SCISSOR_TEST);
    const Picture picture = read_all(to);
    for (const auto& [x, y, inside] :
         {std::tuple{19, 30, false}, {20, 10, true}, {119, 69, true}, {120, 30, false}}) {
        const auto pixel = static_cast<std::size_t>(y * kWidth + x);
        EXPECT_EQ(picture.colours[4 * pixel] == 128 && picture.colours[4 * pixel + 1] == 128, inside) << x;
        EXPECT_EQ(picture.depths[pixel] >> 8 == 4194304, inside) << x;
    }
}

TEST_F(BlitTest, LinearFiltersMixNothingWhereNothingIsScaled) {
    const GLuint from = make_object(0);
    draw();
    const GLuint nearest = make_object(0), linear = make_object(0);
    blit(from, nearest, kRects[0], 0, true);
    blit(from, linear, kRects[0], 0, true, GL_LINEAR);
    EXPECT_EQ(read_all(nearest), read_all(linear));
}

}  // namespace
}  // namespace terrazzo::gl
