// Trials of the vertex side: lighting, materials, colour conversion. Triangles are flat-shaded and w is 1, so
// that a pixel is a vertex colour and nothing else.
#include <cmath>
#include <cstring>
#include <type_traits>

#include "colors/trial.h"

namespace terrazzo::test {
namespace {

constexpr int kTriangles = 60;

// What the model-view matrix may do to lengths: decides the space of lighting.
void choose_modelview(const Gl& gl, Dice& dice) {
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadIdentity();
    const int kind = dice.pick(4);
    if (kind == 0) return;
    gl.Translatef(dice.number(-1, 1), dice.number(-1, 1), dice.number(-1, 1));
    gl.Rotatef(dice.number(-180, 180), dice.number(-1, 1), dice.number(-1, 1), dice.number(-1, 1));
    const float size = dice.number(0.4f, 2);
    if (kind == 2) gl.Scalef(size, size, size);
    if (kind == 3) gl.Scalef(size, dice.number(0.4f, 2), dice.number(0.4f, 2));
}

void choose_view(const Gl& gl, Dice& dice) {
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    gl.Ortho(-3, 3, -3, 3, -9, 9);
    choose_modelview(gl, dice);
}

void choose_light(const Gl& gl, Dice& dice, GLenum light) {
    gl.Enable(light);
    const bool positional = dice.chance();
    std::array<float, 4> position = dice.numbers<4>(-2, 2);
    position[3] = positional ? dice.one_of({1.0f, 0.7f}) : 0.0f;
    gl.Lightfv(light, GL_POSITION, position.data());
    gl.Lightfv(light, GL_AMBIENT, dice.numbers<4>(0, 0.4f).data());
    gl.Lightfv(light, GL_DIFFUSE, dice.numbers<4>(-0.1f, 0.6f).data());
    gl.Lightfv(light, GL_SPECULAR, dice.numbers<4>(0, 0.6f).data());
    if (dice.pick(3) == 0) {
        gl.Lightf(light, GL_CONSTANT_ATTENUATION, dice.number(0.2f, 1));
        gl.Lightf(light, GL_LINEAR_ATTENUATION, dice.one_of({0.0f, dice.number(0, 0.5f)}));
        gl.Lightf(light, GL_QUADRATIC_ATTENUATION, dice.one_of({0.0f, dice.number(0, 0.5f)}));
    }
    if (dice.pick(3) == 0) {
        gl.Lightfv(light, GL_SPOT_DIRECTION, dice.numbers<3>(-1, 1).data());
        gl.Lightf(light, GL_SPOT_CUTOFF, dice.one_of({90.0f, dice.number(20, 90)}));
        gl.Lightf(light, GL_SPOT_EXPONENT, dice.one_of({0.0f, 1.0f, dice.number(0, 128)}));
    }
}

void choose_material(const Gl& gl, Dice& dice, GLenum face) {
    gl.Materialfv(face, GL_AMBIENT, dice.numbers<4>(0, 1).data());
    gl.Materialfv(face, GL_DIFFUSE, dice.numbers<4>(0, 1).data());
    gl.Materialfv(face, GL_SPECULAR, dice.numbers<4>(0, 1).data());
    gl.Materialfv(face, GL_EMISSION, dice.numbers<4>(0, 0.3f).data());
    gl.Materialf(face, GL_SHININESS, dice.one_of({0.0f, 1.0f, 10.0f, dice.number(0, 128)}));
}

void choose_lighting(const Gl& gl, Dice& dice) {
    gl.Enable(GL_LIGHTING);
    const int lights = 1 + dice.pick(3);
    for (int i = 0; i < lights; ++i) choose_light(gl, dice, static_cast<GLenum>(GL_LIGHT0 + dice.pick(8)));
    gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, dice.pick(3) == 0);
    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, dice.pick(3) == 0);
    gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, dice.pick(3) ? GL_SINGLE_COLOR : GL_SEPARATE_SPECULAR_COLOR);
    gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, dice.numbers<4>(0, 0.5f).data());
    choose_material(gl, dice, GL_FRONT_AND_BACK);
    if (dice.chance()) choose_material(gl, dice, GL_BACK);
    if (dice.pick(3) == 0) gl.Enable(GL_NORMALIZE);
    if (dice.pick(3) == 0) gl.Enable(GL_RESCALE_NORMAL);
    if (dice.pick(3) == 0) {
        const GLenum modes[] = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_AMBIENT_AND_DIFFUSE};
        // Back alone is left out: the reference takes green and blue of a back material that varies from the
        // front.
        gl.ColorMaterial(dice.one_of<GLenum>({GL_FRONT, GL_FRONT_AND_BACK}), modes[dice.pick(5)]);
        gl.Enable(GL_COLOR_MATERIAL);
    }
}

