// Surfaces and showing them (EGL 1.5 §3.5, §3.6, §3.10).
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <exception>

#include "frontends/egl/display.h"
#include "frontends/window/refresh.h"
#include "frontends/x11/reply.h"
#include "gl/generated/commands.h"
#include "gl/limits.h"
#include "gl/surface.h"

namespace egl = terrazzo::egl;
namespace gl = terrazzo::gl;
namespace window = terrazzo::window;
namespace x11 = terrazzo::x11;

namespace {

// The surface's handle, unless the display has been terminated meanwhile or its window has a surface by now.
EGLSurface remember(egl::Display& display, std::shared_ptr<egl::Surface> surface) {
    const auto guard = egl::lock();
    if (!display.is_initialized) return egl::fail(EGL_NOT_INITIALIZED);
    if (surface->kind == egl::Kind::kWindow) {
        for (const auto& [name, other] : display.surfaces) {
            if (other->server && other->server->id() == surface->server->id())
                return egl::fail(EGL_BAD_ALLOC);
        }
    }
    const EGLSurface made = surface.get();
    display.surfaces.emplace(made, std::move(surface));
    egl::set_error(EGL_SUCCESS);
    return made;
}

// Lists of EGLint and of EGLAttrib mean the same.
template <class Value>
EGLint parse_native(const Value* list, bool is_window, egl::Surface& out) {
    for (; list && *list != EGL_NONE; list += 2) {
        switch (list[0]) {
            case EGL_RENDER_BUFFER:
                if (!is_window) return EGL_BAD_ATTRIBUTE;
                if (list[1] != EGL_BACK_BUFFER && list[1] != EGL_SINGLE_BUFFER) return EGL_BAD_ATTRIBUTE;
                out.wants_back_buffer = list[1] == EGL_BACK_BUFFER;
                break;
            case EGL_GL_COLORSPACE:
                if (list[1] != EGL_GL_COLORSPACE_LINEAR) return EGL_BAD_MATCH;
                break;
            case EGL_VG_COLORSPACE:
            case EGL_VG_ALPHA_FORMAT:
                break;
            default:
                return EGL_BAD_ATTRIBUTE;
        }
    }
    return EGL_SUCCESS;
}

template <class Value>
EGLSurface create_native(EGLDisplay handle, EGLConfig config_handle, std::uint32_t id,
                         const Value* attributes, egl::Kind kind) try {
    egl::Display* const display = egl::initialized_display(handle);
    if (!display) return EGL_NO_SURFACE;
    const bool is_window = kind == egl::Kind::kWindow;
    const EGLint no_drawable = is_window ? EGL_BAD_NATIVE_WINDOW : EGL_BAD_NATIVE_PIXMAP;
    // There are no native ones, so whatever was given is none (EGL_MESA_platform_surfaceless).
    if (display->platform == egl::Platform::kSurfaceless) return egl::fail(no_drawable);
    const auto config = egl::find_config(*display, config_handle);
    const auto connection = egl::connection_of(*display);
    if (!config) return egl::fail(EGL_BAD_CONFIG);
    if (!config->visual || !connection) return egl::fail(EGL_BAD_MATCH);
    auto surface = std::make_shared<egl::Surface>();
    surface->kind = kind;
    surface->config = config;
    if (const EGLint error = parse_native(attributes, is_window, *surface); error != EGL_SUCCESS)
        return egl::fail(error);
    xcb_connection_t* const xcb = connection->xcb;
    const auto geometry = x11::geometry(xcb, id);
    if (!geometry || (x11::window_visual(xcb, id) != 0) != is_window) return egl::fail(no_drawable);
    if (geometry->depth != config->visual->image.depth) return egl::fail(EGL_BAD_MATCH);
    const bool double_buffered = is_window && surface->wants_back_buffer;
    const auto buffers = x11::ServerDrawable::make(
        connection, id, x11::BufferFormat{*config->visual, config->target_format(), double_buffered},
        *geometry);
    surface->server = buffers.get();
    surface->buffers = buffers;
    return remember(*display, std::move(surface));
} catch (const std::exception&) {
    return egl::fail(EGL_BAD_ALLOC);
}

// Platform functions take a pointer to the id: an Xlib one, which is a long, or xcb's.
std::uint32_t native_id(EGLDisplay handle, const void* pointer) {
    if (!pointer) return 0;
    const egl::Display* const display = egl::find_display(handle);
    if (display && display->name == EGL_PLATFORM_XCB_EXT) return *static_cast<const std::uint32_t*>(pointer);
    return static_cast<std::uint32_t>(*static_cast<const unsigned long*>(pointer));
}

// The calling thread's context if it draws to the surface.
gl::Context* context_drawing_to(const egl::Surface& surface) {
    const auto context = egl::current_context();
    return context && context->draw.get() == &surface ? context->gl.get() : nullptr;
}

}  // namespace

