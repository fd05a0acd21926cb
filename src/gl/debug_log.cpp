// The debug log on stderr; see debug_log.h. One write per line, so lines of several threads do not mix.
#include "gl/debug_log.h"

#include <cstdio>

#include "simd/environment.h"

namespace terrazzo::gl {

bool debug_enabled() {
    return debug_wishes().errors;
}

void debug_log(const char* command, const char* message) {
    if (debug_enabled()) [[unlikely]]
        std::fprintf(stderr, "terrazzo: %s: %s\n", command, message);
}

}  // namespace terrazzo::gl
