// ReadPixels and CopyTexImage on ours and on the reference, from frame buffers with the same random contents:
// every format and type, rectangles that leave the window, random pack and pixel transfer modes.

#include <gtest/gtest.h>

#include <algorithm>

#include "attach_picture.h"
#include "both_libraries.h"
#include "gl/client_pixel.h"
#include "gl/generated/commands.h"
#include "gl/surface.h"
#include "raster/target/target.h"

namespace {

using terrazzo::test::BothLibraries;
using terrazzo::test::Bytes;
using terrazzo::test::ClientPixel;

// Not a multiple of a tile or a bin.
constexpr int kWidth = 77, kHeight = 70;

class BothFrameBuffers : public BothLibraries {
  public:
    BothFrameBuffers(const terrazzo::test::Osmesa& reference, unsigned seed, bool with_transfer)
        : BothLibraries(reference, seed), m_with_transfer(with_transfer) {
        attach_picture(*context, kWidth, kHeight);
        fill();
        // GL 1.5 §4.3.2 clamps what is read; the reference leaves that to the type.
        clamp_theirs = with_transfer;
    }

    // Reads a random rectangle, smaller than kMaxSize x kMaxSize pixels, with some of it beyond the window
    // now and then.
    void read(ClientPixel client) {
        log.str("");
        log << "read " << client;
        if (m_with_transfer) random_transfer();
        Modes modes = random_modes();
        if (modes[2] != 0)
            modes[2] += kMaxSize - 20;  // rows that overlap would depend on the order of writes
        set_modes(GL_PACK_SWAP_BYTES, modes);
        const GLint x = static_cast<GLint>(pick(kWidth + 8)) - 8,
                    y = static_cast<GLint>(pick(kHeight + 8)) - 8;
        const GLsizei width = static_cast<GLsizei>(pick(kMaxSize)),
                      height = static_cast<GLsizei>(pick(kMaxSize));
        log << " at " << x << ' ' << y << " size " << width << ' ' << height;
        Bytes theirs(kClientBytes, 0xcd), ours = theirs;
        TERRAZZO_GL(gl, glReadPixels)(x, y, width, height, client.format, client.type, theirs.data());
        read_pixels(*context, x, y, width, height, client.format, client.type, ours.data());
        expect_same_errors();
        expect_same_pixels(client, width, height, ours, theirs, step(client));
    }

    void copy_to_texture(GLint internal_format) {
        log.str("");
        log << std::hex << "copy to internal format 0x" << internal_format << std::dec;
        set_modes(GL_PACK_SWAP_BYTES, {0, 0, 0, 0, 0, 1});
        const GLint x = static_cast<GLint>(pick(kWidth - 16)), y = static_cast<GLint>(pick(kHeight - 16));
        const auto format = static_cast<GLenum>(internal_format);
        TERRAZZO_GL(gl, glCopyTexImage2D)(GL_TEXTURE_2D, 0, format, x, y, 13, 9, 0);
        copy_tex_image_2d(*context, GL_TEXTURE_2D, 0, format, x, y, 13, 9, 0);
        expect_same_errors();
        // The second rectangle leaves the window where it is near an edge; its texels there must stay.
        const GLint x2 = static_cast<GLint>(pick(kWidth)) - 4, y2 = static_cast<GLint>(pick(kHeight)) - 4;
        TERRAZZO_GL(gl, glCopyTexSubImage2D)(GL_TEXTURE_2D, 0, 2, 3, x2, y2, 9, 5);
        copy_tex_sub_image_2d(*context, GL_TEXTURE_2D, 0, 2, 3, x2, y2, 9, 5);
        expect_same_errors();
        log << " from " << x << ' ' << y << " and " << x2 << ' ' << y2;
        Bytes theirs(4 * 13 * 9, 0xcd), ours = theirs;
        TERRAZZO_GL(gl, glGetTexImage)(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, theirs.data());
        get_tex_image(*context, GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, ours.data());
        expect_same_pixels({GL_RGBA, GL_UNSIGNED_BYTE}, 13, 9, ours, theirs, 0.0f);
    }

  private:
    static constexpr int kMaxSize = 24;
    // 4 floats a pixel, rows of up to 36 pixels, 24 rows and what is skipped.
    static constexpr size_t kClientBytes = 16 * 40 * 32;

