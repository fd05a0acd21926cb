// Memory of a render target and its deferred clears; the layout is explained in target.h.
#include "raster/target/target.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>
#include <utility>

#include "raster/target/color_format.h"
#include "raster/target/plane_kernels.h"

namespace terrazzo::raster {

template <class T>
Target::Plane<T>::Plane(int bins_across, int bins_up, size_t count)
    : m_memory(std::make_shared<ZeroedMemory>(static_cast<size_t>(bins_across) *
                                              static_cast<size_t>(bins_up) * count * sizeof(T))),
      m_bins_across(bins_across),
      m_count(count) {
    if (m_memory->data() == nullptr) throw std::bad_alloc();
}

Target::Target(int width, int height, TargetFormat format, std::nullptr_t)
    : m_width(width),
      m_height(height),
      m_bins_across((width + kBinSize - 1) / kBinSize),
      m_bins_up((height + kBinSize - 1) / kBinSize),
      m_format(format),
      m_states(static_cast<size_t>(bin_count())) {}

void Target::allocate_depth_and_stencil() {
    if (m_format.depth_bits != 0) {
        m_depth = Plane<uint32_t>(m_bins_across, m_bins_up, bin_samples());
        m_depth_alike = new_alike_marks();
        m_farthest = new_farthest();
    }
    if (m_format.stencil_bits != 0) {
        m_stencil = Plane<uint8_t>(m_bins_across, m_bins_up, bin_samples());
        m_stencil_alike = new_alike_marks();
    }
}

Target::Plane<std::byte> Target::new_color() const {
    return {m_bins_across, m_bins_up, bin_samples() * static_cast<size_t>(bytes_per_pixel(m_format.color))};
}

Target::Plane<float> Target::new_farthest() const {
    return {m_bins_across, m_bins_up, kBinTiles};
}

Target::Plane<uint8_t> Target::new_alike_marks() const {
    if (m_format.samples == 1) return {};
    return {m_bins_across, m_bins_up, kBinTiles};
}

Target::Target(int width, int height, TargetFormat format) : Target(width, height, format, nullptr) {
    m_color = new_color();
    m_color_alike = new_alike_marks();
    allocate_depth_and_stencil();
    for (int i = 0; i < bin_count(); ++i) clear_bin(i, {true, true, true}, {});
}

Target::Target(int width, int height, TargetFormat format, const SharedPlanes& planes)
    : Target(width, height, format, nullptr) {
    if (planes.color) {
        m_color = planes.color->m_color;
        m_color_alike = planes.color->m_color_alike;
    }
    if (planes.depth) {
        m_depth = planes.depth->m_depth;
        m_depth_alike = planes.depth->m_depth_alike;
        m_farthest = new_farthest();
    }
    if (planes.stencil) {
        m_stencil = planes.stencil->m_stencil;
        m_stencil_alike = planes.stencil->m_stencil_alike;
    }
    for (const Target* const shared : {planes.color, planes.depth, planes.stencil})
        m_is_part |= shared && (shared->width() > width || shared->height() > height);
}

std::shared_ptr<Target> Target::depth_and_stencil(int width, int height, TargetFormat format) {
    std::shared_ptr<Target> target(new Target(width, height, format, nullptr));
    target->allocate_depth_and_stencil();
    target->start_over();
    return target;
}

void Target::settle() {
    for (int i = 0; i < bin_count(); ++i) materialize(i);
}

void Target::start_over() {
    for (int i = 0; i < bin_count(); ++i) {
        state(i).pending = {};
        forget_farthest(i);
    }
}

Bin Target::bin(int index) {
    const int column = index % m_bins_across, row = index / m_bins_across;
    return {m_color.bin(column, row),
            m_depth.bin(column, row),
            m_stencil.bin(column, row),
            m_farthest.bin(column, row),
            column * kBinSize,
            row * kBinSize,
            &state(index),
            m_color_alike.bin(column, row),
            m_depth_alike.bin(column, row),
            m_stencil_alike.bin(column, row)};
}

void Target::clear_bin(int index, ClearPlanes planes, const ClearValues& values) {
    BinState& bin = state(index);
    if (planes.color && m_color) {
        bin.pending.color = true;
        std::copy_n(values.color, 4, bin.clear.color);
    }
    if (planes.depth && m_depth) {
        bin.pending.depth = true;
        bin.clear.depth = values.depth;
        const uint32_t maximum = m_format.depth_bits == 16 ? 0xffff : 0xffffff;
        bin.farthest = values.depth < maximum ? static_cast<float>(values.depth) / static_cast<float>(maximum)
                                              : std::numeric_limits<float>::infinity();
    }
    if (planes.stencil && m_stencil) {
        bin.pending.stencil = true;
        bin.clear.stencil = values.stencil;
    }
}

void Target::materialize(int index, ClearPlanes wanted) {
    BinState& info = state(index);
    const bool color = info.pending.color && wanted.color, depth = info.pending.depth && wanted.depth,
               stencil = info.pending.stencil && wanted.stencil;
    if (!color && !depth && !stencil) return;
    const Bin planes = bin(index);
    const auto mark_alike = [](uint8_t* marks) {
        if (marks) std::memset(marks, 1, kBinTiles);
    };
    if (color) {
        mark_alike(planes.color_alike);
        if (m_format.color == ColorFormat::kRgba8) {
            uint32_t pixel;
            encode_color(m_format.color, info.clear.color, reinterpret_cast<std::byte*>(&pixel));
            plane_kernels().fill(reinterpret_cast<uint32_t*>(planes.color), pixel, kBinPixels);
        } else {
            fill_color(m_format.color, info.clear.color, planes.color, kBinPixels);
        }
        info.pending.color = false;
    }
    if (depth) {
        mark_alike(planes.depth_alike);
        plane_kernels().fill(planes.depth, info.clear.depth, kBinPixels);
        std::fill_n(planes.farthest, kBinTiles, info.farthest);
        info.pending.depth = false;
    }
    if (stencil) {
        mark_alike(planes.stencil_alike);
        std::memset(planes.stencil, info.clear.stencil, kBinPixels);
        info.pending.stencil = false;
    }
}

void Target::make_second_color() {
    if (m_other_color) return;
    Plane<uint8_t> marks = new_alike_marks();
    m_other_color = new_color();
    m_other_color_alike = std::move(marks);
}

void Target::select_color(ColorPlane plane) {
    if (plane == m_selected) return;
    exchange_color();
    m_selected = plane;
}

void Target::swap_colors() {
    exchange_color();
}

// What is still to be cleared is so in the colour buffer that is in its place.
void Target::exchange_color() {
    for (int i = 0; i < bin_count(); ++i) materialize(i, {true, false, false});
    std::swap(m_color, m_other_color);
    std::swap(m_color_alike, m_other_color_alike);
}

Target::Depths Target::save_depths() const {
    const size_t bins = static_cast<size_t>(bin_count()), samples = bins * bin_samples(),
                 tiles = bins * kBinTiles;
    Depths out;
    const auto save = [](const auto& plane, size_t count, auto& to) {
        if (plane) to.assign(plane.get(), plane.get() + count);
    };
    save(m_depth, samples, out.depth);
    save(m_stencil, samples, out.stencil);
    save(m_farthest, tiles, out.farthest);
    save(m_depth_alike, tiles, out.depth_alike);
    save(m_stencil_alike, tiles, out.stencil_alike);
    out.states = m_states;
    return out;
}

void Target::restore_depths(const Depths& saved) {
    std::ranges::copy(saved.depth, m_depth.get());
    std::ranges::copy(saved.farthest, m_farthest.get());
    std::ranges::copy(saved.stencil, m_stencil.get());
    std::ranges::copy(saved.depth_alike, m_depth_alike.get());
    std::ranges::copy(saved.stencil_alike, m_stencil_alike.get());
    for (size_t i = 0; i < m_states.size(); ++i) {
        const BinState color = m_states[i];
        m_states[i] = saved.states[i];
        m_states[i].pending.color = color.pending.color;
        std::copy_n(color.clear.color, 4, m_states[i].clear.color);
    }
}

void Target::forget_farthest(int index) {
    const Bin planes = bin(index);
    if (planes.farthest == nullptr) return;
    std::fill_n(planes.farthest, kBinTiles, std::numeric_limits<float>::infinity());
    planes.state->farthest = std::numeric_limits<float>::infinity();
}

}  // namespace terrazzo::raster
