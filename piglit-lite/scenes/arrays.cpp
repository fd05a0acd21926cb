// Chapter: vertex arrays (GL 1.5 §2.8).
#include <cmath>
#include <cstring>

#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

// A fan of points round (x, y) in the array's own type; `scale` stretches it, the modelview takes that back.
template <typename T>
std::vector<T> ring(int size, double radius, int count) {
    std::vector<T> values;
    for (int i = 0; i < count; ++i) {
        const double a = 6.283185307 * i / count;
        values.push_back(static_cast<T>(std::lround(radius * std::cos(a))));
        values.push_back(static_cast<T>(std::lround(radius * std::sin(a) * (i % 2 ? 0.6 : 1.0))));
        if (size >= 3) values.push_back(static_cast<T>(i % 3 - 1));
        if (size >= 4) values.push_back(static_cast<T>(2));
    }
    return values;
}

}  // namespace

SCENE(array_vertex_types, "vertex arrays of 2, 3 and 4 shorts, ints, floats and doubles") {
    gl.MatrixMode(GL_PROJECTION);
    gl.Ortho(0, 256, 0, 256, -4, 4);
    gl.MatrixMode(GL_MODELVIEW);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    const GLenum types[] = {GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE};
    for_cells(4, 3, [&](int cell, float x, float y, float w, float h) {
        const int size = 2 + cell / 4;
        const double radius = size == 4 ? 56 : 28;
        const auto s = ring<GLshort>(size, radius, 12);
        const auto n = ring<GLint>(size, radius, 12);
        const auto f = ring<GLfloat>(size, radius, 12);
        const auto d = ring<GLdouble>(size, radius, 12);
        const void* data[] = {s.data(), n.data(), f.data(), d.data()};
        gl.VertexPointer(size, types[cell % 4], 0, data[cell % 4]);
        gl.LoadIdentity();
        gl.Translatef(x + w / 2, y + h / 2, 0);
        gl.Color4fv(hue(static_cast<float>(cell) / 12).data());
        gl.DrawArrays(GL_POLYGON, 0, 12);
    });
}

// One vertex alone decides whether positions are divided and coordinates project; it is not the first one.
SCENE(array_fourth_components,
      "w and q that differ from 1 in one vertex: four types, in order, by index, in lists") {
    gl.MatrixMode(GL_PROJECTION);
    gl.Ortho(0, 256, 0, 256, -1, 1);
    gl.MatrixMode(GL_MODELVIEW);
    painted_texture(gl, 64, 64, GL_NEAREST, GL_NEAREST);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    gl.Enable(GL_TEXTURE_2D);
    const float colors[] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
    gl.ColorPointer(3, GL_FLOAT, 0, colors);
    for (const GLenum array : {GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY})
        gl.EnableClientState(array);
    for_cells(4, 4, [&](int cell, float x, float y, float w, float h) {
        const auto draw = [&](auto number, GLenum type) {
            using T = decltype(number);
            std::vector<T> positions, coordinates;
            for (int i = 0; i < 4; ++i) {
                // Rows of cells: neither, w, q, and both are other than 1 in the third vertex.
                const int row = cell / 4, w4 = i == 2 && row & 1 ? 2 : 1, q = i == 2 && row & 2 ? 3 : 1;
                const double px = x + 4 + (i & 1) * (w - 8), py = y + 4 + (i >> 1) * (h - 8);
                for (const double value : {px * w4, py * w4, 0.0, 1.0 * w4})
                    positions.push_back(static_cast<T>(value));
                for (const int value : {(i & 1) * q, (i >> 1) * q, 0, q})
                    coordinates.push_back(static_cast<T>(value));
            }
            const GLubyte order[] = {0, 1, 2, 1, 2, 3};
            gl.VertexPointer(4, type, 0, positions.data());
            gl.TexCoordPointer(4, type, 0, coordinates.data());
            const bool in_list = (cell + cell / 4) % 2 != 0;
            if (in_list) gl.NewList(1, GL_COMPILE);
            if (cell % 2) {
                gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE, order);
            } else {
                gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
            }
            if (in_list) gl.EndList(), gl.CallList(1);
        };
        if (cell % 4 == 0) draw(GLshort{}, GL_SHORT);
        if (cell % 4 == 1) draw(GLint{}, GL_INT);
        if (cell % 4 == 2) draw(GLfloat{}, GL_FLOAT);
        if (cell % 4 == 3) draw(GLdouble{}, GL_DOUBLE);
    });
}