    // Pixel rectangles fill the reference's buffers and are read back in the formats that lose nothing.
    void fill() {
        Bytes colors(4 * kWidth * kHeight), stencils(kWidth * kHeight);
        std::vector<GLuint> depths(kWidth * kHeight);
        for (unsigned char& byte : colors) byte = static_cast<unsigned char>(pick(256));
        for (unsigned char& byte : stencils) byte = static_cast<unsigned char>(pick(256));
        for (GLuint& depth : depths) depth = static_cast<GLuint>(random());
        TERRAZZO_GL(gl, glPixelStorei)(GL_UNPACK_ALIGNMENT, 1);
        TERRAZZO_GL(gl, glPixelStorei)(GL_PACK_ALIGNMENT, 1);
        TERRAZZO_GL(gl, glRasterPos2f)(-1, -1);
        TERRAZZO_GL(gl, glDrawPixels)(kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, colors.data());
        TERRAZZO_GL(gl, glDrawPixels)(kWidth, kHeight, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencils.data());
        TERRAZZO_GL(gl, glEnable)(GL_DEPTH_TEST);
        TERRAZZO_GL(gl, glDepthFunc)(GL_ALWAYS);
        TERRAZZO_GL(gl, glColorMask)(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        TERRAZZO_GL(gl, glDrawPixels)(kWidth, kHeight, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depths.data());
        TERRAZZO_GL(gl, glReadPixels)(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, colors.data());
        TERRAZZO_GL(gl, glReadPixels)
        (0, 0, kWidth, kHeight, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencils.data());
        TERRAZZO_GL(gl, glReadPixels)
        (0, 0, kWidth, kHeight, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depths.data());
        terrazzo::raster::Target& target = *context->renderer.target();
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const auto pixel = static_cast<size_t>(y * kWidth + x);
                set_pixel(target, x, kHeight - 1 - y, &colors[4 * pixel], depths[pixel] >> 8,
                          stencils[pixel]);
            }
        }
    }

    static void set_pixel(terrazzo::raster::Target& target, int x, int row, const unsigned char* color,
                          GLuint depth, unsigned char stencil) {
        using terrazzo::raster::kBinSize;
        const int index = row / kBinSize * target.bins_across() + x / kBinSize;
        target.materialize(index);
        const terrazzo::raster::Bin bin = target.bin(index);
        const int i = terrazzo::raster::pixel_index(x % kBinSize, row % kBinSize);
        std::copy_n(reinterpret_cast<const std::byte*>(color), 4, bin.color + 4 * i);
        bin.depth[i] = depth;
        bin.stencil[i] = stencil;
    }

    // The reference sums luminance in single precision, which cannot hold 32 bits. What comes out of pixel
    // transfer may lie in the middle of two integers but for the last bit of a float: there the two may
    // differ by one.
    float step(ClientPixel client) {
        if (client.format == GL_STENCIL_INDEX || client.format == GL_DEPTH_COMPONENT) return 0.0f;
        if (!m_with_transfer) {
            const bool is_luminance = client.format == GL_LUMINANCE || client.format == GL_LUMINANCE_ALPHA;
            return is_luminance && terrazzo::test::is_32_bits(client.type) ? 1.0f / 16777215.0f : 0.0f;
        }
        const int bits = std::min(terrazzo::test::component_bits(client.type), 16);
        const bool is_signed = client.type == GL_BYTE || client.type == GL_SHORT || client.type == GL_INT;
        return 1.0f / static_cast<float>((1 << (is_signed ? bits - 1 : bits)) - 1);
    }

    bool m_with_transfer;
};

void compare_all(const terrazzo::test::Osmesa& reference, unsigned seed, bool with_transfer) {
    BothFrameBuffers both(reference, seed, with_transfer);
    std::vector<ClientPixel> pixels = terrazzo::test::legal_pixels();
    std::erase_if(pixels, [](ClientPixel pixel) { return pixel.format == GL_COLOR_INDEX; });
    for (GLenum type :
         {GL_UNSIGNED_BYTE, GL_BYTE, GL_UNSIGNED_SHORT, GL_SHORT, GL_UNSIGNED_INT, GL_INT, GL_FLOAT}) {
        pixels.push_back({GL_DEPTH_COMPONENT, type});
        pixels.push_back({GL_STENCIL_INDEX, type});
    }
    for (ClientPixel client : pixels) {
        for (int i = 0; i < 20; ++i) both.read(client);
    }
}

TEST(ReadPixels, EqualsTheReference) {
    const terrazzo::test::Osmesa reference(kWidth, kHeight);
    if (!reference.missing().empty()) GTEST_SKIP() << reference.missing();
    compare_all(reference, 1, false);
}

TEST(ReadPixels, EqualsTheReferenceThroughPixelTransfer) {
    const terrazzo::test::Osmesa reference(kWidth, kHeight);
    if (!reference.missing().empty()) GTEST_SKIP() << reference.missing();
    compare_all(reference, 2, true);
}

// Without pixel transfer: with it the reference reads other rows of a window than it was asked for.
TEST(CopyTexImage, EqualsTheReference) {
    const terrazzo::test::Osmesa reference(kWidth, kHeight);
    if (!reference.missing().empty()) GTEST_SKIP() << reference.missing();
    BothFrameBuffers both(reference, 3, false);
    for (GLint internal_format :
         {GL_ALPHA, GL_ALPHA16, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_LUMINANCE4_ALPHA4, GL_INTENSITY,
          GL_R3_G3_B2, GL_RGB, GL_RGB4, GL_RGB5, GL_RGB10, GL_RGB16, GL_RGBA, GL_RGBA4, GL_RGB5_A1, GL_RGBA8,
          GL_RGB10_A2, GL_RGBA16}) {
        for (int i = 0; i < 20; ++i) both.copy_to_texture(internal_format);
    }
}

}  // namespace
