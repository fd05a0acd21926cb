// See config.h.
#include "frontends/glx/config.h"

#include <GL/glx.h>

#include <algorithm>

#include "frontends/window/choose.h"

namespace terrazzo::glx {
namespace {

using window::kDontCare;
using window::Match;
using window::Order;

static_assert(static_cast<int>(GLX_DONT_CARE) == kDontCare);

constexpr int kDrawables = GLX_WINDOW_BIT | GLX_PIXMAP_BIT | GLX_PBUFFER_BIT;

int color_bits(const Config& c) {
    return c.visual.red_bits + c.visual.green_bits + c.visual.blue_bits + c.alpha_bits;
}

int visual_type(const Config& c) {
    return c.visual.visual_class == XCB_VISUAL_CLASS_TRUE_COLOR ? GLX_TRUE_COLOR : GLX_DIRECT_COLOR;
}

// In the order in which fitting configurations are compared.
constexpr window::Attribute<Config> kAttributes[] = {
    {GLX_CONFIG_CAVEAT, Match::kExact, Order::kNone, kDontCare, [](const Config&) { return GLX_NONE; }},
    {GLX_RED_SIZE, Match::kAtLeast, Order::kColorTotal, 0, [](const Config& c) { return c.visual.red_bits; }},
    {GLX_GREEN_SIZE, Match::kAtLeast, Order::kColorTotal, 0,
     [](const Config& c) { return c.visual.green_bits; }},
    {GLX_BLUE_SIZE, Match::kAtLeast, Order::kColorTotal, 0,
     [](const Config& c) { return c.visual.blue_bits; }},
    {GLX_ALPHA_SIZE, Match::kAtLeast, Order::kColorTotal, 0, [](const Config& c) { return c.alpha_bits; }},
    {GLX_BUFFER_SIZE, Match::kAtLeast, Order::kSmaller, 0, color_bits},
    {GLX_DOUBLEBUFFER, Match::kExact, Order::kSmaller, kDontCare,
     [](const Config& c) { return int{c.double_buffered}; }},
    {GLX_AUX_BUFFERS, Match::kAtLeast, Order::kSmaller, 0, [](const Config&) { return 0; }},
    {GLX_SAMPLE_BUFFERS, Match::kAtLeast, Order::kSmaller, 0,
     [](const Config& c) { return c.samples ? 1 : 0; }},
    {GLX_SAMPLES, Match::kAtLeast, Order::kSmaller, 0, [](const Config& c) { return c.samples; }},
    {GLX_DEPTH_SIZE, Match::kAtLeast, Order::kLarger, 0, [](const Config& c) { return c.depth_bits; }},
    {GLX_STENCIL_SIZE, Match::kAtLeast, Order::kSmaller, 0, [](const Config& c) { return c.stencil_bits; }},
    {GLX_ACCUM_RED_SIZE, Match::kAtLeast, Order::kAccumTotal, 0,
     [](const Config& c) { return c.accum_bits; }},
    {GLX_ACCUM_GREEN_SIZE, Match::kAtLeast, Order::kAccumTotal, 0,
     [](const Config& c) { return c.accum_bits; }},
    {GLX_ACCUM_BLUE_SIZE, Match::kAtLeast, Order::kAccumTotal, 0,
     [](const Config& c) { return c.accum_bits; }},
    {GLX_ACCUM_ALPHA_SIZE, Match::kAtLeast, Order::kAccumTotal, 0,
     [](const Config& c) { return c.accum_bits; }},
    {GLX_X_VISUAL_TYPE, Match::kExact, Order::kNone, kDontCare, visual_type},
    {GLX_FBCONFIG_ID, Match::kExact, Order::kNone, kDontCare, [](const Config& c) { return c.id; }},
    {GLX_LEVEL, Match::kExact, Order::kNone, 0, [](const Config&) { return 0; }},
    {GLX_STEREO, Match::kExact, Order::kNone, 0, [](const Config&) { return 0; }},
    {GLX_RENDER_TYPE, Match::kMask, Order::kNone, GLX_RGBA_BIT, [](const Config&) { return GLX_RGBA_BIT; }},
    {GLX_DRAWABLE_TYPE, Match::kMask, Order::kNone, GLX_WINDOW_BIT, [](const Config&) { return kDrawables; }},
    {GLX_X_RENDERABLE, Match::kExact, Order::kNone, kDontCare, [](const Config&) { return 1; }},
    {GLX_TRANSPARENT_TYPE, Match::kExact, Order::kNone, GLX_NONE, [](const Config&) { return GLX_NONE; }},
    {GLX_TRANSPARENT_INDEX_VALUE, Match::kIgnored, Order::kNone, 0, [](const Config&) { return 0; }},
    {GLX_TRANSPARENT_RED_VALUE, Match::kIgnored, Order::kNone, 0, [](const Config&) { return 0; }},
    {GLX_TRANSPARENT_GREEN_VALUE, Match::kIgnored, Order::kNone, 0, [](const Config&) { return 0; }},
    {GLX_TRANSPARENT_BLUE_VALUE, Match::kIgnored, Order::kNone, 0, [](const Config&) { return 0; }},
    {GLX_TRANSPARENT_ALPHA_VALUE, Match::kIgnored, Order::kNone, 0, [](const Config&) { return 0; }},
    {GLX_MAX_PBUFFER_WIDTH, Match::kIgnored, Order::kNone, 0, [](const Config&) { return 16384; }},
    {GLX_MAX_PBUFFER_HEIGHT, Match::kIgnored, Order::kNone, 0, [](const Config&) { return 16384; }},
    {GLX_MAX_PBUFFER_PIXELS, Match::kIgnored, Order::kNone, 0, [](const Config&) { return 16384 * 16384; }},
    {GLX_OPTIMAL_PBUFFER_WIDTH_SGIX, Match::kIgnored, Order::kNone, 0, [](const Config&) { return 0; }},
    {GLX_OPTIMAL_PBUFFER_HEIGHT_SGIX, Match::kIgnored, Order::kNone, 0, [](const Config&) { return 0; }},
    {GLX_VISUAL_ID, Match::kIgnored, Order::kNone, 0,
     [](const Config& c) { return static_cast<int>(c.visual.id); }},
    {GLX_VISUAL_SELECT_GROUP_SGIX, Match::kExact, Order::kNone, kDontCare, [](const Config&) { return 0; }},
    {GLX_BIND_TO_TEXTURE_RGB_EXT, Match::kExact, Order::kNone, kDontCare, [](const Config&) { return 1; }},
    {GLX_BIND_TO_TEXTURE_RGBA_EXT, Match::kExact, Order::kNone, kDontCare,
     [](const Config& c) { return c.alpha_bits ? 1 : 0; }},
    {GLX_BIND_TO_MIPMAP_TEXTURE_EXT, Match::kExact, Order::kNone, kDontCare, [](const Config&) { return 0; }},
    {GLX_BIND_TO_TEXTURE_TARGETS_EXT, Match::kMask, Order::kNone, kDontCare,
     [](const Config&) { return GLX_TEXTURE_1D_BIT_EXT | GLX_TEXTURE_2D_BIT_EXT; }},
    {GLX_Y_INVERTED_EXT, Match::kExact, Order::kNone, kDontCare, [](const Config&) { return 0; }},
};

constexpr window::Chooser<Config> kChooser{kAttributes};

}  // namespace

std::vector<const Config*> choose(const std::vector<Config>& configs, const int* list) {
    window::Wishes wishes;
    for (; list && *list != None; list += 2) {
        if (!kChooser.find(list[0])) return {};
        wishes[list[0]] = list[1];
    }
    return kChooser.choose(configs, wishes, GLX_FBCONFIG_ID);
}

std::vector<const Config*> choose_for_visual(const std::vector<Config>& configs, const int* list) {
    window::Wishes wishes{{GLX_DOUBLEBUFFER, 0}};
    bool rgba = false;
    while (list && *list != None) {
        const int name = *list++;
        switch (name) {
            case GLX_USE_GL:
                break;
            case GLX_RGBA:
                rgba = true;
                break;
            case GLX_DOUBLEBUFFER:
            case GLX_STEREO:
                wishes[name] = 1;
                break;
            default:
                if (!kChooser.find(name)) return {};
                wishes[name] = *list++;
        }
    }
    if (!rgba) return {};  // there are no colour-index visuals
    return kChooser.choose(configs, wishes, GLX_FBCONFIG_ID);
}

std::optional<int> attribute(const Config& config, int name) {
    return kChooser.value(config, name);
}

std::vector<Config> make_configs(const x11::Screen& screen, int number, int first_id) {
    struct Depth {
        int depth_bits, stencil_bits;
    };
    constexpr Depth kDepths[] = {{24, 8}, {24, 0}, {16, 0}, {0, 0}};

    // Visuals that look the same serve as names for different configurations; the root window's comes first.
    std::vector<std::vector<x11::Visual>> groups;
    const auto same = [](const x11::Visual& a, const x11::Visual& b) {
        return a.visual_class == b.visual_class && a.image.depth == b.image.depth && a.layout == b.layout;
    };
    std::vector<x11::Visual> visuals = screen.visuals;
    std::stable_partition(visuals.begin(), visuals.end(),
                          [&](const x11::Visual& v) { return v.id == screen.root_visual; });
    for (const x11::Visual& visual : visuals) {
        const auto group =
            std::ranges::find_if(groups, [&](const auto& g) { return same(g.front(), visual); });
        if (group == groups.end()) {
            groups.push_back({visual});
        } else {
            group->push_back(visual);
        }
    }

    std::vector<Config> out;
    for (const auto& group : groups) {
        std::size_t in_group = 0;
        const bool eight_bits = group.front().color == raster::ColorFormat::kRgba8;
        const auto add = [&](int samples, int accum, bool double_buffered, const Depth& depth, int alpha) {
            if (alpha ? !eight_bits : group.front().has_alpha) return;
            Config& config = out.emplace_back();
            config.id = first_id++;
            config.screen = number;
            config.visual = group[in_group++ % group.size()];
            config.alpha_bits = alpha;
            config.depth_bits = depth.depth_bits;
            config.stencil_bits = depth.stencil_bits;
            config.accum_bits = accum;
            config.double_buffered = double_buffered;
            config.samples = samples;
        };
        for (const int samples : {0, raster::kMaxSamples})
            for (const int accum : {0, 16})
                for (const bool double_buffered : {true, false})
                    for (const Depth& depth : kDepths)
                        for (const int alpha : {0, 8}) add(samples, accum, double_buffered, depth, alpha);
    }
    return out;
}

}  // namespace terrazzo::glx

terrazzo::raster::TargetFormat __GLXFBConfigRec::target_format() const {
    terrazzo::raster::TargetFormat format{visual.color, alpha_bits != 0,
                                          static_cast<std::uint8_t>(depth_bits),
                                          static_cast<std::uint8_t>(stencil_bits)};
    format.samples = static_cast<std::uint8_t>(samples ? samples : 1);
    return format;
}

terrazzo::x11::BufferFormat __GLXFBConfigRec::buffer_format() const {
    return {visual, target_format(), double_buffered};
}
