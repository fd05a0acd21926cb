// Sheets of waves, cut into each kind of primitive.
#include "geometry.h"

#include <cmath>

namespace terrazzo::states {
namespace {

constexpr float kTextureRepeats = 3;
// So that lines of the mesh do not run along edges of texels, where a rounding decides which one is nearest.
constexpr float kTextureStart[2] = {0.0137F, 0.0191F};

// Centre and extent; the eye looks along -z from the origin and sees 3 by 3 at z = -3.
struct Sheet {
    float centre[3];
    float extent[2];
};
constexpr Sheet kSheets[] = {{{-0.25F, -0.2F, -3.2F}, {2.6F, 2.7F}},
                             {{0.45F, 0.4F, -2.8F}, {1.7F, 1.6F}},
                             {{-0.6F, -0.7F, -2.6F}, {1.1F, 0.9F}}};

float wave(float u, float v) {
    return 0.12F * std::sin(7 * u) * std::cos(5 * v);
}

void set_normal(Vertex& vertex, const Sheet& sheet, float u, float v) {
    // The upper edge is farther away, by as much as set_position() says.
    const float du = 0.84F * std::cos(7 * u) * std::cos(5 * v) / sheet.extent[0];
    const float dv = (-0.6F * std::sin(7 * u) * std::sin(5 * v) - 0.8F) / sheet.extent[1];
    const float length = std::sqrt(du * du + dv * dv + 1);
    vertex.normal[0] = -du / length;
    vertex.normal[1] = -dv / length;
    vertex.normal[2] = 1 / length;
}

void set_colour(Vertex& vertex, float u, float v, int sheet) {
    const float colour[4] = {0.25F + 0.75F * u, 0.9F - 0.6F * v,
                             sheet % 2 ? 0.8F - 0.5F * u : 0.3F + 0.5F * v,
                             0.3F + 0.7F * (sheet % 2 ? v : u)};
    for (int i = 0; i < 4; ++i) {
        vertex.colour[i] = colour[i];
        vertex.colour_bytes[i] = static_cast<std::uint8_t>(std::lround(colour[i] * 255));
    }
}

Vertex make_vertex(int sheet_number, float u, float v) {
    const Sheet& sheet = kSheets[sheet_number];
    Vertex vertex{};
    vertex.position[0] = sheet.centre[0] + (u - 0.5F) * sheet.extent[0];
    vertex.position[1] = sheet.centre[1] + (v - 0.5F) * sheet.extent[1];
    vertex.position[2] = sheet.centre[2] - 0.8F * (v - 0.5F) + wave(u, v);
    set_normal(vertex, sheet, u, v);
    set_colour(vertex, u, v, sheet_number);
    vertex.texture[0] = kTextureRepeats * u + kTextureStart[0];
    vertex.texture[1] = kTextureRepeats * v + kTextureStart[1];
    vertex.texture[2] = (u + v) / 2;
    vertex.direction[0] = 2.4F * u - 1.2F;
    vertex.direction[1] = 2.4F * v - 1.2F;
    vertex.direction[2] = 0.9F;
    vertex.light_map[0] = u + kTextureStart[0];
    vertex.light_map[1] = v + kTextureStart[1];
    return vertex;
}

// Corners of a cell in the order of a quad, counter-clockwise unless the sheet shows its back.
using Corners = std::array<GLuint, 4>;

class Sheeted {
  public:
    Sheeted(Mesh& mesh, int cells) : m_mesh(mesh), m_cells(cells) {}

    void add_sheet(int number) {
        m_first = static_cast<GLuint>(m_mesh.vertices.size());
        m_is_back = number % 2;
        for (int y = 0; y <= m_cells; ++y)
            for (int x = 0; x <= m_cells; ++x)
                m_mesh.vertices.push_back(make_vertex(number, part(x), part(y)));
        for (int y = 0; y < m_cells; ++y) add_row(y);
        // The last row and column of lines, the last of points.
        if (is_open_ended()) add_row(m_cells);
    }

