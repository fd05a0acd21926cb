// Lighting state (GL 1.5 §2.14, tables 6.11-6.14): lights, light model, materials, colour tracking, shade
// model.
//
// Positions and spot directions are kept in eye coordinates: they were transformed by the model-view matrix
// of the moment they were specified. Everything here is saved by glPushAttrib(GL_LIGHTING_BIT).
#pragma once

#include <GL/gl.h>

#include <array>

#include "gl/limits.h"

namespace terrazzo::gl {

struct Context;

using Color4 = std::array<GLfloat, 4>;

struct Light {
    bool enabled = false;
    Color4 ambient{0, 0, 0, 1};
    Color4 diffuse{0, 0, 0, 1};                       // white for light 0
    Color4 specular{0, 0, 0, 1};                      // white for light 0
    std::array<GLfloat, 4> eye_position{0, 0, 1, 0};  // w = 0: directional
    std::array<GLfloat, 3> eye_spot_direction{0, 0, -1};
    GLfloat spot_exponent = 0;
    GLfloat spot_cutoff = 180;  // degrees; 180 means no spot
    GLfloat constant_attenuation = 1;
    GLfloat linear_attenuation = 0;
    GLfloat quadratic_attenuation = 0;
};

struct Material {
    Color4 ambient{0.2f, 0.2f, 0.2f, 1};
    Color4 diffuse{0.8f, 0.8f, 0.8f, 1};
    Color4 specular{0, 0, 0, 1};
    Color4 emission{0, 0, 0, 1};
    GLfloat shininess = 0;
    std::array<GLfloat, 3> color_indexes{0, 1, 1};  // ambient, diffuse, specular
};

struct LightModel {
    Color4 ambient{0.2f, 0.2f, 0.2f, 1};
    bool local_viewer = false;
    bool two_side = false;
    GLenum color_control = GL_SINGLE_COLOR;
};

// While enabled, the parameter `mode` of the materials `face` follows the current colour.
struct ColorMaterial {
    bool enabled = false;
    GLenum face = GL_FRONT_AND_BACK;
    GLenum mode = GL_AMBIENT_AND_DIFFUSE;
};

struct LightingState {
    LightingState() { lights[0].diffuse = lights[0].specular = {1, 1, 1, 1}; }

    bool enabled = false;
    GLenum shade_model = GL_SMOOTH;
    std::array<Light, kMaxLights> lights;
    LightModel model;
    ColorMaterial color_material;
    Material front, back;
};

// While GL_COLOR_MATERIAL is enabled the tracked parameters are the current colour, and what is kept in
// `front` and `back` is stale. This brings them up to date: before they are read or saved, before tracking
// ends or changes.
void latch_color_material(Context& ctx);

}  // namespace terrazzo::gl
