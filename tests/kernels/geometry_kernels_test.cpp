// Every instruction set's vertex program and triangle set-up against scalar's, on random state, vertices and
// triangles.
//
// Numbers must be equal bit by bit; where both are NaN their bits may differ, since which NaN an operation
// returns is the processor's choice.
#include <gtest/gtest.h>

#include <cstring>
#include <iterator>
#include <vector>

#include "pipeline/geometry/geometry_table.h"
#include "pipeline/schedule/float_environment.h"
#include "random.h"
#include "raster/kernel_table.h"

namespace terrazzo::pipeline {
namespace {

using stress::Random;

constexpr int kVertices = 203;

struct Draw {
    explicit Draw(std::uint64_t seed) : random(seed), data(kVertices * kStride) {
        const auto fill = [&](float* values, std::size_t count, float low, float high) {
            for (std::size_t i = 0; i < count; ++i) values[i] = random.between(low, high);
        };
        fill(data.data(), data.size(), -2, 2);
        for (int i = 0; i < 6; ++i)
            data[static_cast<std::size_t>(random.below(kVertices) * kStride + i)] = i % 2 ? 1e30f : 0.0f;
        fill(state.mvp, 16, -1, 1);
        fill(state.modelview, 16, -1, 1);
        fill(state.normal_matrix, 9, -1, 1);
        fill(state.viewport_scale, 3, 10, 400);
        fill(state.viewport_translate, 3, 10, 400);
        state.clip_plane_mask = static_cast<std::uint32_t>(random.once_in(3) ? random.below(64) : 0);
        fill(state.clip_planes[0], 4 * kMaxClipPlanes, -1, 1);
        state.normal_scaling = static_cast<NormalScaling>(random.below(3));
        state.rescale_factor = random.between(0.5f, 2);
        state.eye_space = random.coin();
        state.edge_flags = random.coin();
        make_lighting(fill);
        make_varyings(fill);
        make_input();
    }

    template <class Fill>
    void make_lighting(const Fill& fill) {
        Lighting& l = state.lighting;
        l.enabled = random.coin();
        l.two_sided = l.enabled && random.coin();
        l.local_viewer = random.coin();
        l.separate_specular = random.coin();
        l.light_count = random.below(4);
        fill(l.model_ambient, std::size(l.model_ambient), 0, 1);
        for (Light& light : l.lights) make_light(fill, light);
        for (Material& material : l.materials) {
            fill(material.ambient, std::size(material.ambient), 0, 1);
            fill(material.diffuse, std::size(material.diffuse), 0, 1);
            fill(material.specular, std::size(material.specular), 0, 1);
            fill(material.emission, std::size(material.emission), 0, 1);
            fill(material.scene_color, std::size(material.scene_color), 0, 1);
            material.shininess = random.between(0, 128);
        }
        for (ColorMaterial& color : l.color_material)
            color = {random.once_in(4), random.once_in(4), random.once_in(4), random.once_in(4)};
    }

    template <class Fill>
    void make_light(const Fill& fill, Light& light) {
        light.positional = random.coin();
        light.spot = random.coin();
        light.attenuated = light.positional && random.coin();
        fill(light.position, std::size(light.position), -3, 3);
        fill(light.half_vector, std::size(light.half_vector), -1, 1);
        fill(light.direction, std::size(light.direction), -1, 1);
        fill(light.attenuation, std::size(light.attenuation), 0.1f, 1);
        light.spot_exponent = random.between(0, 60);
        light.spot_cos_cutoff = random.between(0, 1);
        fill(light.ambient, std::size(light.ambient), 0, 1);
        fill(light.diffuse, std::size(light.diffuse), 0, 1);
        fill(light.specular, std::size(light.specular), 0, 1);
        for (LitMaterial& lit : light.lit) {
            fill(lit.ambient, std::size(lit.ambient), 0, 1);
            fill(lit.diffuse, std::size(lit.diffuse), 0, 1);
            fill(lit.specular, std::size(lit.specular), 0, 1);
        }
    }

