// The list of states: what it is derived from, that it is valid, unique and always the same.
#include "states/list.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace terrazzo::states {
namespace {

TEST(Axes, AreInTheOrderOfTheirNumbersAndNamedOnce) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < axes().size(); ++i) {
        const AxisEntry& axis = axes()[i];
        EXPECT_EQ(static_cast<std::size_t>(axis.axis), i) << axis.name;
        EXPECT_TRUE(names.insert(axis.name).second) << axis.name;
        std::set<std::string> values;
        for (const Value& value : axis.values) {
            EXPECT_TRUE(values.insert(value.name).second) << axis.name << " " << value.name;
            EXPECT_EQ(std::string(value.name).find_first_of(" =/"), std::string::npos) << value.name;
        }
        EXPECT_GE(axis.values.size(), 2U) << axis.name;
    }
}

TEST(States, TextsAreReadBack) {
    for (const NamedState& named : named_states())
        EXPECT_EQ(State::parse(named.state.text()), named.state) << named.name;
    EXPECT_EQ(State().text(), "");
    EXPECT_EQ(State::parse("fog=exp2 units=one").text(), "units=one fog=exp2");
}

TEST(States, WhatIsNoStateIsRefused) {
    for (const char* text : {"fog", "fog=thick", "weather=fog", "fog=exp2  units=one", "=", "fog="})
        EXPECT_THROW(State::parse(text), std::invalid_argument) << text;
}

TEST(States, SettlingTwiceIsSettlingOnce) {
    for (const NamedState& named : random_states(3000, 5))
        EXPECT_EQ(settled(named.state), named.state) << named.state.text();
}

TEST(States, WhatHasNoMeaningIsAtItsDefault) {
    EXPECT_EQ(settled(State::parse("filter=trilinear target=cube environment=decal")), State());
    EXPECT_EQ(settled(State::parse("material=tracks-colour")), State());
    EXPECT_EQ(settled(State::parse("primitive=points cull=back offset=on")).text(), "primitive=points");
    EXPECT_EQ(settled(State::parse("units=one target=3d format=depth-compare")).text(),
              "units=one format=depth-compare");
}

TEST(States, DefectsOfTheReferenceAreFew) {
    EXPECT_EQ(reference_defect(State()), nullptr);
    EXPECT_NE(reference_defect(State::parse("samples=four scissor=on")), nullptr);
    EXPECT_NE(reference_defect(State::parse("samples=four primitive=mode-line")), nullptr);
    EXPECT_EQ(reference_defect(State::parse("samples=four")), nullptr);
    // What is measured by name is also compared.
    for (const NamedState& named : named_states())
        EXPECT_EQ(reference_defect(named.state), nullptr) << named.name;
}

TEST(List, HasEnoughStatesOverThreeGeometries) {
    const std::vector<NamedState> states = named_states();
    std::map<std::size_t, int> by_geometry;
    for (const NamedState& named : states) ++by_geometry[named.state.index(Axis::kGeometry)];
    EXPECT_EQ(by_geometry.size(), 3U);
    for (const auto& [geometry, count] : by_geometry) EXPECT_GE(count, 60) << geometry;
}

TEST(List, NamesAndStatesAreThereOnce) {
    std::set<std::string> names, texts;
    for (const NamedState& named : named_states()) {
        EXPECT_TRUE(names.insert(named.name).second) << named.name;
        EXPECT_TRUE(texts.insert(named.state.text()).second) << named.name;
        EXPECT_EQ(settled(named.state), named.state) << named.name;
    }
}

TEST(List, ShowsEveryValueOfEveryAxis) {
    const std::vector<NamedState> states = named_states();
    for (const AxisEntry& axis : axes())
        for (std::size_t i = 0; i < axis.values.size(); ++i) {
            const auto shows = [&](const NamedState& named) { return named.state.index(axis.axis) == i; };
            EXPECT_TRUE(std::any_of(states.begin(), states.end(), shows))
                << axis.name << "=" << axis.values[i].name;
        }
}

TEST(List, IsTheSameEveryTime) {
    const auto same = [](const std::vector<NamedState>& a, const std::vector<NamedState>& b) {
        return std::equal(
            a.begin(), a.end(), b.begin(), b.end(),
            [](const NamedState& x, const NamedState& y) { return x.name == y.name && x.state == y.state; });
    };
    EXPECT_TRUE(same(named_states(), named_states()));
    EXPECT_TRUE(same(random_states(50, 3), random_states(50, 3)));
    EXPECT_FALSE(same(random_states(50, 3), random_states(50, 4)));
    // A longer list begins like a shorter one: a state of a seed is found again by its number.
    std::vector<NamedState> longer = random_states(50, 3);
    longer.resize(20);
    EXPECT_TRUE(same(longer, random_states(20, 3)));
}

}  // namespace
}  // namespace terrazzo::states
