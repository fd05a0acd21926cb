// What showing a picture costs: frames that are drawn and swapped, against frames that are only drawn.
// usage: swap_cost WIDTH HEIGHT [FRAMES]; prints the renderer and two times in milliseconds a frame, drawn and swapped.
#define _POSIX_C_SOURCE 200809L
#include <GL/gl.h>
#include <GL/glx.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e3 * (double)t.tv_sec + 1e-6 * (double)t.tv_nsec;
}

static void draw(int frame) {
    glClearColor((float)(frame % 7) / 7, 0.2f, 0.3f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0, 0);
    glVertex2f(-0.5f, -0.5f);
    glColor3f(0, 1, 0);
    glVertex2f(0.5f, -0.5f);
    glColor3f(0, 0, 1);
    glVertex2f(0, 0.5f);
    glEnd();
}

int main(int argc, char** argv) {
    if (argc < 3) return 2;
    const unsigned width = (unsigned)atoi(argv[1]), height = (unsigned)atoi(argv[2]);
    const int frames = argc > 3 ? atoi(argv[3]) : 200;
    Display* display = XOpenDisplay(NULL);
    int wanted[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_DEPTH_SIZE, 24, None};
    XVisualInfo* visual = display ? glXChooseVisual(display, DefaultScreen(display), wanted) : NULL;
    if (!visual) return 77;
    XSetWindowAttributes attributes = {0};
    attributes.colormap = XCreateColormap(display, DefaultRootWindow(display), visual->visual, AllocNone);
    attributes.override_redirect = True;
    const Window window = XCreateWindow(display, DefaultRootWindow(display), 0, 0, width, height, 0, visual->depth,
                                        InputOutput, visual->visual,
                                        CWColormap | CWBorderPixel | CWOverrideRedirect, &attributes);
    XMapWindow(display, window);
    XSync(display, False);
    glXMakeCurrent(display, window, glXCreateContext(display, visual, NULL, True));
    printf("%s\n", (const char*)glGetString(GL_RENDERER));
    glEnable(GL_DEPTH_TEST);
    double times[2];
    for (int swap = 0; swap < 2; ++swap) {
        for (int i = -10; i < frames; ++i) {
            if (i == 0) times[swap] = now();
            draw(i + 10);
            glFinish();
            if (swap) glXSwapBuffers(display, window);
        }
        XSync(display, False);
        times[swap] = (now() - times[swap]) / frames;
    }
    printf("%.4f %.4f\n", times[0], times[1]);
    return 0;
}
