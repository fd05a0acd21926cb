// terrazzo demo: T1-T6 and models through both libraries: pictures, differences, speed, first frame, memory;
// and the report, with what bench/windows/programs.py found out about programs with windows.
#include <OpenImageIO/imagebufalgo.h>
#include <fmt/core.h>
#include <unistd.h>

#include <filesystem>
#include <memory>

#include "commands.h"
#include "demo_report.h"
#include "kit/child.h"
#include "places.h"
#include "report/page.h"
#include "report/pictures.h"
#include "scene_arguments.h"
#include "study/scenes.h"

namespace terrazzo {
namespace {

namespace fs = std::filesystem;

struct Options {
    std::vector<std::string> models;
    std::string output = "out/demo";
    std::string ours = "terrazzo";
    std::string theirs = "osmesa";
    std::vector<int> threads{0, 1, 2};
    int size = 1024;
    int rounds = 3;
    double seconds = 0.4;
    bool pictures_only = false;
    std::string programs;
    gltf::LoadOptions model;
};

// Debian's assimp-testmodels; what is not there is left out.
std::vector<std::string> default_models() {
    const fs::path folder = "/usr/share/assimp/models";
    std::vector<std::string> found;
    for (const char* name :
         {"glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb",
          "glTF2/BoxTextured-glTF-Binary/BoxTextured.glb", "glTF2/ClearCoat-glTF/ClearCoatTest.gltf",
          "glTF2/textureTransform/TextureTransformTest.gltf", "glTF2/BoxTexcoords-glTF/boxTexcoords.gltf",
          "glTF2/glTF-Sample-Models/AnimatedMorphCube-glTF/AnimatedMorphCube.gltf"}) {
        std::error_code error;
        if (fs::exists(folder / name, error)) found.push_back((folder / name).string());
    }
    return found;
}

std::string description_of(const nlohmann::json& arguments) {
    for (const study::SceneEntry& entry : study::scenes())
        if (arguments.at("scene") == entry.name) return entry.description;
    return "a model from a file, lit by two fixed-function lights";
}

std::optional<OIIO::ImageBuf> picture(const Options& options, const nlohmann::json& scene,
                                      const std::string& library, const char* label, DemoScene& result) {
    kit::ChildRequest request;
    request.executable = draw_program();
    request.task = "draw";
    request.arguments = scene;
    request.arguments.update(
        {{"library", library}, {"width", options.size}, {"height", options.size}, {"planes", true}});
    request.environment = bench::thread_environment(0);
    const kit::ChildReport child = kit::run_in_child(request);
    if (!child.finished()) {
        result.failures.push_back(fmt::format("{}: {}", label, child.message));
        return std::nullopt;
    }
    for (const auto& error : child.result["errors"])
        result.failures.push_back(fmt::format("{}: {}", label, error.get<std::string>()));
    const std::vector<std::uint8_t>& colour = child.result["colour"].get_binary();
    return report::picture_of(colour, options.size, options.size, 4);
}

void compare(DemoScene& scene) {
    if (!scene.ours || !scene.theirs) return;
    constexpr float kOneStep = 1.5F / 255;
    const auto figures = OIIO::ImageBufAlgo::compare(*scene.ours, *scene.theirs, kOneStep, kOneStep);
    scene.pixels_off = figures.nfail;
    scene.largest_difference = figures.maxerror * 255;
}

std::vector<DemoScene> draw_scenes(const Options& options, const SceneList& list, const std::string& ours,
                                   const std::string& theirs) {
    std::vector<DemoScene> scenes;
    for (const nlohmann::json& arguments : list.arguments) {
        DemoScene scene;
        scene.name = arguments.at("scene").get<std::string>();
        scene.description = description_of(arguments);
        scene.ours = picture(options, arguments, ours, kOurs, scene);
        scene.theirs = picture(options, arguments, theirs, kTheirs, scene);
        compare(scene);
        fmt::print("{:<24} {} pixels off, largest difference {:.0f}/255{}\n", scene.name, scene.pixels_off,
                   scene.largest_difference,
                   scene.failures.empty() ? "" : "  FAILED: " + scene.failures.front());
        scenes.push_back(std::move(scene));
    }
    return scenes;
}

void measure(const Options& options, const SceneList& list, const std::string& ours,
             const std::string& theirs, std::vector<DemoScene>& scenes) {
    bench::Plan plan;
    plan.draw_program = draw_program();
    plan.scenes = list.arguments;
    plan.rounds = options.rounds;
    plan.seconds = options.seconds;
    plan.width = plan.height = options.size;
    for (const int threads : options.threads) {
        plan.contenders.push_back({kOurs, ours, threads});
        plan.contenders.push_back({kTheirs, theirs, threads});
    }
    const bool is_terminal = isatty(STDOUT_FILENO) != 0;
    std::vector<bench::SceneResult> results = bench::run(plan, [=](const std::string& line) {
        if (is_terminal) {
            fmt::print("\r\033[Kmeasuring {}", line);
        } else {
            fmt::print("measuring {}\n", line);
        }
        std::fflush(stdout);
    });
    if (is_terminal) fmt::print("\r\033[K");
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        scenes[i].speed = std::move(results[i]);
        for (const bench::Measurement& m : scenes[i].speed.measurements) {
            if (!m.measured() && !m.failures.empty())
                scenes[i].failures.push_back(m.contender.label + ": " + m.failures.front());
        }
    }
    report::write_text(options.output + "/figures.json", [&] {
        std::vector<bench::SceneResult> copies;
        for (const DemoScene& scene : scenes) copies.push_back(scene.speed);
        return bench::to_json(plan, copies, kTheirs).dump(2) + "\n";
    }());
}

void print_figures(const std::vector<DemoScene>& scenes) {
    fmt::print("{:<24} {:<10} {:>7} {:>9} {:>8} {:>10} {:>9}\n", "scene", "library", "threads", "FPS",
               "ratio", "first, ms", "peak, MB");
    for (const DemoScene& scene : scenes)
        for (const bench::Measurement& m : scene.speed.measurements) {
            if (!m.measured()) continue;
            const bench::Measurement* other = bench::partner(scene.speed, m, kTheirs);
            const double seconds = bench::median(m.frame_seconds);
            fmt::print("{:<24} {:<10} {:>7} {:>9.1f} {:>8} {:>10.1f} {:>9.1f}\n", scene.name,
                       m.contender.label, m.contender.threads, 1 / seconds,
                       other && other != &m
                           ? fmt::format("{:.2f}x", bench::median(other->frame_seconds) / seconds)
                           : "",
                       bench::median(m.first_frame_seconds) * 1e3, bench::median(m.peak_resident_kib) / 1024);
        }
}

void run(const Options& options) {
    const std::string ours = parse_library(options.ours).path, theirs = parse_library(options.theirs).path;
    if (!fs::exists(ours)) throw std::runtime_error("no library at " + ours + "; build it first");
    std::vector<std::string> names = study_scene_names();
    const std::vector<std::string> models = options.models.empty() ? default_models() : options.models;
    names.insert(names.end(), models.begin(), models.end());
    fs::create_directories(options.output);
    const SceneList list = load_scenes(names, options.model);

    std::vector<DemoScene> scenes = draw_scenes(options, list, ours, theirs);
    if (!options.pictures_only) {
        measure(options, list, ours, theirs, scenes);
        print_figures(scenes);
    }
    const DemoPrograms programs = options.programs.empty() ? DemoPrograms() : load_programs(options.programs);
    const std::string page = options.output + "/report.html", sheet = options.output + "/contact-sheet.png";
    report::write_text(page, demo_page(scenes, options.threads, programs));
    report::write_picture(demo_contact_sheet(scenes, programs), sheet);
    fmt::print("\n{}\n{}\n", page, sheet);
    for (const DemoScene& scene : scenes)
        if (!scene.failures.empty()) throw std::runtime_error(scene.name + ": " + scene.failures.front());
}

}  // namespace

