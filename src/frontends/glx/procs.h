// GLX's functions by name, libglvnd's way to them, and the strings that say what there is.
#pragma once

#include <GL/glx.h>

#include "frontends/glx/glvnd_calls.h"

namespace terrazzo::glx {

using Function = void (*)();

struct Procedure {
    const char* name;
    Function address;
    // For functions that libglvnd does not know by itself: the way from there to the vendor, and the number
    // that libglvnd has given the function. Null for others.
    Function dispatch = nullptr;
    int* dispatch_index = nullptr;
};

// Null for what is no function of ours.
const Procedure* find_procedure(const char* name);

// What GLX_EXTENSIONS lists.
const char* extensions();

// GLX_MESA_query_renderer.
bool renderer_integer(int attribute, unsigned* value);
const char* renderer_string(int attribute);

}  // namespace terrazzo::glx
