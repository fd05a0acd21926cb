// Map, MapGrid, EvalCoord, EvalPoint, EvalMesh and GetMap. An evaluated vertex leaves the current values as
// they were (GL 1.5 §5.1).
#include "gl/evaluators.h"

#include <cmath>

#include "gl/bezier.h"
#include "gl/context.h"
#include "gl/convert.h"
#include "gl/generated/commands.h"
#include "gl/vertex_inline.h"

namespace terrazzo::gl {
namespace {

constexpr int kComponents[kEvaluatorTargetCount] = {4, 1, 3, 1, 2, 3, 4, 3, 4};

// Which map an enumerant names.
struct Named {
    int dimensions = 0;  // 0: none
    int target = 0;

    explicit Named(GLenum name) {
        if (name >= GL_MAP1_COLOR_4 && name <= GL_MAP1_VERTEX_4) {
            dimensions = 1;
            target = static_cast<int>(name - GL_MAP1_COLOR_4);
        } else if (name >= GL_MAP2_COLOR_4 && name <= GL_MAP2_VERTEX_4) {
            dimensions = 2;
            target = static_cast<int>(name - GL_MAP2_COLOR_4);
        }
    }
    int components() const { return kComponents[target]; }
};

// One parameter of Map1 or Map2.
struct Axis {
    GLfloat first, last;
    GLint stride, order;
};

const char* broken_rule(const Axis& axis, int components) {
    if (axis.first == axis.last) return "the domain is empty";
    if (axis.order < 1 || axis.order > kMaxEvalOrder) return "the order is out of range";
    if (axis.stride < components) return "the stride is less than a control point";
    return nullptr;
}

template <typename Real>
void set_map(Context& ctx, GLenum name, int dimensions, const Axis& u, const Axis& v, const Real* points) {
    const Named named(name);
    if (named.dimensions != dimensions) return record_error(ctx, GL_INVALID_ENUM, "no such map");
    for (const Axis& axis : {u, v})
        if (const char* const rule = broken_rule(axis, named.components()))
            return record_error(ctx, GL_INVALID_VALUE, rule);
    if (ctx.texture.active_unit != 0)
        return record_error(ctx, GL_INVALID_OPERATION, "another texture unit than 0 is active");
    std::vector<GLfloat> copied;
    for (GLint i = 0; i < u.order; ++i)
        for (GLint j = 0; j < v.order; ++j)
            for (int k = 0; k < named.components(); ++k)
                copied.push_back(static_cast<GLfloat>(
                    points[static_cast<std::ptrdiff_t>(i) * u.stride + std::ptrdiff_t{j} * v.stride + k]));
    EvaluatorMaps& maps = dimensions == 1 ? ctx.evaluators.maps_1d : ctx.evaluators.maps_2d;
    EvaluatorMap& map = maps[static_cast<std::size_t>(named.target)];
    map.domain = {u.first, u.last, v.first, v.last};
    map.order = {u.order, v.order};
    map.points = std::move(copied);
}

// What Map1 has for a second parameter.
Axis single_point(GLenum name) {
    return {0, 1, kComponents[Named(name).target], 1};
}

template <typename Real>
void set_map_1d(Context& ctx, GLenum name, Real u1, Real u2, GLint stride, GLint order, const Real* points) {
    set_map(ctx, name, 1, {static_cast<GLfloat>(u1), static_cast<GLfloat>(u2), stride, order},
            single_point(name), points);
}

template <typename Real>
void set_map_2d(Context& ctx, GLenum name, Real u1, Real u2, GLint ustride, GLint uorder, Real v1, Real v2,
                GLint vstride, GLint vorder, const Real* points) {
    set_map(ctx, name, 2, {static_cast<GLfloat>(u1), static_cast<GLfloat>(u2), ustride, uorder},
            {static_cast<GLfloat>(v1), static_cast<GLfloat>(v2), vstride, vorder}, points);
}

template <typename Value, typename Convert>
void get_map(Context& ctx, GLenum name, GLenum query, Value* out, Convert convert) {
    const Named named(name);
    if (named.dimensions == 0) return record_error(ctx, GL_INVALID_ENUM, "no such map");
    const EvaluatorMaps& maps = named.dimensions == 1 ? ctx.evaluators.maps_1d : ctx.evaluators.maps_2d;
    const EvaluatorMap& map = maps[static_cast<std::size_t>(named.target)];
    const auto dimensions = static_cast<std::size_t>(named.dimensions);
    switch (query) {
        case GL_COEFF:
            for (const GLfloat value : map.points) *out++ = convert(value);
            return;
        case GL_ORDER:
            for (std::size_t i = 0; i < dimensions; ++i) *out++ = static_cast<Value>(map.order[i]);
            return;
        case GL_DOMAIN:
            for (std::size_t i = 0; i < 2 * dimensions; ++i) *out++ = convert(map.domain[i]);
            return;
    }
    record_error(ctx, GL_INVALID_ENUM, "no such value of a map");
}

using Value4 = std::array<GLfloat, 4>;

// A parameter as the map has it, u (0) or v (1).
GLfloat scaled(const EvaluatorMap& map, std::size_t axis, GLfloat value) {
    const GLfloat first = map.domain[2 * axis], last = map.domain[2 * axis + 1];
    return (value - first) * (1.0f / (last - first));
}

Value4 evaluate(const EvaluatorMap& map, int components, GLfloat u) {
    Value4 out{0, 0, 0, 1};
    bezier_curve(map.points.data(), components, components, map.order[0], scaled(map, 0, u), out.data());
    return out;
}

BezierSurface surface_of(const EvaluatorMap& map, int components) {
    return {map.points.data(), components, map.order[0], map.order[1]};
}

Value4 evaluate(const EvaluatorMap& map, int components, GLfloat u, GLfloat v) {
    Value4 out{0, 0, 0, 1};
    bezier_surface(surface_of(map, components), scaled(map, 0, u), scaled(map, 1, v), out.data());
    return out;
}

// The point of a surface and its normal (GL 1.5 §5.1, GL_AUTO_NORMAL).
Value4 evaluate_with_normal(const EvaluatorMap& map, int components, GLfloat u, GLfloat v, Value4& normal) {
    Value4 out{0, 0, 0, 1}, du{}, dv{};
    bezier_tangents(surface_of(map, components), scaled(map, 0, u), scaled(map, 1, v), out.data(), du.data(),
                    dv.data());
    if (components == 4) {
        for (std::size_t c = 0; c < 3; ++c) {
            du[c] = du[c] * out[3] - du[3] * out[c];
            dv[c] = dv[c] * out[3] - dv[3] * out[c];
        }
    }
    normal = {du[1] * dv[2] - du[2] * dv[1], du[2] * dv[0] - du[0] * dv[2], du[0] * dv[1] - du[1] * dv[0], 1};
    const GLfloat length2 = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
    if (length2 == 0) return out;
    // The tangents are those of the scaled parameters: a domain that runs backwards turns one round.
    const bool turned = (map.domain[1] < map.domain[0]) != (map.domain[3] < map.domain[2]);
    const GLfloat scale = (turned ? -1.0f : 1.0f) / std::sqrt(length2);
    for (std::size_t c = 0; c < 3; ++c) normal[c] *= scale;
    return out;
}

// The enabled one of several maps with the most components, -1 for none.
int best_enabled(const EvaluatorEnables& enabled, int first, int last) {
    for (int target = last; target >= first; --target)
        if (enabled[static_cast<std::size_t>(target)]) return target;
    return -1;
}

// Sets attributes for one vertex and puts the current values back after it.
class OneVertex {
  public:
    explicit OneVertex(Context& ctx) : m_ctx(ctx) {}
    ~OneVertex() {
        for (int i = 0; i < m_count; ++i) {
            const Value4& v = m_saved[static_cast<std::size_t>(i)].value;
            set_attribute(m_ctx, m_saved[static_cast<std::size_t>(i)].attribute, v[0], v[1], v[2], v[3]);
        }
    }
    OneVertex(const OneVertex&) = delete;
    OneVertex& operator=(const OneVertex&) = delete;

