// Names of scenes and model files on the command line -> arguments of the draw task.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "kit/shared_bytes.h"

namespace terrazzo {

// Models are loaded here, once; the children read the packed bytes for as long as this object lives.
struct SceneList {
    std::vector<nlohmann::json> arguments;
    std::vector<kit::SharedBytes> models;
};

// Throws std::runtime_error for a name that is neither a scene nor a model file that can be drawn.
SceneList load_scenes(const std::vector<std::string>& names);
// T1..T6.
std::vector<std::string> study_scene_names();

}  // namespace terrazzo
