// What EGL remembers: displays with their configurations, surfaces, contexts and syncs, and each thread's API
// and error.
//
// One lock guards it all, as in GLX, whatever thread terminates a display under whose feet; objects are
// handed out as shared_ptr.
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "frontends/egl/config.h"
#include "frontends/window/current.h"
#include "frontends/x11/drawable.h"

namespace terrazzo::egl {

enum class Kind { kWindow, kPixmap, kPbuffer };

struct Context;

// What an EGLSurface points at. A surface is current in one thread at most.
struct Surface {
    Kind kind = Kind::kPbuffer;
    std::shared_ptr<const Config> config;
    std::shared_ptr<gl::Drawable> buffers;
    x11::ServerDrawable* server = nullptr;  // the same; null for pbuffers
    bool wants_back_buffer = true;          // EGL_RENDER_BUFFER
    bool is_largest = false;
    std::atomic<bool> preserves = true;  // EGL_SWAP_BEHAVIOR
    // Of the thread that has it current.
    int swap_interval = 0;
    std::int64_t last_msc = 0;  // of the last swap that waited
    // Guarded by lock().
    std::weak_ptr<Context> user;         // the last context it was made current with
    bool is_being_made_current = false;  // in some thread, which knows by now that no other has it
};

// What an EGLContext points at.
struct Context : window::Context {
    Context() : window::Context(window::Interface::kEgl) {}
    std::shared_ptr<const Config> config;  // null: made without one
    EGLint release_behavior = EGL_CONTEXT_RELEASE_BEHAVIOR_FLUSH_KHR;
    // While it is current; written under lock() by the thread that has it current.
    std::shared_ptr<Surface> draw, read;
    EGLDisplay display = EGL_NO_DISPLAY;
};

// What an EGLSync points at. Fences are signalled when they are made: nothing runs behind the caller's back.
struct Sync {};

enum class Platform { kX11, kSurfaceless };

struct Display {
    Platform platform = Platform::kSurfaceless;
    EGLenum name = EGL_NONE;  // as the program called the platform
    void* native = nullptr;   // its display, null for the default one
    int screen = 0;           // as the program asked for it; -1: the default one

    // Guarded by lock().
    bool is_initialized = false;
    bool is_closed = false;                             // the program has closed the native display
    std::shared_ptr<const x11::Connection> connection;  // null where there is none
    std::shared_ptr<const std::vector<Config>> configs;
    std::map<EGLSurface, std::shared_ptr<Surface>> surfaces;
    std::map<EGLContext, std::shared_ptr<Context>> contexts;
    std::map<EGLSync, std::shared_ptr<Sync>> syncs;
};

// Of a display that is initialised, or was a moment ago: they stay good whoever terminates it. The
// connection is null where there is none.
std::shared_ptr<const std::vector<Config>> configs_of(const Display& display);
std::shared_ptr<const x11::Connection> connection_of(const Display& display);
// Null for what is no configuration of the display.
std::shared_ptr<const Config> find_config(const Display& display, EGLConfig config);

// Displays are never freed, as EGL has it: the same native display gives the same EGLDisplay.
Display* get_display(EGLenum platform, void* native, int screen);
// Null for what is no display.
Display* find_display(EGLDisplay display);

// Null for what is no surface of the display, EGL_NO_SURFACE among it.
std::shared_ptr<Surface> find_surface(Display& display, EGLSurface surface);

// Guards displays and all that they hold.
std::unique_lock<std::mutex> lock();

// The calling thread's error, as eglGetError fetches it.
void set_error(EGLint error);
EGLint take_error();

// Records an error and is the answer of the function that failed.
struct Failure {
    operator EGLBoolean() const { return EGL_FALSE; }
    template <class T>
    operator T*() const {
        return nullptr;
    }
};
Failure fail(EGLint error);

// The display if it is one and initialised; else null, with the error recorded.
Display* initialized_display(EGLDisplay display);

// EGL_NONE, EGL_OPENGL_API.
EGLenum& current_api();

// The calling thread's context if it is EGL's, else null.
std::shared_ptr<Context> current_context();

// The only device: the processor.
EGLDeviceEXT software_device();

}  // namespace terrazzo::egl
