// The child of piglit-lite: draws one scene with one library and returns its planes and noted values.
// Links only libc and libstdc++ besides the library under test.
#include <cstdio>
#include <optional>
#include <stdexcept>

#include "kit/child.h"
#include "scene.h"

namespace {

using namespace terrazzo;

nlohmann::json binary(const void* data, std::size_t size) {
    const auto* bytes = static_cast<const std::uint8_t*>(data);
    return nlohmann::json::binary({bytes, bytes + size});
}

void clear_to_background(const kit::Gl& gl) {
    const float* colour = piglit::kBackground;
    gl.ClearColor(colour[0], colour[1], colour[2], colour[3]);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    gl.ClearColor(0, 0, 0, 0);
}

// A frame buffer object like the window, in its place while a scene is drawn.
class ObjectInWindow {
  public:
    ObjectInWindow(const kit::Gl& gl, const kit::ContextOptions& window)
        : m_gl(gl), m_width(window.width), m_height(window.height) {
        GLuint object;
        m_gl.GenFramebuffers(1, &object);
        m_gl.BindFramebuffer(GL_FRAMEBUFFER, object);
        attach(GL_COLOR_ATTACHMENT0, GL_RGBA8);
        if (window.depth_bits == 16 && window.stencil_bits == 0) {
            attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT16);
        } else {
            attach(GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8);
        }
    }
    // Its colours become the window's.
    void show() const {
        m_gl.Disable(GL_SCISSOR_TEST);
        m_gl.ReadBuffer(GL_COLOR_ATTACHMENT0);
        m_gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
        m_gl.BlitFramebuffer(0, 0, m_width, m_height, 0, 0, m_width, m_height, GL_COLOR_BUFFER_BIT,
                             GL_NEAREST);
        m_gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    }

  private:
    void attach(GLenum point, GLenum format) const {
        GLuint renderbuffer;
        m_gl.GenRenderbuffers(1, &renderbuffer);
        m_gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
        m_gl.RenderbufferStorage(GL_RENDERBUFFER, format, m_width, m_height);
        m_gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, renderbuffer);
    }

    const kit::Gl& m_gl;
    int m_width, m_height;
};

nlohmann::json draw(const nlohmann::json& arguments) {
    const auto name = arguments.at("scene").get<std::string>();
    const piglit::Scene* scene = piglit::find_scene(name);
    if (!scene) throw std::runtime_error("no scene is called " + name);
    const kit::Library library(arguments.at("library").get<std::string>());
    kit::ContextOptions options = scene->context;
    if (arguments.value("in_rgba", false)) options.format = OSMESA_RGBA;
    const kit::OffscreenContext context(library, options);
    std::optional<ObjectInWindow> object;
    if (arguments.value("in_object", false)) object.emplace(library.gl, options);
    clear_to_background(library.gl);
    piglit::Notes notes;
    scene->draw(library.gl, notes);
    nlohmann::json result{{"errors", nlohmann::json::array()}, {"values", nlohmann::json::array()}};
    for (const GLenum error : context.take_errors()) result["errors"].push_back(kit::error_name(error));
    for (const piglit::NotedValue& noted : notes.all())
        result["values"].push_back({noted.name, noted.value, noted.tolerance});
    const auto depth = context.read_depth();
    const auto stencil = context.read_stencil();
    if (object) object->show();
    library.gl.Finish();
    result["colour"] = binary(context.colour_buffer().data(), context.colour_buffer().size());
    result["depth"] = binary(depth.data(), depth.size() * sizeof(std::uint32_t));
    result["stencil"] = binary(stencil.data(), stencil.size());
    result["format"] = options.format;
    result["renderer"] = reinterpret_cast<const char*>(library.gl.GetString(GL_RENDERER));
    return result;
}

}  // namespace

int main(int argc, char** argv) {
    int exit_code = 0;
    if (terrazzo::kit::serve_child(argc, argv, {{"draw", draw}}, &exit_code)) return exit_code;
    std::fputs("piglit-lite-draw is started by piglit-lite.\n", stderr);
    return 2;
}
