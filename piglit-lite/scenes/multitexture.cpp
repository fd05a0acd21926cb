// Chapter: texture units (GL 1.5 §2.7, §2.8, §3.8.15, §6.1.2): coordinates, bindings, environments,
// generation and matrices of each.
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

void select_unit(const Gl& gl, int unit) {
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl.ClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
}

// Units 0 to count - 1, each with a picture of its own.
void enable_units(const Gl& gl, int count, GLint mode = GL_MODULATE, GLenum filter = GL_LINEAR) {
    for (int unit = count - 1; unit >= 0; --unit) {
        select_unit(gl, unit);
        gl.Enable(GL_TEXTURE_2D);
        painted_texture(gl, 16 << unit % 3, 32 >> unit % 2, filter, filter,
                        static_cast<std::uint32_t>(unit) + 1);
        gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, mode);
    }
}

// A quad with coordinates of `units` units that differ from one another.
void corner(const Gl& gl, int units, float s, float t, float x, float y) {
    for (int unit = 0; unit < units; ++unit) {
        const float k = 1 + 0.25F * static_cast<float>(unit);
        gl.MultiTexCoord2f(GL_TEXTURE0 + static_cast<GLenum>(unit), s * k,
                           t * k + 0.1F * static_cast<float>(unit));
    }
    gl.Vertex2f(x, y);
}
void quad(const Gl& gl, int units, float x0, float y0, float x1, float y1) {
    gl.Begin(GL_QUADS);
    corner(gl, units, 0, 0, x0, y0);
    corner(gl, units, 1, 0, x1, y0);
    corner(gl, units, 1, 1, x1, y1);
    corner(gl, units, 0, 1, x0, y1);
    gl.End();
}

}  // namespace

SCENE(multitexture_modulate, "one to eight units that modulate") {
    pixel_projection(gl);
    for_cells(3, 3, [&](int cell, float x, float y, float w, float h) {
        enable_units(gl, cell % 8 + 1, GL_MODULATE, cell == 8 ? GL_NEAREST : GL_LINEAR);
        gl.Color4fv(hue(static_cast<float>(cell) / 9).data());
        quad(gl, 8, x + 3, y + 3, x + w - 3, y + h - 3);
    });
}

SCENE(multitexture_environments, "every pair of environments on two units") {
    pixel_projection(gl);
    const GLint modes[] = {GL_MODULATE, GL_REPLACE, GL_DECAL, GL_BLEND, GL_ADD};
    enable_units(gl, 2);
    const GLfloat constants[2][4] = {{0.9F, 0.6F, 0.1F, 0.5F}, {0.1F, 0.2F, 0.9F, 0.7F}};
    for_cells(5, 5, [&](int cell, float x, float y, float w, float h) {
        for (int unit = 0; unit < 2; ++unit) {
            select_unit(gl, unit);
            gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, modes[unit ? cell / 5 : cell % 5]);
            gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, constants[unit]);
        }
        gl.Color4fv(hue(static_cast<float>(cell) / 25, 1, 0.8F).data());
        quad(gl, 2, x + 2, y + 2, x + w - 2, y + h - 2);
    });
}

SCENE(multitexture_gaps,
      "units that are enabled with gaps between them, and one whose texture is incomplete") {
    pixel_projection(gl);
    enable_units(gl, 8);
    for_cells(4, 2, [&](int cell, float x, float y, float w, float h) {
        constexpr unsigned kEnabled[] = {0x01, 0x02, 0x80, 0x81, 0x42, 0x2a, 0x55, 0xff};
        for (int unit = 0; unit < 8; ++unit) {
            select_unit(gl, unit);
            (kEnabled[cell] >> unit & 1 ? gl.Enable : gl.Disable)(GL_TEXTURE_2D);
            if (unit == 3)
                gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                                 cell == 7 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
        }
        gl.Color4fv(hue(static_cast<float>(cell) / 8).data());
        quad(gl, 8, x + 3, y + 3, x + w - 3, y + h - 3);
    });
}