SCENE(array_colour_types, "colour arrays of three and four components in all eight types") {
    pixel_projection(gl);
    const auto ramp = [](auto top, int size) {
        using T = decltype(top);
        std::vector<T> values;
        for (int i = 0; i < 8; ++i)
            for (int c = 0; c < size; ++c)
                values.push_back(
                    static_cast<T>(static_cast<double>(top) * ((i * (c + 2) + c * 3) % 8) / 7.0));
        return values;
    };
    float positions[8][2];
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.EnableClientState(GL_COLOR_ARRAY);
    gl.VertexPointer(2, GL_FLOAT, 0, positions);
    for_cells(4, 4, [&](int cell, float x, float y, float w, float h) {
        for (int i = 0; i < 8; ++i) {
            positions[i][0] = x + 3 + (w - 6) * static_cast<float>(i / 2) / 3;
            positions[i][1] = y + (i % 2 ? h - 3 : 3);
        }
        const int size = cell < 8 ? 3 : 4;
        const auto b = ramp(GLbyte{127}, size);
        const auto ub = ramp(GLubyte{255}, size);
        const auto s = ramp(GLshort{32767}, size);
        const auto us = ramp(GLushort{65535}, size);
        const auto n = ramp(GLint{2147483647}, size);
        const auto un = ramp(GLuint{4294967295U}, size);
        const auto f = ramp(GLfloat{1}, size);
        const auto d = ramp(GLdouble{1}, size);
        const struct {
            GLenum type;
            const void* data;
        } arrays[] = {{GL_BYTE, b.data()},  {GL_UNSIGNED_BYTE, ub.data()},
                      {GL_SHORT, s.data()}, {GL_UNSIGNED_SHORT, us.data()},
                      {GL_INT, n.data()},   {GL_UNSIGNED_INT, un.data()},
                      {GL_FLOAT, f.data()}, {GL_DOUBLE, d.data()}};
        gl.ColorPointer(size, arrays[cell % 8].type, 0, arrays[cell % 8].data);
        gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 8);
    });
}

// The reference forgets the order in ArrayElement and in display lists.
SCENE(array_bgra, "colours and secondary colours with blue first: in order, by index, flat, in a buffer") {
    pixel_projection(gl);
    gl.Enable(GL_COLOR_SUM);
    constexpr int kCount = 12;
    float positions[2 * kCount];
    std::uint8_t colours[4 * kCount], secondary[8 * kCount];
    std::uint16_t indices[kCount];
    Random random(5);
    for (std::uint8_t& byte : colours) byte = static_cast<std::uint8_t>(random.bits());
    for (std::uint8_t& byte : secondary) byte = static_cast<std::uint8_t>(random.bits() % 85);
    for (int i = 0; i < kCount; ++i) indices[i] = static_cast<std::uint16_t>(i);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.EnableClientState(GL_COLOR_ARRAY);
    gl.EnableClientState(GL_SECONDARY_COLOR_ARRAY);
    gl.VertexPointer(2, GL_FLOAT, 0, positions);
    for_cells(2, 2, [&](int cell, float x, float y, float w, float h) {
        for (int i = 0; i < kCount; ++i) {
            positions[2 * i] = x + 2 + (w - 4) * static_cast<float>(i / 2) / (kCount / 2 - 1);
            positions[2 * i + 1] = y + (i % 2 ? h - 3 : 3);
        }
        gl.ColorPointer(GL_BGRA, GL_UNSIGNED_BYTE, 0, colours);
        gl.SecondaryColorPointer(cell < 3 ? GL_BGRA : 3, GL_UNSIGNED_BYTE, 8, secondary);
        gl.ShadeModel(cell == 2 ? GL_FLAT : GL_SMOOTH);
        if (cell == 1) return gl.DrawElements(GL_TRIANGLE_STRIP, kCount, GL_UNSIGNED_SHORT, indices);
        if (cell == 3) {
            GLuint buffer = 0;
            gl.GenBuffers(1, &buffer);
            gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
            gl.BufferData(GL_ARRAY_BUFFER, sizeof colours, colours, GL_STATIC_DRAW);
            gl.ColorPointer(GL_BGRA, GL_UNSIGNED_BYTE, 0, nullptr);
            gl.BindBuffer(GL_ARRAY_BUFFER, 0);
        }
        gl.DrawArrays(GL_TRIANGLE_STRIP, 0, kCount);
    });
    GLint size = 0;
    gl.GetIntegerv(GL_COLOR_ARRAY_SIZE, &size);
    notes.value("size", size);
}

