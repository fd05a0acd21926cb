// T3-T6: one bilinear texture modulated with the current colour.
#include "scene_classes.h"

namespace terrazzo::study {
namespace {

void enable_textured(const kit::Gl& gl, int width, int height) {
    gl.Viewport(0, 0, width, height);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_LEQUAL);
    gl.Enable(GL_TEXTURE_2D);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
}

// Floor of T4 and T5: a size that is not a power of two.
constexpr int kFloorTexels = 736;

}  // namespace

void CubesOnFloor::prepare(const kit::Gl& gl, int width, int height) {
    enable_textured(gl, width, height);
    gl.Enable(GL_CULL_FACE);
    m_textures[0] = create_tiled_texture(gl, 256, 8, 3);
    m_textures[1] = create_texture(gl, make_crate(256, 4));
    m_textures[2] = create_texture(gl, make_bricks(128, 5));
    set_perspective(gl, static_cast<double>(width) / height, 0.1, 1000);
}

void CubesOnFloor::draw(const kit::Gl& gl, int frame) {
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.LoadIdentity();
    gl.Translatef(0, 0, -20);
    gl.Rotatef(25 + static_cast<float>(frame), 0, 1, 0);
    gl.BindTexture(GL_TEXTURE_2D, m_textures[0]);
    draw_mesh(gl, m_floor);

    gl.BindTexture(GL_TEXTURE_2D, m_textures[1]);
    gl.PushMatrix();
    gl.Translatef(0, -1, 0);
    gl.Scalef(3, 3, 3);
    draw_mesh(gl, m_cube);
    gl.Translatef(0, 1.5F, 0);
    gl.Scalef(0.5F, 0.5F, 0.5F);
    draw_mesh(gl, m_cube);
    gl.Translatef(0, 2, 0);
    draw_mesh(gl, m_pyramid);
    gl.PopMatrix();

    gl.BindTexture(GL_TEXTURE_2D, m_textures[2]);
    for (const float x : {-6.0F, 6.0F})
        for (const float z : {-6.0F, 6.0F}) {
            gl.PushMatrix();
            gl.Translatef(x, -1, z);
            draw_mesh(gl, m_pyramid);
            gl.Translatef(0, -2, 0);
            draw_mesh(gl, m_cube);
            gl.PopMatrix();
        }
}

void OneTeapot::prepare(const kit::Gl& gl, int width, int height) {
    enable_textured(gl, width, height);
    m_textures[0] = create_texture(gl, make_glaze(128, 6));
    m_textures[1] = create_tiled_texture(gl, kFloorTexels, 8, 7);
    set_perspective(gl, static_cast<double>(width) / height, 0.01, 1000);
}

void OneTeapot::draw(const kit::Gl& gl, int frame) {
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.LoadIdentity();
    gl.Translatef(0, -0.5F, -5);
    gl.Rotatef(20, 1, 0, 0);
    if (frame != 0) gl.Rotatef(static_cast<float>(frame), 0, 1, 0);
    gl.Color3f(0.75F, 0.75F, 0.75F);
    gl.BindTexture(GL_TEXTURE_2D, m_textures[0]);
    draw_mesh(gl, m_teapot);
    gl.BindTexture(GL_TEXTURE_2D, m_textures[1]);
    draw_mesh(gl, m_floor);
}

void NineTeapots::prepare(const kit::Gl& gl, int width, int height) {
    enable_textured(gl, width, height);
    m_textures[0] = create_texture(gl, make_glaze(128, 6));
    m_textures[1] = create_tiled_texture(gl, kFloorTexels, 8, 7);
    set_perspective(gl, static_cast<double>(width) / height, 0.01, 1000);
}

void NineTeapots::draw(const kit::Gl& gl, int frame) {
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.LoadIdentity();
    gl.Translatef(0, 0.5F, -5);
    gl.Rotatef(20, 1, 0, 0);
    gl.Rotatef(150 + static_cast<float>(frame), 0, 1, 0);
    gl.Color3f(0.75F, 0.75F, 0.75F);
    gl.BindTexture(GL_TEXTURE_2D, m_textures[0]);
    for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j) {
            gl.PushMatrix();
            gl.Translatef(2 * static_cast<float>(i), 0, 2 * static_cast<float>(j));
            gl.Scalef(0.5F, 0.5F, 0.5F);
            draw_mesh(gl, m_teapot);
            gl.PopMatrix();
        }
    gl.BindTexture(GL_TEXTURE_2D, m_textures[1]);
    draw_mesh(gl, m_floor);
}

void Terrain::prepare(const kit::Gl& gl, int width, int height) {
    enable_textured(gl, width, height);
    gl.Enable(GL_CULL_FACE);
    m_texture = create_texture(gl, m_field.image);
    set_perspective(gl, static_cast<double>(width) / height, 0.1, 100);
}

void Terrain::draw(const kit::Gl& gl, int frame) {
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.LoadIdentity();
    gl.Translatef(0, 0, -15);
    gl.Rotatef(25, 1, 0, 0);
    if (frame != 0) gl.Rotatef(static_cast<float>(frame), 0, 1, 0);
    gl.Scalef(1.0F / 16, 1, 1.0F / 16);
    gl.BindTexture(GL_TEXTURE_2D, m_texture);
    draw_mesh(gl, m_field.mesh);
}

}  // namespace terrazzo::study
