// Windows, pixmaps, pbuffers, and showing what is in them (GLX 1.4 §3.3.4-3.3.6, §3.3.10).
#include "frontends/glx/drawables.h"

#include <GL/glx.h>
#include <X11/Xlibint.h>
#undef min
#undef max

#include <algorithm>
#include <exception>
#include <optional>

#include "frontends/glx/protocol.h"
#include "frontends/window/refresh.h"
#include "gl/generated/commands.h"
#include "gl/limits.h"
#include "gl/surface.h"

namespace gl = terrazzo::gl;
namespace glx = terrazzo::glx;
namespace window = terrazzo::window;
namespace x11 = terrazzo::x11;
using terrazzo::glx::registry;

namespace terrazzo::glx {
namespace {

std::shared_ptr<Drawable> make_server_drawable(const DisplayState& display, Kind kind, XID server_id,
                                               const Config& config, const x11::Geometry& geometry) {
    auto out = std::make_shared<Drawable>();
    out->kind = kind;
    out->server_id = server_id;
    out->config = &config;
    x11::BufferFormat format = config.buffer_format();
    if (kind == Kind::kPixmap) format.double_buffered = false;
    const auto buffers = x11::ServerDrawable::make(display.connection, static_cast<xcb_drawable_t>(server_id),
                                                   format, geometry);
    out->server = buffers.get();
    out->buffers = buffers;
    return out;
}

// Gives a drawable a name. Throws std::bad_alloc.
GLXDrawable name_drawable(DisplayState& display, const std::shared_ptr<Drawable>& drawable) {
    for (;;) {
        const GLXDrawable name = xcb_generate_id(display.xcb());
        // Names come again when the server has run out of them, those of dead windows among them.
        if (registry().add(display, name, registry().drawable(display, name), drawable)) return name;
    }
}

// Windows that went to their end without a word to GLX are forgotten when a new one comes.
void forget_dead_windows(DisplayState& display) {
    for (const XID name : registry().unused_windows(display)) {
        if (!x11::geometry(display.xcb(), static_cast<xcb_window_t>(name))) registry().remove(display, name);
    }
}

}  // namespace

std::shared_ptr<Drawable> drawable_for(DisplayState& display, GLXDrawable name, const Config* config) {
    for (;;) {
        const auto known = registry().drawable(display, name);
        // A window keeps the buffers that it was first drawn with until a context of another kind comes.
        const bool other = known && known->is_x_window && config &&
                           (known->config->target_format() != config->target_format() ||
                            known->config->double_buffered != config->double_buffered);
        if (known && !other) return known;
        const auto window = static_cast<xcb_window_t>(name);
        const xcb_visualid_t visual = x11::window_visual(display.xcb(), window);
        const auto geometry = x11::geometry(display.xcb(), window);
        if (!visual || !geometry) return nullptr;
        if (!config) {
            for (std::size_t s = 0; s < display.configs.size() && !config; ++s)
                config = registry().config_of_visual(display, static_cast<int>(s), visual);
            if (!config) return nullptr;
        }
        if (config->visual.image.depth != geometry->depth) return nullptr;
        forget_dead_windows(display);
        auto drawable = make_server_drawable(display, Kind::kWindow, window, *config, *geometry);
        drawable->is_x_window = true;
        // Unless another thread has been faster, or has forgotten a window that died: then once more.
        if (registry().add(display, name, known, drawable)) return drawable;
    }
}

}  // namespace terrazzo::glx