SCENE(array_normal_and_texture_types,
      "normal arrays of five types, texture coordinate arrays of four types and sizes") {
    const Solid grid = make_grid(1, 6);
    for_viewports(gl, 3, 3, [&](int cell) {
        camera(gl, 45, 3);
        gl.EnableClientState(GL_VERTEX_ARRAY);
        gl.VertexPointer(3, GL_FLOAT, sizeof(SolidVertex), grid.vertices[0].position);
        std::vector<GLbyte> nb;
        std::vector<GLshort> ns, ts;
        std::vector<GLint> ni, ti;
        std::vector<GLdouble> nd, td;
        std::vector<GLfloat> tf;
        const int size = cell % 4 + 1;
        for (std::size_t i = 0; i < grid.vertices.size(); ++i) {
            const float n[] = {0.6F * std::sin(static_cast<float>(i)),
                               0.5F * std::cos(static_cast<float>(i) * 0.7F), 0.6F};
            for (const float value : n) {
                nb.push_back(static_cast<GLbyte>(127 * value));
                ns.push_back(static_cast<GLshort>(32767 * value));
                ni.push_back(static_cast<GLint>(2147480000.0F * value));
                nd.push_back(value);
            }
            const float t[] = {3 * grid.vertices[i].texture[0], 3 * grid.vertices[i].texture[1], 0, 1};
            for (int c = 0; c < size; ++c) {
                ts.push_back(static_cast<GLshort>(std::lround(t[c])));
                ti.push_back(static_cast<GLint>(std::lround(t[c])));
                td.push_back(t[c]);
                tf.push_back(t[c]);
            }
        }
        if (cell < 5) {
            gl.Enable(GL_LIGHTING);
            gl.Enable(GL_LIGHT0);
            gl.Enable(GL_NORMALIZE);
            gl.EnableClientState(GL_NORMAL_ARRAY);
            if (cell == 0) gl.NormalPointer(GL_BYTE, 0, nb.data());
            if (cell == 1) gl.NormalPointer(GL_SHORT, 0, ns.data());
            if (cell == 2) gl.NormalPointer(GL_INT, 0, ni.data());
            if (cell == 3) gl.NormalPointer(GL_FLOAT, sizeof(SolidVertex), grid.vertices[0].normal);
            if (cell == 4) gl.NormalPointer(GL_DOUBLE, 0, nd.data());
        } else {
            gl.Disable(GL_LIGHTING);
            gl.Enable(GL_TEXTURE_2D);
            painted_texture(gl, 16, 16, GL_NEAREST, GL_NEAREST);
            gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
            if (cell == 5) gl.TexCoordPointer(size, GL_SHORT, 0, ts.data());
            if (cell == 6) gl.TexCoordPointer(size, GL_INT, 0, ti.data());
            if (cell == 7) gl.TexCoordPointer(size, GL_FLOAT, 0, tf.data());
            if (cell == 8) gl.TexCoordPointer(size, GL_DOUBLE, 0, td.data());
        }
        if (cell < 3) {
            // The reference's draws take signed integers by a later version's rule (doc/reference.md §2.1).
            gl.Begin(GL_TRIANGLES);
            for (const std::uint16_t index : grid.indices) gl.ArrayElement(index);
            gl.End();
        } else {
            gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(grid.indices.size()), GL_UNSIGNED_SHORT,
                            grid.indices.data());
        }
        gl.DisableClientState(GL_NORMAL_ARRAY);
        gl.DisableClientState(GL_TEXTURE_COORD_ARRAY);
    });
}

