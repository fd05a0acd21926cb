// Chapter: lighting, materials, colour material, shade model (GL 1.5 §2.14).
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

void set_light(const Gl& gl, GLenum light, Colour diffuse, std::array<float, 4> position) {
    gl.Enable(light);
    gl.Lightfv(light, GL_DIFFUSE, diffuse.data());
    gl.Lightfv(light, GL_SPECULAR, diffuse.data());
    gl.Lightfv(light, GL_POSITION, position.data());
}

void set_material(const Gl& gl, Colour diffuse, float shine) {
    const GLfloat specular[] = {0.8F, 0.8F, 0.8F, 1};
    gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, diffuse.data());
    gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
    gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, shine);
}

void stage(const Gl& gl) {
    camera(gl, 45, 4.4F);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_LIGHTING);
}

// A 3x3 grid of spheres, each after prepare(i).
void nine_spheres(const Gl& gl, const std::function<void(int)>& prepare) {
    const Solid sphere = make_sphere(0.5F, 16, 24);
    for (int i = 0; i < 9; ++i) {
        gl.PushMatrix();
        gl.Translatef(static_cast<float>(i % 3 - 1) * 1.15F, static_cast<float>(i / 3 - 1) * 1.15F, 0);
        prepare(i);
        draw_solid(gl, sphere, kNormals);
        gl.PopMatrix();
    }
}

}  // namespace

SCENE(light_default, "GL_LIGHT0 and the material as they are at the start") {
    stage(gl);
    gl.Enable(GL_LIGHT0);
    gl.Rotatef(40, 1, 1, 0);
    draw_solid(gl, make_torus(1.1F, 0.5F, 40, 20), kNormals);
}

SCENE(light_directional_colours, "three directional lights of different colours on a torus") {
    stage(gl);
    set_light(gl, GL_LIGHT0, {0.9F, 0.2F, 0.1F, 1}, {1, 0, 0.4F, 0});
    set_light(gl, GL_LIGHT1, {0.1F, 0.9F, 0.2F, 1}, {-1, 0.5F, 0.4F, 0});
    set_light(gl, GL_LIGHT2, {0.2F, 0.2F, 1.0F, 1}, {0, -1, 0.3F, 0});
    set_material(gl, {0.9F, 0.9F, 0.9F, 1}, 12);
    gl.Rotatef(-50, 1, 0.3F, 0);
    draw_solid(gl, make_torus(1.1F, 0.5F, 40, 20), kNormals);
}

SCENE(light_eight, "all eight lights at once, each a colour of the circle") {
    stage(gl);
    for (int i = 0; i < 8; ++i) {
        const Colour place = hue(static_cast<float>(i) / 8);
        set_light(gl, static_cast<GLenum>(GL_LIGHT0 + i), hue(static_cast<float>(i) / 8, 0.4F),
                  {4 * (place[0] - 0.55F), 4 * (place[1] - 0.55F), 0.7F, i % 2 ? 1.0F : 0.0F});
    }
    set_material(gl, {1, 1, 1, 1}, 30);
    draw_solid(gl, make_sphere(1.5F, 24, 36), kNormals);
}

SCENE(light_specular_exponents, "shininess 0, 1, 2, 5, 10, 32, 64, 100 and 128") {
    stage(gl);
    set_light(gl, GL_LIGHT0, {1, 1, 1, 1}, {0.6F, 0.7F, 1, 0});
    nine_spheres(gl, [&](int i) {
        const float exponents[] = {0, 1, 2, 5, 10, 32, 64, 100, 128};
        const Colour colour = hue(static_cast<float>(i) / 9, 0.6F);
        set_material(gl, colour, exponents[i]);
    });
}

SCENE(light_local_viewer, "highlights with an infinite viewer on the left and a local one on the right") {
    camera(gl, 70, 2.2F);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_LIGHTING);
    set_light(gl, GL_LIGHT0, {1, 1, 0.9F, 1}, {0, 0, 1.6F, 1});
    set_material(gl, {0.1F, 0.2F, 0.5F, 1}, 20);
    const Solid grid = make_grid(0.75F, 24);
    for (int local = 0; local < 2; ++local) {
        gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, local);
        gl.PushMatrix();
        gl.Translatef(local ? 0.8F : -0.8F, 0, 0);
        gl.Rotatef(local ? -20.0F : 20.0F, 0, 1, 0);
        draw_solid(gl, grid, kNormals);
        gl.PopMatrix();
    }
}

