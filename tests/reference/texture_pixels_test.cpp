// Uploads and read-backs of textures on ours and on the reference: every internal format x client format x
// client type under random pixel store and pixel transfer modes, with random pixels. What GetTexImage returns
// must agree in every byte, and what GetTexLevelParameter says in every value.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <random>
#include <sstream>
#include <vector>

#include "gl/client_pixel.h"
#include "gl/context.h"
#include "gl/generated/commands.h"
#include "gl/pixel_convert.h"
#include "osmesa.h"

namespace {

using terrazzo::gl::Context;
using Bytes = std::vector<unsigned char>;

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
constexpr GLenum kFormats[] = {
    GL_COLOR_INDEX, GL_RED, GL_GREEN, GL_BLUE,      GL_ALPHA,           GL_RGB,
    GL_RGBA,        GL_BGR, GL_BGRA,  GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_ABGR_EXT};
constexpr GLenum kTypes[] = {GL_UNSIGNED_BYTE,
                             GL_BYTE,
                             GL_UNSIGNED_SHORT,
                             GL_SHORT,
                             GL_UNSIGNED_INT,
                             GL_INT,
                             GL_FLOAT,
                             GL_BITMAP,
                             GL_UNSIGNED_BYTE_3_3_2,
                             GL_UNSIGNED_BYTE_2_3_3_REV,
                             GL_UNSIGNED_SHORT_5_6_5,
                             GL_UNSIGNED_SHORT_5_6_5_REV,
                             GL_UNSIGNED_SHORT_4_4_4_4,
                             GL_UNSIGNED_SHORT_4_4_4_4_REV,
                             GL_UNSIGNED_SHORT_5_5_5_1,
                             GL_UNSIGNED_SHORT_1_5_5_5_REV,
                             GL_UNSIGNED_INT_8_8_8_8,
                             GL_UNSIGNED_INT_8_8_8_8_REV,
                             GL_UNSIGNED_INT_10_10_10_2,
                             GL_UNSIGNED_INT_2_10_10_10_REV};

struct ClientPixel {
    GLenum format, type;
};

std::vector<ClientPixel> legal_pixels() {
    std::vector<ClientPixel> pixels;
    for (GLenum format : kFormats) {
        for (GLenum type : kTypes) {
            if (terrazzo::gl::check_client_pixel(format, type).code == GL_NO_ERROR)
                pixels.push_back({format, type});
        }
    }
    return pixels;
}

// Bits of the largest component of a type.
int component_bits(GLenum type) {
    if (const auto* packed = terrazzo::gl::find_packed_type(type)) return packed->bits[0];
    return static_cast<int>(8 * terrazzo::gl::element_size(type));
}

// Drives both sides with the same calls and keeps a log of them for the message of a failure.
class BothTextures {
  public:
    BothTextures(const terrazzo::test::Osmesa& reference, unsigned seed)
        : m_gl(reference), m_ours(terrazzo::gl::create_context({}, nullptr)), m_random(seed) {}

    unsigned pick(unsigned n) { return std::uniform_int_distribution<unsigned>(0, n - 1)(m_random); }
    ClientPixel pick(const std::vector<ClientPixel>& pixels) {
        return pixels[pick(static_cast<unsigned>(pixels.size()))];
    }

    void random_transfer() {
        m_with_transfer = true;
        for (GLenum name : {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE}) {
            transfer(name, number(-0.5f, 2.0f));
        }
        for (GLenum name : {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS}) {
            transfer(name, number(-0.5f, 0.5f));
        }
        transfer(GL_MAP_COLOR, static_cast<GLfloat>(pick(2)));
        transfer(GL_INDEX_SHIFT, static_cast<GLfloat>(pick(5)) - 2.0f);
        transfer(GL_INDEX_OFFSET, static_cast<GLfloat>(pick(9)) - 4.0f);
        for (GLenum map = GL_PIXEL_MAP_I_TO_R; map <= GL_PIXEL_MAP_A_TO_A; ++map) {
            GLfloat values[256];
            for (GLfloat& value : values) value = number(-0.1f, 1.1f);
            const GLsizei size =
                map <= GL_PIXEL_MAP_I_TO_A ? 1 << pick(9) : 1 + static_cast<GLsizei>(pick(256));
            TERRAZZO_GL(m_gl, glPixelMapfv)(map, size, values);
            pixel_mapfv(*m_ours, map, size, values);
        }
    }

