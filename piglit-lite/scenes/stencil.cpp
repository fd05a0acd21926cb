// Chapter: stencil test (GL 1.5 §4.1.5).
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

// Values 0..n in the stencil buffer, as overlapping squares.
void stencil_steps(const Gl& gl, float x, float y, float w, float h, int steps) {
    gl.Enable(GL_STENCIL_TEST);
    gl.ColorMask(0, 0, 0, 0);
    for (int i = 0; i < steps; ++i) {
        gl.StencilFunc(GL_ALWAYS, i + 1, 255);
        gl.StencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE);
        const float inset = static_cast<float>(i) * 0.5F / static_cast<float>(steps);
        rectangle(gl, x + inset * w, y + inset * h, x + w - inset * w, y + h - inset * h);
    }
    gl.ColorMask(1, 1, 1, 1);
}

}  // namespace

SCENE(stencil_functions, "the eight functions with a reference against nested squares of values") {
    pixel_projection(gl);
    const GLenum functions[] = {GL_NEVER,   GL_LESS,     GL_EQUAL,  GL_LEQUAL,
                                GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};
    for_cells(4, 2, [&](int cell, float x, float y, float w, float h) {
        stencil_steps(gl, x + 2, y + 2, w - 4, h - 4, 6);
        gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
        gl.StencilFunc(functions[cell], 3, 255);
        gl.Color4fv(hue(static_cast<float>(cell) / 8).data());
        rectangle(gl, x, y, x + w, y + h);
    });
}

SCENE(stencil_operations, "eight operations, with stencil failing, depth failing and both passing") {
    pixel_projection(gl);
    const GLenum operations[] = {GL_KEEP, GL_ZERO,   GL_REPLACE,   GL_INCR,
                                 GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP};
    gl.Enable(GL_DEPTH_TEST);
    for_cells(8, 3, [&](int cell, float x, float y, float w, float h) {
        gl.DepthFunc(GL_ALWAYS);
        gl.DepthMask(GL_FALSE);
        stencil_steps(gl, x + 1, y + 1, w - 2, h - 2, 4);
        gl.DepthMask(GL_TRUE);
        const GLenum op = operations[cell % 8];
        const int outcome = cell / 8;
        gl.StencilFunc(outcome == 0 ? GL_NEVER : GL_ALWAYS, 0xA5, 255);
        gl.DepthFunc(outcome == 1 ? GL_NEVER : GL_ALWAYS);
        gl.StencilOp(outcome == 0 ? op : GL_KEEP, outcome == 1 ? op : GL_KEEP, outcome == 2 ? op : GL_KEEP);
        gl.Color4fv(hue(static_cast<float>(cell) / 24).data());
        rectangle(gl, x + 6, y + 6, x + w - 6, y + h - 6);
    });
    // Shows the values: each bit as a colour, through the test.
    gl.DepthFunc(GL_ALWAYS);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ONE);
    for (int bit = 0; bit < 8; ++bit) {
        gl.StencilFunc(GL_EQUAL, 1 << bit, 1U << bit);
        gl.Color4fv(hue(static_cast<float>(bit) / 8, 0.3F).data());
        rectangle(gl, 0, 0, kSize, kSize);
    }
}

SCENE(stencil_masks, "write masks and compare masks bit by bit") {
    pixel_projection(gl);
    gl.Enable(GL_STENCIL_TEST);
    for_cells(4, 4, [&](int cell, float x, float y, float w, float h) {
        gl.StencilMask(0xFF);
        gl.StencilFunc(GL_ALWAYS, 0x5A, 255);
        gl.StencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE);
        gl.Color3f(0.3F, 0.3F, 0.3F);
        rectangle(gl, x + 2, y + 2, x + w - 2, y + h - 2);
        gl.StencilMask(0x11U << cell % 4);
        gl.StencilOp(GL_INVERT, GL_INVERT, GL_INVERT);
        gl.StencilFunc(GL_EQUAL, 0x0A, 0x0FU >> cell / 4);
        gl.Color4fv(hue(static_cast<float>(cell) / 16).data());
        gl.Begin(GL_TRIANGLES);
        gl.Vertex2f(x + 4, y + 4);
        gl.Vertex2f(x + w - 4, y + 4);
        gl.Vertex2f(x + w / 2, y + h - 4);
        gl.End();
    });
    GLint mask = 0;
    gl.GetIntegerv(GL_STENCIL_WRITEMASK, &mask);
    notes.value("write mask", mask);
}

