// Terrazzo's library, but for two commands that it does not admit to have: one of OpenGL 1.4, one of an
// extension.
#include <GL/osmesa.h>
#include <dlfcn.h>

#include <string_view>

// Used by name, so that the linker keeps the library it is in.
extern "C" decltype(&OSMesaGetCurrentContext) forgetful_partner;
decltype(&OSMesaGetCurrentContext) forgetful_partner = &OSMesaGetCurrentContext;

extern "C" OSMESAproc OSMesaGetProcAddress(const char* name) {
    static const auto next =
        reinterpret_cast<OSMESAproc (*)(const char*)>(dlsym(RTLD_NEXT, "OSMesaGetProcAddress"));
    const std::string_view asked = name;
    return asked == "glFogCoordf" || asked == "glBlitFramebuffer" ? nullptr : next(name);
}
