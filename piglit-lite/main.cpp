// piglit-lite: draws scenes with our library and the reference and compares them. Exit status 0 when every
// chosen scene keeps its promise.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <thread>

#include "pixels.h"
#include "report/page.h"
#include "report/pictures.h"
#include "reports.h"

namespace {

using namespace terrazzo;
using namespace terrazzo::piglit;
namespace fs = std::filesystem;

struct CommandLine {
    Options options;
    std::vector<std::string> filters;
    std::string report_folder;
    std::string junit_path;
    std::string contact_path;
    bool only_failures = false;
    bool list = false;
    bool print_values = false;
};

fs::path own_folder() {
    return fs::read_symlink("/proc/self/exe").parent_path();
}

std::vector<const Scene*> chosen_scenes(const std::vector<std::string>& filters, bool in_object) {
    std::vector<const Scene*> chosen;
    for (const Scene& scene : scenes()) {
        bool wanted = filters.empty();
        for (const std::string& filter : filters)
            wanted |=
                std::string(scene.name).find(filter) != std::string::npos || chapter_of(scene) == filter;
        if (wanted && !(in_object && scene.window_only != nullptr)) chosen.push_back(&scene);
    }
    return chosen;
}

void define_options(CLI::App& app, CommandLine& line) {
    Options& options = line.options;
    options.draw_program = (own_folder() / "piglit-lite-draw").string();
    options.ours = (own_folder() / "../src/frontends/osmesa/libOSMesa.so.8").lexically_normal().string();
    options.theirs = TERRAZZO_REFERENCE_LIBRARY;
    options.jobs = std::max(1U, std::thread::hardware_concurrency());
    app.add_flag("--list", line.list, "List the scenes and stop");
    app.add_flag("--values", line.print_values, "Print the values that the scenes note");
    app.add_option("--filter", line.filters, "Only scenes with this in their name, or of this chapter");
    app.add_option("--ours", options.ours, "Library under test; softpipe to judge Mesa against itself")
        ->capture_default_str();
    app.add_option("--theirs", options.theirs, "Reference library")->capture_default_str();
    app.add_option("--threads", options.threads, "Thread counts of ours")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--isa", options.isas, "Instruction sets of ours; none: its own choice")->delimiter(',');
    app.add_flag("--in-object", options.in_object, "Draw to a frame buffer object in the window's place");
    app.add_option("--samples", options.samples, "Samples a pixel of that object");
    app.add_flag("!--no-softpipe", options.softpipe, "Leave softpipe out of the report");
    app.add_option("--jobs", options.jobs, "Scenes at a time")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_flag("--fail-fast", options.fail_fast, "Start no scene after one has failed")
        ->envname("GTEST_FAIL_FAST");
    app.add_option("--report", line.report_folder, "Folder for report.html and junit.xml");
    app.add_flag("--only-failures", line.only_failures,
                 "Report only the scenes that fail, and nothing if none does");
    app.add_option("--contact", line.contact_path, "Write the reference's pictures as one PNG");
    // The name is GoogleTest's so that meson can ask for it.
    app.add_option("--gtest_output", line.junit_path, "JUnit file, as xml:PATH")->group("");
}

void print_result(const SceneReport& report) {
    const Comparison& c = report.comparison;
    fmt::print(
        "{:<4} {:<44} off {:>6} max {:>5.1f} coverage {:>4} depth {:>4} stencil {:>4}   softpipe off {:>6}\n",
        report.open       ? "open"
        : report.passed() ? "ok"
                          : "FAIL",
        report.scene->name, c.differing, c.largest_difference, c.coverage, c.largest_depth_difference,
        c.stencil_differing, report.softpipe_comparison.differing);
    for (const std::string& problem : report.problems) fmt::print("       {}\n", problem);
    std::fflush(stdout);
}

void print_values(const SceneReport& report) {
    for (const NotedValue& ours : report.ours.values) {
        double expected = std::nan("");
        for (const NotedValue& theirs : report.theirs.values)
            if (theirs.name == ours.name) expected = theirs.value;
        fmt::print("       {:<48} ours {:>14.8g} theirs {:>14.8g}\n", ours.name, ours.value, expected);
    }
}

void write_reports(const CommandLine& line, const std::vector<SceneReport>& reports) {
    std::vector<SceneReport> told = reports;
    if (line.only_failures) std::erase_if(told, [](const SceneReport& report) { return report.passed(); });
    if (!line.report_folder.empty() && !(line.only_failures && told.empty())) {
        fs::create_directories(line.report_folder);
        report::write_text(line.report_folder + "/report.html", html_report(line.options, told));
        report::write_text(line.report_folder + "/junit.xml", junit_report(told));
    }
    if (!line.junit_path.empty()) {
        const std::string prefix = "xml:";
        const bool prefixed = line.junit_path.rfind(prefix, 0) == 0;
        report::write_text(prefixed ? line.junit_path.substr(prefix.size()) : line.junit_path,
                           junit_report(reports));
    }
    if (!line.contact_path.empty()) {
        std::vector<OIIO::ImageBuf> pictures;
        for (const SceneReport& report : reports)
            if (report.theirs.drawn()) pictures.push_back(colour_picture(*report.scene, report.theirs));
        report::write_picture(report::contact_sheet(pictures, 5, 256), line.contact_path);
    }
}

int run(CommandLine& line) {
    const std::vector<const Scene*> chosen = chosen_scenes(line.filters, line.options.in_object);
    if (line.list) {
        for (const Scene* scene : chosen)
            fmt::print("{:<24} {:<44} {}\n", chapter_of(*scene), scene->name, scene->theme);
        return 0;
    }
    if (chosen.empty()) throw std::runtime_error("no scene fits the filter");
    // Scenes are compared side by side in threads of ours; OpenImageIO's own pool would only get in their
    // way.
    OIIO::attribute("threads", 1);
    if (line.options.ours == "softpipe") line.options.ours_is_softpipe = true;
    if (line.options.isas.empty()) line.options.isas.emplace_back();
    const std::vector<SceneReport> reports =
        piglit::run(line.options, chosen, [&](const SceneReport& report) {
            print_result(report);
            if (line.print_values) print_values(report);
        });
    write_reports(line, reports);
    std::size_t passed = 0, open = 0;
    for (const SceneReport& report : reports) {
        open += report.passed() && report.open;
        passed += report.passed() && !report.open;
    }
    const std::size_t failed = reports.size() - passed - open;
    fmt::print("{} passed, {} failed, {} skipped as open differences\n", passed, failed, open);
    return failed == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Draws scenes with two GL libraries and compares them."};
    CommandLine line;
    try {
        define_options(app, line);
        app.parse(argc, argv);
        return run(line);
    } catch (const CLI::ParseError& stop) {
        return app.exit(stop);
    } catch (const std::exception& failure) {
        fmt::print(stderr, "piglit-lite: {}\n", failure.what());
        return 2;
    }
}
