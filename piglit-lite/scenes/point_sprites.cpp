// Chapter: point sprites (ARB_point_sprite): squares of any size, coordinates replaced on some units.
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

void enable_units(const Gl& gl, int count, GLenum filter) {
    for (int unit = count - 1; unit >= 0; --unit) {
        gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        gl.Enable(GL_TEXTURE_2D);
        painted_texture(gl, 16 << unit, 16, filter, filter, static_cast<std::uint32_t>(unit) + 2);
    }
}

void some_points(const Gl& gl, int seed) {
    Random random(static_cast<std::uint32_t>(seed));
    gl.Begin(GL_POINTS);
    for (int i = 0; i < 24; ++i) {
        gl.Color4fv(hue(static_cast<float>(i) / 24, 1, 0.7F).data());
        InOrder{gl.TexCoord2f, random(0, 1), random(0, 1)};
        InOrder{gl.MultiTexCoord2f, GL_TEXTURE1, random(0, 1), random(0, 1)};
        InOrder{gl.Vertex3f, random(-1.2F, 1.2F), random(-1.2F, 1.2F), random(-3, 0)};
    }
    gl.End();
}

}  // namespace

SCENE(sprite_sizes, "sprites of sizes between pixels, nearest and linear") {
    pixel_projection(gl);
    gl.Enable(GL_POINT_SPRITE);
    gl.TexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, GL_TRUE);
    for_cells(8, 8, [&](int cell, float x, float y, float w, float h) {
        enable_units(gl, 1, cell % 2 ? GL_LINEAR : GL_NEAREST);
        gl.PointSize(0.4F + 0.47F * static_cast<float>(cell));
        gl.Begin(GL_POINTS);
        gl.Vertex2f(x + w * 0.5F + 0.13F * static_cast<float>(cell % 5),
                    y + h * 0.5F - 0.25F * static_cast<float>(cell % 4));
        gl.End();
    });
}

SCENE(sprite_units, "coordinates replaced on the first unit, on the second, on both, on none") {
    for_viewports(gl, 2, 2, [&](int cell) {
        camera(gl, 60, 3);
        enable_units(gl, 2, GL_LINEAR);
        gl.Enable(GL_POINT_SPRITE);
        gl.PointSize(24.6F);
        for (int unit = 0; unit < 2; ++unit) {
            gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
            gl.TexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, cell >> unit & 1);
        }
        some_points(gl, 3);
    });
}

SCENE(sprite_perspective,
      "attenuated sprites in perspective, blended, depth-tested, over the window's edges") {
    camera(gl, 60, 3);
    enable_units(gl, 1, GL_LINEAR);
    gl.Enable(GL_POINT_SPRITE);
    gl.Enable(GL_POINT_SMOOTH);  // without effect on sprites
    gl.TexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, GL_TRUE);
    const GLfloat attenuation[] = {0, 0, 0.05F};
    gl.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
    gl.PointSize(30);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE);
    for (int seed = 0; seed < 4; ++seed) some_points(gl, seed);
}

SCENE(sprite_projective, "sprites whose other coordinates have a q, and polygons drawn as points") {
    for_viewports(gl, 2, 1, [&](int cell) {
        camera(gl, 60, 3);
        enable_units(gl, 1, GL_LINEAR);
        gl.Enable(GL_POINT_SPRITE);
        gl.TexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, GL_TRUE);
        gl.PointSize(17.3F);
        gl.PolygonMode(GL_FRONT_AND_BACK, GL_POINT);
        gl.Begin(cell ? GL_QUADS : GL_POINTS);
        for (int i = 0; i < 8; ++i) {
            gl.TexCoord4f(1, 2, 0, 2);
            gl.Vertex3f(static_cast<float>(i % 4 / 2) - 0.5F, static_cast<float>((i + 1) % 4 / 2) - 0.5F,
                        -static_cast<float>(i / 4));
        }
        gl.End();
    });
}
