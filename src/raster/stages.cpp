// The stages of one instruction set: which of them a fragment state takes, and the run of a batch through
// them.
#include "raster/stages/stages.h"

#include "raster/stages/color.h"
#include "raster/stages/coordinates.h"
#include "raster/stages/names.h"
#include "raster/stages/output.h"
#include "raster/stages/samples.h"
#include "raster/stages/test.h"
#include "raster/stages/texels.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

namespace {

// A small error of such coordinates changes a filtered colour little.
bool is_continuous(const Sampler& sampler) {
    return has_packed_texels(sampler) && !sampler.faces && sampler.dimensions < 3 && filters_agree(sampler) &&
           sampler.mag_filter == Filter::kLinear;
}

// Whether the only unit's texels are the fragments' colours.
bool shows_texels(const FragmentState& state) {
    const FragmentKey& k = state.key;
    if (state.texture_count != 1 || k.separate_specular || k.fog != FogMode::kNone) return false;
    const TextureStage& stage = state.textures[0];
    if (stage.texels_are_floats || k.color_format != ColorFormat::kRgba8) return false;
    if (stage.mode == EnvMode::kReplace) return stage.base_format == BaseFormat::kRgba;
    const auto is_white = [&] {
        return !k.interpolated_color &&
               std::all_of(state.constant_color, state.constant_color + 4, [](float c) { return c == 1; });
    };
    return stage.mode == EnvMode::kModulate && stage.base_format != BaseFormat::kAlpha && is_white();
}

UnitStage choose_coordinates(bool perspective, bool exact) {
    if (!perspective) return coordinates_stage<false, true>;
    return exact ? coordinates_stage<true, true> : coordinates_stage<true, false>;
}

}  // namespace

void choose_stages(FragmentState& state, std::span<TextureStage> units) {
    const FragmentKey& k = state.key;
    FragmentState::Stages& out = state.stages;
    out = {};
    size_t texel_bytes_in_all = 0;
    for (TextureStage& unit : units) {
        unit.texels_are_floats = !has_packed_texels(unit.sampler);
        unit.sample = choose_sample_stage(unit.sampler);
        unit.texel_bytes_before = static_cast<uint16_t>(texel_bytes_in_all);
        texel_bytes_in_all += texel_bytes(unit);
    }
    out.tiles = static_cast<uint8_t>(
        std::min(size_t{kBatchTiles}, Batch::kTexelBytes / std::max(texel_bytes_in_all, size_t{1})));
    out.exact_coordinates =
        !k.perspective || !std::all_of(units.begin(), units.end(),
                                       [](const TextureStage& unit) { return is_continuous(unit.sampler); });
    for (TextureStage& unit : units)
        unit.coordinates = choose_coordinates(k.perspective, out.exact_coordinates);
    out.is_batched = k.image == PixelImage::kNone && k.coverage == Coverage::kNone;
    // How many samples are covered may depend on alpha.
    out.samples_are_batched = out.is_batched && !k.alpha_to_coverage && !k.alpha_to_one;
    out.test = choose_test_stage(state);
    out.sample_test = choose_sample_test_stage(state);
    const bool has_output = k.color_mask != 0 || !tests_early(k) || k.alpha_func != Compare::kAlways;
    if (!has_output) return;
    out.output = choose_output_stage(state);
    out.sample_output = has_wide_channels(k.color_format) ? sample_output_stage<WideOutput>
                                                          : sample_output_stage<PackedOutput>;
    out.shades = true;
    out.shows_texels = shows_texels(state);
    if (!out.shows_texels)
        out.color = k.interpolated_color ? choose_color_stage<true>(state) : choose_color_stage<false>(state);
}

void count_stages(FragmentState& state) {
    FragmentState::Stages& stages = state.stages;
    StageNames names;
    if (stages.is_batched) {
        name_stages(state, false, names);
        stages.count = count_of_stages(names);
    }
    if (stages.samples_are_batched) {
        name_stages(state, true, names);
        stages.sample_count = count_of_stages(names);
    }
}

void flush(Bin& bin, Batch& batch) {
    if (batch.count == 0) return;
    const FragmentState& state = *batch.state;
    const FragmentState::Stages& stages = state.stages;
    const bool by_samples = bin.color_alike || bin.depth_alike || bin.stencil_alike;
    if (StageCount* const count = by_samples ? stages.sample_count : stages.count) [[unlikely]]
        count_batch(batch, *count);
    batch.to_centre = by_samples && state.multisample ? 0.5f : 0.0f;
    if (const Stage test = by_samples ? stages.sample_test : stages.test) test(state, bin, batch);
    if (stages.shades && batch.count != 0) {
        for (int u = 0; u < state.texture_count; ++u) {
            const TextureStage& unit = state.textures[u];
            unit.coordinates(state, unit, bin, batch);
            unit.sample(state, unit, bin, batch);
        }
        if (stages.color) stages.color(state, bin, batch);
        (by_samples ? stages.sample_output : stages.output)(state, bin, batch);
    }
    if (state.key.counts_samples) (by_samples ? count_all_samples : count_samples)(state, bin, batch);
    batch.count = 0;
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
