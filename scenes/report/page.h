// Stage: reports. The frame of our HTML pages: one file, no scripts from elsewhere, readable in light and
// dark.
#pragma once

#include <string>
#include <string_view>

namespace terrazzo::report {

std::string escaped(std::string_view text);
// Everything before and after a page's own content.
std::string page_head(std::string_view title);
std::string page_foot();

void write_text(const std::string& path, std::string_view text);  // throws std::runtime_error

}  // namespace terrazzo::report
