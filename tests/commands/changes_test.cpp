// A command has its effect on the next draw whatever was drawn before, and none on what was drawn before:
// what is derived from state must be derived again, and vertices that wait must be drawn under the state they
// were given in. Every command with seeded arguments, with and without a draw before it, and with that draw
// finished and still waiting.
#include <gtest/gtest.h>

#include <cstdlib>

#include "trial.h"

namespace terrazzo::test {
namespace {

enum class Before { kNothing, kInvisibleDraw, kFinishedDraw, kWaitingDraw };

Outcome run(const kit::Library& library, const Call& call, unsigned seed, Before before, std::string* text) {
    Trial trial(library, seed);
    trial.arguments.set_pixel_store(trial.gl);
    if (before == Before::kInvisibleDraw) trial.draw_nothing();
    if (before == Before::kFinishedDraw || before == Before::kWaitingDraw) trial.draw_triangles();
    if (before != Before::kWaitingDraw) trial.gl.Finish();
    const auto& arguments = trial.arguments(call);
    *text = RandomArguments::text(call, arguments);
    call.with(trial.gl, arguments.data());
    trial.draw();
    return trial.outcome();
}

// What leaves the program, or waits for more, instead of changing state.
bool is_tried(const Call& call) {
    if (call.kinds.find('q') != std::string_view::npos || call.name.starts_with("glGet")) return false;
    for (std::string_view other :
         {"glBegin", "glEnd", "glNewList", "glEndList", "glSelectBuffer", "glFeedbackBuffer", "glRenderMode",
          "glMapBuffer", "glUnmapBuffer", "glInterleavedArrays"}) {
        if (call.name == other) return false;
    }
    return call.name.find("Pointer") == std::string_view::npos &&
           call.name.find("Framebuffer") == std::string_view::npos &&
           call.name.find("Renderbuffer") == std::string_view::npos;
}

void expect_same(Before one, Before other) {
    const kit::Library library(TERRAZZO_OWN_LIBRARY);
    const char* chosen = std::getenv("TERRAZZO_COMMAND_SEEDS");
    const unsigned seeds = chosen ? static_cast<unsigned>(std::atoi(chosen)) : 3;
    for (const Call& call : kEveryCall) {
        if (!is_tried(call)) continue;
        for (unsigned seed = 1; seed <= (call.inside_begin_end ? 1 : seeds); ++seed) {
            std::string text;
            const Outcome first = run(library, call, seed, one, &text),
                          second = run(library, call, seed, other, &text);
            const std::string found = difference(first, second);
            ASSERT_TRUE(found.empty()) << found << "\n" << text << ", seed " << seed;
        }
    }
}

TEST(CommandChanges, ShowInTheNextDraw) {
    expect_same(Before::kNothing, Before::kInvisibleDraw);
}

TEST(CommandChanges, DoNotShowInTheDrawBefore) {
    expect_same(Before::kFinishedDraw, Before::kWaitingDraw);
}

}  // namespace
}  // namespace terrazzo::test
