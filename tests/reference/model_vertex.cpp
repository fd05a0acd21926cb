// Viewport, transformation and clipping of the model; see model.h and doc/reference.md §1-3.

#include <algorithm>
#include <cmath>

#include "model.h"

namespace terrazzo::test::model {

namespace {

constexpr int kPlanes = 6;
constexpr Float4 kFrustum[kPlanes] = {{-1, 0, 0, 1}, {1, 0, 0, 1}, {0, -1, 0, 1},
                                      {0, 1, 0, 1},  {0, 0, 1, 1}, {0, 0, -1, 1}};

// NaN is outside everything.
unsigned outcode(const Vertex& vertex) {
    const auto& [x, y, z, w] = vertex.clip;
    return unsigned(!(x <= w)) | unsigned(!(x + w >= 0)) << 1 | unsigned(!(y <= w)) << 2 |
           unsigned(!(y + w >= 0)) << 3 | unsigned(!(z + w >= 0)) << 4 | unsigned(!(z <= w)) << 5;
}

float distance(const Vertex& vertex, int plane) {
    const Float4 &v = vertex.clip, &p = kFrustum[plane];
    return v[0] * p[0] + v[1] * p[1] + v[2] * p[2] + v[3] * p[3];
}

// A new vertex; its window position is not fused, unlike project()'s.
Vertex between(const Vertex& from, const Vertex& to, float t, const Viewport& viewport) {
    Vertex v;
    for (int i = 0; i < 4; ++i) {
        v.clip[i] = from.clip[i] + t * (to.clip[i] - from.clip[i]);
        v.colour[i] = from.colour[i] + t * (to.colour[i] - from.colour[i]);
    }
    const float oow = 1.0f / v.clip[3];
    for (int i = 0; i < 3; ++i) v.window[i] = v.clip[i] * oow * viewport.scale[i] + viewport.translate[i];
    v.window[3] = oow;
    return v;
}

// Interpolates from the end that is nearer to the plane.
Vertex crossing(const Vertex& previous, const Vertex& next, float d_previous, float d_next,
                const Viewport& viewport) {
    const float span = d_next - d_previous;
    const bool previous_nearer = d_next < 0 ? !(-d_next < d_previous) : -d_previous < d_next;
    return previous_nearer ? between(previous, next, -d_previous / span, viewport)
                           : between(next, previous, d_next / span, viewport);
}

std::vector<Vertex> clip_polygon(const std::vector<Vertex>& polygon, int plane, const Viewport& viewport) {
    std::vector<Vertex> result;
    Vertex previous = polygon[0];
    float d_previous = distance(previous, plane);
    for (std::size_t i = 1; i <= polygon.size(); ++i) {
        const Vertex& next = polygon[i % polygon.size()];
        const float d_next = distance(next, plane);
        if (!std::isfinite(d_previous) || !std::isfinite(d_next)) return {};
        if (d_previous >= 0) result.push_back(previous);
        if ((d_previous >= 0) != (d_next >= 0))
            result.push_back(crossing(previous, next, d_previous, d_next, viewport));
        previous = next;
        d_previous = d_next;
    }
    return result;
}

}  // namespace

Viewport make_viewport(int x, int y, int width, int height, double near, double far, int surface_height) {
    const float half_width = 0.5f * static_cast<float>(width);
    const float half_height = 0.5f * static_cast<float>(height);
    const float translate_y = half_height + static_cast<float>(y);
    return {{half_width, -half_height, static_cast<float>(0.5 * (far - near))},
            {half_width + static_cast<float>(x), static_cast<float>(surface_height) - translate_y,
             static_cast<float>(0.5 * (near + far))}};
}

Float4 transform(const float matrix[16], const Float4& p) {
    Float4 result;
    for (int r = 0; r < 4; ++r)
        result[r] = matrix[r] * p[0] + matrix[4 + r] * p[1] + matrix[8 + r] * p[2] + matrix[12 + r] * p[3];
    return result;
}

void project(Vertex& vertex, const Viewport& viewport) {
    const float oow = 1.0f / vertex.clip[3];
    for (int i = 0; i < 3; ++i)
        vertex.window[i] = std::fma(vertex.clip[i] * oow, viewport.scale[i], viewport.translate[i]);
    vertex.window[3] = oow;
}

std::vector<std::array<Vertex, 3>> clip_triangle(const std::array<Vertex, 3>& triangle,
                                                 const Viewport& viewport) {
    const unsigned codes[3] = {outcode(triangle[0]), outcode(triangle[1]), outcode(triangle[2])};
    if (codes[0] & codes[1] & codes[2]) return {};
    std::vector<Vertex> polygon(triangle.begin(), triangle.end());
    for (int plane = 0; plane < kPlanes && polygon.size() >= 3; ++plane)
        if ((codes[0] | codes[1] | codes[2]) >> plane & 1) polygon = clip_polygon(polygon, plane, viewport);

    std::vector<std::array<Vertex, 3>> fan;
    if (polygon.size() == 3 && !(codes[0] | codes[1] | codes[2])) return {triangle};
    for (std::size_t i = 2; i < polygon.size(); ++i) fan.push_back({polygon[i - 1], polygon[i], polygon[0]});
    return fan;
}

bool clip_line(Vertex& a, Vertex& b, const Viewport& viewport) {
    const unsigned code_a = outcode(a), code_b = outcode(b);
    if (code_a & code_b) return false;
    float ta = 0, tb = 0;
    for (int plane = 0; plane < kPlanes; ++plane) {
        if (!((code_a | code_b) >> plane & 1)) continue;
        const float da = distance(a, plane), db = distance(b, plane);
        if (!std::isfinite(da) || !std::isfinite(db)) return false;
        if (db < 0) tb = std::max(tb, db / (db - da));
        if (da < 0) ta = std::max(ta, da / (da - db));
        if (ta + tb >= 1) return false;
    }
    const Vertex old_a = a, old_b = b;
    if (code_a) a = between(old_a, old_b, ta, viewport);
    if (code_b) b = between(old_b, old_a, tb, viewport);
    return true;
}

bool point_visible(const Vertex& point) {
    return outcode(point) == 0;
}

}  // namespace terrazzo::test::model
