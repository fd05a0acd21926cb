// Stage: client side, a state of `terrazzo bench states`: a value on every axis.
// Input: values by name. Output: valid GL that draws something. Invariant: after settle() no axis is set that
// another one makes meaningless, so that two states are equal when they draw the same.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "axes.h"

namespace terrazzo::states {

class State {
  public:
    // Every axis at its default.
    State() = default;

    std::size_t index(Axis axis) const { return m_values[static_cast<std::size_t>(axis)]; }
    const Value& value(Axis axis) const { return entry(axis).values[index(axis)]; }
    GLenum number(Axis axis, std::size_t which = 0) const { return value(axis).numbers[which]; }
    bool is(Axis axis, std::string_view name) const { return value(axis).name == name; }

    State& set(Axis axis, std::size_t index);
    State& set(Axis axis, std::string_view name) { return set(axis, value_called(entry(axis), name)); }
    // "axis=value axis=value ...": the axes that are not at their defaults. Empty for the default state.
    std::string text() const;
    // Throws std::invalid_argument for what is not such a text.
    static State parse(std::string_view text);

    bool operator==(const State&) const = default;

  private:
    std::array<std::uint8_t, kAxisCount> m_values{};
};

// The nearest state that is valid and whose every setting has a meaning.
State settled(State state);

// What Debian's OSMesa is known to draw wrongly of the state (doc/reference.md §3.3, §3.4, §4); null:
// nothing.
const char* reference_defect(const State& state);

struct NamedState {
    std::string name;
    State state;
};

}  // namespace terrazzo::states