EGLSurface eglCreateWindowSurface(EGLDisplay display, EGLConfig config, EGLNativeWindowType window,
                                  const EGLint* attributes) {
    return create_native(display, config, static_cast<std::uint32_t>(window), attributes, egl::Kind::kWindow);
}

EGLSurface eglCreatePixmapSurface(EGLDisplay display, EGLConfig config, EGLNativePixmapType pixmap,
                                  const EGLint* attributes) {
    return create_native(display, config, static_cast<std::uint32_t>(pixmap), attributes, egl::Kind::kPixmap);
}

EGLSurface eglCreatePlatformWindowSurface(EGLDisplay display, EGLConfig config, void* window,
                                          const EGLAttrib* attributes) {
    return create_native(display, config, native_id(display, window), attributes, egl::Kind::kWindow);
}

EGLSurface eglCreatePlatformPixmapSurface(EGLDisplay display, EGLConfig config, void* pixmap,
                                          const EGLAttrib* attributes) {
    return create_native(display, config, native_id(display, pixmap), attributes, egl::Kind::kPixmap);
}

EGLSurface eglCreatePlatformWindowSurfaceEXT(EGLDisplay display, EGLConfig config, void* window,
                                             const EGLint* attributes) {
    return create_native(display, config, native_id(display, window), attributes, egl::Kind::kWindow);
}

EGLSurface eglCreatePlatformPixmapSurfaceEXT(EGLDisplay display, EGLConfig config, void* pixmap,
                                             const EGLint* attributes) {
    return create_native(display, config, native_id(display, pixmap), attributes, egl::Kind::kPixmap);
}

EGLSurface eglCreatePbufferSurface(EGLDisplay handle, EGLConfig config_handle, const EGLint* attributes) try {
    egl::Display* const display = egl::initialized_display(handle);
    if (!display) return EGL_NO_SURFACE;
    const auto config = egl::find_config(*display, config_handle);
    if (!config) return egl::fail(EGL_BAD_CONFIG);
    auto surface = std::make_shared<egl::Surface>();
    surface->config = config;
    int width = 0, height = 0;
    for (const EGLint* a = attributes; a && *a != EGL_NONE; a += 2) {
        switch (a[0]) {
            case EGL_WIDTH:
                width = a[1];
                break;
            case EGL_HEIGHT:
                height = a[1];
                break;
            case EGL_LARGEST_PBUFFER:
                surface->is_largest = a[1] != 0;
                break;
            case EGL_TEXTURE_FORMAT:
            case EGL_TEXTURE_TARGET:  // for OpenGL ES
                if (a[1] != EGL_NO_TEXTURE) return egl::fail(EGL_BAD_MATCH);
                break;
            case EGL_MIPMAP_TEXTURE:
            case EGL_VG_COLORSPACE:
            case EGL_VG_ALPHA_FORMAT:
                break;
            case EGL_GL_COLORSPACE:
                if (a[1] != EGL_GL_COLORSPACE_LINEAR) return egl::fail(EGL_BAD_MATCH);
                break;
            default:
                return egl::fail(EGL_BAD_ATTRIBUTE);
        }
    }
    if (width < 0 || height < 0) return egl::fail(EGL_BAD_PARAMETER);
    if (std::max(width, height) > gl::kMaxViewportSize && !surface->is_largest)
        return egl::fail(EGL_BAD_ALLOC);
    width = std::clamp(width, 1, gl::kMaxViewportSize);
    height = std::clamp(height, 1, gl::kMaxViewportSize);
    surface->buffers = std::make_shared<gl::Drawable>(gl::Buffering::kSingleByEitherName);
    surface->buffers->allocate(width, height, config->target_format());
    return remember(*display, std::move(surface));
} catch (const std::exception&) {
    return egl::fail(EGL_BAD_ALLOC);
}

