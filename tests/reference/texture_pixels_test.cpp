// Uploads and read-backs of textures on ours and on the reference: every internal format x client format x
// client type under random pixel store and pixel transfer modes, with random pixels. What GetTexImage returns
// must agree in every byte, and what GetTexLevelParameter says in every value.

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "both_libraries.h"
#include "gl/generated/commands.h"

namespace {

using terrazzo::test::BothLibraries;
using terrazzo::test::Bytes;
using terrazzo::test::ClientPixel;

constexpr GLint kInternalFormats[] = {
    1,
    2,
    3,
    4,
    GL_ALPHA,
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
};
// Drives both sides with the same calls and keeps a log of them for the message of a failure.
class BothTextures : public BothLibraries {
  public:
    BothTextures(const terrazzo::test::Osmesa& reference, unsigned seed, bool with_transfer)
        : BothLibraries(reference, seed), m_with_transfer(with_transfer) {}

    void upload(GLint internal_format, ClientPixel client) {
        m_from_indices = client.format == GL_COLOR_INDEX;
        m_from_32_bits = terrazzo::test::is_32_bits(client.type);
        log.str("");
        log << std::hex << "internal format 0x" << internal_format << " from " << client;
        random_unpack_modes(client);
        Bytes pixels = random_pixels(client.type);
        TERRAZZO_GL(gl, glTexImage2D)
        (GL_TEXTURE_2D, 0, internal_format, kWidth, kHeight, 0, client.format, client.type, pixels.data());
        tex_image_2d(*context, GL_TEXTURE_2D, 0, internal_format, kWidth, kHeight, 0, client.format,
                     client.type, pixels.data());
    }

    // A part of the texture anew, from other pixels.
    void upload_part(ClientPixel client) {
        const GLint x = static_cast<GLint>(pick(kWidth)), y = static_cast<GLint>(pick(kHeight));
        const GLsizei width = static_cast<GLsizei>(pick(static_cast<unsigned>(kWidth - x)) + 1);
        const GLsizei height = static_cast<GLsizei>(pick(static_cast<unsigned>(kHeight - y)) + 1);
        m_from_indices |= client.format == GL_COLOR_INDEX;
        m_from_32_bits |= terrazzo::test::is_32_bits(client.type);
        log << ", part from " << client;
        random_unpack_modes(client);
        Bytes pixels = random_pixels(client.type);
        TERRAZZO_GL(gl, glTexSubImage2D)
        (GL_TEXTURE_2D, 0, x, y, width, height, client.format, client.type, pixels.data());
        tex_sub_image_2d(*context, GL_TEXTURE_2D, 0, x, y, width, height, client.format, client.type,
                         pixels.data());
    }

    void expect_same_level() {
        constexpr GLenum kNames[] = {
            GL_TEXTURE_WIDTH,          GL_TEXTURE_HEIGHT,         GL_TEXTURE_DEPTH,
            GL_TEXTURE_BORDER,         GL_TEXTURE_RED_SIZE,       GL_TEXTURE_GREEN_SIZE,
            GL_TEXTURE_BLUE_SIZE,      GL_TEXTURE_ALPHA_SIZE,     GL_TEXTURE_LUMINANCE_SIZE,
            GL_TEXTURE_INTENSITY_SIZE, GL_TEXTURE_INTERNAL_FORMAT};
        for (GLenum name : kNames) {
            GLfloat theirs = -1, ours = -2;
            TERRAZZO_GL(gl, glGetTexLevelParameterfv)(GL_TEXTURE_2D, 0, name, &theirs);
            get_tex_level_parameterfv(*context, GL_TEXTURE_2D, 0, name, &ours);
            EXPECT_EQ(theirs, ours) << log.str() << " parameter 0x" << std::hex << name;
        }
    }

    void expect_same_texels(ClientPixel client) {
        const std::string uploads = log.str();
        log << ", as " << client;
        set_modes(GL_PACK_SWAP_BYTES, random_modes());
        Bytes theirs(kClientBytes, 0xcd), ours = theirs;
        TERRAZZO_GL(gl, glGetTexImage)(GL_TEXTURE_2D, 0, client.format, client.type, theirs.data());
        get_tex_image(*context, GL_TEXTURE_2D, 0, client.format, client.type, ours.data());
        expect_same_pixels(client, kWidth, kHeight, ours, theirs,
                           is_inexact(client.type) ? step(client.type) : 0.0f);
        log.str("");
        log << uploads;
    }