SCENE(multitexture_perspective,
      "two mip-mapped units on a floor in perspective, blended, clipped and fogged") {
    camera(gl, 70, 1);
    gl.Enable(GL_DEPTH_TEST);
    for (int unit = 0; unit < 2; ++unit) {
        select_unit(gl, unit);
        gl.Enable(GL_TEXTURE_2D);
        painted_texture(gl, 64, 64, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, static_cast<std::uint32_t>(unit) + 3);
        for (int level = 1; level < 7; ++level) {
            const int size = 64 >> level;
            const auto texels = painted_texels(size, size, static_cast<std::uint32_t>(level));
            gl.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA8, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                          texels.data());
        }
    }
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
    gl.Enable(GL_FOG);
    gl.Fogi(GL_FOG_MODE, GL_LINEAR);
    gl.Fogf(GL_FOG_END, 12);
    gl.Begin(GL_QUADS);
    const float corners[4][2] = {{-8, -30}, {8, -30}, {8, 2}, {-8, 2}};
    for (const auto& c : corners) {
        gl.Color4f(1, c[0] * 0.05F + 0.5F, 0.6F, 1);
        gl.MultiTexCoord2f(GL_TEXTURE0, c[0], c[1]);
        gl.MultiTexCoord2f(GL_TEXTURE1, c[1] * 0.3F, c[0] * 0.3F);
        gl.Vertex3f(c[0], -1, c[1]);
    }
    gl.End();
}

SCENE(multitexture_arrays, "coordinate arrays of several units, in client memory, by element and in a list") {
    pixel_projection(gl);
    enable_units(gl, 3);
    const GLfloat positions[] = {0, 0, 58, 0, 58, 120, 0, 120};
    const GLshort first[] = {0, 0, 2, 0, 2, 2, 0, 2};
    const GLfloat second[] = {0, 0, 0, 1, 1, 0, 0, 1, 1.5F, 1.5F, 0, 1, 0, 1, 0, 1};
    const GLdouble third[] = {0, 0.2, 1, 0.2, 1, 0.9, 0, 0.9};
    select_unit(gl, 0);
    gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
    gl.TexCoordPointer(2, GL_SHORT, 0, first);
    select_unit(gl, 1);
    gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
    gl.TexCoordPointer(4, GL_FLOAT, 0, second);
    select_unit(gl, 2);
    gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
    gl.TexCoordPointer(2, GL_DOUBLE, 0, third);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.VertexPointer(2, GL_FLOAT, 0, positions);
    const GLubyte indices[] = {0, 1, 2, 3};
    gl.NewList(1, GL_COMPILE);
    gl.DrawArrays(GL_QUADS, 0, 4);
    gl.EndList();
    for_cells(4, 2, [&](int cell, float x, float y, float, float) {
        gl.LoadIdentity();
        gl.Translatef(x + 3, y + 3, 0);
        gl.Color4f(1, 1, static_cast<float>(cell) / 8, 1);
        // Arrays that are off leave the current coordinates.
        gl.MultiTexCoord4f(GL_TEXTURE1, 0.3F, 0.7F, 0, 1);
        switch (cell % 4) {
            case 0:
                return gl.DrawArrays(GL_QUADS, 0, 4);
            case 1:
                return gl.DrawElements(GL_QUADS, 4, GL_UNSIGNED_BYTE, indices);
            case 2:
                return gl.CallList(1);
        }
        gl.Begin(GL_QUADS);
        for (int i = 0; i < 4; ++i) gl.ArrayElement(i);
        gl.End();
        gl.ClientActiveTexture(GL_TEXTURE1);
        gl.DisableClientState(GL_TEXTURE_COORD_ARRAY);
    });
}

