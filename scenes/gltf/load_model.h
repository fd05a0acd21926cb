// Stage: models from files. Input: a glTF 2.0 file, text or binary. Output: a Model, and sentences about what
// of the file is not drawn. Uses tinygltf for the document and OpenImageIO for its images.
// Invariant: whatever a file holds, loading ends with a Model or with an exception, within the limits.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model.h"

namespace terrazzo::gltf {

// What a file may ask for. The defaults are told by the commands' help and by doc/models.md.
struct Limits {
    std::size_t pixels = 64'000'000;    // of all images that are drawn with
    std::size_t vertices = 10'000'000;  // of all meshes, and again of all that a frame draws
    std::size_t bytes = 1'000'000'000;  // of all files that are read
};

struct LoadOptions {
    Limits limits;
    int scene = -1;  // -1: the file's default scene
};

struct LoadedModel {
    Model model;
    std::vector<std::string> notes;  // whole sentences
};

// Throws std::runtime_error, with the reason in words, for a file of which nothing can be drawn.
LoadedModel load_model(const std::string& path, const LoadOptions& options = {});

}  // namespace terrazzo::gltf
