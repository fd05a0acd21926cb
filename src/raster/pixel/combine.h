// Texture environments of OpenGL 1.1 and ADD (GL 1.5 §3.8.13, tables 3.22 and 3.23): what a unit makes of the
// incoming colour and its texel.
#pragma once

#include "raster/pixel/color.h"
#include "raster/state.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

TERRAZZO_NOINLINE Color combine(const TextureStage& stage, const Color& f, const Color& t) {
    const BaseFormat base = stage.base_format;
    const bool has_color = base != BaseFormat::kAlpha;
    const bool has_alpha = base != BaseFormat::kLuminance && base != BaseFormat::kRgb;
    const float* const c = stage.env_color;
    Color out = f;
    switch (stage.mode) {
        case EnvMode::kReplace:
            if (has_color) out = {t.r, t.g, t.b, f.a};
            if (has_alpha) out.a = t.a;
            return out;
        case EnvMode::kModulate:
            if (has_color) out = {f.r * t.r, f.g * t.g, f.b * t.b, f.a};
            if (has_alpha) out.a = f.a * t.a;
            return out;
        case EnvMode::kDecal: {
            // Defined for RGB and RGBA only; without alpha the texel replaces the colour.
            if (base == BaseFormat::kRgb) return {t.r, t.g, t.b, f.a};
            const F32x16 rest = F32x16(1.0f) - t.a;
            return {f.r * rest + t.r * t.a, f.g * rest + t.g * t.a, f.b * rest + t.b * t.a, f.a};
        }
        case EnvMode::kBlend: {
            const F32x16 one(1.0f);
            if (has_color) {
                out = {f.r * (one - t.r) + F32x16(c[0]) * t.r, f.g * (one - t.g) + F32x16(c[1]) * t.g,
                       f.b * (one - t.b) + F32x16(c[2]) * t.b, f.a};
            }
            if (base == BaseFormat::kIntensity) {
                out.a = f.a * (one - t.a) + F32x16(c[3]) * t.a;
            } else if (has_alpha) {
                out.a = f.a * t.a;
            }
            return out;
        }
        case EnvMode::kAdd: {
            const auto sum = [](F32x16 a, F32x16 b) { return clamp(a + b, F32x16(0.0f), F32x16(1.0f)); };
            if (has_color) out = {sum(f.r, t.r), sum(f.g, t.g), sum(f.b, t.b), f.a};
            if (base == BaseFormat::kIntensity) {
                out.a = sum(f.a, t.a);
            } else if (has_alpha) {
                out.a = f.a * t.a;
            }
            return out;
        }
    }
    return out;
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
