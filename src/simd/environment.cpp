// See environment.h.
#include "simd/environment.h"

#include <cstdlib>

namespace terrazzo {

const char* setting(const char* name) {
    return secure_getenv(name);
}

}  // namespace terrazzo
