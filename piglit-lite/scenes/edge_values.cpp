// Chapter: values at which rules that look alike part: saturation and wrapping, limits below and above what
// they limit, constant blend factors, back sides drawn as lines and points, depths one step apart (GL 1.5
// §3.3, §3.5, §4.1.4-4.1.7).
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

// Each bit of the stencil buffer as a colour over what is there.
void show_stencil(const Gl& gl) {
    gl.Disable(GL_DEPTH_TEST);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ONE);
    for (int bit = 0; bit < 8; ++bit) {
        gl.StencilFunc(GL_EQUAL, 0xff, 1U << bit);
        gl.Color4fv(hue(static_cast<float>(bit) / 8, 0.3F).data());
        rectangle(gl, 0, 0, kSize, kSize);
    }
}

}  // namespace

SCENE(stencil_saturation, "the operations on 0, 1, 254 and 255, for each outcome of the tests") {
    pixel_projection(gl);
    const GLenum operations[] = {GL_KEEP, GL_ZERO,   GL_REPLACE,   GL_INCR,
                                 GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP};
    const GLint values[] = {0, 1, 254, 255};
    gl.Enable(GL_STENCIL_TEST);
    gl.Enable(GL_DEPTH_TEST);
    for_cells(8, 12, [&](int cell, float x, float y, float w, float h) {
        const GLenum op = operations[cell % 8];
        const int value = cell / 8 % 4, outcome = cell / 32;
        gl.DepthFunc(GL_ALWAYS);
        gl.StencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE);
        gl.StencilFunc(GL_ALWAYS, values[value], 0xff);
        gl.Color3f(0.2F, 0.2F, 0.2F);
        rectangle(gl, x + 1, y + 1, x + w - 1, y + h - 1);
        gl.StencilFunc(outcome == 0 ? GL_NEVER : GL_ALWAYS, 0x5c, 0xff);
        gl.DepthFunc(outcome == 1 ? GL_NEVER : GL_ALWAYS);
        gl.StencilOp(outcome == 0 ? op : GL_ZERO, outcome == 1 ? op : GL_ZERO, outcome == 2 ? op : GL_ZERO);
        rectangle(gl, x + 5, y + 4, x + w - 5, y + h - 4);
    });
    show_stencil(gl);
}

SCENE(stencil_references_beyond_the_buffer,
      "references below 0 and above 255 are clamped to what the buffer holds") {
    pixel_projection(gl);
    gl.Enable(GL_STENCIL_TEST);
    const GLint references[] = {-70000, -1, 0, 1, 254, 255, 256, 70000};
    const GLenum functions[] = {GL_LESS, GL_EQUAL, GL_GREATER, GL_GEQUAL};
    for_cells(8, 4, [&](int cell, float x, float y, float w, float h) {
        gl.StencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE);
        gl.StencilFunc(GL_ALWAYS, references[cell % 8], 0xff);
        gl.Color3f(0.2F, 0.2F, 0.2F);
        rectangle(gl, x + 1, y + 1, x + w - 1, y + h - 1);
        gl.StencilOp(GL_KEEP, GL_KEEP, GL_INVERT);
        gl.StencilFunc(functions[cell / 8], references[(cell * 3 + 1) % 8], 0xff);
        gl.Color4fv(hue(static_cast<float>(cell) / 32).data());
        rectangle(gl, x + 6, y + 6, x + w - 6, y + h - 6);
    });
    show_stencil(gl);
}

SCENE(blend_constant_factors, "constant colours and alphas as every factor, under every equation") {
    pixel_projection(gl);
    striped_backdrop(gl, 16);
    gl.Enable(GL_BLEND);
    gl.BlendColor(0.85F, 0.15F, 0.45F, 0.65F);
    const GLenum factors[] = {GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_COLOR,
                              GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA,
                              GL_SRC_ALPHA,      GL_ONE_MINUS_DST_COLOR};
    const GLenum equations[] = {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT};
    for_cells(12, 9, [&](int cell, float x, float y, float w, float h) {
        const int source = cell % 6, destination = cell / 6 % 6, equation = cell / 36;
        gl.BlendEquation(equations[equation]);
        gl.BlendFuncSeparate(factors[source], factors[destination], factors[destination],
                             factors[(source + 1) % 6]);
        const Colour colour = hue(static_cast<float>(cell) / 108, 0.8F, 0.3F);
        gl.Color4fv(colour.data());
        rectangle(gl, x + 2, y + 2, x + w - 2, y + h - 2);
    });
}