void add_demo_command(CLI::App& app) {
    auto* command =
        app.add_subcommand("demo", "Draw T1-T6 and models through both libraries and write a report");
    auto options = std::make_shared<Options>();
    command->add_option("models", options->models,
                        "glTF or GLB files; Debian's test models if none is given");
    command->add_option("-o,--output", options->output, "Folder of the report")->capture_default_str();
    command->add_option("--ours", options->ours, "Library shown as Terrazzo")->capture_default_str();
    command->add_option("--theirs", options->theirs, "Library shown as OSMesa")->capture_default_str();
    command->add_option("-t,--threads", options->threads, "Rasterizer threads")
        ->delimiter(',')
        ->capture_default_str();
    command->add_option("--size", options->size, "Width and height")
        ->check(CLI::Range(16, 8192))
        ->capture_default_str();
    command->add_option("-r,--rounds", options->rounds)->check(CLI::PositiveNumber)->capture_default_str();
    command->add_option("-s,--seconds", options->seconds, "Time of one measurement")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command->add_option("--programs", options->programs,
                        "Folder of bench/windows/programs.py: programs with windows, for the report");
    add_model_options(*command, options->model);
    command->add_flag("--pictures-only", options->pictures_only, "No measurements");
    command->callback([options] { run(*options); });
}

}  // namespace terrazzo
