// Stage: reports. Pictures inside our HTML pages. Input: OpenImageIO pictures. Output: HTML.
#pragma once

#include <OpenImageIO/imagebuf.h>

#include <optional>
#include <string>
#include <string_view>

namespace terrazzo::report {

// How much differences are magnified: one step of 255 becomes a visible tone, eight become white.
inline constexpr float kMagnification = 32;

// At most 512 pixels wide.
std::string figure(const OIIO::ImageBuf& picture, std::string_view caption);

// A picture of each library and, where there are two of one size, their difference.
using OptionalPicture = std::optional<OIIO::ImageBuf>;
std::string comparison(const OptionalPicture& ours, std::string_view our_name, const OptionalPicture& theirs,
                       std::string_view their_name);

}  // namespace terrazzo::report