namespace {

struct Failure {
    int code;
    bool is_glx;
    XID resource;
};

GLXDrawable create_on_server(Display* display, const glx::Config* config, XID server_id, glx::Kind kind,
                             const int* attributes, int minor) try {
    const auto state = registry().display(display);
    const auto fail = [&](const Failure& failure) -> GLXDrawable {
        glx::send_error(display, failure.code, failure.is_glx, failure.resource, minor);
        return 0;
    };
    const bool is_pixmap = kind == glx::Kind::kPixmap;
    if (!config || !registry().is_config(*state, const_cast<GLXFBConfig>(config)))
        return fail({GLXBadFBConfig, true, 0});
    const auto id = static_cast<xcb_drawable_t>(server_id);
    const auto geometry = x11::geometry(state->xcb(), id);
    const bool is_window = x11::window_visual(state->xcb(), id) != 0;
    if (!geometry || is_window == is_pixmap)
        return fail({is_pixmap ? BadPixmap : BadWindow, false, server_id});
    if (geometry->depth != config->visual.image.depth) return fail({BadMatch, false, server_id});
    const auto drawable = glx::make_server_drawable(*state, kind, server_id, *config, *geometry);
    for (; attributes && *attributes != None; attributes += 2) {
        switch (attributes[0]) {
            case GLX_TEXTURE_FORMAT_EXT:
                drawable->texture_format = attributes[1];
                break;
            case GLX_TEXTURE_TARGET_EXT:
                drawable->texture_target = attributes[1];
                break;
            case GLX_MIPMAP_TEXTURE_EXT:
                drawable->texture_mipmaps = attributes[1] != 0;
                break;
            default:
                return fail({BadValue, false, 0});
        }
    }
    return glx::name_drawable(*state, drawable);
} catch (const std::exception&) {
    glx::send_error(display, BadAlloc, false, 0, minor);
    return 0;
}

void destroy(Display* display, GLXDrawable name, glx::Kind kind, int error, int minor) {
    const auto state = registry().find_display(display);
    const auto drawable = state ? registry().drawable(*state, name) : nullptr;
    if (!drawable || drawable->kind != kind || drawable->is_x_window)
        return glx::send_error(display, error, true, name, minor);
    const bool is_ours = registry().remove(*state, name) != nullptr;  // and not another thread's
    // A window that is destroyed takes its GLXWindow along.
    const auto id = static_cast<xcb_drawable_t>(drawable->server_id);
    if (!is_ours || (kind == glx::Kind::kWindow && !x11::geometry(state->xcb(), id)))
        glx::send_error(display, error, true, name, minor);
}

struct PbufferRequest {
    int width = 0, height = 0;
    bool largest = false, preserved = true;
};

GLXPbuffer create_pbuffer(Display* display, const glx::Config* config, PbufferRequest wanted) try {
    const auto state = registry().display(display);
    if (!config || !registry().is_config(*state, const_cast<GLXFBConfig>(config))) {
        glx::send_error(display, GLXBadFBConfig, true, 0, X_GLXCreatePbuffer);
        return 0;
    }
    if (wanted.width < 0 || wanted.height < 0) {
        glx::send_error(display, BadValue, false, 0, X_GLXCreatePbuffer);
        return 0;
    }
    if (std::max(wanted.width, wanted.height) > gl::kMaxViewportSize) {
        if (!wanted.largest) {
            glx::send_error(display, BadAlloc, false, 0, X_GLXCreatePbuffer);
            return 0;
        }
        wanted.width = std::min(wanted.width, gl::kMaxViewportSize);
        wanted.height = std::min(wanted.height, gl::kMaxViewportSize);
    }
    auto drawable = std::make_shared<glx::Drawable>();
    drawable->kind = glx::Kind::kPbuffer;
    drawable->config = config;
    drawable->is_largest = wanted.largest;
    drawable->is_preserved = wanted.preserved;
    drawable->buffers = std::make_shared<gl::Drawable>(config->double_buffered ? gl::Buffering::kDouble
                                                                               : gl::Buffering::kSingle);
    drawable->buffers->allocate(std::max(wanted.width, 1), std::max(wanted.height, 1),
                                config->target_format());
    return glx::name_drawable(*state, drawable);
} catch (const std::exception&) {
    glx::send_error(display, BadAlloc, false, 0, X_GLXCreatePbuffer);
    return 0;
}

// The calling thread's context if it draws to the drawable.
gl::Context* context_drawing_to(const glx::Drawable& drawable) {
    const auto context = glx::current_context();
    return context && context->gl->framebuffers.window_draw == drawable.buffers ? context->gl.get() : nullptr;
}

// Nobody sees a pbuffer, but its front buffer can be read.
void swap_pbuffer(gl::Context* ctx, gl::Drawable& buffers) {
    if (ctx) gl::finish(*ctx);
    buffers.target_with_front();
    buffers.swap_pixels();
}

void wait_for_interval(glx::Drawable& drawable) {
    const int interval = drawable.swap_interval;
    if (interval != 0) drawable.last_msc = window::wait_for_msc(drawable.last_msc + interval, 0, 0);
}

}  // namespace