    template <class Fill>
    void make_varyings(const Fill& fill) {
        raster::Varyings& v = state.varyings;
        v.color = 0;
        v.count = 4;
        if (random.coin())
            v.secondary = static_cast<std::int8_t>(v.count), v.count = static_cast<std::uint8_t>(v.count + 3);
        if (random.coin())
            v.fog = static_cast<std::int8_t>(v.count), v.count = static_cast<std::uint8_t>(v.count + 1);
        TextureCoordinates& unit = state.texture[0];
        unit.used = random.coin();
        if (!unit.used) return;
        v.texture[0] = static_cast<std::int8_t>(v.count);
        v.count = static_cast<std::uint8_t>(v.count + 4);
        v.projective = v.uses_r = 1;
        unit.has_matrix = random.coin();
        fill(unit.matrix, 16, -1, 1);
        fill(unit.planes[0], 16, -1, 1);
        for (TexgenMode& mode : unit.texgen) mode = static_cast<TexgenMode>(random.below(6));
        if (unit.texgen[2] == TexgenMode::kSphereMap)
            unit.texgen[2] = TexgenMode::kOff;  // it has two coordinates
        if (unit.texgen[3] >= TexgenMode::kSphereMap) unit.texgen[3] = TexgenMode::kOff;
    }

    void make_input() {
        const auto* const bytes = reinterpret_cast<const std::byte*>(data.data());
        const auto stream = [&](int attribute, std::size_t first, ComponentType type, std::uint8_t components,
                                bool normalized) {
            input.streamed |= bit(attribute);
            input.streams[static_cast<std::size_t>(attribute)] = {
                bytes + first * sizeof(float), kStride * sizeof(float), type, components, normalized};
        };
        for (auto& constant : input.constants)
            for (float& c : constant) c = random.between(-1, 1);
        stream(kPosition, 0, ComponentType::kFloat32, static_cast<std::uint8_t>(2 + random.below(3)), false);
        if (random.coin())
            stream(kColor, 4, random.coin() ? ComponentType::kUint8 : ComponentType::kInt16, 4, true);
        if (random.coin()) stream(kNormal, 6, ComponentType::kFloat32, 3, false);
        if (random.coin()) stream(kTexture0, 9, ComponentType::kFloat32, 2, false);
        if (random.coin())
            for (std::uint32_t& e : elements.emplace_back(kVertices))
                e = static_cast<std::uint32_t>(random.below(kVertices));
    }
    const std::uint32_t* element_list() const { return elements.empty() ? nullptr : elements.front().data(); }

    int columns() const { return kFirstVarying + state.varyings.count * (state.lighting.two_sided ? 2 : 1); }

    static constexpr std::size_t kStride = 12;
    Random random;
    VertexState state;
    VertexInput input;
    std::vector<float> data;
    std::vector<std::vector<std::uint32_t>> elements;
};

bool same(float a, float b) {
    return std::memcmp(&a, &b, sizeof a) == 0 || (a != a && b != b);
}

// Primitives in the order set-up made them.
struct Sink : PrimitiveSink {
    Sink() {
        allocate = [](PrimitiveSink& sink, int plane_count) {
            auto& memory = static_cast<Sink&>(sink).memory;
            memory.emplace_back(raster::Primitive::size_of(plane_count) / sizeof(std::max_align_t) + 1);
            return reinterpret_cast<raster::Primitive*>(memory.back().data());
        };
        commit = [](PrimitiveSink& sink, raster::Primitive&) { ++static_cast<Sink&>(sink).committed; };
    }
    const raster::Primitive& operator[](std::size_t i) const {
        return *reinterpret_cast<const raster::Primitive*>(memory[i].data());
    }
    std::vector<std::vector<std::max_align_t>> memory;
    std::size_t committed = 0;
};

void expect_same(const Sink& expected, const Sink& found) {
    ASSERT_EQ(expected.committed, found.committed);
    for (std::size_t i = 0; i < expected.committed; ++i) {
        const raster::Primitive &a = expected[i], &b = found[i];
        ASSERT_EQ(std::tie(a.x0, a.y0, a.x1, a.y1, a.back_facing, a.plane_count),
                  std::tie(b.x0, b.y0, b.x1, b.y1, b.back_facing, b.plane_count));
        ASSERT_TRUE(same(a.depth_offset, b.depth_offset));
        for (int e = 0; e < a.edge_count; ++e)
            ASSERT_EQ(std::tie(a.edges[e].c, a.edges[e].step_x, a.edges[e].step_y),
                      std::tie(b.edges[e].c, b.edges[e].step_x, b.edges[e].step_y));
        for (int p = 0; p < 3 * a.plane_count; ++p)
            ASSERT_TRUE(same(a.a0()[p], b.a0()[p])) << "plane value " << p;
    }
}

class GeometryKernels : public testing::TestWithParam<simd::Isa> {
    const FloatEnvironment m_environment;  // as the renderer has it: ARMv7's vectors know no denormals

