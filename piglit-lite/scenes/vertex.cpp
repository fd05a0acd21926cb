// Chapter: Begin/End and every form of the vertex, colour, normal, texture coordinate and index commands
// (GL 1.5 §2.6-2.7).
#include <cmath>
#include <numbers>

#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

constexpr float kTau = 2 * std::numbers::pi_v<float>;

// Points of a flower outline in a cell, for primitives of any kind.
struct Flower {
    float x, y, radius;
    std::array<float, 2> at(int i, int count, float wobble = 0.3F) const {
        const float a = kTau * static_cast<float>(i) / static_cast<float>(count);
        const float r = radius * (1 - wobble + wobble * std::cos(5 * a));
        return {x + r * std::cos(a), y + r * std::sin(a)};
    }
};

void coloured_vertex(const Gl& gl, std::array<float, 2> point, float turn) {
    gl.Color4fv(hue(turn).data());
    gl.Vertex2fv(point.data());
}

}  // namespace

SCENE(vertex_all_primitives, "each of the ten Begin modes over the same rings of points, one a cell") {
    pixel_projection(gl);
    gl.PointSize(5);
    gl.LineWidth(3);
    for_cells(4, 3, [&](int cell, float x, float y, float w, float h) {
        if (cell > GL_POLYGON) return;
        const Flower flower{x + w / 2, y + h / 2, w * 0.45F};
        const bool strip = cell == GL_TRIANGLE_STRIP || cell == GL_QUAD_STRIP;
        gl.Begin(static_cast<GLenum>(cell));
        if (cell == GL_TRIANGLE_FAN) coloured_vertex(gl, {flower.x, flower.y}, 0);
        for (int i = 0; i < 20; ++i) {
            auto point = flower.at(i, 20, cell == GL_POLYGON ? 0.0F : 0.2F);
            if (strip && i % 2) point = {(point[0] + 2 * flower.x) / 3, (point[1] + 2 * flower.y) / 3};
            coloured_vertex(gl, point, static_cast<float>(i) / 20);
        }
        gl.End();
    });
}

SCENE(vertex_incomplete_primitives,
      "Begin/End pairs with too few or left-over vertices draw only whole primitives") {
    pixel_projection(gl);
    gl.PointSize(4);
    gl.LineWidth(2);
    for_cells(10, 9, [&](int cell, float x, float y, float w, float h) {
        const auto mode = static_cast<GLenum>(cell % 10);
        const int count = cell / 10;
        const Flower flower{x + w / 2, y + h / 2, w * 0.42F};
        gl.Begin(mode);
        for (int i = 0; i < count; ++i) coloured_vertex(gl, flower.at(i, 8, 0), static_cast<float>(i) / 8);
        gl.End();
    });
}

