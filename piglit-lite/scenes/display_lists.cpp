// Chapter: display lists (GL 1.5 §5.4).
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

void petal(const Gl& gl) {
    gl.Begin(GL_TRIANGLE_FAN);
    gl.Color3f(1, 1, 0.8F);
    gl.Vertex2f(0, 0);
    for (int i = 0; i <= 8; ++i) {
        const float t = static_cast<float>(i) / 8;
        gl.Color4fv(hue(t).data());
        gl.Vertex2f(10 + 30 * t, 14 * (t - 0.5F));
    }
    gl.End();
}

}  // namespace

SCENE(list_geometry, "one compiled flower called under many matrices") {
    pixel_projection(gl);
    const GLuint list = gl.GenLists(1);
    gl.NewList(list, GL_COMPILE);
    petal(gl);
    gl.EndList();
    for (int i = 0; i < 36; ++i) {
        gl.PushMatrix();
        gl.Translatef(static_cast<float>(i % 6) * 42 + 23, static_cast<float>(i / 6) * 42 + 23, 0);
        gl.Scalef(0.5F, 0.5F, 1);
        for (int k = 0; k < 5; ++k) {
            gl.Rotatef(72 + static_cast<float>(i), 0, 0, 1);
            gl.CallList(list);
        }
        gl.PopMatrix();
    }
    notes.value("is a list", gl.IsList(list));
    gl.DeleteLists(list, 1);
    notes.value("is a list after deletion", gl.IsList(list));
    gl.CallList(list);  // an undefined list is ignored
}

SCENE(list_compile_and_execute, "COMPILE_AND_EXECUTE draws at once and again when called") {
    pixel_projection(gl);
    gl.Translatef(64, 64, 0);
    gl.NewList(7, GL_COMPILE_AND_EXECUTE);
    for (int i = 0; i < 5; ++i) {
        gl.Rotatef(72, 0, 0, 1);
        petal(gl);
    }
    GLint index = 0, mode = 0;
    gl.GetIntegerv(GL_LIST_INDEX, &index);
    gl.GetIntegerv(GL_LIST_MODE, &mode);
    notes.value("index while compiling", index);
    notes.value("mode while compiling", mode);
    gl.EndList();
    gl.LoadIdentity();
    gl.Translatef(180, 180, 0);
    gl.Scalef(1.6F, 1.6F, 1);
    gl.CallList(7);
}

SCENE(list_nested, "lists calling lists, redefined between calls, eight deep") {
    pixel_projection(gl);
    const GLuint base = gl.GenLists(10);
    for (GLuint i = 0; i < 9; ++i) {
        gl.NewList(base + i, GL_COMPILE);
        gl.Color4fv(hue(static_cast<float>(i) / 9).data());
        gl.Rectf(0, 0, 60, 60);
        gl.PushMatrix();
        gl.Translatef(30, 25, 0);
        gl.Rotatef(13, 0, 0, 1);
        gl.Scalef(0.85F, 0.85F, 1);
        gl.CallList(base + i + 1);  // the last one does not exist yet
        gl.PopMatrix();
        gl.EndList();
    }
    gl.PushMatrix();
    gl.Translatef(10, 10, 0);
    gl.CallList(base);
    gl.PopMatrix();
    gl.NewList(base + 9, GL_COMPILE);  // now it does, and the chain is longer
    gl.Color3f(1, 1, 1);
    gl.Rectf(-20, -20, 40, 40);
    gl.EndList();
    gl.Translatef(10, 130, 0);
    gl.CallList(base);
}

