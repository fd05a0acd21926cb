// Chapter: the client's buffer in OSMesa's formats and types, orders of rows and row lengths.
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

// Gradients, a textured patch and a translucent disc: rounding, byte order and row order all show.
void emblem(const Gl& gl) {
    pixel_projection(gl);
    gl.Begin(GL_QUADS);
    gl.Color4f(1, 0.1F, 0, 1), gl.Vertex2f(10, 10);
    gl.Color4f(0, 0.9F, 0.2F, 0.7F), gl.Vertex2f(246, 10);
    gl.Color4f(0.1F, 0.2F, 1, 0.4F), gl.Vertex2f(246, 180);
    gl.Color4f(0.9F, 0.9F, 0.9F, 0.1F), gl.Vertex2f(10, 180);
    gl.End();
    gl.Enable(GL_TEXTURE_2D);
    painted_texture(gl, 32, 32, GL_LINEAR, GL_LINEAR);
    gl.Color4f(1, 1, 1, 1);
    textured_rectangle(gl, 20, 120, 110, 245);
    gl.Disable(GL_TEXTURE_2D);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl.Color4f(1, 0.8F, 0.1F, 0.5F);
    gl.Begin(GL_TRIANGLES);
    gl.Vertex2f(60, 40);
    gl.Vertex2f(230, 90);
    gl.Vertex2f(170, 240);
    gl.End();
}

}  // namespace

SCENE(buffer_rgba, "RGBA bytes, rows from the bottom") {
    emblem(gl);
}
SCENE(buffer_bgra, "BGRA bytes", .context = {.format = OSMESA_BGRA}) {
    emblem(gl);
}
SCENE(buffer_argb, "ARGB bytes", .context = {.format = OSMESA_ARGB}) {
    emblem(gl);
}
// llvmpipe's own three-byte buffers come out garbled, so the reference is its RGBA picture.
SCENE(buffer_rgb, "RGB bytes", .context = {.format = OSMESA_RGB}, .reference_in_rgba = true) {
    emblem(gl);
}
SCENE(buffer_565, "RGB_565 shorts", .context = {.format = OSMESA_RGB_565, .type = GL_UNSIGNED_SHORT_5_6_5}) {
    emblem(gl);
}
SCENE(buffer_rgba_shorts, "RGBA of 16 bits a component", .context = {.type = GL_UNSIGNED_SHORT}) {
    emblem(gl);
}
SCENE(buffer_rgba_floats, "RGBA floats", .context = {.type = GL_FLOAT}) {
    emblem(gl);
}
SCENE(buffer_rgb_floats, "RGB floats, as MuJoCo-like clients ask",
      .context = {.format = OSMESA_RGB, .type = GL_FLOAT}) {
    emblem(gl);
}
SCENE(buffer_y_down, "rows from the top (OSMESA_Y_UP 0)", .context = {.y_up = false}) {
    emblem(gl);
}
SCENE(buffer_row_length, "rows longer than the picture (OSMESA_ROW_LENGTH)", .context = {.row_length = 300}) {
    emblem(gl);
}
SCENE(buffer_odd_size, "a width and height that no tile divides", .context = {.width = 251, .height = 131}) {
    emblem(gl);
}
SCENE(buffer_tiny, "three pixels by two", .context = {.width = 3, .height = 2}) {
    gl.Begin(GL_TRIANGLES);
    gl.Color3f(1, 0, 0), gl.Vertex2f(-1, -1);
    gl.Color3f(0, 1, 0), gl.Vertex2f(1.2F, -1);
    gl.Color3f(0, 0, 1), gl.Vertex2f(-1, 1.4F);
    gl.End();
}
SCENE(buffer_large, "1500 by 900 pixels", .context = {.width = 1500, .height = 900}) {
    gl.Viewport(0, 0, 1500, 900);
    camera(gl, 45, 4);
    gl.Enable(GL_DEPTH_TEST);
    gl.Rotatef(-50, 1, 0.3F, 0);
    draw_solid(gl, make_torus(1.1F, 0.5F, 60, 30), kColours);
}
SCENE(buffer_float_clamping, "what a float buffer holds of colours beyond 0..1",
      .context = {.type = GL_FLOAT}) {
    pixel_projection(gl);
    gl.ClearColor(1.5F, -0.5F, 0.3F, 2);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(10, 10, 100, 100);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Disable(GL_SCISSOR_TEST);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ONE);
    for (int i = 0; i < 3; ++i) {
        gl.Color4f(0.7F, 0.4F, 0.9F, 0.6F);
        rectangle(gl, 60 + static_cast<float>(i) * 30, 60, 200, 240);
    }
}
