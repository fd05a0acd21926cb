// Analysis of a stack entry and its inverse: the half of matrix_math that normals, light positions and user
// clip planes depend on. Used by settle() only.
#pragma once

#include "gl/matrix_math.h"

namespace terrazzo::gl {

/// Traits and shape from the sixteen values, after a load or a product with a matrix of the program's own.
void classify_values(StackMatrix& stack);

/// Shape from the traits, after operations whose traits are known.
void classify_traits(StackMatrix& stack);

/// The inverse by the algorithm of the shape; the identity and kSingular when there is none.
void invert(StackMatrix& stack);

}  // namespace terrazzo::gl
