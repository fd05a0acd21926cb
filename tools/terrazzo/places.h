// Where the command finds its drawing program and the two libraries that it compares by default.
#pragma once

#include <string>

namespace terrazzo {

// Beside the command in a build tree, in libexec when installed.
std::string draw_program();
// Terrazzo's libOSMesa: TERRAZZO_LIBRARY, else the build tree's, else the installed one. May not exist yet.
std::string own_library();
// The system's libOSMesa: TERRAZZO_REFERENCE, else the one that the build found.
std::string reference_library();

// Where libglvnd's vendor libraries are, and the plain libGL, libOpenGL and libEGL; what describes the EGL vendor.
std::string vendor_folder();
std::string plain_folder();
std::string vendor_description();

// "LABEL=PATH" or "PATH"; the words "terrazzo" and "osmesa" stand for the two above.
struct NamedLibrary {
    std::string label;
    std::string path;
};
NamedLibrary parse_library(const std::string& text);

}  // namespace terrazzo
