// Means, histograms, JSON.
#include "state_summary.h"

#include <algorithm>
#include <cstdio>
#include <set>

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
    if (!run.ways.empty()) json["ways"] = run.ways;
    return json;
}

nlohmann::json to_json(const SlowStages& stages) {
    return {{"states", stages.states}, {"of", stages.known}, {"stages", stages.by_stage}};
}

nlohmann::json to_json(const StateSummary& summary) {
    nlohmann::json histogram = nlohmann::json::array();
    for (std::size_t bin = 0; bin < summary.histogram.size(); ++bin)
        histogram.push_back({{"ratios", bin_name(bin)}, {"states", summary.histogram[bin]}});
    return {
        {"of", summary.of},       {"states", summary.count},    {"geometric_mean", summary.geometric_mean},
        {"worst", summary.worst}, {"slower", summary.slower()}, {"histogram", std::move(histogram)}};
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

Rows rows_of(const std::vector<StateRow>& rows) {
    Rows pointers;
    for (const StateRow& row : rows) pointers.push_back(&row);
    return pointers;
}

std::vector<Population> populations(const std::vector<StateRow>& rows) {
    Population named{"named", {}}, random{"random", {}};
    for (const StateRow& row : rows)
        (row.state.name.rfind("random/", 0) == 0 ? random : named).rows.push_back(&row);
    std::vector<Population> result;
    for (Population* const population : {&named, &random})
        if (!population->rows.empty()) result.push_back(std::move(*population));
    return result;
}

std::vector<StateSummary> summaries(const Rows& rows, std::size_t contender, TimeKind kind) {
    const states::AxisEntry& geometry = states::entry(Axis::kGeometry);
    std::vector<std::vector<double>> ratios(geometry.values.size());
    std::vector<double> all;
    for (const StateRow* const row : rows)
        if (const double value = ratio(*row, contender, kind); value > 0) {
            ratios[row->state.state.index(Axis::kGeometry)].push_back(value);
            all.push_back(value);
        }
    std::vector<StateSummary> result;
    for (std::size_t i = 0; i < ratios.size(); ++i)
        if (!ratios[i].empty()) result.push_back(summarize(geometry.values[i].name, ratios[i]));
    result.push_back(summarize("all", all));
    return result;
}

Rows slowest(const Rows& rows, std::size_t contender, TimeKind kind) {
    Rows sorted;
    for (const StateRow* const row : rows)
        if (ratio(*row, contender, kind) > 0) sorted.push_back(row);
    std::stable_sort(sorted.begin(), sorted.end(), [&](const StateRow* a, const StateRow* b) {
        return ratio(*a, contender, kind) < ratio(*b, contender, kind);
    });
    return sorted;
}

SlowStages slow_stages(const Rows& rows, std::size_t contender) {
    SlowStages stages;
    for (const StateRow* const row : rows) {
        const StateRun& run = row->runs[contender];
        stages.known += !run.ways.empty();
        stages.states += run.has_slow_stage();
        std::set<std::string> taken;
        for (const std::string& way : run.ways)
            for (std::string& stage : slow_stages_of(way)) taken.insert(std::move(stage));
        for (const std::string& stage : taken) ++stages.by_stage[stage];
    }
    return stages;
}

std::string text_of(const SlowStages& stages) {
    if (stages.known == 0) return "";
    std::string text =
        "slow: " + std::to_string(stages.states) + " of " + std::to_string(stages.known) + " states";
    std::string by_stage;
    for (const auto& [stage, count] : stages.by_stage)
        by_stage += (by_stage.empty() ? "" : ", ") + stage + " " + std::to_string(count);
    return by_stage.empty() ? text : text + " (" + by_stage + ")";
}

nlohmann::json to_json(const StatePlan& plan, const std::vector<StateRow>& rows, TimeKind kind) {
    nlohmann::json json{{"width", plan.width},
                        {"height", plan.height},
                        {"threads", plan.threads},
                        {"rounds", plan.rounds},
                        {"seconds", plan.seconds},
                        {"seed", plan.seed},
                        {"clock", kind == TimeKind::kCpu ? "cpu" : "wall"},
                        {"baseline", plan.contenders.back().label}};
    for (std::size_t i = 0; i < plan.contenders.size(); ++i) {
        const StateContender& contender = plan.contenders[i];
        nlohmann::json entry{{"label", contender.label},
                             {"library", contender.library},
                             {"isa", contender.isa},
                             {"renderer", renderer_of(rows, i)}};
        if (i + 1 < plan.contenders.size())
            for (const Population& population : populations(rows)) {
                nlohmann::json part{{"name", population.name}};
                for (const StateSummary& summary : summaries(population.rows, i, kind))
                    part["summaries"].push_back(to_json(summary));
                if (const SlowStages slow = slow_stages(population.rows, i); slow.known > 0)
                    part["slow"] = to_json(slow);
                entry["populations"].push_back(std::move(part));
            }
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
