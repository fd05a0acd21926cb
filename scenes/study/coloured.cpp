// T1 and T2: interpolated colours, no textures.
#include <cmath>
#include <numbers>

#include "scene_classes.h"

namespace terrazzo::study {
namespace {

constexpr int kTriangles = 8192;

// Uniform in [-1, 1].
float uniform(std::uint32_t& counter) {
    return static_cast<float>(hash(counter++, 0, 2020) >> 8) / 8388607.5F - 1;
}

void draw_pyramid(const kit::Gl& gl) {
    struct Corner {
        float colour[3], position[3];
    };
    constexpr Corner kApex{{1, 0, 0}, {0, 1, 0}};
    constexpr Corner kBase[4] = {{{0, 1, 0}, {-1, -1, 1}},
                                 {{0, 0, 1}, {1, -1, 1}},
                                 {{0, 1, 0}, {1, -1, -1}},
                                 {{0, 0, 1}, {-1, -1, -1}}};
    const auto corner = [&](const Corner& c) {
        gl.Color3fv(c.colour);
        gl.Vertex3fv(c.position);
    };
    gl.Begin(GL_TRIANGLES);
    for (int side = 0; side < 4; ++side) {
        corner(kApex);
        corner(kBase[side]);
        corner(kBase[(side + 1) % 4]);
    }
    for (const int index : {0, 3, 2, 0, 2, 1}) corner(kBase[index]);
    gl.End();
}

void draw_cube(const kit::Gl& gl) {
    constexpr float kColours[6][3] = {{0, 1, 0}, {1, 0.5F, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}};
    const Mesh cube = make_cube();
    float colours[24][3];
    for (std::size_t vertex = 0; vertex < 24; ++vertex)
        for (int channel = 0; channel < 3; ++channel)
            colours[vertex][channel] = kColours[vertex / 4][channel];
    gl.EnableClientState(GL_COLOR_ARRAY);
    gl.ColorPointer(3, GL_FLOAT, 0, colours);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.VertexPointer(3, GL_FLOAT, sizeof(Vertex), cube.vertices[0].position);
    gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(cube.indices.size()), GL_UNSIGNED_INT,
                    cube.indices.data());
    gl.DisableClientState(GL_VERTEX_ARRAY);
    gl.DisableClientState(GL_COLOR_ARRAY);
}

}  // namespace

void set_perspective(const kit::Gl& gl, double aspect, double near_plane, double far_plane) {
    const double top = near_plane * std::tan(45.0 / 2 * std::numbers::pi / 180);
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    gl.Frustum(-top * aspect, top * aspect, -top, top, near_plane, far_plane);
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadIdentity();
}

void PyramidAndCube::prepare(const kit::Gl& gl, int width, int height) {
    gl.Viewport(0, 0, width, height);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_LEQUAL);
    set_perspective(gl, static_cast<double>(width) / height, 0.1, 100);
}

void PyramidAndCube::draw(const kit::Gl& gl, int frame) {
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const auto turn = static_cast<float>(frame);
    gl.LoadIdentity();
    gl.Translatef(-1.5F, 0, -6);
    gl.Rotatef(40 + turn, 0, 1, 0);
    draw_pyramid(gl);
    gl.LoadIdentity();
    gl.Translatef(1.5F, 0, -7);
    gl.Rotatef(20 + turn, 1, 1, 1);
    draw_cube(gl);
}

RandomTriangles::RandomTriangles() {
    std::uint32_t counter = 0;
    for (int triangle = 0; triangle < kTriangles; ++triangle) {
        const float centre[2] = {uniform(counter), uniform(counter)};
        float corner[3][2];
        for (auto& point : corner)
            for (int axis = 0; axis < 2; ++axis) point[axis] = centre[axis] + 0.025F * uniform(counter);
        const float area = (corner[1][0] - corner[0][0]) * (corner[2][1] - corner[0][1]) -
                           (corner[2][0] - corner[0][0]) * (corner[1][1] - corner[0][1]);
        for (const int index : {0, area < 0 ? 2 : 1, area < 0 ? 1 : 2}) {
            m_positions.insert(m_positions.end(), {corner[index][0], corner[index][1]});
            for (int channel = 0; channel < 3; ++channel)
                m_colours.push_back(uniform(counter) < 0 ? 0.0F : 1.0F);
        }
    }
}

void RandomTriangles::prepare(const kit::Gl& gl, int width, int height) {
    gl.Viewport(0, 0, width, height);
    gl.MatrixMode(GL_MODELVIEW);
}

void RandomTriangles::draw(const kit::Gl& gl, int frame) {
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.LoadIdentity();
    if (frame != 0) gl.Rotatef(static_cast<float>(frame), 0, 0, 1);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.EnableClientState(GL_COLOR_ARRAY);
    gl.VertexPointer(2, GL_FLOAT, 0, m_positions.data());
    gl.ColorPointer(3, GL_FLOAT, 0, m_colours.data());
    gl.DrawArrays(GL_TRIANGLES, 0, 3 * kTriangles);
    gl.DisableClientState(GL_COLOR_ARRAY);
    gl.DisableClientState(GL_VERTEX_ARRAY);
}

}  // namespace terrazzo::study
