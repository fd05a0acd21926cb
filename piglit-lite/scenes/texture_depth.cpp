// Chapter: depth textures and comparisons (GL 1.5 §3.8.4, §3.8.5, §3.8.14).
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

void set(const Gl& gl, GLenum parameter, GLenum value) {
    gl.TexParameteri(GL_TEXTURE_2D, parameter, static_cast<GLint>(value));
}

// Waves of depths.
std::vector<float> waves(int width, int height) {
    std::vector<float> depths;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            depths.push_back(0.5F + 0.5F * std::sin(0.7F * static_cast<float>(x)) *
                                        std::cos(0.5F * static_cast<float>(y)));
    return depths;
}

void specify(const Gl& gl, GLint format, int size) {
    for (int level = 0; size >> level > 0; ++level)
        gl.TexImage2D(GL_TEXTURE_2D, level, format, size >> level, size >> level, 0, GL_DEPTH_COMPONENT,
                      GL_FLOAT, waves(size >> level, size >> level).data());
}

// r runs over the rectangle from left to right.
void ramp(const Gl& gl, float x, float y, float w, float h, float from = -0.1F, float to = 1.1F) {
    gl.Begin(GL_QUADS);
    gl.TexCoord3f(0, 0, from);
    gl.Vertex2f(x, y);
    gl.TexCoord3f(1, 0, to);
    gl.Vertex2f(x + w, y);
    gl.TexCoord3f(1, 1, to);
    gl.Vertex2f(x + w, y + h);
    gl.TexCoord3f(0, 1, from);
    gl.Vertex2f(x, y + h);
    gl.End();
}

}  // namespace

SCENE(depth_texture_modes,
      "depths of 16, 24 and 32 bits as luminance, intensity and alpha in five environments") {
    pixel_projection(gl);
    striped_backdrop(gl, 5);
    gl.Enable(GL_TEXTURE_2D);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    const GLint formats[] = {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32};
    const GLenum modes[] = {GL_LUMINANCE, GL_INTENSITY, GL_ALPHA};
    const GLenum environments[] = {GL_MODULATE, GL_REPLACE, GL_BLEND, GL_ADD};
    const GLfloat constant[] = {0.2F, 0.9F, 0.4F, 0.6F};
    gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, constant);
    for_cells(6, 6, [&](int cell, float x, float y, float w, float h) {
        specify(gl, formats[cell % 3], 16);
        set(gl, GL_DEPTH_TEXTURE_MODE, modes[cell / 3 % 3]);
        set(gl, GL_TEXTURE_MIN_FILTER, cell % 2 ? GL_LINEAR : GL_NEAREST);
        set(gl, GL_TEXTURE_MAG_FILTER, cell % 2 ? GL_LINEAR : GL_NEAREST);
        gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, static_cast<GLint>(environments[cell / 9]));
        gl.Color4f(0.9F, 0.6F, 0.8F, 0.75F);
        ramp(gl, x + 1, y + 1, w - 2, h - 2);
    });
}

SCENE(shadow_functions, "r compared by all eight functions, nearest and linear, in three depth formats") {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_2D);
    set(gl, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    const GLint formats[] = {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32};
    for_cells(8, 6, [&](int cell, float x, float y, float w, float h) {
        specify(gl, formats[cell / 16], 16);
        set(gl, GL_TEXTURE_COMPARE_FUNC, GL_NEVER + static_cast<GLenum>(cell % 8));
        const GLenum filter = cell / 8 % 2 ? GL_LINEAR : GL_NEAREST;
        set(gl, GL_TEXTURE_MIN_FILTER, filter);
        set(gl, GL_TEXTURE_MAG_FILTER, filter);
        ramp(gl, x + 1, y + 1, w - 2, h - 2);
    });
    GLint values[3];
    gl.GetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, values);
    gl.GetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, values + 1);
    gl.GetTexParameteriv(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, values + 2);
    notes.values("parameters", values);
}

SCENE(shadow_wrap_and_levels,
      "comparisons across edges with a border, and in mip levels, in modes of all three kinds") {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_2D);
    set(gl, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    const GLfloat border[] = {0.6F, 0, 0, 0};
    gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border);
    const GLenum wraps[] = {GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT};
    const GLenum modes[] = {GL_LUMINANCE, GL_INTENSITY, GL_ALPHA};
    for_cells(5, 4, [&](int cell, float x, float y, float w, float h) {
        specify(gl, GL_DEPTH_COMPONENT, 16);
        set(gl, GL_TEXTURE_WRAP_S, wraps[cell % 5]);
        set(gl, GL_TEXTURE_WRAP_T, wraps[(cell + 1) % 5]);
        set(gl, GL_DEPTH_TEXTURE_MODE, modes[cell % 3]);
        const GLenum filters[] = {GL_LINEAR, GL_NEAREST, GL_LINEAR_MIPMAP_LINEAR, GL_NEAREST_MIPMAP_NEAREST};
        set(gl, GL_TEXTURE_MIN_FILTER, filters[cell / 5]);
        set(gl, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        gl.MatrixMode(GL_TEXTURE);
        gl.LoadIdentity();
        const float scale = cell / 5 > 1 ? 6.0F : 1.9F;
        gl.Translatef(-0.4F, -0.3F, 0);
        gl.Scalef(scale, scale, 1);
        gl.MatrixMode(GL_MODELVIEW);
        ramp(gl, x + 1, y + 1, w - 2, h - 2);
    });
}

