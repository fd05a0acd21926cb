// Conversions of arguments that the generated thunks make before they call a command's core form, and of
// answers.
//
// Integers that stand for colours and normals are normalised as GL 1.5 table 2.9 says, signed (2c + 1)/(2^b -
// 1), unsigned c/(2^b - 1), with the roundings of the reference (doc/reference.md §2.1).
#pragma once

#include <GL/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

#include "gl/context.h"

namespace terrazzo::gl {

// A normalised integer's value between 0 or -1 and 1.
template <typename Integer>
constexpr GLfloat normalised(Integer value) {
    // Products where the specification has quotients, in the precision of the reference (doc/reference.md
    // §2.1).
    const GLfloat c = static_cast<GLfloat>(value);
    if constexpr (std::is_same_v<Integer, GLubyte>) return c / 255.0f;
    if constexpr (std::is_same_v<Integer, GLbyte>) return (2.0f * c + 1.0f) * (1.0f / 255.0f);
    if constexpr (std::is_same_v<Integer, GLushort>) return c * (1.0f / 65535.0f);
    if constexpr (std::is_same_v<Integer, GLshort>) return (2.0f * c + 1.0f) * (1.0f / 65535.0f);
    if constexpr (std::is_same_v<Integer, GLuint>) return static_cast<GLfloat>(value * (1.0 / 4294967295.0));
    return static_cast<GLfloat>((2.0f * c + 1.0f) * (1.0 / 4294967294.0));
}

// The nearest integer (GL 1.5 §6.1.2); what does not fit, and NaN as 0, is brought into range.
inline GLint rounded(double value) {
    if (std::isnan(value)) return 0;
    constexpr double lowest = std::numeric_limits<GLint>::min(), highest = std::numeric_limits<GLint>::max();
    return static_cast<GLint>(std::clamp(std::floor(value + 0.5), lowest, highest));
}

// A colour or normal component as an integer: the inverse of `normalised` (GL 1.5 §6.1.2, table 4.7).
inline GLint denormalised(double value) {
    return rounded((value * 4294967295.0 - 1.0) / 2.0);
}

// What a pname of a parameter command stands for.
struct ParameterCount {
    int size;  // 0 when there is no such parameter
    bool normalised;
};

// The values given to Lightiv and its like, as floats. Reads exactly as many as the parameter has.
class ParameterValues {
  public:
    template <typename Value>
    ParameterValues(const Value* given, ParameterCount count) {
        for (int i = 0; i < count.size; ++i) {
            if constexpr (std::is_integral_v<Value>) {
                m_values[i] = count.normalised ? gl::normalised(given[i]) : static_cast<GLfloat>(given[i]);
            } else {
                m_values[i] = static_cast<GLfloat>(given[i]);
            }
        }
    }

    const GLfloat* data() const { return m_values.data(); }

  private:
    std::array<GLfloat, 4> m_values{};
};

// Where GetLightfv and its like write, until the values are converted for GetLightiv.
class QueriedValues {
  public:
    explicit QueriedValues(const Context& ctx) : m_ctx(ctx), m_errors_before(ctx.error.count) {}

    GLfloat* data() { return m_values.data(); }

    // Hands the values out unless the query recorded an error.
    template <typename Value>
    void write(Value* out, ParameterCount count) const {
        if (m_ctx.error.count != m_errors_before) return;
        for (int i = 0; i < count.size; ++i) {
            if constexpr (std::is_integral_v<Value>) {
                out[i] = count.normalised ? denormalised(m_values[i]) : rounded(m_values[i]);
            } else {
                out[i] = static_cast<Value>(m_values[i]);
            }
        }
    }

  private:
    const Context& m_ctx;
    unsigned m_errors_before;
    std::array<GLfloat, 4> m_values{};
};

}  // namespace terrazzo::gl
