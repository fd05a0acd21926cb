// Chapter: minification, magnification, mipmaps and wrap modes (GL 1.5 §3.8.7-3.8.9).
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

void filters(const Gl& gl, GLenum min, GLenum mag) {
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(min));
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(mag));
}

// A floor running to the horizon: all levels of detail in one picture.
void floor_plane(const Gl& gl, float tiles) {
    receding_rectangle(gl, {4, -1, 0, -1, -32}, tiles, 4 * tiles);
}

}  // namespace

SCENE(filter_nearest_magnified, "NEAREST over rotated, enlarged texels") {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_2D);
    painted_texture(gl, 16, 16, GL_NEAREST, GL_NEAREST);
    gl.Translatef(128, 128, 0);
    gl.Rotatef(17, 0, 0, 1);
    textured_rectangle(gl, -110, -110, 110, 110, 1.7F, 1.3F);
}

SCENE(filter_linear_magnified, "LINEAR between enlarged texels, across the repeating seam") {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_2D);
    painted_texture(gl, 8, 8, GL_LINEAR, GL_LINEAR);
    gl.Translatef(128, 128, 0);
    gl.Rotatef(-23, 0, 0, 1);
    textured_rectangle(gl, -110, -110, 110, 110, 1.6F, 1.6F);
}

SCENE(filter_linear_perspective, "LINEAR in perspective on a solid, textures of and not of powers of two") {
    for_viewports(gl, 2, 2, [&](int cell) {
        camera(gl, 50, 4);
        gl.Enable(GL_DEPTH_TEST);
        gl.Enable(GL_TEXTURE_2D);
        const int sizes[][2] = {{64, 64}, {100, 36}, {17, 93}, {128, 16}};
        painted_texture(gl, sizes[cell][0], sizes[cell][1], GL_LINEAR, GL_LINEAR,
                        static_cast<std::uint32_t>(cell));
        gl.Rotatef(static_cast<float>(cell) * 25 - 60, 1, 0.6F, 0);
        draw_solid(gl, make_torus(1.1F, 0.55F, 24, 12), kTextures);
    });
}

SCENE(filter_all_minifications, "the six minification filters on a floor, every level in its own colour") {
    for_viewports(gl, 3, 2, [&](int cell) {
        camera(gl, 60, 1, 0.3F, 60);
        gl.Enable(GL_TEXTURE_2D);
        gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        coloured_levels(gl, 64, 64);
        filters(gl, kMinFilters[cell], GL_LINEAR);
        floor_plane(gl, 4);
    });
}

SCENE(filter_magnification_threshold,
      "where minification turns into magnification, for each pair of filters") {
    for_viewports(gl, 4, 3, [&](int cell) {
        camera(gl, 60, 0.2F, 0.1F, 60);
        gl.Enable(GL_TEXTURE_2D);
        gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        coloured_levels(gl, 32, 32);
        filters(gl, kMinFilters[cell % 6], cell < 6 ? GL_NEAREST : GL_LINEAR);
        gl.Rotatef(static_cast<float>(cell) * 7, 0, 0, 1);
        floor_plane(gl, 2);
    });
}

SCENE(filter_mipmap_shapes, "mipmaps of long, flat and odd images, sampled at many scales") {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_2D);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    const int shapes[][2] = {{64, 4}, {2, 64}, {48, 20}, {33, 65}};
    for (int i = 0; i < 4; ++i) {
        GLuint name = 0;
        gl.GenTextures(1, &name);
        gl.BindTexture(GL_TEXTURE_2D, name);
        coloured_levels(gl, shapes[i][0], shapes[i][1]);
        filters(gl, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
        float x = 4;
        for (int k = 0; k < 7; ++k) {
            const float size = 62.0F / static_cast<float>(1 << k) + 3;
            textured_rectangle(gl, x, static_cast<float>(i) * 64 + 2, x + size,
                               static_cast<float>(i) * 64 + 2 + size * 0.9F);
            x += size + 5;
        }
    }
}

SCENE(filter_lod_limits, "base and max level, min and max lod, and a bias of the level of detail") {
    for_viewports(gl, 3, 2, [&](int cell) {
        camera(gl, 60, 1, 0.3F, 60);
        gl.Enable(GL_TEXTURE_2D);
        gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        GLuint name = 0;
        gl.GenTextures(1, &name);
        gl.BindTexture(GL_TEXTURE_2D, name);
        coloured_levels(gl, 64, 64);
        filters(gl, cell % 2 ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR);
        if (cell == 1) gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 2);
        if (cell == 2) gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 3);
        if (cell == 3) gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, 1.5F);
        if (cell == 4) gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_LOD, 2.25F);
        if (cell == 5)
            gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 1),
                gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 4);
        floor_plane(gl, 4);
    });
}

