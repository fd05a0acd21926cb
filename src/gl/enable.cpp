// Enable, Disable and IsEnabled (GL 1.5 §6.1.1 and the chapters of the capabilities).
//
// One table says where a capability lives and what its change makes stale; glGet answers from it too.
#include "gl/enable.h"

#include "gl/generated/commands.h"

namespace terrazzo::gl {
namespace {

Capability indexed_capability(Context& ctx, GLenum cap) {
    if (bool* const flag = find_evaluator_flag(ctx.evaluators.modes, cap)) return {flag, Dirty::kNothing};
    if (cap - GL_LIGHT0 < static_cast<GLenum>(kMaxLights)) {
        return {&ctx.lighting.lights[cap - GL_LIGHT0].enabled, Dirty::kLighting};
    }
    if (cap - GL_CLIP_PLANE0 < static_cast<GLenum>(kMaxClipPlanes)) {
        return {&ctx.matrix.transform.clip_planes[cap - GL_CLIP_PLANE0].enabled, Dirty::kTransform};
    }
    if (cap >= GL_TEXTURE_GEN_S && cap <= GL_TEXTURE_GEN_Q) {
        TextureUnit& unit = ctx.texture.units[ctx.texture.active_unit];
        return {&unit.texgen.coordinates[cap - GL_TEXTURE_GEN_S].enabled, Dirty::kTexture};
    }
    return {};
}

void set_capability(Context& ctx, GLenum cap, bool enabled) {
    const Capability capability = find_capability(ctx, cap);
    if (!capability.enabled) return record_error(ctx, GL_INVALID_ENUM, "no such capability");
    if (*capability.enabled == enabled) return;
    begin_change(ctx, capability.dirty);
    if (cap == GL_COLOR_MATERIAL) latch_color_material(ctx);
    *capability.enabled = enabled;
}

}  // namespace

Capability find_capability(Context& ctx, GLenum cap) {
    FragmentOpsState& fragment = ctx.fragment_ops;
    PolygonState& polygon = ctx.rasterization.polygon;
    TextureUnit& unit = ctx.texture.units[ctx.texture.active_unit];
    switch (cap) {
        case GL_ALPHA_TEST:
            return {&fragment.color.alpha_test.enabled, Dirty::kFragment};
        case GL_BLEND:
            return {&fragment.color.blend.enabled, Dirty::kFragment};
        case GL_COLOR_LOGIC_OP:
            return {&fragment.color.logic_op.color_enabled, Dirty::kFragment};
        case GL_INDEX_LOGIC_OP:
            return {&fragment.color.logic_op.index_enabled, Dirty::kFragment};
        case GL_DITHER:
            return {&fragment.color.dither, Dirty::kFragment};
        case GL_DEPTH_TEST:
            return {&fragment.depth.test_enabled, Dirty::kFragment};
        case GL_STENCIL_TEST:
            return {&fragment.stencil.enabled, Dirty::kFragment};
        case GL_STENCIL_TEST_TWO_SIDE_EXT:
            return {&fragment.stencil.two_side_enabled, Dirty::kFragment};
        case GL_SCISSOR_TEST:
            return {&fragment.scissor.enabled, Dirty::kFragment};
        case GL_FOG:
            return {&ctx.fog.enabled, Dirty::kFragment};
        case GL_COLOR_SUM:
            return {&ctx.fog.color_sum, Dirty::kFragment};
        case GL_LIGHTING:
            return {&ctx.lighting.enabled, Dirty::kLighting};
        case GL_COLOR_MATERIAL:
            return {&ctx.lighting.color_material.enabled, Dirty::kLighting};
        case GL_NORMALIZE:
            return {&ctx.matrix.transform.normalize, Dirty::kTransform};
        case GL_RESCALE_NORMAL:
            return {&ctx.matrix.transform.rescale_normal, Dirty::kTransform};
        case GL_DEPTH_CLAMP:
            return {&ctx.matrix.transform.depth_clamp, Dirty::kAll};
        case GL_POINT_SMOOTH:
            return {&ctx.rasterization.point.smooth, Dirty::kRasterization};
        case GL_POINT_SPRITE:
            return {&ctx.rasterization.point.sprite, Dirty::kRasterization};
        case GL_MULTISAMPLE:
            return {&ctx.rasterization.multisample.enabled, Dirty::kRasterization};
        case GL_SAMPLE_ALPHA_TO_COVERAGE:
            return {&ctx.rasterization.multisample.alpha_to_coverage, Dirty::kRasterization};
        case GL_SAMPLE_ALPHA_TO_ONE:
            return {&ctx.rasterization.multisample.alpha_to_one, Dirty::kRasterization};
        case GL_SAMPLE_COVERAGE:
            return {&ctx.rasterization.multisample.coverage, Dirty::kRasterization};
        case GL_LINE_SMOOTH:
            return {&ctx.rasterization.line.smooth, Dirty::kRasterization};
        case GL_LINE_STIPPLE:
            return {&ctx.rasterization.line.stipple_enabled, Dirty::kRasterization};
        case GL_CULL_FACE:
            return {&polygon.cull_enabled, Dirty::kRasterization};
        case GL_POLYGON_SMOOTH:
            return {&polygon.smooth, Dirty::kRasterization};
        case GL_POLYGON_STIPPLE:
            return {&polygon.stipple_enabled, Dirty::kRasterization};
        case GL_POLYGON_OFFSET_FILL:
            return {&polygon.offset_fill, Dirty::kRasterization};
        case GL_POLYGON_OFFSET_LINE:
            return {&polygon.offset_line, Dirty::kRasterization};
        case GL_POLYGON_OFFSET_POINT:
            return {&polygon.offset_point, Dirty::kRasterization};
        case GL_TEXTURE_1D:
            return {&unit.enabled[kTexture1D], Dirty::kTexture};
        case GL_TEXTURE_2D:
            return {&unit.enabled[kTexture2D], Dirty::kTexture};
        case GL_TEXTURE_3D:
            return {&unit.enabled[kTexture3D], Dirty::kTexture};
        case GL_TEXTURE_CUBE_MAP:
            return {&unit.enabled[kTextureCube], Dirty::kTexture};
    }
    return indexed_capability(ctx, cap);
}

void enable(Context& ctx, GLenum cap) {
    set_capability(ctx, cap, true);
}

void disable(Context& ctx, GLenum cap) {
    set_capability(ctx, cap, false);
}

GLboolean is_enabled(Context& ctx, GLenum cap) {
    if (const bool* enabled = find_capability(ctx, cap).enabled) return *enabled;
    if (const ClientArray* array = find_client_array(ctx.arrays, cap)) return array->enabled;
    record_error(ctx, GL_INVALID_ENUM, "no such capability");
    return GL_FALSE;
}

}  // namespace terrazzo::gl
