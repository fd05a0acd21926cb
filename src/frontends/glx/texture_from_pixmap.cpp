// GLX_EXT_texture_from_pixmap: a pixmap's pixels as the image of the bound texture. They are copied when they
// are bound: what is drawn to the pixmap later is seen when it is bound again, as the extension allows.
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/glx.h>

#include <exception>

#include "frontends/glx/display.h"
#include "frontends/glx/own_pixels.h"
#include "frontends/glx/protocol.h"
#include "gl/generated/dispatch.h"

namespace gl = terrazzo::gl;
namespace glx = terrazzo::glx;
using terrazzo::glx::registry;

// Row 0 of a texture is the pixmap's bottom row (GLX_Y_INVERTED_EXT is False).
void glXBindTexImageEXT(Display* display, GLXDrawable name, int buffer, const int*) try {
    const auto drawable = glx::find_drawable(display, name);
    const auto fail = [&](int code, bool is_glx) {
        glx::send_error(display, code, is_glx, name, X_GLXVendorPrivate);
    };
    if (!drawable || drawable->kind != glx::Kind::kPixmap || !drawable->server)
        return fail(GLXBadPixmap, true);
    if (buffer < GLX_FRONT_LEFT_EXT || buffer > GLX_AUX9_EXT) return fail(BadValue, false);
    if (drawable->texture_format == GLX_TEXTURE_FORMAT_NONE_EXT) return fail(BadMatch, false);
    const auto context = glx::current_context();
    if (!context) return;
    drawable->server->follow_window(gl::Follow::kOncePerPicture);
    const auto picture = drawable->server->read_server();
    if (!picture) return fail(BadDrawable, false);

    const bool is_565 = drawable->config->visual.color == terrazzo::raster::ColorFormat::kRgb565;
    const GLenum format = is_565 ? GL_RGB
                          : drawable->config->visual.layout == terrazzo::raster::PixelLayout::kBgra8
                              ? GL_BGRA
                              : GL_RGBA;
    const GLenum type = is_565 ? GL_UNSIGNED_SHORT_5_6_5 : GL_UNSIGNED_BYTE;
    const GLint internal = drawable->texture_format == GLX_TEXTURE_FORMAT_RGBA_EXT ? GL_RGBA : GL_RGB;
    const glx::OwnPixels own(*context->gl);
    // Not through the program's list, if it is compiling one.
    const gl::Dispatch& commands = *context->gl->dispatch.execute;
    if (drawable->texture_target == GLX_TEXTURE_1D_EXT) {
        commands.TexImage1D(context->gl.get(), GL_TEXTURE_1D, 0, internal, picture->width, 0, format, type,
                            picture->rows.data());
    } else {
        commands.TexImage2D(context->gl.get(), GL_TEXTURE_2D, 0, internal, picture->width, picture->height, 0,
                            format, type, picture->rows.data());
    }
} catch (const std::exception&) {
    glx::send_error(display, BadAlloc, false, name, X_GLXVendorPrivate);
}

// The texture keeps what it has: it is the texture's own.
void glXReleaseTexImageEXT(Display* display, GLXDrawable name, int buffer) {
    const auto drawable = glx::find_drawable(display, name);
    if (!drawable || drawable->kind != glx::Kind::kPixmap)
        return glx::send_error(display, GLXBadPixmap, true, name, X_GLXVendorPrivate);
    if (buffer < GLX_FRONT_LEFT_EXT || buffer > GLX_AUX9_EXT)
        glx::send_error(display, BadValue, false, name, X_GLXVendorPrivate);
}
