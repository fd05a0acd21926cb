// What a fragment goes through, as plain data: made by src/gl/validate.cpp, kept by the frame while draws are
// queued, read by the pixel kernels. No GL enumerants here or below.
//
// FragmentKey holds every choice that selects code; FragmentState holds the key and the numbers. Fragments go
// through the stages of a batch (stages/), or through a kernel: an instance of the templates in pixel/ for
// one constant key, or the general one that reads the key as it runs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "raster/target/formats.h"

namespace terrazzo::raster {

inline constexpr int kMaxTextureUnits = 8;
inline constexpr int kMaxMipLevels = 15;

enum class Compare : uint8_t {
    kNever,
    kLess,
    kEqual,
    kLessEqual,
    kGreater,
    kNotEqual,
    kGreaterEqual,
    kAlways
};

enum class StencilOp : uint8_t {
    kKeep,
    kZero,
    kReplace,
    kIncrement,
    kDecrement,
    kInvert,
    kIncrementWrap,
    kDecrementWrap
};

enum class BlendFactor : uint8_t {
    kZero,
    kOne,
    kSourceColor,
    kOneMinusSourceColor,
    kDestinationColor,
    kOneMinusDestinationColor,
    kSourceAlpha,
    kOneMinusSourceAlpha,
    kDestinationAlpha,
    kOneMinusDestinationAlpha,
    kConstantColor,
    kOneMinusConstantColor,
    kConstantAlpha,
    kOneMinusConstantAlpha,
    kSourceAlphaSaturate,
};

enum class BlendEquation : uint8_t { kAdd, kSubtract, kReverseSubtract, kMin, kMax };

// The 16 operations of GL 1.5 table 4.2, numbered by their truth table: bit (2*s + d) is the result for bits
// s, d.
using LogicOp = uint8_t;
inline constexpr LogicOp kLogicCopy = 0b1100;

enum class FogMode : uint8_t { kNone, kLinear, kExp, kExp2 };

enum class EnvMode : uint8_t { kModulate, kReplace, kDecal, kBlend, kAdd, kCombine };

// Of two or three arguments a, b, c (GL 1.5 table 3.24, ATI_texture_env_combine3).
enum class CombineFunction : uint8_t {
    kReplace,
    kModulate,
    kAdd,
    kAddSigned,
    kInterpolate,
    kSubtract,
    kDot3Rgb,   // the colours alone
    kDot3Rgba,  // the colours, and alpha instead of its own function
    kModulateAdd,
    kModulateSignedAdd,
    kModulateSubtract,
};

// The texels of units come first.
enum class CombineSource : uint8_t {
    kTexture0,
    kPrimary = kTexture0 + kMaxTextureUnits,
    kPrevious,
    kConstant,
    kZero,
    kOne
};

struct CombineArgument {
    CombineSource source = CombineSource::kZero;
    bool alpha = false;       // the source's alpha in place of its colours
    bool complement = false;  // 1 minus that
};

// One half of a combiner, for the colours or for alpha.
struct CombineHalf {
    CombineFunction function = CombineFunction::kReplace;
    CombineArgument arguments[3];
    float scale = 1;
};

enum class Wrap : uint8_t { kRepeat, kClamp, kClampToEdge, kClampToBorder, kMirroredRepeat };
enum class Filter : uint8_t { kNearest, kLinear };
enum class MipFilter : uint8_t { kNone, kNearest, kLinear };

struct MipLevel {
    // Rows from low t to high, readable 64 bytes before and past. Depths may be in the tiles of a target's
    // plane instead (target/target.h).
    const void* texels = nullptr;
    int32_t width = 0;  // texels
    int32_t height = 0;
    int32_t pitch = 0;  // texels from row to row
    int32_t depth = 1;
    int32_t slice = 0;        // texels from one image of a 3D texture to the next
    int32_t bins_across = 0;  // of tiles: how many bins a row of them has; 0 for rows
};

struct Sampler {
    TexelStorage storage = TexelStorage::kRgba8;
    uint8_t dimensions = 2;  // 1 to 3
    Wrap wrap_s = Wrap::kRepeat;
    Wrap wrap_t = Wrap::kRepeat;
    Wrap wrap_r = Wrap::kRepeat;
    Filter min_filter = Filter::kNearest;
    Filter mag_filter = Filter::kLinear;
    MipFilter mip_filter = MipFilter::kNone;
    uint8_t level_count = 1;
    bool in_floats = false;    // whatever the storage and the wrap modes
    bool anisotropic = false;  // the filters do not count
    float lod_bias = 0, min_lod = -1000, max_lod = 1000;
    float border_color[4] = {};
    std::array<MipLevel, kMaxMipLevels> levels;
    // Of a cube map: six samplers of 2D textures, in the order +x -x +y -y +z -z. Lives in the fragment
    // block.
    const Sampler* faces = nullptr;
    // Of depth textures: what a texel becomes, how many bits it has, and the comparison with r that takes its
    // place.
    BaseFormat depth_mode = BaseFormat::kLuminance;
    uint8_t depth_bits = 24;
    bool compares = false;
    Compare compare_func = Compare::kLessEqual;
};

struct FragmentState;
struct StageCount;
struct TextureStage;
struct Primitive;
struct Bin;
struct Batch;
struct TileList;
struct SampleList;
// One step of all entries of a batch, and one for a texture unit (raster/stages).
using Stage = void (*)(const FragmentState&, Bin& bin, Batch& batch);
using UnitStage = void (*)(const FragmentState&, const TextureStage&, Bin& bin, Batch& batch);

struct TextureStage {
    uint8_t unit = 0;  // whose texture coordinates it samples at
    Sampler sampler;
    EnvMode mode = EnvMode::kModulate;
    BaseFormat base_format = BaseFormat::kRgba;
    float env_color[4] = {};
    CombineHalf rgb, alpha;  // of EnvMode::kCombine
    // Chosen by KernelTable::choose:
    UnitStage coordinates = nullptr, sample = nullptr;
    bool texels_are_floats = false;   // in batches: four floats a texel, or else four bytes
    uint16_t texel_bytes_before = 0;  // of one entry of a batch, by the units before this one
};

enum class BlendKind : uint8_t {
    kNone,
    kGeneral,
    kAlpha,     // SRC_ALPHA, ONE_MINUS_SRC_ALPHA
    kAdditive,  // ONE, ONE
};

// Smooth lines and points carry coverage varyings that multiply alpha: pixel/coverage.h.
enum class Coverage : uint8_t { kNone, kLine, kPoint };

// What a rectangle's TileData is to its fragments (GL 1.5 §3.6.4).
enum class PixelImage : uint8_t {
    kNone,
    kRgba8,     // 16 words a tile in place of the primary colour
    kRgba32F,   // 4 times 16 floats a tile, the same
    kDepth,     // 16 words a tile in the buffer's format, in place of interpolated depth
    kStencil,   // 16 bytes a tile: they go to the stencil buffer through its mask, and nothing else happens
    kVerbatim,  // kRgba8 where nothing is between the image and the buffer
};

// Every choice that selects code. A structural type, so that a constant one can be a template argument.
struct FragmentKey {
    ColorFormat color_format = ColorFormat::kRgba8;
    uint8_t color_mask = 0xf;  // bit 0 red ... bit 3 alpha
    bool depth_test = false;
    bool depth_write = false;
    Compare depth_func = Compare::kLess;
    bool depth_offset = false;
    bool depth_clamp = false;  // to a part of 0..1: FragmentState::depth_range
    bool stencil_test = false;
    Compare alpha_func = Compare::kAlways;
    FogMode fog = FogMode::kNone;
    BlendKind blend = BlendKind::kNone;
    bool logic_op = false;
    bool polygon_stipple = false;
    Coverage coverage = Coverage::kNone;
    bool perspective = true;         // some 1/w of the draw is not 1
    bool interpolated_color = true;  // otherwise FragmentState::constant_color
    bool flat_color = false;         // colours are their planes' origins as they stand
    bool separate_specular = false;  // a secondary colour is added after texturing
    bool counts_samples = false;     // Bin::samples_passed, FragmentState::samples_passed
    // Of multisampled targets (GL 1.5 §4.1.3):
    uint8_t sample_mask = 0xf;  // which samples may be written
    bool alpha_to_coverage = false;
    bool alpha_to_one = false;
    bool textured = false;  // FragmentState::textures
    PixelImage image = PixelImage::kNone;

