// One open frame at a time.
#include "small_task.h"

#include <time.h>

#include <optional>
#include <stdexcept>

#include "kit/dialogue.h"
#include "kit/offscreen.h"
#include "small_frames.h"

namespace terrazzo::small_frames {
namespace {

double seconds_of(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

kit::ContextOptions options_of(const Description& description) {
    kit::ContextOptions options;
    options.width = options.height = description.size;
    return options;
}

class OpenFrames {
  public:
    OpenFrames(const kit::Library& library, const Description& description)
        : m_context(library, options_of(description)), m_frames(library.gl, description) {}

    nlohmann::json first_frames() {
        m_frames.draw();
        const std::vector<std::uint8_t> first = m_frames.picture();
        m_frames.draw();
        nlohmann::json errors = nlohmann::json::array();
        for (const GLenum error : m_context.take_errors()) errors.push_back(kit::error_name(error));
        const auto* renderer = reinterpret_cast<const char*>(m_context.library().gl.GetString(GL_RENDERER));
        return {{"renderer", renderer ? renderer : ""},
                {"errors", errors},
                {"steady", first == m_frames.picture()},
                {"picture", nlohmann::json::binary(m_frames.picture())}};
    }
    // Looks at the clock seldom: it costs as much as a frame might.
    nlohmann::json measure(double seconds) {
        constexpr int kAtATime = 16;
        const double wall = seconds_of(CLOCK_MONOTONIC), cpu = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
        int frames = 0;
        double used = 0;
        while (frames == 0 || used < seconds) {
            for (int i = 0; i < kAtATime; ++i) m_frames.draw();
            frames += kAtATime;
            used = seconds_of(CLOCK_PROCESS_CPUTIME_ID) - cpu;
        }
        return {
            {"frames", frames}, {"wall_seconds", seconds_of(CLOCK_MONOTONIC) - wall}, {"cpu_seconds", used}};
    }

  private:
    kit::OffscreenContext m_context;
    Frames m_frames;
};

}  // namespace

nlohmann::json small_task(const nlohmann::json& arguments) {
    const kit::Library library(arguments.at("library").get<std::string>());
    std::optional<OpenFrames> open;
    kit::answer_questions([&](const nlohmann::json& question) -> nlohmann::json {
        if (question.contains("open")) {
            open.reset();
            open.emplace(library, Description::parse(question.at("open").get<std::string>()));
            return open->first_frames();
        }
        if (!open) throw std::runtime_error("no frame is open");
        return open->measure(question.at("measure").get<double>());
    });
    return nullptr;
}

}  // namespace terrazzo::small_frames
