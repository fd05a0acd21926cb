// Queries of state variables (GL 1.5 tables 6.5-6.35): the search, and the table of what decides how things
// are drawn. Capabilities are in enable.cpp.
#include "gl/state_table.h"

#include <algorithm>

#include "gl/enable.h"

namespace terrazzo::gl {
namespace {

using Out = StateValues;

// Colours of a fixed-point target are clamped when they are used; a query answers what is used.
void clamped(Out& out, const std::array<GLfloat, 4>& color) {
    out.kind = StateKind::kNormalized;
    for (GLfloat component : color) out.push(std::clamp(component, 0.0f, 1.0f));
}

void matrix(Out& out, const StackMatrix& entry) {
    for (GLfloat element : entry.value.m) out.push(element);
}

void transposed(Out& out, const StackMatrix& entry) {
    for (GLfloat element : transpose(entry.value).m) out.push(element);
}

int depth(const MatrixStack& stack) {
    return static_cast<int>(stack.entries.size());
}

MatrixStack& texture_stack(Context& c) {
    return c.matrix.texture[c.texture.active_unit];
}

const StencilFace& stencil(const Context& c) {
    return c.fragment_ops.stencil.active();
}

const StencilFace& back_stencil(const Context& c) {
    return c.fragment_ops.stencil.back;
}

GLint stencil_reference(const Context& c, const StencilFace& face) {
    return std::clamp(face.reference, 0, (1 << c.config.stencil_bits) - 1);
}

GLuint texture_name(const Context& c, TextureTarget target) {
    return c.texture.units[c.texture.active_unit].bound[target]->name;
}

constexpr auto kDrawingVariables = sorted_by_name(std::to_array<StateVariable>({
        // Transformation and viewport
        {GL_MODELVIEW_MATRIX, [](Context& c, Out& out) { matrix(out, c.matrix.modelview.top()); }},
        {GL_PROJECTION_MATRIX, [](Context& c, Out& out) { matrix(out, c.matrix.projection.top()); }},
        {GL_TEXTURE_MATRIX, [](Context& c, Out& out) { matrix(out, texture_stack(c).top()); }},
        {GL_MODELVIEW_STACK_DEPTH, [](Context& c, Out& out) { out = depth(c.matrix.modelview); }},
        {GL_PROJECTION_STACK_DEPTH, [](Context& c, Out& out) { out = depth(c.matrix.projection); }},
        {GL_TEXTURE_STACK_DEPTH, [](Context& c, Out& out) { out = depth(texture_stack(c)); }},
        {GL_MATRIX_MODE, [](Context& c, Out& out) { out = c.matrix.transform.matrix_mode; }},
        {GL_CLIP_ORIGIN, [](Context& c, Out& out) { out = c.matrix.transform.clip_origin; }},
        {GL_CLIP_DEPTH_MODE, [](Context& c, Out& out) { out = c.matrix.transform.clip_depth_mode; }},
        {GL_VIEWPORT,
         [](Context& c, Out& out) {
             const ViewportState& v = c.framebuffer.viewport;
             out = std::array{v.x, v.y, v.width, v.height};
         }},
        {GL_DEPTH_RANGE,
         [](Context& c, Out& out) {
             normalized(out, std::array{c.framebuffer.viewport.near_depth, c.framebuffer.viewport.far_depth});
         }},
        {GL_TRANSPOSE_MODELVIEW_MATRIX, [](Context& c, Out& out) { transposed(out, c.matrix.modelview.top()); }},
        {GL_TRANSPOSE_PROJECTION_MATRIX, [](Context& c, Out& out) { transposed(out, c.matrix.projection.top()); }},
        {GL_TRANSPOSE_TEXTURE_MATRIX, [](Context& c, Out& out) { transposed(out, texture_stack(c).top()); }},

        // Fog
        {GL_FOG_MODE, [](Context& c, Out& out) { out = c.fog.mode; }},
        {GL_FOG_COLOR, [](Context& c, Out& out) { clamped(out, c.fog.color); }},
        {GL_FOG_DENSITY, [](Context& c, Out& out) { out = c.fog.density; }},
        {GL_FOG_START, [](Context& c, Out& out) { out = c.fog.start; }},
        {GL_FOG_END, [](Context& c, Out& out) { out = c.fog.end; }},
        {GL_FOG_INDEX, [](Context& c, Out& out) { out = c.fog.index; }},

        {GL_FOG_DISTANCE_MODE_NV, [](Context& c, Out& out) { out = c.fog.distance_mode; }},
        {GL_FOG_COORDINATE_SOURCE, [](Context& c, Out& out) { out = c.fog.coordinate_source; }},

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
        {GL_POINT_SIZE_MIN, [](Context& c, Out& out) { out = c.rasterization.point.min_size; }},
        {GL_POINT_SIZE_MAX, [](Context& c, Out& out) { out = c.rasterization.point.max_size; }},
        {GL_POINT_FADE_THRESHOLD_SIZE, [](Context& c, Out& out) { out = c.rasterization.point.fade_threshold; }},
        {GL_POINT_DISTANCE_ATTENUATION, [](Context& c, Out& out) { out = c.rasterization.point.attenuation; }},
        {GL_SAMPLE_COVERAGE_VALUE,
         [](Context& c, Out& out) { out = c.rasterization.multisample.coverage_value; }},
        {GL_SAMPLE_COVERAGE_INVERT,
         [](Context& c, Out& out) { out = c.rasterization.multisample.coverage_invert; }},
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
        {GL_ACTIVE_TEXTURE, [](Context& c, Out& out) { out = GL_TEXTURE0 + c.texture.active_unit; }},
        {GL_FRAMEBUFFER_BINDING,
         [](Context& c, Out& out) { out = c.framebuffers.draw ? c.framebuffers.draw->name() : 0; }},
        {GL_READ_FRAMEBUFFER_BINDING,
         [](Context& c, Out& out) { out = c.framebuffers.read ? c.framebuffers.read->name() : 0; }},
        {GL_RENDERBUFFER_BINDING,
         [](Context& c, Out& out) { out = c.framebuffers.renderbuffer ? c.framebuffers.renderbuffer->name : 0; }},
        {GL_TEXTURE_BINDING_1D, [](Context& c, Out& out) { out = texture_name(c, kTexture1D); }},
        {GL_TEXTURE_BINDING_2D, [](Context& c, Out& out) { out = texture_name(c, kTexture2D); }},
        {GL_TEXTURE_BINDING_3D, [](Context& c, Out& out) { out = texture_name(c, kTexture3D); }},
        {GL_TEXTURE_BINDING_CUBE_MAP, [](Context& c, Out& out) { out = texture_name(c, kTextureCube); }},

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
        {GL_STENCIL_FUNC, [](Context& c, Out& out) { out = stencil(c).func; }},
        {GL_STENCIL_VALUE_MASK, [](Context& c, Out& out) { out = stencil(c).value_mask; }},
        {GL_STENCIL_REF, [](Context& c, Out& out) { out = stencil_reference(c, stencil(c)); }},
        {GL_STENCIL_FAIL, [](Context& c, Out& out) { out = stencil(c).fail; }},
        {GL_STENCIL_PASS_DEPTH_FAIL, [](Context& c, Out& out) { out = stencil(c).depth_fail; }},
        {GL_STENCIL_PASS_DEPTH_PASS, [](Context& c, Out& out) { out = stencil(c).depth_pass; }},
        {GL_STENCIL_BACK_FUNC, [](Context& c, Out& out) { out = back_stencil(c).func; }},
        {GL_STENCIL_BACK_VALUE_MASK, [](Context& c, Out& out) { out = back_stencil(c).value_mask; }},
        {GL_STENCIL_BACK_REF, [](Context& c, Out& out) { out = stencil_reference(c, back_stencil(c)); }},
        {GL_STENCIL_BACK_FAIL, [](Context& c, Out& out) { out = back_stencil(c).fail; }},
        {GL_STENCIL_BACK_PASS_DEPTH_FAIL, [](Context& c, Out& out) { out = back_stencil(c).depth_fail; }},
        {GL_STENCIL_BACK_PASS_DEPTH_PASS, [](Context& c, Out& out) { out = back_stencil(c).depth_pass; }},
        {GL_ACTIVE_STENCIL_FACE_EXT, [](Context& c, Out& out) { out = c.fragment_ops.stencil.active_face; }},
        {GL_DEPTH_FUNC, [](Context& c, Out& out) { out = c.fragment_ops.depth.func; }},
        {GL_BLEND_SRC, [](Context& c, Out& out) { out = c.fragment_ops.color.blend.source_rgb; }},
        {GL_BLEND_DST, [](Context& c, Out& out) { out = c.fragment_ops.color.blend.destination_rgb; }},
        {GL_BLEND_SRC_RGB, [](Context& c, Out& out) { out = c.fragment_ops.color.blend.source_rgb; }},
        {GL_BLEND_SRC_ALPHA, [](Context& c, Out& out) { out = c.fragment_ops.color.blend.source_alpha; }},
        {GL_BLEND_DST_RGB, [](Context& c, Out& out) { out = c.fragment_ops.color.blend.destination_rgb; }},
        {GL_BLEND_DST_ALPHA, [](Context& c, Out& out) { out = c.fragment_ops.color.blend.destination_alpha; }},
        {GL_BLEND_EQUATION_RGB, [](Context& c, Out& out) { out = c.fragment_ops.color.blend.equation_rgb; }},
        {GL_BLEND_EQUATION_ALPHA, [](Context& c, Out& out) { out = c.fragment_ops.color.blend.equation_alpha; }},
        {GL_BLEND_COLOR, [](Context& c, Out& out) { clamped(out, c.fragment_ops.color.blend.color); }},
        {GL_LOGIC_OP_MODE, [](Context& c, Out& out) { out = c.fragment_ops.color.logic_op.op; }},

        // Frame buffer
        {GL_DRAW_BUFFER, [](Context& c, Out& out) { out = c.framebuffer.draw_buffer; }},
        {GL_READ_BUFFER, [](Context& c, Out& out) { out = c.framebuffer.read_buffer; }},
        {GL_INDEX_WRITEMASK, [](Context& c, Out& out) { out = static_cast<GLint>(c.fragment_ops.color.index_write_mask); }},
        {GL_COLOR_WRITEMASK, [](Context& c, Out& out) { out = c.fragment_ops.color.write_mask; }},
        {GL_DEPTH_WRITEMASK, [](Context& c, Out& out) { out = c.fragment_ops.depth.write_mask; }},
        {GL_STENCIL_WRITEMASK, [](Context& c, Out& out) { out = stencil(c).write_mask; }},
        {GL_STENCIL_BACK_WRITEMASK, [](Context& c, Out& out) { out = back_stencil(c).write_mask; }},
        {GL_COLOR_CLEAR_VALUE, [](Context& c, Out& out) { clamped(out, c.framebuffer.clear.color); }},
        {GL_INDEX_CLEAR_VALUE, [](Context& c, Out& out) { out = c.framebuffer.clear.index; }},
        {GL_DEPTH_CLEAR_VALUE, [](Context& c, Out& out) { normalized(out, c.framebuffer.clear.depth); }},
        {GL_STENCIL_CLEAR_VALUE, [](Context& c, Out& out) { out = c.framebuffer.clear.stencil; }},
        {GL_ACCUM_CLEAR_VALUE, [](Context& c, Out& out) { normalized(out, c.framebuffer.clear.accum); }},
}));

const StateVariable* find(std::span<const StateVariable> table, GLenum name) {
    const auto found = std::ranges::lower_bound(table, name, {}, &StateVariable::name);
    return found != table.end() && found->name == name ? &*found : nullptr;
}

}  // namespace

bool read_state(Context& ctx, GLenum pname, StateValues& values) {
    for (std::span<const StateVariable> table :
         {std::span<const StateVariable>(kDrawingVariables), client_variables(), limit_variables()}) {
        if (const StateVariable* variable = find(table, pname)) {
            variable->read(ctx, values);
            return true;
        }
    }
    if (const bool* enabled = find_capability(ctx, pname).enabled) return values = *enabled, true;
    if (const ClientArray* array = find_client_array(ctx.arrays, pname)) return values = array->enabled, true;
    return false;
}

}  // namespace terrazzo::gl
