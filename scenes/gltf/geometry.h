// Stage: models from files, primitives. Input: a primitive, the sets of coordinates that its material wants,
// and how its node bends it. Output: a Geometry. Invariant: indices are below the vertex count, values
// finite, lists of one length.
#pragma once

#include <span>
#include <vector>

#include "accessors.h"
#include "materials.h"
#include "matrix.h"

namespace terrazzo::gltf {

struct Bending {
    std::vector<double> weights;  // of morph targets
    std::vector<Matrix> joints;   // of a skin; empty: none
};

// Throws std::runtime_error for what cannot be drawn; optional attributes that cannot be read have a note.
Geometry make_geometry(const tinygltf::Primitive& primitive, const Surface& surface, const Bending& bending,
                       const Accessors& accessors, Budget& vertices, Notes& notes);

// glTF 2.0 §3.7.2.1: triangles without normals are flat. Strips and fans become triangles.
void add_flat_normals(Geometry& geometry);

}  // namespace terrazzo::gltf
