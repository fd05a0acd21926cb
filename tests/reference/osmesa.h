// The reference library for tests that compare with it: Debian 12's libOSMesa.so.8, loaded at run time so
// that its gl* functions and ours never meet. TERRAZZO_REFERENCE_OSMESA names another file to load.
#pragma once

#include <GL/gl.h>
#include <GL/osmesa.h>

#include <string>
#include <vector>

namespace terrazzo::test {

class Osmesa {
  public:
    /// Loads the library, makes a context of width x height (RGBA of the type given, 24 + 8 bits of depth and
    /// stencil) current. Where that fails or the library is not the reference, missing() says why.
    Osmesa(int width, int height, GLenum type = GL_UNSIGNED_BYTE);
    ~Osmesa();
    Osmesa(const Osmesa&) = delete;
    Osmesa& operator=(const Osmesa&) = delete;

    const std::string& missing() const { return m_missing; }

    /// The buffer of a GL_FLOAT context, row 0 at the bottom; current after glFinish.
    const float* floats() const { return m_pixels.data(); }

    template <typename Function>
    Function* find(const char* name) const {
        return reinterpret_cast<Function*>(symbol(name));
    }

  private:
    void* symbol(const char* name) const;

    void* m_library = nullptr;
    OSMesaContext m_context = nullptr;
    std::vector<float> m_pixels;
    std::string m_missing;
};

}  // namespace terrazzo::test

/// A GL function of the reference, under its own name: TERRAZZO_GL(osmesa, glRotatef)(...).
#define TERRAZZO_GL(osmesa, name) ((osmesa).find<decltype(::name)>(#name))
