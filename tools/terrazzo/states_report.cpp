// Tiles, plots, the slowest, all rows, pictures that differ.
#include "states_report.h"

#include <fmt/core.h>

#include <cstring>

#include "parts_report.h"
#include "report/figures.h"
#include "report/page.h"
#include "report/pictures.h"
#include "report/plots.h"
#include "rounds.h"

namespace terrazzo {
namespace {

using bench::StateRow;
using report::escaped;
using states::Axis;

constexpr const char* kColours[] = {"#3f8f6b", "#c2703d", "#5a7fc0", "#a05a9c"};
constexpr std::size_t kSlowest = 10;
constexpr int kMostPictures = 40;

struct Page {
    const bench::StatePlan& plan;
    const std::vector<StateRow>& rows;
    bench::TimeKind kind;
    std::vector<bench::Population> populations;

    std::size_t contenders() const { return plan.contenders.size() - 1; }
    const std::string& label(std::size_t i) const { return plan.contenders[i].label; }
    const std::string& baseline() const { return plan.contenders.back().label; }
};

std::string ratio_cell(double ratio) {
    if (ratio <= 0) return "<td></td>";
    return fmt::format("<td class=\"{}\">{:.2f}x</td>", ratio >= 1 ? "good-text" : "bad-text", ratio);
}

std::string tiles(const Page& page) {
    std::string html = "<div class=\"totals\">";
    for (std::size_t i = 0; i < page.contenders(); ++i)
        for (const bench::Population& population : page.populations) {
            const bench::StateSummary all = bench::summaries(population.rows, i, page.kind).back();
            html += fmt::format(
                "<div><b>{:.2f}x</b><span>{}, geometric mean of {} {} states; {} slower than {}, the slowest "
                "{:.2f}x</span></div>",
                all.geometric_mean, escaped(page.label(i)), all.count, population.name, all.slower(),
                escaped(page.baseline()), all.worst);
        }
    return html;
}

std::string histogram_table(const Page& page) {
    std::string html =
        "<div "
        "class=\"figures\"><table><tr><th>library</th><th>states</th><th>geometry</th><th>count</"
        "th><th>mean</"
        "th><th>slowest</th>";
    for (std::size_t bin = 0; bin < bench::Histogram{}.size(); ++bin)
        html += "<th>" + escaped(bench::bin_name(bin)) + "</th>";
    html += "</tr>\n";
    for (std::size_t i = 0; i < page.contenders(); ++i)
        for (const bench::Population& population : page.populations)
            for (const bench::StateSummary& summary : bench::summaries(population.rows, i, page.kind)) {
                html += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td>",
                                    escaped(page.label(i)), population.name, summary.of, summary.count);
                html += ratio_cell(summary.geometric_mean) + ratio_cell(summary.worst);
                for (const int count : summary.histogram) html += fmt::format("<td>{}</td>", count);
                html += "</tr>\n";
            }
    return html + "</table></div>\n";
}

// Ratios in rising order over the share of states, a curve a geometry.
std::string sorted_plot(const Page& page, const bench::Rows& rows, std::size_t contender) {
    std::string data, curves;
    const states::AxisEntry& geometry = states::entry(Axis::kGeometry);
    for (std::size_t g = 0; g < geometry.values.size(); ++g) {
        std::vector<double> ratios;
        for (const StateRow* row : bench::slowest(rows, contender, page.kind))
            if (row->state.state.index(Axis::kGeometry) == g)
                ratios.push_back(bench::ratio(*row, contender, page.kind));
        if (ratios.empty()) continue;
        data += fmt::format("$g{} << EOD\n", g);
        for (std::size_t i = 0; i < ratios.size(); ++i)
            data += fmt::format("{} {}\n",
                                100.0 * static_cast<double>(i + 1) / static_cast<double>(ratios.size()),
                                ratios[i]);
        data += "EOD\n";
        curves += fmt::format(
            "{}$g{} using 1:2 with linespoints pointtype 7 pointsize 0.3 linewidth 2 linecolor rgb '{}' "
            "title '{}'",
            curves.empty() ? "" : ", ", g, kColours[g % std::size(kColours)], geometry.values[g].name);
    }
    if (curves.empty()) return "";
    return report::plot(
        data +
            "set logscale y 2\nset grid ytics linecolor rgb '#8a8378' linewidth 0.3\nset key left top\n"
            "set xlabel 'share of the states, %'\nset ylabel 'times the speed'\nset xrange [0:100]\nplot " +
            curves + ", 1 with lines linewidth 1 linecolor rgb '#b3372b' notitle\n",
        760, 340);
}

std::string histogram_plot(const Page& page, const bench::Rows& rows, std::size_t contender) {
    const std::vector<bench::StateSummary> summaries = bench::summaries(rows, contender, page.kind);
    std::string data = "$h << EOD\n";
    for (std::size_t bin = 0; bin < bench::Histogram{}.size(); ++bin) {
        data += "\"" + bench::bin_name(bin) + "\"";
        for (std::size_t i = 0; i + 1 < summaries.size(); ++i)
            data += fmt::format(" {}", summaries[i].histogram[bin]);
        data += "\n";
    }
    data +=
        "EOD\nset style data histograms\nset style histogram rowstacked\nset style fill solid 0.85 "
        "noborder\nset boxwidth 0.8\n"
        "set yrange [0:*]\nset xlabel 'times the speed'\nset ylabel 'states'\nplot ";
    for (std::size_t i = 0; i + 1 < summaries.size(); ++i)
        data += fmt::format("{}$h using {}{} title '{}' linecolor rgb '{}'", i ? ", " : "", i + 2,
                            i ? "" : ":xtic(1)", summaries[i].of, kColours[i % std::size(kColours)]);
    return summaries.size() < 2 ? "" : report::plot(data + "\n", 760, 300);
}

std::string table_header(const Page& page) {
    std::string html = "<tr><th>state</th>";
    for (std::size_t i = 0; i < page.contenders(); ++i)
        html += fmt::format("<th>{}, ms</th><th>ratio</th><th>differs, %</th>", escaped(page.label(i)));
    return html + fmt::format("<th>{}, ms</th><th>settings</th></tr>\n", escaped(page.baseline()));
}

std::string time_cell(const bench::StateRun& run, bench::TimeKind kind) {
    if (run.measured()) return fmt::format("<td>{:.3f}</td>", bench::frame_seconds(run, kind) * 1e3);
    return "<td class=\"bad-text\">failed</td>";
}

std::string table_row(const Page& page, const StateRow& row) {
    std::string html = fmt::format("<tr><td>{}</td>", escaped(row.state.name));
    for (std::size_t i = 0; i < page.contenders(); ++i) {
        const bench::StateRun& run = row.runs[i];
        html += time_cell(run, page.kind) + ratio_cell(bench::ratio(row, i, page.kind));
        html += run.difference ? fmt::format("<td>{:.3f}</td>", run.difference->share * 100) : "<td></td>";
    }
    html += time_cell(row.runs.back(), page.kind);
    return html + fmt::format("<td>{}</td></tr>\n", escaped(row.state.state.text()));
}

std::string slowest_table(const Page& page, const bench::Rows& rows, std::size_t contender) {
    const bench::Rows sorted = bench::slowest(rows, contender, page.kind);
    std::string html = "<div class=\"figures\"><table>" + table_header(page);
    for (std::size_t i = 0; i < std::min(kSlowest, sorted.size()); ++i) html += table_row(page, *sorted[i]);
    return html + "</table></div>\n";
}

std::string pictures(const Page& page) {
    std::string html;
    int shown = 0;
    for (const StateRow& row : page.rows)
        for (std::size_t i = 0; i < page.contenders() && shown < kMostPictures; ++i) {
            if (row.runs[i].picture.empty() || row.runs.back().picture.empty()) continue;
            ++shown;
            html += fmt::format(
                "<div class=\"card bad\"><h3>{}</h3><div class=\"theme\">{}: {:.3f} % of the values differ, "
                "by {:.0f} at most</div>",
                escaped(row.state.name), escaped(row.state.state.text()), row.runs[i].difference->share * 100,
                row.runs[i].difference->largest);
            html += report::comparison(picture_of(page.plan, row, i), page.label(i),
                                       picture_of(page.plan, row, page.contenders()), page.baseline());
            html += "</div>\n";
        }
    return html.empty() ? html : "<h2>Pictures that differ</h2>\n" + html;
}

std::string failures(const Page& page) {
    std::string html;
    for (const StateRow& row : page.rows)
        for (std::size_t i = 0; i < row.runs.size(); ++i)
            for (const std::string& failure : row.runs[i].failures)
                html += fmt::format("<li>{}, {}: {}</li>", escaped(row.state.name),
                                    escaped(page.plan.contenders[i].label), escaped(failure));
    return html.empty() ? html : "<h2>Failures</h2><ul class=\"problems\">" + html + "</ul>\n";
}

std::string population_part(const Page& page, const bench::Population& population, std::size_t contender) {
    std::string html = fmt::format("<h2>{}, {} states</h2>\n<div class=\"card\">",
                                   escaped(page.label(contender)), population.name);
    html += sorted_plot(page, population.rows, contender) + histogram_plot(page, population.rows, contender);
    const std::string slow = bench::text_of(bench::slow_stages(population.rows, contender));
    if (!slow.empty()) html += "<div class=\"theme\">" + escaped(slow) + "</div>";
    return html + fmt::format("</div>\n<h3>The {} slowest</h3>\n", kSlowest) +
           slowest_table(page, population.rows, contender);
}

}  // namespace

