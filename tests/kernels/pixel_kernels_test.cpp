// Every instruction set's pixel kernels against scalar's: random state and a random primitive in one bin,
// then all three planes byte by byte, with guard bytes around them.
//
// The scalar table has the general kernel and the stages only, so specialised kernels are compared with these
// too.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>

#include "pipeline/schedule/float_environment.h"
#include "random.h"
#include "raster/batch.h"
#include "raster/kernel_table.h"

namespace terrazzo::raster {
namespace {

using stress::Random;

constexpr int kTargetSize = 192, kBinOrigin = 64;  // the middle one of nine bins
constexpr std::uint8_t kGuard = 0xa5;

// A plane's bytes with guards before and behind.
class GuardedPlane {
  public:
    GuardedPlane(Random& random, std::size_t bytes) : m_memory(bytes + 2 * kGuardBytes + 64, kGuard) {
        m_first = m_memory.data() + kGuardBytes;
        m_first += 63 - (reinterpret_cast<std::uintptr_t>(m_first) + 63) % 64;
        for (std::size_t i = 0; i < bytes; ++i) m_first[i] = random.byte();
        m_bytes = bytes;
    }
    std::uint8_t* data() { return m_first; }
    std::size_t size() const { return m_bytes; }
    bool guards_hold() const {
        const auto untouched = [](std::uint8_t byte) { return byte == kGuard; };
        return std::all_of(m_memory.data(), static_cast<const std::uint8_t*>(m_first), untouched) &&
               std::all_of(static_cast<const std::uint8_t*>(m_first) + m_bytes,
                           m_memory.data() + m_memory.size(), untouched);
    }

  private:
    static constexpr std::size_t kGuardBytes = 256;
    std::vector<std::uint8_t> m_memory;
    std::uint8_t* m_first;
    std::size_t m_bytes;
};

// Everything one primitive is drawn with. Does not move: its parts point at one another.
struct Scene {
    explicit Scene(std::uint64_t seed) : random(seed) {
        make_key();
        make_varyings();
        make_numbers();
        make_primitive();
    }
    Scene(const Scene&) = delete;

    void make_key() {
        FragmentKey& key = state.key;
        constexpr ColorFormat kFormats[] = {ColorFormat::kRgba8, ColorFormat::kRgba8, ColorFormat::kRgb565,
                                            ColorFormat::kRgba16, ColorFormat::kRgba32F};
        constexpr BlendKind kBlends[] = {BlendKind::kNone, BlendKind::kNone, BlendKind::kGeneral,
                                         BlendKind::kAlpha, BlendKind::kAdditive};
        // Half of the states are those that specialised kernels are made for.
        key.perspective = random.coin();
        key.interpolated_color = random.coin();
        key.flat_color = key.interpolated_color && random.once_in(4);
        key.textured = !random.once_in(3);
        key.depth_test = random.coin();
        key.depth_write = key.depth_test && !random.once_in(4);
        key.depth_func = random.coin() ? Compare::kLess : static_cast<Compare>(random.below(8));
        if (random.once_in(3)) key.blend = BlendKind::kAlpha;
        if (random.coin()) return;
        key.color_format = random.one_of(kFormats);
        key.color_mask = static_cast<std::uint8_t>(random.coin() ? 15 : random.below(16));
        key.depth_offset = random.coin();
        key.stencil_test = random.coin();
        key.alpha_func = random.coin() ? Compare::kAlways : static_cast<Compare>(random.below(8));
        key.fog = static_cast<FogMode>(random.below(4));
        key.blend = random.one_of(kBlends);
        if (key.color_format != ColorFormat::kRgba8 && key.blend != BlendKind::kNone)
            key.blend = BlendKind::kGeneral;
        key.logic_op = key.blend == BlendKind::kNone && random.once_in(4);
        key.polygon_stipple = random.once_in(4);
        key.separate_specular = random.coin();
    }

