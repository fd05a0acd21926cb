// Making and drawing the cells; see corpus.h.
#include "corpus.h"

#include <algorithm>
#include <limits>

#include "random.h"

namespace terrazzo::coverage {
namespace {

struct WindowPoint {
    float x, y;
    float depth;  // 0 near, 1 far
};

// Makes window positions of one family.
class Placer {
  public:
    Placer(Random& random, Family family, int width, int height)
        : m_random(random),
          m_family(family),
          m_width(static_cast<float>(width)),
          m_height(static_cast<float>(height)) {}

    // The vertices of one primitive, or the next one of a connected row.
    void primitive(int vertices, std::vector<WindowPoint>& out);

  private:
    WindowPoint anywhere(float beyond) {
        return {m_random.number(-beyond * m_width, (1 + beyond) * m_width),
                m_random.number(-beyond * m_height, (1 + beyond) * m_height), m_random.number(0.05f, 0.95f)};
    }
    WindowPoint near_to(const WindowPoint& p, float distance) {
        return {p.x + m_random.number(-distance, distance), p.y + m_random.number(-distance, distance),
                std::clamp(p.depth + m_random.number(-0.05f, 0.05f), 0.01f, 0.99f)};
    }
    WindowPoint between(const WindowPoint& a, const WindowPoint& b, float t) {
        return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.depth + t * (b.depth - a.depth)};
    }
    WindowPoint outside();

    Random& m_random;
    Family m_family;
    float m_width, m_height;
};

WindowPoint Placer::outside() {
    WindowPoint p = anywhere(0.5f);
    const float reach = m_random.chance(3) ? 1.0f : 0.5f;  // of a size of the cell, or barely
    const bool low = m_random.chance(2);
    float& across = m_random.chance(2) ? p.x : p.y;
    const float far_side = &across == &p.x ? m_width : m_height;
    across = low ? m_random.number(-reach * far_side, 0.3f)
                 : m_random.number(far_side - 0.3f, (1 + reach) * far_side);
    return p;
}

void Placer::primitive(int vertices, std::vector<WindowPoint>& out) {
    const size_t first = out.size();
    const WindowPoint start = anywhere(m_random.chance(4) ? 0.2f : 0.0f);
    const auto add = [&](const WindowPoint& p) { out.push_back(p); };
    switch (m_family) {
        case Family::kRandom:
        case Family::kNear:
        case Family::kNotFinite:
            for (int i = 0; i < vertices; ++i) add(anywhere(0.15f));
            break;
        case Family::kSliver: {
            const WindowPoint end = anywhere(0.0f);
            add(start);
            if (vertices > 1) add(end);
            if (vertices > 2) {
                const float width = m_random.one_of({1.0f, 0.25f, 0.0625f, 0.00390625f});
                add(near_to(m_random.chance(2) ? start : between(start, end, m_random.number(0, 1)), width));
            }
            break;
        }
        case Family::kSubPixel: {
            const float reach = m_random.one_of({1.0f, 0.5f, 0.1f, 0.01f});
            for (int i = 0; i < vertices; ++i) add(near_to(start, reach));
            break;
        }
        case Family::kLattice: {
            const float step = m_random.one_of({0.5f, 0.25f, 0.125f, 0.0625f, 0.00390625f, 0.001953125f});
            for (int i = 0; i < vertices; ++i) {
                const WindowPoint p = m_random.chance(2) ? anywhere(0.1f) : near_to(start, 4);
                add({Random::on_lattice(p.x, step), Random::on_lattice(p.y, step), p.depth});
            }
            break;
        }
        case Family::kScreenFilling:
            for (int i = 0; i < vertices; ++i) {
                WindowPoint p = anywhere(0);
                p.x = (p.x - m_width / 2) * m_random.one_of({3.0f, 20.0f, 300.0f});
                p.y = (p.y - m_height / 2) * m_random.one_of({3.0f, 20.0f, 300.0f});
                add(p);
            }
            break;
        case Family::kOffScreen:
            for (int i = 0; i < vertices; ++i) add(outside());
            break;
        case Family::kDegenerate: {
            const WindowPoint end = m_random.chance(3) ? start : anywhere(0.1f);
            add(start);
            if (vertices > 1) add(end);
            if (vertices > 2) add(between(start, end, m_random.one_of({0.0f, 0.25f, 0.5f, 1.0f, 2.0f})));
            break;
        }
    }
    if (m_family == Family::kNear) {
        for (size_t i = first; i < out.size(); ++i)
            if (m_random.chance(2)) out[i].depth = m_random.number(-0.8f, 1.8f);
    }
}

// What the window point is in the cell's coordinates.
std::array<float, 4> unproject(const Cell& cell, const WindowPoint& p, int width, int height) {
    if (!cell.perspective) return {p.x, p.y, 1 - 2 * p.depth, 1};
    const auto [left, right, bottom, top, near, far] = cell.volume;
    const double distance = near + p.depth * (far - near);
    const double x = (left + (right - left) * p.x / width) * distance / near;
    const double y = (bottom + (top - bottom) * p.y / height) * distance / near;
    const double moved[3] = {x - cell.placement[4], y - cell.placement[5], -distance - cell.placement[6]};
    // Turned back about the axis.
    const double angle = -cell.placement[0] * 3.14159265358979 / 180;
    double axis[3] = {cell.placement[1], cell.placement[2], cell.placement[3]};
    const double length = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    for (double& a : axis) a /= length;
    const double dot = axis[0] * moved[0] + axis[1] * moved[1] + axis[2] * moved[2];
    std::array<float, 4> out{0, 0, 0, 1};
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        out[static_cast<size_t>(i)] = static_cast<float>(
            moved[i] * std::cos(angle) + (axis[j] * moved[k] - axis[k] * moved[j]) * std::sin(angle) +
            axis[i] * dot * (1 - std::cos(angle)));
    }
    return out;
}

