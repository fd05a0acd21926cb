// OpenImageIO decodes; which of its readers does is decided by the bytes, so that no other ever sees them.
#include "images.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstring>

#include "notes.h"

namespace terrazzo::gltf {
namespace {

// A progressive JPEG goes over all its pixels once a scan, and a scan may be a few bytes.
constexpr std::size_t kMostScans = 64;
// However small, an image costs its decoder and a texture.
constexpr std::size_t kPixelsOfAnImage = 4096;

bool starts_with(std::span<const unsigned char> bytes, std::initializer_list<unsigned char> magic) {
    return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
}

const char* format_of(std::span<const unsigned char> bytes) {
    if (starts_with(bytes, {0x89, 'P', 'N', 'G'})) return "png";
    if (starts_with(bytes, {0xFF, 0xD8, 0xFF})) return "jpeg";
    refuse("it is neither PNG nor JPEG");
}

void check_scans(std::span<const unsigned char> bytes) {
    std::size_t scans = 0;
    for (std::size_t i = 0; i + 1 < bytes.size(); ++i) scans += bytes[i] == 0xFF && bytes[i + 1] == 0xDA;
    if (scans > kMostScans) refuse("it is a JPEG of too many scans");
}

Level as_rgba(const std::vector<std::uint8_t>& source, int width, int height, int channels) {
    Level level{width, height, {}};
    const auto step = static_cast<std::size_t>(channels);
    const std::size_t pixels = source.size() / step;
    level.rgba.resize(pixels * 4);
    for (std::size_t i = 0; i < pixels; ++i) {
        const std::uint8_t* from = &source[i * step];
        std::uint8_t* to = &level.rgba[i * 4];
        for (std::size_t c = 0; c < 3; ++c) to[c] = from[step >= 3 ? c : 0];
        to[3] = step == 4 ? from[3] : step == 2 ? from[1] : 255;
    }
    return level;
}

// What one pixel of a smaller level covers of a larger one's row or column.
struct Cover {
    int first;
    int count;                 // 1 to 3
    std::uint32_t weights[3];  // of the pixels
};

// `larger` pixels become `smaller`, half as many rounded down (or one stays one). In units in which a pixel
// of the larger level is `smaller` long and one of the smaller level `larger`.
Cover cover_of(int index, int larger, int smaller) {
    const std::int64_t from = std::int64_t{index} * larger, to = from + larger, step = smaller;
    Cover cover{static_cast<int>(from / step), 0, {}};
    for (std::int64_t pixel = cover.first; pixel * step < to; ++pixel)
        cover.weights[cover.count++] =
            static_cast<std::uint32_t>(std::min(to, (pixel + 1) * step) - std::max(from, pixel * step));
    return cover;
}

void average(const Level& larger, const Cover& across, const Cover& down, std::uint8_t* to) {
    std::uint64_t weight = 0, alpha = 0, plain[3] = {}, weighted[3] = {};
    for (int y = 0; y < down.count; ++y)
        for (int x = 0; x < across.count; ++x) {
            const std::size_t pixel =
                static_cast<std::size_t>(down.first + y) * static_cast<std::size_t>(larger.width) +
                static_cast<std::size_t>(across.first + x);
            const std::uint8_t* from = &larger.rgba[pixel * 4];
            const std::uint64_t area = std::uint64_t{across.weights[x]} * down.weights[y];
            weight += area;
            alpha += area * from[3];
            for (std::size_t c = 0; c < 3; ++c) {
                plain[c] += area * from[c];
                weighted[c] += area * from[3] * from[c];
            }
        }
    // Where nothing is to be seen the colours still count for what interpolation makes of them.
    for (std::size_t c = 0; c < 3; ++c)
        to[c] = static_cast<std::uint8_t>(alpha > 0 ? (weighted[c] + alpha / 2) / alpha
                                                    : (plain[c] + weight / 2) / weight);
    to[3] = static_cast<std::uint8_t>((alpha + weight / 2) / weight);
}

Level half_of(const Level& larger) {
    Level smaller{std::max(1, larger.width / 2), std::max(1, larger.height / 2), {}};
    const auto width = static_cast<std::size_t>(smaller.width);
    smaller.rgba.resize(width * static_cast<std::size_t>(smaller.height) * 4);
    std::vector<Cover> across;
    for (int x = 0; x < smaller.width; ++x) across.push_back(cover_of(x, larger.width, smaller.width));
    for (int y = 0; y < smaller.height; ++y) {
        const Cover down = cover_of(y, larger.height, smaller.height);
        std::uint8_t* row = &smaller.rgba[static_cast<std::size_t>(y) * width * 4];
        for (std::size_t x = 0; x < width; ++x) average(larger, across[x], down, row + x * 4);
    }
    return smaller;
}

}  // namespace

Level decode_image(std::span<const unsigned char> bytes, Budget& pixels) {
    pixels.spend(kPixelsOfAnImage);
    const std::string format = format_of(bytes);
    if (format == "jpeg") check_scans(bytes);
    OIIO::Filesystem::IOMemReader reader(const_cast<unsigned char*>(bytes.data()), bytes.size());
    const auto input = OIIO::ImageInput::create(format);
    if (!input || !input->set_ioproxy(&reader)) refuse(OIIO::geterror());
    OIIO::ImageSpec wishes, spec;
    wishes["oiio:UnassociatedAlpha"] = 1;  // colours as they are in the file
    if (!input->open("image." + format, spec, wishes)) refuse(input->geterror());
    if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0 || spec.nchannels > 4)
        refuse("it has no pixels, or pixels of more than four channels");
    const auto count = static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height);
    pixels.spend(count - std::min<std::uint64_t>(count, kPixelsOfAnImage));
    std::vector<std::uint8_t> source(count * static_cast<std::size_t>(spec.nchannels));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, source.data()))
        refuse(input->geterror());
    return as_rgba(source, spec.width, spec.height, spec.nchannels);
}

void add_smaller_levels(std::vector<Level>& levels) {
    while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(half_of(levels.back()));
}

Level reduced_to(Level level, int largest) {
    while (level.width > largest || level.height > largest) level = half_of(level);
    return level;
}

}  // namespace terrazzo::gltf