  protected:
    const GeometryTable& table = geometry_of(GetParam());
    const GeometryTable& scalar = geometry_of(simd::Isa::kScalar);
};

TEST_P(GeometryKernels, ShadeWhatScalarShades) {
    ShadedVertices expected, found;
    for (std::uint64_t seed = 0; seed < 1500; ++seed) {
        const Draw draw(seed);
        expected.reserve(draw.columns());
        found.reserve(draw.columns());
        scalar.shade_vertices(draw.state, draw.input, draw.element_list(), 0, kVertices, expected);
        table.shade_vertices(draw.state, draw.input, draw.element_list(), 0, kVertices, found);
        for (int column = 0; column < draw.columns(); ++column) {
            if (column == kEdgeFlagColumn && !draw.state.edge_flags) continue;
            // Of the back side there are colours alone.
            const int back = column - kFirstVarying - draw.state.varyings.count;
            if (back >= 0 && !draw.state.varyings.is_color(back)) continue;
            for (int i = 0; i < kVertices; ++i)
                ASSERT_TRUE(same(expected.column(column)[i], found.column(column)[i]))
                    << "seed " << seed << " column " << column << " vertex " << i << ": "
                    << expected.column(column)[i] << " and " << found.column(column)[i];
        }
    }
}

TEST_P(GeometryKernels, SetUpWhatScalarSetsUp) {
    std::size_t made = 0;
    for (std::uint64_t seed = 0; seed < 1500; ++seed) {
        Draw draw(seed);
        Random& random = draw.random;
        ShadedVertices vertices;
        vertices.reserve(draw.columns());
        scalar.shade_vertices(draw.state, draw.input, nullptr, 0, kVertices, vertices);
        raster::FragmentState fragment;
        fragment.varyings = draw.state.varyings;
        fragment.key.perspective = random.coin();
        TriangleSetup setup;
        setup.state = &fragment;
        setup.x1 = 1 + random.below(500), setup.y1 = 1 + random.below(500);
        setup.cull_front = random.once_in(4), setup.cull_back = random.once_in(4);
        setup.cull_unsnapped = random.coin();
        setup.front_is_clockwise = random.coin();
        setup.row0_is_top = random.coin();
        setup.flat = random.once_in(3);
        setup.two_sided = draw.state.lighting.two_sided;
        setup.offset = random.coin();
        setup.offset_factor = random.between(-2, 2), setup.offset_units = random.between(-1, 1);
        TriangleBatch batch;
        batch.count = 1 + random.below(16);
        for (int i = 0; i < 16; ++i)
            for (std::int32_t* const corner : {&batch.v0[i], &batch.v1[i], &batch.v2[i]})
                *corner = random.below(kVertices);
        Sink expected, found;
        scalar.setup_triangles(setup, vertices, batch, expected);
        table.setup_triangles(setup, vertices, batch, found);
        SCOPED_TRACE(seed);
        expect_same(expected, found);
        if (HasFatalFailure()) return;
        made += expected.committed;
    }
    EXPECT_GT(made, 2000u);
}

std::vector<simd::Isa> runnable() {
    std::vector<simd::Isa> isas;
    for (const raster::KernelTable* table : raster::compiled_kernels()) isas.push_back(table->isa);
    return isas;
}
INSTANTIATE_TEST_SUITE_P(InstructionSets, GeometryKernels, testing::ValuesIn(runnable()),
                         [](const auto& info) { return simd::isa_name(info.param); });

}  // namespace
}  // namespace terrazzo::pipeline
