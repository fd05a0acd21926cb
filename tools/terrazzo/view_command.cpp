// terrazzo view: a model in a window.
//
// GLFW loads the libGL or libEGL that the loader finds, and the loader reads its environment once, when a
// program starts. So the command sets it as `terrazzo run` does and becomes itself, as a client of the
// system's OpenGL.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>

#include "commands.h"
#include "launch.h"
#include "report/pictures.h"
#include "scene_arguments.h"
#include "viewer.h"

namespace terrazzo {
namespace {

struct Options {
    ViewerOptions viewer;
    std::string size = "800x600";
    int threads = -1;
    bool system = false;
};

std::vector<std::string> own_arguments() {
    std::ifstream file("/proc/self/cmdline", std::ios::binary);
    std::vector<std::string> arguments;
    for (std::string argument; std::getline(file, argument, '\0');) arguments.push_back(argument);
    return arguments;
}

[[noreturn]] void start_anew(int threads) {
    std::vector<std::string> arguments = own_arguments();
    arguments.at(0) = std::filesystem::read_symlink("/proc/self/exe");
    arguments.insert(std::find(arguments.begin(), arguments.end(), "view") + 1, "--system");
    use_terrazzo(threads);
    become(arguments);
}

void set_size(ViewerOptions& viewer, const std::string& text) {
    int used = 0;
    const bool read = std::sscanf(text.c_str(), "%dx%d%n", &viewer.width, &viewer.height, &used) == 2;
    const auto fits = [](int length) { return length >= 1 && length <= 16384; };
    if (!read || used != static_cast<int>(text.size()) || !fits(viewer.width) || !fits(viewer.height))
        throw CLI::ValidationError("--size", text + " is not WIDTHxHEIGHT");
}

void run(Options& options) {
    set_size(options.viewer, options.size);
    if (!options.viewer.screenshot.empty()) report::check_picture_path(options.viewer.screenshot);
    if (!options.system) start_anew(options.threads);
    view(options.viewer);
}

}  // namespace

void add_view_command(CLI::App& app) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("view", "Show a glTF model in a window, drawn by Terrazzo");
    command->add_option("model", options->viewer.model, "A .gltf or .glb file")
        ->required()
        ->check(CLI::ExistingFile);
    command
        ->add_option("--camera", options->viewer.camera, "Seen by the model's camera of this number, from 0")
        ->check(CLI::NonNegativeNumber)
        ->group("Model files");
    add_model_options(*command, options->viewer.model_options);
    command->add_flag("--egl", options->viewer.egl, "Through EGL instead of GLX");
    command->add_option("--size", options->size, "Of the window: WIDTHxHEIGHT")->capture_default_str();
    command->add_flag("--fps", options->viewer.print_fps,
                      "As many frames as can be, their number printed every second");
    command->add_option("--frames", options->viewer.frames, "Draw so many frames, then end")
        ->check(CLI::PositiveNumber);
    command->add_option("--screenshot", options->viewer.screenshot,
                        "Write the last frame to this picture file");
    command
        ->add_option("-t,--threads", options->threads, "Threads that draw, the program's included; 0: as 1")
        ->check(CLI::Range(0, 64));
    command->add_flag("--system", options->system, "Drawn by the OpenGL that the system finds instead");
    command->footer(
        "Mouse: left button turns, right button shifts, wheel zooms.\n"
        "Keys: w wireframe, t textures, l lighting, c the model's next camera, s screenshot, q or Escape "
        "ends.\n"
        "What of the model cannot be drawn is said on standard error; doc/models.md tells what is drawn.");
    command->callback([options] { run(*options); });
}

}  // namespace terrazzo
