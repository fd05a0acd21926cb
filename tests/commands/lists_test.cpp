// Display lists do what the commands in them do: every command that a list holds, with seeded arguments and
// pixel store modes, called at once in one context and through a list in another. Client memory and pixel
// store have changed by the time the list is called (GL 1.5 §5.4).
//
// TERRAZZO_COMMAND_SEEDS=n tries n seeds a command; TERRAZZO_COMMAND=name only commands whose names contain
// it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <numeric>
#include <vector>

#include "trial.h"

namespace terrazzo::test {
namespace {

const kit::Library& library() {
    static const kit::Library own(TERRAZZO_OWN_LIBRARY);
    return own;
}

unsigned seed_count(unsigned usual) {
    const char* text = std::getenv("TERRAZZO_COMMAND_SEEDS");
    return text ? static_cast<unsigned>(std::atoi(text)) : usual;
}

bool is_chosen(const Call& call) {
    const char* text = std::getenv("TERRAZZO_COMMAND");
    return !text || call.name.find(text) != std::string_view::npos;
}

constexpr GLuint kList = 60, kOuterList = 61;
enum class Way { kAtOnce, kTwiceAtOnce, kList, kExecutedAndCalled, kExecuted, kNestedList };
constexpr Way kListWays[] = {Way::kList, Way::kExecuted, Way::kExecutedAndCalled, Way::kNestedList};
constexpr const char* kWayNames[] = {
    "at once",       "twice at once", "list", "compiled, executed and called", "executed while compiled",
    "list in a list"};

// Runs `commands` in a way of `way`; what comes between compiling and calling is there in all of them.
Outcome run(unsigned seed, Way way, bool feedback, const std::function<void(Trial&)>& commands) {
    Trial trial(library(), seed);
    const kit::Gl& gl = trial.gl;
    if (feedback) trial.start_feedback();
    trial.arguments.set_pixel_store(gl);
    const auto compile = [&](GLenum mode) {
        gl.NewList(kList, mode);
        commands(trial);
        gl.EndList();
    };
    switch (way) {
        case Way::kAtOnce:
            commands(trial);
            break;
        case Way::kTwiceAtOnce: {
            const RandomArguments before = trial.arguments;
            commands(trial);
            trial.arguments = before;
            commands(trial);
            break;
        }
        case Way::kList:
        case Way::kNestedList:
            compile(GL_COMPILE);
            break;
        case Way::kExecuted:
        case Way::kExecutedAndCalled:
            compile(GL_COMPILE_AND_EXECUTE);
            break;
    }
    if (way == Way::kNestedList) {
        gl.NewList(kOuterList, GL_COMPILE);
        gl.CallList(kList);
        gl.EndList();
    }
    trial.arguments.spoil();
    gl.PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    for (GLenum mode : {GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS,
                        GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_IMAGES})
        gl.PixelStorei(mode, 1);
    if (way == Way::kList || way == Way::kExecutedAndCalled) gl.CallList(kList);
    if (way == Way::kNestedList) gl.CallList(kOuterList);
    gl.PopClientAttrib();
    return trial.outcome();
}

// Draws from arrays leave the current values as they like (GL 1.5 §2.8), and ours do so differently.
bool leaves_current_values(const Call& call) {
    return call.name.starts_with("glDraw") || call.name.starts_with("glMultiDraw");
}

void forget_current_values(Outcome& outcome) {
    std::erase_if(outcome.state, [](const std::string& line) {
        return line.starts_with("GL_CURRENT_") || line.starts_with("GL_EDGE_FLAG ") ||
               line.find("MATERIAL") != std::string::npos || line.find("FRONT.") != std::string::npos ||
               line.find("BACK.") != std::string::npos;
    });
}

// Begin and End have a test of their own; a call of a list within itself would not end.
bool is_tried(const Call& call) {
    return call.in_lists && call.name != "glBegin" && call.name != "glEnd" && is_chosen(call);
}

// A single value for a vector is refused by TexParameter at once and taken in lists, as in the reference.
bool differs_on_purpose(const Call& call, const std::vector<Arguments>& arguments) {
    return (call.name == "glTexParameterf" || call.name == "glTexParameteri") &&
           static_cast<GLenum>(arguments[1].integer) == GL_TEXTURE_BORDER_COLOR;
}

TEST(CommandLists, EveryCommandDoesTheSameThroughAList) {
    int calls = 0, refused = 0;
    for (const Call& call : kEveryCall) {
        if (!is_tried(call)) continue;
        const bool simple = call.inside_begin_end || call.kinds.size() < 2;
        for (unsigned seed = 1; seed <= seed_count(simple ? 1 : 4); ++seed) {
            std::string text;
            const auto commands = [&](Trial& trial) {
                const auto& arguments = trial.arguments(call);
                text = RandomArguments::text(call, arguments);
                if (!differs_on_purpose(call, arguments)) call.with(trial.gl, arguments.data());
            };
            Outcome once = run(seed, Way::kAtOnce, false, commands),
                    twice = run(seed, Way::kTwiceAtOnce, false, commands);
            ++calls;
            refused += !once.errors.empty();
            if (leaves_current_values(call)) forget_current_values(once), forget_current_values(twice);
            for (Way way : kListWays) {
                Outcome listed = run(seed, way, false, commands);
                if (leaves_current_values(call)) forget_current_values(listed);
                const std::string found = difference(way == Way::kExecutedAndCalled ? twice : once, listed);
                ASSERT_TRUE(found.empty())
                    << found << "\n"
                    << text << ", seed " << seed << ", " << kWayNames[static_cast<int>(way)];
            }
        }
    }
    // Most arguments are good ones, or little would be compared.
    if (!std::getenv("TERRAZZO_COMMAND")) {
        EXPECT_LT(refused, calls / 3);
    }
}

constexpr GLenum kModes[] = {GL_POINTS,         GL_LINES,        GL_LINE_STRIP, GL_LINE_LOOP,  GL_TRIANGLES,
                             GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS,      GL_QUAD_STRIP, GL_POLYGON};

// What may stand between Begin and End, in any order, and state changes between them.
void geometry(Trial& trial, std::string& text) {
    static const std::vector<const Call*> inside = [] {
        std::vector<const Call*> out;
        for (const Call& call : kEveryCall) {
            if (call.in_lists && call.inside_begin_end && call.name != "glEnd" &&
                !call.name.starts_with("glCallList"))
                out.push_back(&call);
        }
        return out;
    }();
    const auto pick = [&](std::size_t count) { return trial.arguments.pick(static_cast<unsigned>(count)); };
    const auto call = [&](const Call& what) {
        const auto& arguments = trial.arguments(what);
        text += "\n  " + RandomArguments::text(what, arguments);
        what.with(trial.gl, arguments.data());
    };
    const Call& vertex = *find_call("glVertex3f");
    for (unsigned primitive = 0; primitive < 3; ++primitive) {
        const GLenum mode = kModes[pick(std::size(kModes))];
        text += "\n  glBegin " + std::to_string(mode);
        trial.gl.Begin(mode);
        const unsigned favourite =
            pick(inside.size());  // streams begin where one attribute comes again and again
        for (unsigned i = 0, count = 1 + pick(9); i < count; ++i) {
            if (pick(2)) call(*inside[favourite]);
            for (unsigned k = pick(3); k > 0; --k) call(*inside[pick(inside.size())]);
            call(vertex);
        }
        trial.gl.End();
        if (pick(2)) call(*inside[pick(inside.size())]);
        if (pick(3) == 0) trial.gl.Translatef(0.0625f, 0, 0);
    }
}

TEST(CommandLists, GeometryIsTheSameThroughAList) {
    std::vector<unsigned> seeds(seed_count(60));
    std::iota(seeds.begin(), seeds.end(), 1u);
    seeds.push_back(836);  // a texture coordinate's q rounded the primitives before it another way
    for (const unsigned seed : seeds) {
        const bool feedback = seed % 2 == 1;
        std::string text;
        const auto commands = [&](Trial& trial) {
            text.clear();
            geometry(trial, text);
        };
        const Outcome once = run(seed, Way::kAtOnce, feedback, commands),
                      twice = run(seed, Way::kTwiceAtOnce, feedback, commands);
        for (Way way : kListWays) {
            const std::string found =
                difference(way == Way::kExecutedAndCalled ? twice : once, run(seed, way, feedback, commands));
            ASSERT_TRUE(found.empty()) << found << "\n"
                                       << "seed " << seed << ", " << kWayNames[static_cast<int>(way)] << text;
        }
    }
}

}  // namespace
}  // namespace terrazzo::test
