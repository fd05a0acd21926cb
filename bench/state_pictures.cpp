// OSMesa's buffers as numbers.
#include "state_pictures.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace terrazzo::bench {
namespace {

using states::Axis;

template <typename Stored>
std::vector<float> scaled(const std::vector<std::uint8_t>& bytes, float factor) {
    std::vector<float> values(bytes.size() / sizeof(Stored));
    for (std::size_t i = 0; i < values.size(); ++i) {
        Stored value;
        std::memcpy(&value, bytes.data() + i * sizeof value, sizeof value);
        values[i] = static_cast<float>(value) * factor;
    }
    return values;
}

std::vector<float> unpacked_565(const std::vector<std::uint8_t>& bytes) {
    std::vector<float> values;
    values.reserve(bytes.size() / 2 * 3);
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        std::uint16_t pixel;
        std::memcpy(&pixel, bytes.data() + i, sizeof pixel);
        values.push_back(static_cast<float>(pixel >> 11) * 255 / 31);
        values.push_back(static_cast<float>(pixel >> 5 & 63) * 255 / 63);
        values.push_back(static_cast<float>(pixel & 31) * 255 / 31);
    }
    return values;
}

// The largest difference that is no more than a rounding.
float tolerated(const states::State& state) {
    const bool is_coarse = state.number(Axis::kBuffer, 1) == GL_UNSIGNED_SHORT_5_6_5;
    return (is_coarse ? 255.0F / 31 : 1) + 1e-3F;
}

// NaN is unlike everything but itself.
float distance(float a, float b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
    const float distance = std::fabs(a - b);
    return std::isnan(distance) ? 255 : distance;
}

}  // namespace

std::vector<float> values_of(const states::State& state, const std::vector<std::uint8_t>& bytes) {
    switch (state.number(Axis::kBuffer, 1)) {
        case GL_UNSIGNED_SHORT_5_6_5:
            return unpacked_565(bytes);
        case GL_UNSIGNED_SHORT:
            return scaled<std::uint16_t>(bytes, 255.0F / 65535);
        case GL_FLOAT:
            return scaled<float>(bytes, 255);
        default:
            return scaled<std::uint8_t>(bytes, 1);
    }
}

PictureDifference difference(const states::State& state, const std::vector<std::uint8_t>& a,
                             const std::vector<std::uint8_t>& b) {
    if (a.size() != b.size()) throw std::runtime_error("pictures of different sizes");
    const std::vector<float> ours = values_of(state, a), theirs = values_of(state, b);
    const float step = tolerated(state);
    PictureDifference result;
    std::size_t differing = 0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        const float off = distance(ours[i], theirs[i]);
        differing += off > step;
        result.largest = std::max(result.largest, static_cast<double>(off));
    }
    if (!ours.empty()) result.share = static_cast<double>(differing) / static_cast<double>(ours.size());
    return result;
}

bool is_uniform(const states::State& state, const std::vector<std::uint8_t>& bytes) {
    const std::vector<float> values = values_of(state, bytes);
    const std::size_t channels = state.number(Axis::kBuffer, 2);
    for (std::size_t i = channels; i < values.size(); ++i)
        if (values[i] != values[i % channels]) return false;
    return true;
}

}  // namespace terrazzo::bench
