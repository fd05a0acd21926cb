/* Draws and swaps and asks its X server nothing, until that dies, and goes on. usage: dead_server WAY [HANDLER]
 *
 * WAY      glx, glx-single (drawn to the front and flushed), egl (Xlib's display), egl-single, or egl-xcb
 * HANDLER  of Xlib's for the end of a server: none (Xlib's own), jump (out of it, with longjmp), stay (it lets the program
 *          go on)
 * Prints "drawing" when the first pictures have been shown. Then, if it lives on after the server's end, what EGL says of
 * it, and how many refreshes went by in kMore more pictures: "gone on 0x300b 40". */
#define _GNU_SOURCE
#define EGL_EGLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glx.h>
#include <X11/Xlib-xcb.h>
#include <setjmp.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <xcb/xcb.h>

enum { kSize = 64, kFirst = 5, kMore = 40, kRefreshRate = 60 };

static Display* display;
static xcb_connection_t* connection;
static unsigned long window;
static EGLDisplay egl;
static EGLSurface surface;
static int single_buffered;
static jmp_buf before_the_end;

static int jump(Display* dead) {
    (void)dead;
    longjmp(before_the_end, 1);
}

static int take_note(Display* dead) {
    (void)dead;
    return 0;
}

static void stay(Display* dead, void* data) { (void)dead, (void)data; }

static int start_glx(void) {
    int list[] = {GLX_RGBA, GLX_RED_SIZE, 8, None, None};
    XVisualInfo* visual;
    XSetWindowAttributes attributes;
    if (!single_buffered) list[3] = GLX_DOUBLEBUFFER;
    visual = glXChooseVisual(display, DefaultScreen(display), list);
    if (!visual) return 0;
    memset(&attributes, 0, sizeof attributes);
    attributes.colormap = XCreateColormap(display, DefaultRootWindow(display), visual->visual, AllocNone);
    window = XCreateWindow(display, DefaultRootWindow(display), 0, 0, kSize, kSize, 0, visual->depth, InputOutput,
                           visual->visual, CWColormap | CWBorderPixel, &attributes);
    XMapWindow(display, window);
    return glXMakeCurrent(display, window, glXCreateContext(display, visual, NULL, True));
}

static int start_egl(void) {
    const EGLint list[] = {EGL_SURFACE_TYPE, EGL_WINDOW_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_RED_SIZE, 8, EGL_NONE};
    const EGLint kind[] = {EGL_RENDER_BUFFER, single_buffered ? EGL_SINGLE_BUFFER : EGL_BACK_BUFFER, EGL_NONE};
    EGLConfig config;
    EGLint count = 0;
    egl = display ? eglGetDisplay((EGLNativeDisplayType)display)
                  : eglGetPlatformDisplay(EGL_PLATFORM_XCB_EXT, connection, NULL);
    if (!eglInitialize(egl, NULL, NULL) || !eglBindAPI(EGL_OPENGL_API)) return 0;
    if (!eglChooseConfig(egl, list, &config, 1, &count) || count != 1) return 0;
    if (display) {
        window = XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, kSize, kSize, 0, 0, 0);
        XMapWindow(display, window);
        surface = eglCreateWindowSurface(egl, config, window, kind);
    } else {
        xcb_screen_t* const screen = xcb_setup_roots_iterator(xcb_get_setup(connection)).data;
        xcb_window_t id = xcb_generate_id(connection);
        xcb_create_window(connection, XCB_COPY_FROM_PARENT, id, screen->root, 0, 0, kSize, kSize, 0,
                          XCB_WINDOW_CLASS_INPUT_OUTPUT, screen->root_visual, 0, NULL);
        xcb_map_window(connection, id);
        surface = eglCreatePlatformWindowSurface(egl, config, &id, NULL);
    }
    return eglMakeCurrent(egl, surface, surface, eglCreateContext(egl, config, EGL_NO_CONTEXT, NULL));
}

/* 0 when the window system says that the picture reached nobody. */
static int show(int frame) {
    glClearColor((float)(frame & 1), 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    if (single_buffered) {
        glFlush();
        return egl == EGL_NO_DISPLAY || eglSwapBuffers(egl, surface);
    }
    if (egl != EGL_NO_DISPLAY) return eglSwapBuffers(egl, surface);
    glXSwapBuffers(display, window);
    return 1;
}

static long long refreshes(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec * (long long)kRefreshRate + now.tv_nsec * (long long)kRefreshRate / 1000000000;
}

int main(int argc, char** argv) {
    const char* const way = argc > 1 ? argv[1] : "";
    const char* const handler = argc > 2 ? argv[2] : "none";
    volatile int frame;
    volatile int was_told = 0;
    long long begin;
    // As programs do that outlive their server: libxcb writes to a socket that may have been closed.
    signal(SIGPIPE, SIG_IGN);
    single_buffered = strstr(way, "single") != NULL;
    if (!strcmp(way, "egl-xcb")) {
        connection = xcb_connect(NULL, NULL);
        if (xcb_connection_has_error(connection)) return 2;
    } else {
        display = XOpenDisplay(NULL);
        if (!display) return 2;
        connection = XGetXCBConnection(display);
        if (!strcmp(handler, "jump")) XSetIOErrorHandler(jump);
        if (!strcmp(handler, "stay")) {
            XSetIOErrorHandler(take_note);
            XSetIOErrorExitHandler(display, stay, NULL);
        }
    }
    if (!(strncmp(way, "egl", 3) ? start_glx() : start_egl())) return 3;
    for (frame = 0; frame < kFirst; ++frame)
        if (!show(frame)) return 4;
    puts("drawing");
    fflush(stdout);
    /* Without a handler that spares it, a program of Xlib's ends in this loop. Nothing but its swaps asks the server. */
    if (!setjmp(before_the_end)) {
        while (!was_told) was_told = !show(frame++) || (handler[0] == 's' && xcb_connection_has_error(connection));
    } else {
        was_told = 1;
    }
    begin = refreshes();
    printf("gone on 0x%x", egl == EGL_NO_DISPLAY ? 0 : (unsigned)eglGetError());
    if (handler[0] != 'j')
        for (frame = 0; frame < kMore; ++frame) show(frame);
    printf(" %lld\n", refreshes() - begin);
    return 0;
}