// There is no client API whose buffers could become pbuffers.
EGLSurface eglCreatePbufferFromClientBuffer(EGLDisplay handle, EGLenum, EGLClientBuffer, EGLConfig,
                                            const EGLint*) {
    if (!egl::initialized_display(handle)) return EGL_NO_SURFACE;
    return egl::fail(EGL_BAD_PARAMETER);
}

// Where it is current it lives on.
EGLBoolean eglDestroySurface(EGLDisplay handle, EGLSurface surface) {
    egl::Display* const display = egl::initialized_display(handle);
    if (!display) return EGL_FALSE;
    const auto last = egl::find_surface(*display, surface);  // dies without the lock
    const auto guard = egl::lock();
    if (!last || display->surfaces.erase(surface) == 0) return egl::fail(EGL_BAD_SURFACE);
    egl::set_error(EGL_SUCCESS);
    return EGL_TRUE;
}

EGLBoolean eglQuerySurface(EGLDisplay handle, EGLSurface surface_handle, EGLint attribute, EGLint* value) {
    egl::Display* const display = egl::initialized_display(handle);
    if (!display) return EGL_FALSE;
    const auto surface = egl::find_surface(*display, surface_handle);
    if (!surface) return egl::fail(EGL_BAD_SURFACE);
    if (!value) return egl::fail(EGL_BAD_PARAMETER);
    egl::set_error(EGL_SUCCESS);
    switch (attribute) {
        case EGL_WIDTH:
        case EGL_HEIGHT: {
            const auto connection = egl::connection_of(*display);
            const auto now = connection && surface->kind == egl::Kind::kWindow
                                 ? x11::geometry(connection->xcb, surface->server->id())
                                 : std::nullopt;
            const gl::Drawable& buffers = *surface->buffers;
            *value = attribute == EGL_WIDTH ? (now ? now->width : buffers.width())
                                            : (now ? now->height : buffers.height());
            return EGL_TRUE;
        }
        case EGL_CONFIG_ID:
            *value = surface->config->id;
            return EGL_TRUE;
        case EGL_RENDER_BUFFER:
            *value = surface->kind != egl::Kind::kPixmap && surface->wants_back_buffer ? EGL_BACK_BUFFER
                                                                                       : EGL_SINGLE_BUFFER;
            return EGL_TRUE;
        case EGL_SWAP_BEHAVIOR:
            *value = surface->preserves ? EGL_BUFFER_PRESERVED : EGL_BUFFER_DESTROYED;
            return EGL_TRUE;
        case EGL_MULTISAMPLE_RESOLVE:
            *value = EGL_MULTISAMPLE_RESOLVE_DEFAULT;
            return EGL_TRUE;
        case EGL_GL_COLORSPACE:
            *value = EGL_GL_COLORSPACE_LINEAR;
            return EGL_TRUE;
        case EGL_VG_COLORSPACE:
            *value = EGL_VG_COLORSPACE_sRGB;
            return EGL_TRUE;
        case EGL_VG_ALPHA_FORMAT:
            *value = EGL_VG_ALPHA_FORMAT_NONPRE;
            return EGL_TRUE;
        case EGL_HORIZONTAL_RESOLUTION:
        case EGL_VERTICAL_RESOLUTION:
        case EGL_PIXEL_ASPECT_RATIO:
            *value = EGL_UNKNOWN;
            return EGL_TRUE;
        case EGL_BUFFER_AGE_EXT: {
            if (!context_drawing_to(*surface)) return egl::fail(EGL_BAD_SURFACE);
            *value = surface->server ? static_cast<EGLint>(surface->server->buffer_age()) : 0;
            return EGL_TRUE;
        }
        case EGL_LARGEST_PBUFFER:
            if (surface->kind == egl::Kind::kPbuffer) *value = surface->is_largest;
            return EGL_TRUE;
        case EGL_TEXTURE_FORMAT:
        case EGL_TEXTURE_TARGET:
            if (surface->kind == egl::Kind::kPbuffer) *value = EGL_NO_TEXTURE;
            return EGL_TRUE;
        case EGL_MIPMAP_TEXTURE:
        case EGL_MIPMAP_LEVEL:
            if (surface->kind == egl::Kind::kPbuffer) *value = 0;
            return EGL_TRUE;
    }
    return egl::fail(EGL_BAD_ATTRIBUTE);
}

