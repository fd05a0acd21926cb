// Sine and cosine of a float, the same bits on every machine and those of glibc's sinf and cosf, which the
// reference calls for glRotate and for spot cut-offs (doc/reference.md §1).
#pragma once

namespace terrazzo::gl {

float sine(float radians);
float cosine(float radians);

}  // namespace terrazzo::gl
