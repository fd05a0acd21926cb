// Objects that contexts created with a share partner have in common (GL 1.5 §5.4, §3.8.12; glXCreateContext).
//
// Contexts of one group may be current in different threads: every access to the maps holds `mutex`. Objects
// are shared_ptr, so one that is deleted or replaced stays alive for whoever is using it.
#pragma once

#include <mutex>

namespace terrazzo::gl {

struct ShareGroup {
    std::mutex mutex;
};

}  // namespace terrazzo::gl
