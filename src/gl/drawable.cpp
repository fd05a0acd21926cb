// Which pixels stand for which buffer of a drawable. A double-buffered one begins with its back buffer alone:
// most programs never touch the front.
#include "gl/drawable.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace terrazzo::gl {

bool Drawable::has_buffers(int width, int height, const raster::TargetFormat& format) const {
    const Lock lock(m_mutex);
    const raster::Target* const target = m_buffers.target.get();
    return target && target->width() == width && target->height() == height && target->format() == format;
}

Drawable::Buffers Drawable::make_buffers(int width, int height, const raster::TargetFormat& format) {
    Buffers made;
    made.target = std::make_shared<raster::Target>(width, height, format);
    return made;
}

void Drawable::exchange_buffers(Buffers& buffers) noexcept {
    const Lock lock(m_mutex);
    std::swap(m_buffers, buffers);
}

void Drawable::allocate(int width, int height, const raster::TargetFormat& format) {
    if (has_buffers(width, height, format)) return;
    Buffers made = make_buffers(width, height, format);
    exchange_buffers(made);
}

void Drawable::set_target(std::shared_ptr<raster::Target> target) {
    const Lock lock(m_mutex);
    m_buffers.target = std::move(target);
}

std::shared_ptr<raster::Target> Drawable::target() const {
    const Lock lock(m_mutex);
    return m_buffers.target;
}

int Drawable::width() const {
    const Lock lock(m_mutex);
    return m_buffers.target ? m_buffers.target->width() : 0;
}

int Drawable::height() const {
    const Lock lock(m_mutex);
    return m_buffers.target ? m_buffers.target->height() : 0;
}

std::shared_ptr<raster::Target> Drawable::target_with_front() {
    const Lock lock(m_mutex);
    if (!is_double_buffered() || !m_buffers.target || m_buffers.has_front) return m_buffers.target;
    {
        const std::lock_guard planes(m_buffers.target->mutex());
        m_buffers.target->make_second_color();
    }
    load_front();
    m_buffers.has_front = true;
    return m_buffers.target;
}

bool Drawable::has_front_pixels() const {
    const Lock lock(m_mutex);
    return !is_double_buffered() || m_buffers.has_front;
}

std::shared_ptr<AccumulationPlane> Drawable::accumulation(const raster::Target& target) {
    const auto make = [&] { return std::make_shared<AccumulationPlane>(target.width(), target.height()); };
    const Lock lock(m_mutex);
    if (&target != m_buffers.target.get()) return make();
    if (!m_buffers.accumulation) m_buffers.accumulation = make();
    return m_buffers.accumulation;
}

void Drawable::swap_pixels() {
    const Lock lock(m_mutex);
    if (!is_double_buffered() || !m_buffers.target || !m_buffers.has_front) return;
    const std::lock_guard planes(m_buffers.target->mutex());
    m_buffers.target->swap_colors();
}

void copy_picture(Drawable& drawable, ColorBuffer buffer, raster::PixelLayout layout, std::byte* bottom_row,
                  std::ptrdiff_t stride) {
    const auto target = buffer == ColorBuffer::kFront ? drawable.target_with_front() : drawable.target();
    if (!target) return;
    std::byte* const top_row = bottom_row + (target->height() - 1) * stride;
    const raster::TargetUse use(*target, drawable.plane_of(buffer));
    for (int bin = 0; bin < target->bin_count(); ++bin)
        raster::resolve_bins(*target, bin, 1, layout, top_row, -stride);
}

void load_picture(raster::Target& target, raster::ColorPlane plane, raster::PixelLayout layout,
                  const std::byte* top_row, std::ptrdiff_t stride) {
    const raster::TargetUse use(target, plane);
    const std::ptrdiff_t bytes = raster::bytes_per_pixel(layout);
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
                if (layout == raster::PixelLayout::kBgra8) std::swap(pixel[0], pixel[2]);
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
