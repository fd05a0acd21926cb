// terrazzo draw: one scene with one library, as a picture.
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <fmt/core.h>

#include <memory>

#include "commands.h"
#include "kit/child.h"
#include "places.h"
#include "rounds.h"
#include "scene_arguments.h"

namespace terrazzo {
namespace {

struct Options {
    std::string scene = "T4";
    std::string library = "terrazzo";
    std::string output = "scene.png";
    int frame = 0;
    int threads = 0;
    int width = 1024;
    int height = 1024;
};

void write_picture(const std::string& path, const std::vector<std::uint8_t>& rgba, int width, int height) {
    const OIIO::ImageSpec spec(width, height, 4, OIIO::TypeDesc::UINT8);
    const OIIO::ImageBuf bottom_up(spec, const_cast<std::uint8_t*>(rgba.data()));
    OIIO::ImageBuf picture = OIIO::ImageBufAlgo::channels(OIIO::ImageBufAlgo::flip(bottom_up), 3, {});
    if (!picture.write(path)) throw std::runtime_error(picture.geterror());
}

void run(const Options& options) {
    kit::ChildRequest request;
    request.executable = draw_program();
    request.task = "draw";
    request.arguments = scene_arguments({options.scene}).front();
    request.arguments.update({{"library", parse_library(options.library).path},
                              {"frame", options.frame},
                              {"width", options.width},
                              {"height", options.height},
                              {"planes", true}});
    request.environment = bench::thread_environment(options.threads);
    const kit::ChildReport report = kit::run_in_child(request);
    if (!report.finished()) throw std::runtime_error(report.message + "\n" + report.output);
    write_picture(options.output, report.result["colour"].get_binary(), options.width, options.height);
    fmt::print("{} by {}, first frame after {:.1f} ms\n", options.output,
               report.result["renderer"].get<std::string>(),
               report.result["first_frame_seconds"].get<double>() * 1e3);
    for (const auto& error : report.result["errors"]) fmt::print("GL error: {}\n", error.get<std::string>());
}

}  // namespace

void add_draw_command(CLI::App& app) {
    auto* command = app.add_subcommand("draw", "Draw one scene into a picture file");
    auto options = std::make_shared<Options>();
    command->add_option("scene", options->scene, "T1..T6 or a model file")->capture_default_str();
    command->add_option("-l,--library", options->library, "PATH, or the words terrazzo and osmesa")
        ->capture_default_str();
    command->add_option("-o,--output", options->output, "Picture file")->capture_default_str();
    command->add_option("-f,--frame", options->frame)->capture_default_str();
    command->add_option("-t,--threads", options->threads)->capture_default_str();
    command->add_option("--width", options->width)->check(CLI::Range(1, 16384))->capture_default_str();
    command->add_option("--height", options->height)->check(CLI::Range(1, 16384))->capture_default_str();
    command->callback([options] { run(*options); });
}

}  // namespace terrazzo
