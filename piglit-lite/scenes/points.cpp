// Chapter: points (GL 1.5 §3.3).
#include "helpers.h"

using namespace terrazzo::piglit;

SCENE(points_sizes, "aliased points of sizes 0.3 to 24 at whole and fractional positions") {
    pixel_projection(gl);
    const float sizes[] = {0.3F, 1, 1.4F, 1.6F, 2, 2.5F, 3, 4, 5.5F, 7, 9, 12, 15, 18, 21, 24};
    for_cells(4, 4, [&](int cell, float x, float y, float w, float h) {
        gl.PointSize(sizes[cell]);
        gl.Begin(GL_POINTS);
        for (int i = 0; i < 4; ++i) {
            gl.Color4fv(hue(static_cast<float>(cell * 4 + i) / 64).data());
            gl.Vertex2f(x + w / 4 + static_cast<float>(i % 2) * (w / 2 + 0.37F),
                        y + h / 4 + static_cast<float>(i / 2) * (h / 2 + 0.61F));
        }
        gl.End();
    });
    GLfloat range[2];
    gl.GetFloatv(GL_POINT_SIZE, range);
    notes.value("point size", range[0]);
}

SCENE(points_subpixel_positions, "one-pixel and three-pixel points on a lattice of 1/16 pixel offsets") {
    pixel_projection(gl);
    for (int size = 0; size < 2; ++size) {
        gl.PointSize(size ? 3 : 1);
        gl.Begin(GL_POINTS);
        for (int j = 0; j < 16; ++j)
            for (int i = 0; i < 16; ++i) {
                gl.Color4fv(hue(static_cast<float>(i + 16 * j) / 256).data());
                gl.Vertex2f(static_cast<float>(i) * 7.0625F + 4 + static_cast<float>(size) * 128,
                            static_cast<float>(j) * 15.0625F + 5);
            }
        gl.End();
    }
}

SCENE(points_with_everything, "lit, textured, fogged, depth-tested and clipped points in perspective") {
    camera(gl, 50, 4, 1, 8);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.Enable(GL_TEXTURE_2D);
    gl.Enable(GL_FOG);
    gl.Fogf(GL_FOG_START, 2);
    gl.Fogf(GL_FOG_END, 7);
    gl.Fogi(GL_FOG_MODE, GL_LINEAR);
    const GLfloat fog[] = {0.3F, 0.2F, 0.5F, 1};
    gl.Fogfv(GL_FOG_COLOR, fog);
    painted_texture(gl, 64, 64, GL_LINEAR, GL_LINEAR);
    gl.PointSize(8);
    const Solid torus = make_torus(1.6F, 0.6F, 30, 14);
    gl.Rotatef(60, 1, 0.4F, 0);
    gl.Begin(GL_POINTS);
    for (const SolidVertex& vertex : torus.vertices) {
        gl.Normal3fv(vertex.normal);
        gl.TexCoord2fv(vertex.texture);
        gl.Vertex3fv(vertex.position);
    }
    gl.End();
}

SCENE(points_at_window_edges, "wide points whose centres are inside, on and outside the window's edges") {
    pixel_projection(gl);
    gl.PointSize(13);
    gl.Begin(GL_POINTS);
    for (int i = 0; i <= 16; ++i) {
        const float along = static_cast<float>(i) * 16;
        gl.Color4fv(hue(static_cast<float>(i) / 17).data());
        gl.Vertex2f(along, static_cast<float>(i % 5) - 2);
        gl.Vertex2f(along, 256 + static_cast<float>(i % 5) - 2);
        gl.Vertex2f(static_cast<float>(i % 5) - 2, along);
        gl.Vertex2f(256 + static_cast<float>(i % 5) - 2, along);
        gl.Vertex2f(along, along);
    }
    gl.End();
}
