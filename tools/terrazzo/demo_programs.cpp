// Stage: the demo's programs with windows; see demo_programs.h.
#include "demo_programs.h"

#include <OpenImageIO/imagebufalgo.h>
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "report/figures.h"
#include "report/page.h"
#include "rounds.h"

namespace terrazzo {
namespace {

using report::escaped;

std::optional<OIIO::ImageBuf> picture(const std::string& folder, const nlohmann::json& program,
                                      const char* side) {
    if (!program.contains(side)) return std::nullopt;
    const std::string path = folder + "/" + program.at(side).get<std::string>();
    const OIIO::ImageBuf file(path);
    if (!file.initialized() || file.has_error()) throw std::runtime_error("cannot read " + path);
    return OIIO::ImageBufAlgo::channels(file, 3, {});
}

double rate(const nlohmann::json& samples) {
    const auto values = samples.get<std::vector<double>>();
    return values.empty() ? 0 : bench::median(values);
}

DemoProgram program_of(const std::string& folder, const nlohmann::json& json) {
    DemoProgram program;
    program.name = json.at("name");
    program.description = json.at("about");
    program.ours = picture(folder, json, "terrazzo");
    program.theirs = picture(folder, json, "mesa");
    program.problem = json.value("problem", "");
    program.frames = json.at("frames");
    program.within_one = json.at("within_one").get<std::vector<double>>();
    program.largest_difference = json.at("largest");
    program.our_rate = rate(json.at("fps").at("terrazzo"));
    program.their_rate = rate(json.at("fps").at("mesa"));
    return program;
}

std::string row(const DemoProgram& program) {
    std::string html = fmt::format("<tr><td><a href=\"#{0}\">{0}</a></td>", escaped(program.name));
    if (!program.problem.empty())
        return html + fmt::format("<td colspan=\"6\">{}</td></tr>\n", escaped(program.problem));
    const double ratio = program.ratio();
    html += fmt::format("<td>{:.1f}</td><td>{:.1f}</td>", program.our_rate, program.their_rate);
    html += ratio == 0
                ? "<td></td>"
                : fmt::format("<td class=\"{}\">{:.2f}x</td>", ratio >= 1 ? "good-text" : "bad-text", ratio);
    return html + fmt::format("<td>{}</td><td>{:.3f} %</td><td>{}</td></tr>\n", program.frames,
                              100 * program.lowest_share(), program.largest_difference);
}

std::string card(const DemoProgram& program) {
    std::string html =
        fmt::format("<div class=\"card {}\" id=\"{}\"><h3>{}</h3><div class=\"theme\">{}</div>\n",
                    program.agrees() ? "good" : "bad", escaped(program.name), escaped(program.name),
                    escaped(program.description));
    html += report::comparison(program.ours, "Terrazzo", program.theirs, "Mesa");
    if (program.problem.empty())
        html += fmt::format(
            "<div class=\"theme\">{} pictures compared: {:.3f} % of the pixels or more are within one step "
            "of "
            "255; largest difference: {}</div>",
            program.within_one.size(), 100 * program.lowest_share(), program.largest_difference);
    else
        html += "<ul class=\"problems\"><li>" + escaped(program.problem) + "</li></ul>";
    return html + "</div>\n";
}

}  // namespace

double DemoProgram::ratio() const {
    return our_rate > 0 && their_rate > 0 ? our_rate / their_rate : 0;
}

double DemoProgram::lowest_share() const {
    return within_one.empty() ? 0 : *std::min_element(within_one.begin(), within_one.end());
}

bool DemoProgram::agrees() const {
    return problem.empty() && lowest_share() >= kAgreeingShare;
}

DemoPrograms load_programs(const std::string& folder) {
    std::ifstream file(folder + "/programs.json");
    if (!file) throw std::runtime_error("cannot read " + folder + "/programs.json");
    const nlohmann::json json = nlohmann::json::parse(file);
    DemoPrograms programs;
    for (const nlohmann::json& program : json.at("programs"))
        programs.programs.push_back(program_of(folder, program));
    programs.absent = json.at("absent").get<std::vector<std::string>>();
    programs.their_renderer = json.at("renderers").at(0);
    programs.our_renderer = json.at("renderers").at(1);
    return programs;
}

double mean_ratio(const DemoPrograms& programs) {
    std::vector<double> ratios;
    for (const DemoProgram& program : programs.programs)
        if (program.ratio() > 0) ratios.push_back(program.ratio());
    return bench::geometric_mean(ratios);
}

std::string programs_section(const DemoPrograms& programs) {
    if (programs.programs.empty()) return "";
    std::string html = fmt::format(
        "<h2>Programs in windows</h2><p class=\"lead\">Real programs, not changed and not compiled anew. "
        "Each ran on Terrazzo for some seconds while what it draws was written down; then both drivers drew "
        "these very frames, in turns, as fast as they could, in a window of one X server. Terrazzo: {}. "
        "Mesa: {}. "
        "Frames a second are medians, and count the tool that reads the recording, which is the same for "
        "both.</p>\n",
        escaped(programs.our_renderer), escaped(programs.their_renderer));
    html +=
        "<div class=\"figures\"><table><tr><th>program</th><th>FPS, Terrazzo</th><th>Mesa</th><th>ratio</th>"
        "<th>frames</th><th>pixels within 1/255</th><th>largest, /255</th></tr>\n";
    for (const DemoProgram& program : programs.programs) html += row(program);
    html += fmt::format("<tr><td>geometric mean</td><td></td><td></td><td>{:.2f}x</td></tr></table></div>\n",
                        mean_ratio(programs));
    if (!programs.absent.empty())
        html += fmt::format("<p class=\"lead\">Not installed and left out: {}.</p>\n",
                            escaped(fmt::format("{}", fmt::join(programs.absent, ", "))));
    for (const DemoProgram& program : programs.programs) html += card(program);
    return html;
}

}  // namespace terrazzo
