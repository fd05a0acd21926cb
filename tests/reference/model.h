// An executable form of doc/reference.md §2-4: what the reference library does to one triangle, line or
// point, from clip coordinates to float pixels. Slow and plain on purpose: tests compare it with the library,
// and the pipeline's stages with it. Image rows run downwards, as in the library; all arithmetic is single
// precision with fused steps written out.
#pragma once

#include <array>
#include <vector>

namespace terrazzo::test::model {

using Float4 = std::array<float, 4>;

struct Viewport {
    float scale[3], translate[3];
};

/// glViewport and glDepthRange on a window surface of the given height.
Viewport make_viewport(int x, int y, int width, int height, double near, double far, int surface_height);

struct Vertex {
    Float4 clip;
    Float4 window;  // x, y, z, 1/w
    Float4 colour;
};

/// The product of a matrix (column-major) and a position.
Float4 transform(const float matrix[16], const Float4& position);

/// Fills in the window coordinates of a vertex that was not clipped.
void project(Vertex& vertex, const Viewport& viewport);

/// The triangles that are left, fanned; none if nothing is.
std::vector<std::array<Vertex, 3>> clip_triangle(const std::array<Vertex, 3>& triangle,
                                                 const Viewport& viewport);

/// Whether anything of the line is left; moves its ends.
bool clip_line(Vertex& a, Vertex& b, const Viewport& viewport);

bool point_visible(const Vertex& point);

struct Pixel {
    bool covered = false;
    Float4 colour{};
    float z = 0;
};

struct Image {
    Image(int w, int h) : width(w), height(h), pixels(static_cast<std::size_t>(w) * h) {}

    Pixel& at(int x, int y) { return pixels[static_cast<std::size_t>(y) * width + x]; }

    int width, height;
    std::vector<Pixel> pixels;
};

struct PolygonOffset {
    float factor = 0, units = 0;
    int depth_bits = 24;
};

void draw_triangle(Image& image, std::array<Vertex, 3> triangle, const PolygonOffset& offset = {});
void draw_line(Image& image, const Vertex& start, const Vertex& end, float width);
void draw_point(Image& image, const Vertex& point, float size);

}  // namespace terrazzo::test::model
