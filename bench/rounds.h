// Stage: benchmark, comparing GL libraries.
// Input: scenes, libraries, thread counts. Output: medians per (scene, library, threads) over interleaved
// rounds. Invariant: each measurement is a fresh child process; within a round every contender runs once (A B
// A B ...), so that a machine that slows down slows all of them.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace terrazzo::bench {

struct Contender {
    std::string label;
    std::string library;
    int threads;
};

struct Plan {
    std::string draw_program;
    std::vector<Contender> contenders;
    std::vector<nlohmann::json> scenes;  // arguments of the draw task that name the scene
    int rounds = 3;
    double seconds = 0.5;  // per measurement
    int width = 1024;
    int height = 1024;
    bool animate = false;
    int samples = 0;  // of a pixel
};

struct Measurement {
    Contender contender;
    std::string renderer;
    std::vector<double> frame_seconds;  // one median a round
    std::vector<double> first_frame_seconds;
    std::vector<double> peak_resident_kib;
    std::vector<std::string> failures;

    bool measured() const { return !frame_seconds.empty(); }
};

struct SceneResult {
    std::string scene;
    std::vector<Measurement> measurements;  // in the order of Plan::contenders
};

double median(std::vector<double> values);
// 0 of no values.
double geometric_mean(const std::vector<double>& values);

// `progress` gets a line of text before each measurement.
std::vector<SceneResult> run(const Plan& plan, const std::function<void(const std::string&)>& progress);

// The measurement of `label` at the same thread count as `measurement`; null when it failed or is not there.
const Measurement* partner(const SceneResult& scene, const Measurement& measurement,
                           const std::string& label);

nlohmann::json to_json(const Plan& plan, const std::vector<SceneResult>& results,
                       const std::string& baseline);

// The variables that give a child this many rasterizer threads, whichever library it loads.
std::vector<std::pair<std::string, std::string>> thread_environment(int threads);

}  // namespace terrazzo::bench
