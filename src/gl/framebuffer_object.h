// Frame buffer objects and renderbuffers (ARB_framebuffer_object, EXT_framebuffer_object).
//
// Renderbuffers are shared between contexts, frame buffer objects are not. A frame buffer object is a
// drawable whose target has the planes of its attachments. While a texture is attached to the object that is
// bound, its pixels are in planes of the attachment's own, which begin as the texture's image before the
// first draw. When the object is left (settle_framebuffers) they are stored in the image's rows; depths are
// not copied: the image gets the planes' memory, and the planes go on in other. Like images, and unlike
// windows, objects have their bottom row first.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "gl/drawable.h"
#include "gl/texture.h"

namespace terrazzo::gl {

struct Context;

struct Renderbuffer {
    GLuint name = 0;
    GLenum internal_format = GL_RGBA;
    GLsizei width = 0, height = 0;
    raster::TargetFormat format{raster::ColorFormat::kRgba8, true, 0, 0};
    bool has_color = false;
    std::shared_ptr<raster::Target> planes;  // null while there is no storage
};

// Part of the share group. A name that GenRenderbuffers returned and nothing has bound yet maps to null.
struct RenderbufferNames {
    std::unordered_map<GLuint, std::shared_ptr<Renderbuffer>> objects;
    GLuint next_name = 1;
};

enum AttachmentPoint : int { kColorAttachment, kDepthAttachment, kStencilAttachment, kAttachmentCount };

struct Attachment {
    std::shared_ptr<Renderbuffer> renderbuffer;
    std::shared_ptr<TextureObject> texture;
    int face = 0;
    GLint level = 0, layer = 0;
    std::shared_ptr<raster::Target> planes;  // of a texture's attachment
    std::uint64_t content = 0;               // of the image that the planes show; 0 for none

    bool is_empty() const { return !renderbuffer && !texture; }
};

class Framebuffer : public Drawable {
  public:
    explicit Framebuffer(GLuint name) : Drawable(Buffering::kSingle), m_name(name) {}

    GLuint name() const { return m_name; }
    std::array<Attachment, kAttachmentCount> attachments;
    GLenum draw_buffer = GL_COLOR_ATTACHMENT0, read_buffer = GL_COLOR_ATTACHMENT0;

    // Drawing that Flush has passed on is still to be stored in textures.
    void show_front(Context&) override { flushed = true; }
    bool flushed = false;

    // Makes the target's planes those of the attachments; `planes` are null where there are none.
    void compose(int width, int height, const raster::TargetFormat& format,
                 const std::array<std::shared_ptr<raster::Target>, kAttachmentCount>& planes);

  private:
    GLuint m_name;
    std::array<std::shared_ptr<raster::Target>, kAttachmentCount> m_planes;
};

struct FramebufferBindings {
    // Names that GenFramebuffers returned and nothing has bound yet map to null.
    std::unordered_map<GLuint, std::shared_ptr<Framebuffer>> objects;
    GLuint next_name = 1;
    std::shared_ptr<Framebuffer> draw, read;  // null: the window system's
    std::shared_ptr<Renderbuffer> renderbuffer;

    // What the window system gave, while an object takes its place.
    std::shared_ptr<Drawable> window_draw, window_read;
    GLenum window_draw_buffer = GL_FRONT, window_read_buffer = GL_FRONT;
    bool window_drawn = false;

    bool any() const { return draw || read; }
};

// GL_FRAMEBUFFER_COMPLETE or what is wrong. Null is the window system's frame buffer.
GLenum framebuffer_status(Context& ctx, const Framebuffer* framebuffer);

// Whether there is a colour buffer to draw to.
bool draws_colors(const Context& ctx);

// What DrawBuffer and ReadBuffer chose is kept in the context while an object is bound: brings the objects up
// to date.
void take_over_buffers(Context& ctx);

// Makes sure that what is bound can be drawn to and read from as its attachments are now. False, and the
// error is recorded, where the object drawn to is not complete. Called before drawing; cheap where no object
// is bound. Throws std::bad_alloc.
bool check_framebuffer(Context& ctx);
// The same for the object that is read from.
bool check_read_framebuffer(Context& ctx);
// The same for pixels that are read one a pixel: of a multisampled object that is an error.
bool check_readable_framebuffer(Context& ctx);

// GL_SAMPLES: of a pixel of what is drawn to; 0 where it is not multisampled.
GLint drawn_samples(Context& ctx);

// Draws what is queued and brings the textures that are attached up to date. Throws std::bad_alloc, and
// nothing that was drawn is lost then.
void settle_framebuffers(Context& ctx);

// How many bits what is attached has of a component, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE and so on; textures
// are locked, and something is attached.
GLint size_in_bits(const Attachment& a, GLenum pname);

// The points that `attachment` names, at most two; none where it is unknown, and the error is recorded.
std::vector<Attachment*> find_attachments(Context& ctx, Framebuffer& framebuffer, GLenum attachment);

// A query of GetRenderbufferParameter about bits.
GLint renderbuffer_bits(const Renderbuffer& renderbuffer, GLenum pname);

// A texture that is deleted leaves the objects that are bound.
void detach_texture(Context& ctx, const TextureObject* texture);

}  // namespace terrazzo::gl
