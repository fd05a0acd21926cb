// The eight comparisons of 16 values: floats of alpha (GL 1.5 §4.1.4) and of depth textures (§3.8.14),
// integers of stencil (§4.1.5) and of depth (§4.1.6).
#pragma once

#include "raster/fragment_state.h"
#include "simd/wide.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

template <class Lanes>
TERRAZZO_INLINE Mask16 compare(Compare func, Lanes a, Lanes b) {
    switch (func) {
        case Compare::kNever:
            return mask_from_bits(0);
        case Compare::kLess:
            return a < b;
        case Compare::kEqual:
            return a == b;
        case Compare::kLessEqual:
            return a <= b;
        case Compare::kGreater:
            return a > b;
        case Compare::kNotEqual:
            return a != b;
        case Compare::kGreaterEqual:
            return a >= b;
        case Compare::kAlways:
            break;
    }
    return mask_from_bits(0xffff);
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
