// Stage: client side, the states of `terrazzo bench states`: the table of axes.
// Input: nothing. Output: per axis its values, each with a name and the numbers that the code which applies
// it takes from here (GL enumerants where GL has them). Invariant: an axis's first value is the one a state
// has by default; names are unique within an axis and need no quotes on a command line.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "kit/library.h"

namespace terrazzo::states {

enum class Axis {
    kGeometry,
    kPrimitive,
    kGiven,
    kColour,
    kView,
    kLights,
    kMaterial,
    kShade,
    kCull,
    kUnits,
    kTarget,
    kFormat,
    kSize,
    kFilter,
    kWrap,
    kTexels,
    kEnvironment,
    kTexgen,
    kFog,
    kAlpha,
    kBlend,
    kStencil,
    kDepth,
    kMask,
    kOffset,
    kScissor,
    kClip,
    kBuffer,
    kSamples,
};
inline constexpr std::size_t kAxisCount = 29;

struct Value {
    const char* name;
    GLenum numbers[5];  // what they mean is said beside each axis's table
};

struct AxisEntry {
    Axis axis;
    const char* name;
    std::span<const Value> values;
};

// In the order of the enumeration.
std::span<const AxisEntry> axes();
const AxisEntry& entry(Axis axis);
// Throws std::invalid_argument, in words, for a name that is not in the table.
const AxisEntry& axis_called(std::string_view name);
std::size_t value_called(const AxisEntry& axis, std::string_view name);

// The numbers of axes for which GL has no enumerants.
enum Given : GLenum { kElements, kArrays, kImmediate, kList, kVertexBuffer, kStreamedBuffer, kLockedArrays };
enum Light : GLenum {
    kSpecular = 1,
    kSpot = 2,
    kTwoSided = 4,
    kSeparate = 8,
    kPositional = 16,
    kLocalViewer = 32,
};
enum Texels : GLenum { kUploaded, kUpdated, kCopied, kRendered };
enum Stencil : GLenum { kNoStencil, kReplaced, kMasked, kCounted, kSides };
// Sums of these say which coordinates are generated.
enum Texgen : GLenum { kNoTexgen = 0, kS = 1, kT = 2, kR = 4, kQ = 8 };

}  // namespace terrazzo::states
