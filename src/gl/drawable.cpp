// Which pixels stand for which buffer of a drawable. A double-buffered one begins with its back buffer alone:
// most programs never touch the front.
#include "gl/drawable.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace terrazzo::gl {

bool Drawable::has_buffers(int width, int height, const raster::TargetFormat& format) const {
    const raster::Target* const target = m_buffers.target.get();
    return target && target->width() == width && target->height() == height && target->format() == format;
}

Drawable::Buffers Drawable::make_buffers(int width, int height, const raster::TargetFormat& format) const {
    Buffers made;
    made.target = std::make_shared<raster::Target>(width, height, format);
    made.selected = is_double_buffered() ? ColorBuffer::kBack : ColorBuffer::kFront;
    return made;
}

void Drawable::allocate(int width, int height, const raster::TargetFormat& format) {
    if (!has_buffers(width, height, format)) m_buffers = make_buffers(width, height, format);
}

void Drawable::select(ColorBuffer buffer) {
    if (!is_double_buffered() || !m_buffers.target || buffer == m_buffers.selected) return;
    m_buffers.target->exchange_color();
    m_buffers.selected = buffer;
    if (buffer != ColorBuffer::kFront || m_buffers.has_front) return;
    m_buffers.has_front = true;
    try {
        load_front();
    } catch (...) {
        m_buffers.has_front = false;
        m_buffers.selected = ColorBuffer::kBack;
        m_buffers.target->exchange_color();
        throw;
    }
}

AccumulationPlane& Drawable::accumulation() {
    if (!m_buffers.accumulation)
        m_buffers.accumulation = std::make_unique<AccumulationPlane>(width(), height());
    return *m_buffers.accumulation;
}

void Drawable::swap_pixels() {
    if (!is_double_buffered() || !m_buffers.target || !m_buffers.has_front) return;
    m_buffers.target->exchange_color();
}

void copy_picture(Drawable& drawable, ColorBuffer buffer, pipeline::PixelLayout layout, std::byte* bottom_row,
                  std::ptrdiff_t stride) {
    if (!drawable.target()) return;
    const ColorBuffer selected = drawable.selected();
    drawable.select(buffer);
    raster::Target& target = *drawable.target();
    std::byte* const top_row = bottom_row + (drawable.height() - 1) * stride;
    for (int bin = 0; bin < target.bin_count(); ++bin)
        pipeline::resolve_bin(target, bin, layout, top_row, -stride);
    drawable.select(selected);
}

void load_picture(Drawable& drawable, pipeline::PixelLayout layout, const std::byte* top_row,
                  std::ptrdiff_t stride) {
    raster::Target& target = *drawable.target();
    const std::ptrdiff_t bytes = pipeline::bytes_per_pixel(layout);
    for (int i = 0; i < target.bin_count(); ++i) {
        target.materialize(i);
        const raster::Bin bin = target.bin(i);
        const int width = std::min(raster::kBinSize, target.width() - bin.x);
        const int height = std::min(raster::kBinSize, target.height() - bin.y);
        for (int y = 0; y < height; ++y) {
            const std::byte* in = top_row + (bin.y + y) * stride + bin.x * bytes;
            for (int x = 0; x < width; ++x, in += bytes) {
                std::byte pixel[16];
                std::memcpy(pixel, in, static_cast<std::size_t>(bytes));
                if (layout == pipeline::PixelLayout::kBgra8) std::swap(pixel[0], pixel[2]);
                for (int sample = 0; sample < target.format().samples; ++sample) {
                    const raster::Bin planes = raster::planes_of_sample(bin, sample, target.format().color);
                    std::memcpy(planes.color + raster::pixel_index(x, y) * bytes, pixel,
                                static_cast<std::size_t>(bytes));
                }
            }
        }
    }
}

}  // namespace terrazzo::gl