SCENE(list_call_lists_types, "CallLists with all ten types and a list base, as a font") {
    pixel_projection(gl);
    const GLuint base = gl.GenLists(8);
    for (GLuint i = 0; i < 8; ++i) {
        gl.NewList(base + i, GL_COMPILE);
        gl.Color4fv(hue(static_cast<float>(i) / 8).data());
        gl.Rectf(0, 0, 10 + static_cast<float>(i), 4 + 2 * static_cast<float>(i));
        gl.Translatef(24, 0, 0);
        gl.EndList();
    }
    gl.ListBase(base);
    const GLbyte b[] = {0, 1, 2, 3, 4, 5, 6, 7};
    const GLubyte ub[] = {7, 6, 5, 4, 3, 2, 1, 0};
    const GLshort s[] = {0, 2, 4, 6, 1, 3, 5, 7};
    const GLushort us[] = {1, 1, 2, 2, 3, 3, 4, 4};
    const GLint n[] = {7, 0, 6, 1, 5, 2, 4, 3};
    const GLuint un[] = {3, 4, 2, 5, 1, 6, 0, 7};
    const GLfloat f[] = {0.2F, 1.9F, 2.5F, 3, 4, 5, 6, 7};
    const GLubyte two[] = {0, 0, 0, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6, 0, 7};
    const GLubyte three[] = {0, 0, 7, 0, 0, 6, 0, 0, 5, 0, 0, 4, 0, 0, 3, 0, 0, 2, 0, 0, 1, 0, 0, 0};
    const GLubyte four[] = {0, 0, 0, 5, 0, 0, 0, 4, 0, 0, 0, 3, 0, 0, 0, 5,
                            0, 0, 0, 4, 0, 0, 0, 3, 0, 0, 0, 2, 0, 0, 0, 1};
    const struct {
        GLenum type;
        const void* names;
    } rows[] = {{GL_BYTE, b},        {GL_UNSIGNED_BYTE, ub}, {GL_SHORT, s}, {GL_UNSIGNED_SHORT, us},
                {GL_INT, n},         {GL_UNSIGNED_INT, un},  {GL_FLOAT, f}, {GL_2_BYTES, two},
                {GL_3_BYTES, three}, {GL_4_BYTES, four}};
    float y = 8;
    for (const auto& row : rows) {
        gl.PushMatrix();
        gl.Translatef(20, y, 0);
        gl.CallLists(8, row.type, row.names);
        gl.PopMatrix();
        y += 24;
    }
}

SCENE(list_state_commands,
      "state set in lists: enables, blending, matrices, lights, materials, textures, stipples, fog") {
    const GLuint base = gl.GenLists(4);
    const GLuint texture = painted_texture(gl, 32, 32, GL_LINEAR, GL_LINEAR);
    const GLfloat red[] = {0.9F, 0.3F, 0.2F, 1}, light[] = {1, 1, 1, 0}, white[] = {1, 1, 1, 1},
                  fog[] = {0.2F, 0.3F, 0.5F, 1};
    gl.NewList(base, GL_COMPILE);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_LEQUAL);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.Lightfv(GL_LIGHT0, GL_POSITION, light);
    gl.Materialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, red);
    gl.Materialfv(GL_FRONT, GL_SPECULAR, white);
    gl.Materialf(GL_FRONT, GL_SHININESS, 20);
    gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
    gl.ShadeModel(GL_FLAT);
    gl.EndList();
    gl.NewList(base + 1, GL_COMPILE);
    gl.Enable(GL_TEXTURE_2D);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.Enable(GL_FOG);
    gl.Fogfv(GL_FOG_COLOR, fog);
    gl.Fogi(GL_FOG_MODE, GL_LINEAR);
    gl.Fogf(GL_FOG_START, 3);
    gl.Fogf(GL_FOG_END, 7);
    gl.EndList();
    gl.NewList(base + 2, GL_COMPILE);
    gl.PushAttrib(GL_ENABLE_BIT | GL_COLOR_BUFFER_BIT | GL_LINE_BIT);
    gl.Disable(GL_LIGHTING);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ONE);
    gl.Enable(GL_LINE_STIPPLE);
    gl.LineStipple(2, 0x0F3C);
    gl.LineWidth(3);
    gl.Begin(GL_LINES);
    for (int i = 0; i < 10; ++i) {
        gl.Color4fv(hue(static_cast<float>(i) / 10).data());
        gl.Vertex3f(-2, -2 + 0.4F * static_cast<float>(i), 0);
        gl.Vertex3f(2, -1.6F + 0.4F * static_cast<float>(i), 0);
    }
    gl.End();
    gl.PopAttrib();
    gl.EndList();
    gl.NewList(base + 3, GL_COMPILE);
    gl.MatrixMode(GL_MODELVIEW);
    gl.PushMatrix();
    gl.Rotatef(-50, 1, 0.4F, 0);
    gl.Scalef(1.2F, 1.2F, 1);
    gl.EndList();
    camera(gl, 45, 5);
    gl.CallList(base);
    gl.CallList(base + 1);
    gl.CallList(base + 3);
    draw_solid(gl, make_torus(1, 0.45F, 20, 12), kNormals | kTextures);
    gl.PopMatrix();
    gl.CallList(base + 2);
}