SCENE(vertex_position_forms, "Vertex2/3/4 of short, int, float and double, scalars and vectors") {
    pixel_projection(gl);
    int slot = 0;
    const auto place = [&] {
        gl.LoadIdentity();
        gl.Translatef(static_cast<float>(slot % 6) * 42 + 4, static_cast<float>(slot / 6) * 60 + 4, 0);
        gl.Color4fv(hue(static_cast<float>(slot) / 24).data());
        ++slot;
    };
    const auto triangle = [&](const auto& vertex) {
        place();
        gl.Begin(GL_TRIANGLES);
        vertex(0, 0);
        vertex(36, 10);
        vertex(12, 50);
        gl.End();
    };
    triangle([&](int x, int y) { gl.Vertex2s(static_cast<GLshort>(x), static_cast<GLshort>(y)); });
    triangle([&](int x, int y) { gl.Vertex2i(x, y); });
    triangle([&](int x, int y) { gl.Vertex2f(static_cast<float>(x) + 0.5F, static_cast<float>(y)); });
    triangle([&](int x, int y) { gl.Vertex2d(x - 0.25, y); });
    triangle([&](int x, int y) { gl.Vertex3s(static_cast<GLshort>(x), static_cast<GLshort>(y), 0); });
    triangle([&](int x, int y) { gl.Vertex3i(x, y, 0); });
    triangle([&](int x, int y) { gl.Vertex3f(static_cast<float>(x), static_cast<float>(y) + 0.5F, 0.5F); });
    triangle([&](int x, int y) { gl.Vertex3d(x, y, -0.5); });
    triangle([&](int x, int y) { gl.Vertex4s(static_cast<GLshort>(x), static_cast<GLshort>(y), 0, 1); });
    triangle([&](int x, int y) { gl.Vertex4i(2 * x, 2 * y, 0, 2); });
    triangle(
        [&](int x, int y) { gl.Vertex4f(static_cast<float>(x) / 2, static_cast<float>(y) / 2, 0, 0.5F); });
    triangle([&](int x, int y) { gl.Vertex4d(x * 0.25, y * 0.25, 0, 0.25); });
    triangle([&](int x, int y) {
        const GLshort v[] = {static_cast<GLshort>(x), static_cast<GLshort>(y)};
        gl.Vertex2sv(v);
    });
    triangle([&](int x, int y) {
        const GLint v[] = {x, y};
        gl.Vertex2iv(v);
    });
    triangle([&](int x, int y) {
        const GLfloat v[] = {static_cast<float>(x), static_cast<float>(y)};
        gl.Vertex2fv(v);
    });
    triangle([&](int x, int y) {
        const GLdouble v[] = {x + 0.25, y + 0.75};
        gl.Vertex2dv(v);
    });
    triangle([&](int x, int y) {
        const GLshort v[] = {static_cast<GLshort>(x), static_cast<GLshort>(y), 1};
        gl.Vertex3sv(v);
    });
    triangle([&](int x, int y) {
        const GLint v[] = {x, y, -1};
        gl.Vertex3iv(v);
    });
    triangle([&](int x, int y) {
        const GLfloat v[] = {static_cast<float>(x), static_cast<float>(y), 0};
        gl.Vertex3fv(v);
    });
    triangle([&](int x, int y) {
        const GLdouble v[] = {x + 0.0, y + 0.0, 0.25};
        gl.Vertex3dv(v);
    });
    triangle([&](int x, int y) {
        const GLshort v[] = {static_cast<GLshort>(x * 3), static_cast<GLshort>(y * 3), 0, 3};
        gl.Vertex4sv(v);
    });
    triangle([&](int x, int y) {
        const GLint v[] = {x * 5, y * 5, 0, 5};
        gl.Vertex4iv(v);
    });
    triangle([&](int x, int y) {
        const GLfloat v[] = {static_cast<float>(x), static_cast<float>(y), 0, 1};
        gl.Vertex4fv(v);
    });
    triangle([&](int x, int y) {
        const GLdouble v[] = {x * 8.0, y * 8.0, 0, 8};
        gl.Vertex4dv(v);
    });
}

SCENE(vertex_colour_forms, "all 32 Color commands, each a patch with its own conversion to the unit range") {
    pixel_projection(gl);
    std::vector<std::function<void(float)>> forms;  // set the colour for a brightness 0..1
    const auto add = [&](auto scale, auto three, auto four, auto three_v, auto four_v) {
        using T = decltype(scale);
        const double top = static_cast<double>(scale);
        const auto convert = [top](double value) { return static_cast<T>(top * value); };
        forms.push_back([=](float t) { three(convert(t), convert(0.5 * t), convert(1 - t)); });
        forms.push_back([=](float t) { four(convert(1 - t), convert(t), convert(0.25), convert(t)); });
        forms.push_back([=](float t) {
            const T v[] = {convert(0.2), convert(t), convert(t * t)};
            three_v(v);
        });
        forms.push_back([=](float t) {
            const T v[] = {convert(t), convert(0.1), convert(1 - t), convert(0.5)};
            four_v(v);
        });
    };
    add(GLbyte{127}, gl.Color3b, gl.Color4b, gl.Color3bv, gl.Color4bv);
    add(GLubyte{255}, gl.Color3ub, gl.Color4ub, gl.Color3ubv, gl.Color4ubv);
    add(GLshort{32767}, gl.Color3s, gl.Color4s, gl.Color3sv, gl.Color4sv);
    add(GLushort{65535}, gl.Color3us, gl.Color4us, gl.Color3usv, gl.Color4usv);
    add(GLint{2147483647}, gl.Color3i, gl.Color4i, gl.Color3iv, gl.Color4iv);
    add(GLuint{4294967295U}, gl.Color3ui, gl.Color4ui, gl.Color3uiv, gl.Color4uiv);
    add(GLfloat{1}, gl.Color3f, gl.Color4f, gl.Color3fv, gl.Color4fv);
    add(GLdouble{1}, gl.Color3d, gl.Color4d, gl.Color3dv, gl.Color4dv);
    for_cells(4, 8, [&](int cell, float x, float y, float w, float h) {
        gl.Begin(GL_QUAD_STRIP);
        for (int i = 0; i <= 5; ++i) {
            forms[static_cast<std::size_t>(cell)](static_cast<float>(i) / 5);
            gl.Vertex2f(x + w * static_cast<float>(i) / 5, y + 3);
            gl.Vertex2f(x + w * static_cast<float>(i) / 5, y + h);
        }
        gl.End();
        GLfloat current[4];
        gl.GetFloatv(GL_CURRENT_COLOR, current);
        // One unit of the last place of the shortest form is 2^-31; float has 24 bits.
        notes.values("colour form " + std::to_string(cell), current, 1e-6);
    });
}

