// Set-up, coverage and interpolation of the model; see model.h and doc/reference.md §3-4.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "model.h"

namespace terrazzo::test::model {

namespace {

struct Fixed {
    std::int64_t x, y;  // 8 sub-pixel bits
};

// a + dadx * x + dady * y over the driver's pixels.
struct Plane {
    float origin, dadx, dady;

    float at(int x, int y) const {
        return std::fma(dady, static_cast<float>(y), std::fma(dadx, static_cast<float>(x), origin));
    }
};

struct Planes {
    Plane z, w;
    Plane colour[4];  // over w
};

// The convex outline is covered where every edge function is positive; left and low edges belong to it.
template <std::size_t N>
void fill(Image& image, const std::array<Fixed, N>& corner, const Planes& planes, float depth_offset) {
    std::int64_t dcdx[N], dcdy[N], c[N];
    for (std::size_t i = 0; i < N; ++i) {
        const Fixed &from = corner[i], &to = corner[(i + 1) % N];
        dcdx[i] = from.y - to.y;
        dcdy[i] = from.x - to.x;
        c[i] = dcdx[i] * from.x - dcdy[i] * from.y + (dcdx[i] < 0 || (dcdx[i] == 0 && dcdy[i] < 0));
    }
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            bool inside = true;
            for (std::size_t i = 0; i < N; ++i) inside &= c[i] - dcdx[i] * 256 * x + dcdy[i] * 256 * y > 0;
            if (!inside) continue;
            Pixel& pixel = image.at(x, y);
            pixel.covered = true;
            const float w = 1.0f / planes.w.at(x, y);
            for (int i = 0; i < 4; ++i) pixel.colour[i] = planes.colour[i].at(x, y) * w;
            pixel.z = planes.z.at(x, y) + depth_offset;
        }
}

// Triangles snap halves to even ...
std::int64_t snap(float position) {
    return std::lrint((position - 0.5f) * 256.0f);
}

// ... lines and points away from zero, after a rounded sum.
int snap_away(float value) {
    const float scaled = 256.0f * value;
    return static_cast<int>(scaled >= 0.0f ? scaled + 0.5f : scaled - 0.5f);
}

struct TriangleGradients {
    float x01, y01, x20, y20;  // over the doubled area
    float centre_x, centre_y;

    Plane plane(float a0, float a1, float a2) const {
        const float a01 = a0 - a1, a20 = a2 - a0;
        const float dadx = a01 * y20 - a20 * y01;
        const float dady = a20 * x01 - a01 * x20;
        return {a0 - (dadx * centre_x + dady * centre_y), dadx, dady};
    }
};

float polygon_offset(const std::array<Vertex, 3>& v, float inverse_area, const PolygonOffset& offset) {
    const Float4 &p0 = v[0].window, &p1 = v[1].window, &p2 = v[2].window;
    const float x01 = p0[0] - p1[0], y01 = p0[1] - p1[1], z01 = p0[2] - p1[2];
    const float x20 = p2[0] - p0[0], y20 = p2[1] - p0[1], z20 = p2[2] - p0[2];
    const float dzdx = std::fabs((z20 * y01 - y20 * z01) * inverse_area);
    const float dzdy = std::fabs((x20 * z01 - z20 * x01) * inverse_area);
    const double step = 1.0 / ((1u << offset.depth_bits) - 1);
    return static_cast<float>(offset.units * step * 2) + (dzdx > dzdy ? dzdx : dzdy) * offset.factor;
}

float fraction(float a) {
    return a - std::floor(a);
}
bool positive(float a) {
    return a >= 0;
}

// The end of a line against the diamond of its pixel. Distances are from the pixel's centre; the line is seen
// so that its major axis is x, `cut` is where it crosses the pixel's middle row.
struct LineEnd {
    float along, across, cut;

    bool in_diamond() const { return std::fabs(along) + std::fabs(across) < 0.5; }
};

// Diamond-exit rule (GL 1.5 §3.4.1) for the first pixel, (x, y) = start - end.
bool start_drawn(const LineEnd& e, float x, float y) {
    if (e.in_diamond()) return true;
    if (positive(e.along) == positive(-x)) return false;
    if (positive(-e.across) != positive(y)) return true;
    return e.cut > 0.0f && e.cut < 1.0f;
}

// ... and for the last one, where the y-major test includes zero.
bool end_drawn(const LineEnd& e, float x, float y, bool zero_counts) {
    if (e.in_diamond()) return false;
    if (positive(e.along) != positive(-x)) return false;
    if (positive(-e.across) == positive(y)) return true;
    return (e.cut > 0.0f || (zero_counts && e.cut == 0.0f)) && e.cut < 1.0f;
}

// Planes of a line's attributes run along its major axis.
struct LineGradients {
    float x, y;  // start - end, stretched along the major axis
    float inverse_area;
    float centre_x, centre_y;

    Plane plane(float start, float end) const {
        const float difference = start - end;
        const float dadx = difference * x * inverse_area;
        const float dady = difference * y * inverse_area;
        return {start - (dadx * centre_x + dady * centre_y), dadx, dady};
    }
};

}  // namespace

