// Vertex fetch: attributes of 16 vertices from client memory to lanes (GL 1.5 §2.8).
#pragma once

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <type_traits>

#include "pipeline/geometry/vertex_input.h"
#include "simd/wide.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace pipeline;

// Up to sixteen elements of the streams: where lane i's element number is.
struct ElementBatch {
    const uint32_t* elements;  // null: first, first + 1, ...
    uint32_t first;
    int count;  // 1 to 16; lanes beyond repeat the last

    TERRAZZO_INLINE uint32_t element(int lane) const {
        const int i = lane < count ? lane : count - 1;
        return elements ? elements[i] : first + static_cast<uint32_t>(i);
    }
};

struct Wide4 {
    F32x16 x, y, z, w;
};

// Integers of vertex arrays, with products where GL 1.5 table 2.9 has quotients. Signed ones come out as from
// glNormal3b and its like, bit by bit (gl/convert.h); unsigned ones as the reference's.
template <class T>
TERRAZZO_INLINE float component(const std::byte* from, bool normalized) {
    T value;
    std::memcpy(&value, from, sizeof value);
    if (!normalized) return static_cast<float>(value);
    if constexpr (std::is_same_v<T, uint32_t>) {
        const float above_one = std::bit_cast<float>(0x3f800000u | value >> 9);
        return (above_one - 1.0f) * static_cast<float>(8388608.0 / 8388607.0);
    } else if constexpr (std::is_same_v<T, int32_t>) {
        return static_cast<float>((2.0f * static_cast<float>(value) + 1.0f) * (1.0 / 4294967294.0));
    } else if constexpr (std::is_signed_v<T>) {
        constexpr float kScale =
            1.0f / static_cast<float>(std::numeric_limits<std::make_unsigned_t<T>>::max());
        return (2.0f * static_cast<float>(value) + 1.0f) * kScale;
    } else {
        return static_cast<float>(value) * static_cast<float>(1.0 / std::numeric_limits<T>::max());
    }
}

template <class T>
inline void fetch_components(const AttributeStream& s, const ElementBatch& batch, float (*out)[16]) {
    for (int lane = 0; lane < 16; ++lane) {
        const std::byte* const from = s.data + static_cast<size_t>(batch.element(lane)) * s.stride;
        for (int c = 0; c < s.components; ++c) {
            const std::byte* const at = from + static_cast<size_t>(c) * sizeof(T);
            if constexpr (std::is_floating_point_v<T>) {
                T value;
                std::memcpy(&value, at, sizeof value);
                out[c][lane] = static_cast<float>(value);
            } else {
                out[c][lane] = component<T>(at, s.normalized);
            }
        }
    }
}

inline Wide4 fetch_converted(const AttributeStream& s, const ElementBatch& batch) {
    alignas(64) float out[4][16];
    for (int lane = 0; lane < 16; ++lane) out[1][lane] = out[2][lane] = 0, out[3][lane] = 1;
    switch (s.type) {
        case ComponentType::kInt8:
            fetch_components<int8_t>(s, batch, out);
            break;
        case ComponentType::kUint8:
            fetch_components<uint8_t>(s, batch, out);
            break;
        case ComponentType::kInt16:
            fetch_components<int16_t>(s, batch, out);
            break;
        case ComponentType::kUint16:
            fetch_components<uint16_t>(s, batch, out);
            break;
        case ComponentType::kInt32:
            fetch_components<int32_t>(s, batch, out);
            break;
        case ComponentType::kUint32:
            fetch_components<uint32_t>(s, batch, out);
            break;
        case ComponentType::kFloat32:
            fetch_components<float>(s, batch, out);
            break;
        case ComponentType::kFloat64:
            fetch_components<double>(s, batch, out);
            break;
    }
    return {load(out[s.bgra ? 2 : 0]), load(out[1]), load(out[s.bgra ? 0 : 2]), load(out[3])};
}

TERRAZZO_INLINE Wide4 fetch(const VertexInput& input, int attribute, const ElementBatch& batch) {
    if (!(input.streamed & bit(attribute))) {
        const auto& c = input.constants[static_cast<size_t>(attribute)];
        return {c[0], c[1], c[2], c[3]};
    }
    const AttributeStream& s = input.streams[static_cast<size_t>(attribute)];
    const bool aligned = (reinterpret_cast<uintptr_t>(s.data) | s.stride) % sizeof(float) == 0;
    if (s.type != ComponentType::kFloat32 || batch.elements != nullptr || !aligned || s.stride > 4096)
        return fetch_converted(s, batch);
    // Consecutive floats: lanes are a constant stride apart.
    const float* const base =
        reinterpret_cast<const float*>(s.data + static_cast<size_t>(batch.first) * s.stride);
    const I32x16 index =
        min(lane_numbers(), I32x16(batch.count - 1)) * I32x16(static_cast<int32_t>(s.stride / sizeof(float)));
    Wide4 v{gather(base, index), F32x16(0.0f), F32x16(0.0f), F32x16(1.0f)};
    if (s.components > 1) v.y = gather(base + 1, index);
    if (s.components > 2) v.z = gather(base + 2, index);
    if (s.components > 3) v.w = gather(base + 3, index);
    return v;
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
