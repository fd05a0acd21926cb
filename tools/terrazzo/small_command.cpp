// terrazzo bench small: small pictures read back one by one, beside a baseline library.
#include <fmt/core.h>

#include <fstream>
#include <memory>

#include "commands.h"
#include "places.h"
#include "rounds.h"
#include "small_rounds.h"

namespace terrazzo {
namespace {

// Of values that differ: fragments at edges, and textures' roundings.
constexpr double kTolerated = 0.02;

struct Options {
    std::vector<std::string> libraries{"terrazzo", "osmesa"};
    std::vector<std::string> frames;
    std::string json_path;
    bench::SmallPlan plan;
    bool check = false;
};

void print_row(const bench::SmallPlan& plan, const bench::SmallRow& row) {
    fmt::print("{:<26}", row.frame.name());
    for (std::size_t i = 0; i < row.runs.size(); ++i) {
        fmt::print(" {:>10.2f}", row.runs[i].frame_seconds() * 1e6);
        if (i + 1 < row.runs.size())
            fmt::print(" {:>7.2f}x {:>7.3f}%", row.ratio(i), row.runs[i].differing * 100);
    }
    fmt::print("\n");
    for (std::size_t i = 0; i < row.runs.size(); ++i)
        for (const std::string& failure : row.runs[i].failures)
            fmt::print("  {}: {}\n", plan.contenders[i].label, failure);
    std::fflush(stdout);
}

void check(const bench::SmallPlan& plan, const std::vector<bench::SmallRow>& rows) {
    std::string problems;
    for (const bench::SmallRow& row : rows)
        for (std::size_t i = 0; i < row.runs.size(); ++i) {
            const std::string who = "\n  " + row.frame.name() + ", " + plan.contenders[i].label + ": ";
            for (const std::string& failure : row.runs[i].failures) problems += who + failure;
            if (row.runs[i].differing > kTolerated)
                problems += who + fmt::format("{:.2f} % of the values differ", row.runs[i].differing * 100);
        }
    if (!problems.empty()) throw std::runtime_error("small frames went wrong:" + problems);
    fmt::print("{} small frames drawn without an error, and alike\n", rows.size());
}

void run(Options& options) {
    bench::SmallPlan& plan = options.plan;
    plan.draw_program = draw_program();
    for (const std::string& text : options.libraries) {
        const NamedLibrary library = parse_library(text);
        plan.contenders.push_back({library.label, library.path});
    }
    plan.frames = small_frames::descriptions();
    if (!options.frames.empty()) plan.frames.clear();
    for (const std::string& name : options.frames)
        plan.frames.push_back(small_frames::Description::parse(name));
    fmt::print("{:<26}", "frame");
    for (std::size_t i = 0; i < plan.contenders.size(); ++i) {
        fmt::print(" {:>10}", plan.contenders[i].label + ", us");
        if (i + 1 < plan.contenders.size()) fmt::print(" {:>8} {:>8}", "x", "differs");
    }
    fmt::print("\n");
    const auto rows = bench::run_small(plan, [&](const bench::SmallRow& row) { print_row(plan, row); });
    for (std::size_t i = 0; i + 1 < plan.contenders.size(); ++i) {
        std::vector<double> ratios;
        for (const bench::SmallRow& row : rows)
            if (row.ratio(i) > 0) ratios.push_back(row.ratio(i));
        if (ratios.empty()) continue;
        fmt::print("geometric mean of {}: {:.2f}x {}\n", plan.contenders[i].label,
                   bench::geometric_mean(ratios), plan.contenders.back().label);
    }
    if (!options.json_path.empty()) {
        std::ofstream file(options.json_path);
        file << bench::to_json(plan, rows).dump(1) << '\n';
        if (!file) throw std::runtime_error("cannot write " + options.json_path);
    }
    if (options.check) check(plan, rows);
}

}  // namespace

void add_small_command(CLI::App& bench_command) {
    auto* command = bench_command.add_subcommand(
        "small", "Compare the speed of small pictures that are read back one by one");
    auto options = std::make_shared<Options>();
    command->add_option("frames", options->frames,
                        "CONTENT/SIZE/READOUT/PLACE, as in objects/84/rgb/samples; all if none is given");
    command
        ->add_option(
            "-l,--library", options->libraries,
            "A library: PATH, LABEL=PATH, or the words terrazzo and osmesa; the last is the baseline")
        ->capture_default_str();
    command->add_option("-t,--threads", options->plan.threads, "Threads that draw; 0: the calling one alone")
        ->check(CLI::Range(0, 64))
        ->capture_default_str();
    command->add_option("-r,--rounds", options->plan.rounds, "Interleaved rounds")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    command->add_option("-s,--seconds", options->plan.seconds, "The least time of one measurement")
        ->check(CLI::Range(0.0, 3600.0))
        ->capture_default_str();
    command->add_option("--json", options->json_path, "Write the figures as JSON");
    command->add_flag("--check", options->check,
                      "Fail when a frame has an error or is another picture than the baseline's");
    command->callback([options] { run(*options); });
}

}  // namespace terrazzo
