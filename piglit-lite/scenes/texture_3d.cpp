// Chapter: 3D textures (GL 1.5 §3.8.1-3.8.9).
#include <algorithm>

#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

// A block of texels whose colour says where it is.
std::vector<std::uint8_t> block(int width, int height, int depth, int channels = 4) {
    std::vector<std::uint8_t> texels;
    for (int z = 0; z < depth; ++z)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const int checker = (x + y + z) % 2;
                const int rgba[] = {255 * x / std::max(width - 1, 1), 255 * y / std::max(height - 1, 1),
                                    255 * z / std::max(depth - 1, 1), checker ? 255 : 120};
                for (int c = 0; c < channels; ++c)
                    texels.push_back(static_cast<std::uint8_t>(rgba[c] / (checker ? 1 : 2)));
            }
    return texels;
}

void specify(const Gl& gl, int width, int height, int depth) {
    for (int level = 0;; ++level) {
        gl.TexImage3D(GL_TEXTURE_3D, level, GL_RGBA, width, height, depth, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                      block(width, height, depth).data());
        if (width == 1 && height == 1 && depth == 1) return;
        width = std::max(1, width / 2), height = std::max(1, height / 2), depth = std::max(1, depth / 2);
    }
}

void set(const Gl& gl, GLenum parameter, GLenum value) {
    gl.TexParameteri(GL_TEXTURE_3D, parameter, static_cast<GLint>(value));
}

// A quad that cuts the texture from corner to corner.
void cut(const Gl& gl, float x, float y, float w, float h, float from, float to) {
    gl.Begin(GL_QUADS);
    gl.TexCoord3f(from, from, from);
    gl.Vertex2f(x, y);
    gl.TexCoord3f(to, from, 0.5F * (from + to));
    gl.Vertex2f(x + w, y);
    gl.TexCoord3f(to, to, to);
    gl.Vertex2f(x + w, y + h);
    gl.TexCoord3f(from, to, 0.5F * (from + to));
    gl.Vertex2f(x, y + h);
    gl.End();
}

}  // namespace

SCENE(texture_3d_filters, "every pair of filters over a 3D texture of powers of two and one of none") {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_3D);
    const GLenum min_filters[] = {GL_NEAREST,
                                  GL_LINEAR,
                                  GL_NEAREST_MIPMAP_NEAREST,
                                  GL_LINEAR_MIPMAP_NEAREST,
                                  GL_NEAREST_MIPMAP_LINEAR,
                                  GL_LINEAR_MIPMAP_LINEAR};
    for_cells(6, 4, [&](int cell, float x, float y, float w, float h) {
        if (cell / 12 == 0)
            specify(gl, 16, 8, 32);
        else
            specify(gl, 13, 6, 21);
        set(gl, GL_TEXTURE_MIN_FILTER, min_filters[cell % 6]);
        set(gl, GL_TEXTURE_MAG_FILTER, cell / 6 % 2 ? GL_LINEAR : GL_NEAREST);
        cut(gl, x + 1, y + 1, w / 2 - 2, h - 2, 0.03F, 0.97F);
        cut(gl, x + w / 2 + 1, y + 1, w / 2 - 2, h - 2, -1.2F, 5.9F);
    });
}

SCENE(texture_3d_wrap,
      "each wrap mode along r with others along s and t, bytes and 16-bit texels, border colour") {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_3D);
    const GLenum modes[] = {GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT};
    const GLfloat border[] = {0.9F, 0.2F, 0.5F, 0.7F};
    gl.TexParameterfv(GL_TEXTURE_3D, GL_TEXTURE_BORDER_COLOR, border);
    for_cells(5, 4, [&](int cell, float x, float y, float w, float h) {
        const auto texels = block(8, 8, 8);
        gl.TexImage3D(GL_TEXTURE_3D, 0, cell / 10 ? GL_RGBA16 : GL_RGBA8, 8, 8, 8, 0, GL_RGBA,
                      GL_UNSIGNED_BYTE, texels.data());
        const GLenum filter = cell / 5 % 2 ? GL_LINEAR : GL_NEAREST;
        set(gl, GL_TEXTURE_MIN_FILTER, filter);
        set(gl, GL_TEXTURE_MAG_FILTER, filter);
        set(gl, GL_TEXTURE_WRAP_R, modes[cell % 5]);
        set(gl, GL_TEXTURE_WRAP_S, modes[(cell + 2) % 5]);
        set(gl, GL_TEXTURE_WRAP_T, cell % 2 ? GL_REPEAT : modes[cell % 5]);
        cut(gl, x + 1, y + 1, w - 2, h - 2, -0.7F, 1.8F);
    });
}

