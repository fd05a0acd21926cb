// Curves by Horner's scheme in Bernstein form, tangents by de Casteljau's.
#include "gl/bezier.h"

#include <algorithm>

namespace terrazzo::gl {
namespace {

float mix(float a, float b, float t) {
    return (1.0f - t) * a + t * b;
}

// One component of a net of control points that shrinks step by step.
class Net {
  public:
    Net(const BezierSurface& surface, int component) : m_u(surface.u_order), m_v(surface.v_order) {
        for (int i = 0; i < m_u; ++i)
            for (int j = 0; j < m_v; ++j)
                m_values[i][j] = surface.points[(i * m_v + j) * surface.size + component];
    }

    int u_count() const { return m_u; }
    int v_count() const { return m_v; }
    float at(int i, int j) const { return m_values[i][j]; }

    // A step along both parameters, u first.
    void shrink(float u, float v) {
        --m_u;
        --m_v;
        for (int i = 0; i < m_u; ++i) {
            float row[kMaxEvalOrder];
            for (int j = 0; j <= m_v; ++j) row[j] = mix(m_values[i][j], m_values[i + 1][j], u);
            for (int j = 0; j < m_v; ++j) m_values[i][j] = mix(row[j], row[j + 1], v);
        }
    }

  private:
    int m_u, m_v;
    float m_values[kMaxEvalOrder][kMaxEvalOrder];
};

// The last two points of a curve, and what they make.
struct LastTwo {
    float first, second;

    LastTwo(float* points, int count, float t) {
        for (; count > 2; --count)
            for (int i = 0; i + 1 < count; ++i) points[i] = mix(points[i], points[i + 1], t);
        first = points[0];
        second = count == 2 ? points[1] : points[0];
    }
};

struct Tangents {
    float point, along, across;
};

// A net of two points across (or one) and any number along.
template <typename At>
Tangents strip_tangents(int count, bool has_two, float t_along, float t_across, At at) {
    float points[kMaxEvalOrder], differences[kMaxEvalOrder];
    for (int i = 0; i < count; ++i) {
        const float first = at(i, 0), second = has_two ? at(i, 1) : first;
        points[i] = has_two ? mix(first, second, t_across) : first;
        differences[i] = second - first;
    }
    const LastTwo point(points, count, t_along), difference(differences, count, t_along);
    return {mix(point.first, point.second, t_along), point.second - point.first,
            mix(difference.first, difference.second, t_along)};
}

}  // namespace

void bezier_curve(const float* points, int step, int size, int order, float t, float* out) {
    if (order == 1) {
        std::copy_n(points, size, out);
        return;
    }
    const float s = 1.0f - t;
    auto coefficient = static_cast<float>(order - 1);
    for (int k = 0; k < size; ++k) out[k] = s * points[k] + coefficient * t * points[step + k];
    float power = t * t;
    for (int i = 2; i < order; ++i, power *= t) {
        coefficient *= static_cast<float>(order - i);
        coefficient *= 1.0f / static_cast<float>(i);
        const float* const point = points + i * step;
        for (int k = 0; k < size; ++k) out[k] = s * out[k] + coefficient * power * point[k];
    }
}

void bezier_surface(const BezierSurface& surface, float u, float v, float* out) {
    const int size = surface.size, row = surface.v_order * size;
    float curve[kMaxEvalOrder * 4];
    // The longer direction last.
    if (surface.v_order > surface.u_order) {
        for (int j = 0; j < surface.v_order; ++j)
            bezier_curve(surface.points + j * size, row, size, surface.u_order, u, curve + j * size);
        return bezier_curve(curve, size, size, surface.v_order, v, out);
    }
    for (int i = 0; i < surface.u_order; ++i)
        bezier_curve(surface.points + i * row, size, size, surface.v_order, v, curve + i * size);
    bezier_curve(curve, size, size, surface.u_order, u, out);
}

void bezier_tangents(const BezierSurface& surface, float u, float v, float* out, float* du, float* dv) {
    for (int k = 0; k < surface.size; ++k) {
        Net net(surface, k);
        while (net.u_count() > 2 && net.v_count() > 2) net.shrink(u, v);
        if (net.u_count() == 2 && net.v_count() == 2) {
            const float a = net.at(0, 0), b = net.at(0, 1), c = net.at(1, 0), d = net.at(1, 1);
            du[k] = mix(c - a, d - b, v);
            dv[k] = mix(b - a, d - c, u);
            out[k] = mix(mix(a, b, v), mix(c, d, v), u);
        } else if (net.u_count() <= net.v_count()) {
            const Tangents t = strip_tangents(net.v_count(), net.u_count() == 2, v, u,
                                              [&](int j, int i) { return net.at(i, j); });
            out[k] = t.point, dv[k] = t.along, du[k] = t.across;
        } else {
            const Tangents t = strip_tangents(net.u_count(), net.v_count() == 2, u, v,
                                              [&](int i, int j) { return net.at(i, j); });
            out[k] = t.point, du[k] = t.along, dv[k] = t.across;
        }
    }
}

}  // namespace terrazzo::gl
