// Commands of points, lines and polygons (GL 1.5 §3.3-3.5) except the polygon stipple (polygon_stipple.cpp).
#include "gl/rasterization.h"

#include <algorithm>

#include "gl/change.h"
#include "gl/generated/commands.h"

namespace terrazzo::gl {
namespace {

bool is_face(GLenum face) {
    return face == GL_FRONT || face == GL_BACK || face == GL_FRONT_AND_BACK;
}

}  // namespace

void point_size(Context& ctx, GLfloat size) {
    if (!(size > 0)) return record_error(ctx, GL_INVALID_VALUE, "size is not positive");
    change(ctx, Dirty::kRasterization, ctx.rasterization.point.size, size);
}

void point_parameterfv(Context& ctx, GLenum pname, const GLfloat* params) {
    PointState& point = ctx.rasterization.point;
    GLfloat* value = nullptr;
    switch (pname) {
        case GL_POINT_DISTANCE_ATTENUATION:
            return change(ctx, Dirty::kRasterization, point.attenuation,
                          std::array{params[0], params[1], params[2]});
        case GL_POINT_SIZE_MIN:
            value = &point.min_size;
            break;
        case GL_POINT_SIZE_MAX:
            value = &point.max_size;
            break;
        case GL_POINT_FADE_THRESHOLD_SIZE:
            value = &point.fade_threshold;
            break;
        default:
            return record_error(ctx, GL_INVALID_ENUM, "no such point parameter");
    }
    if (!(*params >= 0)) return record_error(ctx, GL_INVALID_VALUE, "the size is negative");
    change(ctx, Dirty::kRasterization, *value, *params);
}

void sample_coverage(Context& ctx, GLfloat value, GLboolean invert) {
    begin_change(ctx, Dirty::kRasterization);
    MultisampleState& state = ctx.rasterization.multisample;
    state.coverage_value = value > 0 ? std::min(value, 1.0f) : 0.0f;
    state.coverage_invert = invert != GL_FALSE;
}

void line_width(Context& ctx, GLfloat width) {
    if (!(width > 0)) return record_error(ctx, GL_INVALID_VALUE, "width is not positive");
    change(ctx, Dirty::kRasterization, ctx.rasterization.line.width, width);
}

void line_stipple(Context& ctx, GLint factor, GLushort pattern) {
    change(ctx, Dirty::kRasterization, ctx.rasterization.line.stipple_factor, std::clamp(factor, 1, 256));
    change(ctx, Dirty::kRasterization, ctx.rasterization.line.stipple_pattern, pattern);
}

void polygon_mode(Context& ctx, GLenum face, GLenum mode) {
    if (!is_face(face)) return record_error(ctx, GL_INVALID_ENUM, "no such face");
    if (mode != GL_POINT && mode != GL_LINE && mode != GL_FILL) {
        return record_error(ctx, GL_INVALID_ENUM, "mode is not GL_POINT, GL_LINE or GL_FILL");
    }
    PolygonState& polygon = ctx.rasterization.polygon;
    if (face != GL_BACK) change(ctx, Dirty::kRasterization, polygon.front_mode, mode);
    if (face != GL_FRONT) change(ctx, Dirty::kRasterization, polygon.back_mode, mode);
}

void polygon_offset(Context& ctx, GLfloat factor, GLfloat units) {
    change(ctx, Dirty::kRasterization, ctx.rasterization.polygon.offset_factor, factor);
    change(ctx, Dirty::kRasterization, ctx.rasterization.polygon.offset_units, units);
}

void cull_face(Context& ctx, GLenum mode) {
    if (!is_face(mode)) return record_error(ctx, GL_INVALID_ENUM, "no such face");
    change(ctx, Dirty::kRasterization, ctx.rasterization.polygon.cull_face, mode);
}

void front_face(Context& ctx, GLenum mode) {
    if (mode != GL_CW && mode != GL_CCW) {
        return record_error(ctx, GL_INVALID_ENUM, "mode is not GL_CW or GL_CCW");
    }
    change(ctx, Dirty::kRasterization, ctx.rasterization.polygon.front_face, mode);
}

}  // namespace terrazzo::gl
