// A library with one fault, for the test that the fuzzer finds faults: all functions are those of the library
// that it is linked with, but for one, which does what FAULT says first.
#include <GL/gl.h>
#include <dlfcn.h>

#include <cstdlib>
#include <cstring>
#include <string_view>

// Used by name, so that the linker keeps the library it is in.
extern "C" decltype(&glFlush) faulty_partner;
decltype(&glFlush) faulty_partner = &glFlush;

namespace {

std::string_view fault() {
    const char* const name = std::getenv("FAULT");
    return name ? name : "";
}

template <typename Type>
Type* real(const char* name, Type*) {
    return reinterpret_cast<Type*>(dlsym(RTLD_NEXT, name));
}

volatile char sink;
thread_local bool armed = false;

}  // namespace

extern "C" __attribute__((visibility("default"))) void glLoadMatrixf(const GLfloat* matrix) {
    if (matrix && fault() == "reads beyond") sink = reinterpret_cast<const char*>(matrix + 16)[0];
    real("glLoadMatrixf", glLoadMatrixf)(matrix);
}

extern "C" __attribute__((visibility("default"))) void glGetClipPlane(GLenum plane, GLdouble* equation) {
    if (equation && fault() == "writes before") equation[-1] = 1;
    real("glGetClipPlane", glGetClipPlane)(plane, equation);
}

// Only after another call.
extern "C" __attribute__((visibility("default"))) void glShadeModel(GLenum mode) {
    armed = mode == GL_FLAT;
    real("glShadeModel", glShadeModel)(mode);
}

extern "C" __attribute__((visibility("default"))) void glLineWidth(GLfloat width) {
    if (fault() == "hangs") {
        for (;;) sink = sink + 1;
    }
    if (fault() == "crashes in order" && armed && width > 1) std::abort();
    real("glLineWidth", glLineWidth)(width);
}

// An error that changes state all the same.
extern "C" __attribute__((visibility("default"))) void glPointSize(GLfloat size) {
    const auto set = real("glPointSize", glPointSize);
    if (fault() == "changes in spite of an error" && !(size > 0)) set(3);
    set(size);
}
