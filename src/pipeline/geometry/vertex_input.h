// Where a draw's vertices come from: one stream an attribute, or one constant value for the whole draw.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "raster/fragment_state.h"

namespace terrazzo::pipeline {

enum class ComponentType : uint8_t { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

// Vertex attributes. The material ones are streams only where glMaterial was called between Begin and End.
enum Attribute : uint8_t {
    kPosition,
    kNormal,
    kColor,
    kSecondaryColor,
    kFogCoordinate,
    kEdgeFlag,
    kTexture0,
    kFrontAmbient = kTexture0 + raster::kMaxTextureUnits,
    kFrontDiffuse,
    kFrontSpecular,
    kFrontEmission,
    kFrontShininess,
    kBackAmbient,
    kBackDiffuse,
    kBackSpecular,
    kBackEmission,
    kBackShininess,
    kAttributeCount,
};
using AttributeMask = uint32_t;
constexpr AttributeMask bit(int attribute) {
    return 1u << attribute;
}
static_assert(kAttributeCount <= 32);

struct AttributeStream {
    const std::byte* data = nullptr;  // of element 0
    uint32_t stride = 0;              // bytes from element to element
    ComponentType type = ComponentType::kFloat32;
    uint8_t components = 4;   // those missing are 0, 0, 1 for y, z, w
    bool normalized = false;  // integers map to [0, 1] or [-1, 1] (GL 1.5 table 2.9)
    bool bgra = false;        // the first component is z, the third x
};

struct VertexInput {
    AttributeMask streamed = 0;  // attributes that have a stream; the others are constant
    // Streams of kHomogeneous attributes whose fourth component is 1 in every vertex that is drawn.
    AttributeMask fourth_is_one = 0;
    std::array<AttributeStream, kAttributeCount> streams;
    std::array<std::array<float, 4>, kAttributeCount> constants{};
};

// Attributes that are divided by their fourth component: where it is 1 everywhere drawing is faster, and may
// round another way.
constexpr AttributeMask kHomogeneous = bit(kPosition) | ((1u << raster::kMaxTextureUnits) - 1) << kTexture0;

inline bool has_fourth_one(const VertexInput& input, int attribute) {
    const auto i = static_cast<std::size_t>(attribute);
    if (!(input.streamed & bit(attribute))) return input.constants[i][3] == 1;
    return input.streams[i].components < 4 || (input.fourth_is_one & bit(attribute));
}

enum class PrimitiveMode : uint8_t {
    kPoints,
    kLines,
    kLineLoop,
    kLineStrip,
    kTriangles,
    kTriangleStrip,
    kTriangleFan,
    kQuads,
    kQuadStrip,
    kPolygon,
};

// A run of vertices: consecutive elements, or elements by index.
struct VertexRange {
    uint32_t first = 0;
    uint32_t count = 0;
    const uint32_t* indices = nullptr;  // null: first, first + 1, ...
    // The vertices come as they were given, not through indices or a display list: the reference then cuts
    // quads along their other diagonal where it can (doc/reference.md §3.1).
    bool in_order = false;
    // A strip, loop or polygon that was cut: it began in the draw before, or does not end with this one.
    bool continues = false;
    bool is_continued = false;
};

}  // namespace terrazzo::pipeline
