// Contexts (EGL 1.5 §3.7, EGL_KHR_create_context).
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <exception>
#include <optional>

#include "frontends/egl/display.h"
#include "gl/generated/commands.h"
#include "gl/generated/dispatch.h"
#include "gl/surface.h"

namespace egl = terrazzo::egl;
namespace gl = terrazzo::gl;
namespace window = terrazzo::window;

namespace {

struct Request {
    int major = 1, minor = 0;
    int profile = EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT;
    bool forward_compatible = false;
    EGLint release_behavior = EGL_CONTEXT_RELEASE_BEHAVIOR_FLUSH_KHR;
};

// What is specified for contexts of OpenGL alone (EGL 1.5 §3.7.1, EGL_KHR_create_context).
bool is_for_opengl(EGLint attribute, EGLint value) {
    return attribute == EGL_CONTEXT_OPENGL_PROFILE_MASK ||
           attribute == EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE ||
           (attribute == EGL_CONTEXT_FLAGS_KHR && value != 0);
}

// EGL_SUCCESS, or why the list is refused.
EGLint parse(const EGLint* list, Request& out) {
    const bool is_opengl = egl::current_api() == EGL_OPENGL_API;
    for (; list && *list != EGL_NONE; list += 2) {
        const EGLint value = list[1];
        if (!is_opengl && is_for_opengl(list[0], value)) return EGL_BAD_ATTRIBUTE;
        switch (list[0]) {
            case EGL_CONTEXT_MAJOR_VERSION:
                out.major = value;
                break;
            case EGL_CONTEXT_MINOR_VERSION:
                out.minor = value;
                break;
            case EGL_CONTEXT_OPENGL_PROFILE_MASK:
                out.profile = value;
                break;
            case EGL_CONTEXT_FLAGS_KHR:
                if (value &
                    ~(EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR | EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE_BIT_KHR |
                      EGL_CONTEXT_OPENGL_ROBUST_ACCESS_BIT_KHR))
                    return EGL_BAD_ATTRIBUTE;
                out.forward_compatible |= (value & EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE_BIT_KHR) != 0;
                break;
            case EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE:
                if (value != EGL_TRUE && value != EGL_FALSE) return EGL_BAD_ATTRIBUTE;
                out.forward_compatible = value == EGL_TRUE;
                break;
            case EGL_CONTEXT_OPENGL_DEBUG:
            case EGL_CONTEXT_OPENGL_ROBUST_ACCESS:
            case EGL_CONTEXT_OPENGL_NO_ERROR_KHR:
                if (value != EGL_TRUE && value != EGL_FALSE) return EGL_BAD_ATTRIBUTE;
                break;
            case EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY:
                if (value != EGL_NO_RESET_NOTIFICATION && value != EGL_LOSE_CONTEXT_ON_RESET)
                    return EGL_BAD_ATTRIBUTE;
                break;
            case EGL_CONTEXT_RELEASE_BEHAVIOR_KHR:
                if (value != EGL_CONTEXT_RELEASE_BEHAVIOR_FLUSH_KHR &&
                    value != EGL_CONTEXT_RELEASE_BEHAVIOR_NONE_KHR)
                    return EGL_BAD_ATTRIBUTE;
                out.release_behavior = value;
                break;
            default:
                return EGL_BAD_ATTRIBUTE;
        }
    }
    const int version = out.major * 10 + out.minor;
    if (out.major < 1 || out.minor < 0 || out.minor > 9) return EGL_BAD_MATCH;
    if (!is_opengl && version > 11) return EGL_BAD_MATCH;
    // Profiles began with OpenGL 3.2; the mask is ignored before.
    if (version >= 32 && out.profile != EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT) return EGL_BAD_MATCH;
    if (version < 30 && out.forward_compatible) return EGL_BAD_MATCH;
    if (version > gl::kGlMajorVersion * 10 + gl::kGlMinorVersion) return EGL_BAD_MATCH;
    return EGL_SUCCESS;
}

// Null for EGL_NO_CONTEXT and for what is none.
std::shared_ptr<egl::Context> find_context(egl::Display& display, EGLContext handle) {
    const auto guard = egl::lock();
    const auto found = display.contexts.find(handle);
    return found == display.contexts.end() ? nullptr : found->second;
}

bool compatible(const egl::Context& context, const egl::Surface& surface) {
    return !context.config || context.config->color == surface.config->color;
}

// Of the context that is current. The surfaces that it had die, if they do, without the lock.
void set_surfaces(const std::shared_ptr<egl::Context>& context, std::shared_ptr<egl::Surface> draw,
                  std::shared_ptr<egl::Surface> read, EGLDisplay display) {
    const auto guard = egl::lock();
    for (const auto& surface : {draw, read})
        if (surface) surface->user = context;
    context->draw.swap(draw);
    context->read.swap(read);
    context->display = display;
}

// Of a context that the calling thread has let go of. Another may have it by now, with surfaces of its own.
void forget_surfaces(egl::Context& context) {
    std::shared_ptr<egl::Surface> draw, read;
    const auto guard = egl::lock();
    if (context.is_current) return;
    context.draw.swap(draw);
    context.read.swap(read);
    context.display = EGL_NO_DISPLAY;
}

void release() {
    const auto context = egl::current_context();
    window::make_current({});
    if (context) forget_surfaces(*context);
}

// Keeps other threads from surfaces while they are made current in this one, unless some thread has them
// already.
class Claim {
  public:
    Claim(const std::shared_ptr<egl::Surface>& draw, const std::shared_ptr<egl::Surface>& read,
          const std::shared_ptr<egl::Context>& wanted)
        : m_surfaces{draw.get(), read == draw ? nullptr : read.get()} {
        const auto own = egl::current_context();
        const auto guard = egl::lock();
        for (egl::Surface* const surface : m_surfaces) {
            if (!surface) continue;
            const auto user = surface->user.lock();
            const bool is_used = user && user != own && user != wanted && user->is_current &&
                                 (user->draw.get() == surface || user->read.get() == surface);
            m_is_refused = m_is_refused || is_used || surface->is_being_made_current;
        }
        set(true);
    }
    ~Claim() {
        const auto guard = egl::lock();
        set(false);
    }
    Claim(const Claim&) = delete;
    Claim& operator=(const Claim&) = delete;
    bool is_refused() const { return m_is_refused; }

