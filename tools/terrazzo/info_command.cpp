// terrazzo info: what a library is, its limits, and what it does not answer for.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <memory>
#include <set>

#include "commands.h"
#include "kit/child.h"
#include "kit/shared_bytes.h"
#include "osmesa_exports.h"
#include "places.h"

namespace terrazzo {
namespace {

struct Options {
    std::string library = "terrazzo";
    bool missing = false;
};

// What the system's library exports and OSMesaGetProcAddress can be asked for: the GL commands.
nlohmann::json exported_commands() {
    nlohmann::json names = nlohmann::json::array();
    for (const std::string_view name : kOsmesaExports)
        if (name.starts_with("gl")) names.push_back(name);
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
    fmt::print("GL 1.0-1.5 commands not implemented: {} of {}\n", info["missing_commands"].size(),
               info["commands"].get<int>());
    fmt::print("names of the system's libOSMesa not implemented: {} (--missing lists them)\n",
               info["missing_names"].size());
}

void run(const Options& options) {
    const NamedLibrary library = parse_library(options.library);
    kit::ChildRequest request;
    request.executable = draw_program();
    request.task = "info";

    // Through memory: the list is longer than one command-line argument may be.
    const kit::SharedBytes names(nlohmann::json::to_cbor(exported_commands()));
    request.arguments = {{"library", library.path}, {"names", names.path()}};
    const kit::ChildReport report = kit::run_in_child(request);
    if (!report.finished()) throw std::runtime_error(report.message);
    if (!options.missing) {
        print_info(report.result, library.path);
        return;
    }
    std::set<std::string> missing;
    for (const char* key : {"missing_commands", "missing_names"})
        for (const auto& name : report.result[key]) missing.insert(name.get<std::string>());
    for (const std::string& name : missing) fmt::print("{}\n", name);
}

}  // namespace

void add_info_command(CLI::App& app) {
    auto* command = app.add_subcommand("info", "Version, limits and missing commands of a GL library");
    auto options = std::make_shared<Options>();
    command->add_option("-l,--library", options->library, "PATH, or the words terrazzo and osmesa")
        ->capture_default_str();
    command->add_flag("--missing", options->missing,
                      "List the names for which OSMesaGetProcAddress answers NULL");
    command->callback([options] { run(*options); });
}

}  // namespace terrazzo
