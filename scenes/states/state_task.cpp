// One open state at a time.
#include "state_task.h"

#include <time.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>

#include "kit/dialogue.h"
#include "kit/object_in_window.h"
#include "kit/offscreen.h"
#include "state_drawing.h"

namespace terrazzo::states {
namespace {

double seconds_of(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

kit::ContextOptions options_for(const State& state, int width, int height) {
    kit::ContextOptions options;
    options.format = state.number(Axis::kBuffer);
    options.type = state.number(Axis::kBuffer, 1);
    options.width = width;
    options.height = height;
    return options;
}

// A context in a state.
class OpenState {
  public:
    OpenState(const kit::Library& library, const State& state, int width, int height)
        : m_gl(library.gl), m_drawing(state), m_context(library, options_for(state, width, height)) {
        if (const GLenum samples = state.number(Axis::kSamples); samples > 1)
            m_object.emplace(m_gl, m_context.options(), static_cast<int>(samples));
        m_drawing.prepare(m_gl, width, height);
    }

    void draw_frame() {
        if (m_object) m_object->bind();
        m_drawing.draw(m_gl, 0);
        if (m_object) m_object->show();
        m_gl.Finish();
    }
    nlohmann::json first_frames() {
        draw_frame();
        const std::vector<std::uint8_t> first = picture();
        draw_frame();
        std::vector<std::uint8_t> second = picture();
        nlohmann::json errors = nlohmann::json::array();
        for (const GLenum error : m_context.take_errors()) errors.push_back(kit::error_name(error));
        const auto* renderer = reinterpret_cast<const char*>(m_gl.GetString(GL_RENDERER));
        return {{"renderer", renderer ? renderer : ""},
                {"errors", errors},
                {"steady", first == second},
                {"colour", nlohmann::json::binary(std::move(second))}};
    }
    nlohmann::json measure(double seconds) {
        const double wall = seconds_of(CLOCK_MONOTONIC), cpu = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
        int frames = 0;
        double used = 0;
        while (frames == 0 || used < seconds) {
            draw_frame();
            ++frames;
            used = seconds_of(CLOCK_PROCESS_CPUTIME_ID) - cpu;
        }
        return {
            {"frames", frames}, {"wall_seconds", seconds_of(CLOCK_MONOTONIC) - wall}, {"cpu_seconds", used}};
    }

  private:
    std::vector<std::uint8_t> picture() const {
        const auto pixels = m_context.colour_buffer();
        return {pixels.begin(), pixels.end()};
    }

    const kit::Gl& m_gl;
    StateDrawing m_drawing;
    kit::OffscreenContext m_context;
    std::optional<kit::ObjectInWindow> m_object;
};

class Answers {
  public:
    explicit Answers(std::string path) : m_path(std::move(path)) {}

    nlohmann::json to(const nlohmann::json& question) {
        if (question.contains("open")) {
            m_state.reset();
            if (!m_library) m_library.emplace(m_path);
            m_state.emplace(*m_library, State::parse(question.at("open").get<std::string>()),
                            question.at("width").get<int>(), question.at("height").get<int>());
            return m_state->first_frames();
        }
        if (question.contains("close")) {
            m_state.reset();
            return nullptr;
        }
        if (!m_state) throw std::runtime_error("no state is open");
        return m_state->measure(question.at("measure").get<double>());
    }

  private:
    std::string m_path;
    std::optional<kit::Library> m_library;
    std::optional<OpenState> m_state;
};

}  // namespace

nlohmann::json state_task(const nlohmann::json& arguments) {
    Answers answers(arguments.at("library").get<std::string>());
    kit::answer_questions([&](const nlohmann::json& question) { return answers.to(question); });
    return nullptr;
}

}  // namespace terrazzo::states