SCENE(stencil_counting_overlaps, "INCR counts layers with clamping, then colours by count") {
    pixel_projection(gl);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilFunc(GL_ALWAYS, 0, 255);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    gl.ColorMask(0, 0, 0, 0);
    Random random(17);
    for (int i = 0; i < 60; ++i) {
        gl.Begin(GL_TRIANGLES);
        for (int k = 0; k < 3; ++k) InOrder{gl.Vertex2f, random(0, 256), random(0, 256)};
        gl.End();
    }
    gl.ColorMask(1, 1, 1, 1);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    for (int value = 0; value < 24; ++value) {
        gl.StencilFunc(GL_EQUAL, value, 255);
        gl.Color4fv(hue(static_cast<float>(value) / 24, 0.4F + static_cast<float>(value) / 40).data());
        rectangle(gl, 0, 0, kSize, kSize);
    }
}

SCENE(stencil_shadow_volume, "z-fail counting of a closed volume: a shadow on a floor and a sphere") {
    camera(gl, 45, 6);
    gl.Enable(GL_DEPTH_TEST);
    gl.Rotatef(25, 1, 0, 0);
    const auto room = [&] {
        gl.PushMatrix();
        gl.Translatef(0, -1, 0);
        gl.Rotatef(-90, 1, 0, 0);
        draw_solid(gl, make_grid(2.4F, 10), kColours);
        gl.PopMatrix();
        draw_solid(gl, make_sphere(0.8F, 16, 24), kColours);
    };
    room();
    gl.Enable(GL_STENCIL_TEST);
    gl.Enable(GL_CULL_FACE);
    gl.DepthMask(GL_FALSE);
    gl.ColorMask(0, 0, 0, 0);
    gl.StencilFunc(GL_ALWAYS, 0, 255);
    for (const GLenum face : {GL_FRONT, GL_BACK}) {
        gl.CullFace(face);
        gl.StencilOp(GL_KEEP, face == GL_FRONT ? GL_INCR : GL_DECR, GL_KEEP);
        gl.PushMatrix();
        gl.Translatef(0.9F, 0, 0.7F);
        gl.Rotatef(35, 0, 0, 1);
        gl.Scalef(0.5F, 3, 0.5F);
        draw_solid(gl, make_box(1), kPositions);
        gl.PopMatrix();
    }
    gl.ColorMask(1, 1, 1, 1);
    gl.Disable(GL_CULL_FACE);
    gl.DepthFunc(GL_EQUAL);
    gl.StencilFunc(GL_NOTEQUAL, 0, 255);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_DST_COLOR, GL_ZERO);
    gl.DisableClientState(GL_COLOR_ARRAY);
    gl.Color3f(0.35F, 0.35F, 0.45F);
    gl.PushMatrix();
    gl.Translatef(0, -1, 0);
    gl.Rotatef(-90, 1, 0, 0);
    draw_solid(gl, make_grid(2.4F, 10), kPositions);
    gl.PopMatrix();
    draw_solid(gl, make_sphere(0.8F, 16, 24), kPositions);
}

