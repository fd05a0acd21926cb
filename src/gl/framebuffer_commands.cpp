// Commands of frame buffer objects: names, binding, attachments (ARB_framebuffer_object).
#include <algorithm>

#include "gl/context.h"
#include "gl/draw.h"
#include "gl/framebuffer_object.h"
#include "gl/generated/commands.h"
#include "gl/share.h"

namespace terrazzo::gl {
namespace {

constexpr int kColorAttachmentNames = 16;

// Binds `framebuffer`, null for the window system's, as what is drawn to; the draw buffer goes with it.
// Throws std::bad_alloc and changes nothing then.
void bind_draw(Context& ctx, std::shared_ptr<Framebuffer> framebuffer) {
    FramebufferBindings& bindings = ctx.framebuffers;
    if (framebuffer == bindings.draw) return;
    settle_framebuffers(ctx);
    begin_change(ctx, Dirty::kAll);
    const GLenum buffer_before = ctx.framebuffer.draw_buffer;
    const bool drawn_before = ctx.surface.drawn;
    const GLenum buffer = framebuffer ? framebuffer->draw_buffer : bindings.window_draw_buffer;
    // An object becomes the renderer's target when something is drawn.
    use_draw_drawable(ctx, framebuffer ? nullptr : bindings.window_draw, buffer);
    if (bindings.draw) {
        bindings.draw->draw_buffer = buffer_before;
    } else {
        bindings.window_draw_buffer = buffer_before;
        bindings.window_drawn = drawn_before;
    }
    ctx.framebuffer.draw_buffer = buffer;
    bindings.draw = std::move(framebuffer);
    if (!bindings.draw) {
        ctx.surface.drawn = bindings.window_drawn;
    } else if (bindings.draw->target()) {
        bindings.draw->target()->start_over();  // others may have drawn to its planes
    }
}

void bind_read(Context& ctx, std::shared_ptr<Framebuffer> framebuffer) {
    FramebufferBindings& bindings = ctx.framebuffers;
    if (framebuffer == bindings.read) return;
    (bindings.read ? bindings.read->read_buffer : bindings.window_read_buffer) = ctx.framebuffer.read_buffer;
    ctx.framebuffer.read_buffer = framebuffer ? framebuffer->read_buffer : bindings.window_read_buffer;
    bindings.read = std::move(framebuffer);
    ctx.surface.read = bindings.read ? nullptr : bindings.window_read;
}

// The object that `target` names; the error is recorded where there is none, or it is the window system's.
Framebuffer* bound_object(Context& ctx, GLenum target) {
    Framebuffer* object = nullptr;
    if (target == GL_FRAMEBUFFER || target == GL_DRAW_FRAMEBUFFER) {
        object = ctx.framebuffers.draw.get();
    } else if (target == GL_READ_FRAMEBUFFER) {
        object = ctx.framebuffers.read.get();
    } else {
        return record_error(ctx, GL_INVALID_ENUM, "unknown frame buffer target"), nullptr;
    }
    if (!object) record_error(ctx, GL_INVALID_OPERATION, "the window system's frame buffer is bound");
    return object;
}

void attach(Context& ctx, GLenum target, GLenum attachment, const Attachment& attached) {
    Framebuffer* const framebuffer = bound_object(ctx, target);
    if (!framebuffer) return;
    const std::vector<Attachment*> points = find_attachments(ctx, *framebuffer, attachment);
    if (points.empty()) return;
    settle_framebuffers(ctx);
    begin_change(ctx, Dirty::kFramebuffer);
    for (Attachment* const point : points) *point = attached;
}

// What a FramebufferTexture command attaches; false where the error is recorded.
bool find_texture(Context& ctx, GLuint name, GLenum textarget, GLint level, GLint layer, Attachment& out) {
    if (name == 0) return true;
    const auto lock = lock_textures(ctx);
    const auto found = ctx.shared->textures.objects.find(name);
    if (found == ctx.shared->textures.objects.end() || !found->second)
        return record_error(ctx, GL_INVALID_OPERATION, "no such texture"), false;
    const GLenum face = textarget - GL_TEXTURE_CUBE_MAP_POSITIVE_X;
    const bool is_face = face < static_cast<GLenum>(kCubeFaces);
    if (found->second->target != (is_face ? GL_TEXTURE_CUBE_MAP : textarget))
        return record_error(ctx, GL_INVALID_OPERATION, "the texture belongs to another target"), false;
    if (level < 0 || level >= kMaxTextureLevels || layer < 0 || layer >= kMax3dTextureSize)
        return record_error(ctx, GL_INVALID_VALUE, "no such level or layer"), false;
    out.texture = found->second;
    out.face = is_face ? static_cast<int>(face) : 0;
    out.level = level;
    out.layer = layer;
    return true;
}

void framebuffer_texture(Context& ctx, GLenum target, GLenum attachment, GLenum textarget, GLuint texture,
                         GLint level, GLint layer) {
    if (!bound_object(ctx, target)) return;
    Attachment attached;
    if (find_texture(ctx, texture, textarget, level, layer, attached))
        attach(ctx, target, attachment, attached);
}

}  // namespace

std::vector<Attachment*> find_attachments(Context& ctx, Framebuffer& framebuffer, GLenum attachment) {
    auto& points = framebuffer.attachments;
    switch (attachment) {
        case GL_COLOR_ATTACHMENT0:
            return {&points[kColorAttachment]};
        case GL_DEPTH_ATTACHMENT:
            return {&points[kDepthAttachment]};
        case GL_STENCIL_ATTACHMENT:
            return {&points[kStencilAttachment]};
        case GL_DEPTH_STENCIL_ATTACHMENT:
            return {&points[kDepthAttachment], &points[kStencilAttachment]};
    }
    const bool beyond =
        attachment > GL_COLOR_ATTACHMENT0 && attachment < GL_COLOR_ATTACHMENT0 + kColorAttachmentNames;
    record_error(ctx, beyond ? GL_INVALID_OPERATION : GL_INVALID_ENUM, "no such attachment point");
    return {};
}

void gen_framebuffers(Context& ctx, GLsizei n, GLuint* framebuffers) {
    if (n < 0) return record_error(ctx, GL_INVALID_VALUE, "n is negative");
    FramebufferBindings& all = ctx.framebuffers;
    GLsizei made = 0;
    try {
        for (; made < n; ++made) {
            while (all.next_name == 0 || all.objects.contains(all.next_name)) ++all.next_name;
            all.objects.emplace(all.next_name, nullptr);
            framebuffers[made] = all.next_name++;
        }
    } catch (...) {
        while (made > 0) all.objects.erase(framebuffers[--made]);
        throw;
    }
}

void delete_framebuffers(Context& ctx, GLsizei n, const GLuint* framebuffers) {
    if (n < 0) return record_error(ctx, GL_INVALID_VALUE, "n is negative");
    // What may need memory comes first.
    const Framebuffer* const bound = ctx.framebuffers.draw.get();
    if (bound && std::find(framebuffers, framebuffers + n, bound->name()) != framebuffers + n)
        bind_draw(ctx, nullptr);
    for (GLsizei i = 0; i < n; ++i) {
        const auto found = ctx.framebuffers.objects.find(framebuffers[i]);
        if (found == ctx.framebuffers.objects.end()) continue;
        if (found->second && found->second == ctx.framebuffers.read) bind_read(ctx, nullptr);
        ctx.framebuffers.objects.erase(found);
    }
}

GLboolean is_framebuffer(Context& ctx, GLuint framebuffer) {
    const auto found = ctx.framebuffers.objects.find(framebuffer);
    return found != ctx.framebuffers.objects.end() && found->second;
}

// Names that GenFramebuffers did not make are taken too: EXT_framebuffer_object has no such rule.
void bind_framebuffer(Context& ctx, GLenum target, GLuint framebuffer) {
    if (target != GL_FRAMEBUFFER && target != GL_DRAW_FRAMEBUFFER && target != GL_READ_FRAMEBUFFER)
        return record_error(ctx, GL_INVALID_ENUM, "unknown frame buffer target");
    auto& objects = ctx.framebuffers.objects;
    std::shared_ptr<Framebuffer> object;
    const auto found = objects.find(framebuffer);
    if (found != objects.end()) object = found->second;
    const bool is_made = framebuffer != 0 && !object;
    if (is_made) object = std::make_shared<Framebuffer>(framebuffer);
    const auto named =
        found == objects.end() && is_made ? objects.emplace(framebuffer, nullptr).first : found;
    if (target != GL_READ_FRAMEBUFFER) {
        try {
            bind_draw(ctx, object);
        } catch (...) {
            if (named != found) objects.erase(named);
            throw;
        }
    }
    if (target != GL_DRAW_FRAMEBUFFER) bind_read(ctx, object);
    if (is_made) named->second = std::move(object);
}

GLenum check_framebuffer_status(Context& ctx, GLenum target) {
    const FramebufferBindings& bindings = ctx.framebuffers;
    if (target != GL_FRAMEBUFFER && target != GL_DRAW_FRAMEBUFFER && target != GL_READ_FRAMEBUFFER)
        return record_error(ctx, GL_INVALID_ENUM, "unknown frame buffer target"), 0;
    const bool reads = target == GL_READ_FRAMEBUFFER;
    take_over_buffers(ctx);
    const Framebuffer* const object = (reads ? bindings.read : bindings.draw).get();
    if (!object && !(reads ? bindings.window_read : bindings.window_draw)) return GL_FRAMEBUFFER_UNDEFINED;
    return framebuffer_status(ctx, object);
}

void framebuffer_renderbuffer(Context& ctx, GLenum target, GLenum attachment, GLenum renderbuffertarget,
                              GLuint renderbuffer) {
    if (!bound_object(ctx, target)) return;
    if (renderbuffertarget != GL_RENDERBUFFER)
        return record_error(ctx, GL_INVALID_ENUM, "the target is not GL_RENDERBUFFER");
    Attachment attached;
    if (renderbuffer != 0) {
        const std::lock_guard lock(ctx.shared->mutex);
        const auto found = ctx.shared->renderbuffers.objects.find(renderbuffer);
        if (found != ctx.shared->renderbuffers.objects.end()) attached.renderbuffer = found->second;
    }
    if (renderbuffer != 0 && !attached.renderbuffer)
        return record_error(ctx, GL_INVALID_OPERATION, "no such renderbuffer");
    attach(ctx, target, attachment, attached);
}

void framebuffer_texture_1d(Context& ctx, GLenum target, GLenum attachment, GLenum textarget, GLuint texture,
                            GLint level) {
    if (texture != 0 && textarget != GL_TEXTURE_1D)
        return record_error(ctx, GL_INVALID_ENUM, "unknown texture target");
    framebuffer_texture(ctx, target, attachment, textarget, texture, level, 0);
}

void framebuffer_texture_2d(Context& ctx, GLenum target, GLenum attachment, GLenum textarget, GLuint texture,
                            GLint level) {
    const bool is_face = textarget - GL_TEXTURE_CUBE_MAP_POSITIVE_X < static_cast<GLenum>(kCubeFaces);
    if (texture != 0 && textarget != GL_TEXTURE_2D && !is_face)
        return record_error(ctx, GL_INVALID_ENUM, "unknown texture target");
    framebuffer_texture(ctx, target, attachment, textarget, texture, level, 0);
}

void framebuffer_texture_3d(Context& ctx, GLenum target, GLenum attachment, GLenum textarget, GLuint texture,
                            GLint level, GLint zoffset) {
    if (texture != 0 && textarget != GL_TEXTURE_3D)
        return record_error(ctx, GL_INVALID_ENUM, "unknown texture target");
    framebuffer_texture(ctx, target, attachment, textarget, texture, level, zoffset);
}

void framebuffer_texture_layer(Context& ctx, GLenum target, GLenum attachment, GLuint texture, GLint level,
                               GLint layer) {
    framebuffer_texture(ctx, target, attachment, GL_TEXTURE_3D, texture, level, layer);
}

}  // namespace terrazzo::gl
