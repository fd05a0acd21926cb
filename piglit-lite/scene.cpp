// The registry of scenes.
#include "scene.h"

#include <algorithm>
#include <cstring>

namespace terrazzo::piglit {
namespace {

std::vector<Scene>& registry() {
    static std::vector<Scene> entries;
    return entries;
}

}  // namespace

Registration::Registration(const Scene& scene) {
    registry().push_back(scene);
}

const std::vector<Scene>& scenes() {
    // Files register in link order; the list is the same however the program is linked.
    static const bool sorted = [] {
        std::stable_sort(registry().begin(), registry().end(),
                         [](const Scene& a, const Scene& b) { return std::strcmp(a.file, b.file) < 0; });
        return true;
    }();
    (void)sorted;
    return registry();
}

const Scene* find_scene(const std::string& name) {
    for (const Scene& scene : scenes())
        if (name == scene.name) return &scene;
    return nullptr;
}

std::string chapter_of(const Scene& scene) {
    const std::string path = scene.file;
    const std::size_t from = path.rfind('/') + 1;
    return path.substr(from, path.rfind('.') - from);
}

}  // namespace terrazzo::piglit
