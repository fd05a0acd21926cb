// GetFramebufferAttachmentParameteriv: what is attached to a frame buffer object, and what the window
// system's frame buffer is made of (ARB_framebuffer_object, GL 3.0 §6.1.3).
//
// A buffer that is not there has the type GL_NONE and the name 0; every other question about it is
// GL_INVALID_OPERATION, a question that nothing answers GL_INVALID_ENUM.
#include <GL/gl.h>

#include <utility>

#include "gl/context.h"
#include "gl/framebuffer_object.h"
#include "gl/generated/commands.h"

namespace terrazzo::gl {
namespace {

bool is_size(GLenum pname) {
    return pname >= GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE && pname <= GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE;
}

// What every buffer that is there can be asked for, beside its type and name.
bool is_for_all(GLenum pname) {
    return is_size(pname) || pname == GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING ||
           pname == GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE;
}

// What only textures can be asked for.
bool is_for_textures(GLenum pname) {
    return pname == GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL ||
           pname == GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE ||
           pname == GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER;
}

void refuse(Context& ctx) {
    record_error(ctx, GL_INVALID_ENUM, "no such parameter of what is attached");
}

void query_missing(Context& ctx, GLenum pname, GLint* params) {
    if (pname == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE || pname == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME) {
        *params = 0;
    } else if (is_for_all(pname) || is_for_textures(pname)) {
        record_error(ctx, GL_INVALID_OPERATION, "there is no such buffer");
    } else {
        refuse(ctx);
    }
}

}  // namespace

GLint size_in_bits(const Attachment& a, GLenum pname) {
    if (a.renderbuffer) {
        const GLenum to_renderbuffer[] = {GL_RENDERBUFFER_RED_SIZE,   GL_RENDERBUFFER_GREEN_SIZE,
                                          GL_RENDERBUFFER_BLUE_SIZE,  GL_RENDERBUFFER_ALPHA_SIZE,
                                          GL_RENDERBUFFER_DEPTH_SIZE, GL_RENDERBUFFER_STENCIL_SIZE};
        return renderbuffer_bits(*a.renderbuffer,
                                 to_renderbuffer[pname - GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE]);
    }
    if (a.level >= kMaxTextureLevels) return 0;
    const TextureLevel& level = std::as_const(*a.texture).face(a.face)[static_cast<std::size_t>(a.level)];
    if (!level.format) return 0;
    const bool is_depth = level.format->base == GL_DEPTH_COMPONENT;
    switch (pname) {
        case GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE:
            return is_depth ? level.format->bits[0] : 0;
        case GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE:
            return has_stencil(level.internal_format) ? 8 : 0;
        default:
            return is_depth ? 0 : level.format->bits[pname - GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE];
    }
}

namespace {

GLint component_type(GLenum attachment) {
    return attachment == GL_STENCIL_ATTACHMENT || attachment == GL_STENCIL ? GL_INDEX
                                                                           : GL_UNSIGNED_NORMALIZED;
}

void query_texture(Context& ctx, const Attachment& a, GLenum pname, GLint* params) {
    switch (pname) {
        case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL:
            *params = a.level;
            return;
        case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE:
            *params = a.texture->target == GL_TEXTURE_CUBE_MAP ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + a.face : 0;
            return;
        case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER:
            *params = a.layer;
            return;
    }
    refuse(ctx);
}

void query_object(Context& ctx, Framebuffer& framebuffer, GLenum attachment, GLenum pname, GLint* params) {
    const std::vector<Attachment*> points = find_attachments(ctx, framebuffer, attachment);
    if (points.empty()) return;
    const Attachment& a = *points.front();
    if (points.size() == 2) {
        if (a.renderbuffer != points[1]->renderbuffer || a.texture != points[1]->texture)
            return record_error(ctx, GL_INVALID_OPERATION, "depth and stencil are not the same object");
        if (pname == GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE)
            return record_error(ctx, GL_INVALID_OPERATION, "depth and stencil have no common type");
    }
    if (a.is_empty()) return query_missing(ctx, pname, params);
    const auto lock = lock_textures(ctx);
    if (pname == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) {
        *params = a.renderbuffer ? GL_RENDERBUFFER : GL_TEXTURE;
    } else if (pname == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME) {
        *params = static_cast<GLint>(a.renderbuffer ? a.renderbuffer->name : a.texture->name);
    } else if (is_size(pname)) {
        *params = size_in_bits(a, pname);
    } else if (pname == GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING) {
        *params = GL_LINEAR;
    } else if (pname == GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) {
        *params = component_type(attachment);
    } else if (a.texture) {
        query_texture(ctx, a, pname, params);
    } else {
        refuse(ctx);
    }
}

// A buffer of the window system's frame buffer, by DrawBuffer's names for them or as GL_DEPTH and GL_STENCIL.
struct WindowBuffer {
    bool known = false, there = false;
};

WindowBuffer find_window_buffer(const Drawable* drawable, GLenum attachment) {
    const bool any = drawable && drawable->target();
    switch (attachment) {
        case GL_FRONT:
        case GL_FRONT_LEFT:
            return {true, any};
        case GL_BACK:
        case GL_BACK_LEFT:
            return {true, any && drawable->buffering() != Buffering::kSingle};
        case GL_FRONT_RIGHT:
        case GL_BACK_RIGHT:
            return {true, false};
        case GL_DEPTH:
            return {true, any && drawable->target()->format().depth_bits != 0};
        case GL_STENCIL:
            return {true, any && drawable->target()->format().stencil_bits != 0};
    }
    return {};
}

GLint size_in_bits(const raster::TargetFormat& format, GLenum attachment, GLenum pname) {
    const bool is_color = attachment != GL_DEPTH && attachment != GL_STENCIL;
    const ColorBits color = is_color ? color_bits(format) : ColorBits{};
    switch (pname) {
        case GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE:
            return color.red;
        case GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE:
            return color.green;
        case GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE:
            return color.blue;
        case GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE:
            return color.alpha;
        case GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE:
            return attachment == GL_DEPTH ? format.depth_bits : 0;
        default:
            return attachment == GL_STENCIL ? format.stencil_bits : 0;
    }
}

void query_window(Context& ctx, const Drawable* drawable, GLenum attachment, GLenum pname, GLint* params) {
    const WindowBuffer buffer = find_window_buffer(drawable, attachment);
    if (!buffer.known) return record_error(ctx, GL_INVALID_ENUM, "no buffer of the window system's");
    if (!buffer.there) return query_missing(ctx, pname, params);
    const raster::TargetFormat format = drawable->target()->format();
    if (pname == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) {
        *params = GL_FRAMEBUFFER_DEFAULT;
    } else if (pname == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME) {
        *params = 0;
    } else if (is_size(pname)) {
        *params = size_in_bits(format, attachment, pname);
    } else if (pname == GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING) {
        *params = GL_LINEAR;
    } else if (pname == GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) {
        const bool is_float = format.color == raster::ColorFormat::kRgba32F;
        const bool is_color = attachment != GL_DEPTH && attachment != GL_STENCIL;
        *params = is_color && is_float ? GL_FLOAT : component_type(attachment);
    } else {
        refuse(ctx);
    }
}

}  // namespace

void get_framebuffer_attachment_parameteriv(Context& ctx, GLenum target, GLenum attachment, GLenum pname,
                                            GLint* params) {
    const FramebufferBindings& bindings = ctx.framebuffers;
    const bool reads = target == GL_READ_FRAMEBUFFER;
    if (!reads && target != GL_FRAMEBUFFER && target != GL_DRAW_FRAMEBUFFER)
        return record_error(ctx, GL_INVALID_ENUM, "unknown frame buffer target");
    if (Framebuffer* const object = (reads ? bindings.read : bindings.draw).get())
        return query_object(ctx, *object, attachment, pname, params);
    query_window(ctx, (reads ? bindings.window_read : bindings.window_draw).get(), attachment, pname, params);
}

}  // namespace terrazzo::gl
