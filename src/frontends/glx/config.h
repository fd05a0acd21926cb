// GLX's frame buffer configurations and how programs choose among them (GLX 1.4 §3.3.3).
#pragma once

#include <GL/glx.h>

#include <optional>
#include <vector>

#include "frontends/x11/connection.h"
#include "frontends/x11/drawable.h"

// What a GLXFBConfig points at. Constant; lives as long as its display.
struct __GLXFBConfigRec {
    int id = 0;  // GLX_FBCONFIG_ID
    int screen = 0;
    terrazzo::x11::Visual visual;
    int alpha_bits = 0;
    int depth_bits = 0;
    int stencil_bits = 0;
    int accum_bits = 0;  // a component
    bool double_buffered = false;
    int samples = 0;  // of a pixel; 0: not multisampled

    terrazzo::raster::TargetFormat target_format() const;
    terrazzo::x11::BufferFormat buffer_format() const;
};

namespace terrazzo::glx {

using Config = __GLXFBConfigRec;

// All configurations of a screen, those that most programs want first. Each visual has one of its own as far
// as there are enough of them; `first_id` is the id of the first.
std::vector<Config> make_configs(const x11::Screen& screen, int number, int first_id);

// The value of an attribute that glXGetFBConfigAttrib and glXGetConfig know; empty for an unknown one.
std::optional<int> attribute(const Config& config, int name);

// The configurations that fit, best first. `list` is that of glXChooseFBConfig, null for an empty one. Empty
// as well when the list has an unknown attribute.
std::vector<const Config*> choose(const std::vector<Config>& configs, const int* list);

// The same for the list of glXChooseVisual, where some attributes have no value and others mean less.
std::vector<const Config*> choose_for_visual(const std::vector<Config>& configs, const int* list);

}  // namespace terrazzo::glx