SCENE(filter_wrap_repeat_and_clamp,
      "REPEAT and CLAMP per axis, near and far outside, nearest and linear, with a border colour") {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_2D);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    painted_texture(gl, 16, 16, GL_NEAREST, GL_NEAREST);
    const GLfloat border[] = {0.9F, 0.9F, 0.2F, 1};
    gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border);
    for_cells(4, 2, [&](int cell, float x, float y, float w, float h) {
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, cell & 1 ? GL_CLAMP : GL_REPEAT);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, cell & 2 ? GL_CLAMP : GL_REPEAT);
        filters(gl, cell & 4 ? GL_LINEAR : GL_NEAREST, cell & 4 ? GL_LINEAR : GL_NEAREST);
        gl.Begin(GL_QUADS);
        for (const auto& [s, t] : {std::array{0.0F, 0.0F}, {1.0F, 0.0F}, {1.0F, 1.0F}, {0.0F, 1.0F}}) {
            gl.TexCoord2f(-1.3F + 3.7F * s, -2.1F + 4.2F * t);
            gl.Vertex2f(x + 2 + s * (w - 4), y + 2 + t * (h - 4));
        }
        gl.End();
    });
}

SCENE(filter_wrap_to_edge, "CLAMP_TO_EDGE of GL 1.2 beside CLAMP at the same coordinates") {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_2D);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    painted_texture(gl, 8, 8, GL_LINEAR, GL_LINEAR);
    for_cells(2, 2, [&](int cell, float x, float y, float w, float h) {
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, cell & 1 ? GL_CLAMP : GL_CLAMP_TO_EDGE);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, cell & 2 ? GL_CLAMP : GL_CLAMP_TO_EDGE);
        gl.MatrixMode(GL_TEXTURE);
        gl.LoadIdentity();
        gl.Translatef(-0.5F, -0.5F, 0);
        textured_rectangle(gl, x + 3, y + 3, x + w - 3, y + h - 3, 2, 2);
    });
}

SCENE(filter_texture_matrix, "translate, rotate, scale and project texture coordinates") {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_2D);
    painted_texture(gl, 32, 32, GL_LINEAR, GL_LINEAR);
    for_cells(3, 2, [&](int cell, float x, float y, float w, float h) {
        gl.MatrixMode(GL_TEXTURE);
        gl.LoadIdentity();
        if (cell == 1) gl.Translatef(0.3F, -0.2F, 0);
        if (cell == 2) gl.Rotatef(30, 0, 0, 1);
        if (cell == 3) gl.Scalef(2.5F, 0.5F, 1);
        if (cell == 4) {
            const GLfloat projective[16] = {1, 0, 0, 0.6F, 0, 1, 0, 0.3F, 0, 0, 1, 0, 0, 0, 0, 1};
            gl.LoadMatrixf(projective);
        }
        if (cell == 5) gl.PushMatrix(), gl.Rotatef(90, 0, 0, 1), gl.PopMatrix();
        textured_rectangle(gl, x + 3, y + 3, x + w - 3, y + h - 3);
    });
}

SCENE(filter_formats_linear, "LINEAR on luminance, alpha, intensity and small-bit formats") {
    pixel_projection(gl);
    striped_backdrop(gl, 8);
    gl.Enable(GL_TEXTURE_2D);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    filters(gl, GL_LINEAR, GL_LINEAR);
    const GLint formats[] = {GL_LUMINANCE8, GL_ALPHA8,   GL_INTENSITY8, GL_LUMINANCE8_ALPHA8, GL_RGB8,
                             GL_RGBA8,      GL_R3_G3_B2, GL_RGB5_A1,    GL_LUMINANCE16};
    const auto texels = painted_texels(8, 8);
    for_cells(3, 3, [&](int cell, float x, float y, float w, float h) {
        gl.TexImage2D(GL_TEXTURE_2D, 0, formats[cell], 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
        gl.Color4f(0.9F, 0.8F, 0.7F, 0.9F);
        textured_rectangle(gl, x + 4, y + 4, x + w - 4, y + h - 4);
    });
}

SCENE(filter_mipmaps_to_the_border,
      "each wrap mode with mipmaps, whose levels mix with the border in floats") {
    const GLenum modes[] = {GL_CLAMP, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT};
    const GLfloat border[] = {0.9F, 0.2F, 0.5F, 0.7F};
    for_viewports(gl, 4, 3, [&](int cell) {
        camera(gl, 60, 1, 0.3F, 60);
        gl.Enable(GL_TEXTURE_2D);
        gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        coloured_levels(gl, 64, 64);
        gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, static_cast<GLint>(modes[cell / 4]));
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, static_cast<GLint>(modes[cell / 4]));
        filters(gl, kMinFilters[2 + cell % 4], GL_LINEAR);
        gl.MatrixMode(GL_TEXTURE);
        gl.LoadIdentity();
        gl.Translatef(-0.5F, -1.5F, 0);
        gl.MatrixMode(GL_MODELVIEW);
        floor_plane(gl, 2);
    });
}