  private:
    void set(bool claimed) {
        for (egl::Surface* const surface : m_surfaces)
            if (surface && !m_is_refused) surface->is_being_made_current = claimed;
    }

    std::array<egl::Surface*, 2> m_surfaces;
    bool m_is_refused = false;
};

// The window or pixmap that the context draws to is known to have gone.
bool is_drawing_for_nobody(const egl::Context& context) {
    return context.draw && context.draw->server && context.draw->server->is_gone();
}

// What MakeCurrent says of a surface once its window has been asked for its size (EGL 1.5 §3.7.3).
EGLint unusable(const egl::Surface& surface) {
    surface.buffers->follow_window(gl::Follow::kOncePerPicture);
    if (!surface.server || !surface.server->is_gone()) return EGL_SUCCESS;
    return surface.kind == egl::Kind::kWindow ? EGL_BAD_NATIVE_WINDOW : EGL_BAD_NATIVE_PIXMAP;
}

}  // namespace

EGLBoolean eglBindAPI(EGLenum api) {
    if (api != EGL_OPENGL_API) return egl::fail(EGL_BAD_PARAMETER);
    egl::current_api() = api;
    egl::set_error(EGL_SUCCESS);
    return EGL_TRUE;
}

EGLenum eglQueryAPI() {
    egl::set_error(EGL_SUCCESS);
    return egl::current_api();
}

