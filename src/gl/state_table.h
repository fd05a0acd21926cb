// Every state variable that glGet reads, each in its own type.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <span>

#include "gl/context.h"

namespace terrazzo::gl {

// What an integer query makes of the values.
enum class StateKind {
    kNumber,      // the number itself, rounded
    kNormalized,  // -1..1 scaled to the range of integers: colours, normals, depths
};

// A double holds every integer and float of GL without loss.
struct StateValues {
    StateKind kind = StateKind::kNumber;
    int count = 0;
    std::array<GLdouble, 16> data;

    template <typename Number>
    requires std::integral<Number> || std::floating_point<Number>
    void operator=(Number value) { push(value); }
    template <typename Number, std::size_t kCount>
    void operator=(const std::array<Number, kCount>& values) {
        for (Number value : values) push(value);
    }
    void push(GLdouble value) { data[count++] = value; }
};

template <typename Value>
void normalized(StateValues& out, const Value& value) {
    out.kind = StateKind::kNormalized;
    out = value;
}

struct StateVariable {
    GLenum name;
    void (*read)(Context& ctx, StateValues& out);
};

template <std::size_t kCount>
constexpr std::array<StateVariable, kCount> sorted_by_name(std::array<StateVariable, kCount> variables) {
    std::ranges::sort(variables, {}, &StateVariable::name);
    return variables;
}

std::span<const StateVariable> client_variables();
std::span<const StateVariable> limit_variables();

// False: there is no variable of this name.
bool read_state(Context& ctx, GLenum pname, StateValues& values);

}  // namespace terrazzo::gl
