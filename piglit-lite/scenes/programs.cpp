// Small programs of the kind people wrote: many features together in one picture.
#include <cmath>

#include "helpers.h"
#include "study/scenes.h"

using namespace terrazzo::piglit;

namespace {

// A toothed wheel, flat and lit, in quads.
void gear(const Gl& gl, float inner, float outer, float width, int teeth, float depth) {
    const auto direction = [teeth](int quarter) {
        const float a = 6.2831853F * static_cast<float>(quarter) / static_cast<float>(4 * teeth);
        return std::array{std::cos(a), std::sin(a)};
    };
    const auto radius = [&](int quarter) {
        return quarter % 4 == 1 || quarter % 4 == 2 ? outer + depth / 2 : outer - depth / 2;
    };
    gl.ShadeModel(GL_FLAT);
    for (const float side : {1.0F, -1.0F}) {
        gl.Normal3f(0, 0, side);
        gl.Begin(GL_QUAD_STRIP);
        for (int q = 0; q <= 4 * teeth; ++q) {
            const auto d = direction(q);
            const float near_r = side > 0 ? inner : radius(q), far_r = side > 0 ? radius(q) : inner;
            gl.Vertex3f(near_r * d[0], near_r * d[1], side * width / 2);
            gl.Vertex3f(far_r * d[0], far_r * d[1], side * width / 2);
        }
        gl.End();
    }
    gl.Begin(GL_QUAD_STRIP);
    for (int q = 0; q <= 4 * teeth; ++q) {
        const auto d = direction(q), next = direction(q + 1);
        gl.Normal3f(d[0] + next[0], d[1] + next[1], 0);
        gl.Vertex3f(radius(q) * d[0], radius(q) * d[1], width / 2);
        gl.Vertex3f(radius(q) * d[0], radius(q) * d[1], -width / 2);
    }
    gl.End();
    gl.ShadeModel(GL_SMOOTH);
    gl.Begin(GL_QUAD_STRIP);
    for (int q = 0; q <= 4 * teeth; q += 2) {
        const auto d = direction(q);
        gl.Normal3f(-d[0], -d[1], 0);
        gl.Vertex3f(inner * d[0], inner * d[1], -width / 2);
        gl.Vertex3f(inner * d[0], inner * d[1], width / 2);
    }
    gl.End();
}

void study(const Gl& gl, const char* name) {
    const auto drawing = terrazzo::study::create_scene(name);
    drawing->prepare(gl, terrazzo::study::kWidth, terrazzo::study::kHeight);
    drawing->draw(gl, 0);
    gl.Finish();  // the arrays go with this function
}

}  // namespace

SCENE(program_gears, "three meshing gears: lists, flat and smooth shading, culling, light") {
    camera(gl, 50, 15, 5, 60);
    const GLfloat position[] = {5, 5, 10, 0};
    gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
    for (const GLenum capability : {GL_CULL_FACE, GL_LIGHTING, GL_LIGHT0, GL_DEPTH_TEST, GL_NORMALIZE})
        gl.Enable(capability);
    const struct {
        float inner, outer, width;
        int teeth;
        float x, y, turn;
        Colour colour;
    } gears[] = {{1, 4, 1, 20, -3, -2, 0, {0.8F, 0.1F, 0, 1}},
                 {0.5F, 2, 2, 10, 3.1F, -2, -9, {0, 0.8F, 0.2F, 1}},
                 {1.3F, 2, 0.5F, 10, -3.1F, 4.2F, -25, {0.2F, 0.2F, 1, 1}}};
    gl.Rotatef(20, 1, 0, 0);
    gl.Rotatef(30, 0, 1, 0);
    GLuint list = gl.GenLists(3);
    for (const auto& g : gears) {
        gl.NewList(list, GL_COMPILE);
        gl.Materialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, g.colour.data());
        gear(gl, g.inner, g.outer, g.width, g.teeth, 0.7F);
        gl.EndList();
        gl.PushMatrix();
        gl.Translatef(g.x, g.y, 0);
        gl.Rotatef(g.turn, 0, 0, 1);
        gl.CallList(list++);
        gl.PopMatrix();
    }
}

