// A program that is watched, or would be. usage: watched LIBRARY FRAMES [interrupted]
//
// It opens LIBRARY, an OSMesa, draws FRAMES frames of 512x512 pixels and breaks one rule of GL's, which
// TERRAZZO_DEBUG tells of. "interrupted": while a signal comes every millisecond. Prints "done", before that
// "privileged" if it has rights that its caller has not. It links nothing of OSMesa's: a privileged program's
// loader knows no LD_LIBRARY_PATH.
#include <GL/gl.h>
#include <GL/osmesa.h>
#include <dlfcn.h>
#include <signal.h>
#include <sys/auxv.h>
#include <sys/time.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

#ifdef __SANITIZE_ADDRESS__
// A leak checker looks at its process as a debugger does. Programs with their group's rights refuse that, and
// keep from their caller's settings, ASAN_OPTIONS among them, what stands in /proc.
extern "C" const char* __asan_default_options() {
    return "detect_leaks=0";
}
#endif

namespace {

constexpr int kSize = 512;

void interrupt_every_millisecond() {
    struct sigaction action = {};
    action.sa_handler = [](int) {};  // without SA_RESTART
    sigaction(SIGALRM, &action, nullptr);
    const itimerval every = {{0, 1000}, {0, 1000}};
    setitimer(ITIMER_REAL, &every, nullptr);
}

template <class Function>
Function* command(void* library, const char* name) {
    return reinterpret_cast<Function*>(dlsym(library, name));
}

}  // namespace

int main(int argc, char** argv) {
    void* const library = argc > 2 ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : nullptr;
    if (!library) {
        std::fprintf(stderr, "%s\n", argc > 2 ? dlerror() : "usage: watched LIBRARY FRAMES [interrupted]");
        return 2;
    }
    const auto clear_color = command<decltype(glClearColor)>(library, "glClearColor");
    const auto clear = command<decltype(glClear)>(library, "glClear");
    const auto finish = command<decltype(glFinish)>(library, "glFinish");
    std::vector<unsigned char> buffer(kSize * kSize * 4);
    const OSMesaContext context =
        command<decltype(OSMesaCreateContext)>(library, "OSMesaCreateContext")(OSMESA_RGBA, nullptr);
    if (!command<decltype(OSMesaMakeCurrent)>(library, "OSMesaMakeCurrent")(context, buffer.data(),
                                                                            GL_UNSIGNED_BYTE, kSize, kSize))
        return 3;
    if (argc > 3) interrupt_every_millisecond();
    for (int frame = 0; frame < std::atoi(argv[2]); ++frame) {
        clear_color(1, static_cast<float>(frame & 1), 0, 1);
        clear(GL_COLOR_BUFFER_BIT);
        finish();
        if (buffer[0] != 255) return 4;
    }
    command<decltype(glEnable)>(library, "glEnable")(GL_LINE);
    command<decltype(OSMesaDestroyContext)>(library, "OSMesaDestroyContext")(context);
    std::printf("%sdone\n", getauxval(AT_SECURE) ? "privileged " : "");
}
