// Chapter: the texture environment GL_COMBINE (GL 1.5 §3.8.13): functions, sources, operands, scales,
// crossbar, dot products, and the combiners that known programs use.
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

void set(const Gl& gl, GLenum pname, GLint value) {
    gl.TexEnvi(GL_TEXTURE_ENV, pname, value);
}

struct Argument {
    GLint source, operand;
};

void combine(const Gl& gl, GLint rgb, std::initializer_list<Argument> rgb_arguments, GLint alpha,
             std::initializer_list<Argument> alpha_arguments) {
    set(gl, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    set(gl, GL_COMBINE_RGB, rgb);
    set(gl, GL_COMBINE_ALPHA, alpha);
    GLenum i = 0;
    for (const Argument& a : rgb_arguments) {
        set(gl, GL_SRC0_RGB + i, a.source);
        set(gl, GL_OPERAND0_RGB + i++, a.operand);
    }
    i = 0;
    for (const Argument& a : alpha_arguments) {
        set(gl, GL_SRC0_ALPHA + i, a.source);
        set(gl, GL_OPERAND0_ALPHA + i++, a.operand);
    }
}

void enable_units(const Gl& gl, int count) {
    for (int unit = 0; unit < count; ++unit) {
        gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        gl.Enable(GL_TEXTURE_2D);
        painted_texture(gl, 32, 32, GL_LINEAR, GL_LINEAR, static_cast<std::uint32_t>(unit) + 5);
        const GLfloat constant[] = {0.9F, 0.3F * static_cast<float>(unit), 0.2F, 0.6F};
        gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, constant);
    }
    gl.ActiveTexture(GL_TEXTURE0);
}

void quad(const Gl& gl, int units, float x, float y, float w, float h) {
    const float corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    gl.Begin(GL_QUADS);
    for (int i = 0; i < 4; ++i) {
        gl.Color4fv(hue(static_cast<float>(i) / 4, 1, 0.25F + 0.25F * static_cast<float>(i)).data());
        for (int unit = 0; unit < units; ++unit)
            gl.MultiTexCoord2f(GL_TEXTURE0 + static_cast<GLenum>(unit),
                               corners[i][0] * static_cast<float>(unit + 1), corners[i][1]);
        gl.Vertex2f(x + 2 + corners[i][0] * (w - 4), y + 2 + corners[i][1] * (h - 4));
    }
    gl.End();
}

constexpr Argument kTexel{GL_TEXTURE, GL_SRC_COLOR}, kPrevious{GL_PREVIOUS, GL_SRC_COLOR};
constexpr Argument kTexelAlpha{GL_TEXTURE, GL_SRC_ALPHA}, kPreviousAlpha{GL_PREVIOUS, GL_SRC_ALPHA};
constexpr Argument kConstantAlpha{GL_CONSTANT, GL_SRC_ALPHA};

}  // namespace

SCENE(combine_functions, "every function for the colours, with each scale") {
    pixel_projection(gl);
    enable_units(gl, 1);
    const GLint functions[] = {GL_REPLACE,     GL_MODULATE, GL_ADD,      GL_ADD_SIGNED,
                               GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA};
    for_cells(8, 3, [&](int cell, float x, float y, float w, float h) {
        combine(gl, functions[cell % 8], {kTexel, kPrevious, kConstantAlpha}, GL_REPLACE, {kPreviousAlpha});
        set(gl, GL_RGB_SCALE, 1 << cell / 8);
        quad(gl, 1, x, y, w, h);
    });
}

SCENE(combine_alpha, "every function for alpha, blended over stripes, with each scale") {
    pixel_projection(gl);
    striped_backdrop(gl, 12);
    enable_units(gl, 1);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    const GLint functions[] = {GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT};
    for_cells(6, 3, [&](int cell, float x, float y, float w, float h) {
        combine(gl, GL_MODULATE, {kTexel, kPrevious}, functions[cell % 6],
                {kTexelAlpha, kPreviousAlpha, kConstantAlpha});
        set(gl, GL_ALPHA_SCALE, 1 << cell / 6);
        quad(gl, 1, x, y, w, h);
    });
}

SCENE(combine_operands, "sources and operands of INTERPOLATE") {
    pixel_projection(gl);
    enable_units(gl, 1);
    const GLint sources[] = {GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS};
    const GLint operands[] = {GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA};
    for_cells(8, 8, [&](int cell, float x, float y, float w, float h) {
        combine(gl, GL_INTERPOLATE,
                {{GL_TEXTURE, operands[cell % 4]},
                 {sources[cell / 16 % 4], operands[cell / 4 % 4]},
                 {sources[(cell / 16 + 1) % 4], operands[(cell + cell / 4) % 4]}},
                GL_REPLACE, {kPreviousAlpha});
        quad(gl, 1, x, y, w, h);
    });
}