void draw_triangle(Image& image, std::array<Vertex, 3> v, const PolygonOffset& offset) {
    std::array<Fixed, 3> corner;
    for (int i = 0; i < 3; ++i) corner[i] = {snap(v[i].window[0]), snap(v[i].window[1])};
    const std::int64_t area = (corner[0].x - corner[1].x) * (corner[2].y - corner[0].y) -
                              (corner[2].x - corner[0].x) * (corner[0].y - corner[1].y);
    if (area == 0) return;
    if (area < 0) {
        std::swap(v[0], v[1]);
        std::swap(corner[0], corner[1]);
    }
    const Float4 &p0 = v[0].window, &p1 = v[1].window, &p2 = v[2].window;
    const float x01 = p0[0] - p1[0], y01 = p0[1] - p1[1], x20 = p2[0] - p0[0], y20 = p2[1] - p0[1];
    const float inverse_area = 1.0f / (x01 * y20 - y01 * x20);
    const TriangleGradients gradients = {x01 * inverse_area, y01 * inverse_area, x20 * inverse_area,
                                         y20 * inverse_area, p0[0] - 0.5f,       p0[1] - 0.5f};
    Planes planes;
    planes.z = gradients.plane(p0[2], p1[2], p2[2]);
    planes.w = gradients.plane(p0[3], p1[3], p2[3]);
    for (int i = 0; i < 4; ++i)
        planes.colour[i] =
            gradients.plane(v[0].colour[i] * p0[3], v[1].colour[i] * p1[3], v[2].colour[i] * p2[3]);
    const bool offset_enabled = offset.factor != 0 || offset.units != 0;
    fill(image, corner, planes, offset_enabled ? polygon_offset(v, inverse_area, offset) : 0.0f);
}

void draw_line(Image& image, const Vertex& start, const Vertex& end, float width) {
    const Float4 &p = start.window, &q = end.window;
    const float d[2] = {p[0] - q[0], p[1] - q[1]};
    const float area = d[0] * d[0] + d[1] * d[1];
    if (area == 0) return;
    const bool x_major = std::fabs(d[0]) >= std::fabs(d[1]);
    const int a = x_major ? 0 : 1, b = 1 - a;  // along and across
    const float slope = d[b] / d[a];

    float e1[2], e2[2];
    for (int i = 0; i < 2; ++i) {
        e1[i] = fraction(p[i]) - 0.5f;
        e2[i] = fraction(q[i]) - 0.5f;
    }
    if (e2[b] == -0.5f && d[b] < 0) e2[b] = 0.5f;
    // The y-major rules are the x-major ones turned by half a revolution.
    const float turn = x_major ? 1.0f : -1.0f;
    const LineEnd first = {turn * e1[a], turn * e1[b], fraction(p[b]) + e1[a] * slope};
    const LineEnd last = {turn * e2[a], turn * e2[b], fraction(q[b]) + e2[a] * slope};
    const float along = turn * d[a], across = turn * d[b];
    const bool start_covered = positive(-first.along) != positive(along);
    const bool end_covered = positive(last.along) == positive(-along) || last.along == 0;

    // The parallelogram grows or shrinks by a pixel where the diamond rule and its own coverage disagree.
    const bool swapped = along < 0;
    const float half = (swapped ? -0.5f : 0.5f) * turn;
    const float move_start = start_drawn(first, along, across) != start_covered ? -e1[a] + half : 0.0f;
    const float move_end = end_drawn(last, along, across, !x_major) != end_covered ? -e2[a] + half : 0.0f;
    const Float4 &from = swapped ? q : p, &to = swapped ? p : q;
    const float move_from = swapped ? move_end : move_start, move_to = swapped ? move_start : move_end;

    const int half_width = static_cast<int>(std::max(width, 1.0f) + 0.5f) * 256 / 2;
    const auto corner = [&](const Float4& at, float move, int side) {
        const int major = snap_away(at[a] + move - 0.5f);
        const int minor = snap_away(at[b] + move * slope - 0.5f) + side * half_width;
        return x_major ? Fixed{major, minor} : Fixed{minor, major};
    };
    const std::array<Fixed, 4> outline = {corner(from, move_from, -1), corner(to, move_to, -1),
                                          corner(to, move_to, 1), corner(from, move_from, 1)};

    const float stretched = d[a] * (1 + slope * slope);
    const LineGradients gradients = {x_major ? stretched : 0.0f, x_major ? 0.0f : stretched, 1.0f / area,
                                     p[0] - 0.5f, p[1] - 0.5f};
    Planes planes;
    planes.z = gradients.plane(p[2], q[2]);
    planes.w = gradients.plane(p[3], q[3]);
    for (int i = 0; i < 4; ++i)
        planes.colour[i] = gradients.plane(start.colour[i] * p[3], end.colour[i] * q[3]);
    fill(image, outline, planes, 0.0f);
}

void draw_point(Image& image, const Vertex& point, float size) {
    const int x = snap_away(point.window[0]);
    const int y = snap_away(point.window[1]) - 1;  // the lower edge belongs to the pixel, as with triangles
    const int n = std::max(256, (snap_away(size) + 127) & ~255) >> 8;
    const int left = n & 1 ? (x >> 8) - (n - 1) / 2 : ((x + 128) >> 8) - n / 2;
    const int top = n & 1 ? (y >> 8) - (n - 1) / 2 : ((y + 128) >> 8) - n / 2;
    for (int row = std::max(top, 0); row < std::min(top + n, image.height); ++row)
        for (int column = std::max(left, 0); column < std::min(left + n, image.width); ++column) {
            Pixel& pixel = image.at(column, row);
            pixel.covered = true;
            for (int i = 0; i < 4; ++i)
                pixel.colour[i] = point.colour[i] * point.window[3] * (1.0f / point.window[3]);
            pixel.z = point.window[2];
        }
}

}  // namespace terrazzo::test::model
