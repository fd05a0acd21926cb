// Stage: piglit-lite, drawing scenes with every library and configuration.
#include "runner.h"

#include <atomic>
#include <chrono>
#include <mutex>
#include <span>
#include <thread>

namespace terrazzo::piglit {
namespace {

using Environment = std::vector<std::pair<std::string, std::string>>;

Drawing draw(const Options& options, const Scene& scene, const std::string& library,
             Environment environment) {
    kit::ChildRequest request;
    request.executable = options.draw_program;
    request.task = "draw";
    request.arguments = {{"scene", scene.name},
                         {"library", library},
                         {"in_object", options.in_object},
                         {"samples", options.samples},
                         {"in_rgba", scene.reference_in_rgba && library == options.theirs}};
    request.environment = std::move(environment);
    return drawing_of(kit::run_in_child(request));
}

Drawing draw_softpipe(const Options& options, const Scene& scene) {
    return draw(options, scene, options.theirs, {{"GALLIUM_DRIVER", "softpipe"}});
}

std::string configuration_name(int threads, const std::string& isa) {
    return std::to_string(threads) + " threads" + (isa.empty() ? "" : ", " + isa);
}

struct Configuration {
    int threads;
    std::string isa;
};

// Every instruction set with the first thread count, and every thread count with the first instruction set: the
// two choices do not know of each other, and the scalar kernels take as long as all the others together.
std::vector<Configuration> configurations(const Options& options) {
    std::vector<Configuration> all;
    for (const std::string& isa : options.isas) all.push_back({options.threads.front(), isa});
    for (const int threads : std::span(options.threads).subspan(1))
        all.push_back({threads, options.isas.front()});
    return all;
}

// The first configuration is the one compared with the reference; the others must give its bits.
void draw_ours(const Options& options, SceneReport& report) {
    if (options.ours_is_softpipe) {
        report.ours = draw_softpipe(options, *report.scene);
        return;
    }
    std::string first_name;
    for (const auto& [threads, isa] : configurations(options)) {
        const std::string name = configuration_name(threads, isa);
        Environment environment{{"TERRAZZO_THREADS", std::to_string(threads)}};
        if (!isa.empty()) environment.emplace_back("TERRAZZO_ISA", isa);
        Drawing drawing = draw(options, *report.scene, options.ours, std::move(environment));
        if (first_name.empty()) {
            first_name = name;
            report.ours = std::move(drawing);
        } else if (!drawing.drawn()) {
            report.problems.push_back(name + ": " + drawing.failure);
        } else if (report.ours.drawn() && hash_of(drawing) != hash_of(report.ours)) {
            report.problems.push_back(name + " does not give the same bits as " + first_name);
        }
    }
}

SceneReport run_scene(const Options& options, const Scene& scene) {
    const auto start = std::chrono::steady_clock::now();
    SceneReport report;
    report.scene = &scene;
    report.theirs =
        draw(options, scene, options.theirs, {{"GALLIUM_DRIVER", "llvmpipe"}, {"LP_NUM_THREADS", "0"}});
    draw_ours(options, report);
    report.comparison = compare(scene, report.ours, report.theirs);
    const std::vector<std::string>& differences = report.comparison.problems;
    const bool judged = options.ours != options.theirs && !options.ours_is_softpipe;
    if (report.scene->open_difference == nullptr || !judged) {
        report.problems.insert(report.problems.begin(), differences.begin(), differences.end());
    } else if (differences.empty()) {
        report.problems.emplace_back("agrees with the reference now: its open_difference is to go");
    } else {
        report.open = true;
    }
    if (options.softpipe) {
        report.softpipe = draw_softpipe(options, scene);
        report.softpipe_comparison = compare(scene, report.softpipe, report.theirs);
    }
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return report;
}

}  // namespace

std::vector<SceneReport> run(const Options& options, const std::vector<const Scene*>& chosen,
                             const std::function<void(const SceneReport&)>& finished) {
    std::vector<SceneReport> reports(chosen.size());
    std::atomic<std::size_t> next{0};
    std::mutex reporting;
    const auto work = [&] {
        for (std::size_t i = next++; i < chosen.size(); i = next++) {
            reports[i] = run_scene(options, *chosen[i]);
            if (options.fail_fast && !reports[i].passed()) next = chosen.size();
            const std::lock_guard lock(reporting);
            finished(reports[i]);
        }
    };
    std::vector<std::jthread> workers;
    for (unsigned i = 1; i < options.jobs; ++i) workers.emplace_back(work);
    work();
    workers.clear();
    std::erase_if(reports, [](const SceneReport& report) { return report.scene == nullptr; });
    return reports;
}

}  // namespace terrazzo::piglit
