// The pixel kernels of one instruction set: the general one, the specialised ones, and the choice among them.
#include "raster/kernel_table.h"
#include "raster/pixel/shade.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

namespace {

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
                              TextureKind texture, BlendKind blend = BlendKind::kNone) {
    FragmentKey key;
    key.depth_test = key.depth_write = depth;
    key.depth_func = func;
    key.perspective = perspective;
    key.interpolated_color = interpolated_color;
    key.texture = texture;
    key.blend = blend;
    return key;
}

struct Specialised {
    FragmentKey key;
    TileKernel kernel;
};

template <FragmentKey kKey>
constexpr Specialised specialise() {
    return {kKey, specialised_kernel<kKey>};
}

constexpr auto kBilinear = TextureKind::kModulateBilinearRgba8;
// The state of the study's scenes T1 to T6 and of the demo's models, with both usual depth functions. The
// scalar build has the general kernel alone: it is there to be compared with, and one lane at a time is slow
// in any case.
constexpr Specialised kSpecialised[] = {
#if HWY_TARGET == HWY_SCALAR
    {FragmentKey{}, general_kernel},
#else
    specialise<hot_key(false, Compare::kLess, false, true, TextureKind::kNone)>(),
    specialise<hot_key(false, Compare::kLess, false, false, TextureKind::kNone)>(),
    specialise<hot_key(true, Compare::kLess, true, true, TextureKind::kNone)>(),
    specialise<hot_key(true, Compare::kLessEqual, true, true, TextureKind::kNone)>(),
    specialise<hot_key(true, Compare::kLess, true, false, TextureKind::kNone)>(),
    specialise<hot_key(true, Compare::kLess, true, false, TextureKind::kBilinearRgba8)>(),
    specialise<hot_key(true, Compare::kLessEqual, true, false, TextureKind::kBilinearRgba8)>(),
    specialise<hot_key(true, Compare::kLess, true, false, kBilinear)>(),
    specialise<hot_key(true, Compare::kLessEqual, true, false, kBilinear)>(),
    specialise<hot_key(true, Compare::kLess, true, true, kBilinear)>(),
    specialise<hot_key(true, Compare::kLessEqual, true, true, kBilinear)>(),
    // Lit models with textures of any kind, mip-mapped ones above all.
    specialise<hot_key(true, Compare::kLess, true, true, TextureKind::kGeneral)>(),
    specialise<hot_key(true, Compare::kLessEqual, true, true, TextureKind::kGeneral)>(),
    // What programs draw with most besides: sprites, texts and panes, and see-through parts of scenes.
    specialise<hot_key(false, Compare::kLess, false, false, kBilinear)>(),
    specialise<hot_key(false, Compare::kLess, false, true, kBilinear)>(),
    specialise<hot_key(false, Compare::kLess, false, false, kBilinear, BlendKind::kAlpha)>(),
    specialise<hot_key(false, Compare::kLess, false, true, kBilinear, BlendKind::kAlpha)>(),
    specialise<hot_key(false, Compare::kLess, false, false, TextureKind::kNone, BlendKind::kAlpha)>(),
    specialise<hot_key(false, Compare::kLess, false, true, TextureKind::kNone, BlendKind::kAlpha)>(),
    specialise<hot_key(true, Compare::kLess, true, true, TextureKind::kNone, BlendKind::kAlpha)>(),
    specialise<hot_key(true, Compare::kLessEqual, true, true, TextureKind::kNone, BlendKind::kAlpha)>(),
    specialise<hot_key(true, Compare::kLess, true, true, kBilinear, BlendKind::kAlpha)>(),
    specialise<hot_key(true, Compare::kLessEqual, true, true, kBilinear, BlendKind::kAlpha)>(),
#endif
};

TileKernel select_kernel(const FragmentKey& key) {
    FragmentKey wanted = key;
    if (!key.depth_test) wanted.depth_func = Compare::kLess, wanted.depth_write = false;
    for (const Specialised& s : kSpecialised)
        if (s.key == wanted) return s.kernel;
    return general_kernel;
}
#else
// Without vector instructions the general kernel's branches cost next to nothing beside its arithmetic.
TileKernel select_kernel(const FragmentKey&) {
    return general_kernel;
}
#endif

void fill(uint32_t* to, uint32_t value, size_t count) {
    const I32x16 wide(static_cast<int32_t>(value));
    for (size_t i = 0; i < count; i += 16) store(wide, to + i);
}

void draw_primitive(const Primitive& primitive, Bin& bin) {
    TileList list;
    switch (primitive.edge_count) {
        case 0:
            cover_bin<0>(primitive, bin, list);
            break;
        case 3:
            cover_bin<3>(primitive, bin, list);
            break;
        default:
            cover_bin<4>(primitive, bin, list);
            break;
    }
    if (list.count == 0) return;
    const TileKernel kernel = primitive.steep ? general_kernel : primitive.state->kernel;
    kernel(*primitive.state, primitive, bin, list);
}

}  // namespace

extern const KernelTable kKernelTable;
const KernelTable kKernelTable = {simd::Isa::TERRAZZO_ISA_ENUM, select_kernel, draw_primitive, fill};

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
