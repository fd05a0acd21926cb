// The table of the state variables (GL 1.5 tables 6.5-6.35) beside the capabilities, which enable.cpp knows.
#include "gl/state_table.h"

#include <algorithm>

#include "gl/enable.h"

namespace terrazzo::gl {
namespace {

using Out = StateValues;

struct StateVariable {
    GLenum name;
    void (*read)(Context& ctx, Out& out);
};

template <typename Value>
void normalized(Out& out, const Value& value) {
    out.kind = StateKind::kNormalized;
    out = value;
}

// Colours of a fixed-point target are clamped when they are used; a query answers what is used.
void clamped(Out& out, const std::array<GLfloat, 4>& color) {
    out.kind = StateKind::kNormalized;
    for (GLfloat component : color) out.push(std::clamp(component, 0.0f, 1.0f));
}

void matrix(Out& out, const StackMatrix& entry) {
    for (GLfloat element : entry.value.m) out.push(element);
}

int depth(const MatrixStack& stack) {
    return static_cast<int>(stack.entries.size());
}

MatrixStack& texture_stack(Context& c) {
    return c.matrix.texture[c.texture.active_unit];
}

GLint stencil_reference(const Context& c) {
    return std::clamp(c.fragment_ops.stencil.reference, 0, (1 << c.config.stencil_bits) - 1);
}

GLuint texture_name(Context& c, TextureTarget target) {
    const auto& bound = c.texture.units[c.texture.active_unit].bound[target];
    return bound ? bound->name : 0;
}

struct ColorBits {
    int red, green, blue, alpha;
};

ColorBits color_bits(const raster::TargetFormat& format) {
    int bits = 8;
    switch (format.color) {
        case raster::ColorFormat::kRgba8: break;
        case raster::ColorFormat::kRgba16: bits = 16; break;
        case raster::ColorFormat::kRgba32F: bits = 32; break;
        case raster::ColorFormat::kRgb565: return {5, 6, 5, 0};
    }
    return {bits, bits, bits, format.has_alpha ? bits : 0};
}

constexpr auto kByName = [](const StateVariable& a, const StateVariable& b) { return a.name < b.name; };

constexpr auto kVariables = [] {
    auto variables = std::to_array<StateVariable>({
        // Transformation and viewport
        {GL_MODELVIEW_MATRIX, [](Context& c, Out& out) { matrix(out, c.matrix.modelview.top()); }},
        {GL_PROJECTION_MATRIX, [](Context& c, Out& out) { matrix(out, c.matrix.projection.top()); }},
        {GL_TEXTURE_MATRIX, [](Context& c, Out& out) { matrix(out, texture_stack(c).top()); }},
        {GL_MODELVIEW_STACK_DEPTH, [](Context& c, Out& out) { out = depth(c.matrix.modelview); }},
        {GL_PROJECTION_STACK_DEPTH, [](Context& c, Out& out) { out = depth(c.matrix.projection); }},
        {GL_TEXTURE_STACK_DEPTH, [](Context& c, Out& out) { out = depth(texture_stack(c)); }},
        {GL_MATRIX_MODE, [](Context& c, Out& out) { out = c.matrix.transform.matrix_mode; }},
        {GL_VIEWPORT,
         [](Context& c, Out& out) {
             const ViewportState& v = c.framebuffer.viewport;
             out = std::array{v.x, v.y, v.width, v.height};
         }},
        {GL_DEPTH_RANGE,
         [](Context& c, Out& out) {
             normalized(out, std::array{c.framebuffer.viewport.near_depth, c.framebuffer.viewport.far_depth});
         }},

        // Fog
        {GL_FOG_MODE, [](Context& c, Out& out) { out = c.fog.mode; }},
        {GL_FOG_COLOR, [](Context& c, Out& out) { clamped(out, c.fog.color); }},
        {GL_FOG_DENSITY, [](Context& c, Out& out) { out = c.fog.density; }},
        {GL_FOG_START, [](Context& c, Out& out) { out = c.fog.start; }},
        {GL_FOG_END, [](Context& c, Out& out) { out = c.fog.end; }},
        {GL_FOG_INDEX, [](Context& c, Out& out) { out = c.fog.index; }},

        // Lighting
        {GL_SHADE_MODEL, [](Context& c, Out& out) { out = c.lighting.shade_model; }},
        {GL_COLOR_MATERIAL_FACE, [](Context& c, Out& out) { out = c.lighting.color_material.face; }},
        {GL_COLOR_MATERIAL_PARAMETER, [](Context& c, Out& out) { out = c.lighting.color_material.mode; }},
        {GL_LIGHT_MODEL_AMBIENT, [](Context& c, Out& out) { normalized(out, c.lighting.model.ambient); }},
        {GL_LIGHT_MODEL_LOCAL_VIEWER, [](Context& c, Out& out) { out = c.lighting.model.local_viewer; }},
        {GL_LIGHT_MODEL_TWO_SIDE, [](Context& c, Out& out) { out = c.lighting.model.two_side; }},
        {GL_LIGHT_MODEL_COLOR_CONTROL, [](Context& c, Out& out) { out = c.lighting.model.color_control; }},

        // Rasterization
        {GL_POINT_SIZE, [](Context& c, Out& out) { out = c.rasterization.point.size; }},
        {GL_LINE_WIDTH, [](Context& c, Out& out) { out = c.rasterization.line.width; }},
        {GL_LINE_STIPPLE_PATTERN, [](Context& c, Out& out) { out = c.rasterization.line.stipple_pattern; }},
        {GL_LINE_STIPPLE_REPEAT, [](Context& c, Out& out) { out = c.rasterization.line.stipple_factor; }},
        {GL_CULL_FACE_MODE, [](Context& c, Out& out) { out = c.rasterization.polygon.cull_face; }},
        {GL_FRONT_FACE, [](Context& c, Out& out) { out = c.rasterization.polygon.front_face; }},
        {GL_POLYGON_MODE,
         [](Context& c, Out& out) {
             out = std::array{c.rasterization.polygon.front_mode, c.rasterization.polygon.back_mode};
         }},
        {GL_POLYGON_OFFSET_FACTOR, [](Context& c, Out& out) { out = c.rasterization.polygon.offset_factor; }},
        {GL_POLYGON_OFFSET_UNITS, [](Context& c, Out& out) { out = c.rasterization.polygon.offset_units; }},

        // Textures
        {GL_TEXTURE_BINDING_1D, [](Context& c, Out& out) { out = texture_name(c, kTexture1D); }},
        {GL_TEXTURE_BINDING_2D, [](Context& c, Out& out) { out = texture_name(c, kTexture2D); }},

        // Per-fragment operations
        {GL_SCISSOR_BOX,
         [](Context& c, Out& out) {
             const ScissorState& s = c.fragment_ops.scissor;
             out = std::array{s.x, s.y, s.width, s.height};
         }},
        {GL_ALPHA_TEST_FUNC, [](Context& c, Out& out) { out = c.fragment_ops.color.alpha_test.func; }},
        {GL_ALPHA_TEST_REF,
         [](Context& c, Out& out) {
             normalized(out, std::clamp(c.fragment_ops.color.alpha_test.reference, 0.0f, 1.0f));
         }},
        {GL_STENCIL_FUNC, [](Context& c, Out& out) { out = c.fragment_ops.stencil.func; }},
        {GL_STENCIL_VALUE_MASK, [](Context& c, Out& out) { out = c.fragment_ops.stencil.value_mask; }},
        {GL_STENCIL_REF, [](Context& c, Out& out) { out = stencil_reference(c); }},
        {GL_STENCIL_FAIL, [](Context& c, Out& out) { out = c.fragment_ops.stencil.fail; }},
        {GL_STENCIL_PASS_DEPTH_FAIL, [](Context& c, Out& out) { out = c.fragment_ops.stencil.depth_fail; }},
        {GL_STENCIL_PASS_DEPTH_PASS, [](Context& c, Out& out) { out = c.fragment_ops.stencil.depth_pass; }},
        {GL_DEPTH_FUNC, [](Context& c, Out& out) { out = c.fragment_ops.depth.func; }},
        {GL_BLEND_SRC, [](Context& c, Out& out) { out = c.fragment_ops.color.blend.source_rgb; }},
        {GL_BLEND_DST, [](Context& c, Out& out) { out = c.fragment_ops.color.blend.destination_rgb; }},
        {GL_LOGIC_OP_MODE, [](Context& c, Out& out) { out = c.fragment_ops.color.logic_op.op; }},

        // Frame buffer
        {GL_DRAW_BUFFER, [](Context& c, Out& out) { out = c.framebuffer.draw_buffer; }},
        {GL_READ_BUFFER, [](Context& c, Out& out) { out = c.framebuffer.read_buffer; }},
        {GL_INDEX_WRITEMASK, [](Context& c, Out& out) { out = static_cast<GLint>(c.fragment_ops.color.index_write_mask); }},
        {GL_COLOR_WRITEMASK, [](Context& c, Out& out) { out = c.fragment_ops.color.write_mask; }},
        {GL_DEPTH_WRITEMASK, [](Context& c, Out& out) { out = c.fragment_ops.depth.write_mask; }},
        {GL_STENCIL_WRITEMASK, [](Context& c, Out& out) { out = c.fragment_ops.stencil.write_mask; }},
        {GL_COLOR_CLEAR_VALUE, [](Context& c, Out& out) { clamped(out, c.framebuffer.clear.color); }},
        {GL_INDEX_CLEAR_VALUE, [](Context& c, Out& out) { out = c.framebuffer.clear.index; }},
        {GL_DEPTH_CLEAR_VALUE, [](Context& c, Out& out) { normalized(out, c.framebuffer.clear.depth); }},
        {GL_STENCIL_CLEAR_VALUE, [](Context& c, Out& out) { out = c.framebuffer.clear.stencil; }},
        {GL_ACCUM_CLEAR_VALUE, [](Context& c, Out& out) { normalized(out, c.framebuffer.clear.accum); }},

        // Pixels
        {GL_UNPACK_SWAP_BYTES, [](Context& c, Out& out) { out = c.pixels.unpack.swap_bytes; }},
        {GL_UNPACK_LSB_FIRST, [](Context& c, Out& out) { out = c.pixels.unpack.lsb_first; }},
        {GL_UNPACK_ROW_LENGTH, [](Context& c, Out& out) { out = c.pixels.unpack.row_length; }},
        {GL_UNPACK_SKIP_ROWS, [](Context& c, Out& out) { out = c.pixels.unpack.skip_rows; }},
        {GL_UNPACK_SKIP_PIXELS, [](Context& c, Out& out) { out = c.pixels.unpack.skip_pixels; }},
        {GL_UNPACK_ALIGNMENT, [](Context& c, Out& out) { out = c.pixels.unpack.alignment; }},
        {GL_PACK_SWAP_BYTES, [](Context& c, Out& out) { out = c.pixels.pack.swap_bytes; }},
        {GL_PACK_LSB_FIRST, [](Context& c, Out& out) { out = c.pixels.pack.lsb_first; }},
        {GL_PACK_ROW_LENGTH, [](Context& c, Out& out) { out = c.pixels.pack.row_length; }},
        {GL_PACK_SKIP_ROWS, [](Context& c, Out& out) { out = c.pixels.pack.skip_rows; }},
        {GL_PACK_SKIP_PIXELS, [](Context& c, Out& out) { out = c.pixels.pack.skip_pixels; }},
        {GL_PACK_ALIGNMENT, [](Context& c, Out& out) { out = c.pixels.pack.alignment; }},
        {GL_MAP_COLOR, [](Context& c, Out& out) { out = c.pixels.mode.transfer.map_color; }},
        {GL_MAP_STENCIL, [](Context& c, Out& out) { out = c.pixels.mode.transfer.map_stencil; }},
        {GL_INDEX_SHIFT, [](Context& c, Out& out) { out = c.pixels.mode.transfer.index_shift; }},
        {GL_INDEX_OFFSET, [](Context& c, Out& out) { out = c.pixels.mode.transfer.index_offset; }},
        {GL_RED_SCALE, [](Context& c, Out& out) { out = c.pixels.mode.transfer.scale[0]; }},
        {GL_GREEN_SCALE, [](Context& c, Out& out) { out = c.pixels.mode.transfer.scale[1]; }},
        {GL_BLUE_SCALE, [](Context& c, Out& out) { out = c.pixels.mode.transfer.scale[2]; }},
        {GL_ALPHA_SCALE, [](Context& c, Out& out) { out = c.pixels.mode.transfer.scale[3]; }},
        {GL_RED_BIAS, [](Context& c, Out& out) { out = c.pixels.mode.transfer.bias[0]; }},
        {GL_GREEN_BIAS, [](Context& c, Out& out) { out = c.pixels.mode.transfer.bias[1]; }},
        {GL_BLUE_BIAS, [](Context& c, Out& out) { out = c.pixels.mode.transfer.bias[2]; }},
        {GL_ALPHA_BIAS, [](Context& c, Out& out) { out = c.pixels.mode.transfer.bias[3]; }},
        {GL_DEPTH_SCALE, [](Context& c, Out& out) { out = c.pixels.mode.transfer.depth_scale; }},
        {GL_DEPTH_BIAS, [](Context& c, Out& out) { out = c.pixels.mode.transfer.depth_bias; }},
        {GL_ZOOM_X, [](Context& c, Out& out) { out = c.pixels.mode.zoom_x; }},
        {GL_ZOOM_Y, [](Context& c, Out& out) { out = c.pixels.mode.zoom_y; }},

        // Hints
        {GL_PERSPECTIVE_CORRECTION_HINT, [](Context& c, Out& out) { out = c.hints.perspective_correction; }},
        {GL_POINT_SMOOTH_HINT, [](Context& c, Out& out) { out = c.hints.point_smooth; }},
        {GL_LINE_SMOOTH_HINT, [](Context& c, Out& out) { out = c.hints.line_smooth; }},
        {GL_POLYGON_SMOOTH_HINT, [](Context& c, Out& out) { out = c.hints.polygon_smooth; }},
        {GL_FOG_HINT, [](Context& c, Out& out) { out = c.hints.fog; }},
        {GL_GENERATE_MIPMAP_HINT, [](Context& c, Out& out) { out = c.hints.generate_mipmap; }},
        {GL_TEXTURE_COMPRESSION_HINT, [](Context& c, Out& out) { out = c.hints.texture_compression; }},

        // Display lists
        {GL_LIST_BASE, [](Context& c, Out& out) { out = c.lists.base; }},
        {GL_LIST_INDEX, [](Context& c, Out& out) { out = c.lists.compiling_name; }},
        {GL_LIST_MODE, [](Context& c, Out& out) { out = c.lists.mode; }},

        // Attribute stacks
        {GL_ATTRIB_STACK_DEPTH, [](Context& c, Out& out) { out = c.attrib.server.size(); }},
        {GL_CLIENT_ATTRIB_STACK_DEPTH, [](Context& c, Out& out) { out = c.attrib.client.size(); }},

        // What the implementation promises
        {GL_MAX_LIGHTS, [](Context&, Out& out) { out = kMaxLights; }},
        {GL_MAX_CLIP_PLANES, [](Context&, Out& out) { out = kMaxClipPlanes; }},
        {GL_MAX_MODELVIEW_STACK_DEPTH, [](Context&, Out& out) { out = kMaxModelviewDepth; }},
        {GL_MAX_PROJECTION_STACK_DEPTH, [](Context&, Out& out) { out = kMaxProjectionDepth; }},
        {GL_MAX_TEXTURE_STACK_DEPTH, [](Context&, Out& out) { out = kMaxTextureMatrixDepth; }},
        {GL_MAX_ATTRIB_STACK_DEPTH, [](Context&, Out& out) { out = kMaxAttribDepth; }},
        {GL_MAX_CLIENT_ATTRIB_STACK_DEPTH, [](Context&, Out& out) { out = kMaxClientAttribDepth; }},
        {GL_MAX_NAME_STACK_DEPTH, [](Context&, Out& out) { out = kMaxNameStackDepth; }},
        {GL_MAX_LIST_NESTING, [](Context&, Out& out) { out = kMaxListNesting; }},
        {GL_MAX_PIXEL_MAP_TABLE, [](Context&, Out& out) { out = kMaxPixelMapTable; }},
        {GL_MAX_TEXTURE_SIZE, [](Context&, Out& out) { out = kMaxTextureSize; }},
        {GL_MAX_VIEWPORT_DIMS, [](Context&, Out& out) { out = std::array{kMaxViewportSize, kMaxViewportSize}; }},
        {GL_SUBPIXEL_BITS, [](Context&, Out& out) { out = kSubpixelBits; }},
        {GL_POINT_SIZE_RANGE, [](Context&, Out& out) { out = std::array{kMinPointSize, kMaxPointSize}; }},
        {GL_POINT_SIZE_GRANULARITY, [](Context&, Out& out) { out = kPointSizeGranularity; }},
        {GL_ALIASED_POINT_SIZE_RANGE,
         [](Context&, Out& out) { out = std::array{kMinPointSize, kMaxPointSize}; }},
        {GL_LINE_WIDTH_RANGE, [](Context&, Out& out) { out = std::array{kMinLineWidth, kMaxLineWidth}; }},
        {GL_LINE_WIDTH_GRANULARITY, [](Context&, Out& out) { out = kLineWidthGranularity; }},
        {GL_ALIASED_LINE_WIDTH_RANGE,
         [](Context&, Out& out) { out = std::array{kMinLineWidth, kMaxLineWidth}; }},

        // The render target
        {GL_RGBA_MODE, [](Context&, Out& out) { out = true; }},
        {GL_INDEX_MODE, [](Context&, Out& out) { out = false; }},
        {GL_DOUBLEBUFFER, [](Context&, Out& out) { out = false; }},
        {GL_STEREO, [](Context&, Out& out) { out = false; }},
        {GL_AUX_BUFFERS, [](Context&, Out& out) { out = 0; }},
        {GL_INDEX_BITS, [](Context&, Out& out) { out = 0; }},
        {GL_RED_BITS, [](Context& c, Out& out) { out = color_bits(c.surface.format).red; }},
        {GL_GREEN_BITS, [](Context& c, Out& out) { out = color_bits(c.surface.format).green; }},
        {GL_BLUE_BITS, [](Context& c, Out& out) { out = color_bits(c.surface.format).blue; }},
        {GL_ALPHA_BITS, [](Context& c, Out& out) { out = color_bits(c.surface.format).alpha; }},
        {GL_DEPTH_BITS, [](Context& c, Out& out) { out = c.surface.format.depth_bits; }},
        {GL_STENCIL_BITS, [](Context& c, Out& out) { out = c.surface.format.stencil_bits; }},
        {GL_ACCUM_RED_BITS, [](Context&, Out& out) { out = 0; }},
        {GL_ACCUM_GREEN_BITS, [](Context&, Out& out) { out = 0; }},
        {GL_ACCUM_BLUE_BITS, [](Context&, Out& out) { out = 0; }},
        {GL_ACCUM_ALPHA_BITS, [](Context&, Out& out) { out = 0; }},
        {GL_RENDER_MODE, [](Context&, Out& out) { out = GL_RENDER; }},
    });
    std::ranges::sort(variables, kByName);
    return variables;
}();

}  // namespace

bool read_state(Context& ctx, GLenum pname, StateValues& values) {
    const auto* found = std::ranges::lower_bound(kVariables, StateVariable{pname, nullptr}, kByName);
    if (found != kVariables.end() && found->name == pname) {
        found->read(ctx, values);
        return true;
    }
    const bool* enabled = find_capability(ctx, pname).enabled;
    if (!enabled) return false;
    values = *enabled;
    return true;
}

}  // namespace terrazzo::gl
