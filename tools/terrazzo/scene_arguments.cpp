// Names of scenes on the command line -> arguments of the draw task.
#include "scene_arguments.h"

#include <algorithm>
#include <stdexcept>

#include "study/scenes.h"

namespace terrazzo {

std::vector<std::string> study_scene_names() {
    std::vector<std::string> names;
    for (const study::SceneEntry& entry : study::scenes()) names.emplace_back(entry.name);
    return names;
}

std::vector<nlohmann::json> scene_arguments(const std::vector<std::string>& names) {
    const std::vector<std::string> known = study_scene_names();
    std::vector<nlohmann::json> result;
    for (const std::string& name : names) {
        if (std::find(known.begin(), known.end(), name) == known.end())
            throw std::runtime_error("no scene is called " + name);
        result.push_back({{"scene", name}});
    }
    return result;
}

}  // namespace terrazzo
