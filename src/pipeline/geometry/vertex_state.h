// What a vertex goes through, as plain data (GL 1.5 chapter 2): made by src/gl/validate.cpp, used up by the
// draw it is passed to. Matrices are column-major as GL has them.
#pragma once

#include <array>
#include <cstdint>

#include "raster/fragment_state.h"

namespace terrazzo::pipeline {

inline constexpr int kMaxLights = 8;
inline constexpr int kMaxClipPlanes = 6;
using raster::kMaxTextureUnits;

// The light's colour times a material's: what one light gives to one face.
struct LitMaterial {
    float ambient[3], diffuse[3], specular[3];
};

struct Light {
    bool positional = false;
    bool spot = false;
    bool attenuated = false;  // only positional ones are
    float position[3];        // where it is; of a directional light the unit vector towards it
    float half_vector[3];     // of a directional light and a viewer at infinity, of unit length
    float direction[3];       // of a spot, of unit length
    float attenuation[3];     // constant, linear, quadratic
    float spot_exponent, spot_cos_cutoff;
    float ambient[3], diffuse[3], specular[3];
    LitMaterial lit[2];  // with the front and the back material
};

struct Material {
    float ambient[3], diffuse[4], specular[3], emission[3];
    float scene_color[3];  // model ambient * ambient + emission
    float shininess;
};

// Which material colours the vertex colour replaces (GL 1.5 §2.14.3).
struct ColorMaterial {
    bool ambient = false, diffuse = false, specular = false, emission = false;
};

// Positions and directions of lights are in the space that lighting happens in (see VertexState::eye_space).
struct Lighting {
    bool enabled = false;
    bool two_sided = false;
    bool local_viewer = false;
    bool separate_specular = false;
    bool no_shininess = false;  // the shininess is 0 for all vertices and faces
    float model_ambient[3] = {0.2f, 0.2f, 0.2f};
    int light_count = 0;
    std::array<Light, kMaxLights> lights;
    Material materials[2];  // front, back
    ColorMaterial color_material[2];
};

enum class TexgenMode : uint8_t { kOff, kObjectLinear, kEyeLinear, kSphereMap, kReflectionMap, kNormalMap };

struct TextureCoordinates {
    bool used = false;
    bool has_matrix = false;  // other than the identity
    float matrix[16];
    TexgenMode texgen[4] = {};
    float planes[4][4] = {};  // of the mode each coordinate uses
};

// Where a vertex's fog coordinate comes from (GL 1.5 §3.10, NV_fog_distance).
enum class FogDistance : uint8_t { kGiven, kEyePlane, kEyePlaneAbsolute, kEyeRadial };

enum class NormalScaling : uint8_t { kNone, kRescale, kNormalize };

struct VertexState {
    float mvp[16];
    float modelview[16];
    // Lighting happens in eye coordinates; otherwise in object coordinates, and normals are not transformed.
    // The reference's choice: it moves the last bits of colours.
    bool eye_space = true;
    bool fog_eye_z_alone = false;  // nothing before the fog coordinate needs all of the eye position
    float normal_matrix[9];        // columns of the inverse transpose's upper 3x3
    bool affine = false;           // the last row of mvp is 0 0 0 1
    float viewport_scale[3], viewport_translate[3];
    bool zero_to_one = false;  // the near plane is at clip z = 0, not at -w
    float snap_origin = 0.5f;  // what in a pixel sub-pixels are counted from: its centre, or 0 for its corner
    // At the near and the far plane; else the depths of fragments are clamped (ARB_depth_clamp).
    bool clips_depth = true;
    uint32_t clip_plane_mask = 0;               // bit p: plane p is enabled
    float clip_planes[kMaxClipPlanes][4] = {};  // in clip coordinates
    NormalScaling normal_scaling = NormalScaling::kNone;
    float rescale_factor = 1;
    Lighting lighting;
    bool edge_flags = false;  // polygons may be drawn unfilled
    FogDistance fog_distance = FogDistance::kEyePlaneAbsolute;
    // Each vertex has a point size of its own: point_size * 1/sqrt(a + b d + c d²), within the bounds.
    bool point_attenuated = false;
    float point_size = 1, point_size_min = 0, point_size_max = 255;
    float point_attenuation[3] = {1, 0, 0};
    std::array<TextureCoordinates, kMaxTextureUnits> texture;
    raster::Varyings varyings;
    bool interpolated_color = true;
};

}  // namespace terrazzo::pipeline
