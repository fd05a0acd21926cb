// The Utah teapot: Newell's 32 bicubic Bezier patches (with the bottom that was added later), tessellated to
// 8x8 quads each = 4096 triangles. Most of the pot is a surface of revolution, so its data are written as
// profiles; the handle and the spout are tubes, symmetric in depth. Output: y up, x along the spout, texture
// 0..1 over each patch.
#include <array>

#include "shapes.h"

namespace terrazzo::study {
namespace {

constexpr int kQuadsPerEdge = 8;
// Newell's control points of a quarter circle put the tangent's end at 0.56 of the radius.
constexpr float kQuarterCircle = 0.56F;

struct Point {
    float x, y, z;
};
using Patch = std::array<std::array<Point, 4>, 4>;  // [row along the profile][column round the axis or tube]

struct ProfilePoint {
    float radius, height;
};
using Profile = std::array<ProfilePoint, 4>;

constexpr Profile kRevolved[] = {
    {{{1.4F, 2.4F}, {1.3375F, 2.53125F}, {1.4375F, 2.53125F}, {1.5F, 2.4F}}},  // rim
    {{{1.5F, 2.4F}, {1.75F, 1.875F}, {2, 1.35F}, {2, 0.9F}}},                  // upper body
    {{{2, 0.9F}, {2, 0.45F}, {1.5F, 0.225F}, {1.5F, 0.15F}}},                  // lower body
    {{{0, 3.15F}, {0.8F, 3.15F}, {0, 2.85F}, {0.2F, 2.7F}}},                   // knob
    {{{0.2F, 2.7F}, {0.4F, 2.55F}, {1.3F, 2.55F}, {1.3F, 2.4F}}},              // lid
    {{{1.5F, 0.15F}, {1.5F, 0.075F}, {1.425F, 0}, {0, 0}}},                    // bottom
};

// One ring of a tube: its end points in the plane of symmetry and its half width across that plane.
struct TubeRing {
    float first_x, first_height, second_x, second_height, half_width;
};
using Tube = std::array<TubeRing, 4>;

constexpr Tube kTubes[] = {
    // handle
    {{{-1.6F, 2.025F, -1.5F, 2.25F, 0.3F},
      {-2.3F, 2.025F, -2.5F, 2.25F, 0.3F},
      {-2.7F, 2.025F, -3, 2.25F, 0.3F},
      {-2.7F, 1.8F, -3, 1.8F, 0.3F}}},
    {{{-2.7F, 1.8F, -3, 1.8F, 0.3F},
      {-2.7F, 1.575F, -3, 1.35F, 0.3F},
      {-2.5F, 1.125F, -2.65F, 0.9375F, 0.3F},
      {-2, 0.9F, -1.9F, 0.6F, 0.3F}}},
    // spout
    {{{1.7F, 1.425F, 1.7F, 0.6F, 0.66F},
      {2.6F, 1.425F, 3.1F, 0.825F, 0.66F},
      {2.3F, 2.1F, 2.4F, 2.025F, 0.25F},
      {2.7F, 2.4F, 3.3F, 2.4F, 0.25F}}},
    {{{2.7F, 2.4F, 3.3F, 2.4F, 0.25F},
      {2.8F, 2.475F, 3.525F, 2.49375F, 0.25F},
      {2.9F, 2.475F, 3.45F, 2.5125F, 0.15F},
      {2.8F, 2.4F, 3.2F, 2.4F, 0.15F}}},
};

// Quadrant 0..3, going from +x towards -z, so that rows that go down leave the outside counter-clockwise.
Patch revolve(const Profile& profile, int quadrant) {
    constexpr float kCosines[] = {1, 0, -1, 0};
    constexpr float kSines[] = {0, 1, 0, -1};
    const float c = kCosines[quadrant], s = kSines[quadrant];
    Patch patch;
    for (std::size_t row = 0; row < 4; ++row) {
        const float r = profile[row].radius, k = kQuarterCircle * r, y = profile[row].height;
        const float along[4] = {r, r, k, 0};
        const float across[4] = {0, k, r, r};
        for (std::size_t column = 0; column < 4; ++column)
            patch[row][column] = {c * along[column] - s * across[column], y,
                                  -(s * along[column] + c * across[column])};
    }
    return patch;
}

Patch half_tube(const Tube& tube, float side) {
    Patch patch;
    for (std::size_t row = 0; row < 4; ++row) {
        const TubeRing& ring = tube[row];
        const float z = side * ring.half_width;
        patch[row] = {{{ring.first_x, ring.first_height, 0},
                       {ring.first_x, ring.first_height, z},
                       {ring.second_x, ring.second_height, z},
                       {ring.second_x, ring.second_height, 0}}};
    }
    return patch;
}

std::array<float, 4> bernstein(float t) {
    const float s = 1 - t;
    return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

Vertex evaluate(const Patch& patch, float u, float v) {
    // Half of Newell's size makes the pot about 3 wide.
    constexpr float kScale = 0.5F;
    const std::array<float, 4> rows = bernstein(v), columns = bernstein(u);
    Vertex vertex{{0, 0, 0}, {u, v}};
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column) {
            const float weight = kScale * rows[row] * columns[column];
            vertex.position[0] += weight * patch[row][column].x;
            vertex.position[1] += weight * patch[row][column].y;
            vertex.position[2] += weight * patch[row][column].z;
        }
    return vertex;
}

void tessellate(const Patch& patch, bool flipped, Mesh& mesh) {
    constexpr std::uint32_t kRow = kQuadsPerEdge + 1;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int row = 0; row <= kQuadsPerEdge; ++row)
        for (int column = 0; column <= kQuadsPerEdge; ++column)
            mesh.vertices.push_back(evaluate(patch, static_cast<float>(column) / kQuadsPerEdge,
                                             static_cast<float>(row) / kQuadsPerEdge));
    for (std::uint32_t row = 0; row < kQuadsPerEdge; ++row)
        for (std::uint32_t column = 0; column < kQuadsPerEdge; ++column) {
            const std::uint32_t a = first + row * kRow + column, b = a + 1, c = a + kRow, d = c + 1;
            if (flipped)
                mesh.indices.insert(mesh.indices.end(), {a, b, d, a, d, c});
            else
                mesh.indices.insert(mesh.indices.end(), {a, c, d, a, d, b});
        }
}

}  // namespace

Mesh make_teapot() {
    Mesh mesh;
    for (const Profile& profile : kRevolved)
        for (int quadrant = 0; quadrant < 4; ++quadrant) tessellate(revolve(profile, quadrant), false, mesh);
    for (const Tube& tube : kTubes) {
        tessellate(half_tube(tube, 1), true, mesh);
        tessellate(half_tube(tube, -1), false, mesh);
    }
    return mesh;
}

}  // namespace terrazzo::study
