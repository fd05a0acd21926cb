// Memory that runs out, wherever the library asks for it: GL_OUT_OF_MEMORY or the call's own answer, the
// state as it was, and with memory again the same command works and the picture is the one that it would have
// been.
//
// usage: exhaustion_test [--all] [--seed SEED] [GoogleTest's arguments]; without --all a sample that the seed
// chooses.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>

#include "exhaust.h"
#include "failing_memory.h"

namespace terrazzo::test {

std::vector<Program> all_programs() {
    std::vector<Program> all;
    for (const auto& programs : {vertex_programs, state_programs, list_programs, texture_programs,
                                 pixel_programs, object_programs, context_programs})
        for (Program& program : programs()) all.push_back(std::move(program));
    return all;
}

namespace {

bool test_all = false;
unsigned seed = 1;
constexpr unsigned kSampled = 40;  // one in so many

const kit::Library& library() {
    static const kit::Library own(TERRAZZO_OWN_LIBRARY);
    return own;
}

const std::vector<Program>& programs() {
    static const std::vector<Program> all = all_programs();
    return all;
}

class ExhaustionTest : public testing::TestWithParam<std::size_t> {};

TEST_P(ExhaustionTest, LeavesEverythingAsItWas) {
    const Program& program = programs()[GetParam()];
    ASSERT_NE(library().gl.Begin, nullptr);
    ASSERT_TRUE(watch_library("/libOSMesa.so"));
    Exhaustion exhaustion(library(), program);
    if (HasFailure()) return;
    std::minstd_rand random(seed + 7919 * static_cast<unsigned>(GetParam()));
    random.discard(16);
    long asked = 0, tested = 0;
    for (std::size_t command = 0; command < program.commands.size(); ++command) {
        asked += exhaustion.allocations()[command];
        for (const bool for_good : {false, true}) {
            // What happens after a failure asks for memory too: there may be more than undisturbed.
            for (long number = 0;; ++number) {
                const bool beyond = number >= exhaustion.allocations()[command];
                if (!test_all && random() % kSampled != 0) {
                    if (beyond) break;
                    continue;
                }
                ++tested;
                if (!exhaustion.test({command, number, for_good}) || HasFailure()) break;
            }
            if (HasFailure()) return;
        }
    }
    EXPECT_GT(asked, 0) << "nothing can fail";
    RecordProperty("allocations", static_cast<int>(asked));
    std::printf("%s: %ld allocations, %ld failures tested\n", program.name.c_str(), asked, tested);
}

INSTANTIATE_TEST_SUITE_P(Programs, ExhaustionTest, testing::Range(std::size_t{0}, programs().size()),
                         [](const auto& info) { return programs()[info.param].name; });

}  // namespace
}  // namespace terrazzo::test

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--all") == 0)
            terrazzo::test::test_all = true;
        else if (std::strcmp(argv[i], "--seed") == 0 && i + 1 < argc)
            terrazzo::test::seed = static_cast<unsigned>(std::strtoul(argv[++i], nullptr, 10));
    }
    std::printf("seed %u\n", terrazzo::test::seed);
    return RUN_ALL_TESTS();
}