    [[gnu::always_inline]] friend constexpr bool operator==(const FragmentKey&, const FragmentKey&) = default;
};

struct StencilFace {
    Compare func = Compare::kAlways;
    uint8_t reference = 0, compare_mask = 0xff, write_mask = 0xff;
    StencilOp fail = StencilOp::kKeep, depth_fail = StencilOp::kKeep, pass = StencilOp::kKeep;
};

// Where each varying stands among a primitive's planes, counted in planes; -1 where it is absent.
struct Varyings {
    int8_t color = -1;                               // 4 planes r g b a
    int8_t secondary = -1;                           // 3 planes
    int8_t fog = -1;                                 // 1 plane: the distance
    std::array<int8_t, kMaxTextureUnits> texture{};  // 2 planes s t, 3 planes s t r, or 4 planes s t r q
    uint8_t projective = 0;                          // bit u: unit u has 4 planes and divides by q
    uint8_t uses_r = 0;                              // bit u: unit u has r
    int8_t coverage = -1;                            // 4 planes, only of smooth lines and points
    uint8_t count = 0;                               // planes in all, without z and 1/w

    constexpr Varyings() { texture.fill(-1); }

    // How many planes a unit that samples has.
    constexpr int texture_planes(size_t unit) const {
        return projective >> unit & 1 ? 4 : uses_r >> unit & 1 ? 3 : 2;
    }

