// Chapter: scissor, colour mask, clears, draw buffer (GL 1.5 §4.1.2, §4.2).
#include "helpers.h"

using namespace terrazzo::piglit;

SCENE(scissor_boxes, "overlapping scissor boxes, some outside the window and some empty") {
    gl.Enable(GL_SCISSOR_TEST);
    const GLint boxes[][4] = {{0, 0, 100, 100},     {90, 10, 1, 200},  {120, -30, 200, 100},
                              {-20, 130, 100, 300}, {100, 120, 0, 50}, {101, 121, 77, 33},
                              {150, 180, 64, 64},   {63, 63, 65, 65},  {255, 255, 9, 9}};
    int i = 0;
    for (const auto& box : boxes) {
        gl.Scissor(box[0], box[1], box[2], box[3]);
        gl.Begin(GL_TRIANGLE_FAN);
        gl.Color4fv(hue(static_cast<float>(i) / 9).data());
        gl.Vertex2f(0, 0);
        gl.Color4fv(hue(static_cast<float>(i) / 9 + 0.3F).data());
        for (const auto& [x, y] :
             {std::array{-1.0F, -1.0F}, {1.0F, -1.0F}, {1.0F, 1.0F}, {-1.0F, 1.0F}, {-1.0F, -1.0F}})
            gl.Vertex2f(x, y);
        gl.End();
        ++i;
    }
    GLint box[4];
    gl.GetIntegerv(GL_SCISSOR_BOX, box);
    notes.values("box", box);
}

SCENE(scissor_primitives, "points, lines and bitmaps of triangles cut by a slanting row of scissors") {
    pixel_projection(gl);
    gl.Enable(GL_SCISSOR_TEST);
    gl.PointSize(20);
    gl.LineWidth(7);
    for (int i = 0; i < 16; ++i) {
        gl.Scissor(i * 16 + 2, i * 9 + 10, 12, 100);
        gl.Begin(GL_POINTS);
        gl.Color4fv(hue(static_cast<float>(i) / 16).data());
        gl.Vertex2f(static_cast<float>(i) * 16 + 3, static_cast<float>(i) * 9 + 20);
        gl.End();
        gl.Begin(GL_LINES);
        gl.Vertex2f(0, 60);
        gl.Vertex2f(256, 200);
        gl.End();
        gl.Color4fv(hue(static_cast<float>(i) / 16 + 0.5F).data());
        gl.Begin(GL_TRIANGLES);
        gl.Vertex2f(0, 70);
        gl.Vertex2f(256, 150);
        gl.Vertex2f(256, 240);
        gl.End();
    }
}

SCENE(mask_colours, "all sixteen colour masks, on drawing and on clearing") {
    pixel_projection(gl);
    gl.Enable(GL_SCISSOR_TEST);
    for_cells(4, 4, [&](int cell, float x, float y, float w, float h) {
        gl.Scissor(static_cast<GLint>(x) + 2, static_cast<GLint>(y) + 2, static_cast<GLsizei>(w) - 4,
                   static_cast<GLsizei>(h) - 4);
        gl.ColorMask(cell & 1, cell >> 1 & 1, cell >> 2 & 1, cell >> 3 & 1);
        gl.ClearColor(0.8F, 0.6F, 0.9F, 0.4F);
        gl.Clear(GL_COLOR_BUFFER_BIT);
        gl.Begin(GL_TRIANGLES);
        gl.Color4f(1, 0.1F, 0.2F, 0.9F);
        gl.Vertex2f(x + 6, y + 6);
        gl.Color4f(0.1F, 1, 0.2F, 0.1F);
        gl.Vertex2f(x + w - 6, y + 6);
        gl.Color4f(0.2F, 0.1F, 1, 0.6F);
        gl.Vertex2f(x + w / 2, y + h - 6);
        gl.End();
    });
    GLboolean mask[4];
    gl.GetBooleanv(GL_COLOR_WRITEMASK, mask);
    notes.values("mask", mask);
}

SCENE(mask_blend_together, "colour masks with blending, logic op off and on") {
    pixel_projection(gl);
    striped_backdrop(gl, 8);
    for_cells(4, 2, [&](int cell, float x, float y, float w, float h) {
        gl.ColorMask(cell != 0, cell != 1, cell != 2, cell != 3);
        if (cell < 4)
            gl.Enable(GL_BLEND), gl.BlendFunc(GL_SRC_ALPHA, GL_ONE);
        else
            gl.Enable(GL_COLOR_LOGIC_OP), gl.LogicOp(GL_INVERT);
        gl.Color4f(0.5F, 0.6F, 0.7F, 0.5F);
        rectangle(gl, x + 4, y + 4, x + w - 4, y + h - 4);
    });
}