SCENE(light_positional_attenuation,
      "constant, linear and quadratic attenuation of a light close to a plane") {
    for_viewports(gl, 2, 2, [&](int cell) {
        stage(gl);
        set_light(gl, GL_LIGHT0, {1, 0.9F, 0.7F, 1}, {0.2F, 0.1F, 0.4F, 1});
        set_material(gl, {0.8F, 0.8F, 0.8F, 1}, 8);
        gl.Lightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, cell == 0 ? 1.5F : 1);
        gl.Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, cell == 1 ? 1.4F : 0);
        gl.Lightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, cell >= 2 ? 2.0F : 0);
        if (cell == 3) gl.Rotatef(50, 1, 0, 0);
        draw_solid(gl, make_grid(1.5F, 20), kNormals);
    });
}

SCENE(light_spots, "spot lights with cut-offs and exponents, drawn over a fine grid") {
    for_viewports(gl, 3, 3, [&](int cell) {
        stage(gl);
        const GLfloat direction[] = {0.25F * static_cast<float>(cell % 3 - 1), 0.1F, -1};
        set_light(gl, GL_LIGHT0, hue(static_cast<float>(cell) / 9), {0, 0, 1.6F, 1});
        gl.Lightfv(GL_LIGHT0, GL_SPOT_DIRECTION, direction);
        const GLfloat cutoffs[] = {8, 15, 22, 30, 45, 60, 90, 20, 180};
        const GLfloat exponents[] = {0, 1, 4, 16, 40, 128, 2, 80, 10};
        gl.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, cutoffs[cell]);
        gl.Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, exponents[cell]);
        set_material(gl, {0.9F, 0.9F, 0.9F, 1}, 10);
        draw_solid(gl, make_grid(1.7F, 40), kNormals);
    });
}

SCENE(light_two_sided, "open half tori with different front and back materials, one and two-sided") {
    const Solid torus = make_torus(1, 0.45F, 32, 16);
    for_viewports(gl, 2, 2, [&](int cell) {
        stage(gl);
        gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, cell % 2);
        gl.FrontFace(cell / 2 ? GL_CW : GL_CCW);
        set_light(gl, GL_LIGHT0, {1, 1, 1, 1}, {0.3F, 0.5F, 1, 0});
        set_material(gl, {0.8F, 0.3F, 0.1F, 1}, 20);
        const GLfloat back[] = {0.1F, 0.4F, 0.8F, 1}, glow[] = {0, 0.15F, 0, 1};
        gl.Materialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, back);
        gl.Materialfv(GL_BACK, GL_EMISSION, glow);
        gl.Materialf(GL_BACK, GL_SHININESS, 3);
        gl.Rotatef(-40, 1, 0.5F, 0);
        const GLdouble plane[] = {0.2, 1, 0, 0.1};
        gl.ClipPlane(GL_CLIP_PLANE0, plane);
        gl.Enable(GL_CLIP_PLANE0);
        draw_solid(gl, torus, kNormals);
        gl.Disable(GL_CLIP_PLANE0);
    });
}

SCENE(light_material_parameters,
      "ambient, diffuse, specular and emission one at a time, set by f, fv, i and iv forms") {
    stage(gl);
    set_light(gl, GL_LIGHT0, {1, 1, 1, 1}, {0.5F, 0.8F, 1, 0});
    const GLfloat ambient_light[] = {0.5F, 0.5F, 0.5F, 1};
    gl.Lightfv(GL_LIGHT0, GL_AMBIENT, ambient_light);
    nine_spheres(gl, [&](int i) {
        const GLfloat black[] = {0, 0, 0, 1};
        for (const GLenum part : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION})
            gl.Materialfv(GL_FRONT, part, black);
        gl.Materialf(GL_FRONT, GL_SHININESS, 10);
        const Colour colour = hue(static_cast<float>(i) / 9);
        const GLint integers[] = {2147483647, 1073741824, -2147483647, 2147483647};
        switch (i) {
            case 0:
                gl.Materialfv(GL_FRONT, GL_AMBIENT, colour.data());
                break;
            case 1:
                gl.Materialfv(GL_FRONT, GL_DIFFUSE, colour.data());
                break;
            case 2:
                gl.Materialfv(GL_FRONT, GL_SPECULAR, colour.data());
                break;
            case 3:
                gl.Materialfv(GL_FRONT, GL_EMISSION, colour.data());
                break;
            case 4:
                gl.Materialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, colour.data());
                break;
            case 5:
                gl.Materialiv(GL_FRONT, GL_DIFFUSE, integers);
                break;
            case 6:
                gl.Materialiv(GL_FRONT, GL_SPECULAR, integers);
                gl.Materiali(GL_FRONT, GL_SHININESS, 40);
                break;
            case 7:
                gl.Materialfv(GL_BACK, GL_EMISSION, colour.data());  // not seen: the front is
                gl.Materialiv(GL_FRONT, GL_EMISSION, integers);
                break;
            default:
                gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, colour.data());
                break;
        }
    });
    GLfloat diffuse[4];
    gl.GetMaterialfv(GL_FRONT, GL_DIFFUSE, diffuse);
    notes.values("diffuse", diffuse, 1e-6);
    GLint emission[4];
    gl.GetMaterialiv(GL_BACK, GL_EMISSION, emission);
    // Half a unit in 24 bits of the float behind the integer.
    notes.values("emission", emission, 256);
}

