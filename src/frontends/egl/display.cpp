// Displays: finding, initialising and terminating them (EGL 1.5 §3.2-3.3, EGL_EXT_platform_base,
// EGL_EXT_device_*).
#include "frontends/egl/display.h"

#include <X11/Xlib-xcb.h>
#include <X11/Xlibint.h>
#undef min
#undef max

#include <algorithm>
#include <exception>

namespace terrazzo::egl {
namespace {

constinit std::mutex the_mutex;
thread_local EGLint this_threads_error = EGL_SUCCESS;
thread_local EGLenum this_threads_api = EGL_NONE;

std::vector<std::unique_ptr<Display>>& displays() {
    // Never destroyed: programs call EGL from their own destructors.
    static auto& all = *new std::vector<std::unique_ptr<Display>>;
    return all;
}

int a_device;

// What a display had. Dies without the lock; the connection is not touched again then.
struct Remains {
    std::shared_ptr<const x11::Connection> connection;
    std::map<EGLSurface, std::shared_ptr<Surface>> surfaces;
    std::map<EGLContext, std::shared_ptr<Context>> contexts;
    std::map<EGLSync, std::shared_ptr<Sync>> syncs;

    ~Remains() {
        if (connection) x11::abandon_drawables(*connection);
    }
};

// Called by XCloseDisplay. Contexts stay: they may be current, and wait for eglTerminate.
int close_display(::Display* native, XExtCodes*) {
    for (;;) {
        Remains remains;
        const auto guard = lock();
        const auto found = std::ranges::find_if(displays(), [&](const auto& display) {
            return display->name == EGL_PLATFORM_X11_KHR && display->native == native && !display->is_closed;
        });
        if (found == displays().end()) return 0;
        Display& display = **found;
        remains.surfaces.swap(display.surfaces);
        remains.connection.swap(display.connection);
        display.is_closed = true;
        display.is_initialized = false;
    }
}

}  // namespace

std::unique_lock<std::mutex> lock() {
    return std::unique_lock(the_mutex);
}

void set_error(EGLint error) {
    this_threads_error = error;
}

EGLint take_error() {
    return std::exchange(this_threads_error, EGL_SUCCESS);
}

Failure fail(EGLint error) {
    set_error(error);
    return {};
}

EGLenum& current_api() {
    return this_threads_api;
}

EGLDeviceEXT software_device() {
    return &a_device;
}

std::shared_ptr<const std::vector<Config>> configs_of(const Display& display) {
    const auto guard = lock();
    return display.configs;
}

std::shared_ptr<const x11::Connection> connection_of(const Display& display) {
    const auto guard = lock();
    return display.connection;
}

std::shared_ptr<const Config> find_config(const Display& display, EGLConfig config) {
    const auto configs = configs_of(display);
    const auto found = std::ranges::find_if(*configs, [&](const Config& c) { return &c == config; });
    return found == configs->end() ? nullptr : std::shared_ptr<const Config>(configs, &*found);
}

Display* get_display(EGLenum platform, void* native, int screen) {
    const auto guard = lock();
    for (const auto& display : displays()) {
        const bool same = display->name == platform && display->native == native && display->screen == screen;
        if (same && !display->is_closed) return display.get();
    }
    auto display = std::make_unique<Display>();
    display->name = platform;
    display->native = native;
    display->screen = screen;
    switch (platform) {
        case EGL_PLATFORM_X11_KHR:
        case EGL_PLATFORM_XCB_EXT:
            display->platform = Platform::kX11;
            break;
        case EGL_NONE:  // eglGetDisplay(EGL_DEFAULT_DISPLAY)
            // The name that Xlib would connect to: DISPLAY's, or none.
            if (*XDisplayName(nullptr)) display->platform = Platform::kX11;
            break;
        default:
            break;
    }
    return displays().emplace_back(std::move(display)).get();
}

Display* find_display(EGLDisplay wanted) {
    const auto guard = lock();
    const auto found =
        std::ranges::find_if(displays(), [&](const auto& display) { return display.get() == wanted; });
    return found == displays().end() || (*found)->is_closed ? nullptr : found->get();
}

std::shared_ptr<Surface> find_surface(Display& display, EGLSurface surface) {
    const auto guard = lock();
    const auto found = display.surfaces.find(surface);
    return found == display.surfaces.end() ? nullptr : found->second;
}

Display* initialized_display(EGLDisplay wanted) {
    Display* const display = find_display(wanted);
    if (!display) {
        set_error(EGL_BAD_DISPLAY);
        return nullptr;
    }
    const auto guard = lock();
    if (!display->is_initialized) {
        set_error(EGL_NOT_INITIALIZED);
        return nullptr;
    }
    return display;
}

std::shared_ptr<Context> current_context() {
    const window::Binding& binding = window::current_binding();
    if (!binding.context || binding.context->interface != window::Interface::kEgl) return nullptr;
    return std::static_pointer_cast<Context>(binding.context);
}

namespace {

// Xlib finds out about a server that has gone when it is asked something, and calls the program's handler.
void ask_xlib(void* native) {
    XSync(static_cast<::Display*>(native), False);
}

std::shared_ptr<const std::vector<Config>> share(std::vector<Config> configs) {
    return std::make_shared<const std::vector<Config>>(std::move(configs));
}

// False if there is no X server to be had. Throws std::bad_alloc.
bool connect(Display& display) {
    xcb_connection_t* xcb = nullptr;
    ::Display* xlib = nullptr;
    int screen = display.screen;
    if (display.name == EGL_PLATFORM_XCB_EXT && display.native) {
        xcb = static_cast<xcb_connection_t*>(display.native);
    } else if (display.native) {
        xlib = static_cast<::Display*>(display.native);
        xcb = XGetXCBConnection(xlib);
        if (XExtCodes* codes = XAddExtension(xlib)) XESetCloseDisplay(xlib, codes->extension, &close_display);
        if (screen < 0) screen = DefaultScreen(xlib);
    } else {
        xcb = xcb_connect(nullptr, &screen);
    }
    const auto connection = x11::inspect(xcb, !display.native);
    if (xlib) {
        connection->lost = ask_xlib;
        connection->owner = xlib;
    }
    const auto count = static_cast<int>(connection->screens.size());
    if (count == 0) return false;
    const auto number = static_cast<std::size_t>(std::clamp(screen, 0, count - 1));
    display.configs = share(make_configs(&connection->screens[number]));
    display.connection = connection;
    return true;
}

}  // namespace
}  // namespace terrazzo::egl

