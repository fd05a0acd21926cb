// The primitives of the coverage suite: cells of 32 points, lines or triangles each, made from a seed and a
// number.
//
// Half of the cells give window coordinates, through an orthographic projection and a viewport of the same
// size: exactly where that is a power of two, as in most cells. The other half stand in a random frustum,
// behind a random modelview.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kit/library.h"

namespace terrazzo::coverage {

inline constexpr int kCellPrimitives = 32;

enum class Family : uint8_t {
    kRandom,         // in and round the cell
    kSliver,         // one edge short, or all vertices nearly on a line
    kSubPixel,       // smaller than two pixels
    kLattice,        // on pixel centres, borders and other multiples of 1/2 to 1/256
    kScreenFilling,  // reaching over all sides
    kOffScreen,      // outside, or barely inside
    kNear,           // cut by the near or the far plane, or behind the eye
    kDegenerate,     // of equal vertices, or on a line
    kNotFinite,      // with infinite, enormous or undefined coordinates
};
// What of kNotFinite is made. Some vertices have no window position, and the reference, whose integers
// overflow, draws anything (doc/reference.md §3.2): in perspective infinite ones; where an edge leads through
// the eye; where rounding leaves nothing of a cut because the ends are enormous to both sides or of different
// sizes.
enum class Strays : uint8_t { kComparable, kAll };
inline constexpr int kFamilies = 9;
const char* name(Family family);

struct Rectangle {
    int x, y, width, height;
};

struct Cell {
    bool perspective;
    Family family;
    GLenum mode;  // GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_TRIANGLES, GL_TRIANGLE_STRIP or GL_TRIANGLE_FAN
    float size;   // of points, or width of lines
    std::array<double, 6> volume;    // of glOrtho or glFrustum
    std::array<float, 7> placement;  // glRotatef's four arguments and glTranslatef's three
    std::vector<std::array<float, 4>> vertices;
};

// The cell of that number, to be drawn to a viewport of that size.
Cell make_cell(uint32_t seed, uint32_t number, bool perspective, int width, int height,
               Strays strays = Strays::kComparable);

// Every second row of families is in perspective.
inline bool is_perspective(uint32_t cell) {
    return cell / kFamilies % 2 != 0;
}

// The vertices of one primitive of the cell.
std::vector<std::array<float, 4>> vertices_of(const Cell& cell, uint32_t primitive);

// Draws the cell; primitive i adds 2^i to the pixels it covers, its bits spread over R, G, B and A.
void draw(const kit::Gl& gl, const Cell& cell, const Rectangle& viewport);

}  // namespace terrazzo::coverage
