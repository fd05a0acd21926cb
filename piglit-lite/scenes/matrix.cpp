// Chapter: matrices, their stacks, viewport and depth range (GL 1.5 §2.11.1-2.11.3).
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

void wedge(const Gl& gl, float turn) {
    gl.Begin(GL_TRIANGLES);
    gl.Color4fv(hue(turn).data());
    gl.Vertex2f(0, 0);
    gl.Color4fv(hue(turn + 0.2F, 0.6F).data());
    gl.Vertex2f(1, 0.1F);
    gl.Vertex2f(0.8F, 0.5F);
    gl.End();
}

}  // namespace

SCENE(matrix_operations,
      "translate, rotate, scale, load and multiply in float and double forms build a rosette") {
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    gl.Ortho(-2, 2, -2, 2, -4, 4);
    gl.MatrixMode(GL_MODELVIEW);
    for (int i = 0; i < 12; ++i) {
        gl.LoadIdentity();
        const float angle = static_cast<float>(i) * 30;
        if (i % 2)
            gl.Rotatef(angle, 0, 0, 1);
        else
            gl.Rotated(angle, 0, 0, 2);
        if (i % 3 == 0) gl.Translatef(0.4F, 0, 0);
        if (i % 3 == 1) gl.Translated(0.3, 0.1, 0.5);
        if (i % 4 == 1) gl.Scalef(1.3F, 0.7F, 1);
        if (i % 4 == 2) gl.Scaled(0.8, 1.4, 1);
        const GLfloat shear_f[16] = {1, 0.2F, 0, 0, 0.1F, 1, 0, 0, 0, 0, 1, 0, 0.1F, 0, 0, 1};
        const GLdouble shear_d[16] = {1, -0.2, 0, 0, -0.3, 1, 0, 0, 0, 0, 1, 0, 0, 0.2, 0, 1};
        if (i % 5 == 0) gl.MultMatrixf(shear_f);
        if (i % 5 == 1) gl.MultMatrixd(shear_d);
        wedge(gl, static_cast<float>(i) / 12);
        GLfloat matrix[16];
        gl.GetFloatv(GL_MODELVIEW_MATRIX, matrix);
        notes.values("matrix " + std::to_string(i), matrix, 1e-6);
    }
}

SCENE(matrix_load_forms,
      "LoadMatrixf/d, LoadTransposeMatrix and MultTransposeMatrix agree with their plain forms") {
    const GLfloat f[16] = {0.4F, 0.1F, 0, 0, -0.1F, 0.4F, 0, 0, 0, 0, 1, 0, -0.5F, -0.5F, 0, 1};
    GLfloat ft[16];
    GLdouble d[16], dt[16];
    for (int i = 0; i < 16; ++i) ft[i % 4 * 4 + i / 4] = f[i];
    for (int i = 0; i < 16; ++i) d[i] = f[i], dt[i] = ft[i];
    for (int i = 0; i < 8; ++i) {
        gl.LoadIdentity();
        if (i >= 4) gl.Translatef(0.9F, 0.9F, 0);
        switch (i) {
            case 0:
                gl.LoadMatrixf(f);
                break;
            case 1:
                gl.LoadMatrixd(d);
                break;
            case 2:
                gl.LoadTransposeMatrixf(ft);
                break;
            case 3:
                gl.LoadTransposeMatrixd(dt);
                break;
            case 4:
                gl.MultMatrixf(f);
                break;
            case 5:
                gl.MultMatrixd(d);
                break;
            case 6:
                gl.MultTransposeMatrixf(ft);
                break;
            default:
                gl.MultTransposeMatrixd(dt);
                break;
        }
        gl.Rotatef(static_cast<float>(i % 4) * 90, 0, 0, 1);
        wedge(gl, static_cast<float>(i) / 8);
    }
    GLfloat transposed[16];
    gl.GetFloatv(GL_TRANSPOSE_MODELVIEW_MATRIX, transposed);
    notes.values("transposed", transposed, 1e-6);
}

SCENE(matrix_stacks, "a tree drawn with Push/PopMatrix to the depth of the stack") {
    gl.MatrixMode(GL_PROJECTION);
    gl.Ortho(-1.6, 1.6, 0, 3.2, -1, 1);
    gl.MatrixMode(GL_MODELVIEW);
    const std::function<void(int)> branch = [&](int depth) {
        gl.Color4fv(hue(static_cast<float>(depth) / 9).data());
        gl.Rectf(-0.06F, 0, 0.06F, 0.9F);
        if (depth == 8) return;
        for (const float angle : {-28.0F, 22.0F}) {
            gl.PushMatrix();
            gl.Translatef(0, 0.88F, 0);
            gl.Rotatef(angle, 0, 0, 1);
            gl.Scalef(0.74F, 0.74F, 1);
            branch(depth + 1);
            gl.PopMatrix();
        }
    };
    branch(0);
    for (const GLenum mode : {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE}) {
        gl.MatrixMode(mode);
        // Fills and overflows each stack, then empties and underflows it: the picture must not change.
        int pushes = 0;
        while (gl.GetError() == GL_NO_ERROR && pushes < 200) {
            gl.PushMatrix();
            ++pushes;
        }
        int pops = 0;
        do {
            gl.PopMatrix();
            ++pops;
        } while (gl.GetError() == GL_NO_ERROR && pops < 200);
        notes.value("balance of stack " + std::to_string(mode), pushes - pops);
    }
}