GLXWindow glXCreateWindow(Display* display, GLXFBConfig config, Window window, const int* attributes) {
    return create_on_server(display, config, window, glx::Kind::kWindow, attributes, X_GLXCreateWindow);
}

GLXPixmap glXCreatePixmap(Display* display, GLXFBConfig config, Pixmap pixmap, const int* attributes) {
    return create_on_server(display, config, pixmap, glx::Kind::kPixmap, attributes, X_GLXCreatePixmap);
}

GLXPixmap glXCreateGLXPixmap(Display* display, XVisualInfo* visual, Pixmap pixmap) try {
    const auto state = registry().display(display);
    const glx::Config* config =
        visual ? registry().config_of_visual(*state, visual->screen, visual->visualid) : nullptr;
    if (!config) {
        glx::send_error(display, BadMatch, false, pixmap, X_GLXCreateGLXPixmap);
        return 0;
    }
    return create_on_server(display, config, pixmap, glx::Kind::kPixmap, nullptr, X_GLXCreateGLXPixmap);
} catch (const std::exception&) {
    glx::send_error(display, BadAlloc, false, pixmap, X_GLXCreateGLXPixmap);
    return 0;
}

GLXPbuffer glXCreatePbuffer(Display* display, GLXFBConfig config, const int* attributes) {
    PbufferRequest wanted;
    for (; attributes && *attributes != None; attributes += 2) {
        switch (attributes[0]) {
            case GLX_PBUFFER_WIDTH:
                wanted.width = attributes[1];
                break;
            case GLX_PBUFFER_HEIGHT:
                wanted.height = attributes[1];
                break;
            case GLX_LARGEST_PBUFFER:
                wanted.largest = attributes[1] != 0;
                break;
            case GLX_PRESERVED_CONTENTS:
                wanted.preserved = attributes[1] != 0;
                break;
            default:
                glx::send_error(display, BadValue, false, 0, X_GLXCreatePbuffer);
                return 0;
        }
    }
    return create_pbuffer(display, config, wanted);
}

GLXPbuffer glXCreateGLXPbufferSGIX(Display* display, GLXFBConfig config, unsigned int width,
                                   unsigned int height, int* attributes) {
    PbufferRequest wanted;
    for (const int* a = attributes; a && *a != None; a += 2) {
        if (a[0] == GLX_LARGEST_PBUFFER) wanted.largest = a[1] != 0;
        if (a[0] == GLX_PRESERVED_CONTENTS) wanted.preserved = a[1] != 0;
    }
    constexpr unsigned kLargest = 1u << 30;
    wanted.width = static_cast<int>(std::min(width, kLargest));
    wanted.height = static_cast<int>(std::min(height, kLargest));
    return create_pbuffer(display, config, wanted);
}

void glXDestroyWindow(Display* display, GLXWindow window) {
    destroy(display, window, glx::Kind::kWindow, GLXBadWindow, X_GLXDestroyWindow);
}

void glXDestroyPixmap(Display* display, GLXPixmap pixmap) {
    destroy(display, pixmap, glx::Kind::kPixmap, GLXBadPixmap, X_GLXDestroyPixmap);
}

void glXDestroyGLXPixmap(Display* display, GLXPixmap pixmap) {
    destroy(display, pixmap, glx::Kind::kPixmap, GLXBadPixmap, X_GLXDestroyGLXPixmap);
}

void glXDestroyPbuffer(Display* display, GLXPbuffer pbuffer) {
    destroy(display, pbuffer, glx::Kind::kPbuffer, GLXBadPbuffer, X_GLXDestroyPbuffer);
}

void glXDestroyGLXPbufferSGIX(Display* display, GLXPbuffer pbuffer) {
    glXDestroyPbuffer(display, pbuffer);
}

