// A program that is done with OpenGL before it closes its display: the library was loaded by hand, used in a
// thread that has ended, and closed. usage: unload NAME
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <dlfcn.h>

#include <cstdio>
#include <thread>

int main(int argc, char** argv) {
    if (argc < 2) return 2;
    Display* const display = XOpenDisplay(nullptr);
    if (!display) return 2;
    for (int round = 0; round < 3; ++round) {
        void* const library = dlopen(argv[1], RTLD_NOW | RTLD_LOCAL);
        if (!library) return std::fprintf(stderr, "%s\n", dlerror()), 3;
        const auto choose =
            reinterpret_cast<XVisualInfo* (*)(Display*, int, int*)>(dlsym(library, "glXChooseVisual"));
        int list[] = {4 /* GLX_RGBA */, 0};
        std::thread([&] {
            if (XVisualInfo* const visual = choose(display, DefaultScreen(display), list)) XFree(visual);
        }).join();
        dlclose(library);
    }
    XCloseDisplay(display);
    std::puts("closed");
}