SCENE(light_model_ambient_and_colours,
      "scene ambient, light ambient and alpha: lit alpha is the diffuse material's") {
    stage(gl);
    gl.Disable(GL_DEPTH_TEST);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    const GLfloat ambient[] = {0.4F, 0.1F, 0.3F, 1};
    gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
    set_light(gl, GL_LIGHT0, {0.7F, 0.7F, 0.7F, 0.1F}, {1, 1, 1, 0});
    const GLfloat light_ambient[] = {0, 0.3F, 0, 1};
    gl.Lightfv(GL_LIGHT0, GL_AMBIENT, light_ambient);
    nine_spheres(gl, [&](int i) {
        set_material(gl, hue(static_cast<float>(i) / 9, 1, static_cast<float>(i + 1) / 9), 5);
    });
}

SCENE(light_colour_material, "ColorMaterial for each face and parameter, with colours from an array") {
    const Solid sphere = make_sphere(1.5F, 20, 30);
    const GLenum modes[] = {GL_EMISSION, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_AMBIENT_AND_DIFFUSE};
    for_viewports(gl, 3, 2, [&](int cell) {
        stage(gl);
        set_light(gl, GL_LIGHT0, {1, 1, 1, 1}, {-0.7F, 0.6F, 1, 0});
        set_material(gl, {0.3F, 0.3F, 0.3F, 1}, 15);
        const GLfloat black[] = {0, 0, 0, 1};
        gl.Materialfv(GL_FRONT_AND_BACK, GL_EMISSION, black);
        gl.ColorMaterial(cell == 5 ? GL_BACK : GL_FRONT_AND_BACK, modes[cell % 5]);
        gl.Enable(GL_COLOR_MATERIAL);
        draw_solid(gl, sphere, kNormals | kColours);
        gl.Disable(GL_COLOR_MATERIAL);
    });
}

SCENE(light_colour_material_changes,
      "ColorMaterial switched on, changed and off in the middle of Begin/End-built rings") {
    stage(gl);
    set_light(gl, GL_LIGHT0, {1, 1, 1, 1}, {0, 0, 1, 0});
    for (int ring = 0; ring < 4; ++ring) {
        const float r = 0.35F * static_cast<float>(ring + 1);
        if (ring == 1) {
            gl.ColorMaterial(GL_FRONT, GL_DIFFUSE);
            gl.Enable(GL_COLOR_MATERIAL);
        }
        if (ring == 2) gl.ColorMaterial(GL_FRONT, GL_EMISSION);
        if (ring == 3) gl.Disable(GL_COLOR_MATERIAL);
        gl.Begin(GL_QUAD_STRIP);
        gl.Normal3f(0, 0.3F, 0.9F);
        for (int i = 0; i <= 16; ++i) {
            const Colour colour = hue(static_cast<float>(i) / 16);
            gl.Color4fv(colour.data());
            const Colour direction = hue(static_cast<float>(i) / 16 + 0.08F);
            const float x = (direction[0] - 0.55F) / 0.45F, y = (direction[1] - direction[2]) / 0.78F;
            gl.Vertex3f(x * (r - 0.3F), y * (r - 0.3F), 0);
            gl.Vertex3f(x * r, y * r, 0);
        }
        gl.End();
    }
    GLfloat emission[4];
    gl.GetMaterialfv(GL_FRONT, GL_EMISSION, emission);
    notes.values("emission that stayed", emission, 1e-6);
}

