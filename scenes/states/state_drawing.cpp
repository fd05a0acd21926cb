// A frame of a state: texels renewed, cleared, passes before, the mesh, passes after.
#include "state_drawing.h"

#include <algorithm>

namespace terrazzo::states {
namespace {

constexpr int kHelperCells = 16, kHelperSheets = 3;

struct Corner {
    float colour[4];
    float position[3];
};

void draw_quad(const kit::Gl& gl, const Corner (&corners)[4]) {
    gl.Begin(GL_QUADS);
    for (const Corner& corner : corners) {
        gl.Color4fv(corner.colour);
        gl.Vertex3fv(corner.position);
    }
    gl.End();
}

}  // namespace

void StateDrawing::prepare(const kit::Gl& gl, int width, int height) {
    m_width = width, m_height = height;
    // The object that stands in for a window with samples.
    gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &m_window_object);
    gl.Viewport(0, 0, width, height);
    const auto& background = m_state.is(Axis::kBlend, "min") ? kLightBackground : kBackground;
    gl.ClearColor(background[0], background[1], background[2], background[3]);
    if (m_state.is(Axis::kDepth, "greater")) gl.ClearDepth(0);
    apply_vertex_state(gl, m_state);
    apply_raster_state(gl, m_state);
    apply_fragment_state(gl, m_state);
    m_texture = apply_textures(gl, m_state);
    m_mesh.prepare(
        gl,
        make_mesh(static_cast<int>(m_state.number(Axis::kGeometry)),
                  static_cast<int>(m_state.number(Axis::kGeometry, 1)), m_state.number(Axis::kPrimitive)),
        attributes_of(m_state), m_state.number(Axis::kGiven));
    if (m_state.number(Axis::kTexels) != kUploaded) prepare_texels(gl);
}

void StateDrawing::prepare_texels(const kit::Gl& gl) {
    m_kind = kind_of(m_state);
    m_moving = MovingTexels(m_kind, 7);
    Attributes attributes;
    attributes.colours = GL_UNSIGNED_BYTE;
    m_helper.prepare(gl, make_mesh(kHelperCells, kHelperSheets, GL_TRIANGLES), attributes, kList);
    if (m_state.number(Axis::kTexels) != kRendered) return;
    const bool is_depth = m_kind.format == GL_DEPTH_COMPONENT;
    gl.GenFramebuffers(1, &m_object);
    gl.BindFramebuffer(GL_FRAMEBUFFER, m_object);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, is_depth ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0,
                            m_kind.target, m_texture, 0);
    if (is_depth) {
        gl.DrawBuffer(GL_NONE);
        gl.ReadBuffer(GL_NONE);
    } else {
        GLuint depths;
        gl.GenRenderbuffers(1, &depths);
        gl.BindRenderbuffer(GL_RENDERBUFFER, depths);
        gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, m_kind.width, m_kind.height);
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depths);
    }
    gl.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(m_window_object));
}

void StateDrawing::draw(const kit::Gl& gl, int /*frame*/) {
    if (m_state.number(Axis::kTexels) != kUploaded) renew_texels(gl);
    clear(gl);
    if (m_state.number(Axis::kScissor)) {
        gl.Scissor(m_width / 8, m_height / 6, m_width * 3 / 4, m_height * 2 / 3);
        gl.Enable(GL_SCISSOR_TEST);
    }
    if (m_state.number(Axis::kStencil) == kMasked) draw_stencil_mask(gl);
    if (m_state.number(Axis::kDepth) == GL_EQUAL) draw_depths(gl);
    m_mesh.draw(gl);
    if (m_state.is(Axis::kMask, "none")) draw_backdrop(gl);
    if (m_state.number(Axis::kStencil) == kSides) draw_shadow(gl);
    if (m_state.number(Axis::kScissor)) gl.Disable(GL_SCISSOR_TEST);
    // Colours that arrays leave behind (GL 1.5 §2.8) are not the next frame's.
    gl.Color4f(0.85F, 0.9F, 0.8F, 0.7F);
}

void StateDrawing::clear(const kit::Gl& gl) const {
    const bool is_masked = m_state.index(Axis::kMask) != 0 || m_state.number(Axis::kDepth, 1) == GL_FALSE;
    if (is_masked) {
        gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        gl.DepthMask(GL_TRUE);
    }
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    if (is_masked) apply_masks(gl, m_state);
}

