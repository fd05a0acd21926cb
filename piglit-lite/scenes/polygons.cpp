// Chapter: polygons: culling, modes, offset, stipple, fill rules (GL 1.5 §3.5).
#include <cmath>

#include "helpers.h"

using namespace terrazzo::piglit;

SCENE(polygon_shared_edges,
      "a fine mesh and fans round a vertex added with ONE, ONE: no pixel twice, none missed") {
    pixel_projection(gl);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ONE);
    gl.Color3f(0.3F, 0.2F, 0.1F);
    Random random(3);
    float mesh[13][13][2];
    for (int j = 0; j < 13; ++j)
        for (int i = 0; i < 13; ++i) {
            mesh[j][i][0] = static_cast<float>(i) * 20 + 8 + random(-5, 5);
            mesh[j][i][1] = static_cast<float>(j) * 20 + 8 + random(-5, 5);
        }
    for (int j = 0; j < 12; ++j) {
        gl.Begin(GL_TRIANGLE_STRIP);
        for (int i = 0; i < 13; ++i) {
            gl.Vertex2fv(mesh[j + 1][i]);
            gl.Vertex2fv(mesh[j][i]);
        }
        gl.End();
    }
    gl.Color3f(0, 0.25F, 0.4F);
    gl.Begin(GL_TRIANGLE_FAN);
    gl.Vertex2f(128.5F, 128.5F);
    for (int i = 0; i <= 48; ++i)
        gl.Vertex2f(128.5F + 100 * std::cos(0.1309F * static_cast<float>(i)),
                    128.5F + 100 * std::sin(0.1309F * static_cast<float>(i)));
    gl.End();
}

SCENE(polygon_pixel_centres,
      "triangles with edges and vertices exactly on pixel centres and half-way between") {
    pixel_projection(gl);
    for_cells(8, 8, [&](int cell, float x, float y, float, float) {
        const float dx = static_cast<float>(cell % 4) * 0.25F, dy = static_cast<float>(cell / 4 % 4) * 0.25F;
        gl.Color4fv(hue(static_cast<float>(cell) / 64).data());
        gl.Begin(GL_TRIANGLES);
        gl.Vertex2f(x + 4.5F + dx, y + 4.5F + dy);
        gl.Vertex2f(x + (cell % 8 < 4 ? 24.5F : 14.5F) + dx, y + 4.5F + dy);
        gl.Vertex2f(x + (cell < 32 ? 4.5F : 24.5F) + dx, y + 24.5F + dy);
        gl.End();
    });
}

SCENE(polygon_slivers, "thousands of thin, tiny and degenerate triangles") {
    pixel_projection(gl);
    Random random(77);
    gl.Begin(GL_TRIANGLES);
    for (int i = 0; i < 3000; ++i) {
        const float x = random(0, 256), y = random(0, 256);
        gl.Color4fv(hue(static_cast<float>(i) / 3000).data());
        gl.Vertex2f(x, y);
        InOrder{gl.Vertex2f, x + random(-14, 14), y + random(-14, 14)};
        InOrder{gl.Vertex2f, x + random(-0.7F, 0.7F), y + random(-0.7F, 0.7F)};
    }
    gl.End();
}

SCENE(polygon_culling, "front, back and both culled, with either winding as the front") {
    const Solid torus = make_torus(1, 0.45F, 24, 12);
    for_viewports(gl, 4, 2, [&](int cell) {
        camera(gl, 50, 3.6F);
        gl.Scalef(0.5F, 1, 1);
        gl.Scalef(2, 1, 1);
        const GLenum faces[] = {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK};
        if (cell % 4 < 3)
            gl.Enable(GL_CULL_FACE);
        else
            gl.Disable(GL_CULL_FACE);
        gl.CullFace(faces[cell % 4 % 3]);
        gl.FrontFace(cell / 4 ? GL_CW : GL_CCW);
        gl.Rotatef(-55, 1, 0.4F, 0);
        draw_solid(gl, torus, kColours);
        gl.LineWidth(2);
        gl.Begin(GL_LINE_LOOP);  // lines are never culled
        for (int i = 0; i < 12; ++i) {
            gl.Color3f(1, 1, 1);
            gl.Vertex3f(1.7F * std::cos(0.5236F * static_cast<float>(i)),
                        1.7F * std::sin(0.5236F * static_cast<float>(i)), 0);
        }
        gl.End();
    });
}

SCENE(polygon_modes, "fronts and backs as points, lines and fill in all nine combinations") {
    const Solid torus = make_torus(1, 0.45F, 18, 10);
    const GLenum modes[] = {GL_POINT, GL_LINE, GL_FILL};
    for_viewports(gl, 3, 3, [&](int cell) {
        camera(gl, 50, 3.6F);
        gl.Enable(GL_DEPTH_TEST);
        gl.PolygonMode(GL_FRONT, modes[cell % 3]);
        gl.PolygonMode(GL_BACK, modes[cell / 3]);
        gl.PointSize(3);
        gl.Rotatef(-50, 1, 0.3F, 0);
        const GLdouble plane[] = {1, 0.3, 0, 0.5};
        gl.ClipPlane(GL_CLIP_PLANE0, plane);
        gl.Enable(GL_CLIP_PLANE0);
        draw_solid(gl, torus, kColours);
    });
    GLint mode[2];
    gl.GetIntegerv(GL_POLYGON_MODE, mode);
    notes.values("polygon mode", mode);
}

