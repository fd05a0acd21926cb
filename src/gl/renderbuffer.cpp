// Commands of renderbuffers (ARB_framebuffer_object).
#include <mutex>
#include <new>

#include "gl/context.h"
#include "gl/draw.h"
#include "gl/framebuffer_object.h"
#include "gl/generated/commands.h"
#include "gl/limits.h"
#include "gl/share.h"

namespace terrazzo::gl {
namespace {

struct StorageFormat {
    bool known = false, has_color = false;
    raster::TargetFormat format{};
};

StorageFormat color(raster::ColorFormat format, bool has_alpha) {
    return {true, true, {format, has_alpha, 0, 0, raster::RowOrder::kBottomFirst}};
}

StorageFormat depth_stencil(uint8_t depth_bits, uint8_t stencil_bits) {
    return {true,
            false,
            {raster::ColorFormat::kRgba8, false, depth_bits, stencil_bits, raster::RowOrder::kBottomFirst}};
}

// Sizes below 8 bits get 8, but for 5-6-5; those above get 16.
StorageFormat storage_format(GLenum internal_format) {
    using raster::ColorFormat;
    switch (internal_format) {
        case GL_RGB565:
            return color(ColorFormat::kRgb565, false);
        case GL_R3_G3_B2:
        case GL_RGB:
        case GL_RGB4:
        case GL_RGB5:
        case GL_RGB8:
            return color(ColorFormat::kRgba8, false);
        case GL_RGB10:
        case GL_RGB12:
        case GL_RGB16:
            return color(ColorFormat::kRgba16, false);
        case GL_RGBA:
        case GL_RGBA2:
        case GL_RGBA4:
        case GL_RGB5_A1:
        case GL_RGBA8:
            return color(ColorFormat::kRgba8, true);
        case GL_RGB10_A2:
        case GL_RGBA12:
        case GL_RGBA16:
            return color(ColorFormat::kRgba16, true);
        case GL_DEPTH_COMPONENT16:
            return depth_stencil(16, 0);
        case GL_DEPTH_COMPONENT:
        case GL_DEPTH_COMPONENT24:
        case GL_DEPTH_COMPONENT32:
            return depth_stencil(24, 0);
        case GL_DEPTH_STENCIL:
        case GL_DEPTH24_STENCIL8:
            return depth_stencil(24, 8);
        case GL_STENCIL_INDEX:
        case GL_STENCIL_INDEX1:
        case GL_STENCIL_INDEX4:
        case GL_STENCIL_INDEX8:
        case GL_STENCIL_INDEX16:
            return depth_stencil(0, 8);
    }
    return {};
}

}  // namespace

GLint renderbuffer_bits(const Renderbuffer& r, GLenum pname) {
    const bool is_565 = r.format.color == raster::ColorFormat::kRgb565;
    const GLint bits = !r.has_color ? 0 : r.format.color == raster::ColorFormat::kRgba16 ? 16 : 8;
    if (!r.planes) return 0;
    switch (pname) {
        case GL_RENDERBUFFER_RED_SIZE:
        case GL_RENDERBUFFER_BLUE_SIZE:
            return is_565 ? 5 : bits;
        case GL_RENDERBUFFER_GREEN_SIZE:
            return is_565 ? 6 : bits;
        case GL_RENDERBUFFER_ALPHA_SIZE:
            return r.format.has_alpha ? bits : 0;
        case GL_RENDERBUFFER_DEPTH_SIZE:
            return r.format.depth_bits;
        case GL_RENDERBUFFER_STENCIL_SIZE:
            return r.format.stencil_bits;
    }
    return 0;
}

void gen_renderbuffers(Context& ctx, GLsizei n, GLuint* renderbuffers) {
    if (n < 0) return record_error(ctx, GL_INVALID_VALUE, "n is negative");
    const std::lock_guard lock(ctx.shared->mutex);
    RenderbufferNames& names = ctx.shared->renderbuffers;
    GLsizei made = 0;
    try {
        for (; made < n; ++made) {
            while (names.next_name == 0 || names.objects.contains(names.next_name)) ++names.next_name;
            names.objects.emplace(names.next_name, nullptr);
            renderbuffers[made] = names.next_name++;
        }
    } catch (...) {
        while (made > 0) names.objects.erase(renderbuffers[--made]);
        throw;
    }
}

void delete_renderbuffers(Context& ctx, GLsizei n, const GLuint* renderbuffers) {
    if (n < 0) return record_error(ctx, GL_INVALID_VALUE, "n is negative");
    settle_framebuffers(ctx);
    const std::lock_guard lock(ctx.shared->mutex);
    auto& objects = ctx.shared->renderbuffers.objects;
    for (GLsizei i = 0; i < n; ++i) {
        const auto found = objects.find(renderbuffers[i]);
        if (found == objects.end()) continue;
        for (Framebuffer* const framebuffer : {ctx.framebuffers.draw.get(), ctx.framebuffers.read.get()}) {
            if (!framebuffer || !found->second) continue;
            for (Attachment& a : framebuffer->attachments)
                if (a.renderbuffer == found->second) a = {};
        }
        if (ctx.framebuffers.renderbuffer == found->second) ctx.framebuffers.renderbuffer.reset();
        objects.erase(found);
    }
}

GLboolean is_renderbuffer(Context& ctx, GLuint renderbuffer) {
    const std::lock_guard lock(ctx.shared->mutex);
    const auto found = ctx.shared->renderbuffers.objects.find(renderbuffer);
    return found != ctx.shared->renderbuffers.objects.end() && found->second;
}

void bind_renderbuffer(Context& ctx, GLenum target, GLuint renderbuffer) {
    if (target != GL_RENDERBUFFER)
        return record_error(ctx, GL_INVALID_ENUM, "the target is not GL_RENDERBUFFER");
    if (renderbuffer == 0) return ctx.framebuffers.renderbuffer.reset();
    const std::lock_guard lock(ctx.shared->mutex);
    auto& objects = ctx.shared->renderbuffers.objects;
    const auto found = objects.find(renderbuffer);
    std::shared_ptr<Renderbuffer> object = found == objects.end() ? nullptr : found->second;
    if (!object) {
        object = std::make_shared<Renderbuffer>();
        object->name = renderbuffer;
        objects[renderbuffer] = object;
    }
    ctx.framebuffers.renderbuffer = std::move(object);
}

// Whoever asks for several samples gets the one number that there is.
void renderbuffer_storage_multisample(Context& ctx, GLenum target, GLsizei samples, GLenum internalformat,
                                      GLsizei width, GLsizei height) {
    if (target != GL_RENDERBUFFER)
        return record_error(ctx, GL_INVALID_ENUM, "the target is not GL_RENDERBUFFER");
    StorageFormat chosen = storage_format(internalformat);
    if (!chosen.known) return record_error(ctx, GL_INVALID_ENUM, "no format of renderbuffers");
    if (width < 0 || height < 0 || width > kMaxRenderbufferSize || height > kMaxRenderbufferSize)
        return record_error(ctx, GL_INVALID_VALUE, "the size is negative or too large");
    if (samples < 0 || samples > kMaxSamples)
        return record_error(ctx, GL_INVALID_VALUE, "there are not so many samples");
    static_assert(kMaxSamples == raster::kMaxSamples);
    chosen.format.samples = samples > 0 ? kMaxSamples : 1;
    Renderbuffer* const renderbuffer = ctx.framebuffers.renderbuffer.get();
    if (!renderbuffer) return record_error(ctx, GL_INVALID_OPERATION, "no renderbuffer is bound");
    std::shared_ptr<raster::Target> planes;
    if (width > 0 && height > 0) {
        planes = chosen.has_color ? std::make_shared<raster::Target>(width, height, chosen.format)
                                  : raster::Target::depth_and_stencil(width, height, chosen.format);
        planes->start_over();
    }
    settle_framebuffers(ctx);
    begin_change(ctx, Dirty::kFramebuffer);
    const std::lock_guard lock(ctx.shared->mutex);
    renderbuffer->internal_format = internalformat;
    renderbuffer->width = width;
    renderbuffer->height = height;
    renderbuffer->format = chosen.format;
    renderbuffer->has_color = chosen.has_color;
    renderbuffer->planes = std::move(planes);
}

void renderbuffer_storage(Context& ctx, GLenum target, GLenum internalformat, GLsizei width, GLsizei height) {
    renderbuffer_storage_multisample(ctx, target, 0, internalformat, width, height);
}

void get_renderbuffer_parameteriv(Context& ctx, GLenum target, GLenum pname, GLint* params) {
    if (target != GL_RENDERBUFFER)
        return record_error(ctx, GL_INVALID_ENUM, "the target is not GL_RENDERBUFFER");
    if (!ctx.framebuffers.renderbuffer)
        return record_error(ctx, GL_INVALID_OPERATION, "no renderbuffer is bound");
    const std::lock_guard lock(ctx.shared->mutex);
    const Renderbuffer* const r = ctx.framebuffers.renderbuffer.get();
    switch (pname) {
        case GL_RENDERBUFFER_WIDTH:
            *params = r->width;
            return;
        case GL_RENDERBUFFER_HEIGHT:
            *params = r->height;
            return;
        case GL_RENDERBUFFER_INTERNAL_FORMAT:
            *params = static_cast<GLint>(r->internal_format);
            return;
        case GL_RENDERBUFFER_SAMPLES:
            *params = r->format.samples > 1 ? r->format.samples : 0;
            return;
        case GL_RENDERBUFFER_RED_SIZE:
        case GL_RENDERBUFFER_GREEN_SIZE:
        case GL_RENDERBUFFER_BLUE_SIZE:
        case GL_RENDERBUFFER_ALPHA_SIZE:
        case GL_RENDERBUFFER_DEPTH_SIZE:
        case GL_RENDERBUFFER_STENCIL_SIZE:
            *params = renderbuffer_bits(*r, pname);
            return;
    }
    record_error(ctx, GL_INVALID_ENUM, "no such renderbuffer parameter");
}

}  // namespace terrazzo::gl