    void make_varyings() {
        Varyings& v = state.varyings;
        const auto take = [&](int planes) {
            const std::uint8_t first = v.count;
            v.count = static_cast<std::uint8_t>(v.count + planes);
            return static_cast<std::int8_t>(first);
        };
        if (state.key.interpolated_color) v.color = take(4);
        if (state.key.separate_specular) v.secondary = take(3);
        if (state.key.fog != FogMode::kNone) v.fog = take(1);
        if (!state.key.textured) return;
        const bool general = random.coin();
        state.texture_count = static_cast<std::uint8_t>(general ? 1 + random.below(2) : 1);
        for (std::uint8_t unit = 0; unit < state.texture_count; ++unit) {
            const bool projective = general && random.once_in(4);
            const bool uses_r = projective || (general && random.coin());
            v.texture[unit] = take(projective ? 4 : uses_r ? 3 : 2);
            if (projective) v.projective = static_cast<std::uint8_t>(v.projective | 1u << unit);
            if (uses_r) v.uses_r = static_cast<std::uint8_t>(v.uses_r | 1u << unit);
            make_stage(stages[unit], unit, general);
        }
        state.textures = stages;
    }

    void make_stage(TextureStage& stage, std::uint8_t unit, bool general) {
        stage.unit = unit;
        Sampler& sampler = stage.sampler;
        sampler.min_filter = sampler.mag_filter = Filter::kLinear;
        stage.base_format = random.coin() ? BaseFormat::kRgb : BaseFormat::kRgba;
        if (general) {
            stage.mode = static_cast<EnvMode>(random.below(5));
            stage.base_format = static_cast<BaseFormat>(random.below(6));
            sampler.storage = random.once_in(4) ? TexelStorage::kRgba32F : TexelStorage::kRgba8;
            sampler.wrap_s = static_cast<Wrap>(random.below(5));
            sampler.wrap_t = static_cast<Wrap>(random.below(5));
            sampler.wrap_r = static_cast<Wrap>(random.below(5));
            sampler.dimensions = static_cast<std::uint8_t>(random.once_in(4) ? 3 : 1 + random.below(2));
            if (sampler.dimensions < 3 && random.once_in(4)) make_depth_texture(sampler);
            sampler.min_filter = static_cast<Filter>(random.below(2));
            sampler.mag_filter = static_cast<Filter>(random.below(2));
            sampler.mip_filter = static_cast<MipFilter>(random.below(3));
            sampler.anisotropic = random.once_in(4);
        }
        for (float& c : sampler.border_color) c = random.between(0, 1);
        add_levels(sampler);
        if (general && sampler.storage != TexelStorage::kDepth && random.once_in(4)) make_cube(sampler, unit);
        for (float& c : stage.env_color) c = random.between(0, 1);
    }
    void make_depth_texture(Sampler& sampler) {
        constexpr BaseFormat kModes[] = {BaseFormat::kLuminance, BaseFormat::kIntensity, BaseFormat::kAlpha};
        constexpr std::uint8_t kBits[] = {16, 24, 32};
        sampler.storage = TexelStorage::kDepth;
        sampler.depth_mode = random.one_of(kModes);
        sampler.depth_bits = random.one_of(kBits);
        sampler.compares = random.coin();
        sampler.compare_func = static_cast<Compare>(random.below(8));
    }

    void make_cube(Sampler& sampler, std::size_t unit) {
        sampler.dimensions = 2;
        sampler.wrap_s = sampler.wrap_t = Wrap::kClampToEdge;
        add_levels(sampler);
        for (Sampler& face : cubes[unit]) {
            face = sampler;
            if (random.coin()) add_levels(face);
        }
        sampler.faces = cubes[unit];
    }

    void add_levels(Sampler& sampler) {
        const auto size = [&] { return random.coin() ? 1 << random.below(6) : 1 + random.below(63); };
        int width = size(), height = size(), depth = 1;
        if (sampler.dimensions == 3) width = 1 + width / 4, height = 1 + height / 4, depth = 1 + size() / 4;
        sampler.level_count = 0;
        do {
            add_level(sampler, width, height, depth);
            if (width == 1 && height == 1 && depth == 1) break;
            width = std::max(width / 2, 1);
            height = std::max(height / 2, 1);
            depth = std::max(depth / 2, 1);
        } while (sampler.mip_filter != MipFilter::kNone && sampler.level_count < 6);
    }