    void upload(GLint internal_format, ClientPixel client) {
        m_log.str("");
        m_from_indices = client.format == GL_COLOR_INDEX;
        m_from_32_bits = is_32_bits(client.type);
        m_log << std::hex << "internal format 0x" << internal_format << " from 0x" << client.format << " / 0x"
              << client.type << std::dec;
        random_unpack_modes(client);
        Bytes pixels = random_pixels(client.type);
        TERRAZZO_GL(m_gl, glTexImage2D)
        (GL_TEXTURE_2D, 0, internal_format, kWidth, kHeight, 0, client.format, client.type, pixels.data());
        tex_image_2d(*m_ours, GL_TEXTURE_2D, 0, internal_format, kWidth, kHeight, 0, client.format,
                     client.type, pixels.data());
    }

    // A part of the texture anew, perhaps from other pixels.
    void upload_part(ClientPixel client) {
        const GLint x = static_cast<GLint>(pick(kWidth)), y = static_cast<GLint>(pick(kHeight));
        const GLsizei width = static_cast<GLsizei>(pick(static_cast<unsigned>(kWidth - x)) + 1);
        const GLsizei height = static_cast<GLsizei>(pick(static_cast<unsigned>(kHeight - y)) + 1);
        m_from_indices |= client.format == GL_COLOR_INDEX;
        m_from_32_bits |= is_32_bits(client.type);
        m_log << std::hex << " part from 0x" << client.format << " / 0x" << client.type << std::dec;
        random_unpack_modes(client);
        Bytes pixels = random_pixels(client.type);
        TERRAZZO_GL(m_gl, glTexSubImage2D)
        (GL_TEXTURE_2D, 0, x, y, width, height, client.format, client.type, pixels.data());
        tex_sub_image_2d(*m_ours, GL_TEXTURE_2D, 0, x, y, width, height, client.format, client.type,
                         pixels.data());
    }

    void expect_same_errors() {
        EXPECT_EQ(TERRAZZO_GL(m_gl, glGetError)(), get_error(*m_ours)) << m_log.str();
    }

    void expect_same_level() {
        constexpr GLenum kNames[] = {
            GL_TEXTURE_WIDTH,          GL_TEXTURE_HEIGHT,         GL_TEXTURE_DEPTH,
            GL_TEXTURE_BORDER,         GL_TEXTURE_RED_SIZE,       GL_TEXTURE_GREEN_SIZE,
            GL_TEXTURE_BLUE_SIZE,      GL_TEXTURE_ALPHA_SIZE,     GL_TEXTURE_LUMINANCE_SIZE,
            GL_TEXTURE_INTENSITY_SIZE, GL_TEXTURE_INTERNAL_FORMAT};
        for (GLenum name : kNames) {
            GLfloat theirs = -1, ours = -2;
            TERRAZZO_GL(m_gl, glGetTexLevelParameterfv)(GL_TEXTURE_2D, 0, name, &theirs);
            get_tex_level_parameterfv(*m_ours, GL_TEXTURE_2D, 0, name, &ours);
            EXPECT_EQ(theirs, ours) << m_log.str() << " parameter 0x" << std::hex << name;
        }
    }