void random_normal(const Gl& gl, Dice& dice, bool unit) {
    std::array<float, 3> n = dice.numbers<3>(-1, 1);
    if (unit) {
        const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (float& v : n) v /= length;
    }
    gl.Normal3fv(n.data());
}

// Small triangles all over the window; `before_vertex` sets the attributes of each vertex.
template <typename Function>
void triangles(const Gl& gl, Dice& dice, Function before_vertex) {
    gl.ShadeModel(GL_FLAT);
    gl.Begin(GL_TRIANGLES);
    for (int i = 0; i < kTriangles; ++i) {
        const std::array<float, 3> center = dice.numbers<3>(-2, 2);
        for (int v = 0; v < 3; ++v) {
            before_vertex();
            const std::array<float, 3> offset = dice.numbers<3>(-0.5f, 0.5f);
            gl.Vertex3f(center[0] + offset[0], center[1] + offset[1], center[2] + offset[2]);
        }
    }
    gl.End();
}

void lit_triangles(const Gl& gl, Dice& dice) {
    choose_view(gl, dice);
    choose_lighting(gl, dice);
    const bool unit = dice.chance(), colored = dice.chance();
    gl.Color4fv(dice.numbers<4>(0, 1).data());
    triangles(gl, dice, [&] {
        random_normal(gl, dice, unit);
        if (colored) gl.Color4fv(dice.numbers<4>(0, 1).data());
    });
}

// glMaterial between Begin and End belongs to the vertices that follow it.
void material_per_vertex(const Gl& gl, Dice& dice) {
    choose_view(gl, dice);
    choose_lighting(gl, dice);
    // Not 0: the reference lights vertices ahead of the first glMaterial of a shininess by another formula
    // then.
    gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, dice.number(1, 60));
    triangles(gl, dice, [&] {
        random_normal(gl, dice, true);
        gl.Color4fv(dice.numbers<4>(0, 1).data());
        if (dice.chance()) return;
        const GLenum names[] = {GL_EMISSION, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_AMBIENT_AND_DIFFUSE};
        const GLenum name = names[dice.pick(5)];
        // Of back materials the reference does only these two right (see choose_lighting).
        const GLenum face = name == GL_EMISSION ? dice.one_of<GLenum>({GL_FRONT, GL_BACK, GL_FRONT_AND_BACK})
                                                : GLenum{GL_FRONT};
        if (dice.pick(4) == 0)
            gl.Materialf(dice.one_of<GLenum>({GL_FRONT, GL_BACK}), GL_SHININESS, dice.number(0, 60));
        else
            gl.Materialfv(face, name, dice.numbers<4>(0, 1).data());
    });
}

// Every integer form of glColor and glNormal.
void integer_forms(const Gl& gl, Dice& dice) {
    choose_view(gl, dice);
    if (dice.chance()) {
        choose_lighting(gl, dice);
        gl.Enable(GL_COLOR_MATERIAL);
    }
    const auto bits = [&] {
        return static_cast<int>(static_cast<unsigned>(dice.pick(1 << 16)) << 16 |
                                static_cast<unsigned>(dice.pick(1 << 16)));
    };
    const int form = dice.pick(6);
    triangles(gl, dice, [&] {
        const int r = bits(), g = bits(), b = bits(), a = bits();
        const auto call = [&]<typename Number>(auto* color, auto* normal, Number) {
            color(static_cast<Number>(r), static_cast<Number>(g), static_cast<Number>(b),
                  static_cast<Number>(a));
            using Signed = std::make_signed_t<Number>;
            normal(static_cast<Signed>(b), static_cast<Signed>(a), static_cast<Signed>(r));
        };
        switch (form) {
            case 0:
                return call(gl.Color4b, gl.Normal3b, GLbyte{});
            case 1:
                return call(gl.Color4ub, gl.Normal3b, GLubyte{});
            case 2:
                return call(gl.Color4s, gl.Normal3s, GLshort{});
            case 3:
                return call(gl.Color4us, gl.Normal3s, GLushort{});
            case 4:
                return call(gl.Color4i, gl.Normal3i, GLint{});
            default:
                return call(gl.Color4ui, gl.Normal3i, GLuint{});
        }
    });
}

