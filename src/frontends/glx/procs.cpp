// The table of GLX's functions; see procs.h.
#include "frontends/glx/procs.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <iterator>

#include "gl/entry.h"
#include "gl/generated/dispatch.h"
#include "gl/strings.h"

namespace terrazzo::glx {

const __GLXapiExports* glvnd = nullptr;

namespace {

template <auto kFunction>
Procedure core(const char* name) {
    return {name, reinterpret_cast<Function>(kFunction)};
}

template <auto kFunction, Owner kOwner, Makes kMakes = Makes::kNothing>
Procedure extension(const char* name) {
    using Call = VendorCall<kFunction, kOwner, kMakes>;
    return {name, reinterpret_cast<Function>(kFunction), reinterpret_cast<Function>(&Call::call),
            &Call::index};
}

const Procedure kProcedures[] = {
    core<glXChooseFBConfig>("glXChooseFBConfig"),
    core<glXChooseVisual>("glXChooseVisual"),
    core<glXCopyContext>("glXCopyContext"),
    core<glXCreateContext>("glXCreateContext"),
    core<glXCreateGLXPixmap>("glXCreateGLXPixmap"),
    core<glXCreateNewContext>("glXCreateNewContext"),
    core<glXCreatePbuffer>("glXCreatePbuffer"),
    core<glXCreatePixmap>("glXCreatePixmap"),
    core<glXCreateWindow>("glXCreateWindow"),
    core<glXDestroyContext>("glXDestroyContext"),
    core<glXDestroyGLXPixmap>("glXDestroyGLXPixmap"),
    core<glXDestroyPbuffer>("glXDestroyPbuffer"),
    core<glXDestroyPixmap>("glXDestroyPixmap"),
    core<glXDestroyWindow>("glXDestroyWindow"),
    core<glXGetClientString>("glXGetClientString"),
    core<glXGetConfig>("glXGetConfig"),
    core<glXGetCurrentContext>("glXGetCurrentContext"),
    core<glXGetCurrentDisplay>("glXGetCurrentDisplay"),
    core<glXGetCurrentDrawable>("glXGetCurrentDrawable"),
    core<glXGetCurrentReadDrawable>("glXGetCurrentReadDrawable"),
    core<glXGetFBConfigAttrib>("glXGetFBConfigAttrib"),
    core<glXGetFBConfigs>("glXGetFBConfigs"),
    core<glXGetProcAddress>("glXGetProcAddress"),
    core<glXGetProcAddressARB>("glXGetProcAddressARB"),
    core<glXGetSelectedEvent>("glXGetSelectedEvent"),
    core<glXGetVisualFromFBConfig>("glXGetVisualFromFBConfig"),
    core<glXIsDirect>("glXIsDirect"),
    core<glXMakeContextCurrent>("glXMakeContextCurrent"),
    core<glXMakeCurrent>("glXMakeCurrent"),
    core<glXQueryContext>("glXQueryContext"),
    core<glXQueryDrawable>("glXQueryDrawable"),
    core<glXQueryExtension>("glXQueryExtension"),
    core<glXQueryExtensionsString>("glXQueryExtensionsString"),
    core<glXQueryServerString>("glXQueryServerString"),
    core<glXQueryVersion>("glXQueryVersion"),
    core<glXSelectEvent>("glXSelectEvent"),
    core<glXSwapBuffers>("glXSwapBuffers"),
    core<glXUseXFont>("glXUseXFont"),
    core<glXWaitGL>("glXWaitGL"),
    core<glXWaitX>("glXWaitX"),

    extension<glXBindTexImageEXT, Owner::kDrawable>("glXBindTexImageEXT"),
    extension<glXReleaseTexImageEXT, Owner::kDrawable>("glXReleaseTexImageEXT"),
    extension<glXChooseFBConfigSGIX, Owner::kScreen>("glXChooseFBConfigSGIX"),
    extension<glXCopySubBufferMESA, Owner::kDrawable>("glXCopySubBufferMESA"),
    extension<glXCreateContextAttribsARB, Owner::kConfig, Makes::kContext>("glXCreateContextAttribsARB"),
    extension<glXCreateContextWithConfigSGIX, Owner::kConfig, Makes::kContext>(
        "glXCreateContextWithConfigSGIX"),
    extension<glXCreateGLXPbufferSGIX, Owner::kConfig, Makes::kDrawable>("glXCreateGLXPbufferSGIX"),
    extension<glXCreateGLXPixmapWithConfigSGIX, Owner::kConfig, Makes::kDrawable>(
        "glXCreateGLXPixmapWithConfigSGIX"),
    extension<glXDestroyGLXPbufferSGIX, Owner::kDrawable>("glXDestroyGLXPbufferSGIX"),
    extension<glXGetCurrentDisplayEXT, Owner::kCurrent>("glXGetCurrentDisplayEXT"),
    extension<glXGetContextIDEXT, Owner::kContext>("glXGetContextIDEXT"),
    extension<glXGetCurrentReadDrawableSGI, Owner::kCurrent>("glXGetCurrentReadDrawableSGI"),
    extension<glXGetFBConfigAttribSGIX, Owner::kConfig>("glXGetFBConfigAttribSGIX"),
    extension<glXGetFBConfigFromVisualSGIX, Owner::kVisual>("glXGetFBConfigFromVisualSGIX"),
    extension<glXGetMscRateOML, Owner::kDrawable>("glXGetMscRateOML"),
    extension<glXGetSelectedEventSGIX, Owner::kDrawable>("glXGetSelectedEventSGIX"),
    extension<glXGetSwapIntervalMESA, Owner::kCurrent>("glXGetSwapIntervalMESA"),
    extension<glXGetSyncValuesOML, Owner::kDrawable>("glXGetSyncValuesOML"),
    extension<glXGetVideoSyncSGI, Owner::kCurrent>("glXGetVideoSyncSGI"),
    extension<glXGetVisualFromFBConfigSGIX, Owner::kConfig>("glXGetVisualFromFBConfigSGIX"),
    extension<glXMakeCurrentReadSGI, Owner::kDrawable>("glXMakeCurrentReadSGI"),
    extension<glXQueryCurrentRendererIntegerMESA, Owner::kCurrent>("glXQueryCurrentRendererIntegerMESA"),
    extension<glXQueryCurrentRendererStringMESA, Owner::kCurrent>("glXQueryCurrentRendererStringMESA"),
    extension<glXQueryGLXPbufferSGIX, Owner::kDrawable>("glXQueryGLXPbufferSGIX"),
    extension<glXQueryRendererIntegerMESA, Owner::kScreen>("glXQueryRendererIntegerMESA"),
    extension<glXQueryRendererStringMESA, Owner::kScreen>("glXQueryRendererStringMESA"),
    extension<glXSelectEventSGIX, Owner::kDrawable>("glXSelectEventSGIX"),
    extension<glXSwapBuffersMscOML, Owner::kDrawable>("glXSwapBuffersMscOML"),
    extension<glXSwapIntervalEXT, Owner::kDrawable>("glXSwapIntervalEXT"),
    extension<glXSwapIntervalMESA, Owner::kCurrent>("glXSwapIntervalMESA"),
    extension<glXSwapIntervalSGI, Owner::kCurrent>("glXSwapIntervalSGI"),
    extension<glXWaitForMscOML, Owner::kDrawable>("glXWaitForMscOML"),
    extension<glXWaitForSbcOML, Owner::kDrawable>("glXWaitForSbcOML"),
    extension<glXWaitVideoSyncSGI, Owner::kCurrent>("glXWaitVideoSyncSGI"),
};

}  // namespace

const Procedure* find_procedure(const char* name) {
    return window::find_procedure(kProcedures, name);
}

const char* extensions() {
    return "GLX_ARB_context_flush_control GLX_ARB_create_context GLX_ARB_create_context_no_error "
           "GLX_ARB_create_context_profile GLX_ARB_create_context_robustness GLX_ARB_get_proc_address "
           "GLX_ARB_multisample "
           "GLX_EXT_buffer_age GLX_EXT_no_config_context GLX_EXT_swap_control GLX_EXT_texture_from_pixmap "
           "GLX_EXT_visual_info GLX_EXT_visual_rating GLX_MESA_copy_sub_buffer GLX_MESA_query_renderer "
           "GLX_MESA_swap_control GLX_OML_sync_control GLX_SGIX_fbconfig GLX_SGIX_pbuffer "
           "GLX_SGIX_visual_select_group GLX_SGI_make_current_read GLX_SGI_swap_control GLX_SGI_video_sync";
}

bool renderer_integer(int attribute, unsigned* value) {
    switch (attribute) {
        case GLX_RENDERER_VENDOR_ID_MESA:
        case GLX_RENDERER_DEVICE_ID_MESA:
            *value = ~0u;  // no device of any bus
            return true;
        case GLX_RENDERER_VERSION_MESA:
            return std::sscanf(TERRAZZO_VERSION, "%u.%u.%u", &value[0], &value[1], &value[2]) == 3;
        case GLX_RENDERER_ACCELERATED_MESA:
            *value = False;
            return true;
        case GLX_RENDERER_VIDEO_MEMORY_MESA: {
            const auto bytes = static_cast<unsigned long long>(sysconf(_SC_PHYS_PAGES)) *
                               static_cast<unsigned long long>(sysconf(_SC_PAGESIZE));
            *value = static_cast<unsigned>(bytes >> 20);
            return true;
        }
        case GLX_RENDERER_UNIFIED_MEMORY_ARCHITECTURE_MESA:
            *value = True;
            return true;
        case GLX_RENDERER_PREFERRED_PROFILE_MESA:
            *value = GLX_CONTEXT_COMPATIBILITY_PROFILE_BIT_ARB;
            return true;
        case GLX_RENDERER_OPENGL_COMPATIBILITY_PROFILE_VERSION_MESA:
            value[0] = gl::kGlMajorVersion;
            value[1] = gl::kGlMinorVersion;
            return true;
        case GLX_RENDERER_OPENGL_CORE_PROFILE_VERSION_MESA:
        case GLX_RENDERER_OPENGL_ES_PROFILE_VERSION_MESA:
        case GLX_RENDERER_OPENGL_ES2_PROFILE_VERSION_MESA:
            value[0] = value[1] = 0;
            return true;
    }
    return false;
}

const char* renderer_string(int attribute) {
    if (attribute == GLX_RENDERER_VENDOR_ID_MESA) return gl::vendor_string();
    if (attribute == GLX_RENDERER_DEVICE_ID_MESA) return gl::renderer_string();
    return nullptr;
}

}  // namespace terrazzo::glx

namespace {

__GLXextFuncPtr find(const GLubyte* name) {
    const char* const text = reinterpret_cast<const char*>(name);
    if (!text) return nullptr;
    if (const auto* procedure = terrazzo::glx::find_procedure(text)) return procedure->address;
    return terrazzo::gl::find_proc_address(text);
}

}  // namespace

__GLXextFuncPtr glXGetProcAddress(const GLubyte* name) {
    return find(name);
}

__GLXextFuncPtr glXGetProcAddressARB(const GLubyte* name) {
    return find(name);
}
