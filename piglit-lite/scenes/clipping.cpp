// Chapter: clipping against the view volume and user planes (GL 1.5 §2.12).
#include <cmath>

#include "helpers.h"

using namespace terrazzo::piglit;

SCENE(clip_view_volume, "coloured primitives of every kind that stick out through all six planes") {
    camera(gl, 60, 3, 1, 6);
    gl.Enable(GL_DEPTH_TEST);
    Random random(11);
    gl.PointSize(7);
    gl.LineWidth(2);
    for (int i = 0; i < 90; ++i) {
        const GLenum modes[] = {GL_TRIANGLES, GL_LINES, GL_QUADS, GL_POINTS, GL_LINE_LOOP, GL_TRIANGLES};
        const float x = random(-3, 3), y = random(-3, 3), z = random(-4, 3);
        gl.Begin(modes[i % 6]);
        for (int k = 0; k < (i % 6 == 2 ? 4 : i % 6 == 1 ? 2 : 3); ++k) {
            const float a = static_cast<float>(k) * (i % 6 == 2 ? 1.5708F : 2.0944F);
            gl.Color4fv(hue(static_cast<float>(i) / 90 + 0.15F * static_cast<float>(k)).data());
            gl.Vertex3f(x + 1.2F * std::cos(a), y + 1.2F * std::sin(a), z + static_cast<float>(k) * 0.9F);
        }
        gl.End();
    }
}

SCENE(clip_through_the_eye,
      "a textured corridor whose walls run past the eye: near-plane clipping with perspective") {
    camera(gl, 75, 0, 0.1F, 50);
    gl.Enable(GL_TEXTURE_2D);
    gl.Enable(GL_DEPTH_TEST);
    painted_texture(gl, 64, 64, GL_LINEAR, GL_LINEAR);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    for (int wall = 0; wall < 4; ++wall) {
        gl.PushMatrix();
        gl.Rotatef(static_cast<float>(wall) * 90, 0, 0, 1);
        gl.Color4fv(hue(static_cast<float>(wall) / 4).data());
        receding_rectangle(gl, {1, -1, 5, -1, -45}, 2, 25);
        gl.PopMatrix();
    }
}

SCENE(clip_user_planes, "six user planes cut a torus to a block; equations given under a rotated modelview") {
    camera(gl, 45, 5);
    gl.Enable(GL_DEPTH_TEST);
    gl.PushMatrix();
    gl.Rotatef(30, 0, 0, 1);
    const GLdouble planes[6][4] = {{1, 0, 0, 1.1},  {-1, 0, 0, 1.3}, {0, 1, 0, 1},
                                   {0, -1, 0, 1.2}, {0, 0, 1, 0.45}, {0.3, 0.2, -1, 0.4}};
    for (int i = 0; i < 6; ++i) {
        gl.ClipPlane(static_cast<GLenum>(GL_CLIP_PLANE0 + i), planes[i]);
        gl.Enable(static_cast<GLenum>(GL_CLIP_PLANE0 + i));
    }
    gl.PopMatrix();
    gl.Rotatef(-35, 1, 0.3F, 0);
    draw_solid(gl, make_torus(1.2F, 0.55F, 36, 18), kColours);
    for (int i = 0; i < 6; ++i) {
        GLdouble equation[4];
        gl.GetClipPlane(static_cast<GLenum>(GL_CLIP_PLANE0 + i), equation);
        notes.values("plane " + std::to_string(i), equation, 1e-5);
    }
}

SCENE(clip_user_plane_primitives,
      "one slanting user plane across points, lines, strips, quads and polygons with colours and texture") {
    pixel_projection(gl);
    const GLdouble plane[4] = {0.6, 0.8, 0, -170};
    gl.ClipPlane(GL_CLIP_PLANE2, plane);
    gl.Enable(GL_CLIP_PLANE2);
    gl.PointSize(9);
    gl.LineWidth(4);
    gl.Begin(GL_POINTS);
    for (int i = 0; i < 60; ++i) {
        gl.Color4fv(hue(static_cast<float>(i) / 60).data());
        gl.Vertex2f(static_cast<float>(i * 37 % 250), static_cast<float>(i * 53 % 60) + 4);
    }
    gl.End();
    gl.Begin(GL_LINES);
    for (int i = 0; i < 16; ++i) {
        gl.Color4fv(hue(static_cast<float>(i) / 16).data());
        gl.Vertex2f(static_cast<float>(i) * 16 + 4, 66);
        gl.Color4fv(hue(static_cast<float>(i) / 16 + 0.5F).data());
        gl.Vertex2f(static_cast<float>(i) * 12 + 34, 126);
    }
    gl.End();
    gl.Begin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 22; ++i) {
        gl.Color4fv(hue(static_cast<float>(i) / 11).data());
        gl.Vertex2f(static_cast<float>(i) * 12, i % 2 ? 180.0F : 132.0F);
    }
    gl.End();
    gl.Enable(GL_TEXTURE_2D);
    painted_texture(gl, 32, 32, GL_NEAREST, GL_NEAREST);
    gl.Color3f(1, 1, 1);
    textured_rectangle(gl, 4, 186, 124, 252, 3, 2);
    gl.Begin(GL_POLYGON);
    for (int i = 0; i < 9; ++i) {
        const float a = 0.698F * static_cast<float>(i);
        gl.TexCoord2f(0.5F + 0.5F * std::cos(a), 0.5F + 0.5F * std::sin(a));
        gl.Vertex2f(190 + 60 * std::cos(a), 218 + 34 * std::sin(a));
    }
    gl.End();
}

