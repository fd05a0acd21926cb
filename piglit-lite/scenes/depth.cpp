// Chapter: depth test (GL 1.5 §4.1.6).
#include "helpers.h"

using namespace terrazzo::piglit;

SCENE(depth_functions, "the eight functions against a sloping plane, with equal depths included") {
    pixel_projection(gl);
    gl.Enable(GL_DEPTH_TEST);
    const GLenum functions[] = {GL_NEVER,   GL_LESS,     GL_EQUAL,  GL_LEQUAL,
                                GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};
    for_cells(4, 2, [&](int cell, float x, float y, float w, float h) {
        const auto slope = [&](float z0, float z1) {
            gl.Begin(GL_QUADS);
            gl.Vertex3f(x + 2, y + 2, z0);
            gl.Vertex3f(x + w - 2, y + 2, z0);
            gl.Vertex3f(x + w - 2, y + h - 2, z1);
            gl.Vertex3f(x + 2, y + h - 2, z1);
            gl.End();
        };
        gl.DepthFunc(GL_ALWAYS);
        gl.Color3f(0.4F, 0.4F, 0.45F);
        slope(-0.8F, 0.8F);
        gl.DepthFunc(functions[cell]);
        gl.Color4fv(hue(static_cast<float>(cell) / 8).data());
        gl.Begin(GL_TRIANGLES);
        gl.Vertex3f(x + 6, y + 8, 0.1F);
        gl.Vertex3f(x + w - 6, y + 8, 0.1F);
        gl.Vertex3f(x + w / 2, y + h - 8, 0.1F);
        gl.End();
        gl.Color4fv(hue(static_cast<float>(cell) / 8 + 0.5F).data());
        gl.Scissor(static_cast<GLint>(x), static_cast<GLint>(y) + 8, 12, static_cast<GLsizei>(h) - 20);
        gl.Enable(GL_SCISSOR_TEST);
        slope(-0.8F, 0.8F);  // the same plane again: equal depths
        gl.Disable(GL_SCISSOR_TEST);
    });
}

SCENE(depth_intersecting_solids, "interpenetrating boxes, tori and spheres") {
    camera(gl, 50, 5);
    gl.Enable(GL_DEPTH_TEST);
    const Solid solids[] = {make_box(0.8F), make_torus(1.1F, 0.4F, 30, 15), make_sphere(0.9F, 16, 24)};
    for (int i = 0; i < 9; ++i) {
        gl.PushMatrix();
        gl.Translatef(static_cast<float>(i % 3 - 1) * 0.9F, static_cast<float>(i / 3 - 1) * 0.9F,
                      static_cast<float>(i % 2) * 0.3F);
        gl.Rotatef(static_cast<float>(i) * 37, 1, 0.7F, 0.2F);
        draw_solid(gl, solids[i % 3], kColours);
        gl.PopMatrix();
    }
}

SCENE(depth_mask, "depth writes off and on: later solids show through what wrote no depth") {
    camera(gl, 50, 4.5F);
    gl.Enable(GL_DEPTH_TEST);
    const Solid box = make_box(0.7F);
    for (int i = 0; i < 5; ++i) {
        gl.DepthMask(i % 2 == 0);
        gl.PushMatrix();
        gl.Translatef(static_cast<float>(i - 2) * 0.6F, 0.2F * static_cast<float>(i % 3),
                      -0.4F * static_cast<float>(i));
        gl.Rotatef(static_cast<float>(i) * 25, 1, 1, 0);
        draw_solid(gl, box, kColours);
        gl.PopMatrix();
    }
    GLboolean mask = 0;
    gl.GetBooleanv(GL_DEPTH_WRITEMASK, &mask);
    notes.value("mask", mask);
}

SCENE(depth_precision, "planes a few steps apart far from the eye, near 0.01 and far 1000") {
    camera(gl, 45, 0, 0.01F, 1000);
    gl.Enable(GL_DEPTH_TEST);
    for (int i = 0; i < 40; ++i) {
        const float z = -20 - static_cast<float>(i % 8) * 0.2F - static_cast<float>(i / 8) * 30;
        const float s = -z * 0.08F;
        gl.Color4fv(hue(static_cast<float>(i) / 40).data());
        gl.Begin(GL_QUADS);
        const float x = -z * 0.09F * static_cast<float>(i % 8 - 4),
                    y = -z * 0.14F * static_cast<float>(i / 8 - 2);
        gl.Vertex3f(x - s, y - s, z);
        gl.Vertex3f(x + s, y - s, z - 1);
        gl.Vertex3f(x + s, y + s, z + 1);
        gl.Vertex3f(x - s, y + s, z);
        gl.End();
    }
}

