// OSMesa's formats and types; see formats.h. Which pairs exist and in which order the components lie follows
// Mesa 22.3: 16-bit and float buffers are red first, whatever the format says of bytes.
#include "frontends/osmesa/formats.h"

#include <GL/osmesa.h>

namespace terrazzo::osmesa {
namespace {

using raster::PixelLayout;

std::optional<PixelLayout> byte_layout(int format) {
    switch (format) {
        case OSMESA_RGBA:
            return PixelLayout::kRgba8;
        case OSMESA_BGRA:
            return PixelLayout::kBgra8;
        case OSMESA_ARGB:
            return PixelLayout::kArgb8;
        case OSMESA_RGB:
            return PixelLayout::kRgb8;
        default:
            return std::nullopt;
    }
}

std::optional<PixelLayout> wide_layout(int format, PixelLayout with_alpha, PixelLayout without_alpha) {
    if (!byte_layout(format)) return std::nullopt;
    return format == OSMESA_RGB ? without_alpha : with_alpha;
}

}  // namespace

bool is_format(int format) {
    switch (format) {
        case OSMESA_COLOR_INDEX:
        case OSMESA_RGBA:
        case OSMESA_BGRA:
        case OSMESA_ARGB:
        case OSMESA_RGB:
        case OSMESA_BGR:
        case OSMESA_RGB_565:
            return true;
        default:
            return false;
    }
}

std::optional<PixelLayout> pixel_layout(int format, GLenum type) {
    switch (type) {
        case GL_UNSIGNED_BYTE:
            return byte_layout(format);
        case GL_UNSIGNED_SHORT:
            return wide_layout(format, PixelLayout::kRgba16, PixelLayout::kRgb16);
        case GL_FLOAT:
            return wide_layout(format, PixelLayout::kRgba32F, PixelLayout::kRgb32F);
        case GL_UNSIGNED_SHORT_5_6_5:
            return format == OSMESA_RGB_565 ? std::optional(PixelLayout::kRgb565) : std::nullopt;
        default:
            return std::nullopt;
    }
}

}  // namespace terrazzo::osmesa