SCENE(texture_3d_upload,
      "parts of a 3D texture, skipped images, rows and pixels, copies from the frame buffer, lists, read "
      "back") {
    pixel_projection(gl);
    striped_backdrop(gl, 5);
    gl.Enable(GL_TEXTURE_3D);
    set(gl, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 16, 16, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  block(16, 16, 4).data());
    const auto big = block(20, 14, 5, 3);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 20);
    gl.PixelStorei(GL_UNPACK_IMAGE_HEIGHT, 14);
    gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 3);
    gl.PixelStorei(GL_UNPACK_SKIP_ROWS, 2);
    gl.PixelStorei(GL_UNPACK_SKIP_IMAGES, 1);
    gl.TexSubImage3D(GL_TEXTURE_3D, 0, 2, 3, 1, 9, 7, 2, GL_RGB, GL_UNSIGNED_BYTE, big.data());
    gl.NewList(1, GL_COMPILE);
    gl.TexSubImage3D(GL_TEXTURE_3D, 0, 10, 10, 2, 5, 5, 2, GL_RGB, GL_UNSIGNED_BYTE, big.data());
    gl.EndList();
    for (GLenum mode : {GL_UNPACK_ROW_LENGTH, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_PIXELS,
                        GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_IMAGES})
        gl.PixelStorei(mode, 0);
    gl.CallList(1);
    gl.CopyTexSubImage3D(GL_TEXTURE_3D, 0, 4, 6, 3, 100, 90, 8, 7);
    for_cells(4, 1, [&](int cell, float x, float y, float w, float h) {
        const float r = (static_cast<float>(cell) + 0.4F) / 4;
        gl.Begin(GL_QUADS);
        for (int i = 0; i < 4; ++i) {
            const float s = i == 1 || i == 2 ? 1.0F : 0.0F, t = i / 2 ? 1.0F : 0.0F;
            gl.TexCoord3f(s, t, r);
            gl.Vertex2f(x + 2 + s * (w - 4), y + 2 + t * (h / 2));
        }
        gl.End();
    });
    std::vector<std::uint8_t> back(16 * 16 * 4 * 4);
    gl.GetTexImage(GL_TEXTURE_3D, 0, GL_RGBA, GL_UNSIGNED_BYTE, back.data());
    double sum = 0;
    for (std::size_t i = 0; i < back.size(); ++i) sum += back[i] * static_cast<double>(i % 97);
    notes.value("read back", sum);
    GLint values[3];
    gl.GetTexLevelParameteriv(GL_TEXTURE_3D, 0, GL_TEXTURE_DEPTH, values);
    gl.TexImage3D(GL_PROXY_TEXTURE_3D, 0, GL_RGBA, 64, 32, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl.GetTexLevelParameteriv(GL_PROXY_TEXTURE_3D, 0, GL_TEXTURE_DEPTH, values + 1);
    gl.TexImage3D(GL_PROXY_TEXTURE_3D, 0, GL_RGBA, 64, 32, 1 << 20, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl.GetTexLevelParameteriv(GL_PROXY_TEXTURE_3D, 0, GL_TEXTURE_DEPTH, values + 2);
    notes.values("depth", values);
    gl.GetIntegerv(GL_MAX_3D_TEXTURE_SIZE, values);
    notes.value("largest 3D texture", values[0]);
}

SCENE(texture_3d_perspective,
      "a torus carved out of a 3D texture by object coordinates, lit, projective too") {
    camera(gl, 45, 4);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.Enable(GL_TEXTURE_3D);
    specify(gl, 16, 16, 16);
    set(gl, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    const GLfloat planes[4][4] = {{1, 0, 0, 0.5F}, {0, 1, 0, 0.5F}, {0, 0, 1.3F, 0.5F}, {0.1F, 0.2F, 0, 1}};
    for (int c = 0; c < 4; ++c) {
        const GLenum coordinate = static_cast<GLenum>(GL_S + c);
        gl.TexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
        gl.TexGenfv(coordinate, GL_OBJECT_PLANE, planes[c]);
        if (c < 3) gl.Enable(static_cast<GLenum>(GL_TEXTURE_GEN_S + c));
    }
    const Solid torus = make_torus(0.7F, 0.3F, 24, 12);
    gl.Translatef(-0.6F, 0.5F, 0);
    gl.Rotatef(-50, 1, 0.3F, 0);
    draw_solid(gl, torus, kNormals);
    gl.Enable(GL_TEXTURE_GEN_Q);
    gl.Translatef(1.1F, -0.9F, 0.8F);
    draw_solid(gl, torus, kNormals);
}
