// Stage: models from files, drawn by fixed-function OpenGL 1.1: two lights, materials, one texture, arrays.
// Input: a Model, a View. Output: a frame. Invariant: the view of create_drawing is a fresh View's.
#pragma once

#include <vector>

#include "model.h"

namespace terrazzo::gltf {

// How a model is looked at. Angles are degrees.
struct View {
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
    explicit ModelDrawing(Model model);
    // Another frame turns the model by a degree.
    void prepare(const kit::Gl& gl, int width, int height) override;
    void draw(const kit::Gl& gl, int frame) override;

    // After prepare.
    void look(const kit::Gl& gl, const View& view, int width, int height);

  private:
    void set_projection(const kit::Gl& gl, int width, int height) const;
    void place_camera(const kit::Gl& gl, int frame) const;
    void set_material(const kit::Gl& gl, const Material& material, bool lit) const;
    void draw_part(const kit::Gl& gl, const Part& part) const;
    float distance() const;

    Model m_model;
    View m_view;
    std::vector<GLuint> m_textures;
};

}  // namespace terrazzo::gltf
