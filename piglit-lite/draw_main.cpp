// The child of piglit-lite: draws one scene with one library and returns its planes and noted values.
// Links only libc and libstdc++ besides the library under test.
#include <cstdio>
#include <optional>
#include <stdexcept>

#include "kit/child.h"
#include "kit/object_in_window.h"
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

nlohmann::json draw(const nlohmann::json& arguments) {
    const auto name = arguments.at("scene").get<std::string>();
    const piglit::Scene* scene = piglit::find_scene(name);
    if (!scene) throw std::runtime_error("no scene is called " + name);
    const kit::Library library(arguments.at("library").get<std::string>());
    kit::ContextOptions options = scene->context;
    if (arguments.value("in_rgba", false)) options.format = OSMESA_RGBA;
    const kit::OffscreenContext context(library, options);
    std::optional<kit::ObjectInWindow> object;
    if (arguments.value("in_object", false))
        object.emplace(library.gl, options, arguments.value("samples", 0));
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
