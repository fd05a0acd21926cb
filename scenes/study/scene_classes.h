// The study's scenes as classes; set-ups follow [Frolov 2020 §4] and its program.
// Shared rule: LEQUAL depth test (none in T2), perspective-correct attributes, bilinear textures without
// mipmaps.
#pragma once

#include "kit/drawing.h"
#include "shapes.h"
#include "terrain_data.h"
#include "textures.h"

namespace terrazzo::study {

class PyramidAndCube final : public kit::Drawing {
  public:
    void prepare(const kit::Gl& gl, int width, int height) override;
    void draw(const kit::Gl& gl, int frame) override;
};

class RandomTriangles final : public kit::Drawing {
  public:
    RandomTriangles();
    void prepare(const kit::Gl& gl, int width, int height) override;
    void draw(const kit::Gl& gl, int frame) override;

  private:
    std::vector<float> m_positions;
    std::vector<float> m_colours;
};

class CubesOnFloor final : public kit::Drawing {
  public:
    void prepare(const kit::Gl& gl, int width, int height) override;
    void draw(const kit::Gl& gl, int frame) override;

  private:
    Mesh m_floor = make_floor(10, -4);
    Mesh m_cube = make_cube();
    Mesh m_pyramid = make_open_pyramid();
    GLuint m_textures[3] = {};
};

class OneTeapot final : public kit::Drawing {
  public:
    void prepare(const kit::Gl& gl, int width, int height) override;
    void draw(const kit::Gl& gl, int frame) override;

  private:
    Mesh m_teapot = make_teapot();
    Mesh m_floor = make_floor(3, 0);
    GLuint m_textures[2] = {};
};

class NineTeapots final : public kit::Drawing {
  public:
    void prepare(const kit::Gl& gl, int width, int height) override;
    void draw(const kit::Gl& gl, int frame) override;

  private:
    Mesh m_teapot = make_teapot();
    Mesh m_floor = make_floor(3, 0);
    GLuint m_textures[2] = {};
};

class Terrain final : public kit::Drawing {
  public:
    void prepare(const kit::Gl& gl, int width, int height) override;
    void draw(const kit::Gl& gl, int frame) override;

  private:
    HeightField m_field = make_height_field();
    GLuint m_texture = 0;
};

// Projection of the study: 45 degrees of vertical field of view.
void set_perspective(const kit::Gl& gl, double aspect, double near_plane, double far_plane);

}  // namespace terrazzo::study
