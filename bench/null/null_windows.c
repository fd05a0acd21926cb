// Windows of the GL that does nothing: GLX and EGL with one configuration, whose contexts are all current and
// whose pictures are never shown.
#define _GNU_SOURCE  // dladdr
#include <EGL/egl.h>
#include <GL/glx.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

#define EXPORT __attribute__((visibility("default")))

static int s_thing;  // whatever is asked for
static void* handle(void) {
    return &s_thing;
}

typedef void (*Function)(void);
static long nothing(void) {
    return 0;
}
static Function function_called(const char* name) {
    static void* self;
    Dl_info info;
    if (!self && dladdr((void*)&s_thing, &info)) self = dlopen(info.dli_fname, RTLD_NOW | RTLD_NOLOAD);
    Function found = self ? (Function)dlsym(self, name) : NULL;
    return found ? found : (Function)nothing;
}

EXPORT Function glXGetProcAddress(const GLubyte* name) {
    return function_called((const char*)name);
}
EXPORT Function glXGetProcAddressARB(const GLubyte* name) {
    return function_called((const char*)name);
}
EXPORT Bool glXQueryExtension(Display* display, int* error_base, int* event_base) {
    (void)display;
    if (error_base) *error_base = 0;
    if (event_base) *event_base = 0;
    return True;
}
EXPORT Bool glXQueryVersion(Display* display, int* major, int* minor) {
    (void)display;
    return *major = 1, *minor = 4, True;
}
EXPORT const char* glXQueryExtensionsString(Display* display, int screen) {
    return (void)display, (void)screen, "GLX_ARB_create_context GLX_ARB_create_context_profile";
}
EXPORT const char* glXGetClientString(Display* display, int name) {
    return (void)display, (void)name, "";
}
EXPORT const char* glXQueryServerString(Display* display, int screen, int name) {
    return (void)display, (void)screen, (void)name, "";
}
EXPORT XVisualInfo* glXChooseVisual(Display* display, int screen, int* attributes) {
    XVisualInfo wanted;
    int count;
    (void)attributes;
    wanted.visualid = XVisualIDFromVisual(DefaultVisual(display, screen));
    return XGetVisualInfo(display, VisualIDMask, &wanted, &count);
}
EXPORT XVisualInfo* glXGetVisualFromFBConfig(Display* display, GLXFBConfig config) {
    return (void)config, glXChooseVisual(display, DefaultScreen(display), NULL);
}
EXPORT GLXFBConfig* glXChooseFBConfig(Display* display, int screen, const int* attributes, int* count) {
    GLXFBConfig* configs = malloc(sizeof *configs);
    (void)display, (void)screen, (void)attributes;
    configs[0] = handle();
    return *count = 1, configs;
}
EXPORT GLXFBConfig* glXGetFBConfigs(Display* display, int screen, int* count) {
    return glXChooseFBConfig(display, screen, NULL, count);
}
EXPORT int glXGetFBConfigAttrib(Display* display, GLXFBConfig config, int attribute, int* value) {
    (void)config;
    *value = attribute == GLX_DOUBLEBUFFER || attribute == GLX_X_RENDERABLE ? 1 : 8;
    if (attribute == GLX_VISUAL_ID)
        *value = (int)XVisualIDFromVisual(DefaultVisual(display, DefaultScreen(display)));
    return 0;
}
EXPORT GLXContext glXCreateContext(Display* display, XVisualInfo* visual, GLXContext share, Bool direct) {
    return (void)display, (void)visual, (void)share, (void)direct, handle();
}
EXPORT GLXContext glXCreateNewContext(Display* display, GLXFBConfig config, int type, GLXContext share,
                                      Bool direct) {
    return (void)display, (void)config, (void)type, (void)share, (void)direct, handle();
}
EXPORT GLXContext glXCreateContextAttribsARB(Display* display, GLXFBConfig config, GLXContext share,
                                             Bool direct, const int* attributes) {
    return (void)display, (void)config, (void)share, (void)direct, (void)attributes, handle();
}
EXPORT Bool glXMakeCurrent(Display* display, GLXDrawable drawable, GLXContext context) {
    return (void)display, (void)drawable, (void)context, True;
}
EXPORT Bool glXMakeContextCurrent(Display* display, GLXDrawable draw, GLXDrawable read, GLXContext context) {
    return (void)display, (void)draw, (void)read, (void)context, True;
}
EXPORT Bool glXIsDirect(Display* display, GLXContext context) {
    return (void)display, (void)context, True;
}
EXPORT GLXPbuffer glXCreatePbuffer(Display* display, GLXFBConfig config, const int* attributes) {
    return (void)display, (void)config, (void)attributes, (GLXPbuffer)1;
}
EXPORT GLXWindow glXCreateWindow(Display* display, GLXFBConfig config, Window window, const int* attributes) {
    return (void)display, (void)config, (void)attributes, window;
}

