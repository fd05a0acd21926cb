// Driving both libraries; see both_libraries.h.
#include "both_libraries.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "gl/client_pixel.h"
#include "gl/generated/commands.h"
#include "gl/pixel_convert.h"

namespace terrazzo::test {
namespace {

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

// The reference's 1.0 is one too many for 32 bits in single precision and wraps to 0 or the smallest integer.
bool is_wrapped_one(GLenum type, float theirs) {
    return (type == GL_UNSIGNED_INT && theirs == 0.0f) || (type == GL_INT && theirs == -1.0f);
}

}  // namespace

std::ostream& operator<<(std::ostream& out, ClientPixel pixel) {
    return out << std::hex << "0x" << pixel.format << " / 0x" << pixel.type << std::dec;
}

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

BothLibraries::BothLibraries(const Osmesa& reference, unsigned seed)
    : gl(reference), context(terrazzo::gl::create_context({}, nullptr)), random(seed) {}

BothLibraries::Modes BothLibraries::random_modes() {
    return {static_cast<GLint>(pick(2)),
            static_cast<GLint>(pick(2)),
            pick(2) ? static_cast<GLint>(20 + pick(12)) : 0,
            static_cast<GLint>(pick(3)),
            static_cast<GLint>(pick(4)),
            1 << pick(4)};
}

void BothLibraries::set_modes(GLenum first, const Modes& modes) {
    log << (first == GL_PACK_SWAP_BYTES ? " pack" : " unpack");
    for (size_t i = 0; i < modes.size(); ++i) {
        const GLenum name = first + static_cast<GLenum>(i);
        TERRAZZO_GL(gl, glPixelStorei)(name, modes[i]);
        pixel_storei(*context, name, modes[i]);
        log << ' ' << modes[i];
    }
}

void BothLibraries::random_transfer() {
    const auto transfer = [&](GLenum name, GLfloat value) {
        TERRAZZO_GL(gl, glPixelTransferf)(name, value);
        pixel_transferf(*context, name, value);
    };
    for (GLenum name : {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE, GL_DEPTH_SCALE}) {
        transfer(name, number(-0.5f, 2.0f));
    }
    for (GLenum name : {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS, GL_DEPTH_BIAS}) {
        transfer(name, number(-0.5f, 0.5f));
    }
    transfer(GL_MAP_COLOR, static_cast<GLfloat>(pick(2)));
    transfer(GL_MAP_STENCIL, static_cast<GLfloat>(pick(2)));
    transfer(GL_INDEX_SHIFT, static_cast<GLfloat>(pick(5)) - 2.0f);
    transfer(GL_INDEX_OFFSET, static_cast<GLfloat>(pick(9)) - 4.0f);
    for (GLenum map = GL_PIXEL_MAP_S_TO_S; map <= GL_PIXEL_MAP_A_TO_A; ++map) {
        GLfloat values[256];
        for (GLfloat& value : values) {
            value = map == GL_PIXEL_MAP_S_TO_S ? static_cast<GLfloat>(pick(256)) : number(-0.1f, 1.1f);
        }
        const GLsizei size = map <= GL_PIXEL_MAP_I_TO_A ? 1 << pick(9) : 1 + static_cast<GLsizei>(pick(256));
        TERRAZZO_GL(gl, glPixelMapfv)(map, size, values);
        pixel_mapfv(*context, map, size, values);
    }
}

void BothLibraries::expect_same_errors() {
    EXPECT_EQ(TERRAZZO_GL(gl, glGetError)(), get_error(*context)) << log.str();
}

void BothLibraries::expect_same_pixels(ClientPixel client, int width, int height, Bytes ours, Bytes theirs,
                                       float step) {
    if (ours == theirs) return;
    if (step == 0.0f) {
        const auto at = std::mismatch(ours.begin(), ours.end(), theirs.begin()).first - ours.begin();
        ADD_FAILURE() << log.str() << ": byte " << at << " is " << int(ours[static_cast<size_t>(at)])
                      << ", theirs is " << int(theirs[static_cast<size_t>(at)]);
        return;
    }
    const auto& pack = context->pixels.pack;
    const auto layout = terrazzo::gl::image_layout(pack, width, client.format, client.type);
    const size_t row_bytes =
        static_cast<size_t>(width) * terrazzo::gl::bytes_per_pixel(client.format, client.type);
    std::vector<float> a(4 * static_cast<size_t>(width)), b(a.size());
    for (int y = 0; y < height; ++y) {
        unsigned char* our_row = &ours[layout.offset + static_cast<size_t>(y) * layout.row_stride];
        unsigned char* their_row = &theirs[layout.offset + static_cast<size_t>(y) * layout.row_stride];
        terrazzo::gl::unpack_rgba_float(client.format, client.type, pack.swap_bytes, our_row, width,
                                        a.data());
        terrazzo::gl::unpack_rgba_float(client.format, client.type, pack.swap_bytes, their_row, width,
                                        b.data());
        for (size_t i = 0; i < a.size(); ++i) {
            if (a[i] >= 1.0f - step && is_wrapped_one(client.type, b[i])) continue;
            if (clamp_theirs && a[i] != b[i]) b[i] = std::clamp(b[i], 0.0f, 1.0f);
            EXPECT_NEAR(a[i], b[i], 1.01f * step) << log.str() << ": row " << y << " component " << i;
        }
        std::memset(our_row, 0, row_bytes);
        std::memset(their_row, 0, row_bytes);
    }
    EXPECT_EQ(ours, theirs) << log.str() << ": bytes between pixels";
}

}  // namespace terrazzo::test
