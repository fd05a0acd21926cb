// Stage: reports. Pixels from GL (rows from the bottom) <-> OpenImageIO pictures (rows from the top).
// Input: raw planes. Output: PNG bytes, magnified differences, contact sheets.
#pragma once

#include <OpenImageIO/imagebuf.h>

#include <cstdint>
#include <string>
#include <vector>

namespace terrazzo::report {

// Copies; throws std::runtime_error when `bytes` is not width * height * channels values of `type`.
OIIO::ImageBuf picture_of(const std::vector<std::uint8_t>& bytes, int width, int height, int channels,
                          OIIO::TypeDesc type = OIIO::TypeDesc::UINT8);

// |a - b| times `factor` over the colour channels; alpha's difference is added in, so that it shows too.
OIIO::ImageBuf magnified_difference(const OIIO::ImageBuf& a, const OIIO::ImageBuf& b, float factor);

// Colour without alpha, at most `largest` pixels wide, as a PNG file's bytes.
std::vector<std::uint8_t> png_of(const OIIO::ImageBuf& picture, int largest = 1 << 14);
std::string png_data_uri(const OIIO::ImageBuf& picture, int largest = 1 << 14);

// A grid of equal cells with a margin between them.
OIIO::ImageBuf contact_sheet(const std::vector<OIIO::ImageBuf>& pictures, int columns, int cell);

// Throws std::runtime_error, in words, when no picture can be written there: by its format or its folder.
void check_picture_path(const std::string& path);
void write_picture(const OIIO::ImageBuf& picture, const std::string& path);

}  // namespace terrazzo::report
