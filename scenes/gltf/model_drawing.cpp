// A model's frame: camera, lights, materials, arrays.
#include "model_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace terrazzo::gltf {
namespace {

constexpr double kFieldOfView = 45;

// Distance at which the bounding sphere just fits, with a little air.
float camera_distance(float radius) {
    return 1.05F * radius / std::sin(static_cast<float>(kFieldOfView * std::numbers::pi / 360));
}

GLuint upload(const kit::Gl& gl, const Texture& texture) {
    GLuint name = 0;
    gl.GenTextures(1, &name);
    gl.BindTexture(GL_TEXTURE_2D, name);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, texture.wrap_s);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, texture.wrap_t);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, texture.mag_filter);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, texture.min_filter);
    for (std::size_t i = 0; i < texture.levels.size(); ++i)
        gl.TexImage2D(GL_TEXTURE_2D, static_cast<GLint>(i), GL_RGBA, texture.levels[i].width,
                      texture.levels[i].height, 0, GL_RGBA, GL_UNSIGNED_BYTE, texture.levels[i].rgba.data());
    return name;
}

void set_lights(const kit::Gl& gl) {
    constexpr GLfloat kKeyPosition[] = {0.5F, 0.8F, 1, 0}, kKey[] = {0.9F, 0.87F, 0.8F, 1};
    constexpr GLfloat kFillPosition[] = {-1, 0.1F, 0.4F, 0}, kFill[] = {0.25F, 0.3F, 0.4F, 1};
    constexpr GLfloat kAmbient[] = {0.3F, 0.3F, 0.32F, 1}, kNone[] = {0, 0, 0, 1};
    gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, kAmbient);
    gl.Lightfv(GL_LIGHT0, GL_POSITION, kKeyPosition);
    gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, kKey);
    gl.Lightfv(GL_LIGHT0, GL_SPECULAR, kKey);
    gl.Lightfv(GL_LIGHT1, GL_POSITION, kFillPosition);
    gl.Lightfv(GL_LIGHT1, GL_DIFFUSE, kFill);
    gl.Lightfv(GL_LIGHT1, GL_SPECULAR, kNone);
    gl.Enable(GL_LIGHT0);
    gl.Enable(GL_LIGHT1);
}

}  // namespace

ModelDrawing::ModelDrawing(Model model) : m_model(std::move(model)) {}

float ModelDrawing::distance() const {
    return camera_distance(m_model.radius) / m_view.zoom;
}

void ModelDrawing::look(const kit::Gl& gl, const View& view, int width, int height) {
    m_view = view;
    gl.Viewport(0, 0, width, height);
    set_projection(gl, width, height);
    gl.PolygonMode(GL_FRONT_AND_BACK, view.wireframe ? GL_LINE : GL_FILL);
}

void ModelDrawing::set_projection(const kit::Gl& gl, int width, int height) const {
    const double distance = this->distance();
    const double near_plane = std::max(distance - 1.2 * m_model.radius, distance * 0.01);
    const double top = near_plane * std::tan(kFieldOfView * std::numbers::pi / 360);
    // The narrower direction keeps the field of view.
    const double aspect = static_cast<double>(width) / height;
    const double x = top * std::max(aspect, 1.0), y = top * std::max(1 / aspect, 1.0);
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    gl.Frustum(-x, x, -y, y, near_plane, distance + 1.2 * m_model.radius);
    gl.MatrixMode(GL_MODELVIEW);
}

void ModelDrawing::prepare(const kit::Gl& gl, int width, int height) {
    gl.Viewport(0, 0, width, height);
    gl.ClearColor(0.16F, 0.17F, 0.2F, 1);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_LEQUAL);
    gl.Enable(GL_NORMALIZE);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    set_projection(gl, width, height);
    gl.LoadIdentity();
    set_lights(gl);
    for (const Texture& texture : m_model.textures) m_textures.push_back(upload(gl, texture));
}

void ModelDrawing::place_camera(const kit::Gl& gl, int frame) const {
    gl.LoadIdentity();
    gl.Translatef(m_view.shift_x * m_model.radius, m_view.shift_y * m_model.radius, -distance());
    gl.Rotatef(m_view.tilt, 1, 0, 0);
    gl.Rotatef(m_view.turn + static_cast<float>(frame), 0, 1, 0);
    gl.Translatef(-m_model.centre[0], -m_model.centre[1], -m_model.centre[2]);
}

void ModelDrawing::set_material(const kit::Gl& gl, const Material& material, bool lit) const {
    const auto toggle = [&](GLenum capability, bool on) {
        on ? gl.Enable(capability) : gl.Disable(capability);
    };
    const GLfloat specular[] = {material.specular[0], material.specular[1], material.specular[2], 1};
    const GLfloat emission[] = {material.emission[0], material.emission[1], material.emission[2], 1};
    gl.Color4fv(material.diffuse);
    gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, material.diffuse);
    gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
    gl.Materialfv(GL_FRONT_AND_BACK, GL_EMISSION, emission);
    gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, material.shininess);
    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, material.double_sided);
    toggle(GL_LIGHTING, lit && m_view.lighting);
    toggle(GL_CULL_FACE, !material.double_sided);
    const bool textured = material.texture >= 0 && m_view.textures;
    toggle(GL_TEXTURE_2D, textured);
    if (textured) gl.BindTexture(GL_TEXTURE_2D, m_textures[static_cast<std::size_t>(material.texture)]);
    toggle(GL_ALPHA_TEST, material.alpha_cutoff > 0);
    gl.AlphaFunc(GL_GEQUAL, material.alpha_cutoff);
    toggle(GL_BLEND, material.blended);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl.DepthMask(!material.blended);
}

void ModelDrawing::draw_part(const kit::Gl& gl, const Part& part) const {
    set_material(gl, m_model.materials[static_cast<std::size_t>(part.material)], !part.normals.empty());
    gl.FrontFace(part.mirrored ? GL_CW : GL_CCW);
    gl.PushMatrix();
    gl.MultMatrixf(part.matrix);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.VertexPointer(3, GL_FLOAT, 0, part.positions.data());
    if (!part.normals.empty()) {
        gl.EnableClientState(GL_NORMAL_ARRAY);
        gl.NormalPointer(GL_FLOAT, 0, part.normals.data());
    }
    if (!part.textures.empty()) {
        gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
        gl.TexCoordPointer(2, GL_FLOAT, 0, part.textures.data());
    }
    if (!part.colours.empty()) {
        gl.ColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
        gl.Enable(GL_COLOR_MATERIAL);
        gl.EnableClientState(GL_COLOR_ARRAY);
        gl.ColorPointer(4, GL_FLOAT, 0, part.colours.data());
    }
    gl.DrawElements(static_cast<GLenum>(part.mode), static_cast<GLsizei>(part.indices.size()),
                    GL_UNSIGNED_INT, part.indices.data());
    for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_COLOR_ARRAY})
        gl.DisableClientState(array);
    gl.Disable(GL_COLOR_MATERIAL);
    gl.PopMatrix();
}

void ModelDrawing::draw(const kit::Gl& gl, int frame) {
    gl.DepthMask(GL_TRUE);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    place_camera(gl, frame);
    // What is seen through comes after what is not.
    for (const bool blended : {false, true})
        for (const Part& part : m_model.parts)
            if (m_model.materials[static_cast<std::size_t>(part.material)].blended == blended)
                draw_part(gl, part);
}

std::unique_ptr<kit::Drawing> create_drawing(Model model) {
    return std::make_unique<ModelDrawing>(std::move(model));
}

}  // namespace terrazzo::gltf
