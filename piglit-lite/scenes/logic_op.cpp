// Chapter: logical operations on colours (GL 1.5 §4.1.10).
#include "helpers.h"

using namespace terrazzo::piglit;

SCENE(logic_op_all, "the sixteen operations between gradients") {
    pixel_projection(gl);
    striped_backdrop(gl, 16);
    gl.Enable(GL_COLOR_LOGIC_OP);
    for_cells(4, 4, [&](int cell, float x, float y, float w, float h) {
        gl.LogicOp(static_cast<GLenum>(GL_CLEAR + cell));
        gl.Begin(GL_QUADS);
        gl.Color4f(0, 0.3F, 1, 0);
        gl.Vertex2f(x + 3, y + 3);
        gl.Color4f(1, 0.6F, 0.2F, 0.3F);
        gl.Vertex2f(x + w - 3, y + 3);
        gl.Color4f(0.5F, 1, 0.4F, 1);
        gl.Vertex2f(x + w - 3, y + h - 3);
        gl.Color4f(0.1F, 0, 0.8F, 0.6F);
        gl.Vertex2f(x + 3, y + h - 3);
        gl.End();
    });
    GLint mode = 0;
    gl.GetIntegerv(GL_LOGIC_OP_MODE, &mode);
    notes.value("mode", mode);
}

SCENE(logic_op_rubber_band,
      "XOR drawn twice restores the picture; a third time shows; it overrides blending") {
    pixel_projection(gl);
    striped_backdrop(gl, 8);
    gl.Enable(GL_COLOR_LOGIC_OP);
    gl.Enable(GL_BLEND);  // logic op wins over blending
    gl.BlendFunc(GL_ZERO, GL_ZERO);
    gl.LogicOp(GL_XOR);
    gl.Color4ub(255, 170, 85, 0);
    gl.LineWidth(3);
    for (int pass = 0; pass < 3; ++pass) {
        if (pass < 2) rectangle(gl, 20, 20, 120, 120);
        gl.Begin(GL_LINE_LOOP);
        gl.Vertex2f(30, 140);
        gl.Vertex2f(220, 180);
        gl.Vertex2f(128, 245);
        gl.End();
    }
    rectangle(gl, 140, 20, 240, 120);
}
