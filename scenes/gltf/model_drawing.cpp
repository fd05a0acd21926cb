// A model's frame: camera, lights, materials, arrays.
#include "model_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
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

// Sides from the middle of the picture at the near plane. The narrower side keeps the lens's field of view.
void set_fitted_lens(const kit::Gl& gl, double distance, double radius, double aspect) {
    const double near_plane = std::max(distance - 1.2 * radius, distance * 0.01);
    const double top = near_plane * std::tan(kFieldOfView * std::numbers::pi / 360);
    const double x = top * std::max(aspect, 1.0), y = top * std::max(1 / aspect, 1.0);
    gl.Frustum(-x, x, -y, y, near_plane, distance + 1.2 * radius);
}

// glTF 2.0 §3.10.3: the camera's height is kept, its width is the picture's.
void set_lens(const kit::Gl& gl, const Camera& camera, double aspect) {
    if (!camera.perspective) {
        double x = camera.half_size[0], y = camera.half_size[1];
        if (aspect > std::abs(x / y)) {
            x = std::copysign(std::abs(y) * aspect, x);
        } else {
            y = std::copysign(std::abs(x) / aspect, y);
        }
        gl.Ortho(-x, x, -y, y, camera.near_plane, camera.far_plane);
        return;
    }
    const double slope = std::tan(camera.field_of_view / 2.0), near_plane = camera.near_plane;
    const double y = near_plane * slope, x = y * aspect;
    if (camera.far_plane > 0) {
        gl.Frustum(-x, x, -y, y, near_plane, camera.far_plane);
    } else {
        const GLdouble endless[] = {1 / (slope * aspect), 0, 0, 0, 0, 1 / slope, 0, 0, 0, 0, -1, -1, 0, 0,
                                    -2 * near_plane,      0};
        gl.LoadMatrixd(endless);
    }
}

bool has_faces(const Geometry& geometry) {
    return geometry.mode >= GL_TRIANGLES;
}

void toggle(const kit::Gl& gl, GLenum capability, bool on) {
    on ? gl.Enable(capability) : gl.Disable(capability);
}

void set_coordinates(const kit::Gl& gl, GLenum unit, const std::vector<float>& coordinates) {
    if (coordinates.empty()) return;
    gl.ClientActiveTexture(unit);
    gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
    gl.TexCoordPointer(2, GL_FLOAT, 0, coordinates.data());
}

void disable_arrays(const kit::Gl& gl) {
    for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY})
        gl.DisableClientState(array);
    for (const GLenum unit : {GL_TEXTURE1, GL_TEXTURE0}) {
        gl.ClientActiveTexture(unit);
        gl.DisableClientState(GL_TEXTURE_COORD_ARRAY);
    }
}

}  // namespace

ModelDrawing::ModelDrawing(Model model, int camera) : m_model(std::move(model)) {
    if (camera < -1 || camera >= cameras())
        throw std::runtime_error("the model has no camera " + std::to_string(camera) + ", but " +
                                 std::to_string(cameras()) + " cameras");
    m_view.camera = camera;
    for (const Material& material : m_model.materials) m_any_emissive |= material.emissive.texture >= 0;
}

float ModelDrawing::distance() const {
    return camera_distance(m_model.radius) / m_view.zoom;
}

const Camera* ModelDrawing::camera() const {
    return m_view.camera < 0 ? nullptr : &m_model.cameras[static_cast<std::size_t>(m_view.camera)];
}

const Material& ModelDrawing::material_of(const Part& part) const {
    return m_model.materials[static_cast<std::size_t>(part.material)];
}

const Geometry& ModelDrawing::geometry_of(const Part& part) const {
    return m_model.geometries[static_cast<std::size_t>(part.geometry)];
}

void ModelDrawing::look(const kit::Gl& gl, const View& view, int width, int height) {
    m_view = view;
    gl.Viewport(0, 0, width, height);
    set_projection(gl, width, height);
    gl.PolygonMode(GL_FRONT_AND_BACK, view.wireframe ? GL_LINE : GL_FILL);
}

void ModelDrawing::set_projection(const kit::Gl& gl, int width, int height) const {
    const double aspect = static_cast<double>(width) / height;
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    if (camera()) {
        set_lens(gl, *camera(), aspect);
    } else {
        set_fitted_lens(gl, distance(), m_model.radius, aspect);
    }
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
    if (!m_any_emissive) return;
    gl.ActiveTexture(GL_TEXTURE1);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD);
    gl.ActiveTexture(GL_TEXTURE0);
}

void ModelDrawing::place_camera(const kit::Gl& gl, int frame) const {
    const auto turned = static_cast<float>(frame);
    if (camera()) {
        gl.LoadMatrixf(camera()->view);
        gl.Translatef(m_model.centre[0], m_model.centre[1], m_model.centre[2]);
        gl.Rotatef(turned, 0, 1, 0);
    } else {
        gl.LoadIdentity();
        gl.Translatef(m_view.shift_x * m_model.radius, m_view.shift_y * m_model.radius, -distance());
        gl.Rotatef(m_view.tilt, 1, 0, 0);
        gl.Rotatef(m_view.turn + turned, 0, 1, 0);
    }
    gl.Translatef(-m_model.centre[0], -m_model.centre[1], -m_model.centre[2]);
}