    void add_level(Sampler& sampler, int width, int height, int depth) {
        const std::size_t margin = 64, texels = static_cast<std::size_t>(width * height * depth);
        const bool floats = sampler.storage == TexelStorage::kRgba32F;
        auto& memory = images.emplace_back(2 * margin + texels * (floats ? 16 : 4));
        for (std::size_t i = 0; i < texels * 4; ++i) {
            if (floats) {
                const float value = random.between(0, 1);
                std::memcpy(memory.data() + margin + i * 4, &value, sizeof value);
            } else {
                const bool unused = sampler.storage == TexelStorage::kDepth &&
                                    i % 4 >= static_cast<std::size_t>(sampler.depth_bits / 8);
                memory[margin + i] = unused ? std::uint8_t{0} : random.byte();
            }
        }
        sampler.levels[sampler.level_count++] = {memory.data() + margin, width, height, width, depth,
                                                 width * height};
    }

    void make_numbers() {
        state.depth_bits = random.once_in(4) ? 16 : 24;
        state.has_destination_alpha = random.coin();
        for (float& c : state.constant_color) c = random.between(0, 1);
        for (float& c : state.fog_color) c = random.between(0, 1);
        for (float& c : state.blend_color) c = random.between(0, 1);
        state.alpha_reference = random.between(0, 1);
        state.fog_scale = random.between(-1, 2);
        state.fog_bias = random.between(0, 3);
        const auto factor = [&] { return static_cast<BlendFactor>(random.below(15)); };
        state.blend_source_rgb = factor(), state.blend_source_alpha = factor();
        state.blend_destination_rgb = factor(), state.blend_destination_alpha = factor();
        state.blend_equation_rgb = static_cast<BlendEquation>(random.below(5));
        state.blend_equation_alpha = static_cast<BlendEquation>(random.below(5));
        state.logic_op = static_cast<LogicOp>(random.below(16));
        const auto op = [&] { return static_cast<StencilOp>(random.below(8)); };
        for (StencilFace& face : state.stencil)
            face = {static_cast<Compare>(random.below(8)),
                    random.byte(),
                    random.byte(),
                    random.byte(),
                    op(),
                    op(),
                    op()};
        for (std::uint32_t& row : stipple) row = static_cast<std::uint32_t>(random.below(1 << 16)) * 0x10001u;
        state.polygon_stipple = stipple;
        state.target_height_for_stipple = random.coin() ? kTargetSize : 0;
    }

    void make_primitive() {
        Primitive& p = primitive();
        p = {};
        p.state = &state;
        p.plane_count = static_cast<std::uint8_t>(2 + state.varyings.count);
        p.back_facing = random.coin();
        p.is_cut = true;
        p.steep = random.once_in(4);
        p.depth_offset = random.between(-0.1f, 0.1f);
        // Of three rectangles one cuts the bin.
        const auto inset = [&] {
            return static_cast<std::int16_t>(random.once_in(3) ? kBinOrigin + random.below(40) : 0);
        };
        p.x0 = inset(), p.y0 = inset();
        p.x1 = static_cast<std::int16_t>(kTargetSize - inset());
        p.y1 = static_cast<std::int16_t>(kTargetSize - inset());
        p.edge_count = random.once_in(6) ? 0 : 3;
        const auto corner = [&] { return random.below(2 * kTargetSize * 256) - kTargetSize * 128; };
        std::int32_t x[3] = {corner(), corner(), corner()}, y[3] = {corner(), corner(), corner()};
        const std::int64_t area =
            std::int64_t{x[0] - x[1]} * (y[2] - y[0]) - std::int64_t{x[2] - x[0]} * (y[0] - y[1]);
        if (area < 0) std::swap(x[0], x[1]), std::swap(y[0], y[1]);
        for (int e = 0; e < 3; ++e)
            p.edges[e] = Edge::between(x[e], y[e], x[(e + 1) % 3], y[(e + 1) % 3], true, false);
        for (int i = 0; i < p.plane_count; ++i) {
            float* const plane = p.planes() + i;
            plane[0] = random.between(0, 1);
            plane[p.plane_count] = random.between(-0.004f, 0.004f);
            plane[2 * p.plane_count] = random.between(-0.004f, 0.004f);
        }
        p.planes()[1] = random.between(1.6f, 3);  // 1/w stays positive in the target
        constexpr float kExtremes[] = {std::numeric_limits<float>::quiet_NaN(),
                                       std::numeric_limits<float>::infinity(), 1e38f, -1e38f};
        if (random.once_in(8)) p.planes()[random.below(3 * p.plane_count)] = random.one_of(kExtremes);
    }