// Numbers that lead vertices astray: in a cell enormous ones have one size, and in each coordinate one sign.
// Between others cutting leaves no window position.
struct Astray {
    float enormous;
    uint32_t signs;
};

float comparable_number(Random& random, const Astray& astray, bool perspective, uint32_t coordinate) {
    const float infinity = std::numeric_limits<float>::infinity();
    const float not_a_number = std::numeric_limits<float>::quiet_NaN();
    const float sign = (astray.signs >> coordinate & 1) != 0 ? -1.0f : 1.0f;
    if (!perspective && coordinate < 3) {
        return random.one_of(
            {not_a_number, infinity, -infinity, sign * astray.enormous, 1e-40f, 65536.0f, -65536.0f});
    }
    return sign * random.one_of({not_a_number, std::min(astray.enormous, 1e30f), 1e-40f, 65536.0f, 0.0f});
}

void lead_astray(Random& random, Strays strays, Cell& cell) {
    const Astray astray{random.one_of({3e38f, 1e30f, 1e20f, 1e12f}), random.below(16)};
    for (auto& vertex : cell.vertices) {
        if (!random.chance(3)) continue;
        const uint32_t c = random.below(4);
        vertex[c] =
            strays == Strays::kAll ? random.stray() : comparable_number(random, astray, cell.perspective, c);
    }
}

GLenum pick_mode(Random& random) {
    return random.one_of<GLenum>({GL_TRIANGLES, GL_TRIANGLES, GL_TRIANGLES, GL_TRIANGLE_STRIP,
                                  GL_TRIANGLE_FAN, GL_LINES, GL_LINES, GL_LINE_STRIP, GL_POINTS});
}

// Vertices of the first primitive and of each further one.
struct Counts {
    int first, next;
};
Counts vertex_counts(GLenum mode) {
    switch (mode) {
        case GL_POINTS:
            return {1, 1};
        case GL_LINES:
            return {2, 2};
        case GL_LINE_STRIP:
            return {2, 1};
        case GL_TRIANGLES:
            return {3, 3};
    }
    return {3, 1};
}

}  // namespace

const char* name(Family family) {
    constexpr const char* kNames[kFamilies] = {"random",  "sliver",         "sub-pixel",
                                               "lattice", "screen-filling", "off-screen",
                                               "near",    "degenerate",     "not finite"};
    return kNames[static_cast<int>(family)];
}

