// Whole pictures of windows and pixmaps, and what tests of GLX and EGL draw to see whether a pixel lies where
// it belongs and whether a drawable has the buffers that its configuration names.
#pragma once

#include <GL/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "drawing.h"

namespace terrazzo::test {

// Of GL's kind: row 0 is the lowest.
struct Picture {
    int width = 0, height = 0;
    std::vector<Pixel> pixels;

    const Pixel& at(int x, int y) const { return pixels[static_cast<std::size_t>(y * width + x)]; }
    long count(const Pixel& color) const { return std::count(pixels.begin(), pixels.end(), color); }
    // Empty where each pixel is what `expected` says; else the first that is not.
    template <class Expected>
    std::string differing(const Expected& expected) const {
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const Pixel &is = at(x, y), wanted = expected(x, y);
                if (is == wanted) continue;
                std::ostringstream out;
                out << x << "," << y << ": " << is[0] << " " << is[1] << " " << is[2] << ", not " << wanted[0]
                    << " " << wanted[1] << " " << wanted[2];
                return out.str();
            }
        }
        return width * height > 0 ? "" : "no picture";
    }
};

// What the server has in a window, or in a pixmap whose pixels are those of `like`, a window; 0: of the
// root's kind.
inline Picture picture_of(Display* display, Drawable drawable, int width, int height, Window like = 0) {
    XSync(display, 0);
    XImage* const image = XGetImage(display, drawable, 0, 0, static_cast<unsigned>(width),
                                    static_cast<unsigned>(height), ~0ul, ZPixmap);
    if (!image) return {};
    unsigned long masks[3] = {image->red_mask, image->green_mask, image->blue_mask};
    if (masks[0] == 0) {  // a pixmap has no visual
        XWindowAttributes attributes;
        XGetWindowAttributes(display, like ? like : DefaultRootWindow(display), &attributes);
        masks[0] = attributes.visual->red_mask;
        masks[1] = attributes.visual->green_mask;
        masks[2] = attributes.visual->blue_mask;
    }
    Picture out{width, height, {}};
    for (int y = height - 1; y >= 0; --y) {
        for (int x = 0; x < width; ++x) {
            const unsigned long value = XGetPixel(image, x, y);
            Pixel pixel;
            for (std::size_t i = 0; i < 3; ++i) {
                const unsigned long lowest = masks[i] & ~(masks[i] - 1);
                pixel[i] = static_cast<int>((value & masks[i]) / lowest * 255 / (masks[i] / lowest));
            }
            out.pixels.push_back(pixel);
        }
    }
    XDestroyImage(image);
    return out;
}

// No two pixels of it are alike, up to 64 x 64.
inline Pixel pattern(int x, int y) {
    return {x * 4, y * 4, (x * 7 + y * 3) % 256};
}

inline void draw_pattern(int width, int height) {
    std::vector<GLubyte> bytes;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int component : pattern(x, y)) bytes.push_back(static_cast<GLubyte>(component));
    glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glRasterPos2f(-1, -1);
    glDrawPixels(width, height, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
    glPopClientAttrib();
}

// Over the whole viewport, with texture coordinates from 0 to 1.
inline void draw_unit_square() {
    glBegin(GL_QUADS);
    const int corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (const auto& [x, y] : corners) {
        glTexCoord2i(x, y);
        glVertex2i(2 * x - 1, 2 * y - 1);
    }
    glEnd();
}

// What a configuration says of itself.
struct Bits {
    int red, green, blue, alpha, depth, stencil, samples;
};

inline constexpr int kFormatSize = 16;

// Whether a component of 0-255 may have come from this one by being kept in so many bits: the reference
// rounds the colour of some clears, cuts off the bits of fragments, and so do others when they widen them
// again (doc/reference.md).
inline bool is_kept(int value, int from, int bits) {
    return bits == 8 ? value == from : std::abs(value - from) <= 255 / ((1 << bits) - 1) + 1;
}

