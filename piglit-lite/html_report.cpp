// Stage: piglit-lite, the page for people.
#include <fmt/core.h>

#include <algorithm>

#include "pixels.h"
#include "report/figures.h"
#include "report/page.h"
#include "report/pictures.h"
#include "reports.h"

namespace terrazzo::piglit {
namespace {

using report::escaped;
using report::figure;
using report::kMagnification;

bool flat(const std::vector<std::uint8_t>& plane) {
    return plane.empty() ||
           std::all_of(plane.begin(), plane.end(), [&](std::uint8_t v) { return v == plane[0]; });
}

std::string pictures(const SceneReport& report) {
    const Scene& scene = *report.scene;
    std::string html = "<div class=\"pictures\">";
    if (report.ours.drawn()) html += figure(colour_picture(scene, report.ours), "ours");
    if (report.theirs.drawn()) html += figure(colour_picture(scene, report.theirs), "OSMesa");
    if (report.ours.drawn() && report.theirs.drawn() &&
        report.ours.colour.size() == report.theirs.colour.size())
        html += figure(report::magnified_difference(colour_picture(scene, report.ours),
                                                    colour_picture(scene, report.theirs), kMagnification),
                       fmt::format("difference x {:g}", kMagnification));
    if (report.ours.drawn() && !flat(report.ours.stencil))
        html += figure(stencil_picture(scene, report.ours), "stencil of ours");
    return html + "</div>\n";
}

std::string figures_row(const char* name, const Comparison& c) {
    if (c.pixels == 0) return fmt::format("<tr><td>{}</td><td colspan=\"7\">not drawn</td></tr>\n", name);
    const double pixels = static_cast<double>(c.pixels);
    return fmt::format(
        "<tr><td>{}</td><td>{:.4f} %</td><td>{}</td><td>{:.2f}</td><td>{:.5f}</td><td>{}</td><td>{}</td>"
        "<td>{}</td></tr>\n",
        name, 100 * (1 - static_cast<double>(c.differing) / pixels), c.differing, c.largest_difference,
        c.mean_difference, c.coverage, c.largest_depth_difference, c.stencil_differing);
}

std::string card(const Options& options, const SceneReport& report) {
    std::string html =
        fmt::format("<div class=\"card {}\" id=\"{}\"><h3>{}</h3><div class=\"theme\">{}</div>\n",
                    report.passed() ? "good" : "bad", report.scene->name, report.scene->name,
                    escaped(report.scene->theme));
    html += pictures(report);
    html +=
        "<div class=\"figures\"><table><tr><th>against OSMesa</th><th>within tolerance</th><th>pixels "
        "off</th>"
        "<th>largest, /255</th><th>mean, /255</th><th>coverage</th><th>depth "
        "steps</th><th>stencil</th></tr>\n";
    html += figures_row("ours", report.comparison);
    if (options.softpipe) html += figures_row("softpipe", report.softpipe_comparison);
    html += "</table></div>\n";
    if (!report.theirs.values.empty())
        html += fmt::format("<div class=\"theme\">{} values compared</div>\n", report.theirs.values.size());
    if (!report.problems.empty()) {
        html += "<ul class=\"problems\">";
        for (const std::string& problem : report.problems) html += "<li>" + escaped(problem) + "</li>";
        html += "</ul>\n";
    }
    return html + "</div>\n";
}

struct Totals {
    std::size_t passed = 0;
    std::size_t identical = 0;
    std::size_t closer = 0;
    std::size_t behind = 0;
};

Totals count(const std::vector<SceneReport>& reports) {
    Totals totals;
    for (const SceneReport& report : reports) {
        totals.passed += report.passed();
        if (report.comparison.pixels == 0) continue;
        totals.identical += report.ours.colour == report.theirs.colour;
        totals.closer += report.comparison.differing <= report.softpipe_comparison.differing;
        totals.behind += report.comparison.differing > report.softpipe_comparison.differing;
    }
    return totals;
}

}  // namespace

std::string html_report(const Options& options, const std::vector<SceneReport>& reports) {
    const Totals totals = count(reports);
    std::string html = report::page_head("piglit-lite");
    html +=
        "<h1>piglit-lite</h1><p class=\"lead\">Each scene is drawn in a child process per library and "
        "compared "
        "pixel by pixel: colour within one step of 255, coverage and stencil identical, depth within one "
        "step, "
        "and the same bits from every thread count and instruction set of ours.</p>\n";
    html += fmt::format("<p>ours: {}<br>reference: {}</p>\n",
                        escaped(reports.empty() ? "" : reports.front().ours.renderer),
                        escaped(reports.empty() ? "" : reports.front().theirs.renderer));
    html += fmt::format(
        "<div class=\"totals\"><div><b>{} / {}</b><span>scenes keep the promise</span></div>"
        "<div><b>{}</b><span>pictures identical to the byte</span></div>",
        totals.passed, reports.size(), totals.identical);
    if (options.softpipe)
        html += fmt::format(
            "<div><b>{}</b><span>at least as close as softpipe</span></div>"
            "<div><b>{}</b><span>behind softpipe</span></div>",
            totals.closer, totals.behind);
    html += "</div>\n";
    const bool any_failed = totals.passed != reports.size();
    if (any_failed) {
        html += "<nav><span>failed:</span>";
        for (const SceneReport& report : reports)
            if (!report.passed()) html += fmt::format("<a href=\"#{0}\">{0}</a>", report.scene->name);
        html += "</nav>\n";
    }
    std::string chapter;
    for (const SceneReport& report : reports) {
        if (chapter != chapter_of(*report.scene)) {
            chapter = chapter_of(*report.scene);
            html += "<h2>" + escaped(chapter) + "</h2>\n";
        }
        html += card(options, report);
    }
    return html + report::page_foot();
}

}  // namespace terrazzo::piglit
