// A GLFW program that asks for an OSMesa context: GLFW finds the library, the program asks GLFW for GL's
// commands. usage: window PICTURE. Exits with 77 when GLFW has no display.
#define GLFW_INCLUDE_NONE
#define GLFW_EXPOSE_NATIVE_OSMESA
#include <GLFW/glfw3.h>
// GLFW's native header includes osmesa.h, which needs gl.h; gl_table.h brings both GL headers.
#include <GLFW/glfw3native.h>

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

int draw_in(GLFWwindow* window, const char* path) {
    static unsigned char read[kPictureHeight][kPictureWidth][4];
    glfwMakeContextCurrent(window);
    if (glfwGetCurrentContext() != window) return EXIT_FAILURE;
    find_commands();
    draw_picture();
    gl.Finish();
    gl.ReadPixels(0, 0, kPictureWidth, kPictureHeight, GL_RGBA, GL_UNSIGNED_BYTE, read);

    // What GLFW answers is the same picture.
    int width = 0, height = 0, format = 0;
    void* shown = nullptr;
    if (!glfwGetOSMesaColorBuffer(window, &width, &height, &format, &shown)) return EXIT_FAILURE;
    if (width != kPictureWidth || height != kPictureHeight || format != OSMESA_RGBA ||
        std::memcmp(shown, read, sizeof read) != 0) {
        std::fprintf(stderr, "the window's buffer, %d x %d in %x, has another picture\n", width, height,
                     format);
        return EXIT_FAILURE;
    }
    glfwSwapBuffers(window);
    return hand_over(path, &read[0][0][0]);
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) return EXIT_FAILURE;
    glfwSetErrorCallback([](int, const char* text) { std::fprintf(stderr, "GLFW: %s\n", text); });
    if (!glfwInit()) return 77;
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_OSMESA_CONTEXT_API);
    glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
    GLFWwindow* const window = glfwCreateWindow(kPictureWidth, kPictureHeight, "Terrazzo", nullptr, nullptr);
    const int status = window ? draw_in(window, arguments[1]) : EXIT_FAILURE;
    glfwTerminate();
    return status;
}
