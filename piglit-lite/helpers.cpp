// What many scenes draw with: projections, solids, patterns, colours.
#include "helpers.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace terrazzo::piglit {
namespace {

constexpr float kTurn = 2 * std::numbers::pi_v<float>;

void index_grid(Solid& solid, int columns, int rows) {
    const auto at = [&](int x, int y) { return static_cast<std::uint16_t>(y * (columns + 1) + x); };
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
            solid.indices.insert(solid.indices.end(), {at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y),
                                                       at(x + 1, y + 1), at(x, y + 1)});
}

void push(Solid& solid, std::array<float, 3> position, std::array<float, 3> normal, float s, float t) {
    const Colour colour = hue(s + 0.35F * t);
    solid.vertices.push_back({{position[0], position[1], position[2]},
                              {normal[0], normal[1], normal[2]},
                              {s, t},
                              {colour[0], colour[1], colour[2], 0.35F + 0.65F * t}});
}

}  // namespace

void pixel_projection(const Gl& gl, int width, int height) {
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    gl.Ortho(0, width, 0, height, -1, 1);
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadIdentity();
}

void camera(const Gl& gl, float degrees, float distance, float near_plane, float far_plane) {
    const double top = near_plane * std::tan(degrees * std::numbers::pi / 360);
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    gl.Frustum(-top, top, -top, top, near_plane, far_plane);
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadIdentity();
    gl.Translatef(0, 0, -distance);
}

Colour hue(float turn, float brightness, float alpha) {
    const auto channel = [&](float offset) {
        return brightness * (0.55F + 0.45F * std::cos(kTurn * (turn - offset)));
    };
    return {channel(0), channel(1.0F / 3), channel(2.0F / 3), alpha};
}

std::uint32_t Random::bits() {
    m_state ^= m_state << 13;
    m_state ^= m_state >> 17;
    m_state ^= m_state << 5;
    return m_state;
}

float Random::operator()(float low, float high) {
    return low + (high - low) * static_cast<float>(bits() >> 8) / 16777216.0F;
}

Solid make_torus(float ring, float tube, int ring_steps, int tube_steps) {
    Solid solid;
    for (int j = 0; j <= tube_steps; ++j)
        for (int i = 0; i <= ring_steps; ++i) {
            const float s = static_cast<float>(i) / static_cast<float>(ring_steps);
            const float t = static_cast<float>(j) / static_cast<float>(tube_steps);
            const float a = kTurn * s, b = kTurn * t;
            const std::array<float, 3> normal{std::cos(a) * std::cos(b), std::sin(a) * std::cos(b),
                                              std::sin(b)};
            push(solid,
                 {std::cos(a) * (ring + tube * std::cos(b)), std::sin(a) * (ring + tube * std::cos(b)),
                  tube * std::sin(b)},
                 normal, s, t);
        }
    index_grid(solid, ring_steps, tube_steps);
    return solid;
}

Solid make_sphere(float radius, int stacks, int slices) {
    Solid solid;
    for (int j = 0; j <= stacks; ++j)
        for (int i = 0; i <= slices; ++i) {
            const float s = static_cast<float>(i) / static_cast<float>(slices);
            const float t = static_cast<float>(j) / static_cast<float>(stacks);
            const float a = kTurn * s, b = kTurn / 2 * (t - 0.5F);
            const std::array<float, 3> n{std::sin(a) * std::cos(b), std::sin(b), std::cos(a) * std::cos(b)};
            push(solid, {radius * n[0], radius * n[1], radius * n[2]}, n, s, t);
        }
    index_grid(solid, slices, stacks);
    return solid;
}

