// Stage: piglit-lite, a drawing's colour buffer as a picture, and what of it is background.
#include "pixels.h"

#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "report/pictures.h"

namespace terrazzo::piglit {
namespace {

using OIIO::TypeDesc;

TypeDesc channel_type(GLenum type) {
    return type == GL_FLOAT            ? TypeDesc::FLOAT
           : type == GL_UNSIGNED_SHORT ? TypeDesc::UINT16
                                       : TypeDesc::UINT8;
}

std::vector<std::uint8_t> expanded_565(const std::vector<std::uint8_t>& bytes) {
    std::vector<std::uint8_t> rgb;
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        std::uint16_t pixel = 0;
        std::memcpy(&pixel, &bytes[i], sizeof pixel);
        rgb.push_back(static_cast<std::uint8_t>((pixel >> 11) * 255 / 31));
        rgb.push_back(static_cast<std::uint8_t>((pixel >> 5 & 63) * 255 / 63));
        rgb.push_back(static_cast<std::uint8_t>((pixel & 31) * 255 / 31));
    }
    return rgb;
}

// Drops what a row longer than the picture carries past its end.
std::vector<std::uint8_t> tight_rows(const Scene& scene, const std::vector<std::uint8_t>& bytes) {
    const kit::ContextOptions& context = scene.context;
    if (context.row_length == 0 || context.row_length == context.width) return bytes;
    const std::size_t pitch = bytes.size() / static_cast<std::size_t>(context.height);
    const std::size_t row =
        pitch * static_cast<std::size_t>(context.width) / static_cast<std::size_t>(context.row_length);
    std::vector<std::uint8_t> tight;
    for (std::size_t y = 0; y < static_cast<std::size_t>(context.height); ++y)
        tight.insert(tight.end(), bytes.begin() + static_cast<std::ptrdiff_t>(y * pitch),
                     bytes.begin() + static_cast<std::ptrdiff_t>(y * pitch + row));
    return tight;
}

OIIO::ImageBuf reordered(const OIIO::ImageBuf& picture, GLenum format) {
    if (format == OSMESA_BGRA) return OIIO::ImageBufAlgo::channels(picture, 4, {2, 1, 0, 3});
    if (format == OSMESA_ARGB) return OIIO::ImageBufAlgo::channels(picture, 4, {1, 2, 3, 0});
    return picture;
}

// The background as the picture's own type rounds it.
std::array<float, 4> background(const Scene& scene) {
    std::array<float, 4> colour;
    for (std::size_t i = 0; i < 4; ++i)
        colour[i] = scene.context.type == GL_FLOAT ? kBackground[i] : std::round(kBackground[i] * 255) / 255;
    return colour;
}

// All channels as floats 0..1, whatever the picture's type.
std::vector<float> floats_of(const OIIO::ImageBuf& picture) {
    std::vector<float> values(picture.spec().image_pixels() * static_cast<std::size_t>(picture.nchannels()));
    picture.get_pixels(picture.roi(), TypeDesc::FLOAT, values.data());
    return values;
}

bool is_background(const float* pixel, const std::array<float, 4>& colour, std::size_t channels,
                   float threshold) {
    for (std::size_t channel = 0; channel < channels; ++channel)
        if (std::abs(pixel[channel] - colour[channel]) > threshold) return false;
    return true;
}

}  // namespace

OIIO::ImageBuf colour_picture(const Scene& scene, const Drawing& drawing) {
    const kit::ContextOptions& context = scene.context;
    std::vector<std::uint8_t> bytes = tight_rows(scene, drawing.colour);
    const bool three = drawing.format == OSMESA_RGB || drawing.format == OSMESA_RGB_565;
    if (context.type == GL_UNSIGNED_SHORT_5_6_5) bytes = expanded_565(bytes);
    const TypeDesc type =
        context.type == GL_UNSIGNED_SHORT_5_6_5 ? TypeDesc::UINT8 : channel_type(context.type);
    OIIO::ImageBuf picture = report::picture_of(bytes, context.width, context.height, three ? 3 : 4, type);
    if (!context.y_up) picture = OIIO::ImageBufAlgo::flip(picture);
    // A reference drawn in RGBA for a scene in RGB has an alpha that the scene does not compare.
    if (scene.reference_in_rgba && !three) return OIIO::ImageBufAlgo::channels(picture, 3, {});
    return reordered(picture, drawing.format);
}

OIIO::ImageBuf depth_picture(const Scene& scene, const Drawing& drawing) {
    const auto [nearest, farthest] = std::minmax_element(drawing.depth.begin(), drawing.depth.end());
    std::vector<std::uint8_t> tones;
    for (const std::uint32_t depth : drawing.depth) {
        const double range = std::max(1.0, static_cast<double>(*farthest - *nearest));
        const auto tone =
            static_cast<std::uint8_t>(255 - 255 * (static_cast<double>(depth - *nearest) / range));
        tones.insert(tones.end(), 3, tone);
    }
    return report::picture_of(tones, scene.context.width, scene.context.height, 3);
}

OIIO::ImageBuf stencil_picture(const Scene& scene, const Drawing& drawing) {
    std::vector<std::uint8_t> tones;
    for (const std::uint8_t value : drawing.stencil)
        for (const int factor : {37, 91, 151}) tones.push_back(static_cast<std::uint8_t>(value * factor));
    return report::picture_of(tones, scene.context.width, scene.context.height, 3);
}

std::size_t coverage_difference(const Scene& scene, const OIIO::ImageBuf& a, const OIIO::ImageBuf& b,
                                float threshold) {
    const std::array<float, 4> colour = background(scene);
    const auto channels = static_cast<std::size_t>(std::min(4, a.nchannels()));
    const std::vector<float> in_a = floats_of(a), in_b = floats_of(b);
    // Exactly background in one (to the rounding of the buffer's type), clearly something else in the other.
    constexpr float kExact = 0.2F / 255;
    std::size_t count = 0;
    for (std::size_t i = 0; i < std::min(in_a.size(), in_b.size()); i += channels) {
        const auto only = [&](const float* drawn, const float* empty) {
            return is_background(empty, colour, channels, kExact) &&
                   !is_background(drawn, colour, channels, threshold);
        };
        if (only(&in_a[i], &in_b[i]) || only(&in_b[i], &in_a[i])) ++count;
    }
    return count;
}

bool is_blank(const Scene& scene, const Drawing& drawing) {
    const OIIO::ImageBuf picture = colour_picture(scene, drawing);
    const auto channels = static_cast<std::size_t>(std::min(4, picture.nchannels()));
    const std::vector<float> values = floats_of(picture);
    const std::array<float, 4> colour = background(scene);
    constexpr float kStep = 1.5F / 255;
    for (std::size_t i = 0; i < values.size(); i += channels)
        if (!is_background(&values[i], colour, channels, kStep)) return false;
    return true;
}

}  // namespace terrazzo::piglit