SCENE(program_solar_system,
      "textured, lit spheres on nested matrices, orbits as stippled lines, stars as points") {
    camera(gl, 50, 9);
    gl.Enable(GL_DEPTH_TEST);
    Random random(99);
    gl.PointSize(2);
    gl.Begin(GL_POINTS);
    for (int i = 0; i < 200; ++i) {
        const float light = random(0.3F, 1);
        gl.Color3f(light, light, light);
        InOrder{gl.Vertex3f, random(-8, 8), random(-8, 8), -8};
    }
    gl.End();
    gl.Rotatef(30, 1, 0, 0);
    gl.Enable(GL_LINE_STIPPLE);
    gl.LineStipple(1, 0x3333);
    for (int orbit = 1; orbit <= 4; ++orbit) {
        gl.Begin(GL_LINE_LOOP);
        gl.Color4fv(hue(static_cast<float>(orbit) / 5).data());
        for (int i = 0; i < 64; ++i)
            gl.Vertex3f(static_cast<float>(orbit) * std::cos(0.0982F * static_cast<float>(i)), 0,
                        static_cast<float>(orbit) * std::sin(0.0982F * static_cast<float>(i)));
        gl.End();
    }
    painted_texture(gl, 64, 32, GL_LINEAR, GL_LINEAR);
    gl.Enable(GL_TEXTURE_2D);
    gl.Enable(GL_NORMALIZE);
    const Solid sphere = make_sphere(1, 14, 24);
    for (int orbit = 0; orbit <= 4; ++orbit) {
        if (orbit == 1) {
            const GLfloat centre[] = {0, 0, 0, 1};
            gl.Enable(GL_LIGHTING);
            gl.Enable(GL_LIGHT0);
            gl.Lightfv(GL_LIGHT0, GL_POSITION, centre);
        }
        gl.PushMatrix();
        gl.Rotatef(static_cast<float>(orbit) * 100, 0, 1, 0);
        gl.Translatef(static_cast<float>(orbit), 0, 0);
        const float size = orbit == 0 ? 0.7F : 0.2F + 0.06F * static_cast<float>(orbit);
        gl.Scalef(size, size, size);
        gl.Color4fv(hue(static_cast<float>(orbit) / 5, 1).data());
        draw_solid(gl, sphere, kNormals | kTextures);
        gl.PopMatrix();
    }
}