    // Makes it one of a pile: over planes of one format, mostly in front of what lies there or behind it.
    void flatten_to(std::uint8_t depth_bits) {
        state.key.color_format = ColorFormat::kRgba8;
        state.depth_bits = depth_bits;
        state.key.depth_test = true;
        state.key.depth_write = !random.once_in(8);
        if (!random.once_in(24)) state.key.depth_func = random.coin() ? Compare::kLess : Compare::kLessEqual;
        state.key.stencil_test = random.once_in(8);
        if (!random.once_in(8)) state.key.alpha_func = Compare::kAlways, state.key.polygon_stipple = false;
        // Depths beyond both ends too, where they are cut off.
        primitive().planes()[0] = random.between(-0.3f, 1.3f);
        if (random.once_in(4)) primitive().edge_count = 0;
    }

    Primitive& primitive() { return *reinterpret_cast<Primitive*>(memory); }

    Random random;
    FragmentState state;
    TextureStage stages[2];
    Sampler cubes[2][6];
    std::uint32_t stipple[32];
    std::vector<std::vector<std::uint8_t>> images;
    alignas(16) std::byte memory[Primitive::size_of(kMaxPlanes)];
};

struct Planes {
    Planes(Random random, const FragmentState& state)
        : color(random, static_cast<std::size_t>(kBinPixels * bytes_per_pixel(state.key.color_format))),
          depth(random, kBinPixels * 4),
          stencil(random, kBinPixels) {
        auto* const words = reinterpret_cast<std::uint32_t*>(depth.data());
        for (int i = 0; i < kBinPixels; ++i) words[i] &= (1u << state.depth_bits) - 1;
        if (state.key.color_format != ColorFormat::kRgba32F) return;
        auto* const floats = reinterpret_cast<float*>(color.data());
        for (int i = 0; i < kBinPixels * 4; ++i) floats[i] = random.between(0, 1);
    }
    bool guards_hold() const { return color.guards_hold() && depth.guards_hold() && stencil.guards_hold(); }

    GuardedPlane color, depth, stencil;
};

// A bin over some planes, of whose depths nothing is known.
struct BoundedBin {
    explicit BoundedBin(Planes& planes)
        : bin{reinterpret_cast<std::byte*>(planes.color.data()),
              reinterpret_cast<std::uint32_t*>(planes.depth.data()),
              planes.stencil.data(),
              farthest,
              kBinOrigin,
              kBinOrigin,
              &state} {
        std::fill_n(farthest, kBinTiles, state.farthest);
    }

