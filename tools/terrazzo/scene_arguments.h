// Names of scenes on the command line -> arguments of the draw task.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace terrazzo {

// Throws std::runtime_error for a name that is neither a scene nor a file.
std::vector<nlohmann::json> scene_arguments(const std::vector<std::string>& names);
// T1..T6.
std::vector<std::string> study_scene_names();

}  // namespace terrazzo