SCENE(light_normalize,
      "normals of wrong lengths and a scaled modelview, with neither, NORMALIZE and RESCALE_NORMAL") {
    const Solid sphere = make_sphere(0.5F, 16, 24);
    for_viewports(gl, 3, 2, [&](int cell) {
        stage(gl);
        set_light(gl, GL_LIGHT0, {0.9F, 0.8F, 0.6F, 1}, {0.5F, 0.5F, 1, 0});
        set_material(gl, {0.5F, 0.5F, 0.6F, 1}, 10);
        if (cell % 3 == 1) gl.Enable(GL_NORMALIZE);
        if (cell % 3 == 2) gl.Enable(GL_RESCALE_NORMAL);
        if (cell / 3 == 0)
            gl.Scalef(2.8F, 2.8F, 2.8F);
        else
            gl.Scalef(3.2F, 1.6F, 2.0F);
        draw_solid(gl, sphere, kNormals);
        gl.Disable(GL_NORMALIZE);
        gl.Disable(GL_RESCALE_NORMAL);
    });
}

SCENE(light_flat_and_smooth, "the shade model on lit triangles, strips, fans, quads and polygons") {
    const Solid torus = make_torus(1, 0.45F, 14, 8);
    for_viewports(gl, 2, 1, [&](int cell) {
        camera(gl, 80, 3.4F);
        gl.Scalef(1.6F, 0.8F, 1);
        gl.Enable(GL_DEPTH_TEST);
        gl.Enable(GL_LIGHTING);
        gl.Enable(GL_NORMALIZE);
        set_light(gl, GL_LIGHT0, {1, 1, 1, 1}, {0.6F, 0.8F, 1, 0});
        set_material(gl, {0.7F, 0.4F, 0.8F, 1}, 20);
        gl.ShadeModel(cell ? GL_SMOOTH : GL_FLAT);
        gl.PushMatrix();
        gl.Translatef(0, 1.2F, 0);
        gl.Rotatef(-50, 1, 0, 0);
        draw_solid(gl, torus, kNormals);
        gl.PopMatrix();
        const GLenum modes[] = {GL_TRIANGLE_STRIP, GL_QUAD_STRIP, GL_TRIANGLE_FAN, GL_POLYGON};
        for (int i = 0; i < 4; ++i) {
            gl.Begin(modes[i]);
            for (int k = 0; k < 8; ++k) {
                const float t = static_cast<float>(k) / 7;
                gl.Normal3f(2 * t - 1, k % 2 ? 0.6F : -0.2F, 0.5F);
                const float x = i < 2 ? -1.9F + 3.8F * t
                                      : -1 + 2 * static_cast<float>(i - 2) + 0.8F * (hue(t)[0] - 0.55F) * 2;
                const float y = i < 2 ? -1.0F - 0.7F * static_cast<float>(i) + (k % 2 ? 0.6F : 0.0F)
                                      : -2.8F + 0.9F * (hue(t)[1] - hue(t)[2]);
                gl.Vertex3f(x, y, 0);
            }
            gl.End();
        }
    });
}

SCENE(light_changes_under_matrices,
      "positions and spot directions are taken through the modelview of their call") {
    camera(gl, 45, 6);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_LIGHTING);
    const Solid sphere = make_sphere(0.35F, 10, 16);
    for (int i = 0; i < 12; ++i) {
        gl.PushMatrix();
        gl.Rotatef(static_cast<float>(i) * 30, 0, 0, 1);
        if (i % 3 == 0) set_light(gl, GL_LIGHT0, hue(static_cast<float>(i) / 12), {1, 0, 0.2F, 0});
        if (i % 4 == 1) set_light(gl, GL_LIGHT1, hue(static_cast<float>(i) / 12 + 0.5F), {0.5F, 0, 1, 1});
        gl.Translatef(1.8F, 0, 0);
        draw_solid(gl, sphere, kNormals);
        gl.PopMatrix();
    }
    GLfloat position[4], direction[3];
    gl.GetLightfv(GL_LIGHT1, GL_POSITION, position);
    gl.GetLightfv(GL_LIGHT1, GL_SPOT_DIRECTION, direction);
    notes.values("position in eye space", position, 1e-5);
    notes.values("spot direction", direction, 1e-6);
    GLint diffuse[4];
    gl.GetLightiv(GL_LIGHT0, GL_DIFFUSE, diffuse);
    notes.values("diffuse as integers", diffuse, 256);
}