Cell make_cell(uint32_t seed, uint32_t number, bool perspective, int width, int height, Strays strays) {
    Random random(seed, number);
    Cell cell;
    cell.perspective = perspective;
    cell.family = static_cast<Family>(number % kFamilies);
    cell.mode = pick_mode(random);
    const bool is_point = cell.mode == GL_POINTS;
    const float largest = random.chance(4) ? (is_point ? 70.0f : 40.0f) : 8.0f;
    cell.size = random.chance(2) ? static_cast<float>(1 + random.below(4)) : random.number(0.05f, largest);
    if (perspective) {
        const double near = random.number(0.1f, 2), x = random.number(-0.3f, 0.3f),
                     y = random.number(-0.3f, 0.3f);
        const double half_width = random.number(0.2f, 1.5f) * near,
                     half_height = random.number(0.2f, 1.5f) * near;
        cell.volume = {x * near - half_width,
                       x * near + half_width,
                       y * near - half_height,
                       y * near + half_height,
                       near,
                       near * random.number(4, 200)};
        cell.placement = {random.number(-180, 180), random.number(-1, 1), random.number(-1, 1),
                          random.number(0.1f, 1),   random.number(-3, 3), random.number(-3, 3),
                          random.number(-9, 0)};
    } else {
        cell.volume = {0, static_cast<double>(width), 0, static_cast<double>(height), -1, 1};
        cell.placement = {};
    }
    Placer placer(random, cell.family, width, height);
    std::vector<WindowPoint> points;
    const Counts counts = vertex_counts(cell.mode);
    for (int i = 0; i < kCellPrimitives; ++i) placer.primitive(i == 0 ? counts.first : counts.next, points);
    if (cell.mode == GL_TRIANGLE_FAN && cell.family != Family::kNotFinite) {
        // All round the first vertex, in order.
        const float radius = random.number(0.2f, 0.8f) * static_cast<float>(width);
        for (size_t i = 1; i < points.size(); ++i) {
            const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(points.size() - 2);
            const float wobble = random.number(0.3f, 1);
            points[i].x = points[0].x + radius * wobble * std::cos(angle);
            points[i].y = points[0].y + radius * wobble * std::sin(angle);
        }
    }
    for (const WindowPoint& p : points) cell.vertices.push_back(unproject(cell, p, width, height));
    if (cell.family == Family::kNotFinite) lead_astray(random, strays, cell);
    return cell;
}

std::vector<std::array<float, 4>> vertices_of(const Cell& cell, uint32_t primitive) {
    const auto [count, step] = vertex_counts(cell.mode);
    std::vector<std::array<float, 4>> vertices;
    for (int i = 0; i < count; ++i) {
        const bool pivot = cell.mode == GL_TRIANGLE_FAN && i == 0;
        const int at = pivot ? 0 : static_cast<int>(primitive) * step + i;
        vertices.push_back(cell.vertices[static_cast<size_t>(at)]);
    }
    return vertices;
}

void draw(const kit::Gl& gl, const Cell& cell, const Rectangle& viewport) {
    gl.Viewport(viewport.x, viewport.y, viewport.width, viewport.height);
    gl.Scissor(viewport.x, viewport.y, viewport.width, viewport.height);
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    const auto& v = cell.volume;
    if (cell.perspective) {
        gl.Frustum(v[0], v[1], v[2], v[3], v[4], v[5]);
    } else {
        gl.Ortho(v[0], v[1], v[2], v[3], v[4], v[5]);
    }
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadIdentity();
    const auto& p = cell.placement;
    gl.Translatef(p[4], p[5], p[6]);
    if (cell.perspective) gl.Rotatef(p[0], p[1], p[2], p[3]);
    gl.PointSize(cell.size);
    gl.LineWidth(cell.size);
    const Counts counts = vertex_counts(cell.mode);
    gl.Begin(cell.mode);
    int primitive = 0, left = counts.first;
    for (const auto& vertex : cell.vertices) {
        // Flat shading: the last vertex of a primitive gives its colour.
        GLubyte color[4] = {};
        color[primitive / 8] = static_cast<GLubyte>(1u << primitive % 8);
        gl.Color4ubv(color);
        gl.Vertex4fv(vertex.data());
        if (--left == 0) ++primitive, left = counts.next;
    }
    gl.End();
}

}  // namespace terrazzo::coverage