    void expect_same_texels(ClientPixel client) {
        std::ostringstream what;
        what << m_log.str() << std::hex << " as 0x" << client.format << " / 0x" << client.type << std::dec
             << " pack";
        set_modes(GL_PACK_SWAP_BYTES, random_modes(), what);
        Bytes theirs(kClientBytes, 0xcd), ours = theirs;
        TERRAZZO_GL(m_gl, glGetTexImage)(GL_TEXTURE_2D, 0, client.format, client.type, theirs.data());
        get_tex_image(*m_ours, GL_TEXTURE_2D, 0, client.format, client.type, ours.data());
        if (ours == theirs) return;
        if (!is_inexact(client.type)) {
            const auto at = std::mismatch(ours.begin(), ours.end(), theirs.begin()).first - ours.begin();
            ADD_FAILURE() << what.str() << ": byte " << at << " is " << int(ours[static_cast<size_t>(at)])
                          << ", theirs is " << int(theirs[static_cast<size_t>(at)]);
            return;
        }
        expect_near(client, ours, theirs, what.str());
    }

  private:
    static constexpr int kWidth = 13, kHeight = 5;
    // Enough for any image here under any of the modes: 4 floats a pixel, rows of up to 32 and 3 more pixels.
    static constexpr size_t kClientBytes = 16 * 35 * (kHeight + 3);

    float number(float low, float high) { return std::uniform_real_distribution<float>(low, high)(m_random); }

    void transfer(GLenum name, GLfloat value) {
        TERRAZZO_GL(m_gl, glPixelTransferf)(name, value);
        pixel_transferf(*m_ours, name, value);
    }

    // The values of GL_(UN)PACK_SWAP_BYTES, LSB_FIRST, ROW_LENGTH, SKIP_ROWS, SKIP_PIXELS and ALIGNMENT,
    // whose enumerants follow one another in this order.
    using Modes = std::array<GLint, 6>;

    Modes random_modes() {
        return {static_cast<GLint>(pick(2)),
                static_cast<GLint>(pick(2)),
                pick(2) ? static_cast<GLint>(20 + pick(12)) : 0,
                static_cast<GLint>(pick(3)),
                static_cast<GLint>(pick(4)),
                1 << pick(4)};
    }

    void set_modes(GLenum first, const Modes& modes, std::ostringstream& log) {
        for (size_t i = 0; i < modes.size(); ++i) {
            const GLenum name = first + static_cast<GLenum>(i);
            TERRAZZO_GL(m_gl, glPixelStorei)(name, modes[i]);
            pixel_storei(*m_ours, name, modes[i]);
            log << ' ' << modes[i];
        }
    }

    // The reference swaps bytes, transfers pixels and looks indices up in copies of the image, and then
    // applies modes to the copy that described the original; indices it reads as if rows followed one another
    // without gaps. Modes and bitmaps that show this stay away; tests/unit has them for ours.
    void random_unpack_modes(ClientPixel client) {
        Modes modes = random_modes();
        const bool copies = modes[0] != 0 || client.format == GL_COLOR_INDEX;
        if (copies || m_with_transfer) modes[3] = modes[4] = 0;
        if (client.format == GL_COLOR_INDEX || m_with_transfer) modes[2] = 0;
        if (client.format == GL_COLOR_INDEX) modes[5] = 1;
        m_log << " unpack";
        set_modes(GL_UNPACK_SWAP_BYTES, modes, m_log);
    }

    Bytes random_pixels(GLenum type) {
        Bytes pixels(kClientBytes);
        for (unsigned char& byte : pixels) byte = static_cast<unsigned char>(pick(256));
        if (type != GL_FLOAT) return pixels;
        for (size_t i = 0; i < pixels.size(); i += 4) {
            auto bits =
                std::bit_cast<uint32_t>(pick(16) == 0 ? static_cast<float>(pick(2)) : number(-0.25f, 1.25f));
            if (m_ours->pixels.unpack.swap_bytes) bits = __builtin_bswap32(bits);
            std::memcpy(&pixels[i], &bits, 4);
        }
        return pixels;
    }