SCENE(array_strides, "tight, padded and unaligned strides, and a stride shorter than its element") {
    pixel_projection(gl);
    std::vector<std::uint8_t> bytes(4000);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    for_cells(3, 2, [&](int cell, float x, float y, float w, float h) {
        const int strides[] = {8, 12, 17, 64, 9, 4};
        const int stride = strides[cell], offset = cell == 4 ? 3 : 0;
        for (int i = 0; i < 14; ++i) {
            const float a = 0.4488F * static_cast<float>(i);
            const float point[] = {x + w / 2 + w * 0.4F * std::cos(a), y + h / 2 + h * 0.4F * std::sin(a)};
            std::memcpy(bytes.data() + offset + i * stride, point, sizeof point);
        }
        if (stride == 4)  // overlapping pairs: a walk in which each x is the previous y
            for (int i = 0; i < 15; ++i) {
                const float value = 20 + 14 * static_cast<float>(i * i % 11);
                std::memcpy(bytes.data() + i * 4, &value, sizeof value);
            }
        gl.VertexPointer(2, GL_FLOAT, stride, bytes.data() + offset);
        gl.Color4fv(hue(static_cast<float>(cell) / 6).data());
        gl.DrawArrays(cell == 5 ? GL_LINE_STRIP : GL_TRIANGLE_FAN, 0, 14);
    });
}

SCENE(array_elements_types,
      "DrawElements with byte, short and int indices, DrawRangeElements, repeated and reversed indices") {
    pixel_projection(gl);
    float positions[40][2], colours[40][4];
    for (int i = 0; i < 40; ++i) {
        positions[i][0] = static_cast<float>(i % 8) * 11 + 4;
        positions[i][1] = static_cast<float>(i / 8) * 22 + 8 + static_cast<float>(i % 3) * 3;
        const Colour colour = hue(static_cast<float>(i) / 40);
        std::memcpy(colours[i], colour.data(), sizeof colours[i]);
    }
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.EnableClientState(GL_COLOR_ARRAY);
    gl.VertexPointer(2, GL_FLOAT, 0, positions);
    gl.ColorPointer(4, GL_FLOAT, 0, colours);
    GLubyte ub[18];
    GLushort us[18];
    GLuint ui[18];
    for (int i = 0; i < 18; ++i)
        ub[i] = static_cast<GLubyte>(i * 7 % 40), us[i] = static_cast<GLushort>(39 - i),
        ui[i] = static_cast<GLuint>((i / 2 * 4 + i % 2 * 8) % 40);
    for_cells(3, 3, [&](int cell, float x, float y, float, float) {
        gl.LoadIdentity();
        gl.Translatef(x - (cell % 3 ? 2.0F : 0.0F), y * 0.8F, 0);
        gl.Scalef(0.85F, 0.7F, 1);
        const GLenum modes[] = {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_LINE_LOOP};
        if (cell / 3 == 0) gl.DrawElements(modes[cell % 3], 18, GL_UNSIGNED_BYTE, ub);
        if (cell / 3 == 1) gl.DrawRangeElements(modes[cell % 3], 22, 39, 18, GL_UNSIGNED_SHORT, us);
        if (cell / 3 == 2) gl.DrawElements(modes[cell % 3], 18, GL_UNSIGNED_INT, ui);
    });
}

SCENE(array_element_command, "ArrayElement mixed with immediate attributes, and outside Begin/End") {
    pixel_projection(gl);
    float positions[24][2], colours[24][3];
    for (int i = 0; i < 24; ++i) {
        const float a = 0.2618F * static_cast<float>(i), r = i % 2 ? 110.0F : 55.0F;
        positions[i][0] = 128 + r * std::cos(a);
        positions[i][1] = 128 + r * std::sin(a);
        const Colour colour = hue(static_cast<float>(i) / 24);
        for (std::size_t c = 0; c < 3; ++c) colours[i][c] = colour[c];
    }
    gl.VertexPointer(2, GL_FLOAT, 0, positions);
    gl.ColorPointer(3, GL_FLOAT, 0, colours);
    gl.EnableClientState(GL_COLOR_ARRAY);
    gl.ArrayElement(5);  // vertex array off: the colour becomes current
    GLfloat current[4];
    gl.GetFloatv(GL_CURRENT_COLOR, current);
    notes.values("current colour", current, 1e-6);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.Begin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 26; ++i) {
        gl.ArrayElement(i % 24);
    }
    gl.End();
    gl.DisableClientState(GL_COLOR_ARRAY);
    gl.Begin(GL_TRIANGLES);
    for (int i = 0; i < 24; i += 8) {
        gl.Color4fv(hue(static_cast<float>(i) / 24 + 0.5F).data());
        gl.ArrayElement(i);
    }
    gl.End();
}