    void set(int attribute, const Value4& v) {
        m_saved[static_cast<std::size_t>(m_count++)] = {
            attribute, m_ctx.vertex.current.values[static_cast<std::size_t>(attribute)]};
        set_attribute(m_ctx, attribute, v[0], v[1], v[2], v[3]);
    }

  private:
    struct Saved {
        int attribute;
        Value4 value;
    };
    Context& m_ctx;
    std::array<Saved, 4> m_saved;
    int m_count = 0;
};

// `at(map, components)` evaluates a map.
template <typename At>
void set_evaluated(const EvaluatorEnables& enabled, const EvaluatorMaps& maps, OneVertex& vertex, At at) {
    const auto evaluate_one = [&](int target) {
        return at(maps[static_cast<std::size_t>(target)], kComponents[target]);
    };
    if (enabled[kMapColor4]) vertex.set(pipeline::kColor, evaluate_one(kMapColor4));
    if (enabled[kMapNormal]) vertex.set(pipeline::kNormal, evaluate_one(kMapNormal));
    const int texture = best_enabled(enabled, kMapTexture1, kMapTexture4);
    if (texture >= 0) vertex.set(pipeline::kTexture0, evaluate_one(texture));
}

int vertex_map(const EvaluatorEnables& enabled) {
    return best_enabled(enabled, kMapVertex3, kMapVertex4);
}

GLfloat grid_point(const EvaluatorGrid& grid, GLint i) {
    return static_cast<GLfloat>(i) * grid.step() + grid.first;
}

// Calls visit(parameter) for the grid's points from `first` to `last`, as long as it answers true. Whether it
// always has.
template <typename Visit>
bool walk_while(const EvaluatorGrid& grid, GLint first, GLint last, Visit visit) {
    const GLfloat step = grid.step();
    GLfloat parameter = grid.first + static_cast<GLfloat>(first) * step;
    for (std::int64_t i = first; i <= last; ++i, parameter += step)
        if (!visit(parameter)) return false;
    return true;
}

template <typename Visit>
void walk(const EvaluatorGrid& grid, GLint first, GLint last, Visit visit) {
    walk_while(grid, first, last, [&](GLfloat parameter) { return visit(parameter), true; });
}

// Draws what `walk_points` gives the coordinates of; false where nothing may be drawn.
template <typename WalkPoints>
bool draw_points(Context& ctx, GLenum mode, WalkPoints walk_points) {
    if (!open_primitive(ctx, mode)) return false;
    walk_points();
    end(ctx);
    return true;
}

void fill_mesh(Context& ctx, const EvaluatorGrid& across, const EvaluatorGrid& up, GLint i1, GLint i2,
               GLint j1, GLint j2) {
    if (j2 == j1) return;
    const GLfloat step = up.step();
    walk_while(up, j1, j2 - 1, [&](GLfloat v) {
        return draw_points(ctx, GL_TRIANGLE_STRIP, [&] {
            walk(across, i1, i2, [&](GLfloat u) {
                eval_coord2f(ctx, u, v);
                eval_coord2f(ctx, u, v + step);
            });
        });
    });
}

}  // namespace

EvaluatorState::EvaluatorState() {
    const std::vector<GLfloat> initial[kEvaluatorTargetCount] = {
        {1, 1, 1, 1}, {1}, {0, 0, 1}, {0}, {0, 0}, {0, 0, 0}, {0, 0, 0, 1}, {0, 0, 0}, {0, 0, 0, 1}};
    for (std::size_t i = 0; i < kEvaluatorTargetCount; ++i)
        maps_1d[i].points = maps_2d[i].points = initial[i];
}

bool* find_evaluator_flag(EvaluatorModes& modes, GLenum cap) {
    if (cap == GL_AUTO_NORMAL) return &modes.auto_normal;
    const Named named(cap);
    if (named.dimensions == 0) return nullptr;
    EvaluatorEnables& enables = named.dimensions == 1 ? modes.enabled_1d : modes.enabled_2d;
    return &enables[static_cast<std::size_t>(named.target)];
}

std::ptrdiff_t map_elements(GLenum target, GLint stride, GLint order) {
    const Axis none = single_point(target);
    return map_elements(target, stride, order, none.stride, none.order);
}

std::ptrdiff_t map_elements(GLenum target, GLint ustride, GLint uorder, GLint vstride, GLint vorder) {
    const int components = Named(target).components();
    if (Named(target).dimensions == 0 || uorder < 1 || uorder > kMaxEvalOrder || vorder < 1 ||
        vorder > kMaxEvalOrder || ustride < components || vstride < components)
        return 0;
    return std::ptrdiff_t{uorder - 1} * ustride + std::ptrdiff_t{vorder - 1} * vstride + components;
}

void map1f(Context& ctx, GLenum target, GLfloat u1, GLfloat u2, GLint stride, GLint order,
           const GLfloat* points) {
    set_map_1d(ctx, target, u1, u2, stride, order, points);
}

void map1d(Context& ctx, GLenum target, GLdouble u1, GLdouble u2, GLint stride, GLint order,
           const GLdouble* points) {
    set_map_1d(ctx, target, u1, u2, stride, order, points);
}

void map2f(Context& ctx, GLenum target, GLfloat u1, GLfloat u2, GLint ustride, GLint uorder, GLfloat v1,
           GLfloat v2, GLint vstride, GLint vorder, const GLfloat* points) {
    set_map_2d(ctx, target, u1, u2, ustride, uorder, v1, v2, vstride, vorder, points);
}

void map2d(Context& ctx, GLenum target, GLdouble u1, GLdouble u2, GLint ustride, GLint uorder, GLdouble v1,
           GLdouble v2, GLint vstride, GLint vorder, const GLdouble* points) {
    set_map_2d(ctx, target, u1, u2, ustride, uorder, v1, v2, vstride, vorder, points);
}

void map_grid1f(Context& ctx, GLint un, GLfloat u1, GLfloat u2) {
    if (un < 1) return record_error(ctx, GL_INVALID_VALUE, "a grid has at least one segment");
    ctx.evaluators.modes.grid_1d = {un, u1, u2};
}

void map_grid1d(Context& ctx, GLint un, GLdouble u1, GLdouble u2) {
    map_grid1f(ctx, un, static_cast<GLfloat>(u1), static_cast<GLfloat>(u2));
}

void map_grid2f(Context& ctx, GLint un, GLfloat u1, GLfloat u2, GLint vn, GLfloat v1, GLfloat v2) {
    if (un < 1 || vn < 1) return record_error(ctx, GL_INVALID_VALUE, "a grid has at least one segment");
    ctx.evaluators.modes.grid_2d = {EvaluatorGrid{un, u1, u2}, EvaluatorGrid{vn, v1, v2}};
}

void map_grid2d(Context& ctx, GLint un, GLdouble u1, GLdouble u2, GLint vn, GLdouble v1, GLdouble v2) {
    map_grid2f(ctx, un, static_cast<GLfloat>(u1), static_cast<GLfloat>(u2), vn, static_cast<GLfloat>(v1),
               static_cast<GLfloat>(v2));
}

void get_mapfv(Context& ctx, GLenum target, GLenum query, GLfloat* v) {
    get_map(ctx, target, query, v, [](GLfloat value) { return value; });
}

void get_mapdv(Context& ctx, GLenum target, GLenum query, GLdouble* v) {
    get_map(ctx, target, query, v, [](GLfloat value) { return static_cast<GLdouble>(value); });
}

void get_mapiv(Context& ctx, GLenum target, GLenum query, GLint* v) {
    get_map(ctx, target, query, v, [](GLfloat value) { return rounded(static_cast<GLdouble>(value)); });
}

void eval_coord1f(Context& ctx, GLfloat u) {
    const EvaluatorModes& modes = ctx.evaluators.modes;
    const int target = vertex_map(modes.enabled_1d);
    if (target < 0) return;
    OneVertex vertex(ctx);
    const auto at = [&](const EvaluatorMap& map, int components) { return evaluate(map, components, u); };
    set_evaluated(modes.enabled_1d, ctx.evaluators.maps_1d, vertex, at);
    const Value4 position = at(ctx.evaluators.maps_1d[static_cast<std::size_t>(target)], kComponents[target]);
    vertex4f(ctx, position[0], position[1], position[2], position[3]);
}

void eval_coord2f(Context& ctx, GLfloat u, GLfloat v) {
    const EvaluatorModes& modes = ctx.evaluators.modes;
    const int target = vertex_map(modes.enabled_2d);
    if (target < 0) return;
    OneVertex vertex(ctx);
    const auto at = [&](const EvaluatorMap& map, int components) { return evaluate(map, components, u, v); };
    set_evaluated(modes.enabled_2d, ctx.evaluators.maps_2d, vertex, at);
    const EvaluatorMap& map = ctx.evaluators.maps_2d[static_cast<std::size_t>(target)];
    Value4 position;
    if (modes.auto_normal) {
        Value4 normal;
        position = evaluate_with_normal(map, kComponents[target], u, v, normal);
        vertex.set(pipeline::kNormal, normal);
    } else {
        position = at(map, kComponents[target]);
    }
    vertex4f(ctx, position[0], position[1], position[2], position[3]);
}

void eval_point1(Context& ctx, GLint i) {
    eval_coord1f(ctx, grid_point(ctx.evaluators.modes.grid_1d, i));
}

void eval_point2(Context& ctx, GLint i, GLint j) {
    const auto& grid = ctx.evaluators.modes.grid_2d;
    eval_coord2f(ctx, grid_point(grid[0], i), grid_point(grid[1], j));
}

void eval_mesh1(Context& ctx, GLenum mode, GLint i1, GLint i2) {
    if (mode != GL_POINT && mode != GL_LINE)
        return record_error(ctx, GL_INVALID_ENUM, "mode is not GL_POINT or GL_LINE");
    const EvaluatorModes& modes = ctx.evaluators.modes;
    if (vertex_map(modes.enabled_1d) < 0) return;
    draw_points(ctx, mode == GL_POINT ? GL_POINTS : GL_LINE_STRIP,
                [&] { walk(modes.grid_1d, i1, i2, [&](GLfloat u) { eval_coord1f(ctx, u); }); });
}

void eval_mesh2(Context& ctx, GLenum mode, GLint i1, GLint i2, GLint j1, GLint j2) {
    if (mode != GL_POINT && mode != GL_LINE && mode != GL_FILL)
        return record_error(ctx, GL_INVALID_ENUM, "mode is not GL_POINT, GL_LINE or GL_FILL");
    const EvaluatorModes& modes = ctx.evaluators.modes;
    if (vertex_map(modes.enabled_2d) < 0) return;
    const EvaluatorGrid &across = modes.grid_2d[0], &up = modes.grid_2d[1];
    if (mode == GL_FILL) return fill_mesh(ctx, across, up, i1, i2, j1, j2);
    const auto walk_across = [&](GLfloat v) {
        walk(across, i1, i2, [&](GLfloat u) { eval_coord2f(ctx, u, v); });
    };
    const auto walk_up = [&](GLfloat u) { walk(up, j1, j2, [&](GLfloat v) { eval_coord2f(ctx, u, v); }); };
    if (mode == GL_POINT) {
        draw_points(ctx, GL_POINTS, [&] { walk(up, j1, j2, walk_across); });
        return;
    }
    const bool drawn = walk_while(
        up, j1, j2, [&](GLfloat v) { return draw_points(ctx, GL_LINE_STRIP, [&] { walk_across(v); }); });
    if (!drawn) return;
    walk_while(across, i1, i2,
               [&](GLfloat u) { return draw_points(ctx, GL_LINE_STRIP, [&] { walk_up(u); }); });
}

}  // namespace terrazzo::gl
