// Bars, tables and sentences of MuJoCo, traces and programs.
#include "parts_report.h"

#include <fmt/core.h>

#include <algorithm>

#include "report/page.h"
#include "report/plots.h"

namespace terrazzo {
namespace {

using bench::PartRow;
using bench::ReportPart;
using report::escaped;

constexpr const char* kColours[] = {"#3f8f6b", "#c2703d", "#5a7fc0", "#a05a9c"};
constexpr std::size_t kWorst = 10;

// Names as gnuplot's strings have them.
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) result += c == '"' || c == '\\' ? ' ' : c;
    return result + "\"";
}

// A bar a row and contender, the slowest of the first contender first.
std::string bars(const ReportPart& part) {
    const std::vector<const PartRow*> rows = bench::slowest(part, 0);
    if (rows.empty()) return "";
    std::string data = "$p << EOD\n";
    for (const PartRow* const row : rows) {
        data += quoted(row->name);
        for (std::size_t i = 0; i + 1 < part.contenders.size(); ++i)
            data += fmt::format(" {}", row->ratio(i) > 0 ? fmt::format("{}", row->ratio(i)) : "NaN");
        data += "\n";
    }
    data +=
        "EOD\nset style data histograms\nset style histogram clustered gap 1\nset style fill solid 0.85 "
        "noborder\n"
        "set key outside top horizontal\nset xtics rotate by -60\nset termoption noenhanced\nset yrange "
        "[0:*]\nset ylabel 'times the speed'\nplot ";
    for (std::size_t i = 0; i + 1 < part.contenders.size(); ++i)
        data += fmt::format("$p using {}{} title {} linecolor rgb '{}', ", i + 2, i ? "" : ":xtic(1)",
                            quoted(part.contenders[i]), kColours[i % std::size(kColours)]);
    const int width = std::clamp(static_cast<int>(rows.size()) * 22, 420, 1160);
    return report::plot(data + "1 with lines linewidth 1 linecolor rgb '#b3372b' notitle\n", width, 320);
}

std::string table(const ReportPart& part) {
    std::string html = "<div class=\"figures\"><table><tr><th></th>";
    for (std::size_t i = 0; i + 1 < part.contenders.size(); ++i)
        html += fmt::format("<th>{}, ms</th><th>ratio</th>", escaped(part.contenders[i]));
    html += fmt::format("<th>{}, ms</th><th></th></tr>\n", escaped(part.contenders.back()));
    for (const PartRow& row : part.rows) {
        html += fmt::format("<tr><td>{}</td>", escaped(row.name));
        for (std::size_t i = 0; i < part.contenders.size(); ++i) {
            html += row.seconds(i) > 0 ? fmt::format("<td>{:.3f}</td>", row.seconds(i) * 1e3) : "<td></td>";
            if (i + 1 == part.contenders.size()) continue;
            const double ratio = row.ratio(i);
            html += ratio > 0 ? fmt::format("<td class=\"{}\">{:.2f}x</td>",
                                            ratio >= 1 ? "good-text" : "bad-text", ratio)
                              : "<td></td>";
        }
        html += fmt::format("<td>{}</td></tr>\n", escaped(row.note));
    }
    return html + "</table></div>\n";
}

}  // namespace

void print_parts(const std::vector<ReportPart>& parts) {
    for (const ReportPart& part : parts) {
        if (!part.problem.empty()) {
            fmt::print("\n{}: {}\n", part.title, part.problem);
            continue;
        }
        for (std::size_t i = 0; i + 1 < part.contenders.size(); ++i) {
            const bench::StateSummary all = bench::summary_of(part, i);
            fmt::print("\n{}: {} beside {}, geometric mean of {}: {:.2f}x, {} slower\n", part.title,
                       part.contenders[i], part.contenders.back(), all.count, all.geometric_mean,
                       all.slower());
            const std::vector<const PartRow*> sorted = bench::slowest(part, i);
            for (std::size_t r = 0; r < std::min(kWorst, sorted.size()); ++r)
                fmt::print("  {:>6.2f}x  {}\n", sorted[r]->ratio(i), sorted[r]->name);
        }
    }
}

std::string parts_tiles(const std::vector<ReportPart>& parts) {
    std::string html;
    for (const ReportPart& part : parts)
        for (std::size_t i = 0; i + 1 < part.contenders.size(); ++i) {
            const bench::StateSummary all = bench::summary_of(part, i);
            if (all.count == 0) continue;
            html += fmt::format(
                "<div><b>{:.2f}x</b><span>{}, {}, {}; {} slower than {}, the slowest "
                "{:.2f}x</span></div>",
                all.geometric_mean, escaped(part.title), escaped(part.contenders[i]), all.count, all.slower(),
                escaped(part.contenders.back()), all.worst);
        }
    return html;
}

std::string parts_sections(const std::vector<ReportPart>& parts) {
    std::string html;
    for (const ReportPart& part : parts) {
        html +=
            fmt::format("<h2>{}</h2>\n<p class=\"lead\">{}</p>\n", escaped(part.title), escaped(part.about));
        if (!part.problem.empty()) html += "<p class=\"warn-text\">" + escaped(part.problem) + "</p>\n";
        if (part.rows.empty()) continue;
        html += "<div class=\"card\">" + bars(part) + "</div>\n" + table(part);
    }
    return html;
}

}  // namespace terrazzo
