// Configurations, strings, devices and errors (EGL 1.5 §3.1, §3.3, §3.4; EGL_EXT_device_base and its parts).
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <exception>

#include "frontends/egl/display.h"
#include "frontends/egl/procs.h"
#include "gl/strings.h"

namespace egl = terrazzo::egl;
namespace gl = terrazzo::gl;

namespace {

EGLBoolean to_client(const std::vector<const egl::Config*>& found, EGLConfig* configs, EGLint size,
                     EGLint* count) {
    if (!count) return egl::fail(EGL_BAD_PARAMETER);
    EGLint n = static_cast<EGLint>(found.size());
    if (configs) {
        n = std::clamp(size, 0, n);
        for (EGLint i = 0; i < n; ++i)
            configs[i] = const_cast<egl::Config*>(found[static_cast<std::size_t>(i)]);
    }
    *count = n;
    egl::set_error(EGL_SUCCESS);
    return EGL_TRUE;
}

}  // namespace

EGLint eglGetError() {
    return egl::take_error();
}

EGLBoolean eglGetConfigs(EGLDisplay handle, EGLConfig* configs, EGLint size, EGLint* count) try {
    egl::Display* const display = egl::initialized_display(handle);
    if (!display) return EGL_FALSE;
    const auto configs_there = egl::configs_of(*display);
    std::vector<const egl::Config*> all;
    for (const egl::Config& config : *configs_there) all.push_back(&config);
    return to_client(all, configs, size, count);
} catch (const std::exception&) {
    return egl::fail(EGL_BAD_ALLOC);
}

EGLBoolean eglChooseConfig(EGLDisplay handle, const EGLint* attributes, EGLConfig* configs, EGLint size,
                           EGLint* count) try {
    egl::Display* const display = egl::initialized_display(handle);
    if (!display) return EGL_FALSE;
    const auto configs_there = egl::configs_of(*display);
    egl::Choice choice = egl::choose(*configs_there, attributes);
    if (!choice.understood) return egl::fail(EGL_BAD_ATTRIBUTE);
    if (choice.pixmap) {
        const auto connection = egl::connection_of(*display);
        const auto pixmap =
            connection ? terrazzo::x11::geometry(connection->xcb, choice.pixmap) : std::nullopt;
        if (!pixmap) return egl::fail(EGL_BAD_ATTRIBUTE);
        std::erase_if(choice.configs, [&](const egl::Config* config) {
            return !config->visual || config->visual->image.depth != pixmap->depth;
        });
    }
    return to_client(choice.configs, configs, size, count);
} catch (const std::exception&) {
    return egl::fail(EGL_BAD_ALLOC);
}

EGLBoolean eglGetConfigAttrib(EGLDisplay handle, EGLConfig config_handle, EGLint attribute, EGLint* value) {
    egl::Display* const display = egl::initialized_display(handle);
    if (!display) return EGL_FALSE;
    const auto config = egl::find_config(*display, config_handle);
    if (!config) return egl::fail(EGL_BAD_CONFIG);
    const auto answer = egl::attribute(*config, attribute);
    if (!answer) return egl::fail(EGL_BAD_ATTRIBUTE);
    if (!value) return egl::fail(EGL_BAD_PARAMETER);
    *value = *answer;
    egl::set_error(EGL_SUCCESS);
    return EGL_TRUE;
}

const char* eglQueryString(EGLDisplay handle, EGLint name) {
    if (handle == EGL_NO_DISPLAY && (name == EGL_EXTENSIONS || name == EGL_VERSION)) {
        egl::set_error(EGL_SUCCESS);
        return name == EGL_EXTENSIONS ? egl::client_extensions() : "1.5";
    }
    if (!egl::initialized_display(handle)) return nullptr;
    egl::set_error(EGL_SUCCESS);
    switch (name) {
        case EGL_CLIENT_APIS:
            return "OpenGL";
        case EGL_EXTENSIONS:
            return egl::display_extensions();
        case EGL_VENDOR:
            return gl::vendor_string();
        case EGL_VERSION:
            return "1.5";
    }
    return egl::fail(EGL_BAD_PARAMETER);
}

EGLBoolean eglQueryDevicesEXT(EGLint size, EGLDeviceEXT* devices, EGLint* count) {
    if (!count || (devices && size <= 0)) return egl::fail(EGL_BAD_PARAMETER);
    if (devices) devices[0] = egl::software_device();
    *count = 1;
    egl::set_error(EGL_SUCCESS);
    return EGL_TRUE;
}

EGLBoolean eglQueryDeviceAttribEXT(EGLDeviceEXT device, EGLint, EGLAttrib*) {
    return egl::fail(device == egl::software_device() ? EGL_BAD_ATTRIBUTE : EGL_BAD_DEVICE_EXT);
}

const char* eglQueryDeviceStringEXT(EGLDeviceEXT device, EGLint name) {
    if (device != egl::software_device()) return egl::fail(EGL_BAD_DEVICE_EXT);
    egl::set_error(EGL_SUCCESS);
    switch (name) {
        case EGL_EXTENSIONS:
            return "EGL_MESA_device_software EGL_EXT_device_query_name";
        case EGL_VENDOR:
            return gl::vendor_string();
        case EGL_RENDERER_EXT:
            return gl::renderer_string();
    }
    return egl::fail(EGL_BAD_PARAMETER);
}

EGLBoolean eglQueryDisplayAttribEXT(EGLDisplay handle, EGLint attribute, EGLAttrib* value) {
    egl::Display* const display = egl::initialized_display(handle);
    if (!display) return EGL_FALSE;
    if (attribute != EGL_DEVICE_EXT) return egl::fail(EGL_BAD_ATTRIBUTE);
    if (!value) return egl::fail(EGL_BAD_PARAMETER);
    *value = reinterpret_cast<EGLAttrib>(egl::software_device());
    egl::set_error(EGL_SUCCESS);
    return EGL_TRUE;
}
