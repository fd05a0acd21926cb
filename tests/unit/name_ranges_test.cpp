// Sets of object names, against a plain set of the same names.
#include "gl/name_ranges.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace terrazzo::gl {
namespace {

constexpr GLuint kHighest = ~GLuint{0};

TEST(NameRanges, AgreesWithAPlainSet) {
    constexpr GLuint kNames = 60;
    std::mt19937 random(1);
    const auto name = [&] { return std::uniform_int_distribution<GLuint>(1, kNames)(random); };
    NameRanges ranges;
    std::set<GLuint> plain;
    for (int step = 0; step < 5000; ++step) {
        const auto [first, last] = std::minmax({name(), name()});
        if (step % 2) {
            ranges.insert(first, last);
            for (GLuint n = first; n <= last; ++n) plain.insert(n);
        } else {
            ranges.erase(first, last);
            plain.erase(plain.lower_bound(first), plain.upper_bound(last));
        }
        for (GLuint n = 0; n <= kNames + 1; ++n)
            ASSERT_EQ(ranges.contains(n), plain.contains(n)) << step << ": " << n;
    }
}

TEST(NameRanges, TakesTheLowestGap) {
    NameRanges ranges;
    EXPECT_EQ(ranges.take(3), 1u);
    ranges.insert(10, 10);
    EXPECT_EQ(ranges.take(6), 4u);
    EXPECT_EQ(ranges.take(1), 11u);
    ranges.erase(2, 3);
    EXPECT_EQ(ranges.take(3), 12u);
    EXPECT_EQ(ranges.take(2), 2u);
    EXPECT_EQ(ranges.take(0), 0u);
}

TEST(NameRanges, ReachesTheHighestName) {
    NameRanges ranges;
    EXPECT_EQ(ranges.take(kHighest - 1), 1u);
    EXPECT_EQ(ranges.take(2), 0u);
    EXPECT_EQ(ranges.take(1), kHighest);
    EXPECT_EQ(ranges.take(1), 0u);
    EXPECT_TRUE(ranges.contains(kHighest));
    EXPECT_FALSE(ranges.contains(0));
    ranges.erase(kHighest, kHighest);
    EXPECT_FALSE(ranges.contains(kHighest));
    ranges.insert(kHighest, kHighest);
    ranges.erase(1, kHighest);
    EXPECT_EQ(ranges.take(1), 1u);
}

}  // namespace
}  // namespace terrazzo::gl