OIIO::ImageBuf picture_of(const bench::StatePlan& plan, const StateRow& row, std::size_t contender) {
    std::vector<float> values = bench::values_of(row.state.state, row.runs[contender].picture);
    for (float& value : values) value /= 255;
    std::vector<std::uint8_t> raw(values.size() * sizeof(float));
    std::memcpy(raw.data(), values.data(), raw.size());
    const auto channels = static_cast<int>(row.state.state.number(Axis::kBuffer, 2));
    return report::picture_of(raw, plan.width, plan.height, channels, OIIO::TypeDesc::FLOAT);
}

std::string states_page(const bench::StatePlan& plan, const std::vector<StateRow>& rows, bench::TimeKind kind,
                        const std::vector<bench::ReportPart>& parts) {
    const Page page{plan, rows, kind, bench::populations(rows)};
    std::string html = report::page_head("States");
    html += fmt::format(
        "<h1>States</h1><p class=\"lead\">{} states at {}x{}, {} threads, each in a context of its own, "
        "measured in turn with {}. "
        "Ratios are {}'s median {} time of a frame by the other's: more is faster. Random states are of seed "
        "{}.</p>\n",
        rows.size(), plan.width, plan.height, plan.threads, escaped(page.baseline()),
        escaped(page.baseline()), kind == bench::TimeKind::kCpu ? "processor" : "wall clock", plan.seed);
    html += tiles(page) + parts_tiles(parts) + "</div>\n" + histogram_table(page);
    for (std::size_t i = 0; i < page.contenders(); ++i)
        for (const bench::Population& population : page.populations)
            html += population_part(page, population, i);
    html += parts_sections(parts) + failures(page) + pictures(page);
    html += "<h2>All states</h2><div class=\"figures\"><table>" + table_header(page);
    for (const StateRow& row : rows) html += table_row(page, row);
    return html + "</table></div>\n" + report::page_foot();
}

}  // namespace terrazzo