// Arrays of colours and normals of every type.
void arrays(const Gl& gl, Dice& dice) {
    choose_view(gl, dice);
    if (dice.chance()) {
        choose_lighting(gl, dice);
        gl.Enable(GL_COLOR_MATERIAL);
    }
    constexpr int kVertices = 3 * kTriangles;
    std::vector<float> positions(3 * kVertices);
    for (std::size_t i = 0; i < positions.size(); i += 9) {
        const std::array<float, 3> center = dice.numbers<3>(-2, 2);
        for (std::size_t c = 0; c < 9; ++c) positions[i + c] = center[c % 3] + dice.number(-0.5f, 0.5f);
    }
    struct Form {
        GLenum color, normal;
    };
    const Form forms[] = {{GL_BYTE, GL_BYTE},
                          {GL_UNSIGNED_BYTE, GL_BYTE},
                          {GL_SHORT, GL_SHORT},
                          {GL_UNSIGNED_SHORT, GL_SHORT},
                          {GL_INT, GL_INT},
                          {GL_UNSIGNED_INT, GL_INT},
                          {GL_FLOAT, GL_FLOAT},
                          {GL_DOUBLE, GL_DOUBLE},
                          {GL_UNSIGNED_BYTE, GL_FLOAT},
                          {GL_UNSIGNED_SHORT, GL_FLOAT},
                          {GL_UNSIGNED_INT, GL_FLOAT}};
    const Form form = forms[dice.pick(11)];
    // 32 bytes a vertex: four components of the largest type.
    const auto fill = [&](GLenum type) {
        std::vector<unsigned char> bytes(32 * kVertices);
        for (std::size_t i = 0; i < bytes.size(); i += 4) {
            const float real = dice.number(-0.2f, 1.1f);
            const double wide = dice.number(-0.2f, 1.1f) / 3.0;
            const int bits = dice.pick(1 << 16) * 65537 ^ dice.pick(1 << 30);
            if (type == GL_FLOAT)
                std::memcpy(bytes.data() + i, &real, 4);
            else if (type == GL_DOUBLE && i % 8 == 0)
                std::memcpy(bytes.data() + i, &wide, 8);
            else if (type != GL_DOUBLE)
                std::memcpy(bytes.data() + i, &bits, 4);
        }
        return bytes;
    };
    const auto colors = fill(form.color), normals = fill(form.normal);
    gl.ShadeModel(GL_FLAT);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.EnableClientState(GL_COLOR_ARRAY);
    gl.EnableClientState(GL_NORMAL_ARRAY);
    gl.VertexPointer(3, GL_FLOAT, 0, positions.data());
    gl.ColorPointer(3 + dice.pick(2), form.color, 32, colors.data());
    gl.NormalPointer(form.normal, 32, normals.data());
    // The reference's draws take signed integers by a later version's rule (doc/reference.md §2.1).
    if (form.normal == GL_FLOAT || form.normal == GL_DOUBLE) return gl.DrawArrays(GL_TRIANGLES, 0, kVertices);
    gl.Begin(GL_TRIANGLES);
    for (int i = 0; i < kVertices; ++i) gl.ArrayElement(i);
    gl.End();
}

}  // namespace

std::vector<Trial> lighting_trials() {
    return {
        {"lit_triangles", lit_triangles, 120, {}},
        {"material_per_vertex", material_per_vertex, 12, {}},
        {"integer_forms", integer_forms, 24, {}},
        {"arrays", arrays, 24, {}},
    };
}

}  // namespace terrazzo::test
