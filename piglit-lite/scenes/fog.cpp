// Chapter: fog (GL 1.5 §3.10).
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

void row_of_solids(const Gl& gl, unsigned parts) {
    const Solid torus = make_torus(0.8F, 0.35F, 20, 10);
    for (int i = 0; i < 6; ++i) {
        gl.PushMatrix();
        gl.Translatef(-2.6F + 0.65F * static_cast<float>(i), 1.7F - 0.45F * static_cast<float>(i),
                      -2.2F * static_cast<float>(5 - i));
        gl.Rotatef(40, 1, 0.5F, 0);
        draw_solid(gl, torus, parts);
        gl.PopMatrix();
    }
}

void begin(const Gl& gl, float near_plane = 1) {
    camera(gl, 50, 4, near_plane, 40);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_FOG);
    const GLfloat colour[] = {0.7F, 0.75F, 0.8F, 1};
    gl.Fogfv(GL_FOG_COLOR, colour);
}

}  // namespace

SCENE(fog_linear, "linear fog with several starts and ends, also reversed") {
    for_viewports(gl, 2, 2, [&](int cell) {
        begin(gl);
        gl.Fogi(GL_FOG_MODE, GL_LINEAR);
        const float ranges[][2] = {{3, 12}, {0, 30}, {7, 8}, {14, 2}};
        gl.Fogf(GL_FOG_START, ranges[cell][0]);
        gl.Fogf(GL_FOG_END, ranges[cell][1]);
        row_of_solids(gl, kColours);
    });
}

SCENE(fog_exponential, "EXP and EXP2 with densities 0.02 to 0.5") {
    for_viewports(gl, 3, 2, [&](int cell) {
        begin(gl);
        gl.Fogi(GL_FOG_MODE, cell < 3 ? GL_EXP : GL_EXP2);
        const float densities[] = {0.02F, 0.12F, 0.5F};
        gl.Fogf(GL_FOG_DENSITY, densities[cell % 3]);
        row_of_solids(gl, kColours);
    });
}

SCENE(fog_parameters, "forms f, fv, i and iv of the parameters, and what they read back") {
    begin(gl);
    const GLint mode[] = {GL_EXP2}, colour[] = {2147483647, 1073741824, 0, 2147483647};
    const GLfloat density[] = {0.11F};
    gl.Fogiv(GL_FOG_MODE, mode);
    gl.Fogiv(GL_FOG_COLOR, colour);
    gl.Fogfv(GL_FOG_DENSITY, density);
    gl.Fogi(GL_FOG_START, 2);
    gl.Fogi(GL_FOG_INDEX, 3);
    row_of_solids(gl, kColours);
    GLfloat got[4];
    gl.GetFloatv(GL_FOG_COLOR, got);
    notes.values("colour", got, 1e-6);
    for (const GLenum parameter : {GL_FOG_MODE, GL_FOG_DENSITY, GL_FOG_START, GL_FOG_END, GL_FOG_INDEX}) {
        gl.GetFloatv(parameter, got);
        notes.value("parameter " + std::to_string(parameter), got[0], 1e-6);
    }
}

SCENE(fog_distances,
      "along the axis, signed or not, and from the eye, on lit and unlit vertices (NV_fog_distance)") {
    begin(gl);
    gl.Fogi(GL_FOG_MODE, GL_LINEAR);
    gl.Fogf(GL_FOG_START, 2);
    gl.Fogf(GL_FOG_END, 9);
    constexpr GLenum kModes[] = {GL_EYE_RADIAL_NV, GL_EYE_PLANE, GL_EYE_PLANE_ABSOLUTE_NV};
    const Solid torus = make_torus(0.8F, 0.35F, 20, 10);
    for_viewports(gl, 3, 2, [&](int cell) {
        gl.Fogi(GL_FOG_DISTANCE_MODE_NV, static_cast<GLint>(kModes[cell % 3]));
        GLint got = 0;
        gl.GetIntegerv(GL_FOG_DISTANCE_MODE_NV, &got);
        notes.value("mode", got);
        if (cell == 3) {
            gl.Enable(GL_LIGHTING);
            gl.Enable(GL_LIGHT0);
        }
        camera(gl, 100, 1, 0.5F, 40);
        gl.Color3f(0.9F, 0.5F, 0.1F);
        gl.Begin(GL_QUADS);
        for (int i = 0; i < 4; ++i) gl.Vertex3f(i == 0 || i == 3 ? -8.0F : 8.0F, -1, i < 2 ? 0.4F : -9.0F);
        gl.End();
        gl.Translatef(-2, 0.5F, -1.5F);
        draw_solid(gl, torus, kNormals);
    });
    gl.Fogi(GL_FOG_DISTANCE_MODE_NV, GL_FOG_COORDINATE);
    notes.value("no such mode", gl.GetError());
}

