// The copy from our render target to the client's buffer.
#include <GL/osmesa.h>

#include "frontends/osmesa/formats.h"
#include "frontends/osmesa/osmesa_context.h"
#include "gl/surface.h"

namespace terrazzo::osmesa {

void ClientBuffer::show_front(gl::Context& ctx) {
    osmesa_context& context = m_context;
    const pipeline::PixelLayout layout = *pixel_layout(context.format, context.type);
    const int row_pixels = context.row_length > 0 ? context.row_length : context.width;
    const std::ptrdiff_t stride = std::ptrdiff_t{row_pixels} * pipeline::bytes_per_pixel(layout);
    if (context.y_up) {
        gl::copy_picture(ctx, gl::ColorBuffer::kFront, layout, context.buffer, stride);
    } else {
        gl::copy_picture(ctx, gl::ColorBuffer::kFront, layout, context.buffer + (context.height - 1) * stride,
                         -stride);
    }
    if (!context.depth.empty()) read_depth(context);
}

void read_depth(osmesa_context& context) {
    const pipeline::PixelLayout layout = context.gl->config.depth_bits == 16
                                             ? pipeline::PixelLayout::kDepth16
                                             : pipeline::PixelLayout::kDepth24Stencil8;
    const std::ptrdiff_t stride = std::ptrdiff_t{context.width} * pipeline::bytes_per_pixel(layout);
    context.depth.resize(static_cast<std::size_t>(stride) * static_cast<std::size_t>(context.height));
    gl::copy_picture(*context.gl, gl::ColorBuffer::kFront, layout, context.depth.data(), stride);
}

}  // namespace terrazzo::osmesa
