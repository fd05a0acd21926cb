// Chapter: texture environments of 1.1 (GL 1.5 §3.8.13) over every base format.
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

const GLint kBaseFormats[] = {GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_INTENSITY, GL_RGB, GL_RGBA};

// Six cells across, one a base format; the fragment's colour varies over each cell and blends over stripes.
void environment_row(const Gl& gl, GLint mode, float y, float height) {
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, mode);
    const auto texels = painted_texels(16, 16);
    for (int i = 0; i < 6; ++i) {
        gl.TexImage2D(GL_TEXTURE_2D, 0, kBaseFormats[i], 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
        const float x = static_cast<float>(i) * 42 + 3;
        gl.Begin(GL_QUADS);
        gl.Color4f(1, 0.2F, 0.3F, 1);
        gl.TexCoord2f(0, 0), gl.Vertex2f(x, y);
        gl.Color4f(0.3F, 1, 0.2F, 0.7F);
        gl.TexCoord2f(1, 0), gl.Vertex2f(x + 39, y);
        gl.Color4f(0.2F, 0.3F, 1, 0.3F);
        gl.TexCoord2f(1, 1), gl.Vertex2f(x + 39, y + height);
        gl.Color4f(1, 1, 1, 0.9F);
        gl.TexCoord2f(0, 1), gl.Vertex2f(x, y + height);
        gl.End();
    }
}

void begin(const Gl& gl) {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_2D);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    const GLfloat constant[] = {0.9F, 0.6F, 0.1F, 0.5F};
    gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, constant);
}

}  // namespace

SCENE(env_modes_opaque, "REPLACE, MODULATE and BLEND over six base formats, colours alone") {
    begin(gl);
    // DECAL is defined for RGB and RGBA only; other formats' results are undefined, so they are left out of
    // it.
    const GLint modes[] = {GL_REPLACE, GL_MODULATE, GL_BLEND};
    for (int i = 0; i < 3; ++i) environment_row(gl, modes[i], static_cast<float>(i) * 85 + 2, 80);
}

SCENE(env_modes_blended, "the same with the resulting alpha blended over stripes") {
    begin(gl);
    gl.Disable(GL_TEXTURE_2D);
    striped_backdrop(gl, 12);
    gl.Enable(GL_TEXTURE_2D);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    const GLint modes[] = {GL_REPLACE, GL_MODULATE, GL_BLEND};
    for (int i = 0; i < 3; ++i) environment_row(gl, modes[i], static_cast<float>(i) * 85 + 2, 80);
}

SCENE(env_add, "ADD of EXT_texture_env_add over six base formats, colours alone and blended over stripes") {
    begin(gl);
    gl.Disable(GL_TEXTURE_2D);
    striped_backdrop(gl, 12);
    gl.Enable(GL_TEXTURE_2D);
    environment_row(gl, GL_ADD, 2, 120);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    environment_row(gl, GL_ADD, 130, 120);
}

SCENE(env_decal, "DECAL with RGB and RGBA textures, over colours and blended") {
    begin(gl);
    gl.TexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
    const auto texels = painted_texels(16, 16);
    for_cells(2, 2, [&](int cell, float x, float y, float w, float h) {
        if (cell == 2) gl.Enable(GL_BLEND), gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        gl.TexImage2D(GL_TEXTURE_2D, 0, cell % 2 ? GL_RGBA : GL_RGB, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                      texels.data());
        gl.Color4fv(hue(static_cast<float>(cell) / 4, 1, 0.6F).data());
        textured_rectangle(gl, x + 4, y + 4, x + w - 4, y + h - 4);
    });
}

SCENE(env_constant_colour, "TEXTURE_ENV_COLOR in float, int and clamped forms, and read back") {
    begin(gl);
    painted_texture(gl, 16, 16, GL_NEAREST, GL_NEAREST);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_BLEND);
    for_cells(2, 2, [&](int cell, float x, float y, float w, float h) {
        const GLfloat plain[] = {0.2F, 0.9F, 0.6F, 1}, wild[] = {3, -2, 0.5F, 2};
        const GLint integers[] = {2147483647, 0, 1000000000, 2147483647};
        if (cell == 0) gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, plain);
        if (cell == 1) gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, wild);
        if (cell == 2) gl.TexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, integers);
        GLfloat got[4];
        gl.GetTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, got);
        notes.values("constant " + std::to_string(cell), got, 1e-6);
        gl.Color4f(0.3F, 0.2F, 0.9F, 1);
        textured_rectangle(gl, x + 4, y + 4, x + w - 4, y + h - 4);
    });
    GLint mode = 0;
    gl.GetTexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, &mode);
    notes.value("mode", mode);
}

SCENE(env_lit_and_textured, "MODULATE over a lit solid, with smooth and flat shading") {
    const Solid torus = make_torus(1, 0.45F, 20, 12);
    for_viewports(gl, 2, 1, [&](int cell) {
        camera(gl, 70, 3);
        gl.Scalef(1, 0.5F, 1);
        gl.Enable(GL_DEPTH_TEST);
        gl.Enable(GL_LIGHTING);
        gl.Enable(GL_LIGHT0);
        gl.Enable(GL_NORMALIZE);
        gl.Enable(GL_TEXTURE_2D);
        gl.ShadeModel(cell ? GL_FLAT : GL_SMOOTH);
        painted_texture(gl, 64, 64, GL_LINEAR, GL_LINEAR);
        gl.Rotatef(-45, 1, 0.2F, 0);
        draw_solid(gl, torus, kNormals | kTextures);
    });
}
