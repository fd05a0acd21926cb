// libglvnd's door: the one function it looks for in a vendor library (libEGL_terrazzo.so.0), and the stubs
// for functions of extensions, which find out from the display which vendor is meant.
#include <glvnd/libeglabi.h>

#include "frontends/egl/display.h"
#include "frontends/egl/glvnd_calls.h"
#include "frontends/egl/procs.h"

namespace egl = terrazzo::egl;

namespace terrazzo::egl {

const __EGLapiExports* glvnd = nullptr;

}  // namespace terrazzo::egl

namespace {

EGLDisplay platform_display(EGLenum platform, void* native, const EGLAttrib* attributes) {
    return eglGetPlatformDisplay(platform, native, attributes);
}

EGLBoolean supports_api(EGLenum api) {
    return api == EGL_OPENGL_API;
}

const char* vendor_string(int name) {
    return name == __EGL_VENDOR_STRING_PLATFORM_EXTENSIONS ? egl::platform_extensions() : nullptr;
}

void* proc_address(const char* name) {
    return reinterpret_cast<void*>(eglGetProcAddress(name));
}

void* dispatch_address(const char* name) {
    const egl::Procedure* procedure = egl::find_procedure(name);
    return procedure ? reinterpret_cast<void*>(procedure->dispatch) : nullptr;
}

void set_dispatch_index(const char* name, int index) {
    const egl::Procedure* procedure = egl::find_procedure(name);
    if (procedure && procedure->dispatch_index) *procedure->dispatch_index = index;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) EGLBoolean __egl_Main(uint32_t version,
                                                                        const __EGLapiExports* exports,
                                                                        __EGLvendorInfo*,
                                                                        __EGLapiImports* imports) {
    if (EGL_VENDOR_ABI_GET_MAJOR_VERSION(version) != EGL_VENDOR_ABI_MAJOR_VERSION) return EGL_FALSE;
    egl::glvnd = exports;
    imports->getPlatformDisplay = platform_display;
    imports->getSupportsAPI = supports_api;
    imports->getVendorString = vendor_string;
    imports->getProcAddress = proc_address;
    imports->getDispatchAddress = dispatch_address;
    imports->setDispatchIndex = set_dispatch_index;
    return EGL_TRUE;
}
