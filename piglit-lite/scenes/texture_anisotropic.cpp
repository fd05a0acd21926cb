// Chapter: anisotropic filtering (EXT_texture_filter_anisotropic).
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

void set(const Gl& gl, GLenum target, GLenum parameter, GLenum value) {
    gl.TexParameteri(target, parameter, static_cast<GLint>(value));
}

void anisotropy(const Gl& gl, float degree, GLenum min = GL_LINEAR_MIPMAP_LINEAR, GLenum mag = GL_LINEAR,
                GLenum target = GL_TEXTURE_2D) {
    gl.TexParameterf(target, GL_TEXTURE_MAX_ANISOTROPY_EXT, degree);
    set(gl, target, GL_TEXTURE_MIN_FILTER, min);
    set(gl, target, GL_TEXTURE_MAG_FILTER, mag);
}

// A floor running to the horizon, turned about the line of sight.
void floor_plane(const Gl& gl, float tiles, float turn = 0) {
    camera(gl, 60, 1, 0.3F, 60);
    gl.Rotatef(turn, 0, 1, 0);
    receding_rectangle(gl, {6, -1, 0.5F, -1, -32}, tiles, 4 * tiles);
}

void prepare(const Gl& gl) {
    gl.Enable(GL_TEXTURE_2D);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
}

}  // namespace

SCENE(anisotropic_floor, "a floor to the horizon and one turned, degrees from 1 to more than the limit") {
    const float degrees[] = {1, 1.01F, 2, 4, 16, 400};
    for_viewports(gl, 3, 2, [&](int cell) {
        prepare(gl);
        coloured_levels(gl, 64, 64);
        anisotropy(gl, degrees[cell]);
        floor_plane(gl, 4, static_cast<float>(cell) * 13);
    });
}

// Filters without levels that differ from each other have the reference take levels nevertheless.
SCENE(anisotropic_filters, "pairs of filters, which anisotropy takes the place of") {
    for_viewports(gl, 4, 3, [&](int cell) {
        prepare(gl);
        coloured_levels(gl, 32, 32);
        const GLenum min = kMinFilters[cell % 6], mag = cell < 6 ? GL_NEAREST : GL_LINEAR;
        anisotropy(gl, 8, min, min == GL_NEAREST || min == GL_LINEAR ? min : mag);
        floor_plane(gl, 3, static_cast<float>(cell) * 9 - 30);
    });
}

SCENE(anisotropic_without_levels, "textures of a single level, minified") {
    const GLenum filters[] = {GL_NEAREST, GL_LINEAR};
    for_viewports(gl, 2, 2, [&](int cell) {
        prepare(gl);
        painted_texture(gl, 64, 32, filters[cell % 2], filters[cell / 2]);
        anisotropy(gl, 8, filters[cell % 2], filters[cell / 2]);
        floor_plane(gl, 2, static_cast<float>(cell) * 20);
    });
}

SCENE(anisotropic_wrap, "each wrap mode along s with each along t, powers of two and other sizes") {
    pixel_projection(gl);
    prepare(gl);
    const GLenum modes[] = {GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT};
    const GLfloat border[] = {0.9F, 0.2F, 0.5F, 0.7F};
    gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border);
    for_cells(5, 5, [&](int cell, float x, float y, float w, float h) {
        if (cell % 2)
            coloured_levels(gl, 16, 8);
        else
            coloured_levels(gl, 13, 49);
        set(gl, GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, modes[cell % 5]);
        set(gl, GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, modes[cell / 5]);
        anisotropy(gl, 4);
        gl.Begin(GL_QUADS);
        gl.TexCoord2f(-1.3F, -0.8F), gl.Vertex2f(x + 1, y + 1);
        gl.TexCoord2f(2.2F, -1.3F), gl.Vertex2f(x + w - 1, y + 1);
        gl.TexCoord2f(2.4F, 5.7F), gl.Vertex2f(x + w - 1, y + h - 1);
        gl.TexCoord2f(-1.1F, 1.9F), gl.Vertex2f(x + 1, y + h - 1);
        gl.End();
    });
}

SCENE(anisotropic_shapes, "long, flat and odd images, at many scales and angles") {
    pixel_projection(gl);
    prepare(gl);
    const int shapes[][2] = {{64, 4}, {2, 64}, {48, 20}, {33, 65}};
    for_cells(6, 4, [&](int cell, float x, float y, float w, float h) {
        coloured_levels(gl, shapes[cell / 6][0], shapes[cell / 6][1]);
        anisotropy(gl, 16);
        gl.PushMatrix();
        gl.Translatef(x + w / 2, y + h / 2, 0);
        gl.Rotatef(static_cast<float>(cell) * 31, 0, 0, 1);
        const float size = w / static_cast<float>(2 + cell % 6);
        textured_rectangle(gl, -size, -size / 3, size, size / 3, 2, 1.5F);
        gl.PopMatrix();
    });
}

