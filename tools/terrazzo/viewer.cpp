// GLFW's window, the mouse that turns the model, keys, frames a second. The picture is gltf::ModelDrawing's.
#include "viewer.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <vector>

#include "gltf/model_drawing.h"
#include "kit/offscreen.h"
#include "report/pictures.h"
#include "scene_arguments.h"

namespace terrazzo {
namespace {

std::runtime_error glfw_failure(const std::string& what) {
    const char* text = nullptr;
    glfwGetError(&text);
    return std::runtime_error(text ? what + ": " + text : what);
}

class Glfw {
  public:
    Glfw() {
        if (!glfwInit()) throw glfw_failure("there is no display");
    }
    ~Glfw() { glfwTerminate(); }
    Glfw(const Glfw&) = delete;
    Glfw& operator=(const Glfw&) = delete;
};

GLFWwindow* create_window(const ViewerOptions& options, const std::string& title) {
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, options.egl ? GLFW_EGL_CONTEXT_API : GLFW_NATIVE_CONTEXT_API);
    // A picture of a certain size is wanted: no window manager may change it.
    glfwWindowHint(GLFW_RESIZABLE, options.frames == 0);
    GLFWwindow* const window =
        glfwCreateWindow(options.width, options.height, title.c_str(), nullptr, nullptr);
    if (!window) throw glfw_failure("no window for OpenGL");
    glfwMakeContextCurrent(window);
    glfwSwapInterval(options.print_fps || options.frames > 0 ? 0 : 1);
    return window;
}

kit::Gl load_commands() {
    kit::Gl gl{};
    for (const kit::GlCommand& command : kit::kGlCommands) {
        const auto address = glfwGetProcAddress(command.name);
        std::memcpy(reinterpret_cast<char*>(&gl) + command.offset, &address, sizeof address);
    }
    return gl;
}

class Viewer {
  public:
    explicit Viewer(const ViewerOptions& options)
        : m_options(options),
          m_title(std::filesystem::path(options.model).stem().string()),
          m_drawing(load_model_file(options.model, options.model_options), options.camera),
          m_window(create_window(options, m_title)),
          m_gl(load_commands()) {
        m_view.camera = options.camera;
        m_renderer = reinterpret_cast<const char*>(m_gl.GetString(GL_RENDERER));
        fmt::print("renderer: {}\n", m_renderer);
        std::fflush(stdout);
        glfwGetFramebufferSize(m_window, &m_width, &m_height);
        m_drawing.prepare(m_gl, m_width, m_height);
        listen();
    }

    void run() {
        m_second_start = glfwGetTime();
        for (int frame = 0; m_options.frames == 0 || frame < m_options.frames; ++frame) {
            show();
            count_frame();
            glfwPollEvents();
            if (glfwWindowShouldClose(m_window)) break;
        }
        if (!m_options.screenshot.empty()) save(m_options.screenshot);
        if (const GLenum error = m_gl.GetError()) throw std::runtime_error(kit::error_name(error));
    }

  private:
    void listen() {
        glfwSetWindowUserPointer(m_window, this);
        glfwSetKeyCallback(m_window, [](GLFWwindow* window, int key, int, int action, int) {
            if (action == GLFW_PRESS) of(window).on_key(key);
        });
        glfwSetScrollCallback(m_window,
                              [](GLFWwindow* window, double, double steps) { of(window).on_wheel(steps); });
        glfwSetCursorPosCallback(m_window,
                                 [](GLFWwindow* window, double x, double y) { of(window).on_mouse(x, y); });
        glfwSetFramebufferSizeCallback(m_window, [](GLFWwindow* window, int width, int height) {
            of(window).m_width = std::max(width, 1);
            of(window).m_height = std::max(height, 1);
            of(window).m_shown_at_size = 0;
        });
    }
    static Viewer& of(GLFWwindow* window) { return *static_cast<Viewer*>(glfwGetWindowUserPointer(window)); }