SCENE(list_arrays_inside, "array draws in a list take the arrays' values at compile time") {
    pixel_projection(gl);
    float positions[12][2], colours[12][3];
    const auto fill = [&](float turn) {
        for (int i = 0; i < 12; ++i) {
            const Colour colour = hue(turn + static_cast<float>(i) / 12);
            positions[i][0] = 20 + static_cast<float>(i) * 9;
            positions[i][1] = i % 2 ? 90.0F : 20.0F;
            for (std::size_t c = 0; c < 3; ++c) colours[i][c] = colour[c];
        }
    };
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.EnableClientState(GL_COLOR_ARRAY);
    gl.VertexPointer(2, GL_FLOAT, 0, positions);
    gl.ColorPointer(3, GL_FLOAT, 0, colours);
    const GLubyte order[] = {0, 1, 2, 4, 5, 6, 8, 9, 10};
    fill(0);
    gl.NewList(1, GL_COMPILE);
    gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 12);
    gl.Translatef(0, 110, 0);
    gl.DrawElements(GL_TRIANGLES, 9, GL_UNSIGNED_BYTE, order);
    gl.Translatef(115, 0, 0);
    gl.Begin(GL_TRIANGLES);
    for (int i = 0; i < 9; ++i) gl.ArrayElement(i);
    gl.End();
    gl.EndList();
    fill(0.5F);  // must not show
    gl.CallList(1);
}

SCENE(list_textures_inside, "TexImage and TexSubImage in lists keep a copy of the client's pixels") {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_2D);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    auto texels = painted_texels(16, 16);
    gl.NewList(1, GL_COMPILE);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    gl.EndList();
    gl.NewList(2, GL_COMPILE);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 8, 8, GL_RGB, GL_UNSIGNED_BYTE, texels.data() + 100);
    gl.EndList();
    std::fill(texels.begin(), texels.end(), std::uint8_t{99});
    gl.CallList(1);
    textured_rectangle(gl, 8, 8, 124, 248);
    gl.CallList(2);
    textured_rectangle(gl, 132, 8, 248, 248);
}

SCENE(list_material_and_colour_in_primitives,
      "Begin in the caller, vertices in the list, materials between them") {
    camera(gl, 45, 4);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    for (GLuint i = 1; i <= 6; ++i) {
        gl.NewList(i, GL_COMPILE);
        gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, hue(static_cast<float>(i) / 6).data());
        gl.Normal3f(0.3F, 0.1F * static_cast<float>(i), 0.8F);
        const float x = -1.5F + 0.5F * static_cast<float>(i);
        gl.Vertex3f(x, -1, 0);
        gl.Vertex3f(x - 0.2F, 1, 0);
        gl.EndList();
    }
    gl.Begin(GL_QUAD_STRIP);
    for (GLuint i = 1; i <= 6; ++i) gl.CallList(i);
    gl.End();
}

SCENE(list_current_values_after,
      "current colour, normal, texture coordinate and matrix after a list has run") {
    pixel_projection(gl);
    gl.NewList(1, GL_COMPILE);
    gl.Color4f(0.2F, 0.4F, 0.6F, 0.8F);
    gl.Normal3f(0, 1, 0);
    gl.TexCoord2f(3, 4);
    gl.Translatef(5, 6, 0);
    gl.PolygonMode(GL_FRONT, GL_LINE);
    gl.LineWidth(4);
    gl.EndList();
    GLfloat value[16];
    gl.GetFloatv(GL_CURRENT_COLOR, value);
    notes.value("colour before the call", value[0]);
    gl.CallList(1);
    gl.GetFloatv(GL_CURRENT_COLOR, value);
    notes.value("colour after", value[0], 1e-6);
    gl.GetFloatv(GL_CURRENT_NORMAL, value);
    notes.value("normal after", value[1]);
    gl.GetFloatv(GL_CURRENT_TEXTURE_COORDS, value);
    notes.value("texture coordinate after", value[1]);
    gl.GetFloatv(GL_MODELVIEW_MATRIX, value);
    notes.values("matrix after", value, 1e-6);
    rectangle(gl, 40, 40, 200, 200);
}

SCENE(list_large, "a list of ten thousand triangles with every attribute, called twice") {
    camera(gl, 50, 4);
    gl.Enable(GL_DEPTH_TEST);
    const Solid torus = make_torus(1, 0.4F, 100, 50);
    gl.NewList(1, GL_COMPILE);
    gl.Begin(GL_TRIANGLES);
    for (const std::uint16_t index : torus.indices) {
        const SolidVertex& v = torus.vertices[index];
        gl.Color4fv(v.colour);
        gl.Normal3fv(v.normal);
        gl.TexCoord2fv(v.texture);
        gl.Vertex3fv(v.position);
    }
    gl.End();
    gl.EndList();
    for (int i = 0; i < 2; ++i) {
        gl.PushMatrix();
        gl.Translatef(i ? 0.5F : -0.5F, 0, 0);
        gl.Rotatef(i ? 70.0F : -30.0F, 1, 0.3F, 0);
        gl.CallList(1);
        gl.PopMatrix();
    }
}
