// The pixel kernels of one instruction set: the general one, the specialised ones, and the choice among them.
#include "raster/kernel_table.h"
#include "raster/pixel/shade_samples.h"
#include "raster/stage_log.h"
#include "raster/stages/stages.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

namespace {

// Stencil values on their way past all fragment operations (GL 1.5 §3.6.4).
void stencil_image_kernel(const FragmentState& state, const Primitive& primitive, Bin& bin,
                          const TileList& list) {
    const I32x16 writable(state.stencil[0].write_mask);
    Interpolator at(primitive, false);
    for (int i = 0; i < list.count; ++i) {
        const int tile = list.entries[i].tile;
        at.move_to(bin.x + tile % kTilesAcross * kTileSize, bin.y + tile / kTilesAcross * kTileSize);
        uint8_t* const stencil = bin.stencil + tile * kTilePixels;
        const I32x16 old = load_bytes(stencil);
        const I32x16 value =
            (load_bytes(at.image_tile<uint8_t, 16>(primitive)) & writable) | (old & (writable ^ I32x16(255)));
        store_bytes(select(mask_from_bits(list.entries[i].masks[0]), value, old), stencil);
    }
}

// The same on a multisampled target: all samples of a pixel get it.
void stencil_image_sample_kernel(const FragmentState& state, const Primitive& primitive, Bin& bin,
                                 const SampleList& list) {
    TileList tiles;
    for (; tiles.count < list.count; ++tiles.count) {
        const SampleList::Entry& entry = list.entries[tiles.count];
        tiles.entries[tiles.count] = {entry.tile, {entry.masks[0]}};
    }
    for (int s = 0; s < kMaxSamples; ++s) {
        Bin planes = planes_of_sample(bin, s, state.key.color_format);
        stencil_image_kernel(state, primitive, planes, tiles);
    }
}

void general_sample_kernel(const FragmentState& state, const Primitive& primitive, Bin& bin,
                           const SampleList& list) {
    shade_samples(RuntimeKey{state.key}, state, primitive, bin, list);
}

void general_kernel(const FragmentState& state, const Primitive& primitive, Bin& bin, const TileList& list) {
    shade_tiles(RuntimeKey{state.key}, state, primitive, bin, list);
}

#if HWY_TARGET != HWY_SCALAR
template <FragmentKey kKey>
void specialised_kernel(const FragmentState& state, const Primitive& primitive, Bin& bin,
                        const TileList& list) {
    shade_tiles(ConstantKey<kKey>{}, state, primitive, bin, list);
}

constexpr FragmentKey hot_key(bool depth, Compare func, bool perspective, bool interpolated_color,
                              BlendKind blend = BlendKind::kNone) {
    FragmentKey key;
    key.depth_test = key.depth_write = depth;
    key.depth_func = func;
    key.perspective = perspective;
    key.interpolated_color = interpolated_color;
    key.blend = blend;
    return key;
}

constexpr FragmentKey counting(FragmentKey key) {
    key.counts_samples = true;
    return key;
}

template <FragmentKey kKey>
void specialised_sample_kernel(const FragmentState& state, const Primitive& primitive, Bin& bin,
                               const SampleList& list) {
    shade_samples(ConstantKey<kKey>{}, state, primitive, bin, list);
}

// Of each two kernels: who counts samples wants to know how long drawing takes without counting, or draws
// large parts of a scene that way.
struct Specialised {
    FragmentKey key;
    TileKernel kernel, counting_kernel;
    SampleKernel sample_kernel = general_sample_kernel;
};

template <FragmentKey kKey>
constexpr Specialised specialise() {
    return {kKey, specialised_kernel<kKey>, specialised_kernel<counting(kKey)>};
}
// For multisampled targets as well: what models and plain shapes are drawn with.
template <FragmentKey kKey>
constexpr Specialised specialise_both() {
    return {kKey, specialised_kernel<kKey>, specialised_kernel<counting(kKey)>,
            specialised_sample_kernel<kKey>};
}

// One colour a primitive, each another: glShadeModel(GL_FLAT).
constexpr FragmentKey flat_key(Compare func, bool perspective) {
    FragmentKey key = hot_key(true, func, perspective, true);
    key.flat_color = true;
    return key;
}

// Images that are copied, and such with an alpha channel.
constexpr FragmentKey image_key(PixelImage image, BlendKind blend) {
    FragmentKey key = hot_key(false, Compare::kLess, false, false, blend);
    key.image = image;
    return key;
}

// States without textures, with both usual depth functions. The scalar build has the general kernel alone: it
// is there to be compared with, and one lane at a time is slow in any case.
constexpr Specialised kSpecialised[] = {
    specialise_both<hot_key(false, Compare::kLess, false, true)>(),
    specialise<hot_key(false, Compare::kLess, false, false)>(),
    specialise_both<hot_key(true, Compare::kLess, true, true)>(),
    specialise_both<hot_key(true, Compare::kLessEqual, true, true)>(),
    specialise_both<hot_key(true, Compare::kLess, true, false)>(),
    specialise<flat_key(Compare::kLess, true)>(),
    specialise<flat_key(Compare::kLessEqual, true)>(),
    // What programs draw with most besides: panes, and see-through parts of scenes.
    specialise<hot_key(false, Compare::kLess, false, false, BlendKind::kAlpha)>(),
    specialise<hot_key(false, Compare::kLess, false, true, BlendKind::kAlpha)>(),
    specialise<hot_key(true, Compare::kLess, true, true, BlendKind::kAlpha)>(),
    specialise<hot_key(true, Compare::kLessEqual, true, true, BlendKind::kAlpha)>(),
    specialise<image_key(PixelImage::kVerbatim, BlendKind::kNone)>(),
    specialise<image_key(PixelImage::kRgba8, BlendKind::kAlpha)>(),
};

const Specialised* find_specialised(const FragmentKey& key) {
    FragmentKey wanted = key;
    if (!key.depth_test) wanted.depth_func = Compare::kLess, wanted.depth_write = false;
    wanted.counts_samples = false;
    for (const Specialised& s : kSpecialised)
        if (s.key == wanted) return &s;
    return nullptr;
}

TileKernel select_kernel(const FragmentKey& key) {
    if (key.image == PixelImage::kStencil) return stencil_image_kernel;
    const Specialised* const s = find_specialised(key);
    if (s == nullptr) return general_kernel;
    return key.counts_samples ? s->counting_kernel : s->kernel;
}
SampleKernel select_sample_kernel(const FragmentKey& key) {
    if (key.image == PixelImage::kStencil) return stencil_image_sample_kernel;
    const Specialised* const s = key.counts_samples ? nullptr : find_specialised(key);
    return s ? s->sample_kernel : general_sample_kernel;
}
#else
// Without vector instructions the general kernel's branches cost next to nothing beside its arithmetic.
TileKernel select_kernel(const FragmentKey& key) {
    return key.image == PixelImage::kStencil ? stencil_image_kernel : general_kernel;
}
SampleKernel select_sample_kernel(const FragmentKey& key) {
    return key.image == PixelImage::kStencil ? stencil_image_sample_kernel : general_sample_kernel;
}
#endif

// Instead of kernels where somebody asks which are taken: they count, and do what those would.
template <int kSamples>
void count_list(const char* kernel, bool is_slow, const CoveredTiles<kSamples>& list) {
    StageNames names;
    names.of[0] = {"kernel", -1, kernel, is_slow};
    names.count = 1;
    uint64_t fragments = 0;
    for (int i = 0; i < list.count; ++i) {
        uint32_t pixels = 0;
        for (const uint16_t mask : list.entries[i].masks) pixels |= mask;
        fragments += static_cast<uint64_t>(std::popcount(pixels));
    }
    if (StageCount* const count = count_of_stages(names))
        count_drawn(*count, static_cast<uint64_t>(list.count), fragments);
}
const char* name_of(TileKernel kernel) {
    return kernel == general_kernel ? "general" : kernel == stencil_image_kernel ? "stencil_image" : "fused";
}
const char* name_of(SampleKernel kernel) {
    return kernel == general_sample_kernel         ? "samples_general"
           : kernel == stencil_image_sample_kernel ? "samples_stencil_image"
                                                   : "samples_fused";
}
void counted_kernel(const FragmentState& state, const Primitive& primitive, Bin& bin, const TileList& list) {
    const TileKernel kernel = primitive.steep ? general_kernel : select_kernel(state.key);
    count_list(name_of(kernel), kernel == general_kernel, list);
    kernel(state, primitive, bin, list);
}
void counted_sample_kernel(const FragmentState& state, const Primitive& primitive, Bin& bin,
                           const SampleList& list) {
    const SampleKernel kernel = primitive.steep ? general_sample_kernel : select_sample_kernel(state.key);
    count_list(name_of(kernel), kernel == general_sample_kernel, list);
    kernel(state, primitive, bin, list);
}

void count_ways(FragmentState& state) {
    count_stages(state);
    state.kernel = counted_kernel;
    state.sample_kernel = counted_sample_kernel;
}

void choose(FragmentState& state, std::span<TextureStage> units) {
    state.kernel = select_kernel(state.key);
    state.sample_kernel = select_sample_kernel(state.key);
    choose_stages(state, units);
    // One kernel for all of it takes less than stages do, which write colours down in between.
    if (state.texture_count == 0 && state.kernel != general_kernel) state.stages.is_batched = false;
    if (state.texture_count == 0 && state.sample_kernel != general_sample_kernel)
        state.stages.samples_are_batched = false;
    if (logs_stages()) count_ways(state);
}

void fill(uint32_t* to, uint32_t value, size_t count) {
    const I32x16 wide(static_cast<int32_t>(value));
    for (size_t i = 0; i < count; i += 16) store(wide, to + i);
}

// Takes the pixels from the list that a rectangle's masks leave out.
template <int kSamples>
TERRAZZO_NOINLINE void apply_masks(const TileData& data, const Bin& bin, CoveredTiles<kSamples>& list) {
    const auto* const masks = static_cast<const uint16_t*>(data.tiles);
    const int first_column = bin.x / kTileSize, first_row = bin.y / kTileSize;
    int kept = 0;
    for (int i = 0; i < list.count; ++i) {
        auto entry = list.entries[i];
        const int column = first_column + entry.tile % kTilesAcross,
                  row = first_row + entry.tile / kTilesAcross;
        for (uint16_t& mask : entry.masks) mask &= masks[data.index(column, row)];
        list.entries[kept] = entry;
        kept += entry.masks[0] != 0;  // samples of a rectangle are alike
    }
    list.count = kept;
}

template <int kSamples>
TERRAZZO_INLINE void find_tiles(const Primitive& primitive, Bin& bin, CoveredTiles<kSamples>& list) {
    switch (primitive.edge_count) {
        case 0:
            cover_bin<0>(primitive, bin, list);
            if (primitive.data == RectangleData::kMasks) apply_masks(primitive.tile_data, bin, list);
            break;
        case 3:
            cover_bin<3>(primitive, bin, list);
            break;
        default:
            cover_bin<4>(primitive, bin, list);
            break;
    }
}

void draw_primitive(const Primitive& primitive, Bin& bin, Batch& batch) {
    const FragmentState& state = *primitive.state;
    if (batch.count != 0 && batch.state != &state) flush(bin, batch);
    TileList list;
    find_tiles(primitive, bin, list);
    if (list.count == 0) return;
    if (state.stages.is_batched) return append(primitive, list, bin, batch);
    const TileKernel kernel =
        primitive.steep && state.kernel != counted_kernel ? general_kernel : state.kernel;
    kernel(state, primitive, bin, list);
}

void draw_multisampled(const Primitive& primitive, Bin& bin, Batch& batch) {
    const FragmentState& state = *primitive.state;
    if (batch.count != 0 && batch.state != &state) flush(bin, batch);
    SampleList list;
    find_tiles(primitive, bin, list);
    if (list.count == 0) return;
    if (state.key.sample_mask != 0xf) {
        for (int i = 0; i < list.count; ++i)
            for (int s = 0; s < kMaxSamples; ++s)
                if (!(state.key.sample_mask >> s & 1)) list.entries[i].masks[s] = 0;
    }
    if (state.stages.samples_are_batched) return append(primitive, list, bin, batch);
    const SampleKernel kernel = primitive.steep && state.sample_kernel != counted_sample_kernel
                                    ? general_sample_kernel
                                    : state.sample_kernel;
    kernel(state, primitive, bin, list);
}

// The mean of a tile's samples, in floats as the reference has it.
TERRAZZO_INLINE I32x16 mean_of_samples(const uint32_t* tile) {
    const Color first = from_color8(unpack_rgba8(load(tile)));
    F32x16 sums[4] = {first.r, first.g, first.b, first.a};
    for (int s = 1; s < kMaxSamples; ++s) {
        const Color c = from_color8(unpack_rgba8(load(tile + s * kBinPixels)));
        sums[0] = sums[0] + c.r, sums[1] = sums[1] + c.g, sums[2] = sums[2] + c.b, sums[3] = sums[3] + c.a;
    }
    const F32x16 share(1.0f / kMaxSamples);
    return pack_rgba8({to_unorm8(sums[0] * share), to_unorm8(sums[1] * share), to_unorm8(sums[2] * share),
                       to_unorm8(sums[3] * share)});
}

void resolve_rgba8(const uint32_t* samples, const uint8_t* alike, int tile_count, uint32_t* to) {
    for (int tile = 0; tile < tile_count; ++tile, samples += kTilePixels, to += kTilePixels)
        store(alike[tile] ? load(samples) : mean_of_samples(samples), to);
}

}  // namespace

extern const KernelTable kKernelTable;
const KernelTable kKernelTable = {
    simd::Isa::TERRAZZO_ISA_ENUM, choose, draw_primitive, draw_multisampled, flush, {resolve_rgba8, fill}};

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
