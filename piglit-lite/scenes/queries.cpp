// Chapter: occlusion queries (GL 1.5 §4.1.7): the counts themselves are compared.
#include <cmath>

#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

// Notes how many samples of what `draw` draws pass.
template <typename Draw>
void count(const Gl& gl, Notes& notes, const std::string& name, Draw draw) {
    GLuint query, samples = 0;
    gl.GenQueries(1, &query);
    gl.BeginQuery(GL_SAMPLES_PASSED, query);
    draw();
    gl.EndQuery(GL_SAMPLES_PASSED);
    gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &samples);
    gl.DeleteQueries(1, &query);
    notes.value(name, samples);
}

}  // namespace

SCENE(query_tests, "samples that pass the alpha, stencil, depth and scissor tests, with and without colour") {
    pixel_projection(gl);
    striped_backdrop(gl, 5);
    gl.Enable(GL_DEPTH_TEST);
    gl.Color4f(0.3F, 0.5F, 0.9F, 1);
    rectangle(gl, 40, 30, 170, 200, 0.5F);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    const auto triangle = [&] {
        gl.Begin(GL_TRIANGLES);
        gl.Color4f(1, 0, 0, 1);
        gl.Vertex3f(20.3F, 12.7F, 0.9F);
        gl.Color4f(0, 1, 0, 0);
        gl.Vertex3f(240.1F, 60.2F, -0.6F);
        gl.Color4f(0, 0, 1, 0.7F);
        gl.Vertex3f(90.6F, 244.4F, 0.2F);
        gl.End();
    };
    gl.Translatef(0, 0, 0.4F);
    count(gl, notes, "depth", triangle);
    gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl.DepthMask(GL_FALSE);
    gl.DepthFunc(GL_LEQUAL);
    count(gl, notes, "no colour", triangle);
    gl.DepthFunc(GL_GREATER);
    count(gl, notes, "hidden", triangle);
    gl.Enable(GL_ALPHA_TEST);
    gl.AlphaFunc(GL_GREATER, 0.45F);
    gl.DepthFunc(GL_ALWAYS);
    count(gl, notes, "alpha", triangle);
    gl.StencilFunc(GL_LEQUAL, 2, 0xff);
    count(gl, notes, "stencil", triangle);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(50, 60, 101, 77);
    count(gl, notes, "scissor", triangle);
    count(gl, notes, "nothing", [] {});
    gl.Disable(GL_ALPHA_TEST);
    gl.Disable(GL_STENCIL_TEST);
    gl.Disable(GL_DEPTH_TEST);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    count(gl, notes, "no tests", triangle);
}

SCENE(query_primitives,
      "points, lines, polygons as lines, stippled ones, bins left and entered, a clear afterwards") {
    pixel_projection(gl);
    const auto star = [&](GLenum mode) {
        gl.Begin(mode);
        for (int i = 0; i < 12; ++i) {
            const float a = 0.5236F * static_cast<float>(i), r = i % 2 ? 50.3F : 121.7F;
            gl.Vertex2f(128.4F + r * std::cos(a), 127.2F + r * std::sin(a));
        }
        gl.End();
    };
    const GLenum modes[] = {GL_POINTS,         GL_LINES,        GL_LINE_LOOP, GL_TRIANGLES,
                            GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS,     GL_POLYGON};
    gl.PointSize(5);
    gl.LineWidth(3);
    for (std::size_t i = 0; i < std::size(modes); ++i) {
        gl.Color4fv(hue(static_cast<float>(i) / 8).data());
        count(gl, notes, "mode " + std::to_string(i), [&] { star(modes[i]); });
    }
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    count(gl, notes, "unfilled", [&] { star(GL_QUADS); });
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    gl.Enable(GL_LINE_STIPPLE);
    gl.LineStipple(3, 0x5f13);
    count(gl, notes, "stippled", [&] { star(GL_LINE_STRIP); });
    // What a clear wipes out has been counted.
    count(gl, notes, "cleared", [&] {
        star(GL_TRIANGLE_FAN);
        gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        star(GL_LINE_LOOP);
    });
}

SCENE(query_hidden,
      "boxes behind and before a wall, each asked whether it can be seen, results fetched at the end") {
    camera(gl, 45, 6);
    gl.Enable(GL_DEPTH_TEST);
    gl.Color4f(0.4F, 0.4F, 0.5F, 1);
    rectangle(gl, -1.3F, -2, 0.9F, 2);
    const Solid box = make_box(0.35F);
    GLuint queries[16];
    gl.GenQueries(16, queries);
    for (int i = 0; i < 16; ++i) {
        gl.PushMatrix();
        gl.Translatef(static_cast<float>(i % 4) - 1.5F, static_cast<float>(i / 4) - 1.5F,
                      i % 3 ? -1.0F : 0.9F);
        gl.Rotatef(static_cast<float>(i) * 13, 1, 2, 1);
        gl.BeginQuery(GL_SAMPLES_PASSED, queries[i]);
        draw_solid(gl, box, kColours);
        gl.EndQuery(GL_SAMPLES_PASSED);
        gl.PopMatrix();
    }
    for (int i = 0; i < 16; ++i) {
        GLuint samples = 0;
        gl.GetQueryObjectuiv(queries[i], GL_QUERY_RESULT, &samples);
        notes.value("box " + std::to_string(i), samples);
    }
    gl.DeleteQueries(16, queries);
}