  private:
    float part(int cell) const { return static_cast<float>(cell) / static_cast<float>(m_cells); }
    GLuint at(int x, int y) const { return m_first + static_cast<GLuint>(y * (m_cells + 1) + x); }
    bool is_open_ended() const {
        return m_mesh.mode == GL_LINES || m_mesh.mode == GL_LINE_STRIP || m_mesh.mode == GL_POINTS;
    }
    Corners corners(int x, int y) const {
        if (m_is_back) return {at(x, y), at(x, y + 1), at(x + 1, y + 1), at(x + 1, y)};
        return {at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)};
    }
    void add(std::initializer_list<GLuint> indices) {
        m_mesh.indices.insert(m_mesh.indices.end(), indices.begin(), indices.end());
    }
    // What of the row is one run with the row before it.
    bool runs_on() const {
        return m_mesh.mode == GL_TRIANGLES || m_mesh.mode == GL_QUADS || m_mesh.mode == GL_LINES ||
               m_mesh.mode == GL_POINTS;
    }
    void end_run(GLsizei first) {
        const GLsizei count = static_cast<GLsizei>(m_mesh.indices.size()) - first;
        if (runs_on() && !m_mesh.runs.empty())
            m_mesh.runs.back().count += count;
        else
            m_mesh.runs.push_back({first, count});
    }

    void add_row(int y) {
        const auto first = static_cast<GLsizei>(m_mesh.indices.size());
        if (is_open_ended())
            add_lines(y);
        else if (m_mesh.mode == GL_TRIANGLE_STRIP || m_mesh.mode == GL_QUAD_STRIP)
            add_strip(y);
        else if (m_mesh.mode == GL_TRIANGLE_FAN)
            add_fans(y);
        else
            add_cells(y);
        if (m_mesh.mode != GL_TRIANGLE_FAN) end_run(first);
    }
    void add_cells(int y) {
        for (int x = 0; x < m_cells; ++x) {
            const Corners c = corners(x, y);
            if (m_mesh.mode == GL_QUADS)
                add({c[0], c[1], c[2], c[3]});
            else
                add({c[0], c[1], c[2], c[0], c[2], c[3]});
        }
    }
    void add_strip(int y) {
        const int first = m_is_back ? y : y + 1, second = m_is_back ? y + 1 : y;
        for (int x = 0; x <= m_cells; ++x) add({at(x, first), at(x, second)});
    }
    // Eight triangles around each second corner of each second row.
    void add_fans(int y) {
        constexpr int kRing[9][2] = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}, {0, 0}};
        if (y % 2) return;
        for (int x = 0; x + 1 < m_cells; x += 2) {
            const auto first = static_cast<GLsizei>(m_mesh.indices.size());
            add({at(x + 1, y + 1)});
            for (int i = 0; i < 9; ++i) {
                const auto& [dx, dy] = kRing[m_is_back ? 8 - i : i];
                add({at(x + dx, y + dy)});
            }
            end_run(first);
        }
    }
    void add_lines(int y) {
        for (int x = 0; x <= m_cells; ++x) {
            if (m_mesh.mode != GL_LINES) {
                add({at(x, y)});
                continue;
            }
            if (x < m_cells) add({at(x, y), at(x + 1, y)});
            if (y < m_cells) add({at(x, y), at(x, y + 1)});
        }
    }

    Mesh& m_mesh;
    int m_cells;
    GLuint m_first = 0;
    bool m_is_back = false;
};

}  // namespace

Mesh make_mesh(int cells, int sheets, GLenum mode) {
    Mesh mesh;
    mesh.mode = mode;
    Sheeted sheeted(mesh, cells);
    for (int i = 0; i < sheets; ++i) sheeted.add_sheet(i);
    return mesh;
}

}  // namespace terrazzo::states
