// Chapter: the current raster position (GL 1.5 §2.13).
#include <cmath>

#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

// What can be asked about the position; `color_tolerance` in units of the colour.
void note_position(const Gl& gl, Notes& notes, const std::string& name, double color_tolerance = 0) {
    GLboolean valid = GL_FALSE;
    gl.GetBooleanv(GL_CURRENT_RASTER_POSITION_VALID, &valid);
    notes.value(name + " valid", valid);
    GLfloat v[4];
    gl.GetFloatv(GL_CURRENT_RASTER_POSITION, v);
    notes.values(name + " position", v);
    gl.GetFloatv(GL_CURRENT_RASTER_DISTANCE, v);
    notes.value(name + " distance", v[0]);
    gl.GetFloatv(GL_CURRENT_RASTER_COLOR, v);
    notes.values(name + " color", v, color_tolerance);
    gl.GetFloatv(GL_CURRENT_RASTER_TEXTURE_COORDS, v);
    notes.values(name + " texture coordinates", v);
}

void random_transform(const Gl& gl, Random& random) {
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    if (random.bits() & 1) {
        gl.Frustum(-1, 1.1, -0.9, 1, 1, 30);
    } else {
        gl.Ortho(-3, 4, -3, 3, -20, 20);
    }
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadIdentity();
    InOrder{gl.Translatef, random(-1, 1), random(-1, 1), random(-9, -3)};
    InOrder{gl.Rotatef, random(-180, 180), random(-1, 1), random(-1, 1), 1};
    InOrder{gl.Scalef, random(0.5F, 2), random(0.5F, 2), 1};
}

}  // namespace

SCENE(raster_position_transform, "positions through random matrices, viewports, depth ranges and clip planes",
      .draws_nothing_visible = true) {
    note_position(gl, notes, "initial");
    Random random(7);
    for (int i = 0; i < 40; ++i) {
        random_transform(gl, random);
        InOrder{gl.Viewport, static_cast<GLint>(random(-20, 20)), 3, static_cast<GLsizei>(random(50, 300)),
                177};
        InOrder{gl.DepthRange, static_cast<double>(random(0, 1)), static_cast<double>(random(0, 1))};
        const GLdouble plane[4] = {1, 0.5, 0, 0.7};
        if (i % 3 == 0) gl.ClipPlane(GL_CLIP_PLANE2, plane);
        if (i % 5 == 0) {
            gl.Enable(GL_CLIP_PLANE2);
        } else {
            gl.Disable(GL_CLIP_PLANE2);
        }
        InOrder{gl.Color4f, random(0, 1), random(0, 1), random(0, 1), random(0, 1)};
        InOrder{gl.RasterPos4f, random(-1.5F, 1.5F), random(-1.5F, 1.5F), random(-1.5F, 1.5F),
                random(0.8F, 1.2F)};
        note_position(gl, notes, std::to_string(i));
    }
}

SCENE(raster_position_texture_coordinates, "the texture matrix and generated coordinates",
      .draws_nothing_visible = true) {
    Random random(3);
    constexpr GLenum kModes[] = {GL_OBJECT_LINEAR, GL_EYE_LINEAR};
    for (int i = 0; i < 20; ++i) {
        random_transform(gl, random);
        const GLfloat plane[4] = {random(-1, 1), random(-1, 1), random(-1, 1), random(-1, 1)};
        gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, static_cast<GLint>(kModes[i % 2]));
        gl.TexGenfv(GL_S, i % 2 ? GL_EYE_PLANE : GL_OBJECT_PLANE, plane);
        if (i % 3) {
            gl.Enable(GL_TEXTURE_GEN_S);
        } else {
            gl.Disable(GL_TEXTURE_GEN_S);
        }
        gl.MatrixMode(GL_TEXTURE);
        gl.LoadIdentity();
        if (i % 4 == 0) gl.Rotatef(random(0, 90), 1, 2, 3);
        InOrder{gl.TexCoord4f, random(-1, 1), random(-1, 1), random(-1, 1), random(0.5F, 1)};
        InOrder{gl.RasterPos3f, random(-1, 1), random(-1, 1), random(-1, 1)};
        note_position(gl, notes, std::to_string(i));
    }
}