EGLBoolean eglSurfaceAttrib(EGLDisplay handle, EGLSurface surface_handle, EGLint attribute, EGLint value) {
    egl::Display* const display = egl::initialized_display(handle);
    if (!display) return EGL_FALSE;
    const auto surface = egl::find_surface(*display, surface_handle);
    if (!surface) return egl::fail(EGL_BAD_SURFACE);
    switch (attribute) {
        case EGL_SWAP_BEHAVIOR:
            if (value != EGL_BUFFER_PRESERVED && value != EGL_BUFFER_DESTROYED)
                return egl::fail(EGL_BAD_PARAMETER);
            surface->preserves = value == EGL_BUFFER_PRESERVED;
            break;
        case EGL_MULTISAMPLE_RESOLVE:
            if (value != EGL_MULTISAMPLE_RESOLVE_DEFAULT) return egl::fail(EGL_BAD_MATCH);
            break;
        case EGL_MIPMAP_LEVEL:
            break;
        default:
            return egl::fail(EGL_BAD_ATTRIBUTE);
    }
    egl::set_error(EGL_SUCCESS);
    return EGL_TRUE;
}

EGLBoolean eglSwapInterval(EGLDisplay handle, EGLint interval) {
    if (!egl::initialized_display(handle)) return EGL_FALSE;
    const auto context = egl::current_context();
    if (!context) return egl::fail(EGL_BAD_CONTEXT);
    if (!context->draw) return egl::fail(EGL_BAD_SURFACE);
    context->draw->swap_interval = std::clamp(interval, 0, 0x7fff);
    context->draw->last_msc = window::msc_at(window::current_ust());
    egl::set_error(EGL_SUCCESS);
    return EGL_TRUE;
}

// A surface is posted by the thread that draws to it (EGL 1.5 §3.10.5).
EGLBoolean eglSwapBuffers(EGLDisplay handle, EGLSurface surface_handle) try {
    egl::Display* const display = egl::initialized_display(handle);
    if (!display) return EGL_FALSE;
    const auto surface = egl::find_surface(*display, surface_handle);
    gl::Context* const ctx = surface ? context_drawing_to(*surface) : nullptr;
    if (!ctx) return egl::fail(EGL_BAD_SURFACE);
    egl::set_error(EGL_SUCCESS);
    // Only a window's back buffer is swapped; of others what has been drawn so far is drawn.
    if (!surface->server || !surface->buffers->is_double_buffered()) {
        gl::present_window(*ctx);
        gl::finish(*ctx);
    } else {
        if (surface->swap_interval > 0)
            surface->last_msc = window::wait_for_msc(surface->last_msc + surface->swap_interval, 0, 0);
        surface->server->swap(ctx);
    }
    if (surface->kind == egl::Kind::kWindow && surface->server->is_gone())
        return egl::fail(EGL_BAD_NATIVE_WINDOW);
    return EGL_TRUE;
} catch (const std::exception&) {
    return egl::fail(EGL_BAD_ALLOC);
}

