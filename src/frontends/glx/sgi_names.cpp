// Functions of extensions that GLX 1.3 took in under new names.
#include <GL/glx.h>

GLXFBConfigSGIX* glXChooseFBConfigSGIX(Display* display, int screen, int* attributes, int* count) {
    return glXChooseFBConfig(display, screen, attributes, count);
}

int glXGetFBConfigAttribSGIX(Display* display, GLXFBConfigSGIX config, int attribute, int* value) {
    return glXGetFBConfigAttrib(display, config, attribute, value);
}

GLXPixmap glXCreateGLXPixmapWithConfigSGIX(Display* display, GLXFBConfigSGIX config, Pixmap pixmap) {
    return glXCreatePixmap(display, config, pixmap, nullptr);
}

// The extension names the same type by another number.
GLXContext glXCreateContextWithConfigSGIX(Display* display, GLXFBConfigSGIX config, int render_type,
                                          GLXContext share_list, Bool direct) {
    return glXCreateNewContext(display, config, render_type, share_list, direct);
}

XVisualInfo* glXGetVisualFromFBConfigSGIX(Display* display, GLXFBConfigSGIX config) {
    return glXGetVisualFromFBConfig(display, config);
}

void glXSelectEventSGIX(Display* display, GLXDrawable drawable, unsigned long mask) {
    glXSelectEvent(display, drawable, mask);
}

void glXGetSelectedEventSGIX(Display* display, GLXDrawable drawable, unsigned long* mask) {
    glXGetSelectedEvent(display, drawable, mask);
}

Bool glXMakeCurrentReadSGI(Display* display, GLXDrawable draw, GLXDrawable read, GLXContext context) {
    return glXMakeContextCurrent(display, draw, read, context);
}

GLXDrawable glXGetCurrentReadDrawableSGI() {
    return glXGetCurrentReadDrawable();
}

Display* glXGetCurrentDisplayEXT() {
    return glXGetCurrentDisplay();
}
