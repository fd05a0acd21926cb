// Memory of a render target and its deferred clears; the layout is explained in target.h.
#include "raster/target/target.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>

#include "raster/target/color_format.h"
#include "raster/target/plane_kernels.h"

namespace terrazzo::raster {

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

Plane<std::byte> Target::new_color() const {
    return {m_bins_across, m_bins_up, bin_samples() * static_cast<size_t>(bytes_per_pixel(m_format.color))};
}

Plane<float> Target::new_farthest() const {
    return {m_bins_across, m_bins_up, kBinTiles};
}

Plane<uint8_t> Target::new_alike_marks() const {
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

// Bounds of tiles can wait: they are nobody else's.
void Target::settle_row(int row_of_bins) {
    const int first = row_of_bins * m_bins_across;
    for (int i = first; i < first + m_bins_across; ++i) {
        const ClearPlanes pending = state(i).pending;
        if (pending.color) fill_color_of(i);
        if (pending.depth) fill_depth_of(i);
        if (pending.stencil) fill_stencil_of(i);
    }
}

void Target::settle() {
    for (int row = 0; row < m_bins_up; ++row) settle_row(row);
}

int Target::bins_to_fill() const {
    int count = 0;
    for (int i = 0; i < bin_count(); ++i) {
        const BinState& bin = m_states[static_cast<size_t>(i)];
        if (!bin.pending.any()) continue;
        count += (bin.pending.color && !m_color.store().holds(place_in(m_color, i), clear_color_word(bin))) ||
                 (bin.pending.depth && !m_depth.store().holds(place_in(m_depth, i), bin.clear.depth)) ||
                 (bin.pending.stencil && !m_stencil.store().holds(place_in(m_stencil, i), bin.clear.stencil));
    }
    return count;
}

void Target::start_over() {
    for (int i = 0; i < bin_count(); ++i) state(i).pending = {};
    forget_bounds();
}

void Target::forget_bounds() {
    for (int i = 0; i < bin_count(); ++i) forget_farthest(i);
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
        bin.bounds_pending = true;
    }
    if (planes.stencil && m_stencil) {
        bin.pending.stencil = true;
        bin.clear.stencil = values.stencil;
    }
}

// What a bin of the clear colour would hold, where that is a word.
std::optional<uint32_t> Target::clear_color_word(const BinState& bin) const {
    if (bytes_per_pixel(m_format.color) > 4) return std::nullopt;
    std::byte pixel[16] = {};
    encode_color(m_format.color, bin.clear.color, pixel);
    uint32_t word;
    std::memcpy(&word, pixel, sizeof word);
    return word;
}

std::optional<ClearValues> Target::uniform_values(int index, ClearPlanes planes) const {
    const BinState& bin = m_states[static_cast<size_t>(index)];
    ClearValues values = bin.clear;
    const auto holds_one = [&](const auto& plane, bool pending, auto& value) {
        if (!plane || pending) return true;
        const std::optional<uint32_t> known = plane.store().uniform_value(place_in(plane, index));
        if (known) value = static_cast<std::remove_reference_t<decltype(value)>>(*known);
        return known.has_value();
    };
    if (planes.depth && !holds_one(m_depth, bin.pending.depth, values.depth)) return std::nullopt;
    if (planes.stencil && !holds_one(m_stencil, bin.pending.stencil, values.stencil)) return std::nullopt;
    if (!planes.color || !m_color || bin.pending.color) return values;
    if (m_format.color != ColorFormat::kRgba8) return std::nullopt;
    const std::optional<uint32_t> word = m_color.store().uniform_value(place_in(m_color, index));
    if (!word) return std::nullopt;
    std::byte pixel[4];
    std::memcpy(pixel, &*word, sizeof pixel);
    decode_color(m_format.color, pixel, values.color);
    return values;
}

void Target::fill_color_of(int index) {
    BinState& state = this->state(index);
    state.pending.color = false;
    const std::optional<uint32_t> word = clear_color_word(state);
    const size_t place = place_in(m_color, index);
    const Bin planes = bin(index);
    if (planes.color_alike) std::memset(planes.color_alike, 1, kBinTiles);
    if (m_color.store().holds(place, word)) return;
    if (m_format.color == ColorFormat::kRgba8) {
        plane_kernels().fill(reinterpret_cast<uint32_t*>(planes.color), *word, kBinPixels);
    } else {
        fill_color(m_format.color, state.clear.color, planes.color, kBinPixels);
    }
    m_color.store().filled(place, word);
}

void Target::fill_depth_of(int index) {
    BinState& state = this->state(index);
    state.pending.depth = false;
    const size_t place = place_in(m_depth, index);
    if (m_depth_alike) std::memset(bin(index).depth_alike, 1, kBinTiles);
    if (!m_depth.store().holds(place, state.clear.depth))
        plane_kernels().fill(bin(index).depth, state.clear.depth, kBinPixels);
    m_depth.store().filled(place, state.clear.depth);
}

void Target::fill_stencil_of(int index) {
    BinState& state = this->state(index);
    state.pending.stencil = false;
    const size_t place = place_in(m_stencil, index);
    const Bin planes = bin(index);
    if (planes.stencil_alike) std::memset(planes.stencil_alike, 1, kBinTiles);
    if (m_stencil.store().holds(place, state.clear.stencil)) return;
    std::memset(planes.stencil, state.clear.stencil, kBinPixels);
    m_stencil.store().filled(place, state.clear.stencil);
}

void Target::materialize(int index, ClearPlanes wanted, ClearPlanes written) {
    BinState& info = state(index);
    if (wanted.color && m_color) {
        if (info.pending.color) fill_color_of(index);
        if (written.color) m_color.store().written(place_in(m_color, index));
    }
    if (wanted.depth && m_depth) {
        const size_t place = place_in(m_depth, index);
        PlaneStore& depths = m_depth.store();
        if (info.pending.depth) fill_depth_of(index);
        if (depths.is_stale(place)) depths.bring_over(place);
        if (written.depth) depths.written(place);
        if (info.bounds_pending) {
            std::fill_n(bin(index).farthest, kBinTiles, info.farthest);
            info.bounds_pending = false;
        }
    }
    if (wanted.stencil && m_stencil) {
        if (info.pending.stencil) fill_stencil_of(index);
        if (written.stencil) m_stencil.store().written(place_in(m_stencil, index));
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
    for (int i = 0; i < bin_count(); ++i) materialize(i, {true, false, false}, {});
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
        const int index = static_cast<int>(i);
        if (m_depth) m_depth.store().written(place_in(m_depth, index));
        if (m_stencil) m_stencil.store().written(place_in(m_stencil, index));
        const BinState color = m_states[i];
        m_states[i] = saved.states[i];
        m_states[i].pending.color = color.pending.color;
        std::copy_n(color.clear.color, 4, m_states[i].clear.color);
    }
}

void Target::forget_farthest(int index) {
    BinState& info = state(index);
    info.farthest = std::numeric_limits<float>::infinity();
    info.bounds_pending = true;
}

std::unique_ptr<PlanePixels> Target::new_depths() const {
    return std::make_unique<PlanePixels>(static_cast<size_t>(bin_count()), bin_samples() * sizeof(uint32_t));
}

std::shared_ptr<PlanePixels> Target::exchange_depths(std::shared_ptr<PlanePixels> next) {
    return m_depth.store().exchange(std::move(next));
}

void Target::start_from_depths(std::shared_ptr<const PlanePixels> depths) {
    m_depth.store().start_from(std::move(depths));
}

void Target::keep_depths_of_row(int row_of_bins) {
    for (int column = 0; column < m_bins_across; ++column) {
        const size_t place = m_depth.index(column, row_of_bins);
        if (m_depth.store().is_stale(place)) m_depth.store().bring_over(place);
    }
}

int Target::depths_to_copy() const {
    int count = 0;
    for (int i = 0; i < bin_count(); ++i) count += m_depth.store().needs_copy(place_in(m_depth, i));
    return count;
}

void Target::let_go_of_texture() {
    m_depth.store().let_go_of_source();
}

}  // namespace terrazzo::raster
