// Stage: models from files, drawn by fixed-function OpenGL 1.3: two lights, materials, two texture units,
// arrays. Input: a Model, a View. Output: a frame. Invariant: the view of create_drawing is a fresh View's,
// but for its camera.
#pragma once

#include <vector>

#include "model.h"

namespace terrazzo::gltf {

// How a model is looked at. Angles are degrees.
struct View {
    int camera = -1;  // one of the model's; -1: the view that the next ones say
    float turn = -35;
    float tilt = 22;                 // from above
    float zoom = 1;                  // 1: the whole model fits
    float shift_x = 0, shift_y = 0;  // the model's place in the picture, in its radius
    bool wireframe = false;
    bool textures = true;
    bool lighting = true;
};

class ModelDrawing final : public kit::Drawing {
  public:
    // Throws std::runtime_error when the model has no such camera.
    explicit ModelDrawing(Model model, int camera = -1);
    // Another frame turns the model by a degree.
    void prepare(const kit::Gl& gl, int width, int height) override;
    void draw(const kit::Gl& gl, int frame) override;

    // After prepare.
    void look(const kit::Gl& gl, const View& view, int width, int height);
    int cameras() const { return static_cast<int>(m_model.cameras.size()); }

  private:
    const Camera* camera() const;
    void set_projection(const kit::Gl& gl, int width, int height) const;
    void place_camera(const kit::Gl& gl, int frame) const;
    void set_surface(const kit::Gl& gl, const Material& material) const;
    void set_texture(const kit::Gl& gl, GLenum unit, const TextureUse& use, bool on) const;
    void set_material(const kit::Gl& gl, const Material& material, const Geometry& geometry) const;
    void draw_part(const kit::Gl& gl, const Part& part) const;
    void draw_blended(const kit::Gl& gl) const;
    const Material& material_of(const Part& part) const;
    const Geometry& geometry_of(const Part& part) const;
    float distance() const;

    Model m_model;
    View m_view;
    std::vector<GLuint> m_textures;
    bool m_any_emissive = false;
};

}  // namespace terrazzo::gltf