inline bool is_kept(const Pixel& pixel, const Pixel& from, const Bits& bits) {
    return is_kept(pixel[0], from[0], bits.red) && is_kept(pixel[1], from[1], bits.green) &&
           is_kept(pixel[2], from[2], bits.blue);
}

inline constexpr Pixel kOdd{201, 90, 37};

// Draws into the current drawable and sees that its buffers are what `bits` says. Leaves kOdd in its left
// half and what blending with a destination alpha of 0.5, or of 1 where there is none, makes of white in its
// right half.
inline void check_format(const Bits& bits, bool has_back) {
    const auto get = [](GLenum name) {
        GLint out = -1;
        glGetIntegerv(name, &out);
        return out;
    };
    EXPECT_EQ(get(GL_RED_BITS), bits.red);
    EXPECT_EQ(get(GL_GREEN_BITS), bits.green);
    EXPECT_EQ(get(GL_BLUE_BITS), bits.blue);
    EXPECT_EQ(get(GL_ALPHA_BITS), bits.alpha);
    EXPECT_EQ(get(GL_DEPTH_BITS), bits.depth);
    EXPECT_EQ(get(GL_STENCIL_BITS), bits.stencil);
    EXPECT_EQ(get(GL_SAMPLES), bits.samples);
    EXPECT_EQ(get(GL_DOUBLEBUFFER), has_back);

    glViewport(0, 0, kFormatSize, kFormatSize);
    glClearColor(kOdd[0] / 255.0f, kOdd[1] / 255.0f, kOdd[2] / 255.0f, 0.5f);
    glClearDepth(0.5);
    glClearStencil(5);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    const auto expect = [&](int x, const Pixel& color, const char* what) {
        const Pixel found = read(x, 3);
        EXPECT_TRUE(is_kept(found, color, bits)) << what << ": " << testing::PrintToString(found);
    };
    expect(3, kOdd, "cleared");
    GLubyte pixel[4] = {};
    glReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    EXPECT_EQ(pixel[3], bits.alpha ? 128 : 255);

    // Behind the cleared depth: unseen where there is one.
    glEnable(GL_DEPTH_TEST);
    glColor3f(0, 0, 1);
    glBegin(GL_QUADS);
    for (const auto& [x, y] : {std::pair{-1.0f, -1.0f}, {0.0f, -1.0f}, {0.0f, 1.0f}, {-1.0f, 1.0f}})
        glVertex3f(x, y, 0.5f);
    glEnd();
    expect(3, bits.depth ? kOdd : kBlue, "depth test");
    glDisable(GL_DEPTH_TEST);
    // Passes where the stencil is 5; without a stencil buffer the test always passes.
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_NOTEQUAL, 5, 255);
    glColor3f(0, 1, 0);
    glRectf(-1, -1, 0, 1);
    expect(3, !bits.stencil ? kGreen : bits.depth ? kOdd : kBlue, "stencil test");
    glDisable(GL_STENCIL_TEST);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, kFormatSize / 2, kFormatSize);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_DST_ALPHA, GL_ZERO);
    glColor3f(1, 1, 1);
    glRectf(0, -1, 1, 1);
    glDisable(GL_BLEND);
    expect(12, bits.alpha ? Pixel{128, 128, 128} : Pixel{255, 255, 255}, "alpha");
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

// The same on the screen.
inline void check_shown_format(const Picture& picture, const Bits& bits) {
    ASSERT_EQ(picture.width, kFormatSize);
    const int white = bits.alpha ? 128 : 255;
    for (int y = 0; y < kFormatSize; ++y) {
        EXPECT_TRUE(is_kept(picture.at(2, y), kOdd, bits))
            << y << ": " << testing::PrintToString(picture.at(2, y));
        EXPECT_TRUE(is_kept(picture.at(kFormatSize - 2, y), {white, white, white}, bits)) << y;
    }
}

}  // namespace terrazzo::test