  private:
    static constexpr int kWidth = 13, kHeight = 5;
    // Enough for any image here under any of the modes: 4 floats a pixel, rows of up to 32 and 3 more pixels.
    static constexpr size_t kClientBytes = 16 * 35 * (kHeight + 3);

    // The reference swaps bytes, transfers pixels and looks indices up in copies of the image, and then
    // applies modes to the copy that described the original; indices it reads as if rows followed one another
    // without gaps. Modes and bitmaps that show this stay away; tests/unit has them for ours.
    void random_unpack_modes(ClientPixel client) {
        Modes modes = random_modes();
        const bool copies = modes[0] != 0 || client.format == GL_COLOR_INDEX;
        if (copies || m_with_transfer) modes[3] = modes[4] = 0;
        if (client.format == GL_COLOR_INDEX || m_with_transfer) modes[2] = 0;
        if (client.format == GL_COLOR_INDEX) modes[5] = 1;
        set_modes(GL_UNPACK_SWAP_BYTES, modes);
    }

    Bytes random_pixels(GLenum type) {
        Bytes pixels(kClientBytes);
        for (unsigned char& byte : pixels) byte = static_cast<unsigned char>(pick(256));
        if (type != GL_FLOAT) return pixels;
        for (size_t i = 0; i < pixels.size(); i += 4) {
            auto bits =
                std::bit_cast<uint32_t>(pick(16) == 0 ? static_cast<float>(pick(2)) : number(-0.25f, 1.25f));
            if (context->pixels.unpack.swap_bytes) bits = __builtin_bswap32(bits);
            std::memcpy(&pixels[i], &bits, 4);
        }
        return pixels;
    }

    int texture_bits() {
        GLfloat bits = 0;
        for (GLenum name : {GL_TEXTURE_RED_SIZE, GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_LUMINANCE_SIZE,
                            GL_TEXTURE_INTENSITY_SIZE}) {
            GLfloat size = 0;
            get_tex_level_parameterfv(*context, GL_TEXTURE_2D, 0, name, &size);
            bits = std::max(bits, size);
        }
        return static_cast<int>(bits);
    }

    // The reference has several ways between sizes above 8 bits, some by way of floats, and takes one or
    // another depending on details of formats; ours rounds to nearest. From integers of 32 bits ours makes
    // floats first and the reference does not; to them it is the other way round.
    bool is_inexact(GLenum type) {
        return texture_bits() > 8 || terrazzo::test::component_bits(type) == 10 ||
               terrazzo::test::is_32_bits(type) || m_from_32_bits;
    }

    // A step of the coarser one of what is stored and what is returned. Colours that the reference looked up
    // by index have 8 bits.
    float step(GLenum type) {
        const int bits =
            std::min({texture_bits(), terrazzo::test::component_bits(type), m_from_indices ? 8 : 16});
        const bool is_signed = type == GL_BYTE || type == GL_SHORT || type == GL_INT;
        return 1.0f / static_cast<float>((1 << (is_signed ? bits - 1 : bits)) - 1);
    }

    bool m_with_transfer;
    bool m_from_indices = false;  // some texels
    bool m_from_32_bits = false;
};

void compare_all_formats(const terrazzo::test::Osmesa& reference, unsigned seed, bool with_transfer) {
    BothTextures both(reference, seed, with_transfer);
    std::vector<ClientPixel> pixels = terrazzo::test::legal_pixels();
    if (with_transfer) std::erase_if(pixels, [](ClientPixel pixel) { return pixel.type == GL_BITMAP; });
    for (GLint internal_format : kInternalFormats) {
        for (ClientPixel client : pixels) {
            if (with_transfer) both.random_transfer();
            both.upload(internal_format, client);
            both.expect_same_errors();
            both.expect_same_level();
            if (both.pick(2)) both.upload_part(both.pick(pixels));
            for (int i = 0; i < 3; ++i) {
                const ClientPixel out = both.pick(pixels);
                if (out.format != GL_COLOR_INDEX) both.expect_same_texels(out);
            }
            both.expect_same_errors();
            if (testing::Test::HasFailure()) return;
        }
    }
}

TEST(TexturePixels, EqualTheReference) {
    const terrazzo::test::Osmesa reference(4, 4);
    if (!reference.missing().empty()) GTEST_SKIP() << reference.missing();
    compare_all_formats(reference, 1, false);
}

TEST(TexturePixels, EqualTheReferenceThroughPixelTransfer) {
    const terrazzo::test::Osmesa reference(4, 4);
    if (!reference.missing().empty()) GTEST_SKIP() << reference.missing();
    compare_all_formats(reference, 2, true);
}

}  // namespace
