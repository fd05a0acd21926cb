// The six scenes of the rasterization study [Frolov 2020 §4], as OpenGL 1.1 clients.
// Frame 0 is the study's own picture; other frames turn the models.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "kit/drawing.h"

namespace terrazzo::study {

// The study draws all scenes at this size.
inline constexpr int kWidth = 1024;
inline constexpr int kHeight = 1024;

struct SceneEntry {
    const char* name;
    const char* description;
    std::unique_ptr<kit::Drawing> (*create)();
};

const std::vector<SceneEntry>& scenes();
// Null for an unknown name.
std::unique_ptr<kit::Drawing> create_scene(std::string_view name);

}  // namespace terrazzo::study
