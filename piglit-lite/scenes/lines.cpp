// Chapter: lines, their widths and stipple (GL 1.5 §3.4).
#include <cmath>

#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

// Lines from the middle to all sides, so that every octant and both diagonals occur.
void star(const Gl& gl, float x, float y, float radius, int rays) {
    gl.Begin(GL_LINES);
    for (int i = 0; i < rays; ++i) {
        const float a = 6.2831853F * static_cast<float>(i) / static_cast<float>(rays);
        gl.Color4fv(hue(static_cast<float>(i) / static_cast<float>(rays)).data());
        gl.Vertex2f(x + 6 * std::cos(a), y + 6 * std::sin(a));
        gl.Color4fv(hue(static_cast<float>(i) / static_cast<float>(rays) + 0.4F).data());
        gl.Vertex2f(x + radius * std::cos(a), y + radius * std::sin(a));
    }
    gl.End();
}

}  // namespace

SCENE(lines_all_octants, "one-pixel lines to all directions, diamond-exit at both ends") {
    pixel_projection(gl);
    star(gl, 128, 128, 122, 72);
}

SCENE(lines_widths, "stars of widths 1 to 11") {
    pixel_projection(gl);
    const float widths[] = {0.4F, 1.5F, 2, 2.5F, 3, 4, 5, 7.6F, 11};
    for_cells(3, 3, [&](int cell, float x, float y, float w, float) {
        gl.LineWidth(widths[cell]);
        star(gl, x + w / 2, y + w / 2, w * 0.46F, cell < 5 ? 24 : 12);
    });
    GLfloat width = 0;
    gl.GetFloatv(GL_LINE_WIDTH, &width);
    notes.value("line width", width);
}

SCENE(lines_strips_and_loops,
      "connected lines of several widths: ends of neighbours meet without doubling, shown by adding") {
    pixel_projection(gl);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ONE);
    for_cells(3, 3, [&](int cell, float x, float y, float w, float h) {
        gl.LineWidth(1 + static_cast<float>(cell / 3) * 2);
        gl.Begin(cell % 3 == 0 ? GL_LINE_STRIP : cell % 3 == 1 ? GL_LINE_LOOP : GL_LINES);
        for (int i = 0; i < 14; ++i) {
            const float a = 0.4488F * static_cast<float>(i), r = w * (i % 2 ? 0.22F : 0.45F);
            const Colour colour = hue(static_cast<float>(i) / 14, 0.45F);
            gl.Color4fv(colour.data());
            gl.Vertex2f(x + w / 2 + r * std::cos(a), y + h / 2 + r * std::sin(a));
        }
        gl.End();
    });
}

SCENE(lines_stipple, "patterns and factors on lines, strips and loops; the counter runs on along a strip") {
    pixel_projection(gl);
    gl.Enable(GL_LINE_STIPPLE);
    const GLushort patterns[] = {0xAAAA, 0x00FF, 0x0C0F, 0xF0F0, 0x1C47, 0x7FFF, 0x8001, 0x0001};
    for (int i = 0; i < 16; ++i) {
        gl.LineStipple(1 + i % 5, patterns[i % 8]);
        gl.LineWidth(i < 8 ? 1 : 3);
        gl.Color4fv(hue(static_cast<float>(i) / 16).data());
        const float y = static_cast<float>(i) * 8 + 5;
        gl.Begin(i % 2 ? GL_LINES : GL_LINE_STRIP);
        for (int k = 0; k < 8; ++k)
            gl.Vertex2f(static_cast<float>(k) * 34 + 6, y + (k % 3 == 1 ? 5.0F : 0.0F));
        gl.End();
    }
    for (int i = 0; i < 4; ++i) {
        gl.LineStipple(2 + i, patterns[i + 1]);
        gl.LineWidth(static_cast<float>(1 + i));
        gl.Begin(GL_LINE_LOOP);
        for (int k = 0; k < 7; ++k) {
            const float a = 0.8976F * static_cast<float>(k);
            gl.Color4fv(hue(static_cast<float>(k) / 7).data());
            gl.Vertex2f(static_cast<float>(i) * 63 + 34 + 28 * std::cos(a), 196 + 50 * std::sin(a));
        }
        gl.End();
    }
    GLint repeat = 0, pattern = 0;
    gl.GetIntegerv(GL_LINE_STIPPLE_REPEAT, &repeat);
    gl.GetIntegerv(GL_LINE_STIPPLE_PATTERN, &pattern);
    notes.value("repeat", repeat);
    notes.value("pattern", pattern);
}

SCENE(lines_in_perspective, "a lit, fogged, textured wire torus, lines crossing the near plane") {
    camera(gl, 70, 2, 0.8F, 6);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.Enable(GL_FOG);
    gl.Fogi(GL_FOG_MODE, GL_EXP);
    gl.Fogf(GL_FOG_DENSITY, 0.25F);
    gl.LineWidth(2);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    gl.Rotatef(70, 1, 0.3F, 0);
    draw_solid(gl, make_torus(1.4F, 0.6F, 24, 12), kNormals);
}

SCENE(lines_short_and_degenerate, "lines of length 0 to 3 pixels in 1/8 steps, and of no length") {
    pixel_projection(gl);
    for_cells(16, 16, [&](int cell, float x, float y, float, float) {
        const float length = static_cast<float>(cell % 16) * 0.375F,
                    a = static_cast<float>(cell / 16) * 0.3927F;
        gl.Color4fv(hue(static_cast<float>(cell) / 256).data());
        gl.LineWidth(cell % 32 < 16 ? 1 : 3);
        gl.Begin(GL_LINES);
        gl.Vertex2f(x + 8.5F, y + 8.3F);
        gl.Vertex2f(x + 8.5F + length * std::cos(a), y + 8.3F + length * std::sin(a));
        gl.End();
    });
}