SCENE(fog_with_texture_and_blend, "fog after texturing, before blending; alpha passes through") {
    begin(gl);
    gl.Disable(GL_DEPTH_TEST);
    gl.Enable(GL_TEXTURE_2D);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    painted_texture(gl, 32, 32, GL_LINEAR, GL_LINEAR);
    gl.Fogi(GL_FOG_MODE, GL_LINEAR);
    gl.Fogf(GL_FOG_START, 3);
    gl.Fogf(GL_FOG_END, 14);
    gl.Color4f(1, 1, 1, 0.6F);
    row_of_solids(gl, kTextures);
}

SCENE(fog_hints_and_primitives, "fog on points and lines, per pixel or per vertex as hinted, on a lit mesh") {
    begin(gl);
    gl.Hint(GL_FOG_HINT, GL_NICEST);
    gl.Fogi(GL_FOG_MODE, GL_EXP);
    gl.Fogf(GL_FOG_DENSITY, 0.15F);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    row_of_solids(gl, kNormals);
    gl.Disable(GL_LIGHTING);
    gl.LineWidth(3);
    gl.PointSize(6);
    gl.Begin(GL_LINES);
    for (int i = 0; i < 8; ++i) {
        gl.Color4fv(hue(static_cast<float>(i) / 8).data());
        gl.Vertex3f(-2 + 0.5F * static_cast<float>(i), -1.3F, 2);
        gl.Vertex3f(-8 + 2 * static_cast<float>(i), 1.3F, -25);
    }
    gl.End();
    gl.Begin(GL_POINTS);
    for (int i = 0; i < 40; ++i) {
        gl.Color4fv(hue(static_cast<float>(i) / 40).data());
        gl.Vertex3f(static_cast<float>(i % 8) - 4, 1.2F + static_cast<float>(i / 8) * 0.3F,
                    -static_cast<float>(i));
    }
    gl.End();
}

SCENE(fog_flat_triangles, "fog per fragment over one large triangle in depth, orthographic") {
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    gl.Ortho(-1, 1, -1, 1, 0, 10);
    gl.MatrixMode(GL_MODELVIEW);
    gl.Enable(GL_FOG);
    for (int i = 0; i < 3; ++i) {
        const GLint modes[] = {GL_LINEAR, GL_EXP, GL_EXP2};
        gl.Fogi(GL_FOG_MODE, modes[i]);
        gl.Fogf(GL_FOG_START, 2);
        gl.Fogf(GL_FOG_END, 9);
        gl.Fogf(GL_FOG_DENSITY, 0.2F);
        const GLfloat colour[] = {0.2F, 0.1F, 0.4F, 1};
        gl.Fogfv(GL_FOG_COLOR, colour);
        const float y = -0.9F + 0.6F * static_cast<float>(i);
        gl.Begin(GL_QUADS);
        gl.Color3f(1, 0.8F, 0.2F);
        gl.Vertex3f(-0.95F, y, 0);
        gl.Vertex3f(0.95F, y, -10);
        gl.Vertex3f(0.95F, y + 0.55F, -10);
        gl.Vertex3f(-0.95F, y + 0.55F, 0);
        gl.End();
    }
}
