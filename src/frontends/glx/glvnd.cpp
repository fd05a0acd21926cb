// libglvnd's door: the one function it looks for in a vendor library (libGLX_terrazzo.so.0).
#include <glvnd/libglxabi.h>

#include "frontends/glx/display.h"
#include "frontends/glx/procs.h"

namespace glx = terrazzo::glx;

namespace {

const glx::Procedure* find(const GLubyte* name) {
    return glx::find_procedure(reinterpret_cast<const char*>(name));
}

// A screen with a visual that we can draw for.
Bool is_screen_supported(Display* display, int screen) try {
    const auto state = glx::registry().display(display);
    return screen >= 0 && static_cast<std::size_t>(screen) < state->configs.size() &&
           !state->configs[static_cast<std::size_t>(screen)].empty();
} catch (...) {
    return False;
}

void* proc_address(const GLubyte* name) {
    return reinterpret_cast<void*>(glXGetProcAddress(name));
}

void* dispatch_address(const GLubyte* name) {
    const glx::Procedure* procedure = find(name);
    return procedure ? reinterpret_cast<void*>(procedure->dispatch) : nullptr;
}

void set_dispatch_index(const GLubyte* name, int index) {
    const glx::Procedure* procedure = find(name);
    if (procedure && procedure->dispatch_index) *procedure->dispatch_index = index;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) Bool __glx_Main(uint32_t version,
                                                                  const __GLXapiExports* exports,
                                                                  __GLXvendorInfo*,
                                                                  __GLXapiImports* imports) {
    // Minor versions add to the end; we use what the first one has.
    if (GLX_VENDOR_ABI_GET_MAJOR_VERSION(version) != GLX_VENDOR_ABI_MAJOR_VERSION) return False;
    glx::glvnd = exports;
    imports->isScreenSupported = is_screen_supported;
    imports->getProcAddress = proc_address;
    imports->getDispatchAddress = dispatch_address;
    imports->setDispatchIndex = set_dispatch_index;
    return True;
}
