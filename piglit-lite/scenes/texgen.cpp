// Chapter: generated texture coordinates (GL 1.5 §2.11.4).
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

void begin(const Gl& gl) {
    camera(gl, 45, 4.4F);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_TEXTURE_2D);
    painted_texture(gl, 64, 64, GL_LINEAR, GL_LINEAR);
}

void generate(const Gl& gl, GLint mode) {
    for (const GLenum coordinate : {GL_S, GL_T}) gl.TexGeni(coordinate, GL_TEXTURE_GEN_MODE, mode);
    gl.Enable(GL_TEXTURE_GEN_S);
    gl.Enable(GL_TEXTURE_GEN_T);
}

}  // namespace

SCENE(texgen_object_linear, "planes in object space stick to the turning solid") {
    for_viewports(gl, 2, 2, [&](int cell) {
        begin(gl);
        generate(gl, GL_OBJECT_LINEAR);
        const GLfloat s[] = {0.6F, 0, 0.2F, 0.1F}, t[] = {0, 0.6F, 0, 0.5F};
        gl.TexGenfv(GL_S, GL_OBJECT_PLANE, s);
        gl.TexGenfv(GL_T, GL_OBJECT_PLANE, t);
        gl.Rotatef(static_cast<float>(cell) * 30 - 60, 1, 0.5F, 0);
        draw_solid(gl, make_torus(1.1F, 0.5F, 30, 15), kPositions);
    });
}

SCENE(texgen_eye_linear,
      "planes in eye space, given under a transformed modelview, stay while the solid turns") {
    for_viewports(gl, 2, 2, [&](int cell) {
        begin(gl);
        gl.PushMatrix();
        gl.Rotatef(20, 0, 0, 1);
        gl.Scalef(1.5F, 1, 1);
        generate(gl, GL_EYE_LINEAR);
        const GLfloat s[] = {0.5F, 0, 0, 0}, t[] = {0, 0.5F, 0.3F, 0.2F};
        gl.TexGenfv(GL_S, GL_EYE_PLANE, s);
        gl.TexGenfv(GL_T, GL_EYE_PLANE, t);
        gl.PopMatrix();
        gl.Rotatef(static_cast<float>(cell) * 30 - 60, 1, 0.5F, 0);
        draw_solid(gl, make_torus(1.1F, 0.5F, 30, 15), kPositions);
        GLfloat plane[4];
        gl.GetTexGenfv(GL_T, GL_EYE_PLANE, plane);
        notes.values("eye plane " + std::to_string(cell), plane, 1e-5);
    });
}

SCENE(texgen_sphere_map, "sphere mapping on a sphere and a torus, with and without NORMALIZE") {
    for_viewports(gl, 2, 2, [&](int cell) {
        begin(gl);
        generate(gl, GL_SPHERE_MAP);
        if (cell & 1)
            gl.Enable(GL_NORMALIZE);
        else
            gl.Disable(GL_NORMALIZE);
        gl.Rotatef(-40, 1, 0.4F, 0);
        gl.Scalef(1.1F, 1.1F, 1.1F);
        if (cell & 2)
            draw_solid(gl, make_torus(1, 0.5F, 30, 16), kNormals);
        else
            draw_solid(gl, make_sphere(1.4F, 18, 28), kNormals);
    });
}

SCENE(texgen_mixed_and_projective,
      "one coordinate generated and one given; R and Q planes project the image") {
    for_viewports(gl, 2, 2, [&](int cell) {
        begin(gl);
        const GLfloat s[] = {0.4F, 0.1F, 0, 0.4F}, t[] = {0, 0.4F, 0.1F, 0.4F}, q[] = {0.1F, 0.05F, 0.3F, 1};
        gl.TexGenfv(GL_S, GL_OBJECT_PLANE, s);
        gl.TexGenfv(GL_T, GL_OBJECT_PLANE, t);
        gl.TexGenfv(GL_Q, GL_OBJECT_PLANE, q);
        const GLdouble r[] = {0, 0, 1, 0};
        gl.TexGendv(GL_R, GL_OBJECT_PLANE, r);
        for (const GLenum coordinate : {GL_S, GL_T, GL_R, GL_Q})
            gl.TexGenf(coordinate, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
        gl.Disable(GL_TEXTURE_GEN_S);
        gl.Disable(GL_TEXTURE_GEN_T);
        gl.Disable(GL_TEXTURE_GEN_Q);
        if (cell != 1) gl.Enable(GL_TEXTURE_GEN_S);
        if (cell != 2) gl.Enable(GL_TEXTURE_GEN_T);
        if (cell == 3) gl.Enable(GL_TEXTURE_GEN_Q), gl.Enable(GL_TEXTURE_GEN_R);
        gl.Rotatef(-35, 1, 0.5F, 0);
        draw_solid(gl, make_torus(1.1F, 0.5F, 30, 15), kTextures);
        gl.Disable(GL_TEXTURE_GEN_R);
    });
    GLint mode = 0;
    gl.GetTexGeniv(GL_R, GL_TEXTURE_GEN_MODE, &mode);
    notes.value("mode of R", mode);
}

SCENE(texgen_with_texture_matrix,
      "a texture matrix turns generated coordinates; one dimension by contour lines") {
    camera(gl, 45, 4.4F);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_TEXTURE_1D);
    gl.TexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    GLubyte contours[32][3];
    for (int i = 0; i < 32; ++i) {
        const Colour colour = hue(static_cast<float>(i) / 32);
        for (int c = 0; c < 3; ++c)
            contours[i][c] = static_cast<GLubyte>(i % 4 ? 255 * colour[static_cast<std::size_t>(c)] : 0);
    }
    gl.TexImage1D(GL_TEXTURE_1D, 0, GL_RGB, 32, 0, GL_RGB, GL_UNSIGNED_BYTE, contours);
    gl.Enable(GL_TEXTURE_GEN_S);
    gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    const GLint plane[] = {1, 0, 1, 0};
    gl.TexGeniv(GL_S, GL_OBJECT_PLANE, plane);
    gl.MatrixMode(GL_TEXTURE);
    gl.Scalef(0.45F, 1, 1);
    gl.Translatef(0.3F, 0, 0);
    gl.MatrixMode(GL_MODELVIEW);
    gl.Rotatef(-40, 1, 0.3F, 0);
    draw_solid(gl, make_torus(1.2F, 0.5F, 40, 20), kPositions);
}
