// terrazzo info: what a library is, its limits, and what it does not answer for.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <fstream>
#include <memory>

#include "commands.h"
#include "kit/child.h"
#include "places.h"

namespace terrazzo {
namespace {

struct Options {
    std::string library = "terrazzo";
    std::string names_path;
    bool missing = false;
};

std::vector<std::string> read_names(const std::string& path) {
    std::vector<std::string> names;
    if (path.empty()) return names;
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read " + path);
    for (std::string line; std::getline(file, line);)
        if (!line.empty() && line[0] != '#') names.push_back(line);
    return names;
}

void print_info(const nlohmann::json& info, const std::string& path) {
    fmt::print("library     {}\n", path);
    for (const char* key : {"vendor", "renderer", "version"})
        fmt::print("{:<11} {}\n", key, info[key].get<std::string>());
    fmt::print("extensions  {}\n", info["extensions"].get<std::string>());
    for (const auto& limit : info["limits"]) {
        std::string values;
        for (const auto& value : limit["values"]) values += fmt::format(" {:g}", value.get<double>());
        fmt::print("{:<34}{}\n", limit["name"].get<std::string>(), values);
    }
    fmt::print("GL 1.0-1.5 commands not implemented: {}\n", info["missing_commands"].size());
}

void run(const Options& options) {
    const NamedLibrary library = parse_library(options.library);
    kit::ChildRequest request;
    request.executable = draw_program();
    request.task = "info";

    request.arguments = {{"library", library.path}, {"names", read_names(options.names_path)}};
    const kit::ChildReport report = kit::run_in_child(request);
    if (!report.finished()) throw std::runtime_error(report.message);
    if (!options.missing) {
        print_info(report.result, library.path);
        return;
    }
    for (const auto& name : report.result["missing_commands"]) fmt::print("{}\n", name.get<std::string>());
    for (const auto& name : report.result["missing_names"]) fmt::print("{}\n", name.get<std::string>());
}

}  // namespace

void add_info_command(CLI::App& app) {
    auto* command = app.add_subcommand("info", "Version, limits and missing commands of a GL library");
    auto options = std::make_shared<Options>();
    command->add_option("-l,--library", options->library, "PATH, or the words terrazzo and osmesa")
        ->capture_default_str();
    command->add_flag("--missing", options->missing,
                      "List the names for which OSMesaGetProcAddress answers NULL");
    command->add_option("--names", options->names_path, "A file of further names to ask for, one a line");
    command->callback([options] { run(*options); });
}

}  // namespace terrazzo
