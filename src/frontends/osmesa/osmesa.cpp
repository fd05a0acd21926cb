// The OSMesa API: contexts that draw into a buffer of the caller's.
#include <GL/osmesa.h>

#include <new>

#include "gl/context.h"
#include "gl/current.h"
#include "gl/entry.h"

struct osmesa_context {
    std::unique_ptr<terrazzo::gl::Context> gl;
};

OSMesaContext OSMesaCreateContextExt(GLenum, GLint depth_bits, GLint stencil_bits, GLint accum_bits,
                                     OSMesaContext share_list) try {
    auto context = std::make_unique<osmesa_context>();
    const terrazzo::gl::Config config{depth_bits, stencil_bits, accum_bits};
    context->gl = terrazzo::gl::create_context(config, share_list ? share_list->gl.get() : nullptr);
    return context.release();
} catch (const std::bad_alloc&) {
    return nullptr;
}

OSMesaContext OSMesaCreateContext(GLenum format, OSMesaContext share_list) {
    return OSMesaCreateContextExt(format, 24, 8, 0, share_list);
}

void OSMesaDestroyContext(OSMesaContext context) {
    delete context;
}

GLboolean OSMesaMakeCurrent(OSMesaContext context, void*, GLenum, GLsizei, GLsizei) {
    terrazzo::gl::make_current(context ? context->gl.get() : nullptr);
    return GL_TRUE;
}

OSMESAproc OSMesaGetProcAddress(const char* name) {
    return terrazzo::gl::find_proc_address(name);
}
