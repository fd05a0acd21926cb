// The table of what never changes in a context: limits, and the formats of the render target (GL 1.5
// tables 6.31-6.35).
#include "gl/bezier.h"
#include "gl/block_compression.h"
#include "gl/state_table.h"

namespace terrazzo::gl {
namespace {

using Out = StateValues;

struct BufferBits {
    int red, green, blue, alpha, depth, stencil;
};

BufferBits bits_of(const raster::TargetFormat& format) {
    const ColorBits color = color_bits(format);
    return {color.red, color.green, color.blue, color.alpha, format.depth_bits, format.stencil_bits};
}

// Of a frame buffer object what its attachments have, drawn to or not; nothing where it is not complete.
BufferBits drawn_bits(Context& ctx) {
    const Framebuffer* const object = ctx.framebuffers.draw.get();
    if (!object) return bits_of(ctx.surface.format);
    if (framebuffer_status(ctx, object) != GL_FRAMEBUFFER_COMPLETE) return {};
    const auto lock = lock_textures(ctx);
    const auto bits = [&](AttachmentPoint point, GLenum pname) {
        const Attachment& a = object->attachments[point];
        return a.is_empty() ? 0 : size_in_bits(a, pname);
    };
    return {bits(kColorAttachment, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE),
            bits(kColorAttachment, GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE),
            bits(kColorAttachment, GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE),
            bits(kColorAttachment, GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE),
            bits(kDepthAttachment, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE),
            bits(kStencilAttachment, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE)};
}

// Frame buffer objects have no accumulation buffer.
int accumulation_bits(const Context& ctx) {
    return ctx.framebuffers.draw ? 0 : ctx.config.accum_bits;
}

constexpr auto kVariables = sorted_by_name(std::to_array<StateVariable>({
    // What the implementation promises
    {GL_MAX_LIGHTS, [](Context&, Out& out) { out = kMaxLights; }},
    {GL_MAX_CLIP_PLANES, [](Context&, Out& out) { out = kMaxClipPlanes; }},
    {GL_MAX_MODELVIEW_STACK_DEPTH, [](Context&, Out& out) { out = kMaxModelviewDepth; }},
    {GL_MAX_PROJECTION_STACK_DEPTH, [](Context&, Out& out) { out = kMaxProjectionDepth; }},
    {GL_MAX_TEXTURE_STACK_DEPTH, [](Context&, Out& out) { out = kMaxTextureMatrixDepth; }},
    {GL_MAX_ATTRIB_STACK_DEPTH, [](Context&, Out& out) { out = kMaxAttribDepth; }},
    {GL_MAX_CLIENT_ATTRIB_STACK_DEPTH, [](Context&, Out& out) { out = kMaxClientAttribDepth; }},
    {GL_MAX_NAME_STACK_DEPTH, [](Context&, Out& out) { out = kMaxNameStackDepth; }},
    {GL_MAX_EVAL_ORDER, [](Context&, Out& out) { out = kMaxEvalOrder; }},
    {GL_MAX_LIST_NESTING, [](Context&, Out& out) { out = kMaxListNesting; }},
    {GL_MAX_PIXEL_MAP_TABLE, [](Context&, Out& out) { out = kMaxPixelMapTable; }},
    {GL_MAX_TEXTURE_UNITS, [](Context&, Out& out) { out = kMaxTextureUnits; }},
    {GL_MAX_TEXTURE_SIZE, [](Context&, Out& out) { out = kMaxTextureSize; }},
    {GL_MAX_RENDERBUFFER_SIZE, [](Context&, Out& out) { out = kMaxRenderbufferSize; }},
    {GL_MAX_COLOR_ATTACHMENTS, [](Context&, Out& out) { out = 1; }},
    {GL_MAX_SAMPLES, [](Context&, Out& out) { out = kMaxSamples; }},
    {GL_MAX_3D_TEXTURE_SIZE, [](Context&, Out& out) { out = kMax3dTextureSize; }},
    {GL_MAX_CUBE_MAP_TEXTURE_SIZE, [](Context&, Out& out) { out = kMaxCubeTextureSize; }},
    {GL_MAX_VIEWPORT_DIMS, [](Context&, Out& out) { out = std::array{kMaxViewportSize, kMaxViewportSize}; }},
    {GL_MAX_TEXTURE_LOD_BIAS, [](Context&, Out& out) { out = kMaxTextureLodBias; }},
    {GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, [](Context&, Out& out) { out = kMaxTextureAnisotropy; }},
    {GL_NUM_COMPRESSED_TEXTURE_FORMATS, [](Context&, Out& out) { out = std::size(kOfferedBlockFormats); }},
    {GL_COMPRESSED_TEXTURE_FORMATS, [](Context&, Out& out) { out = std::to_array(kOfferedBlockFormats); }},
    {GL_SUBPIXEL_BITS, [](Context&, Out& out) { out = kSubpixelBits; }},
    {GL_POINT_SIZE_RANGE, [](Context&, Out& out) { out = std::array{kMinPointSize, kMaxPointSize}; }},
    {GL_POINT_SIZE_GRANULARITY, [](Context&, Out& out) { out = kPointSizeGranularity; }},
    {GL_ALIASED_POINT_SIZE_RANGE, [](Context&, Out& out) { out = std::array{kMinPointSize, kMaxPointSize}; }},
    {GL_LINE_WIDTH_RANGE, [](Context&, Out& out) { out = std::array{kMinLineWidth, kMaxLineWidth}; }},
    {GL_LINE_WIDTH_GRANULARITY, [](Context&, Out& out) { out = kLineWidthGranularity; }},
    {GL_ALIASED_LINE_WIDTH_RANGE, [](Context&, Out& out) { out = std::array{kMinLineWidth, kMaxLineWidth}; }},
    {GL_MAX_ELEMENTS_VERTICES, [](Context&, Out& out) { out = kMaxElementsVertices; }},
    {GL_MAX_ELEMENTS_INDICES, [](Context&, Out& out) { out = kMaxElementsIndices; }},

    // The render target
    {GL_RGBA_MODE, [](Context&, Out& out) { out = true; }},
    {GL_INDEX_MODE, [](Context&, Out& out) { out = false; }},
    {GL_DOUBLEBUFFER,
     [](Context& c, Out& out) { out = c.surface.draw && c.surface.draw->is_double_buffered(); }},
    {GL_STEREO, [](Context&, Out& out) { out = false; }},
    {GL_AUX_BUFFERS, [](Context&, Out& out) { out = 0; }},
    {GL_INDEX_BITS, [](Context&, Out& out) { out = 0; }},
    {GL_RED_BITS, [](Context& c, Out& out) { out = drawn_bits(c).red; }},
    {GL_GREEN_BITS, [](Context& c, Out& out) { out = drawn_bits(c).green; }},
    {GL_BLUE_BITS, [](Context& c, Out& out) { out = drawn_bits(c).blue; }},
    {GL_ALPHA_BITS, [](Context& c, Out& out) { out = drawn_bits(c).alpha; }},
    {GL_DEPTH_BITS, [](Context& c, Out& out) { out = drawn_bits(c).depth; }},
    {GL_STENCIL_BITS, [](Context& c, Out& out) { out = drawn_bits(c).stencil; }},
    {GL_SAMPLE_BUFFERS, [](Context& c, Out& out) { out = drawn_samples(c) > 0; }},
    {GL_SAMPLES, [](Context& c, Out& out) { out = drawn_samples(c); }},
    {GL_ACCUM_RED_BITS, [](Context& c, Out& out) { out = accumulation_bits(c); }},
    {GL_ACCUM_GREEN_BITS, [](Context& c, Out& out) { out = accumulation_bits(c); }},
    {GL_ACCUM_BLUE_BITS, [](Context& c, Out& out) { out = accumulation_bits(c); }},
    {GL_ACCUM_ALPHA_BITS, [](Context& c, Out& out) { out = accumulation_bits(c); }},
    {GL_RENDER_MODE, [](Context& c, Out& out) { out = c.render_mode.mode; }},
    {GL_NAME_STACK_DEPTH, [](Context& c, Out& out) { out = c.render_mode.selection.depth; }},
    {GL_SELECTION_BUFFER_SIZE, [](Context& c, Out& out) { out = c.render_mode.selection.size; }},
    {GL_FEEDBACK_BUFFER_SIZE, [](Context& c, Out& out) { out = c.render_mode.feedback.size; }},
    {GL_FEEDBACK_BUFFER_TYPE, [](Context& c, Out& out) { out = c.render_mode.feedback.type; }},
}));

}  // namespace

std::span<const StateVariable> limit_variables() {
    return kVariables;
}

}  // namespace terrazzo::gl
