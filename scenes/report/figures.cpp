// Stage: reports. Pictures inside our HTML pages.
#include "figures.h"

#include <fmt/core.h>

#include "page.h"
#include "pictures.h"

namespace terrazzo::report {
namespace {

constexpr int kLargest = 512;

bool of_one_size(const OIIO::ImageBuf& a, const OIIO::ImageBuf& b) {
    return a.spec().width == b.spec().width && a.spec().height == b.spec().height &&
           a.nchannels() == b.nchannels();
}

}  // namespace

std::string figure(const OIIO::ImageBuf& picture, std::string_view caption) {
    return fmt::format("<figure><img alt=\"{0}\" src=\"{1}\"><figcaption>{0}</figcaption></figure>\n",
                       escaped(caption), png_data_uri(picture, kLargest));
}

std::string comparison(const OptionalPicture& ours, std::string_view our_name, const OptionalPicture& theirs,
                       std::string_view their_name) {
    std::string html = "<div class=\"pictures large\">";
    if (ours) html += figure(*ours, our_name);
    if (theirs) html += figure(*theirs, their_name);
    if (ours && theirs && of_one_size(*ours, *theirs))
        html += figure(magnified_difference(*ours, *theirs, kMagnification),
                       fmt::format("difference x {:g}", kMagnification));
    return html + "</div>\n";
}

}  // namespace terrazzo::report