SCENE(blend_constant_color_changes, "a constant colour changes between draws, also beyond 0 and 1") {
    pixel_projection(gl);
    striped_backdrop(gl, 4);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_ALPHA);
    for_cells(6, 6, [&](int cell, float x, float y, float w, float h) {
        const float step = static_cast<float>(cell) / 18 - 0.5F;
        gl.BlendColor(step, 1 - step, 0.5F + step / 2, 1.25F - step);
        gl.Color4f(0.9F, 0.8F, 0.7F, 0.6F);
        rectangle(gl, x + 2, y + 2, x + w - 2, y + h - 2);
    });
}

SCENE(point_size_limits, "attenuated sizes below the minimum, between both and above the maximum") {
    camera(gl, 60, 2, 0.5F, 40);
    const GLfloat attenuations[][3] = {{0, 0, 0.04F}, {0, 0.3F, 0}, {0.5F, 0, 0.01F}, {1, 0, 0}};
    const GLfloat limits[][2] = {{0, 255}, {6, 255}, {0, 9}, {5, 12}};
    for_viewports(gl, 4, 4, [&](int cell) {
        gl.PointSize(11);
        gl.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuations[cell % 4]);
        gl.PointParameterf(GL_POINT_SIZE_MIN, limits[cell / 4][0]);
        gl.PointParameterf(GL_POINT_SIZE_MAX, limits[cell / 4][1]);
        gl.Begin(GL_POINTS);
        for (int i = 0; i < 7; ++i) {
            const float depth = static_cast<float>(i * i) * 0.6F;
            gl.Color4fv(hue(static_cast<float>(i) / 7).data());
            gl.Vertex3f(-0.8F - depth * 0.35F + static_cast<float>(i) * (0.27F + depth * 0.1F), 0.1F * depth,
                        -depth);
        }
        gl.End();
    });
}

// Sizes below the threshold fade where points are multisampled (GL 1.5 §3.3); elsewhere the threshold is
// nothing.
SCENE(point_fade_threshold_alone,
      "a fade threshold above every size changes nothing in a window without samples") {
    pixel_projection(gl);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (int i = 0; i < 12; ++i) {
        gl.PointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, static_cast<float>(i) * 3);
        gl.PointSize(2.0F + static_cast<float>(i % 5) * 2);
        gl.Begin(GL_POINTS);
        for (int k = 0; k < 12; ++k) {
            gl.Color4fv(hue(static_cast<float>(k) / 12, 1, 0.75F).data());
            gl.Vertex2f(12 + static_cast<float>(i) * 20, 12 + static_cast<float>(k) * 20);
        }
        gl.End();
    }
}

SCENE(back_sides_as_lines_and_points,
      "two-sided light with separate specular colours, both sides in every mode") {
    const GLenum modes[] = {GL_FILL, GL_LINE, GL_POINT};
    const GLfloat front[] = {0.9F, 0.2F, 0.1F, 1}, back[] = {0.1F, 0.3F, 0.9F, 1};
    const GLfloat front_shine[] = {0.2F, 0.9F, 0.1F, 1}, back_shine[] = {0.9F, 0.8F, 0, 1};
    camera(gl, 50, 4);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    const GLfloat white[] = {1, 1, 1, 1}, position[] = {1, 1, 3, 0};
    gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
    gl.Lightfv(GL_LIGHT0, GL_SPECULAR, white);
    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    gl.Materialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, front);
    gl.Materialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, back);
    gl.Materialfv(GL_FRONT, GL_SPECULAR, front_shine);
    gl.Materialfv(GL_BACK, GL_SPECULAR, back_shine);
    gl.Materialf(GL_FRONT, GL_SHININESS, 6);
    gl.Materialf(GL_BACK, GL_SHININESS, 3);
    const GLubyte white_texel[] = {255, 255, 255, 255};
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, white_texel);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    const Solid torus = make_torus(0.9F, 0.5F, 16, 8);
    for_viewports(gl, 3, 3, [&](int cell) {
        gl.PolygonMode(GL_FRONT, modes[cell % 3]);
        gl.PolygonMode(GL_BACK, modes[cell / 3]);
        // The texture keeps the two colours apart up to the fragments.
        if (cell % 2) gl.Enable(GL_TEXTURE_2D);
        gl.PointSize(3);
        gl.ShadeModel(cell % 4 == 3 ? GL_FLAT : GL_SMOOTH);
        gl.PushMatrix();
        gl.Rotatef(50, 1, 0.5F, 0);
        gl.FrontFace(cell % 2 ? GL_CW : GL_CCW);
        draw_solid(gl, torus, kNormals | kTextures);
        gl.PopMatrix();
        gl.Disable(GL_TEXTURE_2D);
    });
}

