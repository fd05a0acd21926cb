// Coverage of seeded points, lines and triangles against Debian's libOSMesa, each library in a process of its
// own: through an exact projection the same pixels, in perspective at most one primitive of 10 000 with other
// edge pixels. Meshes are covered once everywhere; vertices without a window position stay within their
// scissor.
//
// TERRAZZO_COVERAGE_PRIMITIVES says how many primitives are drawn, TERRAZZO_COVERAGE_SEED from which seed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdarg>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "child_runs.h"
#include "meshes.h"
#include "sheets.h"

namespace terrazzo::coverage {
namespace {

using nlohmann::json;

template <typename Value>
json to_binary(const std::vector<Value>& values) {
    std::vector<uint8_t> bytes(values.size() * sizeof(Value));
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return json::binary(std::move(bytes));
}
template <typename Value>
std::vector<Value> from_binary(const json& binary) {
    const std::vector<uint8_t>& bytes = binary.get_binary();
    std::vector<Value> values(bytes.size() / sizeof(Value));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
}

json serve_cells(const json& a) {
    return to_binary(draw_cells(a.at("library"), a.at("seed"), a.at("count")));
}
json serve_cell(const json& a) {
    return to_binary(draw_cell(a.at("library"), a.at("seed"), a.at("cell")));
}
json serve_meshes(const json& a) {
    return to_binary(draw_meshes(a.at("library"), a.at("seed"), a.at("count")));
}
json serve_strays(const json& a) {
    return to_binary(draw_strays(a.at("library"), a.at("seed"), a.at("count")));
}

uint32_t seed() {
    return number_from("TERRAZZO_COVERAGE_SEED", 1);
}
uint32_t cell_count() {
    return (number_from("TERRAZZO_COVERAGE_PRIMITIVES", 200000) + kCellPrimitives - 1) / kCellPrimitives;
}

template <typename Value>
std::vector<Value> run(const char* task, const Renderer& renderer, json arguments) {
    arguments["seed"] = seed();
    const json result = run_task(task, renderer, std::move(arguments));
    return result.is_null() ? std::vector<Value>() : from_binary<Value>(result);
}

bool has_reference() {
    return !std::ifstream(TERRAZZO_REFERENCE_LIBRARY).fail();
}

// Which pixels differ of one primitive, and whether all are at an edge: where the reference covers some of
// the eight round them, or the pixel itself, and not the others.
struct PixelDifference {
    int pixels = 0;
    bool only_at_edges = true;
    std::string first;
};
PixelDifference compare_pixels(uint32_t cell, uint32_t bit) {
    const auto ours = run<uint32_t>("cell", kOurs, {{"cell", cell}});
    const auto theirs = run<uint32_t>("cell", kTheirs, {{"cell", cell}});
    const Rectangle r = place_of(cell).viewport;
    PixelDifference result;
    if (ours.size() != theirs.size()) return {-1, false, ""};
    const auto index = [&](int x, int y) {
        return static_cast<size_t>(y) * static_cast<size_t>(r.width) + static_cast<size_t>(x);
    };
    const auto covered = [&](int x, int y) { return (theirs[index(x, y)] >> bit & 1) != 0; };
    for (int y = 0; y < r.height; ++y) {
        for (int x = 0; x < r.width; ++x) {
            if (((ours[index(x, y)] ^ theirs[index(x, y)]) >> bit & 1) == 0) continue;
            if (result.pixels++ == 0) result.first = std::to_string(x) + ' ' + std::to_string(y);
            bool edge = false;
            for (int j = std::max(y - 1, 0); j <= std::min(y + 1, r.height - 1); ++j)
                for (int i = std::max(x - 1, 0); i <= std::min(x + 1, r.width - 1); ++i)
                    edge |= covered(i, j) != covered(x, y);
            result.only_at_edges &= edge;
        }
    }
    return result;
}

[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...) {
    char text[400];
    va_list arguments;
    va_start(arguments, pattern);
    std::vsnprintf(text, sizeof text, pattern, arguments);
    va_end(arguments);
    return text;
}

// All that it takes to draw the primitive again.
std::string describe(uint32_t cell, uint32_t bit) {
    const Rectangle r = place_of(cell).viewport;
    const Cell made = make_cell(seed(), cell, is_perspective(cell), r.width, r.height);
    const auto& v = made.volume;
    const auto& p = made.placement;
    std::string text = format(
        "seed %u, cell %u (%s), primitive %u; window 1024 1024, glViewport(%d, %d, %d, %d), %s(%a, "
        "%a, %a, %a, %a, %a), ",
        seed(), cell, name(made.family), bit, r.x, r.y, r.width, r.height,
        made.perspective ? "glFrustum" : "glOrtho", v[0], v[1], v[2], v[3], v[4], v[5]);
    if (made.perspective) {
        text += format("glTranslatef(%a, %a, %a), glRotatef(%a, %a, %a, %a), ", p[4], p[5], p[6], p[0], p[1],
                       p[2], p[3]);
    }
    text += format("size or width %g, mode %#x:", made.size, made.mode);
    for (const auto& vertex : vertices_of(made, bit))
        text += format(" (%a %a %a %a)", vertex[0], vertex[1], vertex[2], vertex[3]);
    return text;
}

struct Kind {
    size_t drawn = 0, visible = 0, different = 0;
    uint64_t pixels = 0;
};

TEST(Coverage, IsTheReferences) {
    if (!has_reference()) GTEST_SKIP() << TERRAZZO_REFERENCE_LIBRARY " is missing";
    const uint32_t cells = cell_count();
    const auto ours = run<Footprint>("cells", kOurs, {{"count", cells}});
    const auto theirs = run<Footprint>("cells", kTheirs, {{"count", cells}});
    ASSERT_EQ(ours.size(), static_cast<size_t>(cells) * kCellPrimitives);
    ASSERT_EQ(theirs.size(), ours.size());

    Kind kinds[2], families[kFamilies];  // exact, in perspective
    for (size_t i = 0; i < ours.size(); ++i) {
        const auto cell = static_cast<uint32_t>(i / kCellPrimitives),
                   bit = static_cast<uint32_t>(i % kCellPrimitives);
        const bool perspective = is_perspective(cell), differs = ours[i] != theirs[i];
        for (Kind* const kind : {&kinds[perspective], &families[cell % kFamilies]}) {
            ++kind->drawn;
            kind->visible += theirs[i].pixels != 0;
            kind->pixels += theirs[i].pixels;
            kind->different += differs;
        }
        if (!differs || kinds[perspective].different > 20) continue;
        const PixelDifference pixels = compare_pixels(cell, bit);
        const std::string text =
            describe(cell, bit) + format("; %u pixels instead of %u, %d differ, the first at %s",
                                         ours[i].pixels, theirs[i].pixels, pixels.pixels,
                                         pixels.first.c_str());
        // Alone in its cell it may be right: then another cell's primitive has been drawn to its place.
        EXPECT_TRUE(perspective && pixels.only_at_edges && pixels.pixels > 0) << text;
        std::printf("differs: %s\n", text.c_str());
    }
    for (int f = 0; f < kFamilies; ++f) {
        std::printf("  %-15s %6zu primitives, %6zu visible, %9llu pixels, %zu differ\n",
                    name(static_cast<Family>(f)), families[f].drawn, families[f].visible,
                    static_cast<unsigned long long>(families[f].pixels), families[f].different);
    }
    for (const bool perspective : {false, true}) {
        const Kind& kind = kinds[perspective];
        std::printf("%s: %zu primitives, %zu visible, %llu pixels; %zu differ\n",
                    perspective ? "perspective" : "exact projection", kind.drawn, kind.visible,
                    static_cast<unsigned long long>(kind.pixels), kind.different);
        EXPECT_GT(kind.visible, kind.drawn / 2) << "the corpus must show";
        EXPECT_LE(kind.different, perspective ? kind.drawn / 10000 : 0);
    }
}

TEST(Coverage, IsTheSameForThreadsAndInstructionSets) {
    const uint32_t cells = (cell_count() + 3) / 4;  // the suite `stress` has random draws for all of them
    const auto one = run<Footprint>("cells", kOurs, {{"count", cells}});
    const auto other = run<Footprint>("cells", kThreaded, {{"count", cells}});
    ASSERT_EQ(one.size(), static_cast<size_t>(cells) * kCellPrimitives);
    ASSERT_EQ(other.size(), one.size());
    size_t visible = 0, different = 0;
    for (size_t i = 0; i < one.size(); ++i) {
        visible += one[i].pixels != 0;
        if (one[i] == other[i]) continue;
        if (++different <= 5)
            ADD_FAILURE() << describe(static_cast<uint32_t>(i / kCellPrimitives),
                                      static_cast<uint32_t>(i % kCellPrimitives));
    }
    EXPECT_EQ(different, 0u);
    EXPECT_GT(visible, one.size() / 2);
}

TEST(Coverage, CountsSharedEdgesOnce) {
    const uint32_t count = std::max(cell_count() / 16, 6u);
    const auto ours = run<MeshResult>("meshes", kOurs, {{"count", count}});
    ASSERT_EQ(ours.size(), count);
    size_t triangles = 0;
    for (uint32_t i = 0; i < count; ++i) {
        triangles += ours[i].triangles;
        EXPECT_EQ(ours[i].missed, 0u) << "mesh " << i << " of seed " << seed();
        EXPECT_EQ(ours[i].doubled, 0u) << "mesh " << i << " of seed " << seed();
    }
    std::printf("%u meshes of %zu triangles cover each pixel of 512 x 512 once\n", count, triangles);
    EXPECT_GT(triangles, 500u * count) << "the meshes must be fine";
    const auto threaded = run<MeshResult>("meshes", kThreaded, {{"count", count / 4}});
    ASSERT_EQ(threaded.size(), count / 4);
    EXPECT_TRUE(std::equal(threaded.begin(), threaded.end(), ours.begin()));
    if (!has_reference()) GTEST_SKIP() << TERRAZZO_REFERENCE_LIBRARY " is missing";
    EXPECT_EQ(ours, run<MeshResult>("meshes", kTheirs, {{"count", count}}));
}

// NaN, infinities, edges through the eye: nothing crashes, nothing is drawn beyond the scissor, and what is
// drawn is always the same. The reference draws anything there, past its scissor too.
TEST(Coverage, OfStraysStaysInTheScissor) {
    const uint32_t sheets = std::max(cell_count() / 300, 1u);
    const auto ours = run<StrayResult>("strays", kOurs, {{"count", sheets}});
    ASSERT_EQ(ours.size(), sheets);
    for (uint32_t i = 0; i < sheets; ++i) {
        EXPECT_EQ(ours[i].outside, 0u) << "sheet " << i << " of seed " << seed();
        EXPECT_GT(ours[i].inside, 1024u * 1024 / 10) << "sheet " << i << " of seed " << seed();
    }
    EXPECT_EQ(ours, run<StrayResult>("strays", kThreaded, {{"count", sheets}}));
    std::printf("%u strays stay within their scissors\n", sheets * kStraysOfSheet * kCellPrimitives);
}

}  // namespace
}  // namespace terrazzo::coverage

int main(int argc, char** argv) {
    using namespace terrazzo::coverage;
    int exit_code = 0;
    if (terrazzo::kit::serve_child(argc, argv,
                                   {{"cells", serve_cells},
                                    {"cell", serve_cell},
                                    {"meshes", serve_meshes},
                                    {"strays", serve_strays}},
                                   &exit_code))
        return exit_code;
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