    BinState state;
    alignas(64) float farthest[kBinTiles];
    Bin bin;
};

void choose(Scene& scene, const KernelTable& table) {
    table.choose(scene.state, {scene.stages, scene.state.texture_count});
}

void draw_into(Bin& bin, Scene& scene, const KernelTable& table) {
    choose(scene, table);
    const auto batch = std::make_unique_for_overwrite<Batch>();
    batch->count = 0;
    table.draw_primitive(scene.primitive(), bin, *batch);
    table.flush(bin, *batch);
}

Planes draw(Scene& scene, const KernelTable& table) {
    Planes planes(Random(7), scene.state);
    BoundedBin bounded(planes);
    draw_into(bounded.bin, scene, table);
    return planes;
}

bool equal(GuardedPlane& a, GuardedPlane& b) {
    return std::memcmp(a.data(), b.data(), a.size()) == 0;
}

class PixelKernels : public testing::TestWithParam<const KernelTable*> {
    // As the renderer has it: ARMv7's vectors know no denormals.
    const pipeline::FloatEnvironment m_environment;
};
// Those that scalar is not compared with itself in.
class AgainstScalar : public PixelKernels {};

TEST_P(AgainstScalar, DrawWhatScalarDraws) {
    int touched = 0;
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        Scene scene(seed);
        Planes expected = draw(scene, *compiled_kernels().back());
        Planes found = draw(scene, *GetParam());
        Planes untouched(Random(7), scene.state);
        touched += !equal(expected.color, untouched.color);
        ASSERT_TRUE(found.guards_hold() && expected.guards_hold()) << "seed " << seed;
        ASSERT_TRUE(equal(expected.color, found.color)) << "colour, seed " << seed;
        ASSERT_TRUE(equal(expected.depth, found.depth)) << "depth, seed " << seed;
        ASSERT_TRUE(equal(expected.stencil, found.stencil)) << "stencil, seed " << seed;
    }
    EXPECT_GT(touched, 600);
}

// Counting changes nothing that is drawn, and every instruction set counts the same.
TEST_P(AgainstScalar, CountWhatPasses) {
    std::uint64_t passed = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        Scene scene(seed);
        Planes expected = draw(scene, *GetParam());
        scene.state.key.counts_samples = true;
        Planes found(Random(7), scene.state), scalar(Random(7), scene.state);
        BoundedBin bin(found), scalar_bin(scalar);
        draw_into(bin.bin, scene, *GetParam());
        draw_into(scalar_bin.bin, scene, *compiled_kernels().back());
        ASSERT_TRUE(equal(expected.color, found.color)) << "colour, seed " << seed;
        ASSERT_TRUE(equal(expected.depth, found.depth)) << "depth, seed " << seed;
        ASSERT_TRUE(equal(expected.stencil, found.stencil)) << "stencil, seed " << seed;
        ASSERT_EQ(bin.bin.samples_passed, scalar_bin.bin.samples_passed) << "seed " << seed;
        passed += bin.bin.samples_passed;
    }
    EXPECT_GT(passed, 20000u);
}

// Many primitives one over the other, once with what the bin remembers of its depths and once without: what
// is skipped because it is hidden must not be missed.
TEST_P(PixelKernels, SkipOnlyWhatIsHidden) {
    std::uint32_t hidden = 0;
    int bounded_bins = 0;
    for (std::uint64_t pile = 0; pile < 40; ++pile) {
        Scene first(pile);
        first.state.key = {};
        first.state.depth_bits = pile % 4 == 0 ? 16 : 24;
        Planes with(Random(7), first.state), without(Random(7), first.state);
        BoundedBin remembering(with);
        for (std::uint64_t seed = 0; seed < 150; ++seed) {
            Scene scene(1000 * pile + seed);
            scene.flatten_to(first.state.depth_bits);
            draw_into(remembering.bin, scene, *GetParam());
            BoundedBin forgetful(without);
            draw_into(forgetful.bin, scene, *GetParam());
            ASSERT_TRUE(equal(with.depth, without.depth)) << "depth, pile " << pile << ", " << seed;
            ASSERT_TRUE(equal(with.color, without.color)) << "colour, pile " << pile << ", " << seed;
            ASSERT_TRUE(equal(with.stencil, without.stencil)) << "stencil, pile " << pile << ", " << seed;
        }
        hidden += remembering.state.hidden;
        bounded_bins += remembering.state.farthest < 1;
    }
    EXPECT_GT(hidden, 500u);
    EXPECT_GT(bounded_bins, 4);
}

// A bin of four samples a pixel, some of whose tiles are marked as alike.
struct SampledBin {
    SampledBin(Random random, const FragmentState& state)
        : color(random, static_cast<std::size_t>(kPixels * bytes_per_pixel(state.key.color_format))),
          depth(random, kPixels * 4),
          stencil(random, kPixels),
          bin{reinterpret_cast<std::byte*>(color.data()),
              reinterpret_cast<std::uint32_t*>(depth.data()),
              stencil.data(),
              farthest,
              kBinOrigin,
              kBinOrigin,
              &info,
              alike[0],
              alike[1],
              alike[2]} {
        for (int i = 0; i < kPixels; ++i) bin.depth[i] &= (1u << state.depth_bits) - 1;
        if (state.key.color_format == ColorFormat::kRgba32F) {
            auto* const floats = reinterpret_cast<float*>(color.data());
            for (int i = 0; i < kPixels * 4; ++i) floats[i] = random.between(0, 1);
        }
        for (auto& plane : alike)
            for (std::uint8_t& mark : plane) mark = random.coin();
        forget();
    }
    SampledBin(const SampledBin&) = delete;