    int texture_bits() {
        GLfloat bits = 0;
        for (GLenum name : {GL_TEXTURE_RED_SIZE, GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_LUMINANCE_SIZE,
                            GL_TEXTURE_INTENSITY_SIZE}) {
            GLfloat size = 0;
            get_tex_level_parameterfv(*m_ours, GL_TEXTURE_2D, 0, name, &size);
            bits = std::max(bits, size);
        }
        return static_cast<int>(bits);
    }

    static bool is_32_bits(GLenum type) { return type == GL_UNSIGNED_INT || type == GL_INT; }

    // The reference has several ways between sizes above 8 bits, some by way of floats, and takes one or
    // another depending on details of formats; ours rounds to nearest. From integers of 32 bits ours makes
    // floats first and the reference does not; to them it is the other way round.
    bool is_inexact(GLenum type) {
        return texture_bits() > 8 || component_bits(type) == 10 || is_32_bits(type) || m_from_32_bits;
    }

    // Components may differ by a step of the coarser one of what is stored and what is returned; bytes
    // between pixels may not. Colours that the reference looked up by index have 8 bits.
    void expect_near(ClientPixel client, Bytes ours, Bytes theirs, const std::string& what) {
        const int bits = std::min({texture_bits(), component_bits(client.type), m_from_indices ? 8 : 16});
        const bool is_signed = client.type == GL_BYTE || client.type == GL_SHORT || client.type == GL_INT;
        const float step = 1.0f / static_cast<float>((1 << (is_signed ? bits - 1 : bits)) - 1);
        const auto& pack = m_ours->pixels.pack;
        const auto layout = terrazzo::gl::image_layout(pack, kWidth, client.format, client.type);
        const size_t row_bytes = kWidth * terrazzo::gl::bytes_per_pixel(client.format, client.type);
        for (size_t y = 0; y < kHeight; ++y) {
            unsigned char* our_row = &ours[layout.offset + y * layout.row_stride];
            unsigned char* their_row = &theirs[layout.offset + y * layout.row_stride];
            float a[4 * kWidth], b[4 * kWidth];
            terrazzo::gl::unpack_rgba_float(client.format, client.type, pack.swap_bytes, our_row, kWidth, a);
            terrazzo::gl::unpack_rgba_float(client.format, client.type, pack.swap_bytes, their_row, kWidth,
                                            b);
            for (int i = 0; i < 4 * kWidth; ++i) {
                if (a[i] >= 1.0f - step && is_wrapped_one(client.type, b[i])) continue;
                EXPECT_NEAR(a[i], b[i], 1.01f * step) << what << " row " << y << " component " << i;
            }
            std::memset(our_row, 0, row_bytes);
            std::memset(their_row, 0, row_bytes);
        }
        EXPECT_EQ(ours, theirs) << what << ": bytes between pixels";
    }

    // The reference's 1.0 is one too many for 32 bits in single precision and wraps to 0 or the smallest
    // integer.
    static bool is_wrapped_one(GLenum type, float theirs) {
        return (type == GL_UNSIGNED_INT && theirs == 0.0f) || (type == GL_INT && theirs == -1.0f);
    }

    const terrazzo::test::Osmesa& m_gl;
    std::unique_ptr<Context> m_ours;
    std::mt19937 m_random;
    bool m_with_transfer = false;
    bool m_from_indices = false;  // some texels
    bool m_from_32_bits = false;
    std::ostringstream m_log;
};

void compare_all_formats(BothTextures& both, bool with_transfer) {
    std::vector<ClientPixel> pixels = legal_pixels();
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
    BothTextures both(reference, 1);
    compare_all_formats(both, false);
}

TEST(TexturePixels, EqualTheReferenceThroughPixelTransfer) {
    const terrazzo::test::Osmesa reference(4, 4);
    if (!reference.missing().empty()) GTEST_SKIP() << reference.missing();
    BothTextures both(reference, 2);
    compare_all_formats(both, true);
}

}  // namespace