SCENE(program_plot, "a 2D chart: grid, stippled axes, curves, bars with blending and a scissored legend") {
    pixel_projection(gl);
    gl.Color3f(0.95F, 0.95F, 0.92F);
    rectangle(gl, 20, 20, 246, 246);
    gl.Enable(GL_LINE_STIPPLE);
    gl.LineStipple(1, 0x5555);
    gl.Color3f(0.7F, 0.7F, 0.7F);
    gl.Begin(GL_LINES);
    for (int i = 1; i < 10; ++i) {
        const float p = 20 + 22.6F * static_cast<float>(i);
        gl.Vertex2f(p, 20), gl.Vertex2f(p, 246), gl.Vertex2f(20, p), gl.Vertex2f(246, p);
    }
    gl.End();
    gl.Disable(GL_LINE_STIPPLE);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (int i = 0; i < 9; ++i) {
        gl.Color4fv(hue(static_cast<float>(i) / 9, 0.8F, 0.6F).data());
        rectangle(gl, 30 + 23 * static_cast<float>(i), 20, 46 + 23 * static_cast<float>(i),
                  60 + 100 * std::fabs(std::sin(static_cast<float>(i))));
    }
    gl.LineWidth(2);
    for (int curve = 0; curve < 3; ++curve) {
        gl.Color4fv(hue(static_cast<float>(curve) / 3, 0.7F).data());
        gl.Begin(GL_LINE_STRIP);
        for (int i = 0; i <= 75; ++i)
            gl.Vertex2f(20 + 3 * static_cast<float>(i),
                        130 + 80 * std::sin(0.1F * static_cast<float>(i) + static_cast<float>(curve)));
        gl.End();
    }
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(180, 190, 60, 50);
    gl.ClearColor(1, 1, 0.8F, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
}

SCENE(program_planar_shadow,
      "a solid and its shadow by a flattening matrix, stencil against double blending, fog") {
    camera(gl, 45, 6);
    gl.Rotatef(25, 1, 0, 0);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_FOG);
    gl.Fogi(GL_FOG_MODE, GL_LINEAR);
    gl.Fogf(GL_FOG_START, 4);
    gl.Fogf(GL_FOG_END, 11);
    gl.Enable(GL_TEXTURE_2D);
    painted_texture(gl, 64, 64, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.PushMatrix();
    gl.Translatef(0, -1.2F, 0);
    gl.Rotatef(-90, 1, 0, 0);
    textured_rectangle(gl, -4, -4, 4, 4, 6, 6);
    gl.PopMatrix();
    gl.Disable(GL_TEXTURE_2D);
    const Solid torus = make_torus(0.9F, 0.35F, 30, 16);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilFunc(GL_EQUAL, 0, 255);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl.Enable(GL_POLYGON_OFFSET_FILL);
    gl.PolygonOffset(-1, -4);
    gl.Color4f(0, 0, 0, 0.5F);
    const GLfloat flatten[16] = {1, 0, 0, 0, 0.4F, 0, 0.2F, 0, 0, 0, 1, 0, 0, -1.2F, 0, 1};
    for (int pass = 0; pass < 2; ++pass) {
        gl.PushMatrix();
        if (pass == 0) gl.MultMatrixf(flatten);
        gl.Translatef(0, 0.4F, 0);
        gl.Rotatef(50, 1, 0.7F, 0);
        draw_solid(gl, torus, pass == 0 ? kPositions : kNormals);
        gl.PopMatrix();
        gl.Disable(GL_STENCIL_TEST);
        gl.Disable(GL_BLEND);
        gl.Disable(GL_POLYGON_OFFSET_FILL);
        gl.Enable(GL_LIGHTING);
        gl.Enable(GL_LIGHT0);
        gl.Enable(GL_NORMALIZE);
    }
}

SCENE(program_environment_mapped_teapot, "sphere-mapped, lit, two-sided surfaces over a gradient sky") {
    gl.Begin(GL_QUADS);
    gl.Color3f(0.8F, 0.7F, 0.5F), gl.Vertex3f(-1, -1, 1), gl.Vertex3f(1, -1, 1);
    gl.Color3f(0.1F, 0.2F, 0.5F), gl.Vertex3f(1, 1, 1), gl.Vertex3f(-1, 1, 1);
    gl.End();
    camera(gl, 45, 4.4F);
    for (const GLenum capability : {GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0, GL_TEXTURE_2D, GL_TEXTURE_GEN_S,
                                    GL_TEXTURE_GEN_T, GL_NORMALIZE})
        gl.Enable(capability);
    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    for (const GLenum coordinate : {GL_S, GL_T}) gl.TexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
    painted_texture(gl, 64, 64, GL_LINEAR, GL_LINEAR);
    gl.Rotatef(25, 1, 0.4F, 0);
    draw_solid(gl, make_torus(1.1F, 0.5F, 40, 20), kNormals);
}

// The study's scenes at their own size. Under perspective a host's fused arithmetic can move a snapped
// vertex: at most 1 triangle in 10 000 may differ, by edge pixels (promise P2).
SCENE(study_t1, "T1 of the rasterization study: pyramid and cube",
      .context = {.width = 1024, .height = 1024}) {
    study(gl, "T1");
}
SCENE(study_t2, "T2: 8192 random triangles", .context = {.width = 1024, .height = 1024}) {
    study(gl, "T2");
}
SCENE(study_t3, "T3: textured cubes and pyramids", .context = {.width = 1024, .height = 1024}) {
    study(gl, "T3");
}
SCENE(study_t4, "T4: a teapot on a floor", .context = {.width = 1024, .height = 1024}) {
    study(gl, "T4");
}
SCENE(study_t5, "T5: nine teapots", .context = {.width = 1024, .height = 1024}) {
    study(gl, "T5");
}
SCENE(study_t6, "T6: a height field", .context = {.width = 1024, .height = 1024}) {
    study(gl, "T6");
}
