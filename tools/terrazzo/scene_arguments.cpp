// Names of scenes and model files on the command line -> arguments of the draw task.
#include "scene_arguments.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "gltf/load_model.h"
#include "study/scenes.h"

namespace terrazzo {

std::vector<std::string> study_scene_names() {
    std::vector<std::string> names;
    for (const study::SceneEntry& entry : study::scenes()) names.emplace_back(entry.name);
    return names;
}

SceneList load_scenes(const std::vector<std::string>& names) {
    const std::vector<std::string> known = study_scene_names();
    SceneList list;
    for (const std::string& name : names) {
        if (std::find(known.begin(), known.end(), name) != known.end()) {
            list.arguments.push_back({{"scene", name}});
        } else if (std::filesystem::is_regular_file(name)) {
            list.models.emplace_back(gltf::pack(gltf::load_model(name)));
            const std::string title = std::filesystem::path(name).stem().string();
            list.arguments.push_back({{"scene", title}, {"model", list.models.back().path()}});
        } else {
            throw std::runtime_error("no scene or model file is called " + name);
        }
    }
    return list;
}

}  // namespace terrazzo
