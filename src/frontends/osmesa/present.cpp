// The copy from our render target to the client's buffer, and to whoever watches.
#include <GL/osmesa.h>

#include <new>
#include <utility>
#include <vector>

#include "frontends/osmesa/formats.h"
#include "frontends/osmesa/osmesa_context.h"
#include "frontends/window/watch.h"
#include "gl/surface.h"

namespace terrazzo::osmesa {

namespace {

// What comes to the client's buffer is a frame to `terrazzo run`. It is told without the time of the copy,
// which is part of drawing the last bins, and without its picture where there is no memory for that.
void tell_watcher(gl::Context& ctx, gl::Drawable& drawable, int width, int height) {
    if (!window::is_watched()) return;
    std::vector<std::byte> rows;
    if (window::wants_pictures()) {
        const std::ptrdiff_t stride = std::ptrdiff_t{4} * width;
        const std::size_t bytes = static_cast<std::size_t>(stride) * static_cast<std::size_t>(height);
        try {
            rows.resize(bytes);
        } catch (const std::bad_alloc&) {
            return window::watch_frame(width, height, 0, nullptr);
        }
        gl::copy_picture(ctx, drawable, gl::ColorBuffer::kFront, raster::PixelLayout::kRgba8,
                         rows.data() + (height - 1) * stride, -stride);
    }
    window::watch_frame(width, height, 0, rows.empty() ? nullptr : rows.data());
}

}  // namespace

ClientBuffer::ClientBuffer(osmesa_context& context)
    : Drawable(gl::Buffering::kSingleByEitherName), m_context(context) {
    window::is_watched();  // a watcher is told of everything that is drawn here, so find it before
}

void ClientBuffer::show_front(gl::Context& ctx) {
    osmesa_context& context = m_context;
    const raster::PixelLayout layout = *pixel_layout(context.format, context.type);
    const int row_pixels = context.row_length > 0 ? context.row_length : context.width;
    const std::ptrdiff_t stride = std::ptrdiff_t{row_pixels} * raster::bytes_per_pixel(layout);
    if (context.y_up) {
        gl::copy_picture(ctx, *this, gl::ColorBuffer::kFront, layout, context.buffer, stride);
    } else {
        gl::copy_picture(ctx, *this, gl::ColorBuffer::kFront, layout,
                         context.buffer + (context.height - 1) * stride, -stride);
    }
    if (!context.depth.empty()) read_depth(context);
    tell_watcher(ctx, *this, context.width, context.height);
}

void read_depth(osmesa_context& context) {
    const raster::PixelLayout layout = context.gl->config.depth_bits == 16
                                           ? raster::PixelLayout::kDepth16
                                           : raster::PixelLayout::kDepth24Stencil8;
    const std::ptrdiff_t stride = std::ptrdiff_t{context.width} * raster::bytes_per_pixel(layout);
    const bool was_there = !context.depth.empty();
    // A buffer that the client has been given stays where it is.
    std::vector<std::byte> depth = std::move(context.depth);
    try {
        depth.resize(static_cast<std::size_t>(stride) * static_cast<std::size_t>(context.height));
        gl::copy_picture(*context.gl, *context.drawable, gl::ColorBuffer::kFront, layout, depth.data(),
                         stride);
    } catch (...) {
        if (was_there) context.depth = std::move(depth);
        throw;
    }
    context.depth = std::move(depth);
}

}  // namespace terrazzo::osmesa