    void forget() {
        std::fill_n(farthest, kBinTiles, info.farthest = std::numeric_limits<float>::infinity());
    }
    // Gives all samples pixels of their own.
    void spread(ColorFormat format) {
        for (int tile = 0; tile < kBinTiles; ++tile) {
            spread_tile(bin.color, tile, static_cast<std::size_t>(bytes_per_pixel(format)), alike[0]);
            spread_tile(bin.depth, tile, 4, alike[1]);
            spread_tile(bin.stencil, tile, 1, alike[2]);
        }
    }
    bool guards_hold() const { return color.guards_hold() && depth.guards_hold() && stencil.guards_hold(); }

    static constexpr int kPixels = kBinPixels * kMaxSamples;
    GuardedPlane color, depth, stencil;
    std::uint8_t alike[3][kBinTiles];
    alignas(64) float farthest[kBinTiles];
    BinState info;
    Bin bin;
};

// What counts of two planes is the same: of tiles that are alike the first sample.
bool same_plane(GuardedPlane& a, const std::uint8_t* a_alike, GuardedPlane& b, const std::uint8_t* b_alike) {
    const std::size_t bytes = a.size() / SampledBin::kPixels * kTilePixels;
    for (std::size_t tile = 0; tile < kBinTiles; ++tile) {
        for (std::size_t s = 0; s < kMaxSamples; ++s) {
            const auto of = [&](GuardedPlane& plane, const std::uint8_t* alike) {
                return plane.data() + ((alike[tile] ? 0 : s) * kBinTiles + tile) * bytes;
            };
            if (std::memcmp(of(a, a_alike), of(b, b_alike), bytes) != 0) return false;
        }
    }
    return true;
}

bool same_samples(SampledBin& a, SampledBin& b) {
    return same_plane(a.color, a.alike[0], b.color, b.alike[0]) &&
           same_plane(a.depth, a.alike[1], b.depth, b.alike[1]) &&
           same_plane(a.stencil, a.alike[2], b.stencil, b.alike[2]);
}

void make_multisampled(Scene& scene) {
    Random& random = scene.random;
    FragmentKey& key = scene.state.key;
    scene.state.multisample = !random.once_in(4);
    if (scene.state.multisample) {
        if (random.once_in(4)) key.sample_mask = static_cast<std::uint8_t>(random.below(16));
        key.alpha_to_coverage = random.once_in(4);
        key.alpha_to_one = random.once_in(4);
    }
    Primitive& p = scene.primitive();
    for (int e = 0; scene.state.multisample && e < p.edge_count; ++e)
        p.edges[e].c = p.edges[e].c * 256 + random.below(256);
    // Rectangles without edges are of one depth.
    if (p.edge_count == 0 || random.once_in(4)) p.planes()[p.plane_count] = p.planes()[2 * p.plane_count] = 0;
}

void draw_samples(SampledBin& to, Scene& scene, const KernelTable& table) {
    choose(scene, table);
    const auto batch = std::make_unique_for_overwrite<Batch>();
    batch->count = 0;
    table.draw_multisampled(scene.primitive(), to.bin, *batch);
    table.flush(to.bin, *batch);
}

TEST_P(AgainstScalar, DrawTheSamplesThatScalarDraws) {
    int touched = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        Scene scene(seed);
        make_multisampled(scene);
        SampledBin expected(Random(7), scene.state), found(Random(7), scene.state),
            untouched(Random(7), scene.state);
        draw_samples(expected, scene, *compiled_kernels().back());
        draw_samples(found, scene, *GetParam());
        ASSERT_TRUE(found.guards_hold()) << "seed " << seed;
        ASSERT_TRUE(same_samples(expected, found)) << "seed " << seed;
        ASSERT_EQ(std::memcmp(expected.alike, found.alike, sizeof found.alike), 0) << "seed " << seed;
        touched += !same_samples(found, untouched);
    }
    EXPECT_GT(touched, 80);
}

