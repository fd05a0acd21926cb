// A command has its effect on the next draw whatever was drawn before: what is derived from state for drawing
// must be derived again. Every command with seeded arguments, after a draw that touches no pixel and without
// one.
#include <gtest/gtest.h>

#include <cstdlib>

#include "trial.h"

namespace terrazzo::test {
namespace {

Outcome run(const kit::Library& library, const Call& call, unsigned seed, bool draw_before,
            std::string* text) {
    Trial trial(library, seed);
    trial.arguments.set_pixel_store(trial.gl);
    if (draw_before) trial.draw_nothing();
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

TEST(CommandChanges, ShowInTheNextDraw) {
    const kit::Library library(TERRAZZO_OWN_LIBRARY);
    const char* chosen = std::getenv("TERRAZZO_COMMAND_SEEDS");
    const unsigned seeds = chosen ? static_cast<unsigned>(std::atoi(chosen)) : 4;
    for (const Call& call : kEveryCall) {
        if (!is_tried(call)) continue;
        for (unsigned seed = 1; seed <= (call.inside_begin_end ? 2 : seeds); ++seed) {
            std::string text;
            const Outcome fresh = run(library, call, seed, false, &text),
                          after = run(library, call, seed, true, &text);
            const std::string found = difference(fresh, after);
            ASSERT_TRUE(found.empty()) << found << "\n" << text << ", seed " << seed;
        }
    }
}

}  // namespace
}  // namespace terrazzo::test
