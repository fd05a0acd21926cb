// Stage: models from files, matrices of nodes. Column-major, as glTF and GL have them.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace terrazzo::gltf {

using Matrix = std::array<double, 16>;

constexpr Matrix kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

inline Matrix product(const Matrix& a, const Matrix& b) {
    Matrix result{};
    for (std::size_t column = 0; column < 4; ++column)
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t k = 0; k < 4; ++k)
                result[column * 4 + row] += a[k * 4 + row] * b[column * 4 + k];
    return result;
}

// The cofactors of the upper left 3x3 part, in its own order: what normals are transformed by, times the
// determinant.
inline std::array<double, 9> cofactors(const Matrix& m) {
    return {m[5] * m[10] - m[6] * m[9], m[6] * m[8] - m[4] * m[10], m[4] * m[9] - m[5] * m[8],
            m[2] * m[9] - m[1] * m[10], m[0] * m[10] - m[2] * m[8], m[1] * m[8] - m[0] * m[9],
            m[1] * m[6] - m[2] * m[5],  m[2] * m[4] - m[0] * m[6],  m[0] * m[5] - m[1] * m[4]};
}

inline double determinant(const Matrix& m) {
    const std::array<double, 9> c = cofactors(m);
    return m[0] * c[0] + m[1] * c[1] + m[2] * c[2];
}

inline bool is_finite(const Matrix& m) {
    for (const double value : m)
        if (!std::isfinite(static_cast<float>(value))) return false;
    return true;
}

}  // namespace terrazzo::gltf
