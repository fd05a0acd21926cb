// Matrix arithmetic of the fixed-function stacks (GL 1.5 §2.11.2), bit for bit that of the reference
// (doc/reference.md §1): single precision, column-major, every operation rounded once, nothing fused.
//
// Matrix4 is the bare value. StackMatrix is an entry of a matrix stack: it also knows how it was made,
// because the reference picks its product and its inverse by that history, and with them the last bits of
// normals and of light positions. Errors (GL_INVALID_VALUE of glOrtho and the like) are the caller's.
#pragma once

#include <cstdint>
#include <optional>

namespace terrazzo::gl {

/// Element (row, column) is m[4 * column + row].
struct Matrix4 {
    float m[16];

    float& at(int row, int column) { return m[4 * column + row]; }
    float at(int row, int column) const { return m[4 * column + row]; }
};

Matrix4 identity();
Matrix4 transpose(const Matrix4& a);

/// a * b, all 64 products.
Matrix4 multiply(const Matrix4& a, const Matrix4& b);

/// a * b where both have the last row (0 0 0 1): the products with it are left out, which shows in signs of
/// zero.
Matrix4 multiply_affine(const Matrix4& a, const Matrix4& b);

/// The matrix of glRotate; nothing where glRotate leaves the stack alone (no angle, or an axis too short).
std::optional<Matrix4> rotation(float degrees, float x, float y, float z);

Matrix4 ortho(double left, double right, double bottom, double top, double near, double far);
Matrix4 frustum(double left, double right, double bottom, double top, double near, double far);

/// What an entry of a stack is known to do; the union over the operations that made it.
enum MatrixTraits : std::uint8_t {
    kGeneral = 0x01,
    kRotation = 0x02,
    kTranslation = 0x04,
    kUniformScale = 0x08,
    kGeneralScale = 0x10,
    kGeneral3d = 0x20,
    kPerspective = 0x40,
    kSingular = 0x80,
};

/// Selects the algorithm of the inverse.
enum class MatrixShape : std::uint8_t {
    kGeneral,
    kIdentity,
    k3dNoRotation,
    kPerspective,
    k2d,
    k2dNoRotation,
    k3d
};

struct StackMatrix {
    Matrix4 value = identity();
    Matrix4 inverse = identity();  // as of the last settle(); the identity when singular
    std::uint8_t traits = 0;
    MatrixShape shape = MatrixShape::kIdentity;
    bool traits_unknown = false;
    bool shape_stale = false;
    bool inverse_stale = false;
};

/// glLoadIdentity: the traits of what was there before stay.
void load_identity(StackMatrix& stack);
/// glLoadMatrix; a matrix equal in every bit is ignored.
void load(StackMatrix& stack, const Matrix4& a);
/// glMultMatrix; an identity is ignored.
void multiply(StackMatrix& stack, const Matrix4& a);
void translate(StackMatrix& stack, float x, float y, float z);
void scale(StackMatrix& stack, float x, float y, float z);
void rotate(StackMatrix& stack, float degrees, float x, float y, float z);
void ortho(StackMatrix& stack, double left, double right, double bottom, double top, double near, double far);
void frustum(StackMatrix& stack, double left, double right, double bottom, double top, double near,
             double far);

/// Brings shape and inverse up to date. Due before glPushMatrix copies the entry, when a draw validates
/// modelview, projection and texture matrices, and before anything reads `inverse` or `shape`.
void settle(StackMatrix& stack);

/// projection * modelview as the vertex stage gets it.
Matrix4 model_view_projection(const StackMatrix& projection, const StackMatrix& modelview);

/// Whether a settled matrix keeps lengths; else lighting works in eye space and normals are rescaled.
bool preserves_length(const StackMatrix& stack);

/// The row vector v times the matrix, as user clip planes are transformed (GL 1.5 §2.12).
void transform_row(float result[4], const float v[4], const Matrix4& a);

}  // namespace terrazzo::gl
