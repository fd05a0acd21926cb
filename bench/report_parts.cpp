// Parts from JSON, and what becomes of their times.
#include "report_parts.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "rounds.h"

namespace terrazzo::bench {
namespace {

PartRow row_of(const nlohmann::json& json, const std::vector<std::string>& contenders) {
    PartRow row{json.at("name").get<std::string>(), json.value("note", ""), {}};
    const nlohmann::json& times = json.at("times");
    for (const std::string& contender : contenders)
        row.times.push_back(times.value(contender, std::vector<double>{}));
    return row;
}

ReportPart part_of(const nlohmann::json& json) {
    ReportPart part{json.at("title").get<std::string>(),
                    json.at("about").get<std::string>(),
                    json.value("problem", ""),
                    json.at("contenders").get<std::vector<std::string>>(),
                    {}};
    for (const nlohmann::json& row : json.at("rows")) part.rows.push_back(row_of(row, part.contenders));
    if (!part.rows.empty() && part.contenders.size() < 2)
        throw std::runtime_error(part.title + " has nothing to compare");
    return part;
}

nlohmann::json to_json(const ReportPart& part, const PartRow& row) {
    nlohmann::json runs = nlohmann::json::array();
    for (std::size_t i = 0; i < part.contenders.size(); ++i) {
        nlohmann::json run{{"label", part.contenders[i]}, {"rounds", row.times[i]}};
        if (row.seconds(i) > 0) run["seconds"] = row.seconds(i);
        if (row.ratio(i) > 0) run["ratio"] = row.ratio(i);
        runs.push_back(std::move(run));
    }
    return {{"name", row.name}, {"note", row.note}, {"runs", std::move(runs)}};
}

nlohmann::json to_json(const ReportPart& part) {
    nlohmann::json json{{"title", part.title},
                        {"about", part.about},
                        {"problem", part.problem},
                        {"summaries", nlohmann::json::array()},
                        {"rows", nlohmann::json::array()}};
    for (std::size_t i = 0; i + 1 < part.contenders.size(); ++i) {
        const StateSummary summary = summary_of(part, i);
        json["summaries"].push_back({{"label", part.contenders[i]},
                                     {"rows", summary.count},
                                     {"geometric_mean", summary.geometric_mean},
                                     {"worst", summary.worst},
                                     {"slower", summary.slower()}});
    }
    for (const PartRow& row : part.rows) json["rows"].push_back(to_json(part, row));
    return json;
}

}  // namespace

double PartRow::seconds(std::size_t contender) const {
    return times[contender].empty() ? 0 : median(times[contender]);
}

double PartRow::ratio(std::size_t contender) const {
    const double own = seconds(contender), baseline = seconds(times.size() - 1);
    return own > 0 && baseline > 0 ? baseline / own : 0;
}

std::vector<ReportPart> load_parts(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read " + path);
    try {
        std::vector<ReportPart> parts;
        for (const nlohmann::json& part : nlohmann::json::parse(file)) parts.push_back(part_of(part));
        return parts;
    } catch (const nlohmann::json::exception& error) {
        throw std::runtime_error(path + " has no parts of a report: " + error.what());
    }
}

StateSummary summary_of(const ReportPart& part, std::size_t contender) {
    std::vector<double> ratios;
    for (const PartRow* const row : slowest(part, contender)) ratios.push_back(row->ratio(contender));
    return summarize(part.title, ratios);
}

std::vector<const PartRow*> slowest(const ReportPart& part, std::size_t contender) {
    std::vector<const PartRow*> sorted;
    for (const PartRow& row : part.rows)
        if (row.ratio(contender) > 0) sorted.push_back(&row);
    std::stable_sort(sorted.begin(), sorted.end(), [&](const PartRow* a, const PartRow* b) {
        return a->ratio(contender) < b->ratio(contender);
    });
    return sorted;
}

nlohmann::json to_json(const std::vector<ReportPart>& parts) {
    nlohmann::json json = nlohmann::json::array();
    for (const ReportPart& part : parts) json.push_back(to_json(part));
    return json;
}

}  // namespace terrazzo::bench
