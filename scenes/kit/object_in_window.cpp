// See object_in_window.h.
#include "object_in_window.h"

namespace terrazzo::kit {

ObjectInWindow::ObjectInWindow(const Gl& gl, const ContextOptions& window, int samples)
    : m_gl(gl), m_width(window.width), m_height(window.height), m_samples(samples) {
    m_gl.GenFramebuffers(1, &m_name);
    bind();
    attach(GL_COLOR_ATTACHMENT0, GL_RGBA8);
    if (window.depth_bits == 16 && window.stencil_bits == 0) {
        attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT16);
    } else {
        attach(GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8);
    }
}

void ObjectInWindow::bind() const {
    m_gl.BindFramebuffer(GL_FRAMEBUFFER, m_name);
}

void ObjectInWindow::show() const {
    m_gl.Disable(GL_SCISSOR_TEST);
    m_gl.ReadBuffer(GL_COLOR_ATTACHMENT0);
    m_gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    m_gl.BlitFramebuffer(0, 0, m_width, m_height, 0, 0, m_width, m_height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    m_gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
}

void ObjectInWindow::attach(GLenum point, GLenum format) const {
    GLuint renderbuffer;
    m_gl.GenRenderbuffers(1, &renderbuffer);
    m_gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    m_gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, m_samples, format, m_width, m_height);
    m_gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, renderbuffer);
}

}  // namespace terrazzo::kit
