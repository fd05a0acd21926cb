// How the templates of pixel/ and stages/ are told a fragment's key: as a constant, whose branches fold away,
// or as it comes.
#pragma once

#include "raster/fragment_state.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

// Steep primitives are for the general kernel.
template <FragmentKey kKey>
struct ConstantKey {
    static constexpr FragmentKey value = kKey;
    static constexpr bool kTakesSteep = false;
};
struct RuntimeKey {
    const FragmentKey& value;
    static constexpr bool kTakesSteep = true;
};

// Whether depth and stencil tests may come before all else: nothing before them discards fragments, or they
// change nothing that the discarded would have to leave.
constexpr bool tests_early(const FragmentKey& key) {
    return key.coverage != Coverage::kPoint &&
           (key.alpha_func == Compare::kAlways || (!key.depth_write && !key.stencil_test));
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
