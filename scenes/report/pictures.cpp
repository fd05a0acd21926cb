// Stage: reports. What reports need of OpenImageIO, in terms of whole pictures.
#include "pictures.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace terrazzo::report {
namespace {

using OIIO::ImageBuf;
using OIIO::ImageSpec;
using OIIO::TypeDesc;
namespace algo = OIIO::ImageBufAlgo;

ImageBuf without_alpha(const ImageBuf& picture) {
    return picture.nchannels() > 3 ? algo::channels(picture, 3, {}) : picture;
}

ImageBuf fitted(const ImageBuf& picture, int largest) {
    if (picture.spec().width <= largest && picture.spec().height <= largest) return picture;
    const OIIO::ROI roi(0, largest, 0, largest, 0, 1, 0, picture.nchannels());
    return algo::fit(picture, "", 0, false, roi);
}

std::string base64(const std::vector<std::uint8_t>& bytes) {
    constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t word = 0;
        for (std::size_t k = 0; k < 3; ++k) word = word << 8 | (k < count ? bytes[i + k] : 0U);
        for (std::size_t k = 0; k < 4; ++k) text += k <= count ? kDigits[word >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

}  // namespace

ImageBuf picture_of(const std::vector<std::uint8_t>& bytes, int width, int height, int channels,
                    TypeDesc type) {
    const ImageSpec spec(width, height, channels, type);
    if (bytes.size() != spec.image_bytes()) throw std::runtime_error("a plane has the wrong size");
    ImageBuf bottom_up(spec);
    if (!bottom_up.set_pixels(OIIO::get_roi(spec), type, bytes.data()))
        throw std::runtime_error(bottom_up.geterror());
    return algo::flip(bottom_up);
}

ImageBuf magnified_difference(const ImageBuf& a, const ImageBuf& b, float factor) {
    ImageBuf difference = algo::mul(algo::absdiff(a, b), factor);
    if (difference.nchannels() < 4) return difference;
    const ImageBuf alpha = algo::channels(difference, 3, {3, 3, 3});
    return algo::clamp(algo::add(algo::channels(difference, 3, {}), alpha), 0.0F, 1.0F);
}

std::vector<std::uint8_t> png_of(const ImageBuf& picture, int largest) {
    ImageBuf flat = fitted(without_alpha(picture), largest);
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput target(bytes);
    const auto output = OIIO::ImageOutput::create("picture.png", &target);
    if (!output) throw std::runtime_error(OIIO::geterror());
    ImageSpec spec = flat.spec();
    spec.set_format(TypeDesc::UINT8);
    if (!output->open("picture.png", spec)) throw std::runtime_error(output->geterror());
    if (!flat.write(output.get())) throw std::runtime_error(flat.geterror());
    output->close();
    return bytes;
}

std::string png_data_uri(const ImageBuf& picture, int largest) {
    return "data:image/png;base64," + base64(png_of(picture, largest));
}

ImageBuf contact_sheet(const std::vector<ImageBuf>& pictures, int columns, int cell) {
    constexpr int kMargin = 6;
    const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
    const int pitch = cell + kMargin;
    ImageBuf sheet(ImageSpec(columns * pitch + kMargin, rows * pitch + kMargin, 3, TypeDesc::UINT8));
    algo::fill(sheet, {0.93F, 0.92F, 0.90F});
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const int x = kMargin + static_cast<int>(i) % columns * pitch;
        const int y = kMargin + static_cast<int>(i) / columns * pitch;
        algo::paste(sheet, x, y, 0, 0, fitted(without_alpha(pictures[i]), cell));
    }
    return sheet;
}

void check_picture_path(const std::string& path) {
    if (!OIIO::ImageOutput::create(path)) {
        OIIO::geterror();  // names every plug-in that was looked for
        throw std::runtime_error("cannot write " + path + ": its name ends in no known picture format");
    }
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    std::error_code error;
    if (!folder.empty() && !std::filesystem::is_directory(folder, error))
        throw std::runtime_error("cannot write " + path + ": there is no folder " + folder.string());
    if (std::filesystem::is_directory(path, error))
        throw std::runtime_error("cannot write " + path + ": it is a folder");
}

// A full disk is noticed by the stream; OpenImageIO's own files do not look.
void write_picture(const ImageBuf& picture, const std::string& path) {
    const ImageBuf flat = without_alpha(picture);
    const auto output = OIIO::ImageOutput::create(path);
    if (!output) throw std::runtime_error("cannot write " + path + ": " + OIIO::geterror());
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput target(bytes);
    const bool through_memory = output->supports("ioproxy") && output->set_ioproxy(&target);
    if (!output->open(path, flat.spec()) || !flat.write(output.get()) || !output->close())
        throw std::runtime_error("cannot write " + path + ": " + output->geterror() + flat.geterror());
    if (!through_memory) return;
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) throw std::runtime_error("cannot write " + path);
}

}  // namespace terrazzo::report
