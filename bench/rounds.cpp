// Stage: benchmark, comparing GL libraries. Rounds run on the outside, contenders on the inside.
#include "rounds.h"

#include <algorithm>
#include <cmath>

#include "kit/child.h"

namespace terrazzo::bench {
namespace {

void measure(const Plan& plan, const nlohmann::json& scene, Measurement& measurement) {
    kit::ChildRequest request;
    request.executable = plan.draw_program;
    request.task = "draw";
    request.arguments = scene;
    request.arguments.update({{"library", measurement.contender.library},
                              {"width", plan.width},
                              {"height", plan.height},
                              {"seconds", plan.seconds},
                              {"animate", plan.animate},
                              {"samples", plan.samples}});
    request.environment = thread_environment(measurement.contender.threads);
    const kit::ChildReport report = kit::run_in_child(request);
    if (!report.finished()) {
        measurement.failures.push_back(report.message);
        return;
    }
    for (const auto& error : report.result["errors"])
        measurement.failures.push_back(error.get<std::string>());
    measurement.renderer = report.result["renderer"].get<std::string>();
    measurement.frame_seconds.push_back(report.result["median_frame_seconds"].get<double>());
    measurement.first_frame_seconds.push_back(report.result["first_frame_seconds"].get<double>());
    measurement.peak_resident_kib.push_back(report.result["peak_resident_kib"].get<double>());
}

nlohmann::json to_json(const Measurement& measurement) {
    nlohmann::json json{{"label", measurement.contender.label},
                        {"library", measurement.contender.library},
                        {"threads", measurement.contender.threads},
                        {"renderer", measurement.renderer},
                        {"failures", measurement.failures}};
    if (measurement.measured()) {
        const double seconds = median(measurement.frame_seconds);
        json["frame_seconds"] = seconds;
        json["frames_per_second"] = 1 / seconds;
        json["first_frame_seconds"] = median(measurement.first_frame_seconds);
        json["peak_resident_kib"] = median(measurement.peak_resident_kib);
        json["rounds"] = {{"frame_seconds", measurement.frame_seconds},
                          {"first_frame_seconds", measurement.first_frame_seconds},
                          {"peak_resident_kib", measurement.peak_resident_kib}};
    }
    return json;
}

}  // namespace

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

double geometric_mean(const std::vector<double>& values) {
    double logarithms = 0;
    for (const double value : values) logarithms += std::log(value);
    return values.empty() ? 0 : std::exp(logarithms / static_cast<double>(values.size()));
}

std::vector<std::pair<std::string, std::string>> thread_environment(int threads) {
    const std::string count = std::to_string(threads);
    return {{"TERRAZZO_THREADS", count}, {"LP_NUM_THREADS", count}};
}

std::vector<SceneResult> run(const Plan& plan, const std::function<void(const std::string&)>& progress) {
    std::vector<SceneResult> results;
    for (const nlohmann::json& scene : plan.scenes) {
        SceneResult result{scene.at("scene").get<std::string>(), {}};
        for (const Contender& contender : plan.contenders)
            result.measurements.push_back({contender, {}, {}, {}, {}, {}});
        for (int round = 0; round < plan.rounds; ++round)
            for (Measurement& measurement : result.measurements) {
                progress(result.scene + " round " + std::to_string(round + 1) + " " +
                         measurement.contender.label + " threads " +
                         std::to_string(measurement.contender.threads));
                measure(plan, scene, measurement);
            }
        results.push_back(std::move(result));
    }
    return results;
}

const Measurement* partner(const SceneResult& scene, const Measurement& measurement,
                           const std::string& label) {
    for (const Measurement& other : scene.measurements)
        if (other.contender.label == label && other.contender.threads == measurement.contender.threads)
            return other.measured() ? &other : nullptr;
    return nullptr;
}

nlohmann::json to_json(const Plan& plan, const std::vector<SceneResult>& results,
                       const std::string& baseline) {
    nlohmann::json scenes = nlohmann::json::array();
    for (const SceneResult& result : results) {
        nlohmann::json runs = nlohmann::json::array();
        for (const Measurement& measurement : result.measurements) {
            nlohmann::json run = to_json(measurement);
            const Measurement* other = partner(result, measurement, baseline);
            if (other && measurement.measured())
                run["speed_ratio"] = median(other->frame_seconds) / median(measurement.frame_seconds);
            runs.push_back(std::move(run));
        }
        scenes.push_back({{"scene", result.scene}, {"runs", std::move(runs)}});
    }
    return {{"width", plan.width},     {"height", plan.height},      {"rounds", plan.rounds},
            {"seconds", plan.seconds}, {"animate", plan.animate},    {"samples", plan.samples},
            {"baseline", baseline},    {"scenes", std::move(scenes)}};
}

}  // namespace terrazzo::bench
