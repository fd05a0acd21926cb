// Names of scenes and model files on the command line -> arguments of the draw task.
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gltf/load_model.h"
#include "kit/shared_bytes.h"

namespace terrazzo {

// Models are loaded here, once; the children read the packed bytes for as long as this object lives.
struct SceneList {
    std::vector<nlohmann::json> arguments;
    std::vector<kit::SharedBytes> models;
};

// --scene and the limits; `options` must outlive the command.
void add_model_options(CLI::App& command, gltf::LoadOptions& options);

// What of the file is not drawn goes to standard error.
gltf::Model load_model_file(const std::string& path, const gltf::LoadOptions& options);

// Throws std::runtime_error for a name that is neither a scene nor a model file that can be drawn.
SceneList load_scenes(const std::vector<std::string>& names, const gltf::LoadOptions& options = {});
// T1..T6.
std::vector<std::string> study_scene_names();

}  // namespace terrazzo
