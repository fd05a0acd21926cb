// The table of internal formats, and the choice of a size where the program leaves it open.
#include "gl/texture_format.h"

namespace terrazzo::gl {
namespace {

using raster::BaseFormat;
using raster::TexelStorage;

constexpr TexelFormat rgba8_format(GLenum base, BaseFormat base_format, unsigned char red,
                                   unsigned char green, unsigned char blue, unsigned char alpha) {
    return {base, base_format, TexelStorage::kRgba8, {red, green, blue, alpha}};
}

constexpr TexelFormat float_format(GLenum base, BaseFormat base_format, unsigned char color,
                                   unsigned char alpha) {
    return {base, base_format, TexelStorage::kRgba32F, {color, color, color, alpha}};
}

constexpr TexelFormat kA8 = rgba8_format(GL_ALPHA, BaseFormat::kAlpha, 0, 0, 0, 8);
constexpr TexelFormat kA16 = float_format(GL_ALPHA, BaseFormat::kAlpha, 0, 16);
constexpr TexelFormat kL8 = rgba8_format(GL_LUMINANCE, BaseFormat::kLuminance, 8, 8, 8, 0);
constexpr TexelFormat kL16 = float_format(GL_LUMINANCE, BaseFormat::kLuminance, 16, 0);
constexpr TexelFormat kL4A4 = rgba8_format(GL_LUMINANCE_ALPHA, BaseFormat::kLuminanceAlpha, 4, 4, 4, 4);
constexpr TexelFormat kL8A8 = rgba8_format(GL_LUMINANCE_ALPHA, BaseFormat::kLuminanceAlpha, 8, 8, 8, 8);
constexpr TexelFormat kL16A16 = float_format(GL_LUMINANCE_ALPHA, BaseFormat::kLuminanceAlpha, 16, 16);
constexpr TexelFormat kI8 = rgba8_format(GL_INTENSITY, BaseFormat::kIntensity, 8, 8, 8, 8);
constexpr TexelFormat kI16 = float_format(GL_INTENSITY, BaseFormat::kIntensity, 16, 16);
constexpr TexelFormat kRgb332 = rgba8_format(GL_RGB, BaseFormat::kRgb, 3, 3, 2, 0);
constexpr TexelFormat kRgb444 = rgba8_format(GL_RGB, BaseFormat::kRgb, 4, 4, 4, 0);
constexpr TexelFormat kRgb555 = rgba8_format(GL_RGB, BaseFormat::kRgb, 5, 5, 5, 0);
constexpr TexelFormat kRgb565 = rgba8_format(GL_RGB, BaseFormat::kRgb, 5, 6, 5, 0);
constexpr TexelFormat kRgb8 = rgba8_format(GL_RGB, BaseFormat::kRgb, 8, 8, 8, 0);
constexpr TexelFormat kRgb10 = float_format(GL_RGB, BaseFormat::kRgb, 10, 0);
constexpr TexelFormat kRgb16 = float_format(GL_RGB, BaseFormat::kRgb, 16, 0);
constexpr TexelFormat kRgba4 = rgba8_format(GL_RGBA, BaseFormat::kRgba, 4, 4, 4, 4);
constexpr TexelFormat kRgb5A1 = rgba8_format(GL_RGBA, BaseFormat::kRgba, 5, 5, 5, 1);
constexpr TexelFormat kRgba8 = rgba8_format(GL_RGBA, BaseFormat::kRgba, 8, 8, 8, 8);
constexpr TexelFormat kRgb10A2 = float_format(GL_RGBA, BaseFormat::kRgba, 10, 2);
constexpr TexelFormat kRgba16 = float_format(GL_RGBA, BaseFormat::kRgba, 16, 16);

constexpr TexelFormat depth_format(unsigned char bits) {
    return {GL_DEPTH_COMPONENT, BaseFormat::kDepth, TexelStorage::kDepth, {bits, 0, 0, 0}};
}
constexpr TexelFormat kDepth16 = depth_format(16);
constexpr TexelFormat kDepth24 = depth_format(24);
constexpr TexelFormat kDepth32 = depth_format(32);

const TexelFormat* choose_depth(GLenum client_type, bool swap_bytes) {
    if (client_type == GL_UNSIGNED_SHORT && !swap_bytes) return &kDepth16;
    if (client_type == GL_UNSIGNED_INT && !swap_bytes) return &kDepth32;
    return &kDepth24;
}

const TexelFormat* choose_rgb(GLenum client_type, bool swap_bytes) {
    if (client_type == GL_UNSIGNED_SHORT_5_5_5_1) return &kRgb555;
    if (client_type == GL_UNSIGNED_INT_2_10_10_10_REV) return &kRgb10;
    if (swap_bytes) return &kRgb8;
    switch (client_type) {
        case GL_UNSIGNED_BYTE_3_3_2:
        case GL_UNSIGNED_BYTE_2_3_3_REV:
            return &kRgb332;
        case GL_UNSIGNED_SHORT_5_6_5:
        case GL_UNSIGNED_SHORT_5_6_5_REV:
            return &kRgb565;
        default:
            return &kRgb8;
    }
}

const TexelFormat* choose_rgba(GLenum client_format, GLenum client_type, bool swap_bytes) {
    if (client_type == GL_UNSIGNED_SHORT_5_5_5_1) return &kRgb5A1;
    if (client_type == GL_UNSIGNED_INT_2_10_10_10_REV) return &kRgb10A2;
    if (swap_bytes) return &kRgba8;
    switch (client_type) {
        case GL_UNSIGNED_SHORT_4_4_4_4:
        case GL_UNSIGNED_SHORT_4_4_4_4_REV:
            return &kRgba4;
        case GL_UNSIGNED_SHORT_1_5_5_5_REV:
            return &kRgb5A1;
        case GL_UNSIGNED_INT_10_10_10_2:
            return &kRgb10A2;
        case GL_UNSIGNED_SHORT:
            return client_format == GL_RGBA ? &kRgba16 : &kRgba8;
        default:
            return &kRgba8;
    }
}

}  // namespace

std::array<GLfloat, 4> as_texel(BaseFormat base, const std::array<GLfloat, 4>& rgba) {
    const auto [r, g, b, a] = rgba;
    switch (base) {
        case BaseFormat::kAlpha:
            return {0, 0, 0, a};
        case BaseFormat::kLuminance:
            return {r, r, r, 1};
        case BaseFormat::kLuminanceAlpha:
            return {r, r, r, a};
        case BaseFormat::kIntensity:
            return {r, r, r, r};
        case BaseFormat::kRgb:
            return {r, g, b, 1};
        case BaseFormat::kRgba:
        case BaseFormat::kDepth:
            break;
    }
    return rgba;
}

const TexelFormat* choose_texel_format(GLint internal_format, GLenum client_format, GLenum client_type,
                                       bool swap_bytes) {
    // Unsized single-channel formats keep 16 bits when the client's pixels are of the same kind.
    const bool same_16_bits = !swap_bytes && client_type == GL_UNSIGNED_SHORT &&
                              client_format == static_cast<GLenum>(internal_format);
    switch (internal_format) {
        case GL_ALPHA:
            return same_16_bits ? &kA16 : &kA8;
        case GL_ALPHA4:
        case GL_ALPHA8:
            return &kA8;
        case GL_ALPHA12:
        case GL_ALPHA16:
            return &kA16;
        case GL_LUMINANCE:
            return same_16_bits ? &kL16 : &kL8;
        case 1:
        case GL_LUMINANCE4:
        case GL_LUMINANCE8:
            return &kL8;
        case GL_LUMINANCE12:
        case GL_LUMINANCE16:
            return &kL16;
        case GL_LUMINANCE_ALPHA:
            return same_16_bits ? &kL16A16 : &kL8A8;
        case GL_LUMINANCE4_ALPHA4:
            return &kL4A4;
        case 2:
        case GL_LUMINANCE6_ALPHA2:
        case GL_LUMINANCE8_ALPHA8:
            return &kL8A8;
        case GL_LUMINANCE12_ALPHA4:
        case GL_LUMINANCE12_ALPHA12:
        case GL_LUMINANCE16_ALPHA16:
            return &kL16A16;
        case GL_INTENSITY:
        case GL_INTENSITY4:
        case GL_INTENSITY8:
            return &kI8;
        case GL_INTENSITY12:
        case GL_INTENSITY16:
            return &kI16;
        case GL_R3_G3_B2:
            return &kRgb332;
        case GL_RGB:
            return choose_rgb(client_type, swap_bytes);
        case GL_RGB4:
            return &kRgb444;
        case GL_RGB5:
            return &kRgb555;
        case 3:
        case GL_RGB8:
        case GL_COMPRESSED_RGB_S3TC_DXT1_EXT:
            return &kRgb8;
        case GL_RGB10:
            return &kRgb10;
        case GL_RGB12:
        case GL_RGB16:
            return &kRgb16;
        case GL_RGBA:
            return choose_rgba(client_format, client_type, swap_bytes);
        case GL_RGBA2:
        case GL_RGBA4:
            return &kRgba4;
        case GL_RGB5_A1:
            return &kRgb5A1;
        case 4:
        case GL_RGBA8:
        case GL_COMPRESSED_RGBA_S3TC_DXT1_EXT:
        case GL_COMPRESSED_RGBA_S3TC_DXT3_EXT:
        case GL_COMPRESSED_RGBA_S3TC_DXT5_EXT:
            return &kRgba8;
        case GL_RGB10_A2:
            return &kRgb10A2;
        case GL_DEPTH_COMPONENT16:
            return &kDepth16;
        case GL_DEPTH_COMPONENT:
            return choose_depth(client_type, swap_bytes);
        case GL_DEPTH_COMPONENT24:
        case GL_DEPTH_STENCIL:
        case GL_DEPTH24_STENCIL8:
            return &kDepth24;
        case GL_DEPTH_COMPONENT32:
            return &kDepth32;
        case GL_RGBA12:
        case GL_RGBA16:
            return &kRgba16;
        default:
            return nullptr;
    }
}

}  // namespace terrazzo::gl
