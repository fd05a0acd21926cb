// Rasterization state of points, lines and polygons (GL 1.5 §3.3-3.5, table 6.15). Each struct is what one
// bit of glPushAttrib saves.
#pragma once

#include <GL/gl.h>

#include <array>
#include <cstdint>

#include "gl/limits.h"

namespace terrazzo::gl {

struct PointState {
    GLfloat size = 1;
    bool smooth = false;
    bool sprite = false;             // ARB_point_sprite
    std::uint8_t coord_replace = 0;  // one bit for each unit whose coordinates span a sprite
    // GL 1.5 §3.3; only multisampled points would fade.
    GLfloat min_size = 0, max_size = kMaxPointSize;
    GLfloat fade_threshold = 1;
    std::array<GLfloat, 3> attenuation{1, 0, 0};  // constant, linear, quadratic

    bool attenuated() const { return attenuation != std::array<GLfloat, 3>{1, 0, 0}; }
};

struct LineState {
    GLfloat width = 1;
    bool smooth = false;
    bool stipple_enabled = false;
    GLint stipple_factor = 1;  // already clamped to 1..256
    GLushort stipple_pattern = 0xffff;
};

struct PolygonState {
    GLenum front_mode = GL_FILL;
    GLenum back_mode = GL_FILL;
    GLenum front_face = GL_CCW;
    bool cull_enabled = false;
    GLenum cull_face = GL_BACK;
    bool smooth = false;
    bool stipple_enabled = false;
    GLfloat offset_factor = 0;
    GLfloat offset_units = 0;
    bool offset_fill = false;
    bool offset_line = false;
    bool offset_point = false;
};

// Row y of the pattern, lowest first; bit 31 is the leftmost pixel (GL 1.5 §3.5.2).
struct PolygonStipple {
    PolygonStipple() { rows.fill(0xffffffffu); }

    std::array<std::uint32_t, 32> rows;
};

// GL 1.5 §3.2.1, §4.1.3. No render target has samples, so that none of it has an effect.
struct MultisampleState {
    bool enabled = true;
    bool alpha_to_coverage = false, alpha_to_one = false, coverage = false;
    GLfloat coverage_value = 1;
    bool coverage_invert = false;
};

struct RasterizationState {
    MultisampleState multisample;
    PointState point;
    LineState line;
    PolygonState polygon;
    PolygonStipple polygon_stipple;
};

}  // namespace terrazzo::gl