SCENE(stencil_mirror, "a reflection bounded by the stencil, with a clip plane at the mirror") {
    camera(gl, 45, 6);
    gl.Enable(GL_DEPTH_TEST);
    gl.Rotatef(20, 1, 0, 0);
    const auto mirror = [&] {
        gl.Begin(GL_QUADS), gl.Vertex3f(-1.6F, -0.8F, 1.6F), gl.Vertex3f(1.6F, -0.8F, 1.6F),
            gl.Vertex3f(1.6F, -0.8F, -1.6F), gl.Vertex3f(-1.6F, -0.8F, -1.6F), gl.End();
    };
    const auto torus = [&] {
        gl.PushMatrix();
        gl.Translatef(0.2F, 0.5F, 0);
        gl.Rotatef(40, 1, 0.6F, 0);
        draw_solid(gl, make_torus(0.9F, 0.35F, 24, 12), kColours);
        gl.PopMatrix();
    };
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilFunc(GL_ALWAYS, 1, 255);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    gl.DepthMask(0);
    gl.Color3f(0.1F, 0.1F, 0.12F);
    mirror();
    gl.DepthMask(1);
    gl.StencilFunc(GL_EQUAL, 1, 255);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    const GLdouble below[] = {0, -1, 0, -0.8};
    gl.ClipPlane(GL_CLIP_PLANE0, below);
    gl.Enable(GL_CLIP_PLANE0);
    gl.PushMatrix();
    gl.Translatef(0, -1.6F, 0);
    gl.Scalef(1, -1, 1);
    torus();
    gl.PopMatrix();
    gl.Disable(GL_CLIP_PLANE0);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl.Color4f(0.5F, 0.6F, 0.7F, 0.4F);
    mirror();
    gl.Disable(GL_BLEND);
    gl.Disable(GL_STENCIL_TEST);
    torus();
}

namespace {

// What the stencil buffer holds, each value in a colour of its own.
void show_stencil(const Gl& gl, int values) {
    gl.Disable(GL_STENCIL_TEST_TWO_SIDE_EXT);
    gl.Disable(GL_DEPTH_TEST);
    gl.Disable(GL_CULL_FACE);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    pixel_projection(gl);
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadIdentity();
    gl.ColorMask(1, 1, 1, 1);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    for (int value = 1; value < values; ++value) {
        gl.StencilFunc(GL_EQUAL, value, 255);
        gl.Color4fv(hue(static_cast<float>(value) / static_cast<float>(values), 0.9F).data());
        rectangle(gl, 0, 0, kSize, kSize);
    }
}

// Sets the back sides' operation by either extension.
void back_operation(const Gl& gl, bool two_side, GLenum op, GLint reference) {
    if (!two_side) {
        gl.StencilOpSeparateATI(GL_BACK, op, op, op);
        return gl.StencilFuncSeparateATI(GL_ALWAYS, GL_ALWAYS, reference, 255);
    }
    gl.Enable(GL_STENCIL_TEST_TWO_SIDE_EXT);
    gl.ActiveStencilFaceEXT(GL_BACK);
    gl.StencilOp(op, op, op);
    gl.StencilFunc(GL_ALWAYS, reference, 255);
    gl.ActiveStencilFaceEXT(GL_FRONT);
}

void increment_fronts_replace_backs(const Gl& gl) {
    gl.StencilFunc(GL_ALWAYS, 2, 255);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    back_operation(gl, true, GL_REPLACE, 6);
}

void sides_of_tori(const Gl& gl, bool two_side) {
    gl.Enable(GL_STENCIL_TEST);
    gl.ColorMask(0, 0, 0, 0);
    const GLenum operations[] = {GL_REPLACE, GL_INCR, GL_DECR_WRAP, GL_INVERT, GL_ZERO, GL_INCR_WRAP};
    for_viewports(gl, 3, 2, [&](int cell) {
        camera(gl, 45, 5);
        gl.StencilFunc(GL_ALWAYS, 3, 255);
        gl.StencilOp(GL_INCR, GL_INCR, GL_INCR);
        back_operation(gl, two_side, operations[cell], 5);
        gl.FrontFace(cell % 2 ? GL_CW : GL_CCW);
        gl.Rotatef(static_cast<float>(cell) * 31, 1, 0.4F, 0);
        draw_solid(gl, make_torus(1.2F, 0.5F, 24, 12), kPositions);
    });
    gl.Viewport(0, 0, kSize, kSize);
    gl.FrontFace(GL_CCW);
    show_stencil(gl, 8);
}

}  // namespace

SCENE(stencil_separate, "front sides count, back sides do something else (ATI_separate_stencil)") {
    sides_of_tori(gl, false);
}