SCENE(vertex_colour_out_of_range,
      "colours below 0 and above 1 are clamped after interpolation set-up, not before") {
    pixel_projection(gl);
    const float levels[][4] = {
        {2, -1, 0.5F, 1}, {-0.5F, 1.5F, 0.2F, 3}, {0, 0.5F, 4, -2}, {1.25F, 1.25F, -3, 0.5F}};
    for_cells(2, 2, [&](int cell, float x, float y, float w, float h) {
        gl.Begin(GL_TRIANGLE_FAN);
        for (int i = 0; i < 4; ++i) {
            gl.Color4fv(levels[(cell + i) % 4]);
            gl.Vertex2f(x + (i == 1 || i == 2 ? w - 6 : 6), y + (i >= 2 ? h - 6 : 6));
        }
        gl.End();
    });
}

SCENE(vertex_normal_forms, "all ten Normal commands light a fan of facets") {
    camera(gl, 40, 4);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.Enable(GL_NORMALIZE);
    const GLfloat light[] = {1, 0.6F, 0.5F, 0};
    gl.Lightfv(GL_LIGHT0, GL_POSITION, light);
    gl.ShadeModel(GL_FLAT);
    for (int facet = 0; facet < 20; ++facet) {
        const float a = kTau * static_cast<float>(facet) / 20, b = kTau * static_cast<float>(facet + 1) / 20;
        const float nx = 0.8F * std::cos(a), ny = 0.8F * std::sin(a), nz = 0.6F;
        gl.Begin(GL_TRIANGLES);
        switch (facet % 10) {
            case 0:
                gl.Normal3f(nx, ny, nz);
                break;
            case 1:
                gl.Normal3d(nx, ny, nz);
                break;
            case 2:
                gl.Normal3b(static_cast<GLbyte>(127 * nx), static_cast<GLbyte>(127 * ny),
                            static_cast<GLbyte>(127 * nz));
                break;
            case 3:
                gl.Normal3s(static_cast<GLshort>(32767 * nx), static_cast<GLshort>(32767 * ny),
                            static_cast<GLshort>(32767 * nz));
                break;
            case 4:
                gl.Normal3i(static_cast<GLint>(2.1e9F * nx), static_cast<GLint>(2.1e9F * ny),
                            static_cast<GLint>(2.1e9F * nz));
                break;
            case 5: {
                const GLfloat v[] = {nx, ny, nz};
                gl.Normal3fv(v);
            } break;
            case 6: {
                const GLdouble v[] = {nx, ny, nz};
                gl.Normal3dv(v);
            } break;
            case 7: {
                const GLbyte v[] = {static_cast<GLbyte>(127 * nx), static_cast<GLbyte>(127 * ny),
                                    static_cast<GLbyte>(127 * nz)};
                gl.Normal3bv(v);
            } break;
            case 8: {
                const GLshort v[] = {static_cast<GLshort>(32767 * nx), static_cast<GLshort>(32767 * ny),
                                     static_cast<GLshort>(32767 * nz)};
                gl.Normal3sv(v);
            } break;
            default: {
                const GLint v[] = {static_cast<GLint>(2.1e9F * nx), static_cast<GLint>(2.1e9F * ny),
                                   static_cast<GLint>(2.1e9F * nz)};
                gl.Normal3iv(v);
            } break;
        }
        gl.Vertex3f(0, 0, 0.4F);
        gl.Vertex3f(1.3F * std::cos(a), 1.3F * std::sin(a), 0);
        gl.Vertex3f(1.3F * std::cos(b), 1.3F * std::sin(b), 0);
        gl.End();
        GLfloat normal[3];
        gl.GetFloatv(GL_CURRENT_NORMAL, normal);
        notes.values("normal " + std::to_string(facet), normal, 1e-6);
    }
}

