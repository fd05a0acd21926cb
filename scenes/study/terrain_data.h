// T6's landscape: a height field of 256x256 cells and a texture that already carries its light.
#pragma once

#include "shapes.h"
#include "textures.h"

namespace terrazzo::study {

struct HeightField {
    Mesh mesh;    // 257x257 vertices (x-128, h, z-128), h in 0..3; 131072 triangles
    Image image;  // 1024x1024
};

HeightField make_height_field();

}  // namespace terrazzo::study