SCENE(multitexture_lists,
      "coordinates in display lists: batches, single calls, and what a list leaves current") {
    pixel_projection(gl);
    enable_units(gl, 2);
    gl.NewList(1, GL_COMPILE);
    quad(gl, 2, 2, 2, 60, 120);
    gl.MultiTexCoord2i(GL_TEXTURE1, 1, 1);
    gl.EndList();
    gl.NewList(2, GL_COMPILE);
    gl.MultiTexCoord4s(GL_TEXTURE1, 1, 2, 0, 2);
    gl.MultiTexCoord1d(GL_TEXTURE7, 0.5);
    gl.EndList();
    gl.NewList(3, GL_COMPILE_AND_EXECUTE);
    gl.MultiTexCoord2f(GL_TEXTURE1, 0, 0);
    gl.TexCoord2f(0, 0);
    gl.Begin(GL_TRIANGLES);
    gl.Vertex2f(66, 2);
    gl.MultiTexCoord2f(GL_TEXTURE1, 1, 0);
    gl.TexCoord2f(1, 0);
    gl.Vertex2f(120, 2);
    gl.MultiTexCoord2f(GL_TEXTURE0, 0, 1);
    gl.Vertex2f(66, 120);
    gl.End();
    gl.EndList();
    gl.CallList(1);
    gl.CallList(2);
    for (int unit : {0, 1, 7}) {
        gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        GLfloat coordinates[4];
        gl.GetFloatv(GL_CURRENT_TEXTURE_COORDS, coordinates);
        notes.values("unit " + std::to_string(unit), coordinates);
    }
    gl.Translatef(0, 126, 0);
    gl.CallList(3);
}

SCENE(multitexture_matrices, "texture matrices and coordinate generation of each unit") {
    pixel_projection(gl);
    enable_units(gl, 2);
    for_cells(3, 3, [&](int cell, float x, float y, float w, float h) {
        gl.MatrixMode(GL_TEXTURE);
        for (int unit = 0; unit < 2; ++unit) {
            select_unit(gl, unit);
            gl.LoadIdentity();
            gl.Rotatef(static_cast<float>(cell * 20 * (unit + 1)), 0, 0, 1);
            gl.Scalef(1, 1 + static_cast<float>(cell) * 0.2F, 1);
        }
        if (cell > 4) {
            const GLfloat plane[] = {0.02F, 0.01F, 0, 0};
            gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, cell % 2 ? GL_OBJECT_LINEAR : GL_EYE_LINEAR);
            gl.TexGenfv(GL_S, cell % 2 ? GL_OBJECT_PLANE : GL_EYE_PLANE, plane);
            gl.Enable(GL_TEXTURE_GEN_S);
        }
        gl.MatrixMode(GL_MODELVIEW);
        quad(gl, 2, x + 3, y + 3, x + w - 3, y + h - 3);
    });
    GLint depth = 0;
    gl.GetIntegerv(GL_TEXTURE_STACK_DEPTH, &depth);
    notes.value("depth", depth);
}

SCENE(multitexture_stacks, "PushAttrib and PushClientAttrib keep the state of every unit") {
    pixel_projection(gl);
    enable_units(gl, 3);
    gl.ActiveTexture(GL_TEXTURE2);
    gl.PushAttrib(GL_TEXTURE_BIT | GL_CURRENT_BIT);
    gl.PushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    for (int unit = 0; unit < 3; ++unit) {
        select_unit(gl, unit);
        gl.Disable(GL_TEXTURE_2D);
        gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        gl.BindTexture(GL_TEXTURE_2D, 0);
        gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
        gl.MultiTexCoord2f(GL_TEXTURE0 + static_cast<GLenum>(unit), 0.5F, 0.5F);
    }
    gl.PopClientAttrib();
    gl.PopAttrib();
    GLint active = 0, client = 0;
    gl.GetIntegerv(GL_ACTIVE_TEXTURE, &active);
    gl.GetIntegerv(GL_CLIENT_ACTIVE_TEXTURE, &client);
    notes.value("active", active);
    notes.value("client", client);
    notes.value("array", gl.IsEnabled(GL_TEXTURE_COORD_ARRAY));
    quad(gl, 3, 5, 5, 120, 250);
    gl.PushAttrib(GL_ENABLE_BIT);
    gl.Disable(GL_TEXTURE_2D);
    gl.PopAttrib();
    quad(gl, 3, 130, 5, 250, 250);
}

SCENE(multitexture_errors, "units that do not exist", .draws_nothing_visible = true) {
    gl.ActiveTexture(GL_TEXTURE);
    notes.value("ActiveTexture", gl.GetError());
    gl.ClientActiveTexture(GL_TEXTURE0 + 8);
    notes.value("ClientActiveTexture", gl.GetError());
    gl.Begin(GL_POINTS);
    gl.ActiveTexture(GL_TEXTURE1);
    gl.End();
    notes.value("inside", gl.GetError());
    GLint units = 0;
    gl.GetIntegerv(GL_MAX_TEXTURE_UNITS, &units);
    notes.value("units", units);
}
