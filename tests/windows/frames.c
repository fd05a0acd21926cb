// Three frames in a window whose primitives and pixels can be counted by hand, for `terrazzo run`.
// Exits with 77 when there is no display.
#include <GL/gl.h>
#include <GL/glx.h>

enum { kWidth = 160, kHeight = 120, kFrames = 3 };

static Window open_window(Display* display, XVisualInfo* visual) {
    const Window root = RootWindow(display, visual->screen);
    XSetWindowAttributes attributes = {.colormap = XCreateColormap(display, root, visual->visual, AllocNone)};
    const Window window = XCreateWindow(display, root, 0, 0, kWidth, kHeight, 0, visual->depth, InputOutput,
                                        visual->visual, CWColormap, &attributes);
    XMapWindow(display, window);
    return window;
}

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
// leave none: a rectangle behind, one beside the window, one that is seen from its back.
static void draw(int frame) {
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

int main(void) {
    Display* const display = XOpenDisplay(0);
    if (!display) return 77;
    int wanted[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_DEPTH_SIZE, 16, None};
    XVisualInfo* const visual = glXChooseVisual(display, DefaultScreen(display), wanted);
    if (!visual) return 1;
    const Window window = open_window(display, visual);
    const GLXContext context = glXCreateContext(display, visual, 0, True);
    if (!glXMakeCurrent(display, window, context)) return 1;
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, kWidth, 0, kHeight, -1, 1);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
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
