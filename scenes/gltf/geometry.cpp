// Attributes, then morph targets, then the skin, then flat normals where the file has none (glTF 2.0 §3.7).
#include "geometry.h"

#include <algorithm>
#include <cmath>

namespace terrazzo::gltf {
namespace {

using Attributes = std::map<std::string, int>;

int find(const Attributes& attributes, const std::string& name) {
    const auto found = attributes.find(name);
    return found == attributes.end() ? -1 : found->second;
}

// What one primitive's attributes are read with.
struct Reader {
    const tinygltf::Primitive& primitive;
    const Bending& bending;
    const Accessors& accessors;
    Notes& notes;

    // Base values and what the morph targets add to them; the targets have the base's type.
    std::vector<float> morphed(const std::string& name, int components) const {
        const auto read = [&](int accessor) {
            return name.rfind("COLOR_", 0) == 0 ? accessors.colours(accessor)
                                                : accessors.floats(accessor, components);
        };
        std::vector<float> values = read(find(primitive.attributes, name));
        const std::size_t targets = std::min(primitive.targets.size(), bending.weights.size());
        for (std::size_t target = 0; target < targets; ++target) {
            const int accessor = find(primitive.targets[target], name);
            const auto weight = static_cast<float>(bending.weights[target]);
            if (accessor < 0 || weight == 0) continue;
            const std::vector<float> shifts = read(accessor);
            if (shifts.size() != values.size()) refuse("a morph target of another length");
            for (std::size_t i = 0; i < values.size(); ++i) values[i] += weight * shifts[i];
        }
        for (const float value : values)
            if (!std::isfinite(value)) refuse("a value is not finite");
        return values;
    }

    std::vector<float> optional(const std::string& name, int components, std::size_t vertices) const {
        if (find(primitive.attributes, name) < 0) return {};
        try {
            std::vector<float> values = morphed(name, components);
            if (values.size() != vertices * static_cast<std::size_t>(components))
                refuse("it has another length than POSITION");
            return values;
        } catch (const std::runtime_error& failure) {
            notes.add("an attribute " + name + " is ignored: " + failure.what());
            return {};
        }
    }

    std::vector<float> coordinates(int set, std::size_t vertices) const {
        if (set < 0) return {};
        const std::string name = "TEXCOORD_" + std::to_string(set);
        if (find(primitive.attributes, name) < 0) notes.add("a textured primitive has no " + name);
        return optional(name, 2, vertices);
    }
};

std::vector<std::uint32_t> indices_of(const Reader& reader, std::size_t vertices) {
    std::vector<std::uint32_t> indices;
    if (reader.primitive.indices >= 0) {
        indices = reader.accessors.integers(reader.primitive.indices, 1);
    } else {
        for (std::size_t i = 0; i < vertices; ++i) indices.push_back(static_cast<std::uint32_t>(i));
    }
    for (const std::uint32_t index : indices)
        if (index >= vertices) refuse("an index is beyond the vertices");
    return indices;
}

// --- skins: glTF 2.0 §3.7.3 ---

struct Influences {
    std::vector<std::uint32_t> joints;  // 4 a vertex and set
    std::vector<float> weights;
};

std::vector<Influences> influences_of(const Reader& reader, std::size_t vertices) {
    std::vector<Influences> sets;
    for (int set = 0; find(reader.primitive.attributes, "JOINTS_" + std::to_string(set)) >= 0; ++set) {
        const std::string number = std::to_string(set);
        Influences influences{
            reader.accessors.integers(find(reader.primitive.attributes, "JOINTS_" + number), 4),
            reader.accessors.floats(find(reader.primitive.attributes, "WEIGHTS_" + number), 4)};
        if (influences.joints.size() != vertices * 4 || influences.weights.size() != vertices * 4)
            refuse("its joints and weights are fewer or more than its vertices");
        for (const std::uint32_t joint : influences.joints)
            if (joint >= reader.bending.joints.size()) refuse("a joint is beyond those of the skin");
        sets.push_back(std::move(influences));
    }
    return sets;
}

Matrix blend(const std::vector<Influences>& sets, const std::vector<Matrix>& joints, std::size_t vertex) {
    Matrix sum{};
    double total = 0;
    for (const Influences& set : sets)
        for (std::size_t k = vertex * 4; k < vertex * 4 + 4; ++k) {
            const double weight = set.weights[k];
            if (weight == 0) continue;
            total += weight;
            for (std::size_t i = 0; i < 16; ++i) sum[i] += weight * joints[set.joints[k]][i];
        }
    // Weights ought to sum to 1; without any, a vertex goes with the first joint.
    if (!(std::abs(total) > 1e-6)) return joints.front();
    for (double& value : sum) value /= total;
    return sum;
}

void apply_skin(const Reader& reader, Geometry& geometry) {
    const std::size_t vertices = geometry.positions.size() / 3;
    const std::vector<Influences> sets = influences_of(reader, vertices);
    if (sets.empty()) refuse("it has a skin, but no joints");
    for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
        const Matrix m = blend(sets, reader.bending.joints, vertex);
        float* p = &geometry.positions[vertex * 3];
        const double x = p[0], y = p[1], z = p[2];
        for (std::size_t row = 0; row < 3; ++row) {
            p[row] = static_cast<float>(m[row] * x + m[4 + row] * y + m[8 + row] * z + m[12 + row]);
            if (!std::isfinite(p[row])) refuse("its skin moves a vertex out of all numbers");
        }
        if (geometry.normals.empty()) continue;
        const std::array<double, 9> c = cofactors(m);
        const double side = determinant(m) < 0 ? -1 : 1;
        float* n = &geometry.normals[vertex * 3];
        const double nx = n[0], ny = n[1], nz = n[2];
        double turned[3], length = 0;
        for (std::size_t row = 0; row < 3; ++row) {
            turned[row] = side * (c[row] * nx + c[3 + row] * ny + c[6 + row] * nz);
            length += turned[row] * turned[row];
        }
        for (std::size_t row = 0; row < 3; ++row)
            n[row] =
                length > 0 && std::isfinite(length) ? static_cast<float>(turned[row] / std::sqrt(length)) : 0;
    }
}

// --- flat normals ---

template <std::size_t Size>
std::vector<float> unindexed(const std::vector<float>& values, const std::vector<std::uint32_t>& indices) {
    std::vector<float> result;
    if (values.empty()) return result;
    result.reserve(indices.size() * Size);
    for (const std::uint32_t index : indices)
        result.insert(result.end(), values.begin() + static_cast<std::ptrdiff_t>(std::size_t{index} * Size),
                      values.begin() + static_cast<std::ptrdiff_t>(std::size_t{index} * Size + Size));
    return result;
}

// glTF 2.0 §3.7.2.1: each triangle's winding is that of its strip or fan.
std::vector<std::uint32_t> triangles_of(int mode, const std::vector<std::uint32_t>& v) {
    if (mode == GL_TRIANGLES) return {v.begin(), v.end() - static_cast<std::ptrdiff_t>(v.size() % 3)};
    std::vector<std::uint32_t> triangles;
    for (std::size_t i = 0; i + 2 < v.size(); ++i) {
        if (mode == GL_TRIANGLE_FAN) {
            triangles.insert(triangles.end(), {v[0], v[i + 1], v[i + 2]});
        } else {
            triangles.insert(triangles.end(), {v[i], v[i + 1 + i % 2], v[i + 2 - i % 2]});
        }
    }
    return triangles;
}

void include_factor(std::vector<float>& colours, const Material& material) {
    for (std::size_t i = 0; i < colours.size(); ++i) colours[i] *= material.diffuse[i % 4];
}

}  // namespace