SCENE(array_interleaved_formats, "the fourteen interleaved formats") {
    const GLenum formats[] = {
        GL_V2F,         GL_V3F,         GL_C4UB_V2F,        GL_C4UB_V3F,       GL_C3F_V3F,
        GL_N3F_V3F,     GL_C4F_N3F_V3F, GL_T2F_V3F,         GL_T4F_V4F,        GL_T2F_C4UB_V3F,
        GL_T2F_C3F_V3F, GL_T2F_N3F_V3F, GL_T2F_C4F_N3F_V3F, GL_T4F_C4F_N3F_V4F};
    struct Layout {
        int t, c, n, v;  // components; c = -4 means four bytes
    };
    const Layout layouts[] = {{0, 0, 0, 2}, {0, 0, 0, 3}, {0, -4, 0, 2}, {0, -4, 0, 3}, {0, 3, 0, 3},
                              {0, 0, 3, 3}, {0, 4, 3, 3}, {2, 0, 0, 3},  {4, 0, 0, 4},  {2, -4, 0, 3},
                              {2, 3, 0, 3}, {2, 0, 3, 3}, {2, 4, 3, 3},  {4, 4, 3, 4}};
    pixel_projection(gl);
    painted_texture(gl, 16, 16, GL_NEAREST, GL_NEAREST);
    for_cells(4, 4, [&](int cell, float x, float y, float w, float h) {
        if (cell >= 14) return;
        const Layout& layout = layouts[cell];
        std::vector<std::uint8_t> bytes;
        const auto put = [&](const void* data, std::size_t size) {
            const auto* from = static_cast<const std::uint8_t*>(data);
            bytes.insert(bytes.end(), from, from + size);
        };
        for (int i = 0; i < 6; ++i) {
            const float s = static_cast<float>(i / 2) / 2, t = static_cast<float>(i % 2);
            const float texture[] = {s, t, 0, 1};
            const Colour colour = hue(static_cast<float>(i) / 6);
            const GLubyte colour_bytes[] = {static_cast<GLubyte>(255 * colour[0]),
                                            static_cast<GLubyte>(255 * colour[1]),
                                            static_cast<GLubyte>(255 * colour[2]), 255};
            const float normal[] = {s - 0.5F, t - 0.5F, 0.7F};
            const float position[] = {x + 3 + s * (w - 6), y + 3 + t * (h - 6), 0, 1};
            put(texture, sizeof(float) * static_cast<std::size_t>(layout.t));
            if (layout.c == -4)
                put(colour_bytes, 4);
            else
                put(colour.data(), sizeof(float) * static_cast<std::size_t>(layout.c));
            put(normal, sizeof(float) * static_cast<std::size_t>(layout.n));
            put(position, sizeof(float) * static_cast<std::size_t>(layout.v));
        }
        gl.Color4fv(hue(static_cast<float>(cell) / 14).data());
        gl.InterleavedArrays(formats[cell], 0, bytes.data());
        if (layout.t)
            gl.Enable(GL_TEXTURE_2D);
        else
            gl.Disable(GL_TEXTURE_2D);
        if (layout.n && !layout.c)
            gl.Enable(GL_LIGHTING), gl.Enable(GL_LIGHT0);
        else
            gl.Disable(GL_LIGHTING);
        gl.DrawArrays(GL_QUAD_STRIP, 0, 6);
        for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY,
                                   GL_EDGE_FLAG_ARRAY, GL_INDEX_ARRAY})
            notes.value("format " + std::to_string(cell) + " enables " + std::to_string(array),
                        gl.IsEnabled(array));
    });
}

