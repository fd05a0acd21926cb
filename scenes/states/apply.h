// Stage: client side, a state's settings as GL commands.
// Input: a state and a context at its defaults. Output: the context in that state. Invariant: each function
// sets the axes it names and nothing else; matrices are those of the eye, the model's is the identity.
#pragma once

#include "mesh_drawing.h"
#include "state.h"
#include "textures.h"

namespace terrazzo::states {

// View, lights, material, shading, clip planes: GL 1.5 §2.11-2.14.
void apply_vertex_state(const kit::Gl& gl, const State& state);
// Primitive's size and mode, culling, offset, fog: §3.3-3.5, §3.10.
void apply_raster_state(const kit::Gl& gl, const State& state);
// Alpha, blend, stencil, depth, masks: §4.1.
void apply_fragment_state(const kit::Gl& gl, const State& state);
void apply_masks(const kit::Gl& gl, const State& state);
void apply_stencil(const kit::Gl& gl, const State& state);
// Textures, environments, generated coordinates of every unit: §3.8, §2.11.4. Unit 0 has the axes' texture
// and texgen, the last one the axes' environment, the others plain textures. Returns unit 0's texture.
GLuint apply_textures(const kit::Gl& gl, const State& state);

Attributes attributes_of(const State& state);

// Column-major, from eye coordinates to the clip coordinates of a lamp that shadow maps are drawn from.
const float* lamp_projection();

}  // namespace terrazzo::states
