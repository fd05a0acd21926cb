// Sine, cosine and arc tangent of floats, the same bits on every machine and those of glibc's sinf, cosf and
// atan2f, which the reference calls for glRotate, for spot cut-offs and for smooth lines (doc/reference.md
// §1, §3).
#pragma once

namespace terrazzo::simd {

float sine(float radians);
float cosine(float radians);
// The angle of the vector (x, y), in [-pi, pi]; both finite.
float arc_tangent(float y, float x);

}  // namespace terrazzo::simd
