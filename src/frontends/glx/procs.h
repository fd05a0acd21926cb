// GLX's functions by name, libglvnd's way to them, and the strings that say what there is.
#pragma once

#include <GL/glx.h>

#include "frontends/glx/glvnd_calls.h"
#include "frontends/window/procedure.h"

namespace terrazzo::glx {

using window::Function;
using window::Procedure;

// Null for what is no function of ours.
const Procedure* find_procedure(const char* name);

// What GLX_EXTENSIONS lists.
const char* extensions();

// GLX_MESA_query_renderer.
bool renderer_integer(int attribute, unsigned* value);
const char* renderer_string(int attribute);

}  // namespace terrazzo::glx
