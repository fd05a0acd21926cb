// PushAttrib, PopAttrib and their client forms (GL 1.5 §6.1.14; tables 6.5-6.34 say which value belongs to
// which bit).
//
// A saved group is a copy of the chapter's struct, and popping it is an assignment: the values were checked
// when they were set.
#include "gl/attrib.h"

#include <optional>

#include "gl/context.h"
#include "gl/generated/commands.h"
#include "gl/share.h"

namespace terrazzo::gl {
namespace {

struct ColorBufferGroup {
    ColorBufferState state;
    std::array<GLfloat, 4> clear_color;
    GLfloat clear_index;
    GLenum draw_buffer;
};

struct CurrentGroup {
    CurrentAttributes attributes;
    RasterPosition raster_position;
};

struct DepthBufferGroup {
    DepthState state;
    GLdouble clear_depth;
};

struct StencilBufferGroup {
    StencilState state;
    GLint clear_stencil;
};

struct PixelModeGroup {
    PixelMode mode;
    GLenum read_buffer;
};

struct TextureGroup {
    unsigned active_unit;
    std::array<TextureUnit, kMaxTextureUnits> units;
    std::array<std::array<TextureParameters, kTextureTargetCount>, kMaxTextureUnits> parameters;
};

}  // namespace

struct SavedAttributes {
    std::optional<std::array<GLfloat, 4>> clear_accum;
    std::optional<ColorBufferGroup> color_buffer;
    std::optional<CurrentGroup> current;
    std::optional<DepthBufferGroup> depth_buffer;
    std::optional<std::vector<bool>> enables;
    std::optional<EvaluatorModes> evaluators;
    std::optional<FogState> fog;
    std::optional<HintState> hints;
    std::optional<LightingState> lighting;
    std::optional<LineState> line;
    std::optional<GLuint> list_base;
    std::optional<PixelModeGroup> pixel_mode;
    std::optional<MultisampleState> multisample;
    std::optional<PointState> point;
    std::optional<PolygonState> polygon;
    std::optional<PolygonStipple> polygon_stipple;
    std::optional<ScissorState> scissor;
    std::optional<StencilBufferGroup> stencil_buffer;
    std::optional<TextureGroup> texture;
    std::optional<TransformState> transform;
    std::optional<ViewportState> viewport;
};

namespace {

// Every capability that GL_ENABLE_BIT covers, always in the same order.
template <typename Visit>
void for_each_enable(Context& ctx, Visit visit) {
    ColorBufferState& color = ctx.fragment_ops.color;
    PolygonState& polygon = ctx.rasterization.polygon;
    for (bool* flag : {&color.alpha_test.enabled,
                       &color.blend.enabled,
                       &color.logic_op.color_enabled,
                       &color.logic_op.index_enabled,
                       &color.dither,
                       &ctx.fragment_ops.depth.test_enabled,
                       &ctx.fragment_ops.stencil.enabled,
                       &ctx.fragment_ops.stencil.two_side_enabled,
                       &ctx.fragment_ops.scissor.enabled,
                       &ctx.fog.enabled,
                       &ctx.fog.color_sum,
                       &ctx.lighting.enabled,
                       &ctx.lighting.color_material.enabled,
                       &ctx.matrix.transform.normalize,
                       &ctx.matrix.transform.rescale_normal,
                       &ctx.matrix.transform.depth_clamp,
                       &ctx.rasterization.multisample.enabled,
                       &ctx.rasterization.multisample.alpha_to_coverage,
                       &ctx.rasterization.multisample.alpha_to_one,
                       &ctx.rasterization.multisample.coverage,
                       &ctx.rasterization.point.smooth,
                       &ctx.rasterization.point.sprite,
                       &ctx.rasterization.line.smooth,
                       &ctx.rasterization.line.stipple_enabled,
                       &polygon.cull_enabled,
                       &polygon.smooth,
                       &polygon.stipple_enabled,
                       &polygon.offset_fill,
                       &polygon.offset_line,
                       &polygon.offset_point}) {
        visit(*flag);
    }
    EvaluatorModes& evaluators = ctx.evaluators.modes;
    for (bool& enabled : evaluators.enabled_1d) visit(enabled);
    for (bool& enabled : evaluators.enabled_2d) visit(enabled);
    visit(evaluators.auto_normal);
    for (Light& light : ctx.lighting.lights) visit(light.enabled);
    for (ClipPlane& plane : ctx.matrix.transform.clip_planes) visit(plane.enabled);
    for (TextureUnit& unit : ctx.texture.units) {
        for (bool& enabled : unit.enabled) visit(enabled);
        for (TexgenCoordinate& coordinate : unit.texgen.coordinates) visit(coordinate.enabled);
    }
}

std::vector<bool> save_enables(Context& ctx) {
    std::vector<bool> saved;
    for_each_enable(ctx, [&](bool flag) { saved.push_back(flag); });
    return saved;
}

void restore_enables(Context& ctx, const std::vector<bool>& saved) {
    auto next = saved.begin();
    for_each_enable(ctx, [&](bool& flag) { flag = *next++; });
}

TextureGroup save_textures(Context& ctx) {
    TextureGroup group{ctx.texture.active_unit, ctx.texture.units, {}};
    const std::lock_guard lock(ctx.shared->mutex);
    for (int unit = 0; unit < kMaxTextureUnits; ++unit) {
        for (int target = 0; target < kTextureTargetCount; ++target) {
            group.parameters[unit][target] = group.units[unit].bound[target]->parameters;
        }
    }
    return group;
}

// A texture object that was deleted meanwhile stays deleted: the default texture takes its place. So it is
// with objects of another share group, which glXCopyContext may come with; of default textures each group has
// its own.
void restore_textures(Context& ctx, const TextureGroup& group) {
    ctx.texture.active_unit = group.active_unit;
    ctx.texture.units = group.units;
    const std::lock_guard lock(ctx.shared->mutex);
    TextureNames& names = ctx.shared->textures;
    for (int unit = 0; unit < kMaxTextureUnits; ++unit) {
        for (int target = 0; target < kTextureTargetCount; ++target) {
            std::shared_ptr<TextureObject>& bound = ctx.texture.units[unit].bound[target];
            const auto named = names.objects.find(bound->name);
            const bool lives = bound->name == 0 || (named != names.objects.end() && named->second == bound);
            if (bound->name == 0 || !lives) bound = names.defaults[target];
            if (lives) bound->parameters = group.parameters[unit][target];
        }
    }
}

std::shared_ptr<const SavedAttributes> save(Context& ctx, GLbitfield mask) {
    auto saved = std::make_shared<SavedAttributes>();
    const ClearValues& clear = ctx.framebuffer.clear;
    const FragmentOpsState& fragment = ctx.fragment_ops;
    if (mask & GL_ACCUM_BUFFER_BIT) saved->clear_accum = clear.accum;
    if (mask & GL_COLOR_BUFFER_BIT) {
        saved->color_buffer = {fragment.color, clear.color, clear.index, ctx.framebuffer.draw_buffer};
    }
    if (mask & GL_CURRENT_BIT) saved->current = {ctx.vertex.current, ctx.raster_position};
    if (mask & GL_DEPTH_BUFFER_BIT) saved->depth_buffer = {fragment.depth, clear.depth};
    if (mask & GL_ENABLE_BIT) saved->enables = save_enables(ctx);
    if (mask & GL_EVAL_BIT) saved->evaluators = ctx.evaluators.modes;
    if (mask & GL_FOG_BIT) saved->fog = ctx.fog;
    if (mask & GL_HINT_BIT) saved->hints = ctx.hints;
    if (mask & GL_LIGHTING_BIT) {
        latch_color_material(ctx);
        saved->lighting = ctx.lighting;
    }
    if (mask & GL_LINE_BIT) saved->line = ctx.rasterization.line;
    if (mask & GL_LIST_BIT) saved->list_base = ctx.lists.base;
    if (mask & GL_PIXEL_MODE_BIT) saved->pixel_mode = {ctx.pixels.mode, ctx.framebuffer.read_buffer};
    if (mask & GL_MULTISAMPLE_BIT) saved->multisample = ctx.rasterization.multisample;
    if (mask & GL_POINT_BIT) saved->point = ctx.rasterization.point;
    if (mask & GL_POLYGON_BIT) saved->polygon = ctx.rasterization.polygon;
    if (mask & GL_POLYGON_STIPPLE_BIT) saved->polygon_stipple = ctx.rasterization.polygon_stipple;
    if (mask & GL_SCISSOR_BIT) saved->scissor = fragment.scissor;
    if (mask & GL_STENCIL_BUFFER_BIT) saved->stencil_buffer = {fragment.stencil, clear.stencil};
    if (mask & GL_TEXTURE_BIT) saved->texture = save_textures(ctx);
    if (mask & GL_TRANSFORM_BIT) saved->transform = ctx.matrix.transform;
    if (mask & GL_VIEWPORT_BIT) saved->viewport = ctx.framebuffer.viewport;
    return saved;
}

// Throws std::bad_alloc and changes nothing then.
void restore(Context& ctx, const SavedAttributes& saved) {
    begin_change(ctx, Dirty::kAll);
    ClearValues& clear = ctx.framebuffer.clear;
    FragmentOpsState& fragment = ctx.fragment_ops;
    // Nothing else needs memory.
    if (saved.color_buffer) select_draw_buffer(ctx, saved.color_buffer->draw_buffer);
    if (saved.clear_accum) clear.accum = *saved.clear_accum;
    if (saved.color_buffer) {
        fragment.color = saved.color_buffer->state;
        clear.color = saved.color_buffer->clear_color;
        clear.index = saved.color_buffer->clear_index;
    }
    if (saved.current) {
        ctx.vertex.current = saved.current->attributes;
        ctx.vertex.batch.fourth = pipeline::kHomogeneous;  // until Begin looks at them
        ctx.raster_position = saved.current->raster_position;
    }
    if (saved.depth_buffer) {
        fragment.depth = saved.depth_buffer->state;
        clear.depth = saved.depth_buffer->clear_depth;
    }
    if (saved.enables) {
        latch_color_material(ctx);  // a material that ceases to follow the colour keeps its last one
        restore_enables(ctx, *saved.enables);
    }
    if (saved.evaluators) ctx.evaluators.modes = *saved.evaluators;
    if (saved.fog) ctx.fog = *saved.fog;
    if (saved.hints) ctx.hints = *saved.hints;
    if (saved.lighting) ctx.lighting = *saved.lighting;
    if (saved.line) ctx.rasterization.line = *saved.line;
    if (saved.list_base) ctx.lists.base = *saved.list_base;
    if (saved.pixel_mode) {
        ctx.pixels.mode = saved.pixel_mode->mode;
        ctx.framebuffer.read_buffer = saved.pixel_mode->read_buffer;
    }
    if (saved.multisample) ctx.rasterization.multisample = *saved.multisample;
    if (saved.point) ctx.rasterization.point = *saved.point;
    if (saved.polygon) ctx.rasterization.polygon = *saved.polygon;
    if (saved.polygon_stipple) ctx.rasterization.polygon_stipple = *saved.polygon_stipple;
    if (saved.scissor) fragment.scissor = *saved.scissor;
    if (saved.stencil_buffer) {
        fragment.stencil = saved.stencil_buffer->state;
        clear.stencil = saved.stencil_buffer->clear_stencil;
    }
    if (saved.texture) restore_textures(ctx, *saved.texture);
    if (saved.transform) ctx.matrix.transform = *saved.transform;
    if (saved.viewport) ctx.framebuffer.viewport = *saved.viewport;
}

}  // namespace

struct SavedClientAttributes {
    std::optional<PixelStore> pack;
    std::optional<PixelStore> unpack;
    std::optional<ArrayState> arrays;
};

void push_attrib(Context& ctx, GLbitfield mask) {
    if (ctx.attrib.server.size() == kMaxAttribDepth) {
        return record_error(ctx, GL_STACK_OVERFLOW, "the attribute stack is full");
    }
    ctx.attrib.server.push_back(save(ctx, mask));
}

void pop_attrib(Context& ctx) {
    if (ctx.attrib.server.empty()) {
        return record_error(ctx, GL_STACK_UNDERFLOW, "the attribute stack is empty");
    }
    restore(ctx, *ctx.attrib.server.back());
    ctx.attrib.server.pop_back();
}

void copy_attributes(Context& from, Context& to, GLbitfield mask) {
    restore(to, *save(from, mask));
}

void push_client_attrib(Context& ctx, GLbitfield mask) {
    if (ctx.attrib.client.size() == kMaxClientAttribDepth) {
        return record_error(ctx, GL_STACK_OVERFLOW, "the client attribute stack is full");
    }
    auto saved = std::make_shared<SavedClientAttributes>();
    if (mask & GL_CLIENT_PIXEL_STORE_BIT) {
        saved->pack = ctx.pixels.pack;
        saved->unpack = ctx.pixels.unpack;
    }
    if (mask & GL_CLIENT_VERTEX_ARRAY_BIT) saved->arrays = ctx.arrays;
    ctx.attrib.client.push_back(std::move(saved));
}

void pop_client_attrib(Context& ctx) {
    if (ctx.attrib.client.empty()) {
        return record_error(ctx, GL_STACK_UNDERFLOW, "the client attribute stack is empty");
    }
    const SavedClientAttributes& saved = *ctx.attrib.client.back();
    // Buffers that were deleted meanwhile stay deleted.
    const auto is_deleted = [&](const BufferObject& buffer) { return !is_live(ctx, buffer); };
    const auto restore_store = [&](PixelStore& store, const PixelStore& value) {
        store = value;
        if (store.buffer && is_deleted(*store.buffer)) store.buffer.reset();
    };
    if (saved.pack) restore_store(ctx.pixels.pack, *saved.pack);
    if (saved.unpack) restore_store(ctx.pixels.unpack, *saved.unpack);
    if (saved.arrays) {
        ctx.arrays = *saved.arrays;
        forget_buffers(ctx.arrays, is_deleted);
    }
    ctx.attrib.client.pop_back();
}

}  // namespace terrazzo::gl
