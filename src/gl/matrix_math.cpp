// Products and constructors of matrices, and how a stack entry's traits follow from its operations.
// Invariant: expressions are evaluated exactly as written (the build forbids contraction); the order of the
// terms is the reference's and must not be "simplified". The inverse is in matrix_inverse.cpp.

#include "gl/matrix_math.h"

#include <cmath>
#include <cstring>
#include <numbers>

#include "gl/matrix_inverse.h"
#include "simd/trigonometry.h"

namespace terrazzo::gl {

namespace {

constexpr std::uint8_t kTraits3d = kRotation | kTranslation | kUniformScale | kGeneralScale | kGeneral3d;

bool only(std::uint8_t traits, std::uint8_t allowed) {
    return (traits & ~allowed) == 0;
}

bool same_bits(const Matrix4& a, const Matrix4& b) {
    return std::memcmp(a.m, b.m, sizeof a.m) == 0;
}

void changed(StackMatrix& stack, std::uint8_t traits) {
    stack.traits |= traits;
    stack.shape_stale = true;
    stack.inverse_stale = true;
}

// The new traits take part in the choice of the product.
void multiply_known(StackMatrix& stack, const Matrix4& a, std::uint8_t traits) {
    changed(stack, traits);
    stack.value = only(stack.traits, kTraits3d) ? multiply_affine(stack.value, a) : multiply(stack.value, a);
}

// Rotation by an axis of the coordinate system: u turns towards v. The axis' length does not matter, its sign
// does.
Matrix4 axis_rotation(int u, int v, float axis, float sine, float cosine) {
    Matrix4 r = identity();
    r.at(u, u) = cosine;
    r.at(v, v) = cosine;
    r.at(u, v) = axis < 0.0f ? sine : -sine;
    r.at(v, u) = axis < 0.0f ? -sine : sine;
    return r;
}

}  // namespace

Matrix4 identity() {
    return {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
}

Matrix4 transpose(const Matrix4& a) {
    Matrix4 result;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) result.at(column, row) = a.at(row, column);
    return result;
}

Matrix4 multiply(const Matrix4& a, const Matrix4& b) {
    Matrix4 result;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            result.at(row, column) = a.at(row, 0) * b.at(0, column) + a.at(row, 1) * b.at(1, column) +
                                     a.at(row, 2) * b.at(2, column) + a.at(row, 3) * b.at(3, column);
    return result;
}

Matrix4 multiply_affine(const Matrix4& a, const Matrix4& b) {
    Matrix4 result = identity();
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column)
            result.at(row, column) = a.at(row, 0) * b.at(0, column) + a.at(row, 1) * b.at(1, column) +
                                     a.at(row, 2) * b.at(2, column);
        result.at(row, 3) += a.at(row, 3);
    }
    return result;
}

std::optional<Matrix4> rotation(float degrees, float x, float y, float z) {
    if (degrees == 0.0f) return std::nullopt;
    const float radians = static_cast<float>(degrees * std::numbers::pi / 180.0);
    const float s = simd::sine(radians);
    const float c = simd::cosine(radians);

    if (x == 0.0f && y == 0.0f && z != 0.0f) return axis_rotation(0, 1, z, s, c);
    if (x == 0.0f && z == 0.0f && y != 0.0f) return axis_rotation(2, 0, y, s, c);
    if (y == 0.0f && z == 0.0f && x != 0.0f) return axis_rotation(1, 2, x, s, c);

    const float length = std::sqrt(x * x + y * y + z * z);
    if (length <= 1.0e-4f) return std::nullopt;
    x /= length;
    y /= length;
    z /= length;
    const float k = 1.0f - c;
    Matrix4 r = identity();
    r.at(0, 0) = k * (x * x) + c;
    r.at(0, 1) = k * (x * y) - z * s;
    r.at(0, 2) = k * (z * x) + y * s;
    r.at(1, 0) = k * (x * y) + z * s;
    r.at(1, 1) = k * (y * y) + c;
    r.at(1, 2) = k * (y * z) - x * s;
    r.at(2, 0) = k * (z * x) - y * s;
    r.at(2, 1) = k * (y * z) + x * s;
    r.at(2, 2) = k * (z * z) + c;
    return r;
}

