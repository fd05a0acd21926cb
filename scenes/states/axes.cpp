// The table of axes. A line more here is a state more everywhere: in the list, in random states, in the
// tests.
#include "axes.h"

#include <array>
#include <stdexcept>
#include <string>

namespace terrazzo::states {
namespace {

// Cells along an edge of a sheet, sheets: 24, 4096 and 65536 triangles.
constexpr Value kGeometries[] = {{"medium", {32, 2}}, {"large", {2, 3}}, {"small", {128, 2}}};

// Mode, size of lines or points, what is enabled, polygon mode.
constexpr Value kPrimitives[] = {
    {"triangles", {GL_TRIANGLES, 1, 0, GL_FILL}},
    {"strips", {GL_TRIANGLE_STRIP, 1, 0, GL_FILL}},
    {"fans", {GL_TRIANGLE_FAN, 1, 0, GL_FILL}},
    {"quads", {GL_QUADS, 1, 0, GL_FILL}},
    {"quad-strips", {GL_QUAD_STRIP, 1, 0, GL_FILL}},
    {"stippled-polygons", {GL_TRIANGLES, 1, GL_POLYGON_STIPPLE, GL_FILL}},
    {"mode-line", {GL_TRIANGLES, 1, 0, GL_LINE}},
    {"mode-point", {GL_TRIANGLES, 2, 0, GL_POINT}},
    {"lines", {GL_LINES, 1, 0, GL_FILL}},
    {"line-strips", {GL_LINE_STRIP, 1, 0, GL_FILL}},
    {"wide-lines", {GL_LINES, 4, 0, GL_FILL}},
    {"stippled-lines", {GL_LINES, 1, GL_LINE_STIPPLE, GL_FILL}},
    {"smooth-lines", {GL_LINES, 2, GL_LINE_SMOOTH, GL_FILL}},
    {"points", {GL_POINTS, 1, 0, GL_FILL}},
    {"large-points", {GL_POINTS, 6, 0, GL_FILL}},
    {"smooth-points", {GL_POINTS, 6, GL_POINT_SMOOTH, GL_FILL}},
};

constexpr Value kGivens[] = {{"elements", {kElements}},         {"arrays", {kArrays}},
                             {"immediate", {kImmediate}},       {"list", {kList}},
                             {"vbo", {kVertexBuffer}},          {"streamed-vbo", {kStreamedBuffer}},
                             {"locked-arrays", {kLockedArrays}}};

// Type of the colour of a vertex; 0: one colour for all.
constexpr Value kColours[] = {{"bytes", {GL_UNSIGNED_BYTE}}, {"floats", {GL_FLOAT}}, {"constant", {0}}};

constexpr Value kViews[] = {{"perspective", {0}}, {"orthographic", {1}}};

// How many, and what of Light they have.
constexpr Value kLights[] = {
    {"none", {0, 0}},
    {"directional", {1, 0}},
    {"specular", {2, kSpecular | kPositional}},
    {"eight", {8, kPositional}},
    {"spot", {1, kSpot | kPositional}},
    {"two-sided", {1, kTwoSided}},
    {"separate-specular", {2, kSpecular | kSeparate}},
    {"local-viewer", {1, kSpecular | kLocalViewer}},
};

constexpr Value kMaterials[] = {{"fixed", {0}}, {"tracks-colour", {GL_AMBIENT_AND_DIFFUSE}}};
constexpr Value kShades[] = {{"smooth", {GL_SMOOTH}}, {"flat", {GL_FLAT}}};
constexpr Value kCulls[] = {{"none", {0}}, {"back", {GL_BACK}}};
constexpr Value kUnits[] = {{"none", {0}}, {"one", {1}}, {"two", {2}}, {"three", {3}}, {"eight", {8}}};

// Target, dimensions.
constexpr Value kTargets[] = {{"2d", {GL_TEXTURE_2D, 2}},
                              {"1d", {GL_TEXTURE_1D, 1}},
                              {"3d", {GL_TEXTURE_3D, 3}},
                              {"cube", {GL_TEXTURE_CUBE_MAP, 3}}};

// Internal format, external format, type.
constexpr Value kFormats[] = {
    {"rgba8", {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE}},
    {"rgb8", {GL_RGB8, GL_RGBA, GL_UNSIGNED_BYTE}},
    {"luminance", {GL_LUMINANCE8, GL_RGBA, GL_UNSIGNED_BYTE}},
    {"alpha", {GL_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE}},
    {"luminance-alpha", {GL_LUMINANCE8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE}},
    {"intensity", {GL_INTENSITY8, GL_RGBA, GL_UNSIGNED_BYTE}},
    {"rgb565", {GL_RGB5, GL_RGBA, GL_UNSIGNED_BYTE}},
    {"rgba16", {GL_RGBA16, GL_RGBA, GL_UNSIGNED_BYTE}},
    {"depth-compare", {GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT}},
    {"dxt1", {GL_COMPRESSED_RGB_S3TC_DXT1_EXT}},
    {"dxt5", {GL_COMPRESSED_RGBA_S3TC_DXT5_EXT}},
};

// Width, height; of a 3D texture, which is as deep as it is high.
constexpr Value kSizes[] = {
    {"256", {256, 256, 32, 32}}, {"npot", {200, 150, 30, 20}}, {"1024", {1024, 1024, 64, 64}}};

// Minifying, magnifying filter, anisotropy.
constexpr Value kFilters[] = {
    {"linear", {GL_LINEAR, GL_LINEAR, 1}},
    {"nearest", {GL_NEAREST, GL_NEAREST, 1}},
    {"nearest-mipmap-nearest", {GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST, 1}},
    {"linear-mipmap-nearest", {GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR, 1}},
    {"nearest-mipmap-linear", {GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR, 1}},
    {"trilinear", {GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, 1}},
    {"anisotropic", {GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, 4}},
};

constexpr Value kWraps[] = {{"repeat", {GL_REPEAT}},
                            {"edge", {GL_CLAMP_TO_EDGE}},
                            {"border", {GL_CLAMP_TO_BORDER}},
                            {"clamp", {GL_CLAMP}},
                            {"mirrored", {GL_MIRRORED_REPEAT}}};

constexpr Value kTexelValues[] = {
    {"uploaded", {kUploaded}}, {"updated", {kUpdated}}, {"copied", {kCopied}}, {"rendered", {kRendered}}};

// Mode; of combine its function, scale, two sources.
constexpr Value kEnvironments[] = {
    {"modulate", {GL_MODULATE}},
    {"replace", {GL_REPLACE}},
    {"decal", {GL_DECAL}},
    {"blend", {GL_BLEND}},
    {"add", {GL_ADD}},
    {"combine-modulate-x2", {GL_COMBINE, GL_MODULATE, 2, GL_TEXTURE, GL_PREVIOUS}},
    {"combine-interpolate", {GL_COMBINE, GL_INTERPOLATE, 1, GL_TEXTURE, GL_PREVIOUS}},
    {"combine-add-signed", {GL_COMBINE, GL_ADD_SIGNED, 1, GL_TEXTURE, GL_PREVIOUS}},
    {"combine-subtract", {GL_COMBINE, GL_SUBTRACT, 1, GL_TEXTURE, GL_PREVIOUS}},
    {"combine-dot3", {GL_COMBINE, GL_DOT3_RGB, 1, GL_TEXTURE, GL_PRIMARY_COLOR}},
    {"combine-crossbar", {GL_COMBINE, GL_INTERPOLATE, 1, GL_TEXTURE0, GL_PREVIOUS}},
};

// Mode, which coordinates.
constexpr Value kTexgens[] = {{"off", {0, kNoTexgen}},
                              {"sphere", {GL_SPHERE_MAP, kS | kT}},
                              {"reflection", {GL_REFLECTION_MAP, kS | kT | kR}},
                              {"object", {GL_OBJECT_LINEAR, kS | kT}},
                              {"eye", {GL_EYE_LINEAR, kS | kT}},
                              {"projective", {GL_EYE_LINEAR, kS | kT | kR | kQ}}};

constexpr Value kFogs[] = {{"none", {0}}, {"linear", {GL_LINEAR}}, {"exp", {GL_EXP}}, {"exp2", {GL_EXP2}}};

// Function, reference in 255ths.
constexpr Value kAlphas[] = {{"off", {0}},
                             {"greater", {GL_GREATER, 128}},
                             {"less", {GL_LESS, 230}},
                             {"gequal", {GL_GEQUAL, 64}},
                             {"always", {GL_ALWAYS, 0}}};

// What is enabled; factors and equation, or the logic operation.
constexpr Value kBlends[] = {
    {"none", {0}},
    {"alpha", {GL_BLEND, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_FUNC_ADD}},
    {"alpha-add", {GL_BLEND, GL_SRC_ALPHA, GL_ONE, GL_FUNC_ADD}},
    {"add", {GL_BLEND, GL_ONE, GL_ONE, GL_FUNC_ADD}},
    {"multiply", {GL_BLEND, GL_DST_COLOR, GL_ZERO, GL_FUNC_ADD}},
    {"constant", {GL_BLEND, GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_ALPHA, GL_FUNC_ADD}},
    {"subtract", {GL_BLEND, GL_SRC_ALPHA, GL_ONE, GL_FUNC_REVERSE_SUBTRACT}},
    {"min", {GL_BLEND, GL_ONE, GL_ONE, GL_MIN}},
    {"max", {GL_BLEND, GL_ONE, GL_ONE, GL_MAX}},
    {"logic-xor", {GL_COLOR_LOGIC_OP, GL_XOR}},
};

constexpr Value kStencils[] = {{"off", {kNoStencil}},
                               {"replaced", {kReplaced}},
                               {"masked", {kMasked}},
                               {"counted", {kCounted}},
                               {"sides", {kSides}}};

// Function, whether depths are written.
constexpr Value kDepths[] = {
    {"less", {GL_LESS, GL_TRUE}},       {"lequal", {GL_LEQUAL, GL_TRUE}}, {"off", {0, GL_FALSE}},
    {"read-only", {GL_LESS, GL_FALSE}}, {"equal", {GL_EQUAL, GL_FALSE}},  {"always", {GL_ALWAYS, GL_TRUE}},
    {"greater", {GL_GREATER, GL_TRUE}},
};

// Red, green, blue, alpha.
constexpr Value kMasks[] = {
    {"all", {1, 1, 1, 1}}, {"rgb", {1, 1, 1, 0}}, {"red-alpha", {1, 0, 0, 1}}, {"none", {0, 0, 0, 0}}};

constexpr Value kOffsets[] = {{"off", {0}}, {"on", {1}}};
constexpr Value kScissors[] = {{"off", {0}}, {"on", {1}}};
constexpr Value kClips[] = {{"off", {0}}, {"two-planes", {2}}};

// Format and type of the buffer given to OSMesa, its channels.
constexpr Value kBuffers[] = {{"rgba8", {OSMESA_RGBA, GL_UNSIGNED_BYTE, 4}},
                              {"bgra8", {OSMESA_BGRA, GL_UNSIGNED_BYTE, 4}},
                              {"rgb565", {OSMESA_RGB_565, GL_UNSIGNED_SHORT_5_6_5, 3}},
                              {"rgba16", {OSMESA_RGBA, GL_UNSIGNED_SHORT, 4}},
                              {"rgba32f", {OSMESA_RGBA, GL_FLOAT, 4}}};

constexpr Value kSampleCounts[] = {{"one", {1}}, {"four", {4}}};

constexpr std::array<AxisEntry, kAxisCount> kAxes{{
    {Axis::kGeometry, "geometry", kGeometries},
    {Axis::kPrimitive, "primitive", kPrimitives},
    {Axis::kGiven, "given", kGivens},
    {Axis::kColour, "colour", kColours},
    {Axis::kView, "view", kViews},
    {Axis::kLights, "lights", kLights},
    {Axis::kMaterial, "material", kMaterials},
    {Axis::kShade, "shade", kShades},
    {Axis::kCull, "cull", kCulls},
    {Axis::kUnits, "units", kUnits},
    {Axis::kTarget, "target", kTargets},
    {Axis::kFormat, "format", kFormats},
    {Axis::kSize, "size", kSizes},
    {Axis::kFilter, "filter", kFilters},
    {Axis::kWrap, "wrap", kWraps},
    {Axis::kTexels, "texels", kTexelValues},
    {Axis::kEnvironment, "environment", kEnvironments},
    {Axis::kTexgen, "texgen", kTexgens},
    {Axis::kFog, "fog", kFogs},
    {Axis::kAlpha, "alpha", kAlphas},
    {Axis::kBlend, "blend", kBlends},
    {Axis::kStencil, "stencil", kStencils},
    {Axis::kDepth, "depth", kDepths},
    {Axis::kMask, "mask", kMasks},
    {Axis::kOffset, "offset", kOffsets},
    {Axis::kScissor, "scissor", kScissors},
    {Axis::kClip, "clip", kClips},
    {Axis::kBuffer, "buffer", kBuffers},
    {Axis::kSamples, "samples", kSampleCounts},
}};

}  // namespace

std::span<const AxisEntry> axes() {
    return kAxes;
}

const AxisEntry& entry(Axis axis) {
    return kAxes[static_cast<std::size_t>(axis)];
}

const AxisEntry& axis_called(std::string_view name) {
    for (const AxisEntry& axis : kAxes)
        if (name == axis.name) return axis;
    throw std::invalid_argument("no axis is called " + std::string(name));
}

std::size_t value_called(const AxisEntry& axis, std::string_view name) {
    for (std::size_t i = 0; i < axis.values.size(); ++i)
        if (name == axis.values[i].name) return i;
    throw std::invalid_argument(std::string(axis.name) + " has no value " + std::string(name));
}

}  // namespace terrazzo::states
