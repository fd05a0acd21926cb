// Stage: models from files. Input: a .gltf or .glb file. Output: a Model. Uses tinygltf for the file and
// OpenImageIO for its images.
#pragma once

#include <string>

#include "model.h"

namespace terrazzo::gltf {

// Throws std::runtime_error, with the reason in words, for a file that cannot be drawn.
Model load_model(const std::string& path);

}  // namespace terrazzo::gltf
