// EGL's functions by name, libglvnd's way to them, and the extension strings.
#pragma once

#include <EGL/egl.h>

#include "frontends/window/procedure.h"

namespace terrazzo::egl {

using window::Function;
using window::Procedure;

// Null for what is no function of ours.
const Procedure* find_procedure(const char* name);

const char* client_extensions();
const char* platform_extensions();  // those of the client extensions that libglvnd leaves to vendors
const char* display_extensions();

}  // namespace terrazzo::egl
