// Stage: client side, a state as something that is drawn frame by frame.
// Input: a state. Output: frames. Invariant: every frame is the same picture; what a frame changes beside the
// state (masks for clearing, passes of its own) is as before at its end.
#pragma once

#include "apply.h"
#include "kit/drawing.h"

namespace terrazzo::states {

inline constexpr float kBackground[4] = {0.30F, 0.35F, 0.42F, 0.8F};
// Where the lesser of two colours is kept.
inline constexpr float kLightBackground[4] = {0.95F, 0.97F, 1, 0.8F};

class StateDrawing : public kit::Drawing {
  public:
    explicit StateDrawing(const State& state) : m_state(state) {}
    void prepare(const kit::Gl& gl, int width, int height) override;
    void draw(const kit::Gl& gl, int frame) override;

  private:
    void prepare_texels(const kit::Gl& gl);
    void renew_texels(const kit::Gl& gl) const;
    void draw_helper(const kit::Gl& gl) const;
    void render_texels(const kit::Gl& gl) const;
    void copy_texels(const kit::Gl& gl) const;
    void clear(const kit::Gl& gl) const;
    void draw_stencil_mask(const kit::Gl& gl) const;
    void draw_depths(const kit::Gl& gl) const;
    void draw_backdrop(const kit::Gl& gl) const;
    void draw_shadow(const kit::Gl& gl) const;
    void begin_plain(const kit::Gl& gl) const;
    void end_plain(const kit::Gl& gl) const;

    State m_state;
    int m_width = 0, m_height = 0;
    MeshDrawing m_mesh;
    // What is drawn to textures.
    MeshDrawing m_helper;
    TextureKind m_kind;
    MovingTexels m_moving;
    GLuint m_texture = 0;
    GLuint m_object = 0;
    GLint m_window_object = 0;
};

}  // namespace terrazzo::states