void ModelDrawing::set_surface(const kit::Gl& gl, const Material& material) const {
    const GLfloat specular[] = {material.specular[0], material.specular[1], material.specular[2], 1};
    const GLfloat emission[] = {material.emission[0], material.emission[1], material.emission[2], 1};
    gl.Color4fv(material.diffuse);
    gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, material.diffuse);
    gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
    gl.Materialfv(GL_FRONT_AND_BACK, GL_EMISSION, emission);
    gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, material.shininess);
    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, material.double_sided);
    // Only of a metal is the highlight as coloured as the texture.
    gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                   material.metal ? GL_SINGLE_COLOR : GL_SEPARATE_SPECULAR_COLOR);
}

void ModelDrawing::set_texture(const kit::Gl& gl, GLenum unit, const TextureUse& use, bool on) const {
    gl.ActiveTexture(unit);
    toggle(gl, GL_TEXTURE_2D, on);
    if (!on) return;
    gl.BindTexture(GL_TEXTURE_2D, m_textures[static_cast<std::size_t>(use.texture)]);
    gl.MatrixMode(GL_TEXTURE);
    gl.LoadMatrixf(use.matrix);
    gl.MatrixMode(GL_MODELVIEW);
}

void ModelDrawing::set_material(const kit::Gl& gl, const Material& material, const Geometry& geometry) const {
    set_surface(gl, material);
    const bool lit = !geometry.normals.empty() && !material.unlit && m_view.lighting;
    toggle(gl, GL_LIGHTING, lit);
    toggle(gl, GL_CULL_FACE, !material.double_sided);
    if (m_any_emissive)
        set_texture(gl, GL_TEXTURE1, material.emissive, material.emissive.texture >= 0 && m_view.textures);
    set_texture(gl, GL_TEXTURE0, material.base,
                material.base.texture >= 0 && !geometry.base_coordinates.empty() && m_view.textures);
    toggle(gl, GL_ALPHA_TEST, material.alpha_cutoff > 0);
    gl.AlphaFunc(GL_GEQUAL, material.alpha_cutoff);
    toggle(gl, GL_BLEND, material.blended);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl.DepthMask(!material.blended);
}

void ModelDrawing::draw_part(const kit::Gl& gl, const Part& part) const {
    const Material& material = material_of(part);
    const Geometry& geometry = geometry_of(part);
    set_material(gl, material, geometry);
    gl.FrontFace(part.mirrored ? GL_CW : GL_CCW);
    gl.PushMatrix();
    gl.MultMatrixf(part.matrix);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.VertexPointer(3, GL_FLOAT, 0, geometry.positions.data());
    if (!geometry.normals.empty()) {
        gl.EnableClientState(GL_NORMAL_ARRAY);
        gl.NormalPointer(GL_FLOAT, 0, geometry.normals.data());
    }
    set_coordinates(gl, GL_TEXTURE1, geometry.emissive_coordinates);
    set_coordinates(gl, GL_TEXTURE0, geometry.base_coordinates);
    if (!geometry.colours.empty()) {
        gl.ColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
        gl.Enable(GL_COLOR_MATERIAL);
        gl.EnableClientState(GL_COLOR_ARRAY);
        gl.ColorPointer(4, GL_FLOAT, 0, geometry.colours.data());
    }
    const auto draw = [&] {
        gl.DrawElements(static_cast<GLenum>(geometry.mode), static_cast<GLsizei>(geometry.indices.size()),
                        GL_UNSIGNED_INT, geometry.indices.data());
    };
    if (material.blended && material.double_sided && has_faces(geometry)) {
        // What is seen through has its far side behind its near one.
        gl.Enable(GL_CULL_FACE);
        gl.CullFace(GL_FRONT);
        draw();
        gl.CullFace(GL_BACK);
    }
    draw();
    disable_arrays(gl);
    gl.Disable(GL_COLOR_MATERIAL);
    gl.PopMatrix();
}

// From the farthest to the nearest, as their boxes' middles lie; in the file's order where they are as far.
void ModelDrawing::draw_blended(const kit::Gl& gl) const {
    GLfloat m[16];
    gl.GetFloatv(GL_MODELVIEW_MATRIX, m);
    const bool parallel = camera() && !camera()->perspective;
    std::vector<std::pair<float, const Part*>> parts;
    for (const Part& part : m_model.parts) {
        if (!material_of(part).blended) continue;
        float squared = 0;
        for (std::size_t row = parallel ? 2 : 0; row < 3; ++row) {
            const float* c = part.centre;
            const float value = m[row] * c[0] + m[4 + row] * c[1] + m[8 + row] * c[2] + m[12 + row];
            squared += value * value;
        }
        parts.emplace_back(squared, &part);
    }
    std::stable_sort(parts.begin(), parts.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    for (const auto& [distance, part] : parts) draw_part(gl, *part);
}

void ModelDrawing::draw(const kit::Gl& gl, int frame) {
    gl.DepthMask(GL_TRUE);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    place_camera(gl, frame);
    for (const Part& part : m_model.parts)
        if (!material_of(part).blended) draw_part(gl, part);
    draw_blended(gl);
}

std::unique_ptr<kit::Drawing> create_drawing(Model model, int camera) {
    return std::make_unique<ModelDrawing>(std::move(model), camera);
}

}  // namespace terrazzo::gltf