namespace egl = terrazzo::egl;

EGLBoolean eglInitialize(EGLDisplay handle, EGLint* major, EGLint* minor) try {
    egl::Display* const display = egl::find_display(handle);
    if (!display) return egl::fail(EGL_BAD_DISPLAY);
    const auto guard = egl::lock();
    if (!display->is_initialized) {
        if (display->platform == egl::Platform::kX11) {
            if (!egl::connect(*display)) return egl::fail(EGL_NOT_INITIALIZED);
        } else {
            display->configs = egl::share(egl::make_configs(nullptr));
        }
        display->is_initialized = true;
    }
    if (major) *major = 1;
    if (minor) *minor = 5;
    egl::set_error(EGL_SUCCESS);
    return EGL_TRUE;
} catch (const std::exception&) {
    return egl::fail(EGL_BAD_ALLOC);
}

// What is current stays until its threads let go of it; it does not show anything any more.
EGLBoolean eglTerminate(EGLDisplay handle) {
    egl::Display* const display = egl::find_display(handle);
    if (!display) return egl::fail(EGL_BAD_DISPLAY);
    egl::Remains remains;
    const auto guard = egl::lock();
    if (display->is_initialized) {
        remains.surfaces.swap(display->surfaces);
        remains.contexts.swap(display->contexts);
        remains.syncs.swap(display->syncs);
        remains.connection.swap(display->connection);
        display->is_initialized = false;
    }
    egl::set_error(EGL_SUCCESS);
    return EGL_TRUE;
}

EGLDisplay eglGetDisplay(EGLNativeDisplayType native) try {
    egl::set_error(EGL_SUCCESS);
    if (native == EGL_DEFAULT_DISPLAY) return egl::get_display(EGL_NONE, nullptr, -1);
    return egl::get_display(EGL_PLATFORM_X11_KHR, native, -1);
} catch (const std::exception&) {
    return egl::fail(EGL_BAD_ALLOC);
}

EGLDisplay eglGetPlatformDisplay(EGLenum platform, void* native, const EGLAttrib* attributes) try {
    int screen = -1;
    for (; attributes && *attributes != EGL_NONE; attributes += 2) {
        switch (attributes[0]) {
            case EGL_PLATFORM_X11_SCREEN_KHR:  // EGL_PLATFORM_XCB_SCREEN_EXT is another number
            case EGL_PLATFORM_XCB_SCREEN_EXT:
                screen = static_cast<int>(attributes[1]);
                break;
            default:
                return egl::fail(EGL_BAD_ATTRIBUTE);
        }
    }
    egl::set_error(EGL_SUCCESS);
    switch (platform) {
        case EGL_PLATFORM_X11_KHR:
        case EGL_PLATFORM_XCB_EXT:
        case EGL_NONE:
            return egl::get_display(platform, native, screen);
        case EGL_PLATFORM_SURFACELESS_MESA:
            return native == EGL_DEFAULT_DISPLAY ? egl::get_display(platform, nullptr, 0)
                                                 : egl::fail(EGL_BAD_PARAMETER);
        case EGL_PLATFORM_DEVICE_EXT:
            return native == egl::software_device() ? egl::get_display(platform, native, 0)
                                                    : egl::fail(EGL_BAD_PARAMETER);
        default:
            return egl::fail(EGL_BAD_PARAMETER);
    }
} catch (const std::exception&) {
    return egl::fail(EGL_BAD_ALLOC);
}

EGLDisplay eglGetPlatformDisplayEXT(EGLenum platform, void* native, const EGLint* attributes) try {
    std::vector<EGLAttrib> list;
    for (; attributes && *attributes != EGL_NONE; attributes += 2) {
        list.push_back(attributes[0]);
        list.push_back(attributes[1]);
    }
    list.push_back(EGL_NONE);
    return eglGetPlatformDisplay(platform, native, list.data());
} catch (const std::exception&) {
    return egl::fail(EGL_BAD_ALLOC);
}