SCENE(anisotropic_limits, "base and max level, min and max lod, biases of texture and unit") {
    for_viewports(gl, 4, 2, [&](int cell) {
        prepare(gl);
        GLuint name = 0;
        gl.GenTextures(1, &name);
        gl.BindTexture(GL_TEXTURE_2D, name);
        coloured_levels(gl, 52, 64);
        anisotropy(gl, 2);
        if (cell == 0) gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 2);
        if (cell == 1) gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 1);
        if (cell == 2) gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, 1.5F);
        if (cell == 3) gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_LOD, 0.25F);
        if (cell == 4) gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, 1.75F);
        if (cell == 5) gl.TexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, -0.8F);
        if (cell == 6) {
            gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, 2);
            gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_LOD, 2);
        }
        if (cell == 7) gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, -3);
        floor_plane(gl, 4, 25);
        gl.TexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 0);
    });
}

SCENE(anisotropic_solid, "on a lit torus, in perspective, modulated and blended") {
    camera(gl, 50, 4);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_TEXTURE_2D);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    coloured_levels(gl, 128, 32);
    anisotropy(gl, 16);
    gl.MatrixMode(GL_TEXTURE);
    gl.Scalef(5, 3, 1);
    gl.MatrixMode(GL_MODELVIEW);
    gl.Rotatef(-60, 1, 0.6F, 0);
    draw_solid(gl, make_torus(1.1F, 0.55F, 24, 12), kNormals | kTextures);
}

SCENE(anisotropic_formats, "luminance, alpha, 16-bit, compressed and depth textures") {
    for_viewports(gl, 3, 2, [&](int cell) {
        prepare(gl);
        GLuint name = 0;
        gl.GenTextures(1, &name);
        gl.BindTexture(GL_TEXTURE_2D, name);
        const GLint formats[] = {GL_LUMINANCE8, GL_INTENSITY8, GL_RGBA16,
                                 GL_RGB5_A1,    GL_RGBA12,     GL_DEPTH_COMPONENT24};
        if (cell < 5) {
            coloured_levels(gl, 32, 32, formats[cell]);
        } else {
            std::vector<GLfloat> depths(32 * 32);
            for (std::size_t i = 0; i < depths.size(); ++i)
                depths[i] = static_cast<float>((i * 7 + i / 32) % 32) / 31;
            gl.TexImage2D(GL_TEXTURE_2D, 0, formats[cell], 32, 32, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                          depths.data());
        }
        anisotropy(gl, 8, cell < 5 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
        floor_plane(gl, 4, 25);
    });
}

SCENE(anisotropic_3d, "a 3D texture: the nearest slice of a level, by each wrap mode of r") {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_3D);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    const GLenum modes[] = {GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT};
    for_cells(5, 2, [&](int cell, float x, float y, float w, float h) {
        int width = cell < 5 ? 16 : 12, depth = cell < 5 ? 8 : 7;
        for (int level = 0;; ++level) {
            std::vector<std::uint8_t> texels;
            for (int z = 0; z < depth; ++z) {
                const auto slice = painted_texels(width, width, static_cast<std::uint32_t>(level * 8 + z));
                texels.insert(texels.end(), slice.begin(), slice.end());
            }
            gl.TexImage3D(GL_TEXTURE_3D, level, GL_RGBA, width, width, depth, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                          texels.data());
            if (width == 1 && depth == 1) break;
            width = std::max(1, width / 2), depth = std::max(1, depth / 2);
        }
        anisotropy(gl, 4, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_TEXTURE_3D);
        set(gl, GL_TEXTURE_3D, GL_TEXTURE_WRAP_R, modes[cell % 5]);
        gl.Begin(GL_QUADS);
        gl.TexCoord3f(0, 0, -1.3F), gl.Vertex2f(x + 1, y + 1);
        gl.TexCoord3f(3, 0.4F, -0.5F), gl.Vertex2f(x + w - 1, y + 1);
        gl.TexCoord3f(2.5F, 6, 2.2F), gl.Vertex2f(x + w - 1, y + h - 1);
        gl.TexCoord3f(-0.5F, 5, 1.7F), gl.Vertex2f(x + 1, y + h - 1);
        gl.End();
    });
}

// Where pixels of a cube map have different levels, the reference mixes up their sizes.
SCENE(anisotropic_cube, "a cube map by reflection: one level of several, and a single one") {
    for_viewports(gl, 2, 1, [&](int cell) {
        camera(gl, 50, 4);
        gl.Enable(GL_TEXTURE_CUBE_MAP);
        gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        for (GLenum face = 0; face < 6; ++face) {
            for (int level = 0; level < 6; ++level) {
                const auto texels =
                    painted_texels(32 >> level, 32 >> level, face * 8 + static_cast<GLenum>(level));
                gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, GL_RGBA, 32 >> level, 32 >> level,
                              0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
            }
        }
        anisotropy(gl, 8, cell ? GL_LINEAR : GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_TEXTURE_CUBE_MAP);
        gl.TexParameterf(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_LOD, 1);
        gl.TexParameterf(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LOD, 1);
        for (const GLenum coordinate : {GL_S, GL_T, GL_R}) {
            gl.TexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_REFLECTION_MAP);
            gl.Enable(GL_TEXTURE_GEN_S + coordinate - GL_S);
        }
        gl.Rotatef(35, 1, 0.4F, 0);
        draw_solid(gl, make_sphere(1.2F, 18, 24), kNormals);
    });
}
