// What kind of matrix a stack entry is, and the inverse that goes with the kind (doc/reference.md §1).
// Input: the value and traits of a StackMatrix; output: its traits, shape and inverse.
// Invariant: tests, tolerances, order of terms and pivoting are the reference's, since each decides last
// bits.

#include "gl/matrix_inverse.h"

#include <cmath>
#include <utility>

namespace terrazzo::gl {

namespace {

constexpr std::uint8_t kTraitsAngle = kRotation | kTranslation | kUniformScale;
constexpr std::uint8_t kTraits3d = kTraitsAngle | kGeneralScale | kGeneral3d;
constexpr float kTolerance = 1e-6f * 1e-6f;

bool only(std::uint8_t traits, std::uint8_t allowed) {
    return (traits & ~allowed) == 0;
}

float squared(float x) {
    return x * x;
}
float dot2(const float* a, const float* b) {
    return a[0] * b[0] + a[1] * b[1];
}
float dot3(const float* a, const float* b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

bool all_zero(const float* m, std::initializer_list<int> elements) {
    for (int i : elements)
        if (m[i] != 0.0f) return false;
    return true;
}

bool affine(const float* m) {
    return all_zero(m, {3, 7, 11}) && m[15] == 1.0f;
}

void classify_2d(StackMatrix& stack) {
    const float* m = stack.value.m;
    stack.shape = MatrixShape::k2d;
    if (squared(dot2(m, m) - 1) > kTolerance || squared(dot2(m + 4, m + 4) - 1) > kTolerance)
        stack.traits |= kGeneralScale;
    stack.traits |= squared(dot2(m, m + 4)) > kTolerance ? kGeneral3d : kRotation;
}

void classify_3d_no_rotation(StackMatrix& stack) {
    const float* m = stack.value.m;
    stack.shape = MatrixShape::k3dNoRotation;
    if (squared(m[0] - m[5]) < kTolerance && squared(m[0] - m[10]) < kTolerance) {
        if (squared(m[0] - 1.0f) > kTolerance) stack.traits |= kUniformScale;
    } else {
        stack.traits |= kGeneralScale;
    }
}

// Right-handed and orthogonal columns make a rotation.
bool is_rotation(const float* m) {
    if (!(squared(dot3(m, m + 4)) < kTolerance)) return false;
    float c[3] = {m[1] * m[6] - m[2] * m[5], m[2] * m[4] - m[0] * m[6], m[0] * m[5] - m[1] * m[4]};
    for (int i = 0; i < 3; ++i) c[i] -= m[8 + i];
    return dot3(c, c) < kTolerance;
}

void classify_3d(StackMatrix& stack) {
    const float* m = stack.value.m;
    stack.shape = MatrixShape::k3d;
    const float c1 = dot3(m, m), c2 = dot3(m + 4, m + 4), c3 = dot3(m + 8, m + 8);
    if (squared(c1 - c2) < kTolerance && squared(c1 - c3) < kTolerance) {
        if (squared(c1 - 1.0f) > kTolerance) stack.traits |= kUniformScale;
    } else {
        stack.traits |= kGeneralScale;
    }
    stack.traits |= is_rotation(m) ? kRotation : kGeneral3d;
}

// The translation that undoes `a`'s once the 3x3 part of `out` is known.
void invert_translation(Matrix4& out, const Matrix4& a) {
    for (int row = 0; row < 3; ++row)
        out.at(row, 3) =
            -(a.at(0, 3) * out.at(row, 0) + a.at(1, 3) * out.at(row, 1) + a.at(2, 3) * out.at(row, 2));
}

bool invert_no_rotation(StackMatrix& stack, int dimensions) {
    const Matrix4& a = stack.value;
    for (int i = 0; i < dimensions; ++i)
        if (a.at(i, i) == 0.0f) return false;
    stack.inverse = identity();
    for (int i = 0; i < dimensions; ++i) {
        stack.inverse.at(i, i) = 1.0f / a.at(i, i);
        if (stack.traits & kTranslation) stack.inverse.at(i, 3) = -(a.at(i, 3) * stack.inverse.at(i, i));
    }
    return true;
}

// Positive and negative terms are summed apart.
float determinant3(const Matrix4& a) {
    const float terms[6] = {
        a.at(0, 0) * a.at(1, 1) * a.at(2, 2),  a.at(1, 0) * a.at(2, 1) * a.at(0, 2),
        a.at(2, 0) * a.at(0, 1) * a.at(1, 2),  -a.at(2, 0) * a.at(1, 1) * a.at(0, 2),
        -a.at(1, 0) * a.at(0, 1) * a.at(2, 2), -a.at(0, 0) * a.at(2, 1) * a.at(1, 2),
    };
    float positive = 0.0f, negative = 0.0f;
    for (float term : terms) (term >= 0.0f ? positive : negative) += term;
    return positive + negative;
}

// The last row of the inverse keeps what was there: the reference never writes it for 3D matrices.
bool invert_3d_general(StackMatrix& stack) {
    const Matrix4& a = stack.value;
    const float determinant = determinant3(a);
    if (std::fabs(determinant) < 1e-25f) return false;
    const float scale = 1.0f / determinant;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            // Rows and columns of the minor in ascending order; the sign is applied before the scale.
            const int r0 = column == 0 ? 1 : 0, r1 = column == 2 ? 1 : 2;
            const int c0 = row == 0 ? 1 : 0, c1 = row == 2 ? 1 : 2;
            const float minor = a.at(r0, c0) * a.at(r1, c1) - a.at(r1, c0) * a.at(r0, c1);
            stack.inverse.at(row, column) = ((row + column) & 1 ? -minor : minor) * scale;
        }
    }
    invert_translation(stack.inverse, a);
    return true;
}

bool invert_3d(StackMatrix& stack) {
    if (!only(stack.traits, kTraitsAngle)) return invert_3d_general(stack);
    const Matrix4& a = stack.value;
    Matrix4& out = stack.inverse;
    float scale = 1.0f;
    if (stack.traits & kUniformScale) {
        const float length2 = a.at(0, 0) * a.at(0, 0) + a.at(0, 1) * a.at(0, 1) + a.at(0, 2) * a.at(0, 2);
        if (length2 == 0.0f) return false;
        scale = 1.0f / length2;
    } else if (!(stack.traits & kRotation)) {
        out = identity();
        for (int row = 0; row < 3; ++row) out.at(row, 3) = -a.at(row, 3);
        return true;
    }
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) out.at(row, column) = scale * a.at(column, row);
    if (stack.traits & kTranslation)
        invert_translation(out, a);
    else
        for (int row = 0; row < 3; ++row) out.at(row, 3) = 0.0f;
    return true;
}

