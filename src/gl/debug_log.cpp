// The debug log on stderr; see debug_log.h. One write per line, so lines of several threads do not mix.
#include "gl/debug_log.h"

#include <cstdio>
#include <cstring>

#include "simd/environment.h"

namespace terrazzo::gl {

bool debug_enabled() {
    static const bool enabled = [] {
        const char* value = setting("TERRAZZO_DEBUG");
        return value && *value && std::strcmp(value, "0") != 0;
    }();
    return enabled;
}

void debug_log(const char* command, const char* message) {
    if (debug_enabled()) [[unlikely]]
        std::fprintf(stderr, "terrazzo: %s: %s\n", command, message);
}

}  // namespace terrazzo::gl