EXPORT EGLDisplay eglGetDisplay(EGLNativeDisplayType native) {
    return (void)native, handle();
}
EXPORT EGLDisplay eglGetPlatformDisplay(EGLenum platform, void* native, const EGLAttrib* attributes) {
    return (void)platform, (void)native, (void)attributes, handle();
}
EXPORT EGLDisplay eglGetPlatformDisplayEXT(EGLenum platform, void* native, const EGLint* attributes) {
    return (void)platform, (void)native, (void)attributes, handle();
}
EXPORT EGLBoolean eglInitialize(EGLDisplay display, EGLint* major, EGLint* minor) {
    (void)display;
    if (major) *major = 1;
    if (minor) *minor = 5;
    return EGL_TRUE;
}
EXPORT EGLBoolean eglTerminate(EGLDisplay display) {
    return (void)display, EGL_TRUE;
}
EXPORT EGLint eglGetError(void) {
    return EGL_SUCCESS;
}
EXPORT EGLBoolean eglBindAPI(EGLenum api) {
    return (void)api, EGL_TRUE;
}
EXPORT const char* eglQueryString(EGLDisplay display, EGLint name) {
    if (name == EGL_EXTENSIONS)
        return display == EGL_NO_DISPLAY ? "EGL_EXT_platform_base EGL_EXT_platform_x11"
                                         : "EGL_KHR_create_context";
    return name == EGL_CLIENT_APIS ? "OpenGL OpenGL_ES" : name == EGL_VERSION ? "1.5" : "null";
}
EXPORT EGLBoolean eglChooseConfig(EGLDisplay display, const EGLint* attributes, EGLConfig* configs,
                                  EGLint size, EGLint* count) {
    (void)display, (void)attributes;
    if (configs && size > 0) configs[0] = handle();
    return *count = 1, EGL_TRUE;
}
EXPORT EGLBoolean eglGetConfigs(EGLDisplay display, EGLConfig* configs, EGLint size, EGLint* count) {
    return eglChooseConfig(display, NULL, configs, size, count);
}
EXPORT EGLBoolean eglGetConfigAttrib(EGLDisplay display, EGLConfig config, EGLint attribute, EGLint* value) {
    (void)display, (void)config;
    *value = 8;
    if (attribute == EGL_SURFACE_TYPE) *value = EGL_WINDOW_BIT | EGL_PBUFFER_BIT;
    if (attribute == EGL_RENDERABLE_TYPE) *value = EGL_OPENGL_BIT;
    if (attribute == EGL_NATIVE_VISUAL_ID) {
        Display* const x = XOpenDisplay(NULL);
        if (!x) return EGL_FALSE;
        *value = (EGLint)XVisualIDFromVisual(DefaultVisual(x, DefaultScreen(x)));
        XCloseDisplay(x);
    }
    return EGL_TRUE;
}
EXPORT EGLContext eglCreateContext(EGLDisplay display, EGLConfig config, EGLContext share,
                                   const EGLint* attributes) {
    return (void)display, (void)config, (void)share, (void)attributes, handle();
}
EXPORT EGLSurface eglCreateWindowSurface(EGLDisplay display, EGLConfig config, EGLNativeWindowType window,
                                         const EGLint* attributes) {
    return (void)display, (void)config, (void)window, (void)attributes, handle();
}
EXPORT EGLSurface eglCreatePlatformWindowSurface(EGLDisplay display, EGLConfig config, void* window,
                                                 const EGLAttrib* attributes) {
    return (void)display, (void)config, (void)window, (void)attributes, handle();
}
EXPORT EGLSurface eglCreatePbufferSurface(EGLDisplay display, EGLConfig config, const EGLint* attributes) {
    return (void)display, (void)config, (void)attributes, handle();
}
EXPORT EGLBoolean eglMakeCurrent(EGLDisplay display, EGLSurface draw, EGLSurface read, EGLContext context) {
    return (void)display, (void)draw, (void)read, (void)context, EGL_TRUE;
}
EXPORT EGLBoolean eglSwapBuffers(EGLDisplay display, EGLSurface surface) {
    return (void)display, (void)surface, EGL_TRUE;
}
EXPORT EGLBoolean eglSwapInterval(EGLDisplay display, EGLint interval) {
    return (void)display, (void)interval, EGL_TRUE;
}
EXPORT EGLBoolean eglDestroySurface(EGLDisplay display, EGLSurface surface) {
    return (void)display, (void)surface, EGL_TRUE;
}
EXPORT EGLBoolean eglDestroyContext(EGLDisplay display, EGLContext context) {
    return (void)display, (void)context, EGL_TRUE;
}
EXPORT Function eglGetProcAddress(const char* name) {
    return function_called(name);
}