// GL hands doubles; the reference rounds each to float before it computes.
Matrix4 ortho(double left, double right, double bottom, double top, double near, double far) {
    const float l = static_cast<float>(left), r = static_cast<float>(right);
    const float b = static_cast<float>(bottom), t = static_cast<float>(top);
    const float n = static_cast<float>(near), f = static_cast<float>(far);
    Matrix4 result = identity();
    result.at(0, 0) = 2.0f / (r - l);
    result.at(1, 1) = 2.0f / (t - b);
    result.at(2, 2) = -2.0f / (f - n);
    result.at(0, 3) = -(r + l) / (r - l);
    result.at(1, 3) = -(t + b) / (t - b);
    result.at(2, 3) = -(f + n) / (f - n);
    return result;
}

Matrix4 frustum(double left, double right, double bottom, double top, double near, double far) {
    const float l = static_cast<float>(left), r = static_cast<float>(right);
    const float b = static_cast<float>(bottom), t = static_cast<float>(top);
    const float n = static_cast<float>(near), f = static_cast<float>(far);
    Matrix4 result{};
    result.at(0, 0) = 2.0f * n / (r - l);
    result.at(1, 1) = 2.0f * n / (t - b);
    result.at(0, 2) = (r + l) / (r - l);
    result.at(1, 2) = (t + b) / (t - b);
    result.at(2, 2) = -(f + n) / (f - n);
    result.at(2, 3) = -(2.0f * f * n) / (f - n);
    result.at(3, 2) = -1.0f;
    return result;
}

void load_identity(StackMatrix& stack) {
    const std::uint8_t traits = stack.traits;
    stack = StackMatrix{};
    stack.traits = traits;
}

void load(StackMatrix& stack, const Matrix4& a) {
    if (same_bits(stack.value, a)) return;
    stack.value = a;
    stack.traits = 0;
    changed(stack, kGeneral);
    stack.traits_unknown = true;
}

void multiply(StackMatrix& stack, const Matrix4& a) {
    if (same_bits(a, identity())) return;
    stack.value = multiply(stack.value, a);
    changed(stack, kGeneral);
    stack.traits_unknown = true;
}

void translate(StackMatrix& stack, float x, float y, float z) {
    float* m = stack.value.m;
    for (int row = 0; row < 4; ++row)
        m[12 + row] = m[row] * x + m[4 + row] * y + m[8 + row] * z + m[12 + row];
    changed(stack, kTranslation);
}

void scale(StackMatrix& stack, float x, float y, float z) {
    float* m = stack.value.m;
    for (int row = 0; row < 4; ++row) {
        m[row] *= x;
        m[4 + row] *= y;
        m[8 + row] *= z;
    }
    const bool uniform = std::fabs(x - y) < 1e-8f && std::fabs(x - z) < 1e-8f;
    changed(stack, uniform ? kUniformScale : kGeneralScale);
}

void rotate(StackMatrix& stack, float degrees, float x, float y, float z) {
    if (const auto turn = rotation(degrees, x, y, z)) multiply_known(stack, *turn, kRotation);
}

void ortho(StackMatrix& stack, double left, double right, double bottom, double top, double near,
           double far) {
    multiply_known(stack, ortho(left, right, bottom, top, near, far), kGeneralScale | kTranslation);
}

void frustum(StackMatrix& stack, double left, double right, double bottom, double top, double near,
             double far) {
    multiply_known(stack, frustum(left, right, bottom, top, near, far), kPerspective);
}

void settle(StackMatrix& stack) {
    if (stack.shape_stale) {
        if (stack.traits_unknown)
            classify_values(stack);
        else
            classify_traits(stack);
    }
    if (stack.inverse_stale) invert(stack);
    stack.traits_unknown = false;
    stack.shape_stale = false;
    stack.inverse_stale = false;
}

Matrix4 model_view_projection(const StackMatrix& projection, const StackMatrix& modelview) {
    if (only(projection.traits | modelview.traits, kTraits3d))
        return multiply_affine(projection.value, modelview.value);
    return multiply(projection.value, modelview.value);
}

bool preserves_length(const StackMatrix& stack) {
    return only(stack.traits, kRotation | kTranslation);
}

void transform_row(float result[4], const float v[4], const Matrix4& a) {
    for (int column = 0; column < 4; ++column)
        result[column] =
            v[0] * a.at(0, column) + v[1] * a.at(1, column) + v[2] * a.at(2, column) + v[3] * a.at(3, column);
}

}  // namespace terrazzo::gl
