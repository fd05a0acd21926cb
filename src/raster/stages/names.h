// The stages' names (raster/stage_log.h). A stage that is missing here is called "unnamed": the benchmark of
// states finds it.
#pragma once

#include "raster/stage_log.h"
#include "raster/stages/color.h"
#include "raster/stages/coordinates.h"
#include "raster/stages/output.h"
#include "raster/stages/samples.h"
#include "raster/stages/test.h"
#include "raster/stages/texels.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

template <class Function>
struct NamedStage {
    Function stage;
    const char* name;
    bool is_slow = false;
};

inline constexpr NamedStage<Stage> kNamedStages[] = {
    {depth_stage<Compare::kLess, true>, "less_write"},
    {depth_stage<Compare::kLess, false>, "less"},
    {depth_stage<Compare::kLessEqual, true>, "less_equal_write"},
    {depth_stage<Compare::kLessEqual, false>, "less_equal"},
    {depth_stage<Compare::kEqual, true>, "equal_write"},
    {depth_stage<Compare::kEqual, false>, "equal"},
    {any_depth_stage<true>, "any_depth_write"},
    {any_depth_stage<false>, "any_depth"},
    {general_test_stage, "general", true},
    {depth_sample_stage<Compare::kLess, true>, "samples_less_write"},
    {depth_sample_stage<Compare::kLessEqual, true>, "samples_less_equal_write"},
    {general_sample_test_stage, "samples_general", true},

    {color_stage<false, Environments::kNone, true>, "constant"},
    {color_stage<false, Environments::kNone, false>, "constant_more"},
    {color_stage<false, Environments::kModulate, true>, "constant_modulate"},
    {color_stage<false, Environments::kModulate, false>, "constant_modulate_more"},
    {color_stage<false, Environments::kGeneral, true>, "constant_environments"},
    {color_stage<false, Environments::kGeneral, false>, "constant_environments_more"},
    {color_stage<false, Environments::kCombine, true>, "constant_combine"},
    {color_stage<false, Environments::kCombine, false>, "constant_combine_more"},
    {color_stage<true, Environments::kNone, true>, "interpolated"},
    {color_stage<true, Environments::kNone, false>, "interpolated_more"},
    {color_stage<true, Environments::kModulate, true>, "interpolated_modulate"},
    {color_stage<true, Environments::kModulate, false>, "interpolated_modulate_more"},
    {color_stage<true, Environments::kGeneral, true>, "interpolated_environments"},
    {color_stage<true, Environments::kGeneral, false>, "interpolated_environments_more"},
    {color_stage<true, Environments::kCombine, true>, "interpolated_combine"},
    {color_stage<true, Environments::kCombine, false>, "interpolated_combine_more"},

    {rgba8_output_stage<false, BlendKind::kNone>, "store"},
    {rgba8_output_stage<false, BlendKind::kAlpha>, "blend_alpha"},
    {rgba8_output_stage<false, BlendKind::kAdditive>, "blend_add"},
    {rgba8_output_stage<true, BlendKind::kNone>, "alpha_test_store"},
    {rgba8_output_stage<true, BlendKind::kAlpha>, "alpha_test_blend_alpha"},
    {rgba8_output_stage<true, BlendKind::kAdditive>, "alpha_test_blend_add"},
    {general_output_stage<PackedOutput>, "general", true},
    {general_output_stage<WideOutput>, "general_wide", true},
    {sample_output_stage<PackedOutput>, "samples"},
    {sample_output_stage<WideOutput>, "samples_wide", true},
};

inline constexpr NamedStage<UnitStage> kNamedUnitStages[] = {
    {coordinates_stage<false, true>, "flat"},
    {coordinates_stage<true, true>, "perspective_exact"},
    {coordinates_stage<true, false>, "perspective"},
    {linear_stage<true>, "linear_masked"},
    {linear_stage<false>, "linear"},
    {nearest_stage, "nearest"},
    {mipmapped_stage<MipKind::kMaskedLinear>, "mipmapped_linear_masked"},
    {mipmapped_stage<MipKind::kLinear>, "mipmapped_linear"},
    {mipmapped_stage<MipKind::kAny>, "mipmapped"},
    {mipmapped_tiles_stage, "mipmapped_tiles", true},
    {general_sample_stage, "general", true},
};

template <class Function, size_t kCount>
TERRAZZO_INLINE void add_name(StageNames& names, const char* part, int unit, Function stage,
                              const NamedStage<Function> (&known)[kCount]) {
    if (stage == nullptr) return;
    StageName& to = names.of[names.count++];
    to = {part, unit, "unnamed", true};
    for (const NamedStage<Function>& one : known)
        if (one.stage == stage) to.name = one.name, to.is_slow = one.is_slow;
}

// What only stores is quick with samples too.
inline bool only_stores(const FragmentKey& k) {
    return k.color_format == ColorFormat::kRgba8 && k.blend == BlendKind::kNone && !k.logic_op &&
           k.color_mask == 0xf && k.alpha_func == Compare::kAlways;
}

// The names of what a batch goes through; `by_samples`: of a multisampled target.
inline void name_stages(const FragmentState& state, bool by_samples, StageNames& names) {
    const FragmentState::Stages& stages = state.stages;
    names.count = 0;
    add_name(names, "test", -1, by_samples ? stages.sample_test : stages.test, kNamedStages);
    if (!stages.shades) return;
    for (int u = 0; u < state.texture_count; ++u) {
        add_name(names, "coordinates", u, state.textures[u].coordinates, kNamedUnitStages);
        add_name(names, "texels", u, state.textures[u].sample, kNamedUnitStages);
    }
    add_name(names, "colour", -1, stages.color, kNamedStages);
    add_name(names, "output", -1, by_samples ? stages.sample_output : stages.output, kNamedStages);
    if (by_samples && !only_stores(state.key)) names.of[names.count - 1].is_slow = true;
}

// Counts a batch as it comes from coverage.
TERRAZZO_NOINLINE void count_batch(const Batch& batch, StageCount& count) {
    uint64_t fragments = 0;
    for (int i = 0; i < batch.count; ++i)
        fragments += static_cast<uint64_t>(std::popcount(static_cast<uint32_t>(batch.masks[i])));
    count_drawn(count, static_cast<uint64_t>(batch.count), fragments);
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
