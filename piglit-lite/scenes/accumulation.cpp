// Chapter: the accumulation buffer (GL 1.5 §4.2.4).
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

void turned_square(const Gl& gl, int step) {
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadIdentity();
    gl.Rotatef(static_cast<float>(step * 5), 0, 0, 1);
    gl.Begin(GL_QUADS);
    gl.Color3f(1, 0.2F, 0.1F);
    gl.Vertex2f(-0.7F, -0.5F);
    gl.Color3f(0.1F, 1, 0.3F);
    gl.Vertex2f(0.7F, -0.5F);
    gl.Color3f(0.2F, 0.3F, 1);
    gl.Vertex2f(0.7F, 0.5F);
    gl.Color4f(1, 1, 0.5F, 0.3F);
    gl.Vertex2f(-0.7F, 0.5F);
    gl.End();
}

void blur(const Gl& gl) {
    constexpr int kPictures = 7;
    for (int i = 0; i < kPictures; ++i) {
        turned_square(gl, i);
        gl.Accum(i == 0 ? GL_LOAD : GL_ACCUM, 1.0F / kPictures);
    }
    gl.Accum(GL_RETURN, 1);
}

}  // namespace

SCENE(accumulation_blur, "the mean of seven pictures", .context = {.accum_bits = 16},
      .window_only = "objects have no accumulation buffer") {
    blur(gl);
}

SCENE(accumulation_blur_float, "the same in floats", .context = {.type = GL_FLOAT, .accum_bits = 16},
      .window_only = "objects have no accumulation buffer") {
    blur(gl);
}

SCENE(accumulation_blur_short, "the same in 16 bits",
      .context = {.type = GL_UNSIGNED_SHORT, .accum_bits = 16},
      .window_only = "objects have no accumulation buffer") {
    blur(gl);
}

SCENE(accumulation_blur_565, "the same in five and six bits",
      .context = {.format = OSMESA_RGB_565, .type = GL_UNSIGNED_SHORT_5_6_5, .accum_bits = 16},
      .window_only = "objects have no accumulation buffer") {
    blur(gl);
}

// Within the range: the reference lets sums beyond it wrap round.
SCENE(accumulation_operations, "each operation with many values, scissored, masked and cleared",
      .context = {.accum_bits = 16}, .window_only = "objects have no accumulation buffer") {
    pixel_projection(gl);
    striped_backdrop(gl, 21);
    gl.Enable(GL_SCISSOR_TEST);
    constexpr float kValues[] = {0.5F, 1.25F, -0.25F, 0.125F};
    for_cells(4, 4, [&](int cell, float x, float y, float w, float h) {
        gl.Scissor(static_cast<GLint>(x) + 3, static_cast<GLint>(y) + 2, static_cast<GLsizei>(w) - 5,
                   static_cast<GLsizei>(h) - 6);
        const float clear = 0.1F * static_cast<float>(cell % 5);
        gl.ClearAccum(clear, -clear, 0.3F, 0.2F);
        gl.Clear(GL_ACCUM_BUFFER_BIT);
        gl.Accum(GL_ACCUM, 0.3F);
        if (cell / 4 == 1) gl.Accum(GL_MULT, kValues[cell % 4]);
        if (cell / 4 == 2) gl.Accum(GL_ADD, kValues[cell % 4] * 0.2F);
        if (cell / 4 == 3) gl.Accum(GL_LOAD, kValues[cell % 4] * 0.6F);
        gl.ColorMask(1, cell % 3 != 1, 1, cell % 2 == 0);
        gl.Accum(GL_RETURN, cell % 2 ? 1 : 1.7F);
        gl.ColorMask(1, 1, 1, 1);
    });
    GLint bits[4] = {};
    gl.GetIntegerv(GL_ACCUM_RED_BITS, bits);
    gl.GetIntegerv(GL_ACCUM_GREEN_BITS, bits + 1);
    gl.GetIntegerv(GL_ACCUM_BLUE_BITS, bits + 2);
    gl.GetIntegerv(GL_ACCUM_ALPHA_BITS, bits + 3);
    notes.values("bits", bits);
    gl.Accum(GL_ADD_SIGNED, 1);
    notes.value("no operation", gl.GetError());
}

SCENE(accumulation_missing, "a context without", .draws_nothing_visible = true) {
    gl.Accum(GL_RETURN, 1);
    notes.value("error", gl.GetError());
    gl.Clear(GL_ACCUM_BUFFER_BIT);
    notes.value("clear", gl.GetError());
    GLint bits = -1;
    gl.GetIntegerv(GL_ACCUM_RED_BITS, &bits);
    notes.value("bits", bits);
}
