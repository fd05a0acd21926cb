// The table of EGL's functions; see procs.h.
#include "frontends/egl/procs.h"

#include <EGL/eglext.h>

#include <algorithm>
#include <cstring>
#include <iterator>

#include "frontends/egl/glvnd_calls.h"
#include "gl/entry.h"

namespace terrazzo::egl {
namespace {

template <auto kFunction>
Procedure core(const char* name) {
    return {name, reinterpret_cast<Function>(kFunction)};
}

template <auto kFunction, Owner kOwner = Owner::kDisplay>
Procedure extension(const char* name) {
    using Call = VendorCall<kFunction, kOwner>;
    return {name, reinterpret_cast<Function>(kFunction), reinterpret_cast<Function>(&Call::call),
            &Call::index};
}

const Procedure kProcedures[] = {
    core<eglBindAPI>("eglBindAPI"),
    core<eglBindTexImage>("eglBindTexImage"),
    core<eglChooseConfig>("eglChooseConfig"),
    core<eglClientWaitSync>("eglClientWaitSync"),
    core<eglCopyBuffers>("eglCopyBuffers"),
    core<eglCreateContext>("eglCreateContext"),
    core<eglCreateImage>("eglCreateImage"),
    core<eglCreatePbufferFromClientBuffer>("eglCreatePbufferFromClientBuffer"),
    core<eglCreatePbufferSurface>("eglCreatePbufferSurface"),
    core<eglCreatePixmapSurface>("eglCreatePixmapSurface"),
    core<eglCreatePlatformPixmapSurface>("eglCreatePlatformPixmapSurface"),
    core<eglCreatePlatformWindowSurface>("eglCreatePlatformWindowSurface"),
    core<eglCreateSync>("eglCreateSync"),
    core<eglCreateWindowSurface>("eglCreateWindowSurface"),
    core<eglDestroyContext>("eglDestroyContext"),
    core<eglDestroyImage>("eglDestroyImage"),
    core<eglDestroySurface>("eglDestroySurface"),
    core<eglDestroySync>("eglDestroySync"),
    core<eglGetConfigAttrib>("eglGetConfigAttrib"),
    core<eglGetConfigs>("eglGetConfigs"),
    core<eglGetCurrentContext>("eglGetCurrentContext"),
    core<eglGetCurrentDisplay>("eglGetCurrentDisplay"),
    core<eglGetCurrentSurface>("eglGetCurrentSurface"),
    core<eglGetDisplay>("eglGetDisplay"),
    core<eglGetError>("eglGetError"),
    core<eglGetPlatformDisplay>("eglGetPlatformDisplay"),
    core<eglGetProcAddress>("eglGetProcAddress"),
    core<eglGetSyncAttrib>("eglGetSyncAttrib"),
    core<eglInitialize>("eglInitialize"),
    core<eglMakeCurrent>("eglMakeCurrent"),
    core<eglQueryAPI>("eglQueryAPI"),
    core<eglQueryContext>("eglQueryContext"),
    core<eglQueryString>("eglQueryString"),
    core<eglQuerySurface>("eglQuerySurface"),
    core<eglReleaseTexImage>("eglReleaseTexImage"),
    core<eglReleaseThread>("eglReleaseThread"),
    core<eglSurfaceAttrib>("eglSurfaceAttrib"),
    core<eglSwapBuffers>("eglSwapBuffers"),
    core<eglSwapInterval>("eglSwapInterval"),
    core<eglTerminate>("eglTerminate"),
    core<eglWaitClient>("eglWaitClient"),
    core<eglWaitGL>("eglWaitGL"),
    core<eglWaitNative>("eglWaitNative"),
    core<eglWaitSync>("eglWaitSync"),
    // Client extensions, which libglvnd knows.
    core<eglGetPlatformDisplayEXT>("eglGetPlatformDisplayEXT"),
    core<eglQueryDevicesEXT>("eglQueryDevicesEXT"),
    core<eglQueryDisplayAttribEXT>("eglQueryDisplayAttribEXT"),

    extension<eglClientWaitSyncKHR>("eglClientWaitSyncKHR"),
    extension<eglCreatePlatformPixmapSurfaceEXT>("eglCreatePlatformPixmapSurfaceEXT"),
    extension<eglCreatePlatformWindowSurfaceEXT>("eglCreatePlatformWindowSurfaceEXT"),
    extension<eglCreateSyncKHR>("eglCreateSyncKHR"),
    extension<eglDestroySyncKHR>("eglDestroySyncKHR"),
    extension<eglGetSyncAttribKHR>("eglGetSyncAttribKHR"),
    extension<eglQueryDeviceAttribEXT, Owner::kDevice>("eglQueryDeviceAttribEXT"),
    extension<eglQueryDeviceStringEXT, Owner::kDevice>("eglQueryDeviceStringEXT"),
    extension<eglSwapBuffersWithDamageEXT>("eglSwapBuffersWithDamageEXT"),
    extension<eglSwapBuffersWithDamageKHR>("eglSwapBuffersWithDamageKHR"),
    extension<eglWaitSyncKHR>("eglWaitSyncKHR"),
};

}  // namespace

const Procedure* find_procedure(const char* name) {
    return window::find_procedure(kProcedures, name);
}

const char* client_extensions() {
    return "EGL_EXT_client_extensions EGL_EXT_device_base EGL_EXT_device_enumeration EGL_EXT_device_query "
           "EGL_EXT_platform_base EGL_EXT_platform_device EGL_EXT_platform_x11 EGL_EXT_platform_xcb "
           "EGL_KHR_client_get_all_proc_addresses EGL_KHR_platform_x11 EGL_MESA_platform_surfaceless";
}

const char* platform_extensions() {
    return "EGL_EXT_platform_device EGL_EXT_platform_x11 EGL_EXT_platform_xcb EGL_KHR_platform_x11 "
           "EGL_MESA_platform_surfaceless";
}

const char* display_extensions() {
    return "EGL_EXT_buffer_age EGL_EXT_swap_buffers_with_damage EGL_KHR_context_flush_control "
           "EGL_KHR_create_context "
           "EGL_KHR_create_context_no_error EGL_KHR_fence_sync EGL_KHR_get_all_proc_addresses "
           "EGL_KHR_no_config_context "
           "EGL_KHR_surfaceless_context EGL_KHR_swap_buffers_with_damage EGL_KHR_wait_sync "
           "EGL_MESA_configless_context";
}

}  // namespace terrazzo::egl

__eglMustCastToProperFunctionPointerType eglGetProcAddress(const char* name) {
    if (!name) return nullptr;
    if (const auto* procedure = terrazzo::egl::find_procedure(name)) return procedure->address;
    return terrazzo::gl::find_proc_address(name);
}
