// In builds without windows there are neither EGL nor GLX.
#include "fuzz/window_system.h"

namespace terrazzo::fuzz {

std::unique_ptr<WindowSystem> make_egl(const Library&) {
    return nullptr;
}

std::unique_ptr<WindowSystem> make_glx(const Library&) {
    return nullptr;
}

}  // namespace terrazzo::fuzz
