// Windows as wide and as high as they may be: triangles over all of them, and far beyond, give the
// reference's picture. Set-up's integers are at their largest there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "child_runs.h"
#include "kit/offscreen.h"
#include "random.h"

namespace terrazzo::coverage {
namespace {

using nlohmann::json;

json draw_extent(const json& a) {
    const kit::Library library(a.at("library").get<std::string>());
    const kit::OffscreenContext context(library, {.width = a.at("width"), .height = a.at("height")});
    const kit::Gl& gl = library.gl;
    Random random(1, 0);
    gl.Enable(GL_DEPTH_TEST);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Begin(GL_TRIANGLES);
    for (int i = 0; i < 300; ++i) {
        gl.Color3f(random.number(0.1f, 1), random.number(0.1f, 1), random.number(0.1f, 1));
        // Slivers and small ones among those that fill the window.
        const float reach = random.one_of({1.4f, 0.2f, 0.01f});
        const float x = random.number(-1, 1), y = random.number(-1, 1);
        for (int corner = 0; corner < 3; ++corner)
            gl.Vertex3f(x + random.number(-reach, reach), y + random.number(-reach, reach),
                        random.number(-1, 1));
    }
    gl.End();
    gl.Finish();
    const auto picture = context.colour_buffer();
    return json::binary({picture.begin(), picture.end()});
}

std::vector<uint8_t> picture_of(const Renderer& renderer, int width, int height) {
    const json result = run_task("extent", renderer, {{"width", width}, {"height", height}});
    if (result.is_null()) return {};
    return result.get_binary();
}

class Extents : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(Extents, AreTheReferences) {
    if (std::ifstream(TERRAZZO_REFERENCE_LIBRARY).fail())
        GTEST_SKIP() << TERRAZZO_REFERENCE_LIBRARY " is missing";
    const auto [width, height] = GetParam();
    const std::vector<uint8_t> ours = picture_of(kOurs, width, height),
                               theirs = picture_of(kTheirs, width, height);
    ASSERT_EQ(ours.size(), static_cast<size_t>(width) * static_cast<size_t>(height) * 4);
    ASSERT_EQ(theirs.size(), ours.size());
    size_t drawn = 0, wrong = 0;
    for (size_t i = 0; i < ours.size(); ++i) {
        drawn += theirs[i] != 0;
        wrong += std::abs(ours[i] - theirs[i]) > 1;
    }
    EXPECT_EQ(wrong, 0u);
    EXPECT_GT(drawn, ours.size() / 2);
}

INSTANTIATE_TEST_SUITE_P(Windows, Extents,
                         testing::Values(std::pair(16384, 97), std::pair(97, 16384), std::pair(16384, 1),
                                         std::pair(1, 16384)),
                         [](const auto& info) {
                             return std::to_string(info.param.first) + "x" +
                                    std::to_string(info.param.second);
                         });

}  // namespace
}  // namespace terrazzo::coverage

int main(int argc, char** argv) {
    int exit_code = 0;
    if (terrazzo::kit::serve_child(argc, argv, {{"extent", terrazzo::coverage::draw_extent}}, &exit_code))
        return exit_code;
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