// One elimination step on the rows [A | I]: subtracts the pivot row from the rows below it.
void eliminate(float* rows[4], int pivot) {
    const float* p = rows[pivot];
    for (int row = pivot + 1; row < 4; ++row) {
        const float factor = rows[row][pivot] / p[pivot];
        for (int column = pivot + 1; column < 8; ++column) {
            // A zero of the appended identity is skipped in the first two steps: 0 * infinity must not
            // spread.
            if (column >= 4 && pivot < 2 && p[column] == 0.0f) continue;
            rows[row][column] -= factor * p[column];
        }
    }
}

// Gauss-Jordan; the pivot is found by bubbling the larger of neighbouring rows upwards.
bool invert_general(StackMatrix& stack) {
    float storage[4][8] = {};
    float* rows[4] = {storage[0], storage[1], storage[2], storage[3]};
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) rows[row][column] = stack.value.at(row, column);
        rows[row][4 + row] = 1.0f;
    }
    for (int pivot = 0; pivot < 4; ++pivot) {
        for (int row = 3; row > pivot; --row)
            if (std::fabs(rows[row][pivot]) > std::fabs(rows[row - 1][pivot]))
                std::swap(rows[row], rows[row - 1]);
        if (rows[pivot][pivot] == 0.0f) return false;
        if (pivot < 3) eliminate(rows, pivot);
    }
    const float last = 1.0f / rows[3][3];
    for (int column = 4; column < 8; ++column) rows[3][column] *= last;
    for (int row = 2; row >= 0; --row) {
        for (int below = 3; below > row + 1; --below)
            for (int column = 4; column < 8; ++column)
                rows[row][column] -= rows[below][column] * rows[row][below];
        const float scale = 1.0f / rows[row][row];
        for (int column = 4; column < 8; ++column)
            rows[row][column] = scale * (rows[row][column] - rows[row + 1][column] * rows[row][row + 1]);
    }
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) stack.inverse.at(row, column) = rows[row][4 + column];
    return true;
}