// What tiles are marked as must not show.
TEST_P(PixelKernels, DrawAlikeTilesLikeOthers) {
    int made_alike = 0;
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
        Scene scene(seed);
        make_multisampled(scene);
        SampledBin marked(Random(7), scene.state), spread(Random(7), scene.state);
        spread.spread(scene.state.key.color_format);
        draw_samples(marked, scene, *GetParam());
        draw_samples(spread, scene, *GetParam());
        made_alike += static_cast<int>(std::count(spread.alike[0], spread.alike[1], 1));
        ASSERT_TRUE(same_samples(marked, spread)) << "seed " << seed;
    }
    EXPECT_GT(made_alike, 300);
}

TEST_P(PixelKernels, SkipOnlySamplesThatAreHidden) {
    std::uint32_t hidden = 0;
    for (std::uint64_t pile = 0; pile < 4; ++pile) {
        Scene first(pile);
        first.state.key = {};
        first.state.depth_bits = pile % 4 == 0 ? 16 : 24;
        SampledBin remembering(Random(7), first.state), forgetful(Random(7), first.state);
        for (std::uint64_t seed = 0; seed < 150; ++seed) {
            Scene scene(1000 * pile + seed);
            scene.flatten_to(first.state.depth_bits);
            make_multisampled(scene);
            draw_samples(remembering, scene, *GetParam());
            forgetful.forget();
            draw_samples(forgetful, scene, *GetParam());
            ASSERT_TRUE(same_samples(remembering, forgetful)) << "pile " << pile << ", " << seed;
        }
        hidden += remembering.info.hidden;
    }
    EXPECT_GT(hidden, 20u);
}

TEST_P(AgainstScalar, ResolveAsScalarDoes) {
    const FragmentState state;
    SampledBin bin(Random(11), state);
    alignas(64) std::uint32_t expected[kBinPixels], found[kBinPixels];
    const auto* const samples = reinterpret_cast<const std::uint32_t*>(bin.color.data());
    compiled_kernels().back()->planes.resolve_rgba8(samples, bin.alike[0], kBinTiles, expected);
    GetParam()->planes.resolve_rgba8(samples, bin.alike[0], kBinTiles, found);
    EXPECT_EQ(std::memcmp(expected, found, sizeof found), 0);
    for (int i = 0; i < kBinPixels; ++i) {
        if (bin.alike[0][i / kTilePixels]) {
            ASSERT_EQ(found[i], samples[i]);
            continue;
        }
        for (int shift = 0; shift < 32; shift += 8) {
            std::uint32_t sum = 0;
            for (int s = 0; s < kMaxSamples; ++s) sum += samples[s * kBinPixels + i] >> shift & 255;
            ASSERT_NEAR(static_cast<double>(found[i] >> shift & 255), sum / 4.0, 0.5);
        }
    }
}

TEST_P(PixelKernels, FillWhatTheyAreTold) {
    Random random(1);
    for (std::size_t count = 16; count <= 4096; count *= 4) {
        GuardedPlane plane(random, count * 4);
        auto* const words = reinterpret_cast<std::uint32_t*>(plane.data());
        GetParam()->planes.fill(words, 0x89abcdef, count);
        EXPECT_EQ(std::count(words, words + count, 0x89abcdefu), static_cast<std::ptrdiff_t>(count));
        EXPECT_TRUE(plane.guards_hold());
    }
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, AgainstScalar,
                         testing::ValuesIn(compiled_kernels().begin(), compiled_kernels().end() - 1),
                         [](const auto& info) { return simd::isa_name(info.param->isa); });
INSTANTIATE_TEST_SUITE_P(InstructionSets, PixelKernels,
                         testing::ValuesIn(compiled_kernels().begin(), compiled_kernels().end()),
                         [](const auto& info) { return simd::isa_name(info.param->isa); });

}  // namespace
}  // namespace terrazzo::raster
