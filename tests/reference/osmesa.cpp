// Loading of the reference library; see osmesa.h.

#include "osmesa.h"

#include <dlfcn.h>

#include <cstdlib>

namespace terrazzo::test {

namespace {

constexpr const char* kReferenceVersion = "Mesa 22.3.6";  // doc/reference.md describes this one

}  // namespace

Osmesa::Osmesa(int width, int height, GLenum type) : m_pixels(static_cast<std::size_t>(width) * height * 4) {
    const char* override_path = std::getenv("TERRAZZO_REFERENCE_OSMESA");
    m_library = dlopen(override_path ? override_path : "libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
    if (!m_library) {
        m_missing = std::string("the reference library is missing: ") + dlerror();
        return;
    }
    m_context =
        find<decltype(OSMesaCreateContextExt)>("OSMesaCreateContextExt")(OSMESA_RGBA, 24, 8, 0, nullptr);
    auto* make_current = find<decltype(OSMesaMakeCurrent)>("OSMesaMakeCurrent");
    if (!m_context || !make_current(m_context, m_pixels.data(), type, width, height)) {
        m_missing = "the reference library gave no context";
        return;
    }
    const auto* version = reinterpret_cast<const char*>(TERRAZZO_GL(*this, glGetString)(GL_VERSION));
    if (std::string(version ? version : "").find(kReferenceVersion) == std::string::npos)
        m_missing = std::string("the reference library is not ") + kReferenceVersion + " but " +
                    (version ? version : "?");
}

// The library stays loaded: its compiler does not survive being unloaded.
Osmesa::~Osmesa() {
    if (m_context) find<decltype(OSMesaDestroyContext)>("OSMesaDestroyContext")(m_context);
}

void* Osmesa::symbol(const char* name) const {
    return dlsym(m_library, name);
}

}  // namespace terrazzo::test
