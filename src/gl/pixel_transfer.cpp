// Pixel transfer operations on rows of groups.
#include "gl/pixel_transfer.h"

#include <algorithm>
#include <cmath>

#include "gl/texel_row.h"

namespace terrazzo::gl {
namespace {

float look_up(const PixelMap& map, float value) {
    const float position = value > 0.0f ? std::min(value, 1.0f) : 0.0f;  // NaN too is position 0
    return map.values[static_cast<size_t>(std::lrint(position * static_cast<float>(map.size - 1)))];
}

// Sizes of maps from indices are powers of two (GL 1.5 §3.6.3).
float look_up_index(const PixelMap& map, uint32_t index) {
    return map.values[index & static_cast<uint32_t>(map.size - 1)];
}

uint32_t shift_and_offset(const PixelTransfer& transfer, uint32_t index) {
    const int shift = transfer.index_shift;
    if (shift >= 32 || shift <= -32) {
        index = 0;
    } else if (shift >= 0) {
        index <<= shift;
    } else {
        index >>= -shift;
    }
    return index + static_cast<uint32_t>(transfer.index_offset);
}

}  // namespace

bool changes_colors(const PixelState& state) {
    const PixelTransfer& transfer = state.mode.transfer;
    const std::array<GLfloat, 4> one{1, 1, 1, 1}, zero{};
    return transfer.map_color || transfer.scale != one || transfer.bias != zero;
}

bool changes_depths(const PixelState& state) {
    return state.mode.transfer.depth_scale != 1.0f || state.mode.transfer.depth_bias != 0.0f;
}

void transfer_colors(const PixelState& state, float* rgba, int count) {
    const PixelTransfer& transfer = state.mode.transfer;
    for (int i = 0; i < 4 * count; ++i) {
        const auto channel = static_cast<size_t>(i & 3);
        rgba[i] = rgba[i] * transfer.scale[channel] + transfer.bias[channel];
    }
    if (!transfer.map_color) return;
    for (int i = 0; i < 4 * count; ++i) {
        rgba[i] = look_up(state.maps[static_cast<size_t>(kMapRToR + (i & 3))], rgba[i]);
    }
}

void transfer_indices_to_colors(const PixelState& state, const uint32_t* indices, int count, float* rgba) {
    for (int i = 0; i < count; ++i) {
        const uint32_t index = shift_and_offset(state.mode.transfer, indices[i]);
        for (int channel = 0; channel < 4; ++channel) {
            *rgba++ = look_up_index(state.maps[static_cast<size_t>(kMapIToR + channel)], index);
        }
    }
}

bool changes_stencils(const PixelState& state) {
    const PixelTransfer& transfer = state.mode.transfer;
    return transfer.index_shift != 0 || transfer.index_offset != 0 || transfer.map_stencil;
}

void transfer_stencils(const PixelState& state, uint32_t* indices, int count) {
    constexpr uint32_t kStencilMask = 0xff;  // stencil buffers have 8 bits
    const PixelTransfer& transfer = state.mode.transfer;
    for (int i = 0; i < count; ++i) {
        indices[i] = shift_and_offset(transfer, indices[i]) & kStencilMask;
        if (transfer.map_stencil) {
            indices[i] = static_cast<uint32_t>(std::lrint(look_up_index(state.maps[kMapSToS], indices[i])));
        }
    }
}

void transfer_depths(const PixelState& state, float* depths, int count) {
    const PixelTransfer& transfer = state.mode.transfer;
    for (int i = 0; i < count; ++i) {
        depths[i] = std::clamp(depths[i] * transfer.depth_scale + transfer.depth_bias, 0.0f, 1.0f);
    }
}

void transfer_packed_depths(const PixelState& state, uint32_t* depths, int count, int bits) {
    const bool changes = changes_depths(state);
    if (!changes && bits == 24) return;
    const auto maximum = static_cast<double>((uint64_t{1} << bits) - 1);
    for (int i = 0; i < count; ++i) {
        if (!changes) {
            depths[i] = resize_depth(depths[i], 24, static_cast<unsigned>(bits));
            continue;
        }
        auto z = static_cast<float>(depths[i] * (1.0 / 16777215.0));
        transfer_depths(state, &z, 1);
        depths[i] = static_cast<uint32_t>(std::llrint(z * maximum));
    }
}

}  // namespace terrazzo::gl
