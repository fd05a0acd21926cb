// Terrazzo's library, but for two commands that it does not admit to have: one of OpenGL 1.4, one of an
// extension.
#include <GL/osmesa.h>
#include <dlfcn.h>

#include <string_view>

extern "C" OSMESAproc OSMesaGetProcAddress(const char* name) {
    static const auto next =
        reinterpret_cast<OSMESAproc (*)(const char*)>(dlsym(RTLD_NEXT, "OSMesaGetProcAddress"));
    const std::string_view asked = name;
    return asked == "glFogCoordf" || asked == "glBlitFramebuffer" ? nullptr : next(name);
}