SCENE(clip_flat_provoking,
      "flat shading keeps the provoking vertex's colour when clipping cuts that vertex away") {
    pixel_projection(gl);
    gl.ShadeModel(GL_FLAT);
    const GLdouble plane[4] = {-1, -0.5, 0, 250};
    gl.ClipPlane(GL_CLIP_PLANE0, plane);
    gl.Enable(GL_CLIP_PLANE0);
    const auto flat = [&](GLenum mode, float y, int count) {
        gl.Begin(mode);
        for (int i = 0; i < count; ++i) {
            gl.Color4fv(hue(static_cast<float>(i * 5) / 16).data());
            gl.Vertex2f(-30 + static_cast<float>(i) * 26, y + (i % 2 ? 34.0F : 0.0F));
        }
        gl.End();
    };
    flat(GL_TRIANGLE_STRIP, 4, 12);
    flat(GL_QUAD_STRIP, 46, 12);
    flat(GL_TRIANGLES, 88, 12);
    flat(GL_LINE_STRIP, 130, 12);
    flat(GL_TRIANGLE_FAN, 172, 10);
    flat(GL_POLYGON, 214, 4);
}

SCENE(clip_huge_and_tiny, "triangles of enormous size, slivers, and vertices far behind the eye") {
    camera(gl, 60, 2, 0.01F, 1e5F);
    gl.Enable(GL_DEPTH_TEST);
    const float corners[][3][3] = {{{-1e5F, -1e5F, -900}, {1e5F, -1e5F, -900}, {0, 2e5F, -900}},
                                   {{-3, -0.5F, 500}, {3, -0.5F, 500}, {0, -0.7F, -500}},
                                   {{-1e4F, 0.3F, -1}, {1e4F, 0.31F, -1}, {1e4F, 0.35F, -1}},
                                   {{0.2F, -0.9F, 1}, {0.21F, 0.9F, 1}, {0.2F, 0.9F, -300}},
                                   {{-0.8F, -0.2F, 0}, {-0.4F, 0.8F, 0}, {-0.79F, 900, 40}}};
    int i = 0;
    for (const auto& triangle : corners) {
        gl.Begin(GL_TRIANGLES);
        for (const auto& corner : triangle) {
            gl.Color4fv(hue(static_cast<float>(i++) / 7).data());
            gl.Vertex3fv(corner);
        }
        gl.End();
    }
}

SCENE(clip_control,
      "both origins with both ranges of depth: clipped solids, facing, stipples, lines, points, texts") {
    const GLenum origins[] = {GL_LOWER_LEFT, GL_UPPER_LEFT},
                 ranges[] = {GL_NEGATIVE_ONE_TO_ONE, GL_ZERO_TO_ONE};
    for_viewports(gl, 2, 2, [&](int cell) {
        gl.ClipControl(origins[cell % 2], ranges[cell / 2]);
        camera(gl, 60, 1.6F, 0.7F, 2.4F);
        gl.DepthRange(0.1, 0.8);
        gl.Enable(GL_DEPTH_TEST);
        gl.Enable(GL_LIGHTING);
        gl.Enable(GL_LIGHT0);
        gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
        const GLfloat back[] = {0.9F, 0.3F, 0.1F, 1}, front[] = {0.2F, 0.7F, 0.9F, 1};
        gl.Materialfv(GL_FRONT, GL_DIFFUSE, front);
        gl.Materialfv(GL_BACK, GL_DIFFUSE, back);
        gl.PushMatrix();
        gl.Rotatef(-40, 1, 0.5F, 0);
        draw_solid(gl, make_torus(0.8F, 0.35F, 26, 13), kNormals);
        gl.PopMatrix();
        gl.Disable(GL_LIGHTING);
        gl.Enable(GL_CULL_FACE);
        gl.Color3f(1, 0.9F, 0.2F);
        gl.Begin(GL_TRIANGLES);
        gl.Vertex3f(-0.9F, -0.9F, 0), gl.Vertex3f(-0.2F, -0.8F, 1.2F), gl.Vertex3f(-0.7F, 0.1F, -1.1F);
        gl.Vertex3f(0.3F, 0.4F, 0.2F), gl.Vertex3f(0.4F, 0.9F, 0.2F), gl.Vertex3f(0.9F, 0.5F, 0.2F);
        gl.End();
        gl.Disable(GL_CULL_FACE);
        gl.Begin(GL_LINES);
        gl.Vertex3f(-1, 0.9F, -4), gl.Vertex3f(0.9F, 0.7F, 2);
        gl.Vertex3f(-0.8F, 0.8F, 0), gl.Vertex3f(0.1F, -0.9F, 0.4F);
        gl.End();
        gl.PointSize(5);
        gl.Begin(GL_POINTS);
        for (int i = 0; i < 12; ++i)
            gl.Vertex3f(-0.9F + 0.15F * static_cast<float>(i), -0.6F, 1.3F - 0.3F * static_cast<float>(i));
        gl.End();
        gl.Disable(GL_DEPTH_TEST);
        const GLubyte glyph[] = {0xff, 0x81, 0xbd, 0xa1, 0xa1, 0xbd, 0x81, 0xff};
        gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
        gl.RasterPos3f(0.3F, 0.3F, 0.3F);
        gl.Bitmap(8, 8, 0, 0, 0, 0, glyph);
        GLfloat position[4];
        gl.GetFloatv(GL_CURRENT_RASTER_POSITION, position);
        notes.values("raster position", position, 1e-4);
        gl.DepthRange(0, 1);
    });
    gl.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
}
