// Finds programs and libraries relative to the running command, so that a build tree can be moved.
#include "places.h"

#include <cstdlib>
#include <filesystem>

#include "places_config.h"

namespace terrazzo {
namespace {

namespace fs = std::filesystem;

fs::path command_folder() {
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error).parent_path();
}

// The build tree's file unless only the installed one is there.
std::string in_build_or_installed(const char* in_build, const char* installed) {
    const fs::path built = command_folder() / in_build, other = command_folder() / installed;
    std::error_code error;
    const bool use_installed = !fs::exists(built, error) && fs::exists(other, error);
    return (use_installed ? other : built).lexically_normal().string();
}

}  // namespace

std::string draw_program() {
    return in_build_or_installed(kDrawProgramInBuild, kDrawProgramInstalled);
}

std::string own_library() {
    if (const char* chosen = std::getenv("TERRAZZO_LIBRARY")) return chosen;
    return in_build_or_installed(kOwnLibraryInBuild, kOwnLibraryInstalled);
}

std::string reference_library() {
    if (const char* chosen = std::getenv("TERRAZZO_REFERENCE")) return chosen;
    return kReferenceLibrary;
}

std::string vendor_folder() {
    return in_build_or_installed(kVendorFolderInBuild, kVendorFolderInstalled);
}

std::string plain_folder() {
    return in_build_or_installed(kPlainFolderInBuild, kPlainFolderInstalled);
}

std::string vendor_description() {
    return in_build_or_installed(kVendorDescriptionInBuild, kVendorDescriptionInstalled);
}

NamedLibrary parse_library(const std::string& text) {
    const std::size_t equals = text.find('=');
    const std::string label = equals == std::string::npos ? text : text.substr(0, equals);
    const std::string path = equals == std::string::npos ? text : text.substr(equals + 1);
    if (path == "terrazzo") return {label, own_library()};
    if (path == "osmesa") return {label, reference_library()};
    return {equals == std::string::npos ? fs::path(path).stem().string() : label, path};
}

}  // namespace terrazzo
