// What frame buffer objects are made of, and their way in and out of the renderer.
#include "gl/framebuffer_object.h"

#include <algorithm>
#include <utility>

#include "gl/context.h"
#include "gl/draw.h"
#include "gl/pixel_convert.h"
#include "gl/share.h"
#include "gl/texel_row.h"
#include "pipeline/schedule/workers.h"
#include "raster/target/read_row.h"
#include "raster/target/write_row.h"

namespace terrazzo::gl {
namespace {

using raster::Target;

struct AttachedSize {
    int width = 0, height = 0;
};

const TextureLevel& level_of(const Attachment& a) {
    return std::as_const(*a.texture).face(a.face)[static_cast<std::size_t>(a.level)];
}

bool is_depth(const TexelFormat& format) {
    return format.base == GL_DEPTH_COMPONENT;
}

// To be filled in with the planes of an object.
raster::TargetFormat no_planes(bool has_alpha) {
    return {raster::ColorFormat::kRgba8, has_alpha, 0, 0, raster::RowOrder::kBottomFirst};
}

// The format of planes that hold a texture's texels; colours of more than 8 bits take 16.
raster::TargetFormat plane_format(const TexelFormat& texel, AttachmentPoint point) {
    raster::TargetFormat format = no_planes(texel.base == GL_RGBA);
    if (point == kDepthAttachment) format.depth_bits = texel.bits[0] == 16 ? 16 : 24;
    if (point == kStencilAttachment) format.stencil_bits = 8;
    if (texel.storage == raster::TexelStorage::kRgba32F) format.color = raster::ColorFormat::kRgba16;
    return format;
}

// Size of what is attached, 0 where it cannot be drawn to at this point.
AttachedSize size_of(const Attachment& a, AttachmentPoint point) {
    if (a.renderbuffer) {
        const Renderbuffer& r = *a.renderbuffer;
        const bool fits = point == kColorAttachment   ? r.has_color
                          : point == kDepthAttachment ? r.format.depth_bits != 0
                                                      : r.format.stencil_bits != 0;
        return fits && r.planes ? AttachedSize{r.width, r.height} : AttachedSize{};
    }
    if (a.level >= kMaxTextureLevels) return {};
    const TextureLevel& level = level_of(a);
    if (!level.image || level.blocks || a.layer >= level.depth) return {};
    const GLenum base = level.format->base;
    const bool fits = point == kColorAttachment   ? base == GL_RGB || base == GL_RGBA
                      : point == kDepthAttachment ? is_depth(*level.format)
                                                  : has_stencil(level.internal_format);
    return fits ? AttachedSize{level.width, level.height} : AttachedSize{};
}

int samples_of(const Attachment& a) {
    return a.renderbuffer ? a.renderbuffer->format.samples : 1;
}

// As in the reference, and later versions of GL, what draws to or reads from a missing colour buffer is no
// reason to be incomplete, nor are attachments of different sizes.
GLenum status_of(const Framebuffer& framebuffer) {
    int samples = 0;
    bool agree = true;
    for (int point = 0; point < kAttachmentCount; ++point) {
        const Attachment& a = framebuffer.attachments[static_cast<std::size_t>(point)];
        if (a.is_empty()) continue;
        if (size_of(a, static_cast<AttachmentPoint>(point)).width == 0)
            return GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT;
        if (samples == 0) samples = samples_of(a);
        agree = agree && samples_of(a) == samples;
    }
    if (samples == 0) return GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT;
    return agree ? GL_FRAMEBUFFER_COMPLETE : GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE;
}

// Rows of an image and of a target, which both have their bottom row first: calls row(x, y, count, at) where
// `at` is the texel of pixel (x, y). Borders are attached with their texels (GL 3.0 §4.4.3).
struct TexelPosition {
    int x, y, z;
};
template <typename Row>
void for_each_run(const Target& target, const Attachment& a, const raster::TextureImage& image, Row row) {
    for (int y = 0; y < target.height(); ++y)
        for (int x = 0; x < target.width(); x += kPixelChunk)
            row(x, y, std::min(kPixelChunk, target.width() - x),
                TexelPosition{x - image.border_x, y - image.border_y, a.layer - image.border_z});
}

// Whether textures may be sampled in the planes of the attachment, tiles and all.
bool shows_tiles(const Attachment& a, AttachmentPoint point, const Target& planes) {
    if (point != kDepthAttachment) return false;
    const TextureLevel& level = level_of(a);
    return level.border == 0 && level.format->bits[0] == planes.format().depth_bits;
}

void load(const Attachment& a, AttachmentPoint point, Target& planes) {
    const TextureLevel& level = level_of(a);
    const TexelFormat& format = *level.format;
    const raster::TextureImage& image = *level.image;
    if (image.tiles() && shows_tiles(a, point, planes)) return planes.start_from_depths(image.tiles());
    if (point == kDepthAttachment) planes.let_go_of_texture();
    for_each_run(planes, a, image, [&](int x, int y, int count, const TexelPosition& at) {
        if (point == kStencilAttachment) {
            uint8_t stencils[kPixelChunk] = {};
            if (const uint8_t* const known = image.stencils(at.x, at.y)) std::copy_n(known, count, stencils);
            return raster::write_stencil(planes, x, y, count, stencils);
        }
        if (point == kDepthAttachment) {
            uint32_t depths[kPixelChunk];
            const uint32_t* const texels = image.depths(at.x, at.y);
            const auto bits = static_cast<unsigned>(planes.format().depth_bits);
            for (int i = 0; i < count; ++i) depths[i] = resize_depth(texels[i], format.bits[0], bits);
            return raster::write_depth(planes, x, y, count, depths);
        }
        if (format.storage == raster::TexelStorage::kRgba8)
            return raster::write_color_rgba8(planes, x, y, count, image.rgba8(at.x, at.y, at.z));
        raster::write_color(planes, x, y, count, image.rgba32f(at.x, at.y, at.z));
    });
}

void store(const Attachment& a, AttachmentPoint point, Target& planes, raster::TextureImage& image) {
    const TexelFormat& format = *level_of(a).format;
    for_each_run(planes, a, image, [&](int x, int y, int count, const TexelPosition& at) {
        if (point == kStencilAttachment) {
            raster::read_stencil(planes, x, y, count, image.stencils(at.x, at.y));
        } else if (point == kDepthAttachment) {
            uint32_t drawn[kPixelChunk], *const depths = image.depths(at.x, at.y);
            raster::read_depth(planes, x, y, count, drawn);
            const auto bits = static_cast<unsigned>(planes.format().depth_bits);
            // What nothing was drawn to keeps the bits that the planes do not have.
            for (int i = 0; i < count; ++i)
                if (resize_depth(depths[i], format.bits[0], bits) != drawn[i])
                    depths[i] = resize_depth(drawn[i], bits, format.bits[0]);
        } else if (format.storage == raster::TexelStorage::kRgba8) {
            uint8_t rgba[4 * kPixelChunk];
            raster::read_color_rgba8(planes, x, y, count, rgba);
            store_texels(format, rgba, Rounding::kAsDrawn, count, image, at.x, at.y, at.z);
        } else {
            float rgba[4 * kPixelChunk];
            raster::read_color_float(planes, x, y, count, rgba);
            store_texels(format, rgba, Rounding::kOnce, count, image, at.x, at.y, at.z);
        }
    });
}

// Few bins are done sooner than a thread wakes up.
constexpr int kFewBins = 16;
template <typename Work>
void for_each_row_of_bins(const Target& target, int busy_bins, Work work) {
    if (busy_bins > kFewBins)
        return pipeline::run_parallel(target.bins_up(), [&](int row, int) { work(row); });
    for (int row = 0; row < target.bins_up(); ++row) work(row);
}

// Whoever uses the planes next knows nothing of what is still to be cleared.
void settle(Target& target) {
    for_each_row_of_bins(target, target.bins_to_fill(), [&](int row) { target.settle_row(row); });
}

void keep_depths(Target& planes) {
    for_each_row_of_bins(planes, planes.depths_to_copy(), [&](int row) { planes.keep_depths_of_row(row); });
    planes.let_go_of_texture();
}

// Memory for drawing to go on in once a texture has the planes' own: null where the texture's will do, which
// nobody samples any more. Throws std::bad_alloc.
std::shared_ptr<raster::PlanePixels> memory_to_go_on(const raster::LevelImage& image, const Target& planes) {
    const bool is_free = !image.in_use() && image->tiles() && raster::is_sole_owner(image->tiles());
    return is_free ? nullptr : planes.new_depths();
}

// The planes that an attachment is drawn to, loaded from the texture's image where that is a new one.
std::shared_ptr<Target> current_planes(Attachment& a, AttachmentPoint point, bool& loaded) {
    if (a.renderbuffer) return a.renderbuffer->planes;
    if (!a.texture) return nullptr;
    const TextureLevel& level = level_of(a);
    const raster::TargetFormat format = plane_format(*level.format, point);
    if (!a.planes || a.planes->width() != level.width || a.planes->height() != level.height ||
        a.planes->format() != format) {
        a.planes = point == kColorAttachment ? std::make_shared<Target>(level.width, level.height, format)
                                             : Target::depth_and_stencil(level.width, level.height, format);
        a.planes->settle();
        a.content = 0;
    }
    if (a.content != level.image->content()) {
        load(a, point, *a.planes);
        loaded = true;
        a.content = level.image->content();
    }
    return a.planes;
}

// Brings the object's target up to date with its attachments; false where it is not complete. Other contexts
// must not change what is attached in between.
bool compose_complete(Context& ctx, Framebuffer& framebuffer) {
    const auto lock = lock_textures(ctx);
    if (status_of(framebuffer) != GL_FRAMEBUFFER_COMPLETE) return false;
    std::array<std::shared_ptr<Target>, kAttachmentCount> planes;
    raster::TargetFormat format = no_planes(true);
    int width = kMaxRenderbufferSize, height = kMaxRenderbufferSize;  // what all of them have
    bool any = false, loaded = false;
    for (int point = 0; point < kAttachmentCount; ++point) {
        const auto index = static_cast<std::size_t>(point);
        planes[index] =
            current_planes(framebuffer.attachments[index], static_cast<AttachmentPoint>(point), loaded);
        if (!planes[index]) continue;
        any = true;
        width = std::min(width, planes[index]->width());
        height = std::min(height, planes[index]->height());
        const raster::TargetFormat& own = planes[index]->format();
        format.samples = own.samples;
        if (point == kColorAttachment) format.color = own.color, format.has_alpha = own.has_alpha;
        if (point == kDepthAttachment) format.depth_bits = own.depth_bits;
        if (point == kStencilAttachment) format.stencil_bits = own.stencil_bits;
    }
    if (any) framebuffer.compose(width, height, format, planes);
    if (any && loaded) framebuffer.target()->forget_bounds();
    return true;
}

// Writes what was drawn to textures into their images.
void store_textures(Context& ctx, Framebuffer& framebuffer) {
    const auto lock = lock_textures(ctx);
    // Depth and stencil may be one image: which attachments are up to date is known before any is written.
    std::array<bool, kAttachmentCount> stored{};
    for (const AttachmentPoint point : {kColorAttachment, kDepthAttachment, kStencilAttachment}) {
        const Attachment& a = framebuffer.attachments[point];
        stored[point] = a.texture && a.planes && size_of(a, point).width == a.planes->width() &&
                        level_of(a).image->content() == a.content;
    }
    ctx.drawing.state.fragment.reset();  // it would count as a reference to the images
    // Whether or not there is memory for all of them, images that are made writable are what their
    // attachments go to.
    struct Contents {
        Framebuffer& framebuffer;
        const std::array<bool, kAttachmentCount>& stored;
        ~Contents() {
            for (std::size_t point = 0; point < kAttachmentCount; ++point)
                if (Attachment& a = framebuffer.attachments[point]; stored[point])
                    a.content = level_of(a).image->content();
        }
    } const contents{framebuffer, stored};
    std::array<raster::TextureImage*, kAttachmentCount> images{};
    std::array<std::shared_ptr<raster::PlanePixels>, kAttachmentCount> next;
    for (const AttachmentPoint point : {kColorAttachment, kDepthAttachment, kStencilAttachment}) {
        if (!stored[point]) continue;
        Attachment& a = framebuffer.attachments[point];
        raster::LevelImage& image = a.texture->face(a.face)[static_cast<std::size_t>(a.level)].image;
        if (shows_tiles(a, point, *a.planes)) {
            keep_depths(*a.planes);
            next[point] = memory_to_go_on(image, *a.planes);
            images[point] = image.replaceable();
        } else {
            images[point] = point == kStencilAttachment ? image.writable_beside_texels() : image.writable();
        }
        if (!images[point]) throw std::bad_alloc();
        if (point == kStencilAttachment) images[point]->make_stencils();
    }
    for (const AttachmentPoint point : {kColorAttachment, kDepthAttachment, kStencilAttachment}) {
        Attachment& a = framebuffer.attachments[point];
        if (!stored[point]) continue;
        if (!shows_tiles(a, point, *a.planes)) {
            store(a, point, *a.planes, *images[point]);
            continue;
        }
        auto tiles = next[point] ? std::move(next[point]) : images[point]->take_tiles();
        images[point]->show_tiles(a.planes->exchange_depths(std::move(tiles)));
    }
    ctx.dirty |= static_cast<unsigned>(Dirty::kTexture);
}

}  // namespace

void Framebuffer::compose(int width, int height, const raster::TargetFormat& format,
                          const std::array<std::shared_ptr<Target>, kAttachmentCount>& planes) {
    if (target() && planes == m_planes && target()->format() == format) return;
    set_target(std::make_shared<Target>(
        width, height, format,
        raster::SharedPlanes{planes[kColorAttachment].get(), planes[kDepthAttachment].get(),
                             planes[kStencilAttachment].get()}));
    target()->start_over();
    m_planes = planes;
}

GLenum framebuffer_status(Context& ctx, const Framebuffer* framebuffer) {
    if (!framebuffer) return GL_FRAMEBUFFER_COMPLETE;
    const auto lock = lock_textures(ctx);
    return status_of(*framebuffer);
}

void take_over_buffers(Context& ctx) {
    if (ctx.framebuffers.draw) ctx.framebuffers.draw->draw_buffer = ctx.framebuffer.draw_buffer;
    if (ctx.framebuffers.read) ctx.framebuffers.read->read_buffer = ctx.framebuffer.read_buffer;
}

bool draws_colors(const Context& ctx) {
    if (ctx.framebuffer.draw_buffer == GL_NONE) return false;
    // Windows, which other threads may have as well, have colours.
    const Target* const target = ctx.framebuffers.draw ? ctx.renderer.target().get() : nullptr;
    return !target || target->has_color();
}

bool check_framebuffer(Context& ctx) {
    const auto framebuffer = ctx.framebuffers.draw;
    if (!framebuffer) return true;
    take_over_buffers(ctx);
    const bool complete = compose_complete(ctx, *framebuffer);
    use_draw_drawable(ctx, complete ? framebuffer : nullptr, ctx.framebuffer.draw_buffer);
    if (!complete) record_error(ctx, GL_INVALID_FRAMEBUFFER_OPERATION, "the frame buffer is not complete");
    return complete;
}

bool check_read_framebuffer(Context& ctx) {
    const auto framebuffer = ctx.framebuffers.read;
    if (!framebuffer) return true;
    if (framebuffer == ctx.framebuffers.draw) {
        const bool complete = check_framebuffer(ctx);
        ctx.surface.read = complete ? framebuffer : nullptr;
        return complete;
    }
    settle_framebuffers(ctx);
    take_over_buffers(ctx);
    const bool complete = compose_complete(ctx, *framebuffer);
    ctx.surface.read = complete ? framebuffer : nullptr;
    if (!complete) record_error(ctx, GL_INVALID_FRAMEBUFFER_OPERATION, "the frame buffer is not complete");
    return complete;
}

bool check_readable_framebuffer(Context& ctx) {
    if (!check_read_framebuffer(ctx)) return false;
    const bool multisampled = ctx.framebuffers.read && ctx.framebuffers.read->target()->format().samples > 1;
    if (multisampled)
        record_error(ctx, GL_INVALID_OPERATION, "the frame buffer object read from is multisampled");
    return !multisampled;
}

GLint drawn_samples(Context& ctx) {
    const Framebuffer* const object = ctx.framebuffers.draw.get();
    int samples = ctx.surface.format.samples;
    if (object) {
        samples = 1;
        const auto lock = lock_textures(ctx);
        if (status_of(*object) == GL_FRAMEBUFFER_COMPLETE)
            for (const Attachment& a : object->attachments) samples = std::max(samples, samples_of(a));
    }
    return samples > 1 ? samples : 0;
}

void settle_framebuffers(Context& ctx) {
    Framebuffer* const framebuffer = ctx.framebuffers.draw.get();
    if (!framebuffer || !framebuffer->target() || ctx.renderer.target() != framebuffer->target()) return;
    finish_drawing(ctx);
    settle(*framebuffer->target());
    if (ctx.surface.drawn || framebuffer->flushed) store_textures(ctx, *framebuffer);
    ctx.surface.drawn = framebuffer->flushed = false;
}

void detach_texture(Context& ctx, const TextureObject* texture) {
    for (Framebuffer* const framebuffer : {ctx.framebuffers.draw.get(), ctx.framebuffers.read.get()}) {
        if (!framebuffer) continue;
        for (Attachment& a : framebuffer->attachments)
            if (a.texture.get() == texture) a = {};
    }
}

}  // namespace terrazzo::gl