SCENE(clear_values, "clears of colour, depth and stencil in every combination inside scissor boxes") {
    pixel_projection(gl);
    gl.Enable(GL_SCISSOR_TEST);
    for (int cell = 0; cell < 8; ++cell) {
        gl.Scissor(cell % 4 * 64 + 3, cell / 4 * 128 + 3, 58, 122);
        gl.ClearColor(0.1F * static_cast<float>(cell), 1.5F, -1, 0.5F);
        gl.ClearDepth(0.1 * cell);
        gl.ClearStencil(cell * 40);
        gl.Clear((cell & 1 ? GL_COLOR_BUFFER_BIT : 0U) | (cell & 2 ? GL_DEPTH_BUFFER_BIT : 0U) |
                 (cell & 4 ? GL_STENCIL_BUFFER_BIT : 0U));
    }
    GLfloat colour[4];
    gl.GetFloatv(GL_COLOR_CLEAR_VALUE, colour);
    notes.values("clear colour", colour, 1e-6);
    GLint stencil = 0;
    gl.GetIntegerv(GL_STENCIL_CLEAR_VALUE, &stencil);
    notes.value("clear stencil", stencil);
}

SCENE(clear_masked_stencil_and_depth, "clears obey the stencil write mask and the depth mask") {
    pixel_projection(gl);
    gl.Enable(GL_SCISSOR_TEST);
    gl.ClearColor(0.6F, 0.3F, 0.2F, 1);
    for (int cell = 0; cell < 4; ++cell) {
        gl.Scissor(cell * 64 + 3, 10, 58, 236);
        gl.StencilMask(0x0F << cell);
        gl.DepthMask(cell % 2 == 0);
        gl.ClearStencil(0xFF);
        gl.ClearDepth(0.25);
        gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }
}

SCENE(clear_between_draws,
      "clears in the middle of a frame, whole and scissored, with pending draws on both sides") {
    pixel_projection(gl);
    striped_backdrop(gl, 7);
    gl.ClearColor(0.15F, 0.3F, 0.2F, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Enable(GL_DEPTH_TEST);
    gl.Color3f(0.9F, 0.5F, 0.1F);
    rectangle(gl, 20, 20, 200, 200, 0.5F);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(100, 100, 80, 130);
    gl.ClearColor(0.2F, 0.2F, 0.6F, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Color3f(0.8F, 0.8F, 0.9F);
    gl.Disable(GL_SCISSOR_TEST);
    rectangle(gl, 60, 60, 240, 160, 0.1F);
}

SCENE(draw_buffer_none, "DrawBuffer NONE stops colour but not depth; FRONT draws again",
      .window_only = "objects have no front buffer") {
    pixel_projection(gl);
    gl.Enable(GL_DEPTH_TEST);
    gl.Color3f(0.9F, 0.7F, 0.2F);
    rectangle(gl, 20, 20, 120, 236, 0);
    gl.DrawBuffer(GL_NONE);
    rectangle(gl, 90, 60, 236, 200, 0.5F);
    gl.DrawBuffer(GL_FRONT);
    gl.Color3f(0.3F, 0.6F, 0.9F);
    rectangle(gl, 60, 40, 250, 130, 0.2F);
    GLint buffer = 0;
    gl.GetIntegerv(GL_DRAW_BUFFER, &buffer);
    notes.value("draw buffer", buffer);
}

SCENE(dither_off_and_on, "dithering asked for changes nothing in an eight-bit buffer") {
    pixel_projection(gl);
    for (int half = 0; half < 2; ++half) {
        if (half)
            gl.Enable(GL_DITHER);
        else
            gl.Disable(GL_DITHER);
        const float y = static_cast<float>(half) * 128;
        gl.Begin(GL_QUADS);
        gl.Color3f(0.30F, 0.31F, 0.32F), gl.Vertex2f(4, y + 4);
        gl.Color3f(0.33F, 0.30F, 0.31F), gl.Vertex2f(252, y + 4);
        gl.Color3f(0.35F, 0.36F, 0.30F), gl.Vertex2f(252, y + 124);
        gl.Color3f(0.30F, 0.34F, 0.37F), gl.Vertex2f(4, y + 124);
        gl.End();
    }
}