SCENE(depth_clamped_ends, "fragments at depths exactly 0 and 1, and clears to other depths") {
    pixel_projection(gl);
    gl.Enable(GL_DEPTH_TEST);
    for_cells(4, 4, [&](int cell, float x, float y, float w, float h) {
        const float clears[] = {0, 0.3F, 1, 2};
        const float depths[] = {1, 0.4F, -0.4F, -1};
        gl.Enable(GL_SCISSOR_TEST);
        gl.Scissor(static_cast<GLint>(x), static_cast<GLint>(y), static_cast<GLsizei>(w),
                   static_cast<GLsizei>(h));
        gl.ClearDepth(clears[cell / 4]);
        gl.Clear(GL_DEPTH_BUFFER_BIT);
        gl.Disable(GL_SCISSOR_TEST);
        gl.DepthFunc(GL_LEQUAL);
        gl.Color4fv(hue(static_cast<float>(cell) / 16).data());
        rectangle(gl, x + 4, y + 4, x + w - 4, y + h - 4, depths[cell % 4]);
    });
}

SCENE(depth_sixteen_bits, "intersecting slopes in a 16-bit depth buffer",
      .context = {.depth_bits = 16, .stencil_bits = 0}) {
    camera(gl, 50, 4.5F, 0.5F, 50);
    gl.Enable(GL_DEPTH_TEST);
    for (int i = 0; i < 12; ++i) {
        gl.PushMatrix();
        gl.Rotatef(static_cast<float>(i) * 30, 0.2F, 0.1F, 1);
        gl.Rotatef(25, 0, 1, 0);
        gl.Color4fv(hue(static_cast<float>(i) / 12).data());
        gl.Rectf(0, -0.3F, 2, 0.3F);
        gl.PopMatrix();
    }
}

SCENE(depth_clamp,
      "beyond the near and the far plane, with depth ranges, offset and a clipped raster position") {
    constexpr GLclampd kRanges[][2] = {{0, 1}, {0.2, 0.7}, {0.8, 0.3}, {0, 1}};
    for_viewports(gl, 2, 2, [&](int cell) {
        gl.DepthRange(kRanges[cell][0], kRanges[cell][1]);
        camera(gl, 60, 3, 2.6F, 3.2F);
        gl.Enable(GL_DEPTH_TEST);
        gl.DepthFunc(GL_LEQUAL);
        gl.Enable(GL_DEPTH_CLAMP);
        gl.Rotatef(50, 1, 0.3F, 0);
        draw_solid(gl, make_torus(0.8F, 0.35F, 28, 14), kColours);
        if (cell == 1) gl.Enable(GL_POLYGON_OFFSET_FILL);
        gl.PolygonOffset(3, 200);
        gl.Begin(GL_TRIANGLES);
        gl.Color3f(0.3F, 0.3F, 0.9F);
        gl.Vertex3f(-2, -1, -3);
        gl.Color3f(0.9F, 0.3F, 0.3F);
        gl.Vertex3f(2, -1, 1.5F);
        gl.Vertex3f(0, 2, 0.2F);
        gl.End();
        gl.Disable(GL_POLYGON_OFFSET_FILL);
        gl.RasterPos3f(0, 0, 2);
        GLfloat window[4];
        GLboolean valid = 0;
        gl.GetFloatv(GL_CURRENT_RASTER_POSITION, window);
        gl.GetBooleanv(GL_CURRENT_RASTER_POSITION_VALID, &valid);
        notes.value("valid", valid);
        notes.value("depth of the raster position", window[2], 1e-6);
        // Its depth was clamped when the raster position was set; the range of now does not matter.
        gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
        const GLubyte bits[8] = {255, 255, 255, 255, 255, 255, 255, 255};
        gl.DepthRange(0.35, 0.45);
        gl.DepthFunc(GL_ALWAYS);
        gl.Color3f(0.2F, 0.8F, 0.4F);
        gl.RasterPos3f(0, -0.6F, 0.4F);
        gl.DepthRange(0.6, 0.9);
        gl.Bitmap(8, 8, 0, 0, 0, 0, bits);
        if (cell == 3) gl.Disable(GL_DEPTH_CLAMP);
        notes.value("clamping", gl.IsEnabled(GL_DEPTH_CLAMP));
    });
}

SCENE(depth_none, "a context without depth and stencil: the tests pass",
      .context = {.depth_bits = 0, .stencil_bits = 0}, .window_only = "its theme is the context's format") {
    camera(gl, 50, 4.5F);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_NEVER);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilFunc(GL_NEVER, 0, 255);
    gl.Rotatef(40, 1, 0.4F, 0);
    draw_solid(gl, make_torus(1.2F, 0.5F, 30, 15), kColours);
}
