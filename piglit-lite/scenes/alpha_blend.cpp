// Chapter: alpha test and blending (GL 1.5 §4.1.4, §4.1.8).
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

// A quad whose four corners differ in colour and alpha, so that every factor has something to do.
void source_quad(const Gl& gl, float x, float y, float w, float h) {
    const Colour corners[] = {
        {0.9F, 0.2F, 0.1F, 0.1F}, {0.2F, 0.8F, 0.3F, 0.5F}, {0.1F, 0.3F, 1, 0.9F}, {1, 0.9F, 0.6F, 0.7F}};
    const float places[][2] = {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
    gl.Begin(GL_QUADS);
    for (int i = 0; i < 4; ++i) {
        gl.Color4fv(corners[i].data());
        gl.Vertex2fv(places[i]);
    }
    gl.End();
}

const GLenum kSourceFactors[] = {GL_ZERO,
                                 GL_ONE,
                                 GL_DST_COLOR,
                                 GL_ONE_MINUS_DST_COLOR,
                                 GL_SRC_ALPHA,
                                 GL_ONE_MINUS_SRC_ALPHA,
                                 GL_DST_ALPHA,
                                 GL_ONE_MINUS_DST_ALPHA,
                                 GL_SRC_ALPHA_SATURATE};
const GLenum kDestinationFactors[] = {GL_ZERO,      GL_ONE,
                                      GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR,
                                      GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA,
                                      GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA};

}  // namespace

SCENE(blend_all_factors, "nine source by eight destination factors over a striped ground with alpha") {
    pixel_projection(gl);
    striped_backdrop(gl, 16);
    gl.Enable(GL_BLEND);
    for_cells(9, 8, [&](int cell, float x, float y, float w, float h) {
        gl.BlendFunc(kSourceFactors[cell % 9], kDestinationFactors[cell / 9]);
        source_quad(gl, x + 2, y + 2, w - 4, h - 4);
    });
    GLint factor = 0;
    gl.GetIntegerv(GL_BLEND_SRC, &factor);
    notes.value("source factor", factor);
}

SCENE(blend_colour_factors_1_4,
      "source factors of source colour and destination factors of destination colour (GL 1.4)") {
    pixel_projection(gl);
    striped_backdrop(gl, 16);
    gl.Enable(GL_BLEND);
    const GLenum pairs[][2] = {{GL_SRC_COLOR, GL_ZERO},
                               {GL_ONE_MINUS_SRC_COLOR, GL_ONE},
                               {GL_ZERO, GL_DST_COLOR},
                               {GL_ONE, GL_ONE_MINUS_DST_COLOR}};
    for_cells(2, 2, [&](int cell, float x, float y, float w, float h) {
        gl.BlendFunc(pairs[cell][0], pairs[cell][1]);
        source_quad(gl, x + 6, y + 6, w - 12, h - 12);
    });
}

SCENE(blend_layers, "a hundred translucent discs, where every rounding adds up") {
    pixel_projection(gl);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    Random random(8);
    for (int i = 0; i < 100; ++i) {
        const float x = random(0, 256), y = random(0, 256), r = random(10, 60);
        const float turn = random(0, 1), alpha = random(0.05F, 0.4F);
        const Colour colour = hue(turn, 1, alpha);
        gl.Begin(GL_TRIANGLE_FAN);
        gl.Color4fv(colour.data());
        gl.Vertex2f(x, y);
        gl.Color4f(colour[0], colour[1], colour[2], 0.02F);
        for (int k = 0; k <= 20; ++k) {
            const Colour d = hue(static_cast<float>(k) / 20);
            gl.Vertex2f(x + r * (d[0] - 0.55F) / 0.45F, y + r * (d[1] - d[2]) / 0.78F);
        }
        gl.End();
    }
}

SCENE(blend_additive_sparks, "ONE, ONE saturates; points, lines and triangles add alike") {
    pixel_projection(gl);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ONE);
    Random random(21);
    gl.PointSize(5);
    gl.LineWidth(2);
    for (int i = 0; i < 240; ++i) {
        const float x = random(20, 236), y = random(20, 236);
        const GLenum modes[] = {GL_POINTS, GL_LINES, GL_TRIANGLES};
        gl.Begin(modes[i % 3]);
        for (int k = 0; k < 3 - (i % 3 == 1); ++k) {
            gl.Color4fv(hue(static_cast<float>(i) / 240, 0.35F).data());
            InOrder{gl.Vertex2f, x + random(-20, 20), y + random(-20, 20)};
        }
        gl.End();
    }
}

SCENE(blend_texture_and_depth, "translucent textured solids back to front with depth writes off") {
    camera(gl, 50, 5);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_CULL_FACE);
    gl.PushMatrix();
    gl.Rotatef(30, 1, 1, 0);
    draw_solid(gl, make_box(0.7F), kColours);
    gl.PopMatrix();
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl.DepthMask(GL_FALSE);
    gl.Enable(GL_TEXTURE_2D);
    painted_texture(gl, 64, 64, GL_LINEAR, GL_LINEAR);
    gl.Color4f(1, 1, 1, 0.55F);
    gl.Rotatef(-50, 1, 0.3F, 0);
    const Solid torus = make_torus(1.3F, 0.45F, 30, 16);
    for (const GLenum face : {GL_FRONT, GL_BACK}) {
        gl.CullFace(face);
        draw_solid(gl, torus, kTextures);
    }
}

SCENE(alpha_test_functions, "the eight functions against references on a ramp of alpha") {
    pixel_projection(gl);
    gl.Enable(GL_ALPHA_TEST);
    const GLenum functions[] = {GL_NEVER,   GL_LESS,     GL_EQUAL,  GL_LEQUAL,
                                GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};
    const float references[] = {0, 0.25F, 0.5F, 0.75F, 1};
    for_cells(5, 8, [&](int cell, float x, float y, float w, float h) {
        gl.AlphaFunc(functions[cell / 5], references[cell % 5]);
        gl.Begin(GL_QUAD_STRIP);
        for (int i = 0; i <= 4; ++i) {
            const float t = static_cast<float>(i) / 4;
            gl.Color4f(t, 1 - t, 0.5F, t);
            gl.Vertex2f(x + 2 + t * (w - 4), y + 2);
            gl.Vertex2f(x + 2 + t * (w - 4), y + h - 2);
        }
        gl.End();
    });
    GLfloat reference = 0;
    gl.AlphaFunc(GL_LESS, 3);
    gl.GetFloatv(GL_ALPHA_TEST_REF, &reference);
    notes.value("clamped reference", reference, 1e-6);
}

SCENE(alpha_test_texture_cutout, "a cut-out texture: failed fragments write neither colour nor depth") {
    camera(gl, 50, 4);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_ALPHA_TEST);
    gl.AlphaFunc(GL_GREATER, 0.5F);
    gl.Enable(GL_TEXTURE_2D);
    painted_texture(gl, 32, 32, GL_LINEAR, GL_LINEAR);
    for (int i = 0; i < 3; ++i) {
        gl.PushMatrix();
        gl.Rotatef(static_cast<float>(i) * 60 + 15, 0.3F, 1, 0);
        gl.Color4fv(hue(static_cast<float>(i) / 3).data());
        textured_rectangle(gl, -1.4F, -1.4F, 1.4F, 1.4F, 2, 2);
        gl.PopMatrix();
    }
}