    // Whether a varying is part of a colour, which flat shading and two-sided lighting treat apart.
    [[gnu::always_inline]] constexpr bool is_color(int varying) const {
        return (color >= 0 && varying >= color && varying < color + 4) ||
               (secondary >= 0 && varying >= secondary && varying < secondary + 3);
    }
};

// z, 1/w, and all varyings there can be.
inline constexpr int kMaxPlanes = 2 + 4 + 3 + 1 + 4 * kMaxTextureUnits + 4;

// Shades the tiles of `list` that `primitive` covers in `bin`.
using TileKernel = void (*)(const FragmentState&, const Primitive& primitive, Bin& bin, const TileList& list);

// The same on a multisampled target, for the samples of `list`.
using SampleKernel = void (*)(const FragmentState&, const Primitive& primitive, Bin& bin,
                              const SampleList& list);

struct FragmentState {
    FragmentKey key;
    Varyings varyings;
    // Where fragments go through the stages of a batch, as far as there is something for each to do; or else
    // null, and the kernel does it all.
    struct Stages {
        Stage test = nullptr, color = nullptr, output = nullptr;
        Stage sample_test = nullptr,
              sample_output = nullptr;  // in their places where the target is multisampled
        bool is_batched = false;
        bool samples_are_batched = false;
        bool shades = false;            // the texture units' stages are needed
        bool shows_texels = false;      // texels are what goes to the output
        bool exact_coordinates = true;  // of textures: rounded as the reference rounds them
        uint8_t tiles = 0;              // how many entries a batch takes
        // Where somebody asks which stages are taken (stage_log.h); the second of multisampled targets.
        StageCount *count = nullptr, *sample_count = nullptr;
    } stages;
    TileKernel kernel = nullptr;
    SampleKernel sample_kernel = nullptr;  // where the target is multisampled
    bool multisample =
        false;  // each sample of a pixel is tested where it is; else all are where its centre is
    uint8_t texture_count = 0;  // active units, in order
    uint8_t depth_bits = 24;
    float depth_range[2] = {0, 1};  // from low to high
    bool has_destination_alpha = true;

    float constant_color[4] = {1, 1, 1, 1};
    float constant_secondary[3] = {};  // where a secondary colour is added and no varying holds it
    float alpha_reference = 0;
    float fog_color[4] = {};
    // Linear: scale * z + bias; exponential: 2^-(scale * z); squared: 2^-(scale * z)^2.
    float fog_scale = 1, fog_bias = 0;
    BlendFactor blend_source_rgb = BlendFactor::kOne, blend_source_alpha = BlendFactor::kOne;
    BlendFactor blend_destination_rgb = BlendFactor::kZero, blend_destination_alpha = BlendFactor::kZero;
    BlendEquation blend_equation_rgb = BlendEquation::kAdd, blend_equation_alpha = BlendEquation::kAdd;
    float blend_color[4] = {};
    LogicOp logic_op = kLogicCopy;
    StencilFace stencil[2];  // front, back
    const uint32_t* polygon_stipple =
        nullptr;                            // 32 rows from the bottom, bit 31 leftmost; lives in the frame
    int32_t target_height_for_stipple = 0;  // of a target whose row 0 is the top; 0 where row 0 is the bottom

    // Where an occlusion query counts the fragments that pass all tests, by several threads; outlives the
    // state. Null where there is none.
    uint64_t* samples_passed = nullptr;

    // What an error of a varying's plane does to the colour, as a share of its range.
    std::array<float, kMaxPlanes> error_weights{};

    const TextureStage* textures = nullptr;  // texture_count of them; in the frame's memory
};

}  // namespace terrazzo::raster