void glXQueryDrawable(Display* display, GLXDrawable name, int attribute, unsigned int* value) {
    const auto state = registry().find_display(display);
    const auto drawable = glx::find_drawable(display, name);
    if (!drawable) return glx::send_error(display, GLXBadDrawable, true, name, X_GLXGetDrawableAttributes);
    unsigned answer = 0;
    switch (attribute) {
        case GLX_WIDTH:
        case GLX_HEIGHT: {
            const auto now =
                drawable->server
                    ? x11::geometry(state->xcb(), static_cast<xcb_drawable_t>(drawable->server_id))
                    : std::nullopt;
            const gl::Drawable& buffers = *drawable->buffers;
            answer = static_cast<unsigned>(attribute == GLX_WIDTH ? (now ? now->width : buffers.width())
                                                                  : (now ? now->height : buffers.height()));
            break;
        }
        case GLX_PRESERVED_CONTENTS:
            answer = drawable->is_preserved;
            break;
        case GLX_LARGEST_PBUFFER:
            answer = drawable->is_largest;
            break;
        case GLX_FBCONFIG_ID:
            answer = static_cast<unsigned>(drawable->config->id);
            break;
        case GLX_BACK_BUFFER_AGE_EXT:
            answer = drawable->server ? static_cast<unsigned>(drawable->server->buffer_age()) : 0;
            break;
        case GLX_SWAP_INTERVAL_EXT:
            answer = static_cast<unsigned>(drawable->swap_interval);
            break;
        case GLX_MAX_SWAP_INTERVAL_EXT:
            answer = 0x7fff;
            break;
        case GLX_TEXTURE_FORMAT_EXT:
            answer = static_cast<unsigned>(drawable->texture_format);
            break;
        case GLX_TEXTURE_TARGET_EXT:
            answer = static_cast<unsigned>(drawable->texture_target);
            break;
        case GLX_MIPMAP_TEXTURE_EXT:
            answer = drawable->texture_mipmaps;
            break;
        case GLX_Y_INVERTED_EXT:
            break;
        default:
            return glx::send_error(display, BadValue, false, name, X_GLXGetDrawableAttributes);
    }
    if (value) *value = answer;
}

void glXQueryGLXPbufferSGIX(Display* display, GLXPbuffer pbuffer, int attribute, unsigned int* value) {
    glXQueryDrawable(display, pbuffer, attribute, value);
}

void glXSelectEvent(Display* display, GLXDrawable name, unsigned long mask) {
    const auto drawable = glx::find_drawable(display, name);
    if (!drawable) return glx::send_error(display, GLXBadDrawable, true, name, X_GLXChangeDrawableAttributes);
    // Pbuffers are never clobbered: no event will ever come.
    drawable->event_mask = mask;
}

void glXGetSelectedEvent(Display* display, GLXDrawable name, unsigned long* mask) {
    const auto drawable = glx::find_drawable(display, name);
    if (!drawable) return glx::send_error(display, GLXBadDrawable, true, name, X_GLXGetDrawableAttributes);
    if (mask) *mask = drawable->event_mask;
}

void glXSwapBuffers(Display* display, GLXDrawable name) try {
    const auto state = registry().find_display(display);
    if (!state) return;
    const auto drawable = registry().drawable(*state, name);
    if (!drawable) return glx::send_error(display, GLXBadDrawable, true, name, X_GLXSwapBuffers);
    gl::Context* const ctx = context_drawing_to(*drawable);
    if (!drawable->server) return swap_pbuffer(ctx, *drawable->buffers);
    wait_for_interval(*drawable);
    drawable->server->swap(ctx);
} catch (const std::exception&) {
    glx::send_error(display, BadAlloc, false, name, X_GLXSwapBuffers);
}

void glXCopySubBufferMESA(Display* display, GLXDrawable name, int x, int y, int width, int height) try {
    const auto drawable = glx::find_drawable(display, name);
    if (drawable && drawable->server)
        drawable->server->copy_part(context_drawing_to(*drawable), x, y, width, height);
} catch (const std::exception&) {
    glx::send_error(display, BadAlloc, false, name, X_GLXSwapBuffers);
}

void glXWaitGL() try {
    if (const auto context = glx::current_context()) {
        gl::present_window(*context->gl);
        if (Display* display = context->display->display) XSync(display, False);
    }
} catch (const std::exception&) {
    // What could not be drawn stays queued.
}

// A program that has changed its window's size waits for X and then draws. What X has drawn to a window is
// not part of our front buffer until that is read from the server.
void glXWaitX() try {
    const auto context = glx::current_context();
    Display* const display = context ? context->display->display.load() : nullptr;
    if (!display) return;
    XSync(display, False);
    const auto& window = context->gl->framebuffers.window_draw;
    if (!window) return;
    window->follow_window(gl::Follow::kNow);
    gl::follow_drawables(*context->gl);
} catch (const std::bad_alloc&) {
    // The picture keeps the size it has.
}
