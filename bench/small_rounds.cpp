// Children that are asked in turn.
#include "small_rounds.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include "kit/dialogue.h"
#include "rounds.h"

namespace terrazzo::bench {
namespace {

class Contestant {
  public:
    Contestant(const SmallPlan& plan, const SmallContender& contender) {
        m_request.executable = plan.draw_program;
        m_request.task = "small";
        m_request.arguments = {{"library", contender.library}};
        m_request.environment = thread_environment(plan.threads);
    }

    void open(const small_frames::Description& frame, SmallRun& run) {
        if (!m_child || !m_child->is_open()) m_child = std::make_unique<kit::Dialogue>(m_request);
        const nlohmann::json answer = ask({{"open", frame.name()}}, run);
        if (answer.is_null()) return;
        for (const auto& error : answer.at("errors")) run.failures.push_back(error.get<std::string>());
        if (!answer.at("steady").get<bool>()) run.failures.push_back("the second frame is another picture");
        run.picture = answer.at("picture").get_binary();
        if (frame.content != small_frames::Content::kEmpty && is_uniform(frame, run.picture))
            run.failures.push_back("the picture is uniform");
    }
    void measure(double seconds, SmallRun& run) {
        const nlohmann::json answer = ask({{"measure", seconds}}, run);
        if (answer.is_null()) return;
        run.cpu_seconds.push_back(answer.at("cpu_seconds").get<double>() / answer.at("frames").get<double>());
    }

  private:
    // Null where there is no answer.
    nlohmann::json ask(const nlohmann::json& question, SmallRun& run) {
        kit::ChildReport report = m_child->ask(question);
        if (report.finished()) return std::move(report.result);
        run.failures.push_back(report.message);
        return nullptr;
    }

    kit::ChildRequest m_request;
    std::unique_ptr<kit::Dialogue> m_child;
};

template <typename Value>
double differing_values(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b, double step) {
    const std::size_t count = a.size() / sizeof(Value);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < count; ++i) {
        Value ours, theirs;
        std::memcpy(&ours, a.data() + i * sizeof ours, sizeof ours);
        std::memcpy(&theirs, b.data() + i * sizeof theirs, sizeof theirs);
        differing += !(std::fabs(static_cast<double>(ours) - static_cast<double>(theirs)) <= step);
    }
    return static_cast<double>(differing) / static_cast<double>(count);
}

}  // namespace

double SmallRun::frame_seconds() const {
    return cpu_seconds.empty() ? 0 : median(cpu_seconds);
}

double SmallRow::ratio(std::size_t contender) const {
    const double own = runs[contender].frame_seconds();
    return own > 0 ? runs.back().frame_seconds() / own : 0;
}

double differing_share(const small_frames::Description& frame, const std::vector<std::uint8_t>& a,
                       const std::vector<std::uint8_t>& b) {
    if (a.empty() || a.size() != b.size()) return 1;
    return frame.readout == small_frames::Readout::kDepth ? differing_values<float>(a, b, 1.0 / 255)
                                                          : differing_values<std::uint8_t>(a, b, 1);
}

bool is_uniform(const small_frames::Description& frame, const std::vector<std::uint8_t>& picture) {
    const std::size_t pixel = frame.readout == small_frames::Readout::kRgb ? 3 : 4;
    return picture.size() < pixel ||
           std::equal(picture.begin() + static_cast<std::ptrdiff_t>(pixel), picture.end(), picture.begin());
}

std::vector<SmallRow> run_small(const SmallPlan& plan, const std::function<void(const SmallRow&)>& done) {
    std::vector<std::unique_ptr<Contestant>> contestants;
    for (const SmallContender& contender : plan.contenders)
        contestants.push_back(std::make_unique<Contestant>(plan, contender));
    std::vector<SmallRow> rows;
    for (const small_frames::Description& frame : plan.frames) {
        SmallRow row{frame, std::vector<SmallRun>(plan.contenders.size())};
        for (std::size_t i = 0; i < contestants.size(); ++i) contestants[i]->open(frame, row.runs[i]);
        for (SmallRun& run : row.runs)
            run.differing = differing_share(frame, run.picture, row.runs.back().picture);
        for (int round = 0; round < plan.rounds; ++round)
            for (std::size_t i = 0; i < contestants.size(); ++i)
                if (row.runs[i].failures.empty()) contestants[i]->measure(plan.seconds, row.runs[i]);
        done(row);
        for (SmallRun& run : row.runs) run.picture.clear();
        rows.push_back(std::move(row));
    }
    return rows;
}

nlohmann::json to_json(const SmallPlan& plan, const std::vector<SmallRow>& rows) {
    nlohmann::json frames = nlohmann::json::array();
    for (const SmallRow& row : rows) {
        nlohmann::json runs = nlohmann::json::array();
        for (std::size_t i = 0; i < row.runs.size(); ++i) {
            const SmallRun& run = row.runs[i];
            runs.push_back({{"label", plan.contenders[i].label},
                            {"failures", run.failures},
                            {"cpu_seconds", run.frame_seconds()},
                            {"rounds", run.cpu_seconds},
                            {"ratio", row.ratio(i)},
                            {"differing_share", run.differing}});
        }
        frames.push_back({{"frame", row.frame.name()}, {"runs", std::move(runs)}});
    }
    return {{"baseline", plan.contenders.back().label},
            {"rounds", plan.rounds},
            {"threads", plan.threads},
            {"frames", std::move(frames)}};
}

}  // namespace terrazzo::bench
