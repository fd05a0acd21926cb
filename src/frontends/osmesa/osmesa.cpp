// The OSMesa API: contexts that draw into memory of the caller's. Behaviour follows Mesa 22.3's libOSMesa.
//
// Pictures are drawn in a target of our own and reach the caller's buffer at glFlush, glFinish and when the
// context is let go. Nothing here throws: lack of memory makes a creation or MakeCurrent fail. Wrong
// arguments are told to the debug log.
#include <GL/osmesa.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <exception>
#include <utility>

#include "frontends/osmesa/attributes.h"
#include "frontends/osmesa/current.h"
#include "frontends/osmesa/formats.h"
#include "frontends/osmesa/osmesa_context.h"
#include "gl/debug_log.h"
#include "gl/draw.h"
#include "gl/entry.h"
#include "gl/limits.h"

namespace gl = terrazzo::gl;
namespace osmesa = terrazzo::osmesa;
namespace raster = terrazzo::raster;

namespace {

raster::TargetFormat target_format(raster::PixelLayout layout, const gl::Config& config) {
    using raster::ColorFormat;
    using raster::PixelLayout;
    raster::TargetFormat format;
    format.depth_bits = static_cast<std::uint8_t>(config.depth_bits);
    format.stencil_bits = static_cast<std::uint8_t>(config.stencil_bits);
    switch (layout) {
        case PixelLayout::kRgba16:
        case PixelLayout::kRgb16:
            format.color = ColorFormat::kRgba16;
            break;
        case PixelLayout::kRgba32F:
        case PixelLayout::kRgb32F:
            format.color = ColorFormat::kRgba32F;
            break;
        case PixelLayout::kRgb565:
            format.color = ColorFormat::kRgb565;
            break;
        default:
            format.color = ColorFormat::kRgba8;
    }
    format.has_alpha = layout != PixelLayout::kRgb8 && layout != PixelLayout::kRgb16 &&
                       layout != PixelLayout::kRgb32F && layout != PixelLayout::kRgb565;
    return format;
}

// Gives the context something to draw to. Throws std::bad_alloc and changes nothing then.
void attach_buffers(osmesa_context& context, int width, int height, const raster::TargetFormat& format) {
    osmesa::ClientBuffer& drawable = *context.drawable;
    gl::Drawable::Buffers buffers;
    const bool are_new = !drawable.has_buffers(width, height, format);
    if (are_new) {
        buffers = drawable.make_buffers(width, height, format);
        drawable.exchange_buffers(buffers);
    }
    try {
        gl::attach_drawables(*context.gl, context.drawable, context.drawable);
    } catch (...) {
        if (are_new) drawable.exchange_buffers(buffers);
        throw;
    }
}

GLboolean refuse(const char* rule) {
    gl::debug_log("OSMesaMakeCurrent", rule);
    return GL_FALSE;
}

}  // namespace

OSMesaContext OSMesaCreateContextAttribs(const int* attributes, OSMesaContext share_list) try {
    const auto parsed = osmesa::parse_attributes(attributes);
    if (!parsed) return nullptr;
    auto context = std::make_unique<osmesa_context>();
    context->gl = gl::create_context(parsed->config, share_list ? share_list->gl.get() : nullptr);
    context->drawable = std::make_shared<osmesa::ClientBuffer>(*context);
    context->format = parsed->format;
    return context.release();
} catch (const std::exception&) {
    return nullptr;
}

OSMesaContext OSMesaCreateContextExt(GLenum format, GLint depth_bits, GLint stencil_bits, GLint accum_bits,
                                     OSMesaContext share_list) {
    const int attributes[] = {
        OSMESA_FORMAT, static_cast<int>(format), OSMESA_DEPTH_BITS, depth_bits, OSMESA_STENCIL_BITS,
        stencil_bits,  OSMESA_ACCUM_BITS,        accum_bits,        0};
    return OSMesaCreateContextAttribs(attributes, share_list);
}

OSMesaContext OSMesaCreateContext(GLenum format, OSMesaContext share_list) {
    return OSMesaCreateContextExt(format, 24, 8, 0, share_list);
}

void OSMesaDestroyContext(OSMesaContext context) {
    if (context) osmesa::destroy(context);
}

GLboolean OSMesaMakeCurrent(OSMesaContext context, void* buffer, GLenum type, GLsizei width,
                            GLsizei height) try {
    if (!context && !buffer) {
        osmesa::present_before(nullptr);
        osmesa::set_current(nullptr);
        return GL_TRUE;
    }
    if (!context) return refuse("the context is null");
    if (!buffer) return refuse("the buffer is null");
    if (width < 1 || height < 1) return refuse("width or height is less than 1");
    if (width > gl::kMaxViewportSize || height > gl::kMaxViewportSize)
        return refuse("width or height is too large");
    const auto layout = osmesa::pixel_layout(context->format, type);
    if (!layout) return refuse("the format of the context does not go with this type");

    osmesa::present_before(context);
    gl::finish_drawing(*context->gl);
    attach_buffers(*context, width, height, target_format(*layout, context->gl->config));
    if (width != context->width || height != context->height) context->depth = {};
    context->buffer = static_cast<std::byte*>(buffer);
    context->type = type;
    context->width = width;
    context->height = height;
    osmesa::set_current(context);
    return GL_TRUE;
} catch (const std::exception&) {
    return refuse("not enough memory");
}

