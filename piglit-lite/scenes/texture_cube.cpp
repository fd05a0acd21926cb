// Chapter: cube maps (GL 1.5 §3.8.6), reflection and normal maps (§2.11.4).
#include <algorithm>
#include <cmath>

#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

// Six faces in six hues, each with its picture, and all levels.
void specify(const Gl& gl, int size, GLint format = GL_RGBA) {
    for (int face = 0; face < 6; ++face) {
        for (int level = 0; size >> level > 0; ++level) {
            const int edge = size >> level;
            auto texels = painted_texels(edge, edge, static_cast<std::uint32_t>(face + 1));
            const Colour tint = hue(static_cast<float>(face) / 6);
            for (std::size_t i = 0; i < texels.size(); ++i)
                texels[i] = static_cast<std::uint8_t>(static_cast<float>(texels[i] / 2 + 110) * tint[i % 4]);
            gl.TexImage2D(static_cast<GLenum>(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face), level, format, edge,
                          edge, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
        }
    }
}

void set(const Gl& gl, GLenum parameter, GLenum value) {
    gl.TexParameteri(GL_TEXTURE_CUBE_MAP, parameter, static_cast<GLint>(value));
}

void filters(const Gl& gl, GLenum min, GLenum mag) {
    set(gl, GL_TEXTURE_MIN_FILTER, min);
    set(gl, GL_TEXTURE_MAG_FILTER, mag);
}

// The whole sphere of directions in one rectangle.
void map_of_directions(const Gl& gl, float x, float y, float w, float h) {
    constexpr int kColumns = 24, kRows = 12;
    const auto corner = [&](int column, int row) {
        const float a = 6.283185F * static_cast<float>(column) / kColumns;
        const float b = 3.141593F * (static_cast<float>(row) / kRows - 0.5F);
        gl.TexCoord3f(std::cos(b) * std::sin(a), std::sin(b), 0.7F * std::cos(b) * std::cos(a));
        gl.Vertex2f(x + w * static_cast<float>(column) / kColumns, y + h * static_cast<float>(row) / kRows);
    };
    gl.Begin(GL_QUADS);
    for (int row = 0; row < kRows; ++row)
        for (int column = 0; column < kColumns; ++column) {
            corner(column, row);
            corner(column + 1, row);
            corner(column + 1, row + 1);
            corner(column, row + 1);
        }
    gl.End();
}

}  // namespace

SCENE(cube_filters, "all directions of a cube map through every pair of filters") {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_CUBE_MAP);
    specify(gl, 32);
    for_cells(2, 6, [&](int cell, float x, float y, float w, float h) {
        filters(gl, kMinFilters[cell / 2], cell % 2 ? GL_LINEAR : GL_NEAREST);
        map_of_directions(gl, x + 1, y + 1, w - 2, h - 2);
    });
}

SCENE(cube_magnified, "seams and corners close up, bytes and 16-bit texels, wrap modes that do nothing") {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_CUBE_MAP);
    const GLenum wraps[] = {GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT};
    for_cells(4, 2, [&](int cell, float x, float y, float w, float h) {
        specify(gl, 4, cell / 4 ? GL_RGBA16 : GL_RGBA);
        filters(gl, cell % 2 ? GL_LINEAR : GL_NEAREST, cell % 2 ? GL_LINEAR : GL_NEAREST);
        set(gl, GL_TEXTURE_WRAP_S, wraps[cell % 4]);
        set(gl, GL_TEXTURE_WRAP_T, wraps[cell % 4]);
        map_of_directions(gl, x + 1, y + 1, w - 2, h - 2);
    });
}

SCENE(cube_reflections, "a reflecting and a normal-mapped torus, with rotated texture matrices, mip-mapped") {
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_TEXTURE_CUBE_MAP);
    specify(gl, 64);
    const Solid torus = make_torus(0.8F, 0.35F, 32, 16);
    for_viewports(gl, 2, 2, [&](int cell) {
        camera(gl, 45, 3);
        filters(gl, cell / 2 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR, GL_LINEAR);
        for (int c = 0; c < 3; ++c) {
            gl.TexGeni(static_cast<GLenum>(GL_S + c), GL_TEXTURE_GEN_MODE,
                       cell % 2 ? GL_NORMAL_MAP : GL_REFLECTION_MAP);
            gl.Enable(static_cast<GLenum>(GL_TEXTURE_GEN_S + c));
        }
        gl.MatrixMode(GL_TEXTURE);
        gl.LoadIdentity();
        gl.Rotatef(static_cast<float>(cell) * 33, 0.2F, 1, 0.4F);
        gl.MatrixMode(GL_MODELVIEW);
        gl.Rotatef(-60, 1, 0.2F, 0);
        draw_solid(gl, torus, kNormals);
    });
    GLint mode[1];
    gl.GetTexGeniv(GL_R, GL_TEXTURE_GEN_MODE, mode);
    notes.values("mode", mode);
    gl.TexGeni(GL_Q, GL_TEXTURE_GEN_MODE, GL_REFLECTION_MAP);
    notes.value("no reflected q", gl.GetError());
}

