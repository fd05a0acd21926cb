// See environment.h.
#include "simd/environment.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace terrazzo {

const char* setting(const char* name) {
    return secure_getenv(name);
}

DebugWishes parse_debug_wishes(const char* text) {
    DebugWishes wishes;
    std::string_view rest = text ? text : "";
    while (!rest.empty()) {
        const std::string_view word = rest.substr(0, rest.find(','));
        rest.remove_prefix(std::min(rest.size(), word.size() + 1));
        if (word == "stages") {
            wishes.stages = true;
        } else if (!word.empty() && word != "0") {
            wishes.errors = true;
        }
    }
    return wishes;
}

const DebugWishes& debug_wishes() {
    static const DebugWishes wishes = parse_debug_wishes(setting("TERRAZZO_DEBUG"));
    return wishes;
}

}  // namespace terrazzo