SCENE(stencil_two_side, "the same by an active face (EXT_stencil_two_side)") {
    sides_of_tori(gl, true);
    GLint face = 0;
    gl.GetIntegerv(GL_ACTIVE_STENCIL_FACE_EXT, &face);
    notes.value("active face", face);
}

SCENE(stencil_sides_of_points_and_lines,
      "points, lines, smooth lines and pixels are front sides, whichever way round that is") {
    pixel_projection(gl);
    gl.Enable(GL_STENCIL_TEST);
    increment_fronts_replace_backs(gl);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    const std::vector<std::uint8_t> picture = painted_texels(20, 20);
    for_cells(2, 2, [&](int cell, float x, float y, float, float) {
        gl.FrontFace(cell & 1 ? GL_CW : GL_CCW);
        if (cell & 2) gl.Enable(GL_LINE_SMOOTH);
        gl.LineWidth(3);
        gl.PointSize(9);
        gl.Begin(GL_LINES);
        for (int i = 0; i < 8; ++i)
            gl.Vertex2f(x + 10, y + 10 + static_cast<float>(i) * 4),
                gl.Vertex2f(x + 70, y + 60 - static_cast<float>(i) * 3);
        gl.End();
        gl.Begin(GL_POINTS);
        for (int i = 0; i < 6; ++i) gl.Vertex2f(x + 20 + static_cast<float>(i) * 7, y + 90);
        gl.End();
        gl.RasterPos2f(x + 80, y + 80);
        gl.DrawPixels(20, 20, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
        gl.Disable(GL_LINE_SMOOTH);
    });
    gl.Disable(GL_BLEND);
    gl.ColorMask(0, 0, 0, 0);
    gl.FrontFace(GL_CCW);
    show_stencil(gl, 8);
}

SCENE(stencil_sides_of_bitmaps, "bitmaps are front sides, whichever way round that is",
      .window_only = "in objects the reference's bitmaps are back sides") {
    pixel_projection(gl);
    gl.Enable(GL_STENCIL_TEST);
    increment_fronts_replace_backs(gl);
    const std::vector<std::uint8_t> picture = painted_texels(20, 20);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for_cells(2, 2, [&](int cell, float x, float y, float, float) {
        gl.FrontFace(cell & 1 ? GL_CW : GL_CCW);
        gl.RasterPos2f(x + 80, y + 20);
        gl.Bitmap(24, 20, 0, 0, 0, 0, picture.data());
    });
    gl.ColorMask(0, 0, 0, 0);
    gl.FrontFace(GL_CCW);
    show_stencil(gl, 8);
}

SCENE(stencil_shadow_volume_in_one_pass, "z-fail counting of both sides at once, wrapping round") {
    camera(gl, 45, 6);
    gl.Enable(GL_DEPTH_TEST);
    gl.Rotatef(25, 1, 0, 0);
    gl.PushMatrix();
    gl.Translatef(0, -1, 0);
    gl.Rotatef(-90, 1, 0, 0);
    draw_solid(gl, make_grid(2.4F, 10), kColours);
    gl.PopMatrix();
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilFunc(GL_ALWAYS, 0, 255);
    gl.StencilOpSeparateATI(GL_FRONT, GL_KEEP, GL_DECR_WRAP, GL_KEEP);
    gl.StencilOpSeparateATI(GL_BACK, GL_KEEP, GL_INCR_WRAP, GL_KEEP);
    gl.DepthMask(0);
    gl.ColorMask(0, 0, 0, 0);
    gl.PushMatrix();
    gl.Scalef(0.8F, 2.5F, 0.8F);
    gl.Rotatef(30, 0.3F, 1, 0);
    draw_solid(gl, make_box(0.7F), kPositions);
    gl.PopMatrix();
    gl.ColorMask(1, 1, 1, 1);
    gl.StencilFunc(GL_NOTEQUAL, 0, 255);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    gl.Disable(GL_DEPTH_TEST);
    gl.LoadIdentity();
    pixel_projection(gl);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl.Color4f(0, 0, 0.1F, 0.6F);
    rectangle(gl, 0, 0, kSize, kSize);
}
