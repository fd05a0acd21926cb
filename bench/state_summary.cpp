// Means, histograms, JSON.
#include "state_summary.h"

#include <algorithm>
#include <cstdio>

#include "rounds.h"

namespace terrazzo::bench {
namespace {

using states::Axis;

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

nlohmann::json axes_of(const states::State& state) {
    nlohmann::json json;
    for (const states::AxisEntry& axis : states::axes()) json[axis.name] = state.value(axis.axis).name;
    return json;
}

nlohmann::json to_json(const StateContender& contender, const StateRun& run) {
    nlohmann::json json{{"label", contender.label}, {"failures", run.failures}};
    if (run.measured()) {
        json["cpu_seconds"] = median(run.cpu_seconds);
        json["wall_seconds"] = median(run.wall_seconds);
        json["rounds"] = {{"cpu_seconds", run.cpu_seconds}, {"wall_seconds", run.wall_seconds}};
    }
    if (run.difference)
        json["picture"] = {{"differing_share", run.difference->share},
                           {"largest_difference", run.difference->largest}};
    return json;
}

nlohmann::json to_json(const StateSummary& summary) {
    nlohmann::json histogram = nlohmann::json::array();
    for (std::size_t bin = 0; bin < summary.histogram.size(); ++bin)
        histogram.push_back({{"ratios", bin_name(bin)}, {"states", summary.histogram[bin]}});
    return {{"of", summary.of},
            {"states", summary.count},
            {"geometric_mean", summary.geometric_mean},
            {"worst", summary.worst},
            {"histogram", std::move(histogram)}};
}

// What the contender's renderer called itself first.
std::string renderer_of(const std::vector<StateRow>& rows, std::size_t contender) {
    for (const StateRow& row : rows)
        if (!row.runs[contender].renderer.empty()) return row.runs[contender].renderer;
    return "";
}

}  // namespace

double frame_seconds(const StateRun& run, TimeKind kind) {
    if (!run.measured()) return 0;
    return median(kind == TimeKind::kCpu ? run.cpu_seconds : run.wall_seconds);
}

double ratio(const StateRow& row, std::size_t contender, TimeKind kind) {
    const double own = frame_seconds(row.runs[contender], kind),
                 baseline = frame_seconds(row.runs.back(), kind);
    return own > 0 && baseline > 0 ? baseline / own : 0;
}

std::string bin_name(std::size_t bin) {
    if (bin == 0) return std::string("<").append(short_number(kHistogramBounds.front()));
    if (bin == kHistogramBounds.size()) return std::string(">").append(short_number(kHistogramBounds.back()));
    return short_number(kHistogramBounds[bin - 1]) + "-" + short_number(kHistogramBounds[bin]);
}

StateSummary summarize(std::string of, const std::vector<double>& ratios) {
    StateSummary summary;
    summary.of = std::move(of);
    summary.count = static_cast<int>(ratios.size());
    summary.geometric_mean = geometric_mean(ratios);
    if (!ratios.empty()) summary.worst = *std::min_element(ratios.begin(), ratios.end());
    for (const double value : ratios) {
        const auto above = std::upper_bound(kHistogramBounds.begin(), kHistogramBounds.end(), value);
        ++summary.histogram[static_cast<std::size_t>(above - kHistogramBounds.begin())];
    }
    return summary;
}

std::vector<StateSummary> summaries(const std::vector<StateRow>& rows, std::size_t contender, TimeKind kind) {
    const states::AxisEntry& geometry = states::entry(Axis::kGeometry);
    std::vector<std::vector<double>> ratios(geometry.values.size());
    std::vector<double> all;
    for (const StateRow& row : rows)
        if (const double value = ratio(row, contender, kind); value > 0) {
            ratios[row.state.state.index(Axis::kGeometry)].push_back(value);
            all.push_back(value);
        }
    std::vector<StateSummary> result;
    for (std::size_t i = 0; i < ratios.size(); ++i)
        if (!ratios[i].empty()) result.push_back(summarize(geometry.values[i].name, ratios[i]));
    result.push_back(summarize("all", all));
    return result;
}

std::vector<const StateRow*> slowest(const std::vector<StateRow>& rows, std::size_t contender,
                                     TimeKind kind) {
    std::vector<const StateRow*> sorted;
    for (const StateRow& row : rows)
        if (ratio(row, contender, kind) > 0) sorted.push_back(&row);
    std::stable_sort(sorted.begin(), sorted.end(), [&](const StateRow* a, const StateRow* b) {
        return ratio(*a, contender, kind) < ratio(*b, contender, kind);
    });
    return sorted;
}

nlohmann::json to_json(const StatePlan& plan, const std::vector<StateRow>& rows, TimeKind kind) {
    nlohmann::json json{{"width", plan.width},
                        {"height", plan.height},
                        {"threads", plan.threads},
                        {"rounds", plan.rounds},
                        {"seconds", plan.seconds},
                        {"clock", kind == TimeKind::kCpu ? "cpu" : "wall"},
                        {"baseline", plan.contenders.back().label}};
    for (std::size_t i = 0; i < plan.contenders.size(); ++i) {
        const StateContender& contender = plan.contenders[i];
        nlohmann::json entry{{"label", contender.label},
                             {"library", contender.library},
                             {"isa", contender.isa},
                             {"renderer", renderer_of(rows, i)}};
        if (i + 1 < plan.contenders.size())
            for (const StateSummary& summary : summaries(rows, i, kind))
                entry["summaries"].push_back(to_json(summary));
        json["contenders"].push_back(std::move(entry));
    }
    for (const StateRow& row : rows) {
        nlohmann::json runs = nlohmann::json::array();
        for (std::size_t i = 0; i < row.runs.size(); ++i) {
            runs.push_back(to_json(plan.contenders[i], row.runs[i]));
            if (const double value = ratio(row, i, kind); value > 0) runs.back()["ratio"] = value;
        }
        json["states"].push_back({{"name", row.state.name},
                                  {"state", row.state.state.text()},
                                  {"axes", axes_of(row.state.state)},
                                  {"runs", std::move(runs)}});
    }
    return json;
}

}  // namespace terrazzo::bench
