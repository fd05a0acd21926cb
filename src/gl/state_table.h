// Every state variable that glGet reads, each in its own type.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>

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

// False: there is no variable of this name.
bool read_state(Context& ctx, GLenum pname, StateValues& values);

}  // namespace terrazzo::gl