bool invert_by_shape(StackMatrix& stack) {
    switch (stack.shape) {
        case MatrixShape::kIdentity:
            stack.inverse = identity();
            return true;
        case MatrixShape::k3dNoRotation:
            return invert_no_rotation(stack, 3);
        case MatrixShape::k2dNoRotation:
            return invert_no_rotation(stack, 2);
        case MatrixShape::k2d:
        case MatrixShape::k3d:
            return invert_3d(stack);
        case MatrixShape::kGeneral:
        case MatrixShape::kPerspective:
            break;
    }
    return invert_general(stack);
}

}  // namespace

void classify_values(StackMatrix& stack) {
    const float* m = stack.value.m;
    stack.traits = 0;
    if (!all_zero(m, {12, 13, 14})) stack.traits |= kTranslation;

    const bool no_rotation = affine(m) && all_zero(m, {1, 2, 4, 6, 8, 9});
    const bool flat = affine(m) && all_zero(m, {2, 6, 8, 9, 14}) && m[10] == 1.0f;
    const bool unit_xy = m[0] == 1.0f && m[5] == 1.0f;
    if (no_rotation && flat && unit_xy && all_zero(m, {12, 13})) {
        stack.shape = MatrixShape::kIdentity;
    } else if (no_rotation && flat) {
        stack.shape = MatrixShape::k2dNoRotation;
        if (!unit_xy) stack.traits |= kGeneralScale;
    } else if (flat) {
        classify_2d(stack);
    } else if (no_rotation) {
        classify_3d_no_rotation(stack);
    } else if (affine(m)) {
        classify_3d(stack);
    } else {
        const bool perspective = all_zero(m, {1, 2, 3, 4, 6, 7, 12, 13, 15}) && m[11] == -1.0f;
        stack.shape = perspective ? MatrixShape::kPerspective : MatrixShape::kGeneral;
        stack.traits |= kGeneral;
    }
}

void classify_traits(StackMatrix& stack) {
    const float* m = stack.value.m;
    if (stack.traits == 0) {
        stack.shape = MatrixShape::kIdentity;
    } else if (only(stack.traits, kTranslation | kUniformScale | kGeneralScale)) {
        stack.shape =
            m[10] == 1.0f && m[14] == 0.0f ? MatrixShape::k2dNoRotation : MatrixShape::k3dNoRotation;
    } else if (only(stack.traits, kTraits3d)) {
        const bool flat = all_zero(m, {2, 6, 8, 9, 14}) && m[10] == 1.0f;
        stack.shape = flat ? MatrixShape::k2d : MatrixShape::k3d;
    } else {
        const bool perspective = all_zero(m, {1, 2, 3, 4, 6, 7, 12, 13, 15}) && m[11] == -1.0f;
        stack.shape = perspective ? MatrixShape::kPerspective : MatrixShape::kGeneral;
    }
}

void invert(StackMatrix& stack) {
    if (invert_by_shape(stack)) {
        stack.traits = static_cast<std::uint8_t>(stack.traits & ~kSingular);
    } else {
        stack.traits |= kSingular;
        stack.inverse = identity();
    }
}

}  // namespace terrazzo::gl