SCENE(polygon_mode_two_sided_flat,
      "line and point modes carry the face's own lit colour and the provoking colour") {
    camera(gl, 50, 3.6F);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.ShadeModel(GL_FLAT);
    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    const GLfloat front[] = {0.9F, 0.6F, 0.1F, 1}, back[] = {0.1F, 0.6F, 0.9F, 1};
    gl.Materialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, front);
    gl.Materialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, back);
    gl.PolygonMode(GL_FRONT, GL_LINE);
    gl.PolygonMode(GL_BACK, GL_POINT);
    gl.PointSize(5);
    gl.LineWidth(2);
    gl.Rotatef(-60, 1, 0.4F, 0);
    draw_solid(gl, make_torus(1.1F, 0.5F, 20, 10), kNormals);
}

SCENE(polygon_offset_decals,
      "coplanar decals lifted by POLYGON_OFFSET_FILL, wires by LINE, corners by POINT") {
    camera(gl, 45, 4);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_LESS);
    gl.Rotatef(-55, 1, 0.5F, 0);
    const Solid grid = make_grid(1.4F, 8);
    draw_solid(gl, grid, kColours);
    gl.Enable(GL_POLYGON_OFFSET_FILL);
    gl.PolygonOffset(-1, -2);
    gl.Color3f(0.1F, 0.1F, 0.1F);
    gl.Rectf(-1, -0.8F, 0.2F, 0.1F);
    gl.PolygonOffset(1, 4);  // pushed behind: stays hidden
    gl.Color3f(1, 0, 0);
    gl.Rectf(0.3F, 0.3F, 1, 1);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    gl.Enable(GL_POLYGON_OFFSET_LINE);
    gl.PolygonOffset(-2, -4);
    gl.Color3f(1, 1, 1);
    draw_solid(gl, grid, kPositions);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    gl.Enable(GL_POLYGON_OFFSET_POINT);
    gl.PolygonOffset(-3, -8);
    gl.PointSize(5);
    gl.Color3f(1, 0.8F, 0);
    draw_solid(gl, grid, kPositions);
}

SCENE(polygon_offset_depth_values,
      "factor and units on planes of many slopes, compared in the depth buffer itself") {
    pixel_projection(gl);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_POLYGON_OFFSET_FILL);
    gl.DepthFunc(GL_ALWAYS);
    for_cells(8, 8, [&](int cell, float x, float y, float w, float h) {
        gl.PolygonOffset(static_cast<float>(cell % 8 - 3) * 0.5F, static_cast<float>(cell / 8 - 3) * 3);
        const float slope = 0.008F * static_cast<float>(cell + 1) / 64;
        gl.Begin(GL_QUADS);
        gl.Color4fv(hue(static_cast<float>(cell) / 64).data());
        gl.Vertex3f(x + 1, y + 1, 0.3F);
        gl.Vertex3f(x + w - 1, y + 1, 0.3F + slope * w);
        gl.Vertex3f(x + w - 1, y + h - 1, 0.3F + 2 * slope * w);
        gl.Vertex3f(x + 1, y + h - 1, 0.3F + slope * h);
        gl.End();
    });
}

SCENE(polygon_stipple, "two 32x32 patterns, fixed to the window, on triangles and quads that move") {
    pixel_projection(gl);
    GLubyte weave[128], disc[128];
    for (int i = 0; i < 128; ++i) {
        weave[i] = static_cast<GLubyte>(i / 4 % 4 < 2 ? 0xCC : 0x33);
        const int row = i / 4 - 16;
        GLubyte bits = 0;
        for (int b = 0; b < 8; ++b) {
            const int column = i % 4 * 8 + b - 16;
            bits = static_cast<GLubyte>(bits << 1 | (row * row + column * column < 180 ? 1 : 0));
        }
        disc[i] = bits;
    }
    gl.Enable(GL_POLYGON_STIPPLE);
    gl.PolygonStipple(weave);
    gl.Begin(GL_TRIANGLES);
    for (int i = 0; i < 9; ++i) {
        gl.Color4fv(hue(static_cast<float>(i) / 9).data());
        gl.Vertex2f(128 + 120 * std::cos(2.3F * static_cast<float>(i)),
                    70 + 64 * std::sin(2.3F * static_cast<float>(i)));
    }
    gl.End();
    gl.PolygonStipple(disc);
    for (int i = 0; i < 4; ++i) {
        gl.Color4fv(hue(static_cast<float>(i) / 4 + 0.1F).data());
        rectangle(gl, static_cast<float>(i) * 62 + 5, 140 + static_cast<float>(i) * 3,
                  static_cast<float>(i) * 62 + 57, 250);
    }
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);  // stipple applies to filled polygons only
    gl.Color3f(1, 1, 1);
    rectangle(gl, 3, 134, 253, 253);
    GLubyte got[128];
    gl.GetPolygonStipple(got);
    notes.values("pattern", got);
}

SCENE(polygon_large_and_nonplanar_quads,
      "quads that bow and twist: the split into triangles shows in the colours") {
    pixel_projection(gl);
    Random random(5);
    for_cells(4, 4, [&](int cell, float x, float y, float w, float h) {
        gl.Begin(cell % 2 ? GL_POLYGON : GL_QUADS);
        const float corners[4][2] = {{0.05F, 0.05F}, {0.95F, 0.1F}, {0.9F, 0.95F}, {0.1F, 0.9F}};
        for (int i = 0; i < 4; ++i) {
            gl.Color4fv(hue(random(0, 1)).data());
            const bool dent = cell >= 8 && i == 2;
            gl.Vertex3f(x + w * (dent ? 0.45F : corners[i][0]), y + h * (dent ? 0.4F : corners[i][1]),
                        random(-0.5F, 0.5F));
        }
        gl.End();
    });
}
