// The comparison itself: each promise of P2, broken by one pixel more than it allows, must fail.
#include "compare.h"

#include <gtest/gtest.h>

#include <cmath>

namespace terrazzo::piglit {
namespace {

constexpr std::size_t kPixels = 256 * 256;

class CompareTest : public testing::Test {
  protected:
    CompareTest() {
        for (std::size_t i = 0; i < kPixels; ++i)
            for (std::size_t channel = 0; channel < 4; ++channel)
                m_ours.colour.push_back(i < kPixels / 2 ? background_byte(channel)
                                                        : static_cast<std::uint8_t>(100 + channel * 20));
        m_ours.depth.assign(kPixels, 5000);
        m_ours.stencil.assign(kPixels, 3);
        m_ours.values = {{"number", 1.5, 0.25}};
        m_theirs = m_ours;
    }
    static std::uint8_t background_byte(std::size_t channel) {
        return static_cast<std::uint8_t>(std::lround(kBackground[channel] * 255));
    }
    std::size_t problems() const { return compare(m_scene, m_ours, m_theirs).problems.size(); }
    std::uint8_t& drawn_byte(std::size_t pixel) { return m_ours.colour[(kPixels / 2 + pixel) * 4 + 1]; }

    Scene m_scene;
    Drawing m_ours, m_theirs;
};

TEST_F(CompareTest, EqualDrawingsPass) {
    EXPECT_EQ(problems(), 0U);
}

TEST_F(CompareTest, OneStepPassesEverywhere) {
    for (std::size_t i = 0; i < kPixels / 2; ++i) ++drawn_byte(i);
    EXPECT_EQ(problems(), 0U);
}

TEST_F(CompareTest, TwoStepsPassOnTheAllowedShareOnly) {
    const auto allowed = static_cast<std::size_t>(m_scene.tolerance.differing_share * kPixels);
    for (std::size_t i = 0; i < allowed; ++i) drawn_byte(i) += 2;
    EXPECT_EQ(problems(), 0U);
    drawn_byte(allowed) += 2;
    EXPECT_EQ(problems(), 1U);
}

TEST_F(CompareTest, OnePixelOfCoverageFails) {
    for (std::size_t channel = 0; channel < 4; ++channel) m_ours.colour[40 * 4 + channel] = 200;
    EXPECT_EQ(compare(m_scene, m_ours, m_theirs).coverage, 1U);
    EXPECT_EQ(problems(), 1U);
}

TEST_F(CompareTest, DepthPassesWithinOneStep) {
    m_ours.depth[77] += 1;
    EXPECT_EQ(problems(), 0U);
    m_ours.depth[77] += 1;
    EXPECT_EQ(problems(), 1U);
}

TEST_F(CompareTest, StencilMustBeIdentical) {
    m_ours.stencil[1] = 4;
    EXPECT_EQ(problems(), 1U);
}

TEST_F(CompareTest, ValuesHaveTheirTolerance) {
    m_ours.values[0].value = 1.75;
    EXPECT_EQ(problems(), 0U);
    m_ours.values[0].value = 1.76;
    EXPECT_EQ(problems(), 1U);
    m_ours.values[0].value = std::nan("");
    EXPECT_EQ(problems(), 1U);
    m_ours.values.clear();
    EXPECT_EQ(problems(), 1U);
}

TEST_F(CompareTest, GlErrorsFail) {
    m_ours.errors = {"GL_INVALID_ENUM"};
    EXPECT_EQ(problems(), 1U);
    m_theirs.errors = m_ours.errors;
    EXPECT_EQ(problems(), 1U);
}

TEST_F(CompareTest, BlankPicturesFail) {
    for (std::size_t i = 0; i < m_ours.colour.size(); ++i) m_ours.colour[i] = background_byte(i % 4);
    m_theirs.colour = m_ours.colour;
    EXPECT_EQ(problems(), 2U);
    m_scene.draws_nothing_visible = true;
    EXPECT_EQ(problems(), 0U);
}

TEST_F(CompareTest, AFailedChildFails) {
    m_ours.failure = "the child was ended by Segmentation fault";
    EXPECT_EQ(problems(), 1U);
}

TEST_F(CompareTest, HashesSeeEveryPlane) {
    const std::uint64_t hash = hash_of(m_ours);
    EXPECT_EQ(hash, hash_of(m_theirs));
    m_ours.colour[9] ^= 1;
    EXPECT_NE(hash, hash_of(m_ours));
    m_ours = m_theirs;
    m_ours.depth[9] ^= 1;
    EXPECT_NE(hash, hash_of(m_ours));
    m_ours = m_theirs;
    m_ours.stencil[9] ^= 1;
    EXPECT_NE(hash, hash_of(m_ours));
    m_ours = m_theirs;
    m_ours.values[0].value = 2;
    EXPECT_NE(hash, hash_of(m_ours));
}

}  // namespace
}  // namespace terrazzo::piglit