// A program that has not said which API it draws with means OpenGL ES 1: the commands that it draws with are
// OpenGL's too, so it gets one of OpenGL's contexts. parse() refuses later versions.
EGLContext eglCreateContext(EGLDisplay handle, EGLConfig config_handle, EGLContext share,
                            const EGLint* attributes) try {
    egl::Display* const display = egl::initialized_display(handle);
    if (!display) return EGL_NO_CONTEXT;
    const auto config = egl::find_config(*display, config_handle);
    if (config_handle != EGL_NO_CONFIG_KHR && !config) return egl::fail(EGL_BAD_CONFIG);
    const auto partner = find_context(*display, share);
    if (share != EGL_NO_CONTEXT && !partner) return egl::fail(EGL_BAD_CONTEXT);
    Request wanted;
    if (const EGLint error = parse(attributes, wanted); error != EGL_SUCCESS) return egl::fail(error);
    auto context = std::make_shared<egl::Context>();
    context->config = config;
    context->release_behavior = wanted.release_behavior;
    gl::Config asked;
    asked.double_buffered = true;
    if (config) {
        asked.depth_bits = config->depth_bits;
        asked.stencil_bits = config->stencil_bits;
    }
    context->gl = gl::create_context(asked, partner ? partner->gl.get() : nullptr);
    const auto guard = egl::lock();
    if (!display->is_initialized) return egl::fail(EGL_NOT_INITIALIZED);  // by now
    const EGLContext made = context.get();
    display->contexts.emplace(made, std::move(context));
    egl::set_error(EGL_SUCCESS);
    return made;
} catch (const std::exception&) {
    return egl::fail(EGL_BAD_ALLOC);
}

// A thread that has it current keeps it.
EGLBoolean eglDestroyContext(EGLDisplay handle, EGLContext context) {
    egl::Display* const display = egl::initialized_display(handle);
    if (!display) return EGL_FALSE;
    const auto last = find_context(*display, context);  // dies without the lock
    const auto guard = egl::lock();
    if (!last || display->contexts.erase(context) == 0) return egl::fail(EGL_BAD_CONTEXT);
    egl::set_error(EGL_SUCCESS);
    return EGL_TRUE;
}

EGLBoolean eglMakeCurrent(EGLDisplay handle, EGLSurface draw, EGLSurface read,
                          EGLContext context_handle) try {
    const bool nothing = draw == EGL_NO_SURFACE && read == EGL_NO_SURFACE && context_handle == EGL_NO_CONTEXT;
    if (nothing) {
        // Also of a display that is terminated.
        if (!egl::find_display(handle)) return egl::fail(EGL_BAD_DISPLAY);
        release();
        egl::set_error(EGL_SUCCESS);
        return EGL_TRUE;
    }
    egl::Display* const display = egl::initialized_display(handle);
    if (!display) return EGL_FALSE;
    const auto context = find_context(*display, context_handle);
    if (!context) return egl::fail(context_handle == EGL_NO_CONTEXT ? EGL_BAD_MATCH : EGL_BAD_CONTEXT);
    const auto to = egl::find_surface(*display, draw), from = egl::find_surface(*display, read);
    if ((draw != EGL_NO_SURFACE && !to) || (read != EGL_NO_SURFACE && !from))
        return egl::fail(EGL_BAD_SURFACE);
    if (!to != !from) return egl::fail(EGL_BAD_MATCH);
    if (to && (!compatible(*context, *to) || !compatible(*context, *from))) return egl::fail(EGL_BAD_MATCH);
    const Claim claim(to, from, context);
    if (claim.is_refused()) return egl::fail(EGL_BAD_ACCESS);
    EGLint error = to ? unusable(*to) : EGL_SUCCESS;
    if (error == EGL_SUCCESS && from && from != to) error = unusable(*from);
    if (error != EGL_SUCCESS) return egl::fail(error);
    const auto before = egl::current_context();
    if (!window::make_current({context, to ? to->buffers : nullptr, from ? from->buffers : nullptr}))
        return egl::fail(EGL_BAD_ACCESS);
    if (before && before != context) forget_surfaces(*before);
    set_surfaces(context, to, from, handle);
    egl::set_error(EGL_SUCCESS);
    return EGL_TRUE;
} catch (const std::exception&) {
    return egl::fail(EGL_BAD_ALLOC);
}

