// terrazzo draw: one scene with one library, as a picture.
#include <fmt/core.h>

#include <memory>

#include "commands.h"
#include "kit/child.h"
#include "places.h"
#include "report/pictures.h"
#include "rounds.h"
#include "scene_arguments.h"

namespace terrazzo {
namespace {

constexpr const char* kModelsFooter =
    "Of a model, what cannot be drawn is left out, and said on standard error; doc/models.md tells what is\n"
    "drawn. A file of which nothing can be drawn ends the command with exit code 1.";

struct Options {
    std::string scene = "T4";
    std::string library = "terrazzo";
    std::string output = "scene.png";
    int frame = 0;
    int threads = 0;
    int width = 1024;
    int height = 1024;
    int camera = -1;
    gltf::LoadOptions model;
};

void run(const Options& options) {
    // Said before anything is drawn, which may take a while.
    report::check_picture_path(options.output);
    const SceneList scenes = load_scenes({options.scene}, options.model);
    kit::ChildRequest request;
    request.executable = draw_program();
    request.task = "draw";
    request.arguments = scenes.arguments.front();
    request.arguments.update({{"library", parse_library(options.library).path},
                              {"frame", options.frame},
                              {"width", options.width},
                              {"height", options.height},
                              {"camera", options.camera},
                              {"picture", true}});
    request.environment = bench::thread_environment(options.threads);
    const kit::ChildReport child = kit::run_in_child(request);
    if (!child.finished())
        throw std::runtime_error(child.output.empty() ? child.message : child.message + "\n" + child.output);
    const std::vector<std::uint8_t>& colour = child.result["colour"].get_binary();
    report::write_picture(report::picture_of(colour, options.width, options.height, 4), options.output);
    fmt::print("{} by {}, first frame after {:.1f} ms\n", options.output,
               child.result["renderer"].get<std::string>(),
               child.result["first_frame_seconds"].get<double>() * 1e3);
    for (const auto& error : child.result["errors"]) fmt::print("GL error: {}\n", error.get<std::string>());
}

}  // namespace

void add_draw_command(CLI::App& app) {
    auto* command = app.add_subcommand("draw", "Draw one scene or glTF model into a picture file");
    auto options = std::make_shared<Options>();
    command->add_option("scene", options->scene, "T1..T6 or a .gltf or .glb file")->capture_default_str();
    command->add_option("-l,--library", options->library, "PATH, or the words terrazzo and osmesa")
        ->capture_default_str();
    command->add_option("-o,--output", options->output, "Picture file")->capture_default_str();
    command->add_option("-f,--frame", options->frame, "A model turns by a degree from frame to frame")
        ->capture_default_str();
    command->add_option("-t,--threads", options->threads, "Threads that draw; 0: the calling one alone")
        ->check(CLI::Range(0, 64))
        ->capture_default_str();
    command->add_option("--width", options->width)->check(CLI::Range(1, 16384))->capture_default_str();
    command->add_option("--height", options->height)->check(CLI::Range(1, 16384))->capture_default_str();
    command->add_option("--camera", options->camera, "Seen by the model's camera of this number, from 0")
        ->check(CLI::NonNegativeNumber)
        ->group("Model files");
    add_model_options(*command, options->model);
    command->footer(kModelsFooter);
    command->callback([options] { run(*options); });
}

}  // namespace terrazzo
