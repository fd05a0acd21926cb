// The list of the study's scenes.
#include "scenes.h"

#include "scene_classes.h"

namespace terrazzo::study {
namespace {

template <typename Scene>
std::unique_ptr<kit::Drawing> create() {
    return std::make_unique<Scene>();
}

}  // namespace

const std::vector<SceneEntry>& scenes() {
    static const std::vector<SceneEntry> entries{
        {"T1", "18 triangles: a coloured pyramid and a cube", create<PyramidAndCube>},
        {"T2", "8192 small random triangles, colours, 2D", create<RandomTriangles>},
        {"T3", "94 textured triangles: cubes and pyramids on a floor", create<CubesOnFloor>},
        {"T4", "4098 triangles: a textured teapot on a floor", create<OneTeapot>},
        {"T5", "36866 triangles: nine teapots on a floor", create<NineTeapots>},
        {"T6", "131072 triangles: a height field with baked light", create<Terrain>},
    };
    return entries;
}

std::unique_ptr<kit::Drawing> create_scene(std::string_view name) {
    for (const SceneEntry& entry : scenes())
        if (name == entry.name) return entry.create();
    return nullptr;
}

}  // namespace terrazzo::study
