// Chapter: secondary colours and the colour sum (GL 1.5 §2.7, §3.9), fog coordinates (§3.10), point
// parameters (§3.3) and level-of-detail biases (§3.8.8).
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

void cell_quad(const Gl& gl, float x, float y, float w, float h) {
    const float corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    gl.Begin(GL_QUADS);
    for (int i = 0; i < 4; ++i) {
        gl.SecondaryColor3fv(hue(static_cast<float>(i) / 4, 0.7F).data());
        gl.FogCoordf(static_cast<float>(i) * 0.6F - 0.4F);
        gl.TexCoord2fv(corners[i]);
        gl.Vertex2f(x + 2 + corners[i][0] * (w - 4), y + 2 + corners[i][1] * (h - 4));
    }
    gl.End();
}

}  // namespace

SCENE(color_sum, "secondary colours added after texturing, smooth and flat, and not added") {
    pixel_projection(gl);
    for_cells(4, 2, [&](int cell, float x, float y, float w, float h) {
        (cell & 1 ? gl.Enable : gl.Disable)(GL_COLOR_SUM);
        gl.ShadeModel(cell & 2 ? GL_FLAT : GL_SMOOTH);
        if (cell == 4) gl.Enable(GL_TEXTURE_2D), painted_texture(gl, 32, 32, GL_LINEAR, GL_LINEAR);
        gl.Color4f(0.4F, 0.3F, 0.2F, 1);
        cell_quad(gl, x, y, w, h);
    });
}

SCENE(color_sum_lit, "the colour sum with lighting: separate specular colours or none") {
    const Solid sphere = make_sphere(1, 20, 24);
    for_viewports(gl, 2, 2, [&](int cell) {
        camera(gl, 50, 3);
        gl.Enable(GL_DEPTH_TEST);
        gl.Enable(GL_LIGHTING);
        gl.Enable(GL_LIGHT0);
        const GLfloat white[] = {1, 1, 1, 1};
        gl.Materialfv(GL_FRONT, GL_SPECULAR, white);
        gl.Materialf(GL_FRONT, GL_SHININESS, 20);
        (cell & 1 ? gl.Enable : gl.Disable)(GL_COLOR_SUM);
        gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, cell & 2 ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
        gl.SecondaryColor3f(0.5F, 0, 0);
        draw_solid(gl, sphere, kNormals);
    });
}

SCENE(secondary_color_arrays, "secondary colours and fog coordinates in arrays, by element and in lists") {
    pixel_projection(gl);
    gl.Enable(GL_COLOR_SUM);
    const GLfloat positions[] = {0, 0, 58, 0, 58, 120, 0, 120};
    const GLubyte bytes[] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 90, 90, 90};
    const GLshort shorts[] = {32767, 0, -32768, 0, 32767, 0, 0, 0, 32767, 9000, 9000, 9000};
    const GLdouble fog[] = {0, 0.3, 0.6, 0.9};
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.VertexPointer(2, GL_FLOAT, 0, positions);
    gl.EnableClientState(GL_SECONDARY_COLOR_ARRAY);
    gl.EnableClientState(GL_FOG_COORDINATE_ARRAY);
    gl.FogCoordPointer(GL_DOUBLE, 0, fog);
    gl.Fogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
    gl.Fogi(GL_FOG_MODE, GL_LINEAR);
    const GLfloat grey[] = {0.5F, 0.5F, 0.5F, 1};
    gl.Fogfv(GL_FOG_COLOR, grey);
    gl.Color3f(0.2F, 0.2F, 0.2F);
    for_cells(4, 2, [&](int cell, float x, float y, float, float) {
        if (cell > 3) gl.Enable(GL_FOG);
        gl.LoadIdentity();
        gl.Translatef(x + 3, y + 3, 0);
        if (cell % 2)
            gl.SecondaryColorPointer(3, GL_SHORT, 0, shorts);
        else
            gl.SecondaryColorPointer(3, GL_UNSIGNED_BYTE, 0, bytes);
        if (cell % 4 == 3) {
            gl.Begin(GL_QUADS);
            for (int i = 0; i < 4; ++i) gl.ArrayElement(i);
            gl.End();
        } else if (cell % 4 == 2) {
            gl.NewList(1, GL_COMPILE);
            gl.DrawArrays(GL_QUADS, 0, 4);
            gl.EndList();
            gl.CallList(1);
        } else {
            gl.DrawArrays(GL_QUADS, 0, 4);
        }
    });
}