SCENE(matrix_projections, "Frustum and Ortho, symmetric and not, side by side") {
    const Solid torus = make_torus(1, 0.4F, 24, 12);
    gl.Enable(GL_DEPTH_TEST);
    for_viewports(gl, 2, 2, [&](int cell) {
        gl.MatrixMode(GL_PROJECTION);
        gl.LoadIdentity();
        if (cell == 0) gl.Frustum(-1, 1, -1, 1, 2, 20);
        if (cell == 1) gl.Frustum(-0.4, 1.6, -1.5, 0.5, 2, 20);
        if (cell == 2) gl.Ortho(-2, 2, -2, 2, 0, 20);
        if (cell == 3) gl.Ortho(3, -1, -1.5, 2, 2, 9);
        gl.MatrixMode(GL_MODELVIEW);
        gl.LoadIdentity();
        gl.Translatef(0, 0, -4);
        gl.Rotatef(50, 1, 0.4F, 0);
        draw_solid(gl, torus, kColours);
    });
}

SCENE(matrix_viewports, "viewports of odd sizes and places, partly outside the window, without a scissor") {
    const Solid box = make_box(0.7F);
    gl.Enable(GL_DEPTH_TEST);
    const GLint views[][4] = {{0, 0, 120, 90},    {130, 7, 121, 61},  {-40, 100, 130, 133},
                              {160, 90, 160, 75}, {97, 130, 64, 200}, {200, 200, 1, 1}};
    for (const auto& view : views) {
        gl.Viewport(view[0], view[1], view[2], view[3]);
        gl.MatrixMode(GL_PROJECTION);
        gl.LoadIdentity();
        gl.Frustum(-0.6, 0.6, -0.6, 0.6, 1, 10);
        gl.MatrixMode(GL_MODELVIEW);
        gl.LoadIdentity();
        gl.Translatef(0, 0, -2.4F);
        gl.Rotatef(static_cast<float>(view[2]), 1, 2, 0);
        draw_solid(gl, box, kColours);
    }
    GLint viewport[4];
    gl.GetIntegerv(GL_VIEWPORT, viewport);
    notes.values("viewport", viewport);
}

SCENE(matrix_depth_range,
      "depth ranges: whole, part, inverted and of no extent, read back from the depth buffer") {
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_ALWAYS);
    pixel_projection(gl);
    const double ranges[][2] = {{0, 1}, {0.25, 0.5}, {1, 0}, {0.5, 0.5}, {0.9, 2}, {-1, 0.3}};
    int band = 0;
    for (const auto& range : ranges) {
        gl.DepthRange(range[0], range[1]);
        const float y = static_cast<float>(band) * 42;
        gl.Begin(GL_QUADS);
        gl.Color4fv(hue(static_cast<float>(band) / 6).data());
        gl.Vertex3f(4, y, 1);
        gl.Vertex3f(252, y, -1);
        gl.Color4fv(hue(static_cast<float>(band) / 6 + 0.3F).data());
        gl.Vertex3f(252, y + 38, -1);
        gl.Vertex3f(4, y + 38, 1);
        gl.End();
        GLfloat got[2];
        gl.GetFloatv(GL_DEPTH_RANGE, got);
        notes.values("range " + std::to_string(band), got, 1e-6);
        ++band;
    }
}

SCENE(matrix_w_and_homogeneous_positions,
      "vertices given with w other than one, and w interpolated over a quad strip") {
    gl.Enable(GL_TEXTURE_2D);
    painted_texture(gl, 64, 64, GL_LINEAR, GL_LINEAR);
    gl.Begin(GL_QUAD_STRIP);
    for (int i = 0; i <= 6; ++i) {
        const float x = -0.9F + 0.3F * static_cast<float>(i), w = 1 + 0.6F * static_cast<float>(i % 3);
        gl.TexCoord2f(static_cast<float>(i) / 3, 0);
        gl.Vertex4f(x * w, -0.8F * w, 0, w);
        gl.TexCoord2f(static_cast<float>(i) / 3, 2);
        gl.Vertex4f(x * 2, 0.8F * 2, 0, 2);
    }
    gl.End();
}