void add_flat_normals(Geometry& geometry) {
    geometry.indices = triangles_of(geometry.mode, geometry.indices);
    geometry.mode = GL_TRIANGLES;
    geometry.positions = unindexed<3>(geometry.positions, geometry.indices);
    geometry.base_coordinates = unindexed<2>(geometry.base_coordinates, geometry.indices);
    geometry.emissive_coordinates = unindexed<2>(geometry.emissive_coordinates, geometry.indices);
    geometry.colours = unindexed<4>(geometry.colours, geometry.indices);
    for (std::size_t i = 0; i < geometry.indices.size(); ++i)
        geometry.indices[i] = static_cast<std::uint32_t>(i);
    geometry.normals.assign(geometry.positions.size(), 0);
    for (std::size_t i = 0; i + 9 <= geometry.positions.size(); i += 9) {
        const float* p = &geometry.positions[i];
        const double a[] = {double{p[3]} - p[0], double{p[4]} - p[1], double{p[5]} - p[2]};
        const double b[] = {double{p[6]} - p[0], double{p[7]} - p[1], double{p[8]} - p[2]};
        const double n[] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
        const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (std::size_t k = 0; k < 9; ++k)
            geometry.normals[i + k] = length > 0 ? static_cast<float>(n[k % 3] / length) : 0;
    }
}

Geometry make_geometry(const tinygltf::Primitive& primitive, const Surface& surface, const Bending& bending,
                       const Accessors& accessors, Budget& vertices, Notes& notes) {
    const Reader reader{primitive, bending, accessors, notes};
    Geometry geometry;
    geometry.mode = primitive.mode;  // glTF's modes are OpenGL's
    if (geometry.mode > GL_TRIANGLE_FAN) refuse("it has an unknown mode");
    geometry.positions = reader.morphed("POSITION", 3);
    const std::size_t count = geometry.positions.size() / 3;
    geometry.indices = indices_of(reader, count);
    // Flat normals make of every index a vertex, and of a strip's or fan's every index a triangle.
    vertices.spend(std::max(count, geometry.indices.size() * (geometry.mode > GL_TRIANGLES ? 3 : 1)));
    geometry.normals = reader.optional("NORMAL", 3, count);
    geometry.colours = reader.optional("COLOR_0", 4, count);
    include_factor(geometry.colours, surface.material);
    geometry.base_coordinates = reader.coordinates(surface.base_set, count);
    geometry.emissive_coordinates = reader.coordinates(surface.emissive_set, count);
    if (!bending.joints.empty()) apply_skin(reader, geometry);
    if (geometry.normals.empty() && geometry.mode >= GL_TRIANGLES && !surface.material.unlit)
        add_flat_normals(geometry);
    if (geometry.indices.empty()) refuse("it has too few vertices");
    return geometry;
}

}  // namespace terrazzo::gltf