SCENE(secondary_color_lists,
      "secondary colours and fog coordinates in display lists and on the attribute stack") {
    pixel_projection(gl);
    gl.Enable(GL_COLOR_SUM);
    gl.NewList(1, GL_COMPILE);
    cell_quad(gl, 0, 0, 128, 128);
    gl.SecondaryColor3ub(10, 200, 30);
    gl.FogCoordd(0.75);
    gl.EndList();
    gl.PushAttrib(GL_CURRENT_BIT);
    gl.CallList(1);
    GLfloat secondary[4], coordinate[1];
    gl.GetFloatv(GL_CURRENT_SECONDARY_COLOR, secondary);
    gl.GetFloatv(GL_CURRENT_FOG_COORDINATE, coordinate);
    notes.values("secondary", secondary, 1e-6);
    notes.values("fog", coordinate);
    gl.PopAttrib();
    gl.GetFloatv(GL_CURRENT_SECONDARY_COLOR, secondary);
    notes.values("popped", secondary);
    gl.Color3f(0.2F, 0.4F, 0.6F);
    gl.Rectf(130, 130, 250, 250);
}

SCENE(fog_coordinates, "each fog mode by coordinates, and back to the depth") {
    pixel_projection(gl);
    gl.Enable(GL_FOG);
    const GLfloat color[] = {0.1F, 0.7F, 0.9F, 1};
    gl.Fogfv(GL_FOG_COLOR, color);
    const GLint modes[] = {GL_LINEAR, GL_EXP, GL_EXP2};
    for_cells(3, 2, [&](int cell, float x, float y, float w, float h) {
        gl.Fogi(GL_FOG_MODE, modes[cell % 3]);
        gl.Fogi(GL_FOG_COORDINATE_SOURCE, cell < 3 ? GL_FOG_COORDINATE : GL_FRAGMENT_DEPTH);
        cell_quad(gl, x, y, w, h);
    });
}

SCENE(point_parameters, "points that grow with nearness, with bounds, smooth and not") {
    for_viewports(gl, 2, 3, [&](int cell) {
        camera(gl, 60, 4);
        const GLfloat attenuations[3][3] = {{0, 0, 0.05F}, {0, 0.2F, 0}, {0.5F, 0.1F, 0.01F}};
        gl.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuations[cell / 2]);
        gl.PointParameterf(GL_POINT_SIZE_MIN, cell / 2 == 1 ? 3.0F : 0.0F);
        gl.PointParameteri(GL_POINT_SIZE_MAX, cell / 2 == 2 ? 9 : 64);
        gl.PointSize(8);
        (cell & 1 ? gl.Enable : gl.Disable)(GL_POINT_SMOOTH);
        gl.Enable(GL_BLEND);
        gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        gl.Begin(GL_POINTS);
        for (int i = 0; i < 60; ++i) {
            const float k = static_cast<float>(i) / 60;
            gl.Color4fv(hue(k).data());
            gl.Vertex3f(4 * k - 2 + 0.1F * static_cast<float>(i % 3), static_cast<float>(i % 7) * 0.4F - 1.2F,
                        2.5F - 9 * k);
        }
        gl.End();
    });
}

SCENE(point_parameters_of_polygons, "attenuated points as the polygon mode, lit, and clipped") {
    camera(gl, 60, 3);
    const GLfloat attenuation[] = {0, 0, 0.1F};
    gl.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
    gl.PointSize(5);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    const GLdouble plane[] = {1, 0.3, 0, 0.6};
    gl.ClipPlane(GL_CLIP_PLANE0, plane);
    gl.Enable(GL_CLIP_PLANE0);
    draw_solid(gl, make_sphere(1.1F, 14, 18), kNormals);
}

SCENE(texture_lod_bias, "biases of a unit and of a texture, with every mipmap filter") {
    constexpr GLint kFilters[] = {GL_LINEAR, GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST,
                                  GL_LINEAR_MIPMAP_LINEAR};
    for_viewports(gl, 4, 4, [&](int cell) {
        camera(gl, 60, 1);
        gl.Enable(GL_TEXTURE_2D);
        painted_texture(gl, 64, 64, static_cast<GLenum>(kFilters[cell % 4]), GL_LINEAR, 9);
        for (int level = 1; level < 7; ++level) {
            const int size = 64 >> level;
            std::vector<std::uint8_t> texels(static_cast<std::size_t>(size * size * 4));
            for (std::size_t i = 0; i < texels.size(); ++i)
                texels[i] = static_cast<std::uint8_t>(255 * hue(static_cast<float>(level) / 7)[i % 4]);
            gl.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA8, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                          texels.data());
        }
        const GLfloat biases[4][2] = {{1.5F, 0}, {0, -1.25F}, {0.7F, 0.6F}, {-20, 19.5F}};
        gl.TexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, biases[cell / 4][0]);
        gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, biases[cell / 4][1]);
        receding_rectangle(gl, {2, -0.8F, -0.5F, 0.8F, -8}, 4, 8);
    });
}
