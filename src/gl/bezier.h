// Points on Bezier curves and surfaces in floats, operation for operation as the reference evaluates them
// (doc/reference.md, "Evaluators").
#pragma once

namespace terrazzo::gl {

inline constexpr int kMaxEvalOrder = 30;

// Control point i begins at points[i * step] and has `size` (up to 4) components, as has `out`.
void bezier_curve(const float* points, int step, int size, int order, float t, float* out);

// Control points lie v after v, and u after u.
struct BezierSurface {
    const float* points;
    int size;
    int u_order, v_order;
};
void bezier_surface(const BezierSurface& surface, float u, float v, float* out);

// The same with the directions of the tangents: along a parameter without extent they are 0.
void bezier_tangents(const BezierSurface& surface, float u, float v, float* out, float* du, float* dv);

}  // namespace terrazzo::gl
