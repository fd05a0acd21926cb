// Set-up of lines (GL 1.5 §3.4.1, §3.4.2): a parallelogram of four edges, `width` pixels across the minor
// axis, whose ends are moved where the diamond-exit rule asks for a pixel more or less than its own coverage
// gives. With multisampling (§3.4.4) a rectangle, whose samples need no such rule. Operation for operation
// what the reference does (doc/reference.md §3, "Lines").
#include <algorithm>
#include <cmath>
#include <utility>

#include "pipeline/geometry/program/snap.h"
#include "pipeline/geometry/setup/primitive_setup.h"

namespace terrazzo::pipeline {

namespace {

float fraction(float v) {
    return v - std::floor(v);
}
bool positive(float v) {
    return v >= 0;
}

// An end against the diamond of its pixel, seen so that the line's major axis is x: distances from the
// pixel's centre, and where the line crosses the pixel's middle column.
struct LineEnd {
    float along, across, cut;

    bool in_diamond() const { return std::fabs(along) + std::fabs(across) < 0.5f; }
};

// Whether the pixel of the first end is drawn; (dx, dy) leads from the second end to the first.
bool start_drawn(const LineEnd& e, float dx, float dy) {
    if (e.in_diamond()) return true;
    if (positive(e.along) == positive(-dx)) return false;
    if (positive(-e.across) != positive(dy)) return true;
    return e.cut > 0 && e.cut < 1;
}

// ... and that of the last, which the line must leave.
bool end_drawn(const LineEnd& e, float dx, float dy, bool zero_counts) {
    if (e.in_diamond()) return false;
    if (positive(e.along) != positive(-dx)) return false;
    if (positive(-e.across) == positive(dy)) return true;
    return (e.cut > 0 || (zero_counts && e.cut == 0)) && e.cut < 1;
}

struct Line {
    int32_t x[4], y[4];  // corners, a positive outline
    // (first - second), stretched to the length along the major axis but in rectangles, over the squared
    // length.
    float slope_x, slope_y, one_over_area;
};

bool make_rectangle(const float (&p)[2], const float (&q)[2], float width, Line& line) {
    const float dx = p[0] - q[0], dy = p[1] - q[1];
    const float area = dx * dx + dy * dy;
    if (area == 0) return false;
    line.slope_x = dx, line.slope_y = dy;
    line.one_over_area = 1.0f / area;
    const float scale = width * 0.5f / std::sqrt(area);
    const int32_t across_x = snap_away(-dy * scale), across_y = snap_away(dx * scale);
    const float(*const ends[4])[2] = {&p, &q, &q, &p};
    for (int i = 0; i < 4; ++i) {
        line.x[i] = snap_away((*ends[i])[0]) + (i < 2 ? -across_x : across_x);
        line.y[i] = snap_away((*ends[i])[1]) + (i < 2 ? -across_y : across_y);
    }
    return true;
}

// `p` and `q` are the window positions of the ends.
bool make_line(const float (&p)[2], const float (&q)[2], float width, Line& line) {
    const float d[2] = {p[0] - q[0], p[1] - q[1]};
    const float area = d[0] * d[0] + d[1] * d[1];
    if (area == 0) return false;
    const bool x_major = std::fabs(d[0]) >= std::fabs(d[1]);
    const int major = x_major ? 0 : 1, minor = 1 - major;
    const float slope = d[minor] / d[major];
    const float stretched = d[major] * (1 + slope * slope);
    line.slope_x = x_major ? stretched : 0.0f;
    line.slope_y = x_major ? 0.0f : stretched;
    line.one_over_area = 1.0f / area;

    float start[2], end[2];
    for (int i = 0; i < 2; ++i) start[i] = fraction(p[i]) - 0.5f, end[i] = fraction(q[i]) - 0.5f;
    if (end[minor] == -0.5f && d[minor] < 0) end[minor] = 0.5f;
    // Rows count downwards: the y-major rules are the x-major ones turned by half a revolution.
    const float turn = x_major ? 1.0f : -1.0f;
    const LineEnd first{turn * start[major], turn * start[minor], fraction(p[minor]) + start[major] * slope};
    const LineEnd last{turn * end[major], turn * end[minor], fraction(q[minor]) + end[major] * slope};
    const float along = turn * d[major], across = turn * d[minor];
    const bool start_covered = positive(-first.along) != positive(along);
    const bool end_covered = positive(last.along) == positive(-along) || last.along == 0;

    const bool backwards = along < 0;
    const float half_pixel = (backwards ? -0.5f : 0.5f) * turn;
    float move_from = start_drawn(first, along, across) != start_covered ? -start[major] + half_pixel : 0.0f;
    float move_to = end_drawn(last, along, across, !x_major) != end_covered ? -end[major] + half_pixel : 0.0f;
    if (backwards) std::swap(move_from, move_to);
    const float(&from)[2] = backwards ? q : p;
    const float(&to)[2] = backwards ? p : q;

    const int32_t half_width = static_cast<int32_t>(width + 0.5f) * 128;
    const auto corner = [&](int i, const float(&at)[2], float move, int32_t offset) {
        (x_major ? line.x : line.y)[i] = snap_away(at[major] + move - 0.5f);
        (x_major ? line.y : line.x)[i] = snap_away(at[minor] + move * slope - 0.5f) + offset;
    };
    corner(0, from, move_from, -half_width);
    corner(1, to, move_to, -half_width);
    corner(2, to, move_to, half_width);
    corner(3, from, move_from, half_width);
    return true;
}

}  // namespace

void PrimitiveSetup::line(int a, int b) {
    flush();
    if (m_observer) return m_observer->line(m_vertices, a, b, std::exchange(m_restarts, false));
    const float p[2] = {m_vertices.column(kWindowX)[a], m_vertices.column(kWindowY)[a]};
    const float q[2] = {m_vertices.column(kWindowX)[b], m_vertices.column(kWindowY)[b]};
    for (int i = 0; i < 2; ++i)
        if (!is_window_coordinate(p[i]) || !is_window_coordinate(q[i])) return;
    const bool multisample = m_state.fragment->line.multisample;
    Line line;
    if (!(multisample ? make_rectangle : make_line)(p, q, m_state.raster.line_width, line)) return;

    const auto [low_x, high_x] = std::minmax_element(line.x, line.x + 4);
    const auto [low_y, high_y] = std::minmax_element(line.y, line.y + 4);
    const Box box = multisample ? touched_pixels(*low_x, *low_y, *high_x, *high_y)
                                : pixels_within(*low_x, *low_y, *high_x, *high_y);
    raster::Primitive* const primitive = new_primitive(m_state.fragment->line, box, 4);
    if (primitive == nullptr) return;
    set_edges(*primitive, line.x, line.y);

    float* const a0 = primitive->planes();
    float *const dadx = a0 + primitive->plane_count, *const dady = dadx + primitive->plane_count;
    // Planes begin at pixels' centres with multisampling too: the reference's way.
    const auto plane = [&](int index, float first, float second) {
        const float difference = first - second;
        dadx[index] = difference * line.slope_x * line.one_over_area;
        dady[index] = difference * line.slope_y * line.one_over_area;
        a0[index] = first - (dadx[index] * (p[0] - 0.5f) + dady[index] * (p[1] - 0.5f));
    };
    const float* const oow = m_vertices.column(kWindowOow);
    plane(0, m_vertices.column(kWindowZ)[a], m_vertices.column(kWindowZ)[b]);
    plane(1, oow[a], oow[b]);
    const raster::Varyings& varyings = m_state.vertex.varyings;
    for (int i = 0; i < varyings.count; ++i) {
        const float* const column = m_vertices.column(kFirstVarying + i);
        if (m_state.raster.flat && varyings.is_color(i)) {
            a0[2 + i] = column[b];  // the last vertex provokes
            dadx[2 + i] = dady[2 + i] = 0;
        } else {
            plane(2 + i, column[a] * oow[a], column[b] * oow[b]);
        }
    }
    m_lists.add(*primitive);
}

}  // namespace terrazzo::pipeline
