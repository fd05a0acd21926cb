// EGL's frame buffer configurations (EGL 1.5 §3.4).
#pragma once

#include <EGL/egl.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "frontends/x11/connection.h"
#include "raster/target/target.h"

namespace terrazzo::egl {

// What an EGLConfig points at. Constant; lives as long as its display.
struct Config {
    int id = 0;
    std::optional<x11::Visual> visual;  // none where there are only pbuffers
    raster::ColorFormat color = raster::ColorFormat::kRgba8;
    int red_bits = 8, green_bits = 8, blue_bits = 8, alpha_bits = 0;
    int depth_bits = 0, stencil_bits = 0;
    int samples = 0;  // of a pixel; 0: not multisampled

    raster::TargetFormat target_format() const;
    int surface_types() const;  // EGL_WINDOW_BIT ...
};

// `screen` is null for displays without one.
std::vector<Config> make_configs(const x11::Screen* screen);

// The value of an attribute of eglGetConfigAttrib; empty for an unknown one.
std::optional<int> attribute(const Config& config, int name);

// The list of eglChooseConfig, null for an empty one.
struct Choice {
    bool understood = false;             // no unknown attribute and no impossible value
    std::vector<const Config*> configs;  // best first
    std::uint32_t pixmap = 0;            // that they are to go with as well; 0: none
};
Choice choose(const std::vector<Config>& configs, const EGLint* list);

}  // namespace terrazzo::egl
