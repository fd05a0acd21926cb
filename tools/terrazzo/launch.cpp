// The environment that makes a program load Terrazzo; exec.
#include "launch.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "places.h"

namespace terrazzo {
namespace {

void set(const char* name, const std::string& value) {
    setenv(name, value.c_str(), 1);
}

}  // namespace

// The plain libraries come first: they need no GLX in the server. What links libglvnd's own libGLX or libEGL
// finds the vendor libraries, which are the same file.
void use_terrazzo(int threads) {
    const std::string osmesa_folder = std::filesystem::path(own_library()).parent_path();
    std::string path = plain_folder() + ":" + vendor_folder() + ":" + osmesa_folder;
    if (const char* before = std::getenv("LD_LIBRARY_PATH"); before && *before)
        path += std::string(":") + before;
    set("LD_LIBRARY_PATH", path);
    set("__GLX_VENDOR_LIBRARY_NAME", "terrazzo");
    set("__EGL_VENDOR_LIBRARY_FILENAMES", vendor_description());
    if (threads >= 0) set("TERRAZZO_THREADS", std::to_string(threads));
}

void become(const std::vector<std::string>& arguments) {
    std::vector<char*> pointers;
    for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
    pointers.push_back(nullptr);
    execvp(pointers[0], pointers.data());
    const int error = errno;
    fmt::print(stderr, "terrazzo: {}: {}\n", arguments[0], std::strerror(error));
    _exit(error == ENOENT ? 127 : 126);
}

}  // namespace terrazzo