Solid make_box(float half_edge) {
    constexpr float kFaces[6][3][3] = {
        {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}},
        {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
        {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}}, {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}};
    Solid solid;
    for (const auto& [normal, right, up] : kFaces) {
        const auto first = static_cast<std::uint16_t>(solid.vertices.size());
        for (const auto& [s, t] : {std::array{0.0F, 0.0F}, {1.0F, 0.0F}, {1.0F, 1.0F}, {0.0F, 1.0F}}) {
            std::array<float, 3> position;
            for (std::size_t axis = 0; axis < 3; ++axis)
                position[axis] =
                    half_edge * (normal[axis] + (2 * s - 1) * right[axis] + (2 * t - 1) * up[axis]);
            push(solid, position, {normal[0], normal[1], normal[2]}, s, t);
        }
        for (const int offset : {0, 1, 2, 0, 2, 3})
            solid.indices.push_back(static_cast<std::uint16_t>(first + offset));
    }
    return solid;
}

Solid make_grid(float half_edge, int cells) {
    Solid solid;
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) {
            const float s = static_cast<float>(i) / static_cast<float>(cells);
            const float t = static_cast<float>(j) / static_cast<float>(cells);
            push(solid, {half_edge * (2 * s - 1), half_edge * (2 * t - 1), 0}, {0, 0, 1}, s, t);
        }
    index_grid(solid, cells, cells);
    return solid;
}

void draw_solid(const Gl& gl, const Solid& solid, unsigned parts) {
    const SolidVertex& first = solid.vertices[0];
    constexpr GLsizei kStride = sizeof(SolidVertex);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.VertexPointer(3, GL_FLOAT, kStride, first.position);
    if (parts & kNormals) gl.EnableClientState(GL_NORMAL_ARRAY);
    gl.NormalPointer(GL_FLOAT, kStride, first.normal);
    if (parts & kTextures) gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
    gl.TexCoordPointer(2, GL_FLOAT, kStride, first.texture);
    if (parts & kColours) gl.EnableClientState(GL_COLOR_ARRAY);
    gl.ColorPointer(4, GL_FLOAT, kStride, first.colour);
    gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(solid.indices.size()), GL_UNSIGNED_SHORT,
                    solid.indices.data());
    for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_COLOR_ARRAY})
        gl.DisableClientState(array);
}

void lit_torus(const Gl& gl, float turn) {
    camera(gl, 45, 3);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.Rotatef(turn, 1, 0.4F, 0);
    draw_solid(gl, make_torus(0.8F, 0.35F, 28, 14), kNormals);
    gl.Disable(GL_LIGHTING);
}

void rectangle(const Gl& gl, float x0, float y0, float x1, float y1, float z) {
    gl.Begin(GL_QUADS);
    gl.Vertex3f(x0, y0, z);
    gl.Vertex3f(x1, y0, z);
    gl.Vertex3f(x1, y1, z);
    gl.Vertex3f(x0, y1, z);
    gl.End();
}

void textured_rectangle(const Gl& gl, float x0, float y0, float x1, float y1, float tiles_s, float tiles_t) {
    gl.Begin(GL_QUADS);
    gl.TexCoord2f(0, 0);
    gl.Vertex2f(x0, y0);
    gl.TexCoord2f(tiles_s, 0);
    gl.Vertex2f(x1, y0);
    gl.TexCoord2f(tiles_s, tiles_t);
    gl.Vertex2f(x1, y1);
    gl.TexCoord2f(0, tiles_t);
    gl.Vertex2f(x0, y1);
    gl.End();
}

void receding_rectangle(const Gl& gl, const Receding& at, float tiles_s, float tiles_t) {
    gl.Begin(GL_QUADS);
    gl.TexCoord2f(0, 0);
    gl.Vertex3f(-at.half_width, at.y_near, at.z_near);
    gl.TexCoord2f(tiles_s, 0);
    gl.Vertex3f(at.half_width, at.y_near, at.z_near);
    gl.TexCoord2f(tiles_s, tiles_t);
    gl.Vertex3f(at.half_width, at.y_far, at.z_far);
    gl.TexCoord2f(0, tiles_t);
    gl.Vertex3f(-at.half_width, at.y_far, at.z_far);
    gl.End();
}

