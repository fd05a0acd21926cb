// Names of scenes and model files on the command line -> arguments of the draw task.
#include "scene_arguments.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "study/scenes.h"

namespace terrazzo {

std::vector<std::string> study_scene_names() {
    std::vector<std::string> names;
    for (const study::SceneEntry& entry : study::scenes()) names.emplace_back(entry.name);
    return names;
}

void add_model_options(CLI::App& command, gltf::LoadOptions& options) {
    const auto limit = [&](const char* name, std::size_t& value, const char* what) {
        command.add_option(name, value, what)
            ->check(CLI::PositiveNumber)
            ->capture_default_str()
            ->group("Limits of model files");
    };
    command.add_option("--scene", options.scene, "The model's scene, from 0; its default scene if not given")
        ->check(CLI::NonNegativeNumber)
        ->group("Model files");
    limit("--max-pixels", options.limits.pixels, "Pixels of all images that are drawn with");
    limit("--max-vertices", options.limits.vertices, "Vertices of all meshes, and of all that a frame draws");
    limit("--max-bytes", options.limits.bytes, "Bytes that are read from files");
}

gltf::Model load_model_file(const std::string& path, const gltf::LoadOptions& options) {
    gltf::LoadedModel loaded = gltf::load_model(path, options);
    for (const std::string& note : loaded.notes) fmt::print(stderr, "terrazzo: {}: {}\n", path, note);
    return std::move(loaded.model);
}

SceneList load_scenes(const std::vector<std::string>& names, const gltf::LoadOptions& options) {
    const std::vector<std::string> known = study_scene_names();
    SceneList list;
    for (const std::string& name : names) {
        if (std::find(known.begin(), known.end(), name) != known.end()) {
            list.arguments.push_back({{"scene", name}});
        } else if (std::error_code error; std::filesystem::is_regular_file(name, error)) {
            list.models.emplace_back(gltf::pack(load_model_file(name, options)));
            const std::string title = std::filesystem::path(name).stem().string();
            list.arguments.push_back({{"scene", title}, {"model", list.models.back().path()}});
        } else {
            throw std::runtime_error("no scene or model file is called " + name);
        }
    }
    return list;
}

}  // namespace terrazzo