// Window depths of neighbouring steps of 16 bits, and halves of a step, under each comparison.
SCENE(depth_steps_16_bits, "nearly coplanar polygons under each comparison", .context = {.depth_bits = 16}) {
    pixel_projection(gl);
    gl.Enable(GL_DEPTH_TEST);
    const GLenum functions[] = {GL_LESS, GL_LEQUAL, GL_EQUAL, GL_GEQUAL, GL_GREATER, GL_NOTEQUAL};
    const float step = 2.0F / 65535;
    for_cells(6, 5, [&](int cell, float x, float y, float w, float h) {
        gl.DepthFunc(GL_ALWAYS);
        gl.Color3f(0.3F, 0.3F, 0.3F);
        const float slope = static_cast<float>(cell / 6) * 40 * step;
        const auto sloping = [&](float z) {
            gl.Begin(GL_QUADS);
            gl.Vertex3f(x + 1, y + 1, z);
            gl.Vertex3f(x + w - 1, y + 1, z + slope);
            gl.Vertex3f(x + w - 1, y + h - 1, z + slope * 1.5F);
            gl.Vertex3f(x + 1, y + h - 1, z + slope * 0.5F);
            gl.End();
        };
        sloping(0.25F);
        gl.DepthFunc(functions[cell % 6]);
        for (int i = -3; i <= 3; ++i) {
            gl.Color4fv(hue(static_cast<float>(i + 3) / 7).data());
            gl.Enable(GL_SCISSOR_TEST);
            gl.Scissor(static_cast<GLint>(x), static_cast<GLint>(y + static_cast<float>(i + 3) * h / 7),
                       static_cast<GLsizei>(w), static_cast<GLsizei>(h / 7));
            sloping(0.25F + static_cast<float>(i) * 0.5F * step);
            gl.Disable(GL_SCISSOR_TEST);
        }
    });
}

SCENE(depth_lequal_over_itself_16_bits,
      "a mesh drawn over itself, by LEQUAL and EQUAL, with and without offset",
      .context = {.depth_bits = 16}) {
    camera(gl, 40, 6, 1, 200);
    gl.Enable(GL_DEPTH_TEST);
    const Solid torus = make_torus(1, 0.45F, 24, 12);
    const GLenum functions[] = {GL_LESS, GL_LEQUAL, GL_EQUAL, GL_GREATER};
    for_viewports(gl, 4, 2, [&](int cell) {
        gl.PushMatrix();
        gl.Rotatef(35, 1, 0.3F, 0);
        gl.DepthFunc(GL_LESS);
        draw_solid(gl, torus, kColours);
        gl.DepthFunc(functions[cell % 4]);
        gl.Enable(GL_BLEND);
        gl.BlendFunc(GL_ONE, GL_ONE);
        if (cell / 4) {
            gl.Enable(GL_POLYGON_OFFSET_FILL);
            gl.PolygonOffset(0, 1);
        }
        gl.Color3f(0, 0.4F, 0.6F);
        draw_solid(gl, torus, kPositions);
        gl.Disable(GL_POLYGON_OFFSET_FILL);
        gl.Disable(GL_BLEND);
        gl.PopMatrix();
    });
}