    void on_key(int key) {
        switch (key) {
            case GLFW_KEY_W:
                m_view.wireframe = !m_view.wireframe;
                break;
            case GLFW_KEY_T:
                m_view.textures = !m_view.textures;
                break;
            case GLFW_KEY_L:
                m_view.lighting = !m_view.lighting;
                break;
            case GLFW_KEY_C:  // after the last one, the viewer's own
                m_view.camera = m_view.camera + 1 < m_drawing.cameras() ? m_view.camera + 1 : -1;
                break;
            case GLFW_KEY_S:
                save_next();
                break;
            case GLFW_KEY_Q:
            case GLFW_KEY_ESCAPE:
                glfwSetWindowShouldClose(m_window, GLFW_TRUE);
                break;
            default:
                break;
        }
    }

    void on_wheel(double steps) {
        constexpr double kStep = 1.1;
        m_view.zoom = std::clamp(m_view.zoom * static_cast<float>(std::pow(kStep, steps)), 0.05F, 20.0F);
    }

    // The left button turns the model with the mouse, the others shift it.
    void on_mouse(double x, double y) {
        constexpr float kDegreesPerPixel = 0.4F;
        const auto right = static_cast<float>(x - m_mouse_x), down = static_cast<float>(y - m_mouse_y);
        m_mouse_x = x;
        m_mouse_y = y;
        const auto held = [&](int button) { return glfwGetMouseButton(m_window, button) == GLFW_PRESS; };
        if (held(GLFW_MOUSE_BUTTON_LEFT)) {
            m_view.turn = std::fmod(m_view.turn + kDegreesPerPixel * right, 360.0F);
            m_view.tilt = std::clamp(m_view.tilt + kDegreesPerPixel * down, -90.0F, 90.0F);
        } else if (held(GLFW_MOUSE_BUTTON_RIGHT) || held(GLFW_MOUSE_BUTTON_MIDDLE)) {
            // What the narrower side of the window shows at the model's centre.
            constexpr float kRadiiAcross = 2.27F;
            const float radii =
                kRadiiAcross / (m_view.zoom * static_cast<float>(std::min(m_width, m_height)));
            m_view.shift_x += radii * right;
            m_view.shift_y -= radii * down;
        }
    }

    void draw() {
        m_drawing.look(m_gl, m_view, m_width, m_height);
        m_drawing.draw(m_gl, 0);
    }

    void show() {
        draw();
        glfwSwapBuffers(m_window);
        ++m_shown_at_size;
    }

    void count_frame() {
        ++m_frames;
        const double now = glfwGetTime(), seconds = now - m_second_start;
        if (seconds < 1) return;
        const double fps = m_frames / seconds;
        glfwSetWindowTitle(m_window, fmt::format("{}: {:.0f} FPS, {}", m_title, fps, m_renderer).c_str());
        if (m_options.print_fps) {
            fmt::print("{:.1f} FPS\n", fps);
            std::fflush(stdout);
        }
        m_frames = 0;
        m_second_start = now;
    }

    // The first name that is free: a picture is never lost.
    void save_next() {
        std::string path;
        do path = fmt::format("{}-{}.png", m_title, ++m_saved);
        while (std::filesystem::exists(path));
        save(path);
        fmt::print("{}\n", path);
        std::fflush(stdout);
    }

    // Draws anew: what a swap leaves behind is undefined. A drawable has its window's new size after the
    // second swap at the latest.
    void save(const std::string& path) {
        while (m_shown_at_size < 2) show();
        draw();
        std::vector<std::uint8_t> pixels(static_cast<std::size_t>(m_width) *
                                         static_cast<std::size_t>(m_height) * 3);
        m_gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
        m_gl.ReadPixels(0, 0, m_width, m_height, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
        report::write_picture(report::picture_of(pixels, m_width, m_height, 3), path);
    }

    const ViewerOptions& m_options;
    Glfw m_glfw;
    std::string m_title, m_renderer;
    gltf::ModelDrawing m_drawing;
    gltf::View m_view;
    GLFWwindow* m_window;
    kit::Gl m_gl;
    int m_width = 0, m_height = 0;
    double m_mouse_x = 0, m_mouse_y = 0;
    double m_second_start = 0;
    int m_frames = 0, m_saved = 0;
    unsigned m_shown_at_size = 2;  // frames; the window is made with the size that it shows first
};

}  // namespace

void view(const ViewerOptions& options) {
    Viewer(options).run();
}

}  // namespace terrazzo
