// terrazzo bench: frames per second, first frame and memory of scenes over libraries and thread counts.
#include <fmt/core.h>

#include <fstream>
#include <memory>

#include "commands.h"
#include "places.h"
#include "rounds.h"
#include "scene_arguments.h"

namespace terrazzo {
namespace {

struct Options {
    std::vector<std::string> scenes = study_scene_names();
    std::vector<std::string> libraries{"terrazzo", "osmesa"};
    std::vector<int> threads{0};
    std::string baseline;
    std::string json_path;
    bench::Plan plan;
    gltf::LoadOptions model;
    bool quiet = false;
};

void print_table(const std::vector<bench::SceneResult>& results, const std::string& baseline) {
    fmt::print("{:<10} {:<12} {:>7} {:>9} {:>8} {:>10} {:>9}\n", "scene", "library", "threads", "FPS",
               "ratio", "first, ms", "peak, MB");
    std::map<std::pair<std::string, int>, std::vector<double>> ratios;
    for (const bench::SceneResult& result : results)
        for (const bench::Measurement& m : result.measurements) {
            fmt::print("{:<10} {:<12} {:>7} ", result.scene, m.contender.label, m.contender.threads);
            if (!m.measured()) {
                fmt::print("failed: {}\n", m.failures.empty() ? "" : m.failures.front());
                continue;
            }
            const bench::Measurement* other = bench::partner(result, m, baseline);
            const double seconds = bench::median(m.frame_seconds);
            std::string ratio = "-";
            if (other && other != &m) {
                const double value = bench::median(other->frame_seconds) / seconds;
                ratio = fmt::format("{:.2f}x", value);
                ratios[{m.contender.label, m.contender.threads}].push_back(value);
            }
            fmt::print("{:>9.1f} {:>8} {:>10.1f} {:>9.1f}{}\n", 1 / seconds, ratio,
                       bench::median(m.first_frame_seconds) * 1e3, bench::median(m.peak_resident_kib) / 1024,
                       m.failures.empty() ? "" : "  GL error: " + m.failures.front());
        }
    for (const auto& [key, values] : ratios)
        fmt::print("geometric mean of {} with {} threads: {:.2f}x {}\n", key.first, key.second,
                   bench::geometric_mean(values), baseline);
}

void run(Options& options) {
    options.plan.draw_program = draw_program();
    const SceneList scenes = load_scenes(options.scenes, options.model);
    options.plan.scenes = scenes.arguments;
    for (const int threads : options.threads)
        for (const std::string& text : options.libraries) {
            const NamedLibrary library = parse_library(text);
            options.plan.contenders.push_back({library.label, library.path, threads});
        }
    const std::string baseline =
        options.baseline.empty() ? options.plan.contenders.back().label : options.baseline;
    const auto results = bench::run(options.plan, [&](const std::string& line) {
        if (!options.quiet) fmt::print(stderr, "{}\n", line);
    });
    const nlohmann::json json = bench::to_json(options.plan, results, baseline);
    if (options.json_path == "-") {
        fmt::print("{}\n", json.dump(2));
        return;
    }
    print_table(results, baseline);
    if (options.json_path.empty()) return;
    std::ofstream file(options.json_path);
    file << json.dump(2) << '\n';
    if (!file) throw std::runtime_error("cannot write " + options.json_path);
}

}  // namespace

void add_bench_command(CLI::App& app) {
    auto* command = app.add_subcommand("bench", "Compare the speed, first frame and memory of GL libraries");
    auto options = std::make_shared<Options>();
    command->add_option("scenes", options->scenes, "T1..T6 or model files")->capture_default_str();
    command
        ->add_option("-l,--library", options->libraries,
                     "A library: PATH, LABEL=PATH, or the words terrazzo and osmesa; give several")
        ->capture_default_str();
    command->add_option("-t,--threads", options->threads, "Rasterizer threads; 0 draws in the caller")
        ->delimiter(',')
        ->capture_default_str();
    command->add_option("--baseline", options->baseline,
                        "Label that ratios refer to; the last library if not given");
    command->add_option("-r,--rounds", options->plan.rounds, "Interleaved rounds")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command->add_option("-s,--seconds", options->plan.seconds, "Time of one measurement")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command->add_option("--width", options->plan.width)->check(CLI::Range(1, 16384))->capture_default_str();
    command->add_option("--height", options->plan.height)->check(CLI::Range(1, 16384))->capture_default_str();
    command->add_flag("--animate", options->plan.animate, "Turn the models from frame to frame");
    command
        ->add_option("--samples", options->plan.samples,
                     "Samples a pixel, in a frame buffer object that each frame is copied from")
        ->check(CLI::Range(0, 4));
    command->add_option("--json", options->json_path,
                        "Write the figures as JSON; - for standard output only");
    add_model_options(*command, options->model);
    command->add_flag("-q,--quiet", options->quiet, "No progress");
    add_states_command(*command);
    add_small_command(*command);
    command->callback([options, command] {
        if (command->get_subcommands().empty()) run(*options);
    });
}

}  // namespace terrazzo