SCENE(combine_crossbar, "units that use one another's texels, those of units behind them too") {
    pixel_projection(gl);
    enable_units(gl, 3);
    for_cells(3, 3, [&](int cell, float x, float y, float w, float h) {
        for (int unit = 0; unit < 3; ++unit) {
            gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
            const GLint other = GL_TEXTURE0 + (unit + 1 + cell) % 3;
            combine(gl,
                    cell < 3   ? GL_ADD_SIGNED
                    : cell < 6 ? GL_MODULATE
                               : GL_INTERPOLATE,
                    {{other, GL_SRC_COLOR}, kPrevious, {GL_TEXTURE0 + cell % 3, GL_SRC_ALPHA}}, GL_REPLACE,
                    {kPreviousAlpha});
        }
        quad(gl, 3, x, y, w, h);
    });
}

SCENE(combine_bump_map, "a normal map, DOT3 with the light in the colour, modulated by a second unit") {
    pixel_projection(gl);
    constexpr int kSide = 64;
    std::vector<std::uint8_t> normals(kSide * kSide * 4, 255);
    for (int i = 0; i < kSide * kSide; ++i) {
        const int x = i % kSide % 16 - 8, y = i / kSide % 16 - 8;
        const bool dome = x * x + y * y < 49;
        normals[static_cast<std::size_t>(4 * i)] = static_cast<std::uint8_t>(128 + (dome ? x * 15 : 0));
        normals[static_cast<std::size_t>(4 * i + 1)] = static_cast<std::uint8_t>(128 + (dome ? y * 15 : 0));
        normals[static_cast<std::size_t>(4 * i + 2)] = dome ? 180 : 255;
    }
    enable_units(gl, 2);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSide, kSide, 0, GL_RGBA, GL_UNSIGNED_BYTE, normals.data());
    for_cells(2, 2, [&](int cell, float x, float y, float w, float h) {
        gl.ActiveTexture(GL_TEXTURE0);
        combine(gl, cell % 2 ? GL_DOT3_RGBA : GL_DOT3_RGB, {kTexel, {GL_PRIMARY_COLOR, GL_SRC_COLOR}},
                GL_REPLACE, {kTexelAlpha});
        gl.ActiveTexture(GL_TEXTURE1);
        (cell > 1 ? gl.Enable : gl.Disable)(GL_TEXTURE_2D);
        combine(gl, GL_MODULATE, {kTexel, kPrevious}, GL_REPLACE, {kPreviousAlpha});
        set(gl, GL_RGB_SCALE, 2);
        quad(gl, 2, x, y, w, h);
    });
}

SCENE(combine_neverball,
      "three units as a game uses them: plain, interpolated by texel alpha, modulated by colour") {
    camera(gl, 60, 4);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    enable_units(gl, 3);
    gl.ActiveTexture(GL_TEXTURE1);
    combine(gl, GL_MODULATE, {kPrevious, kTexel}, GL_REPLACE, {kPreviousAlpha});
    gl.ActiveTexture(GL_TEXTURE2);
    combine(gl, GL_INTERPOLATE,
            {kPrevious, {GL_PRIMARY_COLOR, GL_SRC_COLOR}, {GL_TEXTURE, GL_ONE_MINUS_SRC_ALPHA}}, GL_REPLACE,
            {kPreviousAlpha});
    for (int unit = 1; unit < 3; ++unit) {
        gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        gl.Enable(GL_TEXTURE_GEN_S);
        gl.Enable(GL_TEXTURE_GEN_T);
        gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, unit == 1 ? GL_SPHERE_MAP : GL_OBJECT_LINEAR);
        gl.TexGeni(GL_T, GL_TEXTURE_GEN_MODE, unit == 1 ? GL_SPHERE_MAP : GL_OBJECT_LINEAR);
    }
    gl.Rotatef(-50, 1, 0.3F, 0);
    draw_solid(gl, make_torus(1.1F, 0.5F, 24, 16), kNormals | kTextures);
}

SCENE(combine_lists_and_stacks, "combiners in display lists and on the attribute stack") {
    pixel_projection(gl);
    enable_units(gl, 1);
    gl.NewList(1, GL_COMPILE);
    combine(gl, GL_SUBTRACT, {kTexel, kPrevious}, GL_REPLACE, {kPreviousAlpha});
    set(gl, GL_RGB_SCALE, 4);
    gl.EndList();
    gl.PushAttrib(GL_TEXTURE_BIT);
    gl.CallList(1);
    quad(gl, 1, 0, 0, 128, 256);
    gl.PopAttrib();
    quad(gl, 1, 128, 0, 128, 256);
    GLint value = 0;
    for (GLenum pname : {GL_TEXTURE_ENV_MODE, GL_COMBINE_RGB, GL_SRC1_RGB, GL_OPERAND2_RGB, GL_RGB_SCALE}) {
        gl.GetTexEnviv(GL_TEXTURE_ENV, pname, &value);
        notes.value("parameter " + std::to_string(pname), value);
    }
}