// What lies outside the damage is the same as before: showing it again changes nothing.
EGLBoolean eglSwapBuffersWithDamageKHR(EGLDisplay display, EGLSurface surface, const EGLint* rectangles,
                                       EGLint count) {
    if (!egl::initialized_display(display)) return EGL_FALSE;
    if (count < 0 || (count > 0 && !rectangles)) return egl::fail(EGL_BAD_PARAMETER);
    return eglSwapBuffers(display, surface);
}

EGLBoolean eglSwapBuffersWithDamageEXT(EGLDisplay display, EGLSurface surface, const EGLint* rectangles,
                                       EGLint count) {
    return eglSwapBuffersWithDamageKHR(display, surface, rectangles, count);
}

EGLBoolean eglCopyBuffers(EGLDisplay handle, EGLSurface surface_handle, EGLNativePixmapType pixmap) try {
    egl::Display* const display = egl::initialized_display(handle);
    if (!display) return EGL_FALSE;
    const auto surface = egl::find_surface(*display, surface_handle);
    gl::Context* const ctx = surface ? context_drawing_to(*surface) : nullptr;
    if (!ctx) return egl::fail(EGL_BAD_SURFACE);
    const auto connection = egl::connection_of(*display);
    xcb_connection_t* const xcb = connection ? connection->xcb : nullptr;
    const auto id = static_cast<xcb_drawable_t>(pixmap);
    const auto geometry = xcb ? x11::geometry(xcb, id) : std::nullopt;
    if (!geometry || !surface->config->visual || x11::window_visual(xcb, id) != 0)
        return egl::fail(EGL_BAD_NATIVE_PIXMAP);
    const x11::Visual& visual = *surface->config->visual;
    const gl::Drawable& buffers = *surface->buffers;
    if (geometry->depth != visual.image.depth || geometry->width != buffers.width() ||
        geometry->height != buffers.height())
        return egl::fail(EGL_BAD_MATCH);
    gl::finish(*ctx);
    x11::Image image(xcb, connection->may_share, visual.image, buffers.width(), buffers.height());
    gl::copy_picture(*surface->buffers, gl::ColorBuffer::kBack, visual.layout,
                     image.data() + (buffers.height() - 1) * image.stride(), -image.stride());
    const xcb_gcontext_t gc = xcb_generate_id(xcb);
    x11::quietly(xcb, xcb_create_gc_checked(xcb, gc, id, 0, nullptr));
    image.put(id, gc, 0, 0, buffers.width(), buffers.height());
    x11::quietly(xcb, xcb_free_gc_checked(xcb, gc));
    x11::geometry(xcb, id);  // the server has read the image when it answers
    egl::set_error(EGL_SUCCESS);
    return EGL_TRUE;
} catch (const std::exception&) {
    return egl::fail(EGL_BAD_ALLOC);
}

// No configuration's pbuffers can be textures: that is OpenGL ES's.
EGLBoolean eglBindTexImage(EGLDisplay handle, EGLSurface surface_handle, EGLint buffer) {
    egl::Display* const display = egl::initialized_display(handle);
    if (!display) return EGL_FALSE;
    if (!egl::find_surface(*display, surface_handle)) return egl::fail(EGL_BAD_SURFACE);
    return egl::fail(buffer == EGL_BACK_BUFFER ? EGL_BAD_MATCH : EGL_BAD_PARAMETER);
}

EGLBoolean eglReleaseTexImage(EGLDisplay display, EGLSurface surface, EGLint buffer) {
    return eglBindTexImage(display, surface, buffer);
}
