// The window system's side of a context: what the render target looks like and how its picture is shown.
//
// The front end fills this in when it makes the context current. Flush and Finish draw what is queued and
// then call `present`, which copies the finished picture to wherever the window system wants it.
#pragma once

#include "pipeline/target.h"

namespace terrazzo::gl {

struct Context;

struct Surface {
    pipeline::RenderTargetDesc target_desc;
    void (*present)(Context&, void* front_end) = nullptr;
    void* front_end = nullptr;
};

}  // namespace terrazzo::gl