SCENE(array_multi_draw, "MultiDrawArrays and MultiDrawElements (GL 1.4), with empty members") {
    pixel_projection(gl);
    float positions[60][2], colours[60][4];
    for (int i = 0; i < 60; ++i) {
        positions[i][0] = 6 + static_cast<float>(i % 20) * 12.5F;
        positions[i][1] = 10 + static_cast<float>(i / 20) * 80 + (i % 2 ? 60.0F : 0.0F);
        const Colour colour = hue(static_cast<float>(i) / 20);
        std::memcpy(colours[i], colour.data(), sizeof colours[i]);
    }
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.EnableClientState(GL_COLOR_ARRAY);
    gl.VertexPointer(2, GL_FLOAT, 0, positions);
    gl.ColorPointer(4, GL_FLOAT, 0, colours);
    const GLint firsts[] = {0, 6, 10, 12, 16};
    const GLsizei counts[] = {5, 3, 0, 2, 4};
    gl.MultiDrawArrays(GL_TRIANGLE_STRIP, firsts, counts, 5);
    const GLubyte a[] = {20, 21, 22, 23, 24}, b[] = {26, 27, 29, 28}, c[] = {32, 33, 34, 39, 38, 37};
    const void* lists[] = {a, b, c};
    const GLsizei sizes[] = {5, 4, 6};
    gl.MultiDrawElements(GL_TRIANGLE_STRIP, sizes, GL_UNSIGNED_BYTE, const_cast<const void* const*>(lists),
                         3);
    gl.DrawArrays(GL_LINE_STRIP, 41, 17);
}

SCENE(array_edge_flags_and_index, "edge flag arrays in line mode, and index arrays by their current value") {
    pixel_projection(gl);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    float positions[24][2];
    GLboolean flags[48];
    for (int i = 0; i < 24; ++i) {
        positions[i][0] = 128 + (60 + 50 * std::sin(static_cast<float>(i) * 1.7F)) *
                                    std::cos(0.2618F * static_cast<float>(i));
        positions[i][1] = 128 + (60 + 50 * std::sin(static_cast<float>(i) * 1.7F)) *
                                    std::sin(0.2618F * static_cast<float>(i));
        flags[2 * i] = i % 4 != 0;
        flags[2 * i + 1] = 0;
    }
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.EnableClientState(GL_EDGE_FLAG_ARRAY);
    gl.VertexPointer(2, GL_FLOAT, 0, positions);
    gl.EdgeFlagPointer(2, flags);
    gl.Color4fv(hue(0.2F).data());
    gl.DrawArrays(GL_TRIANGLES, 0, 24);
    const GLfloat indices[] = {3, 5, 8};
    gl.IndexPointer(GL_FLOAT, 0, indices);
    gl.EnableClientState(GL_INDEX_ARRAY);
    gl.DisableClientState(GL_VERTEX_ARRAY);
    gl.ArrayElement(2);
    GLfloat index = 0;
    gl.GetFloatv(GL_CURRENT_INDEX, &index);
    notes.value("current index", index);
}

SCENE(array_all_modes, "DrawArrays and DrawElements in each of the ten modes") {
    pixel_projection(gl);
    gl.PointSize(4);
    float positions[12][2], colours[12][4];
    GLushort order[12];
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.EnableClientState(GL_COLOR_ARRAY);
    gl.VertexPointer(2, GL_FLOAT, 0, positions);
    gl.ColorPointer(4, GL_FLOAT, 0, colours);
    for_cells(5, 4, [&](int cell, float x, float y, float w, float h) {
        for (int i = 0; i < 12; ++i) {
            const float a = 0.5236F * static_cast<float>(i);
            const bool inner = (cell % 10 == GL_TRIANGLE_STRIP || cell % 10 == GL_QUAD_STRIP) && i % 2;
            positions[i][0] = x + w / 2 + w * (inner ? 0.2F : 0.45F) * std::cos(a);
            positions[i][1] = y + h / 2 + h * (inner ? 0.2F : 0.45F) * std::sin(a);
            const Colour colour = hue(static_cast<float>(i) / 12 + static_cast<float>(cell) / 20);
            std::memcpy(colours[i], colour.data(), sizeof colours[i]);
            order[i] = static_cast<GLushort>(11 - i);
        }
        if (cell < 10)
            gl.DrawArrays(static_cast<GLenum>(cell), 0, 12);
        else
            gl.DrawElements(static_cast<GLenum>(cell - 10), 12, GL_UNSIGNED_SHORT, order);
    });
}

SCENE(array_large_indexed, "a mesh of 20000 triangles in one DrawElements, vertices used many times") {
    camera(gl, 45, 4);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_CULL_FACE);
    gl.Rotatef(-55, 1, 0.3F, 0.1F);
    draw_solid(gl, make_torus(1.1F, 0.5F, 200, 50), kColours);
}