SCENE(vertex_texcoord_forms, "TexCoord1..4 of all types, with q other than one") {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_2D);
    painted_texture(gl, 32, 32, GL_NEAREST, GL_NEAREST);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    std::vector<std::function<void(int, int)>> forms;  // for corners (0 or 1, 0 or 1)
    const auto add = [&](auto one, auto two, auto three, auto four, auto two_v, auto four_v, auto zero) {
        using T = decltype(zero);
        const auto number = [](int value) { return static_cast<T>(value); };
        forms.push_back([=](int s, int) { one(number(s)); });
        forms.push_back([=](int s, int t) { two(number(s), number(t)); });
        forms.push_back([=](int s, int t) { three(number(s), number(2 * t), number(5)); });
        forms.push_back([=](int s, int t) { four(number(3 * s), number(3 * t), number(1), number(3)); });
        forms.push_back([=](int s, int t) {
            const T v[] = {number(2 * s), number(t)};
            two_v(v);
        });
        forms.push_back([=](int s, int t) {
            const T v[] = {number(s), number(t), number(0), number(s + 1)};
            four_v(v);
        });
    };
    add(gl.TexCoord1s, gl.TexCoord2s, gl.TexCoord3s, gl.TexCoord4s, gl.TexCoord2sv, gl.TexCoord4sv,
        GLshort{});
    add(gl.TexCoord1i, gl.TexCoord2i, gl.TexCoord3i, gl.TexCoord4i, gl.TexCoord2iv, gl.TexCoord4iv, GLint{});
    add(gl.TexCoord1f, gl.TexCoord2f, gl.TexCoord3f, gl.TexCoord4f, gl.TexCoord2fv, gl.TexCoord4fv,
        GLfloat{});
    add(gl.TexCoord1d, gl.TexCoord2d, gl.TexCoord3d, gl.TexCoord4d, gl.TexCoord2dv, gl.TexCoord4dv,
        GLdouble{});
    for_cells(6, 4, [&](int cell, float x, float y, float w, float h) {
        // Where a batch has streamed q before, Mesa 22.3 keeps an old one for vertices that give none.
        gl.Flush();
        gl.Begin(GL_QUADS);
        for (const auto& [s, t] : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
            forms[static_cast<std::size_t>(cell)](s, t);
            gl.Vertex2f(x + 2 + static_cast<float>(s) * (w - 4), y + 2 + static_cast<float>(t) * (h - 4));
        }
        gl.End();
    });
    const GLshort one_s[] = {7};
    gl.TexCoord1sv(one_s);
    const GLint three_i[] = {1, 2, 3};
    gl.TexCoord3iv(three_i);
    GLfloat current[4];
    gl.GetFloatv(GL_CURRENT_TEXTURE_COORDS, current);
    notes.values("texture coordinates", current);
}

