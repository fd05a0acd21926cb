// Stage: client side, a frame buffer object that takes a window's place, with renderbuffers like the window's
// buffers or multisampled ones. Input: a current context. Output: what is drawn goes to the object until it
// is shown. Invariant: the window's frame buffer is bound afterwards.
#pragma once

#include "offscreen.h"

namespace terrazzo::kit {

class ObjectInWindow {
  public:
    // Bound when it is made. `samples` of a pixel; 0: it is not multisampled.
    ObjectInWindow(const Gl& gl, const ContextOptions& window, int samples);
    void bind() const;
    // Its colours become the window's.
    void show() const;

  private:
    void attach(GLenum point, GLenum format) const;

    const Gl& m_gl;
    int m_width, m_height, m_samples;
    GLuint m_name = 0;
};

}  // namespace terrazzo::kit
