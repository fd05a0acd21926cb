// Children that are asked in turn.
#include "state_rounds.h"

#include <algorithm>
#include <cctype>
#include <future>
#include <memory>
#include <sstream>

#include "kit/dialogue.h"
#include "rounds.h"

namespace terrazzo::bench {
namespace {

constexpr std::chrono::seconds kLongestAnswer{120};

// Letters and digits alone, small: "AVX-512" is avx512.
std::string plain(const std::string& text) {
    std::string result;
    for (const char c : text)
        if (std::isalnum(static_cast<unsigned char>(c)))
            result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

// A library that does not have an instruction set takes another in silence.
bool draws_with(const std::string& renderer, const std::string& isa) {
    return isa.empty() || plain(renderer).find(plain(isa)) != std::string::npos;
}

// Small: which stages there are does not depend on the size.
constexpr int kWaysSize = 32;

class Contestant {
  public:
    Contestant(const StatePlan& plan, const StateContender& contender)
        : m_plan(plan), m_contender(contender) {}

    void open(const states::NamedState& state, StateRun& run) {
        if (!m_child || !m_child->is_open()) start();
        const auto result =
            ask({{"open", state.state.text()}, {"width", m_plan.width}, {"height", m_plan.height}}, run);
        if (!result) return;
        run.renderer = result->at("renderer").get<std::string>();
        for (const auto& error : result->at("errors")) run.failures.push_back(error.get<std::string>());
        if (!result->at("steady").get<bool>()) run.failures.push_back("the second frame is another picture");
        run.picture = result->at("colour").get_binary();
        if (is_uniform(state.state, run.picture)) run.failures.push_back("the picture is uniform");
        run.opened = draws_with(run.renderer, m_contender.isa);
        if (run.renderer.find("Terrazzo") != std::string::npos) find_ways(state, run);
        if (!run.opened) run.failures.push_back("not drawn with " + m_contender.isa + ": " + run.renderer);
    }
    void measure(StateRun& run) {
        const auto result = ask({{"measure", m_plan.seconds}}, run);
        if (!result) return;
        const double frames = result->at("frames").get<double>();
        run.cpu_seconds.push_back(result->at("cpu_seconds").get<double>() / frames);
        run.wall_seconds.push_back(result->at("wall_seconds").get<double>() / frames);
    }

  private:
    // In a process of its own, which tells at its end. That it counts would be measured otherwise.
    void find_ways(const states::NamedState& state, StateRun& run) const {
        kit::ChildRequest request = child();
        request.environment.emplace_back("TERRAZZO_DEBUG", "stages");
        kit::Dialogue dialogue(request);
        dialogue.ask({{"open", state.state.text()}, {"width", kWaysSize}, {"height", kWaysSize}});
        run.ways = ways_of(dialogue.finish());
    }
    kit::ChildRequest child() const {
        kit::ChildRequest request;
        request.executable = m_plan.draw_program;
        request.task = "states";
        request.arguments = {{"library", m_contender.library}};
        request.environment = thread_environment(m_plan.threads);
        if (!m_contender.isa.empty()) request.environment.emplace_back("TERRAZZO_ISA", m_contender.isa);
        request.timeout = kLongestAnswer;
        return request;
    }
    void start() { m_child.emplace(child()); }
    std::optional<nlohmann::json> ask(const nlohmann::json& question, StateRun& run) {
        kit::ChildReport report = m_child->ask(question);
        if (report.finished()) return std::move(report.result);
        run.failures.push_back(report.output.empty() ? report.message
                                                     : report.message + ": " + report.output);
        return std::nullopt;
    }

    const StatePlan& m_plan;
    const StateContender& m_contender;
    std::optional<kit::Dialogue> m_child;
};

// Pictures that agree are let go.
void compare_pictures(const StatePlan& plan, StateRow& row) {
    StateRun& baseline = row.runs.back();
    bool any_kept = false;
    for (StateRun& run : row.runs) {
        if (&run == &baseline) continue;
        if (!run.picture.empty() && !baseline.picture.empty())
            run.difference = difference(row.state.state, run.picture, baseline.picture);
        const bool kept = run.difference && run.difference->share > plan.tolerated_share;
        any_kept |= kept;
        if (!kept) run.picture.clear();
    }
    if (!any_kept) baseline.picture.clear();
}

// All at once: what is made here is not measured.
void open_all(const std::vector<std::unique_ptr<Contestant>>& contestants, StateRow& row) {
    std::vector<std::future<void>> opening;
    for (std::size_t i = 0; i < contestants.size(); ++i)
        opening.push_back(
            std::async(std::launch::async, [&, i] { contestants[i]->open(row.state, row.runs[i]); }));
    for (std::future<void>& one : opening) one.get();
}

}  // namespace

std::vector<std::string> ways_of(const std::string& log) {
    std::vector<std::string> ways;
    std::istringstream lines(log);
    // "terrazzo: stages: end: 12 tiles, 192 fragments: output=store"
    const std::string counted = " fragments: ";
    for (std::string line; std::getline(lines, line);) {
        const std::size_t at = line.find(counted);
        if (line.rfind("terrazzo: stages: end: ", 0) == 0 && at != std::string::npos)
            ways.push_back(line.substr(at + counted.size()));
    }
    return ways;
}

std::vector<std::string> slow_stages_of(const std::string& way) {
    std::vector<std::string> slow;
    std::istringstream stages(way);
    const std::string mark = "(slow)";
    for (std::string stage; stages >> stage;)
        if (stage.size() > mark.size() && stage.compare(stage.size() - mark.size(), mark.size(), mark) == 0)
            slow.push_back(stage.substr(0, stage.size() - mark.size()));
    return slow;
}

bool StateRun::has_slow_stage() const {
    return std::any_of(ways.begin(), ways.end(),
                       [](const std::string& way) { return !slow_stages_of(way).empty(); });
}

std::vector<StateRow> run_states(const StatePlan& plan, const std::function<void(StateRow&)>& done) {
    std::vector<std::unique_ptr<Contestant>> contestants;
    for (const StateContender& contender : plan.contenders)
        contestants.push_back(std::make_unique<Contestant>(plan, contender));
    std::vector<StateRow> rows;
    for (const states::NamedState& state : plan.states) {
        StateRow row{state, std::vector<StateRun>(plan.contenders.size())};
        open_all(contestants, row);
        compare_pictures(plan, row);
        for (int round = 0; round < plan.rounds; ++round)
            for (std::size_t i = 0; i < contestants.size(); ++i)
                if (row.runs[i].opened) contestants[i]->measure(row.runs[i]);
        done(row);
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace terrazzo::bench
