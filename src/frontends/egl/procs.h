// EGL's functions by name, libglvnd's way to them, and the extension strings.
#pragma once

#include <EGL/egl.h>

namespace terrazzo::egl {

using Function = void (*)();

struct Procedure {
    const char* name;
    Function address;
    // For functions of displays that libglvnd does not know by itself; see frontends/glx/procs.h.
    Function dispatch = nullptr;
    int* dispatch_index = nullptr;
};

// Null for what is no function of ours.
const Procedure* find_procedure(const char* name);

const char* client_extensions();
const char* platform_extensions();  // those of the client extensions that libglvnd leaves to vendors
const char* display_extensions();

}  // namespace terrazzo::egl