void sloping_triangle(const Gl& gl) {
    gl.Begin(GL_TRIANGLES);
    gl.Vertex3f(0, 0, -0.9F);
    gl.Vertex3f(256, 0, 0.9F);
    gl.Vertex3f(0, 256, 0.2F);
    gl.End();
}

void striped_backdrop(const Gl& gl, int bands) {
    const float width = static_cast<float>(kSize) / static_cast<float>(bands);
    for (int band = 0; band < bands; ++band) {
        const auto x = static_cast<float>(band);
        const Colour colour =
            hue(x / static_cast<float>(bands), 0.8F, 0.25F + 0.75F * x / static_cast<float>(bands));
        gl.Color4fv(colour.data());
        rectangle(gl, x * width, 0, (x + 1) * width, kSize);
    }
}

int component_count(GLenum format) {
    switch (format) {
        case GL_RGB:
        case GL_BGR:
            return 3;
        case GL_RGBA:
        case GL_BGRA:
            return 4;
        case GL_LUMINANCE_ALPHA:
            return 2;
        default:
            return 1;
    }
}

std::vector<std::uint8_t> painted_texels(int width, int height, std::uint32_t seed) {
    std::vector<std::uint8_t> texels;
    texels.reserve(static_cast<std::size_t>(width) * height * 4);
    const int cell = std::max(1, std::min(width, height) / 8);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const bool light = (x / cell + y / cell) % 2 == 0;
            const int dx = 2 * x - width / 2, dy = 2 * y - height * 3 / 2;
            const bool disc =
                dx * dx * 4 / (width * width / 4 + 1) + dy * dy * 4 / (height * height / 4 + 1) < 1;
            const int base = light ? 190 : 70;
            const int r = disc ? 250 : base * x / width + 30 + static_cast<int>(seed * 53 % 64);
            const int g = disc ? 60 + x % 32 : base * y / height + 20;
            const int b = disc ? 40 : 230 - base / 2 + static_cast<int>(seed * 29 % 24);
            for (const int value : {r, g, b, light ? 255 : 40 + 180 * y / height})
                texels.push_back(static_cast<std::uint8_t>(std::min(255, std::max(0, value))));
        }
    return texels;
}

GLuint painted_texture(const Gl& gl, int width, int height, GLenum min_filter, GLenum mag_filter,
                       std::uint32_t seed) {
    GLuint name = 0;
    gl.GenTextures(1, &name);
    gl.BindTexture(GL_TEXTURE_2D, name);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(min_filter));
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(mag_filter));
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  painted_texels(width, height, seed).data());
    return name;
}

void coloured_levels(const Gl& gl, int width, int height, GLint format) {
    for (int level = 0;; ++level) {
        const int w = std::max(1, width >> level), h = std::max(1, height >> level);
        auto texels = painted_texels(w, h);
        const Colour tint = hue(static_cast<float>(level) / 7);
        for (std::size_t i = 0; i < texels.size(); ++i)
            texels[i] = static_cast<std::uint8_t>(static_cast<float>(texels[i] / 2 + 100) * tint[i % 4]);
        gl.TexImage2D(GL_TEXTURE_2D, level, format, w, h, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
        if (w == 1 && h == 1) return;
    }
}

void for_cells(int columns, int rows, const std::function<void(int, float, float, float, float)>& draw) {
    const float width = static_cast<float>(kSize) / static_cast<float>(columns);
    const float height = static_cast<float>(kSize) / static_cast<float>(rows);
    for (int cell = 0; cell < columns * rows; ++cell)
        draw(cell, static_cast<float>(cell % columns) * width, static_cast<float>(cell / columns) * height,
             width, height);
}

void for_viewports(const Gl& gl, int columns, int rows, const std::function<void(int)>& draw) {
    for_cells(columns, rows, [&](int cell, float x, float y, float width, float height) {
        gl.Viewport(static_cast<GLint>(x), static_cast<GLint>(y), static_cast<GLsizei>(width),
                    static_cast<GLsizei>(height));
        draw(cell);
    });
    gl.Viewport(0, 0, kSize, kSize);
}

}  // namespace terrazzo::piglit
