// A window with a model in it: what `terrazzo view` shows. Uses GLFW, which finds the OpenGL library.
#pragma once

#include <string>

#include "gltf/load_model.h"

namespace terrazzo {

struct ViewerOptions {
    std::string model;
    int width = 800;
    int height = 600;
    bool egl = false;        // else GLX
    bool print_fps = false;  // and draw as many frames as can be
    int frames = 0;          // 0: until the user has seen enough
    std::string screenshot;  // of the last frame; empty: none
    int camera = -1;         // of the model; -1: the viewer's own
    gltf::LoadOptions model_options;
};

// Returns when the window is closed. Throws std::runtime_error without a display, an OpenGL library or a
// model.
void view(const ViewerOptions& options);

}  // namespace terrazzo