// What passes beside the mesh's have in common: colours and depths alone.
void StateDrawing::begin_plain(const kit::Gl& gl) const {
    gl.PushAttrib(GL_ENABLE_BIT | GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT |
                  GL_CURRENT_BIT | GL_POLYGON_BIT | GL_VIEWPORT_BIT | GL_LIGHTING_BIT);
    for (const GLenum what :
         {GL_LIGHTING, GL_FOG, GL_ALPHA_TEST, GL_BLEND, GL_COLOR_LOGIC_OP, GL_STENCIL_TEST, GL_CULL_FACE,
          GL_POLYGON_STIPPLE, GL_CLIP_PLANE0, GL_CLIP_PLANE1})
        gl.Disable(what);
    for (GLuint unit = m_state.number(Axis::kUnits); unit-- > 0;) {
        gl.ActiveTexture(GL_TEXTURE0 + unit);
        gl.Disable(GL_TEXTURE_2D);
        if (unit == 0) gl.Disable(m_state.number(Axis::kTarget));
    }
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_LESS);
    gl.DepthMask(GL_TRUE);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    gl.ShadeModel(GL_SMOOTH);
}

void StateDrawing::end_plain(const kit::Gl& gl) const {
    gl.PopAttrib();
}

void StateDrawing::renew_texels(const kit::Gl& gl) const {
    switch (m_state.number(Axis::kTexels)) {
        case kUpdated:
            m_moving.give(gl);
            return;
        case kCopied:
            copy_texels(gl);
            return;
        default:
            render_texels(gl);
    }
}

void StateDrawing::draw_helper(const kit::Gl& gl) const {
    gl.ClearDepth(1);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    m_helper.draw(gl);
}

void StateDrawing::copy_texels(const kit::Gl& gl) const {
    begin_plain(gl);
    draw_helper(gl);
    end_plain(gl);
    gl.CopyTexSubImage2D(m_kind.target, 0, 0, 0, 0, 0, std::min(m_kind.width, m_width),
                         std::min(m_kind.height, m_height));
}

void StateDrawing::render_texels(const kit::Gl& gl) const {
    const bool is_depth = m_kind.format == GL_DEPTH_COMPONENT;
    gl.BindFramebuffer(GL_FRAMEBUFFER, m_object);
    begin_plain(gl);
    gl.Viewport(0, 0, m_kind.width, m_kind.height);
    if (is_depth) {
        gl.MatrixMode(GL_PROJECTION);
        gl.PushMatrix();
        gl.LoadMatrixf(lamp_projection());
        gl.PolygonOffset(2, 4);
        gl.Enable(GL_POLYGON_OFFSET_FILL);
    }
    draw_helper(gl);
    if (is_depth) {
        gl.PopMatrix();
        gl.MatrixMode(GL_MODELVIEW);
    }
    end_plain(gl);
    gl.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(m_window_object));
}

void StateDrawing::draw_stencil_mask(const kit::Gl& gl) const {
    constexpr float kHalf = 0.55F;
    begin_plain(gl);
    gl.Disable(GL_DEPTH_TEST);
    gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilFunc(GL_ALWAYS, 1, ~0U);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    gl.Begin(GL_TRIANGLES);
    for (const float x : {-0.6F, 0.6F})
        for (const float y : {-0.6F, 0.6F}) {
            gl.Vertex3f(x - kHalf, y, -3);
            gl.Vertex3f(x, y - kHalf, -3);
            gl.Vertex3f(x + kHalf, y, -3);
            gl.Vertex3f(x - kHalf, y, -3);
            gl.Vertex3f(x + kHalf, y, -3);
            gl.Vertex3f(x, y + kHalf, -3);
        }
    gl.End();
    end_plain(gl);
}

// Depths first, for colours where they are equal.
void StateDrawing::draw_depths(const kit::Gl& gl) const {
    gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl.DepthMask(GL_TRUE);
    gl.DepthFunc(GL_LESS);
    m_mesh.draw(gl);
    apply_masks(gl, m_state);
}

// Behind what had depths alone, so that they are seen.
void StateDrawing::draw_backdrop(const kit::Gl& gl) const {
    begin_plain(gl);
    draw_quad(gl, {{{0.9F, 0.6F, 0.2F, 1}, {-4, -4, -3.3F}},
                   {{0.2F, 0.7F, 0.9F, 1}, {4, -4, -3.3F}},
                   {{0.3F, 0.9F, 0.4F, 1}, {4, 4, -3.3F}},
                   {{0.8F, 0.3F, 0.7F, 1}, {-4, 4, -3.3F}}});
    end_plain(gl);
}

// Darkens what the stencil counted, as shadow volumes do.
void StateDrawing::draw_shadow(const kit::Gl& gl) const {
    begin_plain(gl);
    gl.Disable(GL_DEPTH_TEST);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilFunc(GL_NOTEQUAL, 0, ~0U);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    gl.Enable(GL_BLEND);
    gl.BlendEquation(GL_FUNC_ADD);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    const Corner corners[4] = {{{0, 0, 0, 0.5F}, {-4, -4, -3}},
                               {{0, 0, 0, 0.5F}, {4, -4, -3}},
                               {{0, 0, 0, 0.5F}, {4, 4, -3}},
                               {{0, 0, 0, 0.5F}, {-4, 4, -3}}};
    draw_quad(gl, corners);
    end_plain(gl);
}

}  // namespace terrazzo::states
