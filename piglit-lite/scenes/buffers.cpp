// Chapter: buffer objects (GL 1.5 §2.9).
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

const void* offset(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes);
}

// A buffer object with these bytes, bound to `target`.
template <typename T>
GLuint make_buffer(const Gl& gl, GLenum target, const std::vector<T>& values) {
    GLuint name;
    gl.GenBuffers(1, &name);
    gl.BindBuffer(target, name);
    gl.BufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), GL_STATIC_DRAW);
    return name;
}

void point_to_solid(const Gl& gl) {
    gl.VertexPointer(3, GL_FLOAT, sizeof(SolidVertex), offset(offsetof(SolidVertex, position)));
    gl.NormalPointer(GL_FLOAT, sizeof(SolidVertex), offset(offsetof(SolidVertex, normal)));
    gl.TexCoordPointer(2, GL_FLOAT, sizeof(SolidVertex), offset(offsetof(SolidVertex, texture)));
    gl.ColorPointer(4, GL_FLOAT, sizeof(SolidVertex), offset(offsetof(SolidVertex, colour)));
    for (GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_COLOR_ARRAY})
        gl.EnableClientState(array);
}

}  // namespace

SCENE(buffer_lit_torus, "a lit textured torus of interleaved vertices and indices in buffers; lists of it") {
    camera(gl, 45, 4);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.Enable(GL_COLOR_MATERIAL);
    gl.Enable(GL_TEXTURE_2D);
    painted_texture(gl, 32, 32, GL_LINEAR, GL_LINEAR);
    const Solid torus = make_torus(0.9F, 0.4F, 24, 12);
    make_buffer(gl, GL_ARRAY_BUFFER, torus.vertices);
    make_buffer(gl, GL_ELEMENT_ARRAY_BUFFER, torus.indices);
    point_to_solid(gl);
    gl.BindBuffer(GL_ARRAY_BUFFER, 0);
    const auto draw = [&] {
        const auto half = static_cast<GLsizei>(torus.indices.size() / 2);
        gl.DrawElements(GL_TRIANGLES, half, GL_UNSIGNED_SHORT, nullptr);
        gl.DrawRangeElements(GL_TRIANGLES, 0, static_cast<GLuint>(torus.vertices.size()), half,
                             GL_UNSIGNED_SHORT, offset(static_cast<std::size_t>(half) * 2));
    };
    gl.Rotatef(-50, 1, 0, 0);
    draw();
    gl.NewList(1, GL_COMPILE);
    draw();
    gl.EndList();
    gl.Translatef(0.7F, 0.5F, 0.9F);
    gl.Scalef(0.5F, 0.5F, 0.5F);
    gl.CallList(1);
}

SCENE(buffer_types_and_offsets,
      "shorts, doubles, bytes at odd offsets, one array in a buffer and one in client memory") {
    pixel_projection(gl);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.EnableClientState(GL_COLOR_ARRAY);
    for_cells(3, 2, [&](int cell, float x, float y, float w, float h) {
        std::vector<GLubyte> bytes(7), colours(5);
        std::vector<GLfloat> client;
        for (int i = 0; i < 12; ++i) {
            const float a = 0.5236F * static_cast<float>(i), r = (i % 2 ? 0.3F : 0.45F) * std::min(w, h);
            const double at[] = {x + w / 2 + r * std::cos(a), y + h / 2 + r * std::sin(a)};
            for (const double value : at) {
                const auto append = [&](auto number) {
                    const auto* const from = reinterpret_cast<const GLubyte*>(&number);
                    bytes.insert(bytes.end(), from, from + sizeof number);
                };
                if (cell % 3 == 0) append(static_cast<GLshort>(value));
                if (cell % 3 == 1) append(static_cast<GLfloat>(value));
                if (cell % 3 == 2) append(value);
            }
            const Colour colour = hue(static_cast<float>(i + cell) / 12);
            for (const float value : colour) {
                colours.push_back(static_cast<GLubyte>(255 * value));
                client.push_back(value);
            }
        }
        const GLenum types[] = {GL_SHORT, GL_FLOAT, GL_DOUBLE};
        make_buffer(gl, GL_ARRAY_BUFFER, bytes);
        gl.VertexPointer(2, types[cell % 3], 0, offset(7));
        if (cell < 3) {
            make_buffer(gl, GL_ARRAY_BUFFER, colours);
            gl.ColorPointer(4, GL_UNSIGNED_BYTE, 0, offset(5));
        } else {
            gl.BindBuffer(GL_ARRAY_BUFFER, 0);
            gl.ColorPointer(4, GL_FLOAT, 0, client.data());
        }
        gl.DrawArrays(cell == 4 ? GL_QUADS : GL_TRIANGLE_FAN, 0, 12);
    });
}

SCENE(buffer_streaming,
      "a buffer filled by mapping, by parts and anew between draws; ArrayElement; MultiDraw") {
    pixel_projection(gl);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    make_buffer(gl, GL_ARRAY_BUFFER, std::vector<float>(16));
    gl.VertexPointer(2, GL_FLOAT, 0, nullptr);
    for_cells(4, 3, [&](int cell, float x, float y, float w, float h) {
        const float corners[] = {x + 4, y + 4, x + w - 4, y + 8, x + w - 10, y + h - 4, x + 8, y + h - 10};
        gl.Color4fv(hue(static_cast<float>(cell) / 12).data());
        if (cell % 3 == 0) {
            gl.BufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STREAM_DRAW);
        } else if (cell % 3 == 1) {
            void* const mapped = gl.MapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY);
            if (mapped) std::memcpy(mapped, corners, sizeof corners);
            notes.value("unmapped", gl.UnmapBuffer(GL_ARRAY_BUFFER));
        } else {
            gl.BufferSubData(GL_ARRAY_BUFFER, 0, 20, corners);
            gl.BufferSubData(GL_ARRAY_BUFFER, 20, sizeof corners - 20, corners + 5);
        }
        if (cell < 6) return gl.DrawArrays(GL_QUADS, 0, 4);
        if (cell < 9) {
            gl.Begin(GL_TRIANGLE_FAN);
            for (int i = 0; i < 4; ++i) gl.ArrayElement(i);
            return gl.End();
        }
        const GLint firsts[] = {0, 1};
        const GLsizei counts[] = {3, 3};
        gl.MultiDrawArrays(GL_TRIANGLES, firsts, counts, 2);
    });
    float back[4] = {};
    gl.GetBufferSubData(GL_ARRAY_BUFFER, 8, sizeof back, back);
    notes.values("read back", back);
}
