// A GLFW program in a window: GLFW finds the library, the program asks GLFW for GL's commands. usage:
// window osmesa|glx|egl|glx-multisampled|egl-multisampled PICTURE. What GLFW or the X server shows must be
// what was read. Exits with 77 when GLFW has no display.
#define GLFW_INCLUDE_NONE
#define GLFW_EXPOSE_NATIVE_OSMESA
#define GLFW_EXPOSE_NATIVE_X11
#include <GLFW/glfw3.h>
// GLFW's native header includes osmesa.h, which needs gl.h; gl_table.h brings both GL headers.
#include <GLFW/glfw3native.h>
#include <X11/Xutil.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "gl_table.h"

namespace {

terrazzo::kit::Gl gl;

void find_commands() {
    for (const auto& command : terrazzo::kit::kGlCommands) {
        const auto address = glfwGetProcAddress(command.name);
        std::memcpy(reinterpret_cast<char*>(&gl) + command.offset, &address, sizeof address);
    }
}

}  // namespace

#define GL(name) gl.name
#include "picture.h"

namespace {

using Pixels = unsigned char[kPictureHeight][kPictureWidth][4];  // bottom row first

bool buffer_has(GLFWwindow* window, const Pixels& picture) {
    int width = 0, height = 0, format = 0;
    void* shown = nullptr;
    return glfwGetOSMesaColorBuffer(window, &width, &height, &format, &shown) && width == kPictureWidth &&
           height == kPictureHeight && format == OSMESA_RGBA &&
           std::memcmp(shown, picture, sizeof picture) == 0;
}

// What the server shows. Its window has 8 bits a component, red first, as on_display.py starts it.
bool read_screen(GLFWwindow* window, Pixels& picture) {
    Display* const display = glfwGetX11Display();
    XSync(display, 0);
    XImage* const image =
        XGetImage(display, glfwGetX11Window(window), 0, 0, kPictureWidth, kPictureHeight, AllPlanes, ZPixmap);
    if (!image) return false;
    for (int y = 0; y < kPictureHeight; ++y) {
        for (int x = 0; x < kPictureWidth; ++x) {
            const unsigned long value = XGetPixel(image, x, y);
            unsigned char* const rgba = picture[kPictureHeight - 1 - y][x];
            for (int c = 0; c < 3; ++c) rgba[c] = static_cast<unsigned char>(value >> (16 - 8 * c));
            rgba[3] = 255;
        }
    }
    XDestroyImage(image);
    return true;
}

bool screen_has(GLFWwindow* window, const Pixels& picture) {
    static Pixels screen;
    if (!read_screen(window, screen)) return false;
    int off = 0;
    for (int y = 0; y < kPictureHeight; ++y)
        for (int x = 0; x < kPictureWidth; ++x) off += std::memcmp(screen[y][x], picture[y][x], 3) != 0;
    if (off > 0) std::fprintf(stderr, "%d pixels of the screen are others\n", off);
    return off == 0;
}

int draw_in(GLFWwindow* window, bool multisampled, const char* path) {
    static Pixels read;
    glfwMakeContextCurrent(window);
    if (glfwGetCurrentContext() != window) return EXIT_FAILURE;
    find_commands();
    draw_picture();
    gl.Finish();
    gl.ReadPixels(0, 0, kPictureWidth, kPictureHeight, GL_RGBA, GL_UNSIGNED_BYTE, read);
    glfwSwapBuffers(window);
    // Mesa reads one sample of each pixel of such a window: what counts is what it shows.
    if (multisampled) return read_screen(window, read) ? hand_over(path, &read[0][0][0]) : EXIT_FAILURE;
    const bool osmesa = glfwGetWindowAttrib(window, GLFW_CONTEXT_CREATION_API) == GLFW_OSMESA_CONTEXT_API;
    if (!(osmesa ? buffer_has(window, read) : screen_has(window, read))) {
        std::fprintf(stderr, "the window has another picture\n");
        return EXIT_FAILURE;
    }
    return hand_over(path, &read[0][0][0]);
}

int creation_api(const char* name) {
    if (std::strncmp(name, "glx", 3) == 0) return GLFW_NATIVE_CONTEXT_API;
    return std::strncmp(name, "egl", 3) == 0 ? GLFW_EGL_CONTEXT_API : GLFW_OSMESA_CONTEXT_API;
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 3) return EXIT_FAILURE;
    glfwSetErrorCallback([](int, const char* text) { std::fprintf(stderr, "GLFW: %s\n", text); });
    if (!glfwInit()) return 77;
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, creation_api(arguments[1]));
    const bool multisampled = std::strstr(arguments[1], "-multisampled") != nullptr;
    glfwWindowHint(GLFW_SAMPLES, multisampled ? 4 : 0);
    glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
    GLFWwindow* const window = glfwCreateWindow(kPictureWidth, kPictureHeight, "Terrazzo", nullptr, nullptr);
    const int status = window ? draw_in(window, multisampled, arguments[2]) : EXIT_FAILURE;
    glfwTerminate();
    return status;
}