SCENE(cube_depths, "a cube map of depths in its three modes, NEAREST and LINEAR, of 16, 24 and 32 bits") {
    pixel_projection(gl);
    striped_backdrop(gl, 5);
    gl.Enable(GL_TEXTURE_CUBE_MAP);
    const GLenum modes[] = {GL_LUMINANCE, GL_INTENSITY, GL_ALPHA};
    const GLint formats[] = {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32};
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for_cells(3, 2, [&](int cell, float x, float y, float w, float h) {
        for (GLenum face = 0; face < 6; ++face) {
            std::vector<std::uint16_t> depths(8 * 8);
            for (std::size_t i = 0; i < depths.size(); ++i)
                depths[i] = static_cast<std::uint16_t>((face * 9000 + i * i * 13 + i * 301) & 0xffff);
            gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, formats[cell % 3], 8, 8, 0,
                          GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, depths.data());
        }
        set(gl, GL_DEPTH_TEXTURE_MODE, modes[cell % 3]);
        filters(gl, cell / 3 ? GL_LINEAR : GL_NEAREST, cell / 3 ? GL_LINEAR : GL_NEAREST);
        gl.Color4fv(hue(static_cast<float>(cell) / 6).data());
        map_of_directions(gl, x + 1, y + 1, w - 2, h - 2);
    });
    notes.value("errors", gl.GetError());
}

SCENE(cube_images, "copies and parts of faces, incomplete maps, precedence, proxies, errors") {
    pixel_projection(gl);
    striped_backdrop(gl, 5);
    gl.Enable(GL_TEXTURE_CUBE_MAP);
    gl.Enable(GL_TEXTURE_2D);
    painted_texture(gl, 16, 16, GL_NEAREST, GL_NEAREST);
    filters(gl, GL_LINEAR, GL_LINEAR);
    for_cells(2, 2, [&](int cell, float x, float y, float w, float h) {
        specify(gl, 16);
        const auto part = painted_texels(5, 6, 9);
        gl.TexSubImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, 0, 3, 4, 5, 6, GL_RGBA, GL_UNSIGNED_BYTE,
                         part.data());
        gl.CopyTexSubImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_Z, 0, 2, 2, 20, 30, 9, 9);
        gl.CopyTexImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_X, 0, GL_RGBA, 60, 70, 16, 16, 0);
        // One face of another size: the 2D texture stays out of sight, there is no texturing at all.
        if (cell == 1)
            gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_Y, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                          painted_texels(8, 8).data());
        if (cell == 2)
            gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_Y, 0, GL_RGB, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                          painted_texels(16, 16).data());
        if (cell == 3) gl.Disable(GL_TEXTURE_CUBE_MAP);
        gl.Color4fv(hue(static_cast<float>(cell) / 4).data());
        map_of_directions(gl, x + 1, y + 1, w - 2, h - 2);
    });
    gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_RGBA, 16, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    notes.value("not square", gl.GetError());
    gl.TexImage2D(GL_TEXTURE_CUBE_MAP, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    notes.value("no face", gl.GetError());
    gl.TexImage2D(GL_PROXY_TEXTURE_CUBE_MAP, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    GLint values[2];
    gl.GetTexLevelParameteriv(GL_PROXY_TEXTURE_CUBE_MAP, 0, GL_TEXTURE_WIDTH, values);
    gl.GetIntegerv(GL_MAX_CUBE_MAP_TEXTURE_SIZE, values + 1);
    notes.values("sizes", values);
    std::vector<std::uint8_t> back(16 * 16 * 4);
    gl.GetTexImage(GL_TEXTURE_CUBE_MAP_NEGATIVE_X, 0, GL_RGBA, GL_UNSIGNED_BYTE, back.data());
    double sum = 0;
    for (std::size_t i = 0; i < back.size(); ++i) sum += back[i] * static_cast<double>(i % 89);
    notes.value("read back", sum);
}