SCENE(vertex_index_and_edge_flags,
      "Index and EdgeFlag forms: current values, and edges hidden in line mode") {
    pixel_projection(gl);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    for_cells(3, 3, [&](int cell, float x, float y, float w, float h) {
        const Flower flower{x + w / 2, y + h / 2, w * 0.42F};
        gl.Color4fv(hue(static_cast<float>(cell) / 9).data());
        gl.Begin(cell % 3 == 0 ? GL_POLYGON : cell % 3 == 1 ? GL_TRIANGLES : GL_QUADS);
        for (int i = 0; i < 12; ++i) {
            const GLboolean flag = (i * 7 + cell) % 3 != 0;
            if (cell < 3)
                gl.EdgeFlag(flag);
            else
                gl.EdgeFlagv(&flag);
            gl.Vertex2fv(flower.at(i, 12, cell % 3 == 0 ? 0.0F : 0.4F).data());
        }
        gl.End();
    });
    const GLubyte ub = 200;
    const GLshort s = -3;
    const GLint i = 70000;
    const GLfloat f = 2.5F;
    const GLdouble d = 9.75;
    GLfloat index = 0;
    const auto note = [&](const char* name) {
        gl.GetFloatv(GL_CURRENT_INDEX, &index);
        notes.value(name, index);
    };
    gl.Indexub(ub), note("Indexub"), gl.Indexubv(&ub), note("Indexubv");
    gl.Indexs(s), note("Indexs"), gl.Indexsv(&s), note("Indexsv");
    gl.Indexi(i), note("Indexi"), gl.Indexiv(&i), note("Indexiv");
    gl.Indexf(f), note("Indexf"), gl.Indexfv(&f), note("Indexfv");
    gl.Indexd(d), note("Indexd"), gl.Indexdv(&d), note("Indexdv");
    GLboolean edge = GL_TRUE;
    gl.EdgeFlag(GL_FALSE);
    gl.GetBooleanv(GL_EDGE_FLAG, &edge);
    notes.value("edge flag", edge);
}

SCENE(vertex_rect_forms, "Rects, Recti, Rectf, Rectd and their vector forms, drawn front and back") {
    pixel_projection(gl);
    gl.Enable(GL_CULL_FACE);
    for (int i = 0; i < 8; ++i) {
        gl.LoadIdentity();
        gl.Translatef(static_cast<float>(i % 4) * 64 + 32, static_cast<float>(i / 4) * 128 + 64, 0);
        gl.Rotatef(static_cast<float>(i) * 11, 0, 0, 1);
        gl.Color4fv(hue(static_cast<float>(i) / 8).data());
        const GLshort s[2][2] = {{-20, -40}, {20, 40}};
        const GLint n[2][2] = {{-22, -38}, {22, 38}};
        const GLfloat f[2][2] = {{-18.5F, -42}, {18.5F, 42}};
        const GLdouble d[2][2] = {{-24.25, -30}, {24.25, 30}};
        switch (i) {
            case 0:
                gl.Rects(-20, -40, 20, 40);
                break;
            case 1:
                gl.Recti(-22, -38, 22, 38);
                break;
            case 2:
                gl.Rectf(-18.5F, -42, 18.5F, 42);
                break;
            case 3:
                gl.Rectd(-24.25, -30, 24.25, 30);
                break;
            case 4:
                gl.Rectsv(s[0], s[1]);
                break;
            case 5:
                gl.Rectiv(n[0], n[1]);
                break;
            case 6:
                gl.Rectfv(f[0], f[1]);
                break;
            default:
                gl.Rectdv(d[0], d[1]);
                break;
        }
        gl.Color3f(1, 1, 1);
        gl.Rectf(5, -5, -5, 5);  // opposite corners: clockwise, culled
    }
}

SCENE(vertex_state_between_vertices,
      "colour, normal, texture coordinate and material changed inside Begin/End stick to later vertices") {
    camera(gl, 45, 5);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.Enable(GL_TEXTURE_2D);
    painted_texture(gl, 64, 64, GL_LINEAR, GL_LINEAR);
    gl.Begin(GL_QUAD_STRIP);
    for (int i = 0; i <= 24; ++i) {
        const float a = kTau * static_cast<float>(i) / 24;
        if (i % 3 == 0) gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, hue(static_cast<float>(i) / 24).data());
        if (i % 4 == 0) gl.Normal3f(std::cos(a) * 0.6F, std::sin(a) * 0.6F, 0.8F);
        gl.TexCoord2f(static_cast<float>(i) / 4, 0);
        gl.Vertex3f(0.7F * std::cos(a), 0.7F * std::sin(a), 0.5F);
        gl.TexCoord2f(static_cast<float>(i) / 4, 1);
        gl.Vertex3f(1.8F * std::cos(a), 1.8F * std::sin(a), -0.5F);
    }
    gl.End();
}
