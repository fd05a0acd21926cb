// Stage: client side, what a scene is to the tools that draw, compare and time it.
// Input: a GL function table with a current context. Output: one frame per draw() call.
// Invariant: the same frame number gives the same picture; draw() leaves the matrices and enables it sets as
// they are when it starts again.
#pragma once

#include "gl_table.h"

namespace terrazzo::kit {

class Drawing {
  public:
    virtual ~Drawing() = default;
    // Once per context: textures, lists, fixed state.
    virtual void prepare(const Gl& gl, int width, int height) = 0;
    // One frame, without the finish at its end.
    virtual void draw(const Gl& gl, int frame) = 0;
};

}  // namespace terrazzo::kit
