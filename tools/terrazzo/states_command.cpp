// terrazzo bench states: the speed and the pictures of states along axes, beside a baseline library.
#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <regex>

#include "commands.h"
#include "parts_report.h"
#include "places.h"
#include "report/page.h"
#include "report/pictures.h"
#include "state_summary.h"
#include "states_report.h"

namespace terrazzo {
namespace {

using bench::StateRow;

// What --check accepts: see doc/benchmarks.md.
constexpr double kTolerated = 0.02;

struct Options {
    std::vector<std::string> libraries{"terrazzo", "osmesa"};
    std::vector<std::string> isas;
    std::vector<std::string> given_states;
    std::string filter;
    std::string clock;
    std::string json_path, html_path, pictures, parts_path;
    bench::StatePlan plan;
    int size = 512;
    int random = 0;
    std::uint64_t seed = 1;
    int samples = 0;
    bool only_random = false, smoke = false, check = false, list = false, quiet = false;
};

bench::TimeKind time_kind(const Options& options) {
    const bool is_cpu = options.clock.empty() ? options.plan.threads <= 1 : options.clock == "cpu";
    return is_cpu ? bench::TimeKind::kCpu : bench::TimeKind::kWall;
}

std::vector<states::NamedState> chosen_states(const Options& options) {
    std::vector<states::NamedState> chosen, all;
    for (const std::string& text : options.given_states)
        all.push_back({"given/" + std::to_string(all.size()), states::settled(states::State::parse(text))});
    if (!options.only_random && options.given_states.empty()) all = states::named_states();
    for (states::NamedState& state : states::random_states(options.random, options.seed))
        all.push_back(std::move(state));
    std::regex filter;
    try {
        filter = std::regex(options.filter);
    } catch (const std::regex_error&) {
        throw std::runtime_error("--filter is no regular expression: " + options.filter);
    }
    const states::AxisEntry& samples = states::entry(states::Axis::kSamples);
    for (states::NamedState& state : all) {
        if (!std::regex_search(state.name, filter)) continue;
        if (options.samples)
            for (std::size_t i = 0; i < samples.values.size(); ++i)
                if (samples.values[i].numbers[0] == static_cast<GLenum>(options.samples))
                    state.state = states::settled(state.state.set(samples.axis, i));
        chosen.push_back(std::move(state));
    }
    if (chosen.empty()) throw std::runtime_error("no state is called " + options.filter);
    return chosen;
}

std::vector<bench::StateContender> contenders(const Options& options) {
    std::vector<bench::StateContender> result;
    for (std::size_t i = 0; i < options.libraries.size(); ++i) {
        const NamedLibrary library = parse_library(options.libraries[i]);
        const bool is_baseline = i + 1 == options.libraries.size();
        if (is_baseline || options.isas.empty()) {
            result.push_back({library.label, library.path, ""});
            continue;
        }
        for (const std::string& isa : options.isas)
            result.push_back({library.label + " " + isa, library.path, isa});
    }
    if (result.size() < 2)
        throw std::runtime_error("two libraries are compared: -l A -l B, the last is the baseline");
    return result;
}

void print_row(const StateRow& row, bench::TimeKind kind) {
    fmt::print("{:<52}", row.state.name);
    for (std::size_t i = 0; i + 1 < row.runs.size(); ++i) {
        const bench::StateRun& run = row.runs[i];
        const std::string share = run.difference ? fmt::format("{:.3f}%", run.difference->share * 100) : "-";
        fmt::print(" {:>9.3f} {:>6.2f}x {:>8}", bench::frame_seconds(run, kind) * 1e3,
                   bench::ratio(row, i, kind), share);
    }
    fmt::print(" {:>9.3f}\n", bench::frame_seconds(row.runs.back(), kind) * 1e3);
}

void print_header(const bench::StatePlan& plan) {
    fmt::print("{:<52}", "state");
    for (std::size_t i = 0; i + 1 < plan.contenders.size(); ++i)
        fmt::print(" {:>26}", plan.contenders[i].label + ": ms, x, differs");
    fmt::print(" {:>9}\n", plan.contenders.back().label + ", ms");
}

std::string title_of(const bench::StatePlan& plan, const bench::Population& population) {
    if (population.name != "random") return population.name + " states";
    return fmt::format("random states, seed {}", plan.seed);
}

void print_summary(const bench::StatePlan& plan, const bench::Population& population, std::size_t contender,
                   bench::TimeKind kind) {
    constexpr std::size_t kWorst = 10;
    fmt::print("\n{} beside {}, {} time, {}\n{:<10} {:>6} {:>7} {:>7}", plan.contenders[contender].label,
               plan.contenders.back().label, kind == bench::TimeKind::kCpu ? "processor" : "wall",
               title_of(plan, population), "geometry", "states", "mean", "worst");
    for (std::size_t bin = 0; bin < bench::Histogram{}.size(); ++bin)
        fmt::print(" {:>6}", bench::bin_name(bin));
    for (const bench::StateSummary& summary : bench::summaries(population.rows, contender, kind)) {
        fmt::print("\n{:<10} {:>6} {:>6.2f}x {:>6.2f}x", summary.of, summary.count, summary.geometric_mean,
                   summary.worst);
        for (const int count : summary.histogram) fmt::print(" {:>6}", count);
    }
    fmt::print("\nworst:\n");
    const bench::Rows sorted = bench::slowest(population.rows, contender, kind);
    for (std::size_t i = 0; i < std::min(kWorst, sorted.size()); ++i)
        fmt::print("  {:>6.2f}x  {}\n", bench::ratio(*sorted[i], contender, kind), sorted[i]->state.name);
    const std::string slow = bench::text_of(bench::slow_stages(population.rows, contender));
    if (!slow.empty()) fmt::print("{}\n", slow);
}

// Failures and pictures; never times. Where the reference is wrong its picture says nothing.
std::vector<std::string> problems_of(const bench::StatePlan& plan, const StateRow& row) {
    std::vector<std::string> problems;
    for (std::size_t i = 0; i < row.runs.size(); ++i) {
        const std::string who = row.state.name + ", " + plan.contenders[i].label + ": ";
        for (const std::string& failure : row.runs[i].failures) problems.push_back(who + failure);
        for (const std::string& way : row.runs[i].ways)
            if (way.find("unnamed") != std::string::npos)
                problems.push_back(who + "a stage has no name: " + way);
        const auto& difference = row.runs[i].difference;
        if (difference && difference->share > kTolerated && !states::reference_defect(row.state.state))
            problems.push_back(who + fmt::format("{:.2f} % of the values differ", difference->share * 100));
    }
    return problems;
}

void check(const bench::StatePlan& plan, const std::vector<StateRow>& rows) {
    std::string text;
    int count = 0;
    for (const StateRow& row : rows)
        for (const std::string& problem : problems_of(plan, row)) text += "\n  " + problem, ++count;
    if (count > 0)
        throw std::runtime_error(fmt::format("{} problems in {} states:{}", count, rows.size(), text));
    fmt::print("{} states drawn without an error, seen, and alike\n", rows.size());
}

std::string file_name(const std::string& state, const std::string& label) {
    std::string name = state + "-" + label + ".png";
    for (char& c : name)
        if (c == '/' || c == ' ') c = '-';
    return name;
}

// Takes the pictures that need not be kept for the page.
void write_pictures(const bench::StatePlan& plan, const std::string& folder, StateRow& row) {
    bool differs = false;
    for (std::size_t i = 0; i < row.runs.size(); ++i) {
        if (row.runs[i].picture.empty()) continue;
        const std::string name = file_name(row.state.name, plan.contenders[i].label);
        report::write_picture(picture_of(plan, row, i), folder + "/" + name);
        differs |= row.runs[i].difference && row.runs[i].difference->share > kTolerated;
    }
    if (differs) return;
    for (bench::StateRun& run : row.runs) run.picture.clear();
}

void print_failures(const bench::StatePlan& plan, const StateRow& row) {
    for (std::size_t i = 0; i < row.runs.size(); ++i)
        for (const std::string& failure : row.runs[i].failures)
            fmt::print("{}, {}: {} [{}]\n", row.state.name, plan.contenders[i].label, failure,
                       row.state.state.text());
    std::fflush(stdout);
}

// A library that cannot be loaded, or an instruction set that it does not have, is no result.
void expect_each_drew(const bench::StatePlan& plan, const std::vector<StateRow>& rows) {
    for (std::size_t i = 0; i < plan.contenders.size(); ++i) {
        const auto drew = [&](const StateRow& row) { return row.runs[i].opened; };
        if (std::any_of(rows.begin(), rows.end(), drew)) continue;
        const std::vector<std::string>& failures = rows.front().runs[i].failures;
        throw std::runtime_error(plan.contenders[i].label + " drew nothing" +
                                 (failures.empty() ? "" : ": " + failures.front()));
    }
}

void run(Options& options) {
    bench::StatePlan& plan = options.plan;
    plan.states = chosen_states(options);
    plan.seed = options.seed;
    if (options.list) {
        for (const states::NamedState& state : plan.states)
            fmt::print("{:<52} {}\n", state.name, state.state.text());
        return;
    }
    if (options.smoke) plan.rounds = 1, plan.seconds = 0, options.size = 64;
    plan.draw_program = draw_program();
    plan.contenders = contenders(options);
    plan.width = plan.height = options.size;
    plan.tolerated_share = options.pictures.empty() ? kTolerated : -1;
    if (!options.pictures.empty()) report::check_picture_path(options.pictures + "/picture.png");
    const bench::TimeKind kind = time_kind(options);
    const std::vector<bench::ReportPart> parts =
        options.parts_path.empty() ? std::vector<bench::ReportPart>() : bench::load_parts(options.parts_path);
    if (!options.quiet) print_header(plan);
    const std::vector<StateRow> rows = bench::run_states(plan, [&](StateRow& row) {
        if (!options.quiet) print_row(row, kind);
        print_failures(plan, row);
        if (!options.pictures.empty()) write_pictures(plan, options.pictures, row);
    });
    expect_each_drew(plan, rows);
    for (std::size_t i = 0; i + 1 < plan.contenders.size(); ++i)
        for (const bench::Population& population : bench::populations(rows))
            print_summary(plan, population, i, kind);
    print_parts(parts);
    if (!options.json_path.empty()) {
        nlohmann::json json = bench::to_json(plan, rows, kind);
        json["parts"] = bench::to_json(parts);
        report::write_text(options.json_path, json.dump(1) + "\n");
    }
    if (!options.html_path.empty())
        report::write_text(options.html_path, states_page(plan, rows, kind, parts));
    if (options.check) check(plan, rows);
}

}  // namespace

void add_states_command(CLI::App& bench_command) {
    auto* command = bench_command.add_subcommand(
        "states",
        "Compare the speed and the pictures of many states: what the benchmark of scenes leaves out");
    auto options = std::make_shared<Options>();
    command
        ->add_option(
            "-l,--library", options->libraries,
            "A library: PATH, LABEL=PATH, or the words terrazzo and osmesa; the last is the baseline")
        ->capture_default_str();
    command
        ->add_option("--isa", options->isas, "TERRAZZO_ISA of all but the baseline; give several: avx2,sse4")
        ->delimiter(',');
    command->add_option("-f,--filter", options->filter,
                        "Only states whose names this regular expression finds");
    command->add_option(
        "--state", options->given_states,
        "A state instead of the named list: \"AXIS=VALUE AXIS=VALUE ...\", as --list prints them");
    command->add_option("--random", options->random, "So many random states in addition")
        ->check(CLI::Range(0, 1000000));
    command->add_option("--seed", options->seed, "Of the random states")->capture_default_str();
    command->add_flag("--only-random", options->only_random, "Without the named list");
    command->add_option("-t,--threads", options->plan.threads, "Threads that draw; 0: the calling one alone")
        ->check(CLI::Range(0, 64))
        ->capture_default_str();
    command->add_option("--samples", options->samples, "Samples a pixel, instead of each state's own")
        ->check(CLI::IsMember({1, 4}));
    command->add_option("-r,--rounds", options->plan.rounds, "Interleaved rounds")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command->add_option("-s,--seconds", options->plan.seconds, "The least time of one measurement")
        ->check(CLI::Range(0.0, 3600.0))
        ->capture_default_str();
    command->add_option("--size", options->size, "Width and height of the picture")
        ->check(CLI::Range(1, 4096))
        ->capture_default_str();
    command
        ->add_option("--clock", options->clock,
                     "Which time decides; the processor's if not given and one thread draws")
        ->check(CLI::IsMember({"cpu", "wall"}));
    command->add_option("--json", options->json_path, "Write the figures as JSON");
    command->add_option("--html", options->html_path, "Write a page with plots and the pictures that differ");
    command->add_option("--with", options->parts_path,
                        "A file of other measurements, of bench/report.py, for one report of all");
    command->add_option("--pictures", options->pictures, "Write each picture as PNG to this folder");
    command->add_flag("--smoke", options->smoke, "One frame of 64x64 of each state");
    command->add_flag(
        "--check", options->check,
        "Fail when a state has an error, is not seen, or has another picture than the baseline");
    command->add_flag("--list", options->list, "Only print the states");
    command->add_flag("-q,--quiet", options->quiet, "Only the summary");
    command->callback([options] { run(*options); });
}

}  // namespace terrazzo
