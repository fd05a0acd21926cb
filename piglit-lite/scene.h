// One scene = one function over the GL function table, one theme, drawn once per library in a child process.
// Input: a current context of the scene's format, cleared to kBackground, depth 1, stencil 0, everything else
// in its initial state. Output: pixels, and values noted by the scene. Invariant: a scene is deterministic
// and leaves no GL error pending (errors it provokes, it takes and notes).
#pragma once

#include <string>
#include <vector>

#include "kit/offscreen.h"

namespace terrazzo::piglit {

using kit::Gl;

// Promise P2: within 1/255 on at least 99.98 % of pixels, coverage and stencil identical, depth within one
// step. A scene that states another share says why beside it.
struct Tolerance {
    double colour_steps = 1;          // of 1/255
    double differing_share = 0.0002;  // of all pixels may differ by more than that
    double coverage_share = 0;        // of all pixels may be drawn in one picture and background in the other
    double depth_steps = 1;           // of the depth format
    double depth_share = 0;           // of all pixels may differ by more than that
    double stencil_share = 0;
};

struct NotedValue {
    std::string name;
    double value;
    double tolerance;  // absolute
};

// Values that a scene reads back and wants compared between libraries.
class Notes {
  public:
    void value(std::string name, double value, double tolerance = 0) {
        m_values.push_back({std::move(name), value, tolerance});
    }
    template <typename Number, std::size_t Count>
    void values(const std::string& name, const Number (&numbers)[Count], double tolerance = 0) {
        for (std::size_t i = 0; i < Count; ++i)
            value(name + "[" + std::to_string(i) + "]", static_cast<double>(numbers[i]), tolerance);
    }
    const std::vector<NotedValue>& all() const { return m_values; }

  private:
    std::vector<NotedValue> m_values;
};

inline constexpr float kBackground[4] = {0.125F, 0.14F, 0.18F, 1.0F};

struct Scene {
    const char* name = "";
    const char* file = "";  // its chapter
    void (*draw)(const Gl&, Notes&) = nullptr;
    const char* theme = "";
    Tolerance tolerance{};
    kit::ContextOptions context{};
    bool draws_nothing_visible = false;  // its theme is values; a plain picture is expected
    const char* window_only = nullptr;   // why it is not to be drawn to an object in the window's place
    // A difference from the reference that is known and not yet understood, in words. The scene then counts
    // as open, not as failed; and it fails when the difference is gone, so that this goes too.
    const char* open_difference = nullptr;
    bool reference_in_rgba = false;  // the reference draws RGBA bytes whatever the scene's format says
};

// Registers before main; scenes() lists by file, then in the order of registration.
struct Registration {
    explicit Registration(const Scene& scene);
};
const std::vector<Scene>& scenes();
const Scene* find_scene(const std::string& name);
std::string chapter_of(const Scene& scene);  // file name without folder and ending

// SCENE(name, "theme", .tolerance = {...}) { body using gl and notes }
#define SCENE(scene_name, theme_text, ...)                                                             \
    static void scene_name([[maybe_unused]] const terrazzo::piglit::Gl& gl,                            \
                           [[maybe_unused]] terrazzo::piglit::Notes& notes);                           \
    static const terrazzo::piglit::Registration scene_name##_registration(terrazzo::piglit::Scene{     \
        .name = #scene_name, .file = __FILE__, .draw = scene_name, .theme = theme_text, __VA_ARGS__}); \
    static void scene_name([[maybe_unused]] const terrazzo::piglit::Gl& gl,                            \
                           [[maybe_unused]] terrazzo::piglit::Notes& notes)

}  // namespace terrazzo::piglit