SCENE(shadow_map, "a lit scene whose shadow comes from its depth copied as seen from the light") {
    const Solid torus = make_torus(0.5F, 0.2F, 24, 12);
    const auto draw = [&] {
        gl.Color4f(0.8F, 0.8F, 0.7F, 1);
        gl.Begin(GL_QUADS);
        gl.Vertex3f(-2, -0.8F, -2);
        gl.Vertex3f(-2, -0.8F, 2);
        gl.Vertex3f(2, -0.8F, 2);
        gl.Vertex3f(2, -0.8F, -2);
        gl.End();
        gl.Color4f(0.9F, 0.4F, 0.3F, 1);
        gl.PushMatrix();
        gl.Rotatef(40, 1, 0.3F, 0);
        draw_solid(gl, torus, kPositions);
        gl.PopMatrix();
    };
    const auto light_view = [&] {
        gl.Frustum(-0.6, 0.6, -0.6, 0.6, 1, 8);
        gl.Translatef(0, 0, -4);
        gl.Rotatef(60, 1, 0, 0);
        gl.Rotatef(25, 0, 1, 0);
    };
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_POLYGON_OFFSET_FILL);
    gl.PolygonOffset(2, 4);
    gl.MatrixMode(GL_PROJECTION);
    light_view();
    gl.MatrixMode(GL_MODELVIEW);
    draw();
    gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 0, 0, 256, 256, 0);
    gl.Disable(GL_POLYGON_OFFSET_FILL);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    set(gl, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    set(gl, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    set(gl, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    set(gl, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    set(gl, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    gl.Enable(GL_TEXTURE_2D);
    gl.MatrixMode(GL_TEXTURE);
    gl.LoadIdentity();
    gl.Translatef(0.5F, 0.5F, 0.5F);
    gl.Scalef(0.5F, 0.5F, 0.5F);
    light_view();
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    camera(gl, 45, 4);
    gl.Rotatef(20, 1, 0, 0);
    const GLfloat planes[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    for (int c = 0; c < 4; ++c) {
        const auto coordinate = static_cast<GLenum>(GL_S + c);
        gl.TexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
        gl.TexGenfv(coordinate, GL_OBJECT_PLANE, planes[c]);
        gl.Enable(static_cast<GLenum>(GL_TEXTURE_GEN_S + c));
    }
    draw();
}

SCENE(depth_texture_upload,
      "depths of every client type, through depth scale and bias, read back; sizes and errors") {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_2D);
    set(gl, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    set(gl, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    const GLenum types[] = {GL_UNSIGNED_BYTE, GL_BYTE, GL_UNSIGNED_SHORT, GL_SHORT,
                            GL_UNSIGNED_INT,  GL_INT,  GL_FLOAT};
    const GLint formats[] = {GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24,
                             GL_DEPTH_COMPONENT32};
    Random random(7);
    for_cells(7, 8, [&](int cell, float x, float y, float w, float h) {
        std::vector<std::uint32_t> raw;
        const GLenum type = types[cell % 7];
        for (int i = 0; i < 64; ++i) {
            const float f = random(-0.2F, 1.2F);
            std::uint32_t bits = random.bits();
            if (type == GL_FLOAT) std::memcpy(&bits, &f, sizeof bits);
            raw.push_back(bits);
        }
        if (cell >= 28) {
            gl.PixelTransferf(GL_DEPTH_SCALE, 0.7F);
            gl.PixelTransferf(GL_DEPTH_BIAS, 0.1F);
        }
        const GLint format = formats[cell / 7 % 4];
        gl.TexImage2D(GL_TEXTURE_2D, 0, format, 8, 8, 0, GL_DEPTH_COMPONENT, type, raw.data());
        ramp(gl, x + 1, y + 1, w - 2, h - 2);
        gl.PixelTransferf(GL_DEPTH_SCALE, 1);
        gl.PixelTransferf(GL_DEPTH_BIAS, 0);
        float floats[64] = {};
        std::uint32_t integers[64] = {};
        gl.GetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, floats);
        gl.GetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, integers);
        double sum = 0, integer_sum = 0;
        for (int i = 0; i < 64; ++i) sum += floats[i] * (i + 1), integer_sum += integers[i] * (i % 7 + 1.0);
        const std::string name = std::to_string(cell);
        notes.value("floats " + name, sum, 1e-9);
        notes.value("integers " + name, integer_sum);
        GLint size;
        gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_DEPTH_SIZE, &size);
        notes.value("bits " + name, size);
    });
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    notes.value("depths are no colours", gl.GetError());
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 8, 8, 0, GL_RGBA, GL_FLOAT, nullptr);
    notes.value("colours are no depths", gl.GetError());
    gl.TexImage3D(GL_TEXTURE_3D, 0, GL_DEPTH_COMPONENT, 8, 8, 8, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    notes.value("no 3D depths", gl.GetError());
    set(gl, GL_DEPTH_TEXTURE_MODE, GL_RGB);
    notes.value("no such mode", gl.GetError());
}
