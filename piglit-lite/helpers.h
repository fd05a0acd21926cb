// What many scenes draw with: projections, solids, patterns, colours. All deterministic.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "scene.h"

namespace terrazzo::piglit {

inline constexpr int kSize = 256;  // of a scene's default window

// Object coordinates = window coordinates (lower left origin), depth 0 at z = 0.
void pixel_projection(const Gl& gl, int width = kSize, int height = kSize);
// The camera at (0, 0, distance) looking down -z; leaves GL_MODELVIEW current.
void camera(const Gl& gl, float degrees, float distance, float near_plane = 1, float far_plane = 100);

using Colour = std::array<float, 4>;
Colour hue(float turn, float brightness = 1, float alpha = 1);  // turn 0..1 round the colour circle

// Uniform numbers from a fixed seed.
class Random {
  public:
    explicit Random(std::uint32_t seed) : m_state(seed * 2654435769U + 1) {}
    float operator()(float low, float high);
    std::uint32_t bits();

  private:
    std::uint32_t m_state;
};

// InOrder{gl.Vertex2f, random(0, 1), random(0, 1)}; is a call whose arguments are worked out from left to
// right. The order of a call's own is the compiler's, and with it which random number is x.
struct InOrder {
    template <class Command, class... Arguments>
    explicit InOrder(Command command, Arguments... arguments) {
        command(arguments...);
    }
};

struct SolidVertex {
    float position[3];
    float normal[3];
    float texture[2];
    float colour[4];
};
struct Solid {
    std::vector<SolidVertex> vertices;
    std::vector<std::uint16_t> indices;  // GL_TRIANGLES, counter-clockwise outside
};
Solid make_torus(float ring, float tube, int ring_steps, int tube_steps);
Solid make_sphere(float radius, int stacks, int slices);
Solid make_box(float half_edge);
Solid make_grid(float half_edge, int cells);  // in the xy plane, normal +z

enum SolidParts : unsigned { kPositions = 0, kNormals = 1, kTextures = 2, kColours = 4 };
void draw_solid(const Gl& gl, const Solid& solid, unsigned parts);
// A torus in light, seen by a camera of its own, turned by degrees; leaves the depth test on.
void lit_torus(const Gl& gl, float turn);

// A quad in the current coordinates; texture 0..tiles.
void rectangle(const Gl& gl, float x0, float y0, float x1, float y1, float z = 0);
void textured_rectangle(const Gl& gl, float x0, float y0, float x1, float y1, float tiles_s = 1,
                        float tiles_t = 1);
// The same running away from the camera: from y_near, z_near to y_far, z_far, `half_width` to both sides of
// the middle. All levels of detail in one picture.
struct Receding {
    float half_width, y_near, z_near, y_far, z_far;
};
void receding_rectangle(const Gl& gl, const Receding& at, float tiles_s, float tiles_t);
// Half the window, in depths from one end of the range to the other.
void sloping_triangle(const Gl& gl);
// Wide bands in changing hues over the whole window, to be seen through what is drawn next.
void striped_backdrop(const Gl& gl, int bands = 8);

inline constexpr GLenum kMinFilters[] = {GL_NEAREST,
                                         GL_LINEAR,
                                         GL_NEAREST_MIPMAP_NEAREST,
                                         GL_LINEAR_MIPMAP_NEAREST,
                                         GL_NEAREST_MIPMAP_LINEAR,
                                         GL_LINEAR_MIPMAP_LINEAR};
// How many values a pixel of a format has.
int component_count(GLenum format);
// RGBA8 texels: a shaded checker with a coloured disc, so that flips and shifts show.
std::vector<std::uint8_t> painted_texels(int width, int height, std::uint32_t seed = 1);
GLuint painted_texture(const Gl& gl, int width, int height, GLenum min_filter, GLenum mag_filter,
                       std::uint32_t seed = 1);

// All levels of the 2D texture that is bound, each in its own hue, so that the chosen level is the colour
// seen.
void coloured_levels(const Gl& gl, int width, int height, GLint format = GL_RGBA);

// Calls draw(cell, x, y, width, height) for each cell of a grid over the window, in window coordinates.
void for_cells(int columns, int rows, const std::function<void(int, float, float, float, float)>& draw);
// The same with a viewport and scissor set to the cell and restored afterwards.
void for_viewports(const Gl& gl, int columns, int rows, const std::function<void(int)>& draw);

}  // namespace terrazzo::piglit
