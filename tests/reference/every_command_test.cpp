// Every command of the registry with seeded arguments, good and bad, in random order, in our libOSMesa and in
// the reference's, a process each: after every command the error and everything that can be queried must be
// equal.
//
// TERRAZZO_COMMAND_SEED=n plays one seed; TERRAZZO_COMMAND_SEEDS=n plays the first n.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>

#include "kit/child.h"
#include "kit/offscreen.h"
#include "random_arguments.h"
#include "state_dump.h"

namespace terrazzo::test {
namespace {

using nlohmann::json;

constexpr unsigned kSeeds = 30;
constexpr int kSteps = 60;

bool starts_with_any(std::string_view name, std::initializer_list<std::string_view> beginnings) {
    return std::ranges::any_of(beginnings, [&](std::string_view text) { return name.starts_with(text); });
}

// The reference takes read buffers that GL 1.5 does not know (the player of state_compare does without them)
// and negative strides of edge flags. Else what is compared elsewhere: pictures (piglit-lite), frame buffer
// objects, lists and buffers with their contents; and what gives the program something instead of changing
// state.
bool is_played(const Call& call) {
    if (call.kinds.find('q') != std::string_view::npos) return false;
    return !starts_with_any(call.name, {"glBegin",
                                        "glEnd",
                                        "glGet",
                                        "glIs",
                                        "glGen",
                                        "glDelete",
                                        "glNewList",
                                        "glCallList",
                                        "glMapBuffer",
                                        "glUnmapBuffer",
                                        "glBuffer",
                                        "glBindBuffer",
                                        "glArrayElement",
                                        "glDraw",
                                        "glMultiDraw",
                                        "glCopy",
                                        "glAccum",
                                        "glClear",
                                        "glBitmap",
                                        "glRect",
                                        "glEval",
                                        "glReadBuffer",
                                        "glListBase",
                                        "glRenderMode",
                                        "glFinish",
                                        "glFlush",
                                        "glBlit",
                                        "glBindFramebuffer",
                                        "glFramebuffer",
                                        "glRenderbuffer",
                                        "glBindRenderbuffer",
                                        "glCheckFramebuffer"});
}

// Without the addresses of client memory, texels, which have tests of their own with the steps of their
// formats, and two values with which the reference breaks the specification: it does not clamp raster colours
// (GL 1.5 §2.13.8) and does not normalise integer priorities (§3.8.4).
std::vector<std::string> dump(const kit::Gl& gl) {
    std::vector<std::string> lines = dump_everything(gl);
    for (std::string& line : lines) {
        for (const char* name : {"_ARRAY_POINTER ", "GL_CURRENT_RASTER_COLOR", "GL_TEXTURE_PRIORITY"}) {
            if (line.find(name) != std::string::npos) line.clear();
        }
        // The format of an image that is not there: 1, and in the reference what it was once asked for.
        if (line.starts_with("image ") && line.find(" 0 0 0 0 ") != std::string::npos) line.clear();
        if (line.starts_with("image ")) line.resize(std::min(line.size(), line.find(" texels")));
    }
    return lines;
}

json play_seed(const kit::Library& library, unsigned seed) {
    static const std::vector<const Call*> calls = [] {
        std::vector<const Call*> out;
        for (const Call& call : kEveryCall) {
            if (is_played(call)) out.push_back(&call);
        }
        return out;
    }();
    const kit::OffscreenContext context(library, {.accum_bits = 16, .width = 32, .height = 32});
    RandomArguments random(seed);
    random.be_plain();
    std::vector<std::string> before = dump(library.gl);
    json steps = json::array();
    for (int i = 0; i < kSteps; ++i) {
        const Call& call = *calls[random.pick(static_cast<unsigned>(calls.size()))];
        if (call.name.find("Image") != std::string_view::npos) random.set_pixel_store(library.gl);
        const auto& arguments = random(call);
        call.with(library.gl, arguments.data());
        const GLenum error = library.gl.GetError();
        std::vector<std::string> after = dump(library.gl);
        steps.push_back({{"command", RandomArguments::text(call, arguments)},
                         {"error", error},
                         {"changed", changed(before, after)}});
        before = std::move(after);
    }
    return steps;
}

json play(const json& arguments) {
    const kit::Library library(arguments.at("library").get<std::string>());
    json seeds = json::array();
    for (unsigned seed : arguments.at("seeds")) seeds.push_back(play_seed(library, seed));
    return seeds;
}

json run(const std::string& library, const std::vector<unsigned>& seeds) {
    const kit::ChildReport report = kit::run_in_child({.executable = {},
                                                       .task = "play",
                                                       .arguments = {{"library", library}, {"seeds", seeds}},
                                                       .environment = {}});
    EXPECT_TRUE(report.finished()) << library << ": " << report.message << '\n' << report.output;
    return report.finished() ? report.result : json::array();
}

std::string difference(const json& ours, const json& theirs) {
    std::string text;
    // Where several arguments are bad, either error will do.
    if ((ours["error"] == 0) != (theirs["error"] == 0))
        text += "\n  error " + ours["error"].dump() + ", the reference's is " + theirs["error"].dump();
    const std::set<std::string> our_lines = ours["changed"], their_lines = theirs["changed"];
    for (const std::string& line : our_lines) {
        if (!their_lines.contains(line)) text += "\n  ours    " + line;
    }
    for (const std::string& line : their_lines) {
        if (!our_lines.contains(line)) text += "\n  theirs  " + line;
    }
    return text;
}

std::vector<unsigned> chosen_seeds() {
    if (const char* seed = std::getenv("TERRAZZO_COMMAND_SEED"))
        return {static_cast<unsigned>(std::atoi(seed))};
    const char* count = std::getenv("TERRAZZO_COMMAND_SEEDS");
    std::vector<unsigned> seeds(count ? static_cast<unsigned>(std::atoi(count)) : kSeeds);
    for (unsigned i = 0; i < seeds.size(); ++i) seeds[i] = i + 1;
    return seeds;
}

TEST(EveryCommand, LeavesTheStateOfTheReference) {
    if (std::ifstream(TERRAZZO_REFERENCE_LIBRARY).fail())
        GTEST_SKIP() << TERRAZZO_REFERENCE_LIBRARY " is missing";
    const std::vector<unsigned> seeds = chosen_seeds();
    const json ours = run(TERRAZZO_OWN_LIBRARY, seeds), theirs = run(TERRAZZO_REFERENCE_LIBRARY, seeds);
    ASSERT_EQ(ours.size(), seeds.size());
    ASSERT_EQ(theirs.size(), seeds.size());
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        // Only the first difference of a seed: from there on the two are in different states.
        for (std::size_t step = 0; step < ours[i].size(); ++step) {
            const std::string found = difference(ours[i][step], theirs[i][step]);
            if (found.empty()) continue;
            ADD_FAILURE() << "seed " << seeds[i] << " step " << step << ": "
                          << ours[i][step]["command"].get<std::string>() << found;
            break;
        }
    }
}

}  // namespace
}  // namespace terrazzo::test

int main(int argc, char** argv) {
    int exit_code = 0;
    if (terrazzo::kit::serve_child(argc, argv, {{"play", terrazzo::test::play}}, &exit_code))
        return exit_code;
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
