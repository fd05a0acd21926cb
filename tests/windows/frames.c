// Three frames whose primitives and pixels can be counted by hand, for `terrazzo run`: in a window, or,
// compiled with WITH_OSMESA, in memory. Exits with 77 when there is no display.
#include <GL/gl.h>
#ifdef WITH_OSMESA
#include <GL/osmesa.h>
#else
#include <GL/glx.h>
#endif

enum { kWidth = 160, kHeight = 120, kFrames = 3 };

#ifndef WITH_OSMESA
static Window open_window(Display* display, XVisualInfo* visual) {
    const Window root = RootWindow(display, visual->screen);
    XSetWindowAttributes attributes = {.colormap = XCreateColormap(display, root, visual->visual, AllocNone)};
    const Window window = XCreateWindow(display, root, 0, 0, kWidth, kHeight, 0, visual->depth, InputOutput,
                                        visual->visual, CWColormap, &attributes);
    XMapWindow(display, window);
    return window;
}
#endif

static void triangle(float x, float y, float width, float height, float z) {
    glBegin(GL_TRIANGLES);
    glVertex3f(x, y, z);
    glVertex3f(x + width, y, z);
    glVertex3f(x, y + height, z);
    glEnd();
}

static void rectangle(float x, float y, float width, float height, float z) {
    triangle(x, y, width, height, z);
    triangle(x + width, y + height, -width, -height, z);
}

// 110 x 60 red pixels, some in each of several bins, 20 x 10 green ones over them, and three things that
// leave none: a rectangle behind, one beside the window, one that is seen from its back. What is between them
// has a colour that 5, 6 and 5 bits keep as 8 bits do.
static void draw(int frame) {
    glClearColor(6 / 31.0f, 22 / 63.0f, 25 / 31.0f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glColor3f(1, 0, 0);
    rectangle(10 + frame, 20, 110, 60, 0);
    glColor3f(0, 1, 0);
    rectangle(50, 30, 20, 10, 0.5f);
    glColor3f(0, 0, 1);
    rectangle(50, 30, 20, 10, -0.5f);
    rectangle(-50, 30, 20, 10, 0.5f);
    rectangle(60, 30, -20, 10, 0.5f);
}

static void set_up(void) {
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, kWidth, 0, kHeight, -1, 1);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
}

#ifdef WITH_OSMESA
int main(void) {
    static unsigned char picture[kHeight][kWidth][4];
    const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 16, 0, 0, 0);
    if (!OSMesaMakeCurrent(context, picture, GL_UNSIGNED_BYTE, kWidth, kHeight)) return 1;
    set_up();
    for (int frame = 0; frame < kFrames; ++frame) {
        draw(frame);
        glFinish();
    }
    const GLenum error = glGetError();
    OSMesaDestroyContext(context);
    return error != GL_NO_ERROR;
}
#else
int main(void) {
    Display* const display = XOpenDisplay(0);
    if (!display) return 77;
    int wanted[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_DEPTH_SIZE, 16, None};
    XVisualInfo* const visual = glXChooseVisual(display, DefaultScreen(display), wanted);
    if (!visual) return 1;
    const Window window = open_window(display, visual);
    const GLXContext context = glXCreateContext(display, visual, 0, True);
    if (!glXMakeCurrent(display, window, context)) return 1;
    set_up();
    for (int frame = 0; frame < kFrames; ++frame) {
        draw(frame);
        glXSwapBuffers(display, window);
    }
    const GLenum error = glGetError();
    glXMakeCurrent(display, None, 0);
    glXDestroyContext(display, context);
    XDestroyWindow(display, window);
    XFree(visual);
    XCloseDisplay(display);
    return error != GL_NO_ERROR;
}
#endif