EGLContext eglGetCurrentContext() {
    egl::set_error(EGL_SUCCESS);
    return egl::current_context().get();
}

EGLSurface eglGetCurrentSurface(EGLint which) {
    if (which != EGL_DRAW && which != EGL_READ) return egl::fail(EGL_BAD_PARAMETER);
    egl::set_error(EGL_SUCCESS);
    const auto context = egl::current_context();
    if (!context) return EGL_NO_SURFACE;
    return (which == EGL_DRAW ? context->draw : context->read).get();
}

EGLDisplay eglGetCurrentDisplay() {
    egl::set_error(EGL_SUCCESS);
    const auto context = egl::current_context();
    return context ? context->display : EGL_NO_DISPLAY;
}

EGLBoolean eglQueryContext(EGLDisplay handle, EGLContext context_handle, EGLint attribute, EGLint* value) {
    egl::Display* const display = egl::initialized_display(handle);
    if (!display) return EGL_FALSE;
    const auto context = find_context(*display, context_handle);
    if (!context) return egl::fail(EGL_BAD_CONTEXT);
    std::shared_ptr<egl::Surface> draw;
    {
        const auto guard = egl::lock();
        draw = context->draw;
    }
    EGLint answer = 0;
    switch (attribute) {
        case EGL_CONFIG_ID:
            answer = context->config ? context->config->id : 0;
            break;
        case EGL_CONTEXT_CLIENT_TYPE:
            answer = EGL_OPENGL_API;
            break;
        case EGL_CONTEXT_CLIENT_VERSION:
            answer = gl::kGlMajorVersion;
            break;
        case EGL_RENDER_BUFFER:
            if (!draw) {
                answer = EGL_NONE;
            } else {
                const bool single = draw->kind == egl::Kind::kPixmap || !draw->wants_back_buffer;
                answer = single ? EGL_SINGLE_BUFFER : EGL_BACK_BUFFER;
            }
            break;
        case EGL_CONTEXT_RELEASE_BEHAVIOR_KHR:
            answer = context->release_behavior;
            break;
        default:
            return egl::fail(EGL_BAD_ATTRIBUTE);
    }
    if (!value) return egl::fail(EGL_BAD_PARAMETER);
    *value = answer;
    egl::set_error(EGL_SUCCESS);
    return EGL_TRUE;
}

EGLBoolean eglWaitClient() try {
    egl::set_error(EGL_SUCCESS);
    const auto context = egl::current_context();
    if (!context) return EGL_TRUE;
    gl::present_window(*context->gl);
    gl::finish(*context->gl);
    if (is_drawing_for_nobody(*context)) return egl::fail(EGL_BAD_CURRENT_SURFACE);
    return EGL_TRUE;
} catch (const std::exception&) {
    return egl::fail(EGL_BAD_ALLOC);
}

EGLBoolean eglWaitGL() {
    return eglWaitClient();
}

// A program that has changed its window's size waits for the window system and then draws.
EGLBoolean eglWaitNative(EGLint engine) try {
    if (engine != EGL_CORE_NATIVE_ENGINE) return egl::fail(EGL_BAD_PARAMETER);
    egl::set_error(EGL_SUCCESS);
    const auto context = egl::current_context();
    if (!context || !context->draw) return EGL_TRUE;
    context->draw->buffers->follow_window(gl::Follow::kNow);
    gl::follow_drawables(*context->gl);
    if (is_drawing_for_nobody(*context)) return egl::fail(EGL_BAD_CURRENT_SURFACE);
    return EGL_TRUE;
} catch (const std::exception&) {
    return egl::fail(EGL_BAD_ALLOC);
}

EGLBoolean eglReleaseThread() try {
    if (egl::current_context()) release();
    egl::current_api() = EGL_NONE;
    egl::set_error(EGL_SUCCESS);
    return EGL_TRUE;
} catch (const std::exception&) {
    return egl::fail(EGL_BAD_ALLOC);
}
