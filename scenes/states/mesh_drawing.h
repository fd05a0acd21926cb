// Stage: client side, a mesh handed to GL in the ways programs do it.
// Input: a mesh, which attributes GL needs of it, the way. Output: draw calls. Invariant: only what the state
// reads is given, in the number of components a program would give.
#pragma once

#include "geometry.h"

namespace terrazzo::states {

struct Attributes {
    bool normals = false;
    GLenum colours = 0;  // GL_UNSIGNED_BYTE, GL_FLOAT; 0: none
    struct Unit {
        int components = 0;  // of its texture coordinates; 0: none are given
        bool direction = false;
    };
    std::array<Unit, 8> units;
};

class MeshDrawing {
  public:
    // Makes lists and buffers; `given` is one of states::Given.
    void prepare(const kit::Gl& gl, Mesh mesh, const Attributes& attributes, GLenum given);
    void draw(const kit::Gl& gl) const;

  private:
    void make_buffers(const kit::Gl& gl);
    void set_arrays(const kit::Gl& gl, bool enabled) const;
    void draw_arrays(const kit::Gl& gl) const;
    void draw_elements(const kit::Gl& gl, const GLuint* indices) const;
    void draw_immediate(const kit::Gl& gl) const;
    void draw_buffers(const kit::Gl& gl) const;
    const Vertex* base() const;

    Mesh m_mesh;
    Attributes m_attributes;
    GLenum m_given = 0;
    GLuint m_list = 0;
    GLuint m_buffers[2] = {};
};

}  // namespace terrazzo::states