OSMesaContext OSMesaGetCurrentContext() {
    return osmesa::current_context();
}

void OSMesaPixelStore(GLint pname, GLint value) {
    osmesa_context* context = osmesa::current_context();
    if (!context) return gl::debug_log("OSMesaPixelStore", "no context is current");
    switch (pname) {
        case OSMESA_ROW_LENGTH:
            context->row_length = value;
            return;
        case OSMESA_Y_UP:
            context->y_up = value != 0;
            return;
        default:
            gl::debug_log("OSMesaPixelStore", "unknown pname");
    }
}

void OSMesaGetIntegerv(GLint pname, GLint* value) {
    if (!value) return gl::debug_log("OSMesaGetIntegerv", "value is null");
    const osmesa_context none;
    const osmesa_context* current = osmesa::current_context();
    const osmesa_context& context = current ? *current : none;
    switch (pname) {
        case OSMESA_WIDTH:
            *value = context.width;
            return;
        case OSMESA_HEIGHT:
            *value = context.height;
            return;
        case OSMESA_FORMAT:
            *value = context.format;
            return;
        case OSMESA_TYPE:
            *value = static_cast<GLint>(context.type);
            return;
        case OSMESA_ROW_LENGTH:
            *value = context.row_length;
            return;
        case OSMESA_Y_UP:
            *value = context.y_up;
            return;
        case OSMESA_MAX_WIDTH:
        case OSMESA_MAX_HEIGHT:
            *value = gl::kMaxViewportSize;
            return;
        default:
            gl::debug_log("OSMesaGetIntegerv", "unknown pname");
    }
}

GLboolean OSMesaGetDepthBuffer(OSMesaContext context, GLint* width, GLint* height, GLint* bytes_per_value,
                               void** buffer) try {
    if (!width || !height || !bytes_per_value || !buffer) return GL_FALSE;
    *width = *height = *bytes_per_value = 0;
    *buffer = nullptr;
    if (!context || !context->buffer || context->gl->config.depth_bits == 0) return GL_FALSE;
    osmesa::read_depth(*context);
    *width = context->width;
    *height = context->height;
    *bytes_per_value = context->gl->config.depth_bits == 16 ? 2 : 4;
    *buffer = context->depth.data();
    return GL_TRUE;
} catch (const std::exception&) {
    return GL_FALSE;
}

GLboolean OSMesaGetColorBuffer(OSMesaContext context, GLint* width, GLint* height, GLint* format,
                               void** buffer) {
    if (!width || !height || !format || !buffer) return GL_FALSE;
    const bool drawn_to = context && context->buffer;
    *width = drawn_to ? context->width : 0;
    *height = drawn_to ? context->height : 0;
    *format = drawn_to ? context->format : 0;
    *buffer = drawn_to ? context->buffer : nullptr;
    return drawn_to;
}

// Without effect in Mesa 22.3 as well: the colours of fixed-function vertices are clamped before they are
// drawn.
void OSMesaColorClamp(GLboolean) {}

// There are no filters to turn on.
void OSMesaPostprocess(OSMesaContext, const char*, unsigned) {}

OSMESAproc OSMesaGetProcAddress(const char* name) {
    static const std::pair<const char*, OSMESAproc> kFunctions[] = {
        {"OSMesaColorClamp", reinterpret_cast<OSMESAproc>(OSMesaColorClamp)},
        {"OSMesaCreateContext", reinterpret_cast<OSMESAproc>(OSMesaCreateContext)},
        {"OSMesaCreateContextAttribs", reinterpret_cast<OSMESAproc>(OSMesaCreateContextAttribs)},
        {"OSMesaCreateContextExt", reinterpret_cast<OSMESAproc>(OSMesaCreateContextExt)},
        {"OSMesaDestroyContext", reinterpret_cast<OSMESAproc>(OSMesaDestroyContext)},
        {"OSMesaGetColorBuffer", reinterpret_cast<OSMESAproc>(OSMesaGetColorBuffer)},
        {"OSMesaGetCurrentContext", reinterpret_cast<OSMESAproc>(OSMesaGetCurrentContext)},
        {"OSMesaGetDepthBuffer", reinterpret_cast<OSMESAproc>(OSMesaGetDepthBuffer)},
        {"OSMesaGetIntegerv", reinterpret_cast<OSMESAproc>(OSMesaGetIntegerv)},
        {"OSMesaGetProcAddress", reinterpret_cast<OSMESAproc>(OSMesaGetProcAddress)},
        {"OSMesaMakeCurrent", reinterpret_cast<OSMESAproc>(OSMesaMakeCurrent)},
        {"OSMesaPixelStore", reinterpret_cast<OSMESAproc>(OSMesaPixelStore)},
        {"OSMesaPostprocess", reinterpret_cast<OSMESAproc>(OSMesaPostprocess)},
    };
    if (!name) return nullptr;
    for (const auto& [function, address] : kFunctions) {
        if (std::strcmp(name, function) == 0) return address;
    }
    return gl::find_proc_address(name);
}