// The reference may leave the normal in object coordinates here, so those are the eye's but for a
// translation; tests/unit/raster_position_test.cpp turns and scales them.
SCENE(raster_position_reflections,
      "coordinates generated from the normal: spheres, reflections, the normal itself",
      .draws_nothing_visible = true) {
    Random random(11);
    constexpr GLenum kModes[] = {GL_SPHERE_MAP, GL_REFLECTION_MAP, GL_NORMAL_MAP};
    constexpr GLenum kCoordinates[] = {GL_S, GL_T, GL_R};
    for (int i = 0; i < 30; ++i) {
        random_transform(gl, random);
        gl.LoadIdentity();
        InOrder{gl.Translatef, random(-1, 1), random(-1, 1), random(-9, -3)};
        const GLenum mode = kModes[i % 3];
        for (const GLenum coordinate : kCoordinates) {
            const bool generated = coordinate != GL_R || mode != GL_SPHERE_MAP;  // a sphere has no R
            if (generated) gl.TexGeni(coordinate, GL_TEXTURE_GEN_MODE, static_cast<GLint>(mode));
            const auto set = generated ? gl.Enable : gl.Disable;
            set(GL_TEXTURE_GEN_S + coordinate - GL_S);
        }
        const GLfloat x = random(-0.7F, 0.7F), y = random(-0.7F, 0.7F);
        gl.Normal3f(x, y, std::sqrt(1 - x * x - y * y));
        gl.TexCoord4f(0.1F, 0.2F, 0.3F, 1);
        InOrder{gl.RasterPos3f, random(-1, 1), random(-1, 1), random(-1, 1)};
        note_position(gl, notes, std::to_string(i));
    }
}

// The reference lights the position with arithmetic of its own, whose powers are the C library's.
SCENE(raster_position_lit, "colours that lighting gives the position", .draws_nothing_visible = true) {
    constexpr double kStep = 1.0 / 255;
    Random random(5);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    for (int i = 0; i < 20; ++i) {
        gl.MatrixMode(GL_MODELVIEW);
        gl.LoadIdentity();
        const GLfloat direction[4] = {random(-1, 1), random(-1, 1), random(0, 1), 0};
        gl.Lightfv(GL_LIGHT0, GL_POSITION, direction);
        gl.Rotatef(random(-180, 180), 1, 2, 3);
        const Colour diffuse = hue(random(0, 1)), specular = hue(random(0, 1), 0.5F);
        gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, diffuse.data());
        gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular.data());
        gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, random(1, 40));
        gl.Normal3f(0.6F, 0, 0.8F);
        InOrder{gl.RasterPos3f, random(-0.5F, 0.5F), random(-0.5F, 0.5F), 0};
        note_position(gl, notes, std::to_string(i), kStep);
    }
}

SCENE(raster_position_window, "WindowPos, valid again after a clipped RasterPos; saved by GL_CURRENT_BIT",
      .draws_nothing_visible = true) {
    gl.Color4f(0.25F, 0.5F, 0.75F, 1);
    gl.TexCoord2f(0.3F, 0.4F);
    gl.RasterPos2f(3, 0);
    note_position(gl, notes, "clipped");
    gl.DepthRange(0.25, 0.5);
    gl.WindowPos3f(-10, 500.25F, 0.3F);
    note_position(gl, notes, "outside the window");
    gl.PushAttrib(GL_CURRENT_BIT);
    gl.WindowPos2i(7, 8);
    note_position(gl, notes, "integers");
    gl.PopAttrib();
    note_position(gl, notes, "popped");
    gl.WindowPos3d(1, 2, 3);
    note_position(gl, notes, "z above 1");
    const GLuint list = gl.GenLists(1);
    gl.NewList(list, GL_COMPILE);
    gl.Color3f(1, 0, 0);
    gl.RasterPos2f(0.5F, 0.25F);
    gl.WindowPos2s(30, 40);
    gl.EndList();
    note_position(gl, notes, "compiled");
    gl.CallList(list);
    note_position(gl, notes, "called");
}
