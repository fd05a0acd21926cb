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
#include "registry_names.h"

namespace terrazzo {
namespace {

struct Options {
    std::string library = "terrazzo";
    bool missing = false;
    bool later = false;
};

// The commands to ask for: of OpenGL 1.0-1.5, of extensions, and all that the system's library exports.
nlohmann::json commands_by_origin() {
    nlohmann::json names = {{"core", nlohmann::json::array()}, {"exported", nlohmann::json::array()}};
    for (const char* name : kCoreCommands) names["core"].push_back(name);
    for (const ExtensionCommand& known : kExtensionCommands)
        names["extensions"][known.extension].push_back(known.command);
    for (const std::string_view name : kOsmesaExports)
        if (name.starts_with("gl")) names["exported"].push_back(name);
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
    const auto print_count = [&](const char* what, const char* key, const char* hint) {
        fmt::print("{} not implemented: {} of {} ({} lists them)\n", what, info[key]["missing"].size(),
                   info[key]["asked"].get<int>(), hint);
    };
    print_count("commands of OpenGL 1.0-1.5", "core", "--missing");
    print_count("commands of these extensions", "of_extensions", "--missing");
    print_count("commands of the system's libOSMesa", "exported", "--missing --later");
}

void print_missing(const nlohmann::json& info, bool later) {
    std::set<std::string> missing;
    for (const char* key : {"core", "of_extensions", "exported"}) {
        if (!later && std::string_view(key) == "exported") continue;
        for (const auto& name : info[key]["missing"]) missing.insert(name.get<std::string>());
    }
    for (const std::string& name : missing) fmt::print("{}\n", name);
}

void run(const Options& options) {
    const NamedLibrary library = parse_library(options.library);
    kit::ChildRequest request;
    request.executable = draw_program();
    request.task = "info";

    // Through memory: the list is longer than one command-line argument may be.
    const kit::SharedBytes names(nlohmann::json::to_cbor(commands_by_origin()));
    request.arguments = {{"library", library.path}, {"names", names.path()}};
    const kit::ChildReport report = kit::run_in_child(request);
    if (!report.finished()) throw std::runtime_error(report.message);
    if (options.missing) {
        print_missing(report.result, options.later);
    } else {
        print_info(report.result, library.path);
    }
}

}  // namespace

void add_info_command(CLI::App& app) {
    auto* command = app.add_subcommand("info", "Version, limits and missing commands of a GL library");
    auto options = std::make_shared<Options>();
    command->add_option("-l,--library", options->library, "PATH, or the words terrazzo and osmesa")
        ->capture_default_str();
    CLI::Option* const missing =
        command->add_flag("--missing", options->missing,
                          "List the commands of OpenGL 1.0-1.5, and of the extensions that the library "
                          "names, that it does not have");
    command
        ->add_flag("--later", options->later,
                   "And those of later versions and other extensions that the system's libOSMesa has")
        ->needs(missing);
    command->callback([options] { run(*options); });
}

}  // namespace terrazzo
