// See config.h.
#include "frontends/egl/config.h"

#include <EGL/eglext.h>

#include <algorithm>
#include <initializer_list>

#include "frontends/window/choose.h"
#include "gl/limits.h"

namespace terrazzo::egl {
namespace {

using window::kDontCare;
using window::Match;
using window::Order;

static_assert(static_cast<int>(EGL_DONT_CARE) == kDontCare);

int color_bits(const Config& c) {
    return c.red_bits + c.green_bits + c.blue_bits + c.alpha_bits;
}

int zero(const Config&) {
    return 0;
}

// In the order in which fitting configurations are compared (EGL 1.5 table 3.4).
constexpr window::Attribute<Config> kAttributes[] = {
    {EGL_CONFIG_CAVEAT, Match::kExact, Order::kNone, kDontCare, [](const Config&) { return EGL_NONE; }},
    {EGL_COLOR_BUFFER_TYPE, Match::kExact, Order::kNone, EGL_RGB_BUFFER,
     [](const Config&) { return EGL_RGB_BUFFER; }},
    {EGL_RED_SIZE, Match::kAtLeast, Order::kColorTotal, 0, [](const Config& c) { return c.red_bits; }},
    {EGL_GREEN_SIZE, Match::kAtLeast, Order::kColorTotal, 0, [](const Config& c) { return c.green_bits; }},
    {EGL_BLUE_SIZE, Match::kAtLeast, Order::kColorTotal, 0, [](const Config& c) { return c.blue_bits; }},
    {EGL_LUMINANCE_SIZE, Match::kAtLeast, Order::kColorTotal, 0, zero},
    {EGL_ALPHA_SIZE, Match::kAtLeast, Order::kColorTotal, 0, [](const Config& c) { return c.alpha_bits; }},
    {EGL_BUFFER_SIZE, Match::kAtLeast, Order::kSmaller, 0, color_bits},
    {EGL_SAMPLE_BUFFERS, Match::kAtLeast, Order::kSmaller, 0,
     [](const Config& c) { return c.samples ? 1 : 0; }},
    {EGL_SAMPLES, Match::kAtLeast, Order::kSmaller, 0, [](const Config& c) { return c.samples; }},
    {EGL_DEPTH_SIZE, Match::kAtLeast, Order::kSmaller, 0, [](const Config& c) { return c.depth_bits; }},
    {EGL_STENCIL_SIZE, Match::kAtLeast, Order::kSmaller, 0, [](const Config& c) { return c.stencil_bits; }},
    {EGL_ALPHA_MASK_SIZE, Match::kAtLeast, Order::kSmaller, 0, zero},
    {EGL_NATIVE_VISUAL_TYPE, Match::kExact, Order::kNone, kDontCare,
     [](const Config& c) { return c.visual ? int{c.visual->visual_class} : EGL_NONE; }},
    {EGL_CONFIG_ID, Match::kExact, Order::kSmaller, kDontCare, [](const Config& c) { return c.id; }},
    {EGL_BIND_TO_TEXTURE_RGB, Match::kExact, Order::kNone, kDontCare, zero},
    {EGL_BIND_TO_TEXTURE_RGBA, Match::kExact, Order::kNone, kDontCare, zero},
    {EGL_CONFORMANT, Match::kMask, Order::kNone, 0, [](const Config&) { return EGL_OPENGL_BIT; }},
    {EGL_LEVEL, Match::kExact, Order::kNone, 0, zero},
    {EGL_MAX_PBUFFER_WIDTH, Match::kIgnored, Order::kNone, 0,
     [](const Config&) { return gl::kMaxViewportSize; }},
    {EGL_MAX_PBUFFER_HEIGHT, Match::kIgnored, Order::kNone, 0,
     [](const Config&) { return gl::kMaxViewportSize; }},
    {EGL_MAX_PBUFFER_PIXELS, Match::kIgnored, Order::kNone, 0,
     [](const Config&) { return gl::kMaxViewportSize * gl::kMaxViewportSize; }},
    {EGL_MAX_SWAP_INTERVAL, Match::kExact, Order::kNone, kDontCare, [](const Config&) { return 0x7fff; }},
    {EGL_MIN_SWAP_INTERVAL, Match::kExact, Order::kNone, kDontCare, zero},
    {EGL_NATIVE_RENDERABLE, Match::kExact, Order::kNone, kDontCare,
     [](const Config& c) { return int{c.visual.has_value()}; }},
    {EGL_NATIVE_VISUAL_ID, Match::kIgnored, Order::kNone, 0,
     [](const Config& c) { return c.visual ? static_cast<int>(c.visual->id) : 0; }},
    // OpenGL ES is the standard wish, and programs that draw with OpenGL leave it at that (xscreensaver's):
    // it is granted, though eglBindAPI knows no OpenGL ES.
    {EGL_RENDERABLE_TYPE, Match::kMask, Order::kNone, EGL_OPENGL_ES_BIT,
     [](const Config&) { return EGL_OPENGL_BIT | EGL_OPENGL_ES_BIT; }},
    {EGL_SURFACE_TYPE, Match::kMask, Order::kNone, EGL_WINDOW_BIT,
     [](const Config& c) { return c.surface_types(); }},
    {EGL_TRANSPARENT_TYPE, Match::kExact, Order::kNone, EGL_NONE, [](const Config&) { return EGL_NONE; }},
    {EGL_TRANSPARENT_RED_VALUE, Match::kExact, Order::kNone, kDontCare, zero},
    {EGL_TRANSPARENT_GREEN_VALUE, Match::kExact, Order::kNone, kDontCare, zero},
    {EGL_TRANSPARENT_BLUE_VALUE, Match::kExact, Order::kNone, kDontCare, zero},
};

constexpr window::Chooser<Config> kChooser{kAttributes};

// Whether the attribute can have the value (EGL 1.5 table 3.1, §3.4.1.1).
bool is_value(int name, int value) {
    const auto among = [&](std::initializer_list<int> values) {
        return std::ranges::count(values, value) != 0;
    };
    if (name == EGL_LEVEL) return value != kDontCare;
    if (value == kDontCare) return true;
    switch (name) {
        case EGL_CONFIG_CAVEAT:
            return among({EGL_NONE, EGL_SLOW_CONFIG, EGL_NON_CONFORMANT_CONFIG});
        case EGL_COLOR_BUFFER_TYPE:
            return among({EGL_RGB_BUFFER, EGL_LUMINANCE_BUFFER});
        case EGL_TRANSPARENT_TYPE:
            return among({EGL_NONE, EGL_TRANSPARENT_RGB});
        case EGL_BIND_TO_TEXTURE_RGB:
        case EGL_BIND_TO_TEXTURE_RGBA:
        case EGL_NATIVE_RENDERABLE:
            return among({EGL_TRUE, EGL_FALSE});
        case EGL_CONFIG_ID:
            return value > 0;
        case EGL_NATIVE_VISUAL_TYPE:
        case EGL_SURFACE_TYPE:
        case EGL_RENDERABLE_TYPE:
        case EGL_CONFORMANT:
            return true;
        default:
            return value >= 0;
    }
}

}  // namespace

raster::TargetFormat Config::target_format() const {
    raster::TargetFormat format{color, alpha_bits != 0, static_cast<std::uint8_t>(depth_bits),
                                static_cast<std::uint8_t>(stencil_bits)};
    format.samples = static_cast<std::uint8_t>(samples ? samples : 1);
    return format;
}

int Config::surface_types() const {
    return visual ? EGL_WINDOW_BIT | EGL_PIXMAP_BIT | EGL_PBUFFER_BIT : EGL_PBUFFER_BIT;
}

std::vector<Config> make_configs(const x11::Screen* screen) {
    // One visual of each look; the root window's stands for its like.
    std::vector<std::optional<x11::Visual>> looks;
    if (screen) {
        std::vector<x11::Visual> visuals = screen->visuals;
        std::stable_partition(visuals.begin(), visuals.end(),
                              [&](const x11::Visual& v) { return v.id == screen->root_visual; });
        for (const x11::Visual& visual : visuals) {
            const bool known = std::ranges::any_of(looks, [&](const auto& look) {
                return look->visual_class == visual.visual_class && look->image.depth == visual.image.depth &&
                       look->layout == visual.layout;
            });
            if (!known) looks.push_back(visual);
        }
    } else {
        looks.push_back(std::nullopt);
    }
    struct Depth {
        int depth_bits, stencil_bits;
    };
    constexpr Depth kDepths[] = {{24, 8}, {24, 0}, {16, 0}, {0, 0}};
    std::vector<Config> out;
    const auto add = [&](int samples, const std::optional<x11::Visual>& look, int alpha, const Depth& depth) {
        const bool eight_bits = !look || look->color == raster::ColorFormat::kRgba8;
        if (alpha ? !eight_bits : look && look->has_alpha) return;
        Config& config = out.emplace_back();
        config.id = static_cast<int>(out.size());
        config.visual = look;
        config.alpha_bits = alpha;
        config.depth_bits = depth.depth_bits;
        config.stencil_bits = depth.stencil_bits;
        config.samples = samples;
        if (!look) return;
        config.color = look->color;
        config.red_bits = look->red_bits;
        config.green_bits = look->green_bits;
        config.blue_bits = look->blue_bits;
    };
    for (const int samples : {0, raster::kMaxSamples})
        for (const auto& look : looks)
            for (const int alpha : {0, 8})
                for (const Depth& depth : kDepths) add(samples, look, alpha, depth);
    return out;
}

std::optional<int> attribute(const Config& config, int name) {
    return kChooser.value(config, name);
}

Choice choose(const std::vector<Config>& configs, const EGLint* list) {
    Choice out;
    window::Wishes wishes;
    for (; list && *list != EGL_NONE; list += 2) {
        if (list[0] == EGL_MATCH_NATIVE_PIXMAP) {
            out.pixmap = list[1] == EGL_NONE ? 0 : static_cast<std::uint32_t>(list[1]);
            continue;
        }
        if (!kChooser.find(list[0]) || !is_value(list[0], list[1])) return {};
        wishes[list[0]] = list[1];
    }
    out.understood = true;
    out.configs = kChooser.choose(configs, wishes, EGL_CONFIG_ID);
    return out;
}

}  // namespace terrazzo::egl
