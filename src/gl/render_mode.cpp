// Name stack, hit records and feedback tokens.
#include "gl/render_mode.h"

#include <algorithm>
#include <exception>

#include "gl/context.h"
#include "gl/draw.h"
#include "gl/generated/commands.h"
#include "gl/translate.h"
#include "gl/validate.h"

namespace terrazzo::gl {
namespace {

void write(FeedbackState& feedback, GLfloat value) {
    if (feedback.written < static_cast<std::size_t>(feedback.size)) feedback.buffer[feedback.written] = value;
    ++feedback.written;
}

void write(SelectionState& selection, GLuint value) {
    if (selection.written < static_cast<std::size_t>(selection.size))
        selection.buffer[selection.written] = value;
    ++selection.written;
}

void write_token(FeedbackState& feedback, GLenum token) {
    write(feedback, static_cast<GLfloat>(token));
}

// GL 1.5 table 5.1.
void write_vertex(FeedbackState& feedback, const GLfloat window[4], const GLfloat color[4],
                  const GLfloat texture_coordinates[4]) {
    const bool has_texture = feedback.type == GL_3D_COLOR_TEXTURE || feedback.type == GL_4D_COLOR_TEXTURE;
    const int coordinates = feedback.type == GL_2D ? 2 : feedback.type == GL_4D_COLOR_TEXTURE ? 4 : 3;
    for (int i = 0; i < coordinates; ++i) write(feedback, window[i]);
    if (has_texture || feedback.type == GL_3D_COLOR)
        for (int i = 0; i < 4; ++i) write(feedback, color[i]);
    if (has_texture)
        for (int i = 0; i < 4; ++i) write(feedback, texture_coordinates[i]);
}

// Depth as a fraction of the range of unsigned integers.
GLuint scaled_depth(GLfloat z) {
    const GLfloat scaled = 4294967296.0f * z;
    return scaled >= 4294967296.0f ? 0xffffffffu : scaled > 0 ? static_cast<GLuint>(scaled) : 0;
}

void write_hit_record(SelectionState& selection) {
    if (!selection.hit) return;
    write(selection, static_cast<GLuint>(selection.depth));
    write(selection, scaled_depth(selection.lowest_z));
    write(selection, scaled_depth(selection.highest_z));
    for (int i = 0; i < selection.depth; ++i) write(selection, selection.names[static_cast<std::size_t>(i)]);
    selection.hit = false;
    selection.lowest_z = 1;
    selection.highest_z = 0;
    ++selection.hits;
}

// What is drawn so far belongs to the names as they are.
void finish_hits(Context& ctx) {
    flush_vertices(ctx);
    write_hit_record(ctx.render_mode.selection);
}

class HitObserver final : public pipeline::PrimitiveObserver {
  public:
    explicit HitObserver(Context& ctx) : m_ctx(ctx) {}

    void point(const pipeline::ShadedVertices& vertices, int v) override { hit(vertices, v); }
    void line(const pipeline::ShadedVertices& vertices, int a, int b, bool) override {
        hit(vertices, a);
        hit(vertices, b);
    }
    void triangle(const pipeline::ShadedVertices& vertices, int a, int b, int c) override {
        for (const int v : {a, b, c}) hit(vertices, v);
    }

  private:
    void hit(const pipeline::ShadedVertices& vertices, int v) {
        note_hit(m_ctx, vertices.column(pipeline::kWindowZ)[v]);
    }

    Context& m_ctx;
};

// Feedback vertices carry these, whatever is enabled.
constexpr int kColorVarying = 0, kTextureVarying = 4;

raster::Varyings feedback_varyings() {
    raster::Varyings varyings;
    varyings.color = kColorVarying;
    varyings.texture[0] = kTextureVarying;
    varyings.projective = varyings.uses_r = 1;
    varyings.count = 8;
    return varyings;
}

class FeedbackObserver final : public pipeline::PrimitiveObserver {
  public:
    FeedbackObserver(FeedbackState& feedback, const Surface& surface, bool flat)
        : m_feedback(feedback), m_surface(surface), m_flat(flat) {}

    void point(const pipeline::ShadedVertices& vertices, int v) override {
        write_token(m_feedback, GL_POINT_TOKEN);
        vertex(vertices, v, v);
    }
    void line(const pipeline::ShadedVertices& vertices, int a, int b, bool restarts) override {
        write_token(m_feedback, restarts ? GL_LINE_RESET_TOKEN : GL_LINE_TOKEN);
        for (const int v : {a, b}) vertex(vertices, v, b);
    }
    void triangle(const pipeline::ShadedVertices& vertices, int a, int b, int c) override {
        write_token(m_feedback, GL_POLYGON_TOKEN);
        write(m_feedback, 3);
        for (const int v : {a, b, c}) vertex(vertices, v, c);
    }

  private:
    void vertex(const pipeline::ShadedVertices& vertices, int v, int provoking) {
        const auto read = [&](int column, int slot) { return vertices.column(column)[slot]; };
        const GLfloat y = read(pipeline::kWindowY, v);
        const bool top_first = m_surface.format.rows == raster::RowOrder::kTopFirst;
        const GLfloat window[4] = {read(pipeline::kWindowX, v),
                                   top_first ? static_cast<GLfloat>(m_surface.height) - y : y,
                                   read(pipeline::kWindowZ, v), 1.0f / read(pipeline::kWindowOow, v)};
        GLfloat color[4], coordinates[4];
        for (int i = 0; i < 4; ++i) {
            color[i] = read(pipeline::kFirstVarying + kColorVarying + i, m_flat ? provoking : v);
            coordinates[i] = read(pipeline::kFirstVarying + kTextureVarying + i, v);
        }
        write_vertex(m_feedback, window, color, coordinates);
    }

    FeedbackState& m_feedback;
    const Surface& m_surface;
    bool m_flat;
};

}  // namespace

void note_hit(Context& ctx, GLfloat z) {
    SelectionState& selection = ctx.render_mode.selection;
    selection.hit = true;
    selection.lowest_z = std::min(selection.lowest_z, z);
    selection.highest_z = std::max(selection.highest_z, z);
}

void capture_primitives(Context& ctx, GLenum mode, const pipeline::VertexInput& input,
                        const pipeline::VertexRange& range) {
    validate(ctx, input);
    pipeline::DrawState state = ctx.drawing.state;
    // Nothing of how lines and points become pixels matters.
    pipeline::RasterState& raster = state.raster;
    raster.offset_fill = raster.offset_line = raster.offset_point = false;
    raster.point_smooth = raster.line_smooth = raster.line_stipple = raster.polygon_stipple = false;
    for (pipeline::TextureCoordinates& coordinates : state.vertex.texture) coordinates.used = false;
    state.vertex.varyings = raster::Varyings{};
    // Where memory is short nothing of the draw has been seen.
    struct Unseen {
        RenderModeState& state;
        const SelectionState selection;
        const std::size_t written;
        const int exceptions = std::uncaught_exceptions();
        ~Unseen() {
            if (std::uncaught_exceptions() == exceptions) return;
            state.selection = selection;
            state.feedback.written = written;
        }
    } const unseen{ctx.render_mode, ctx.render_mode.selection, ctx.render_mode.feedback.written};
    if (ctx.render_mode.mode == GL_SELECT) {
        HitObserver observer(ctx);
        return ctx.renderer.observe(state, input, translate_mode(mode), range, observer);
    }
    state.vertex.varyings = feedback_varyings();
    make_texture_coordinates(ctx, 0, state.vertex.texture[0]);
    make_lighting(ctx, input, state.vertex);
    FeedbackObserver observer(ctx.render_mode.feedback, ctx.surface, raster.flat);
    ctx.renderer.observe(state, input, translate_mode(mode), range, observer);
}

void capture_raster(Context& ctx, GLenum token) {
    flush_vertices(ctx);
    if (ctx.render_mode.mode != GL_FEEDBACK) return;
    const RasterPosition& position = ctx.raster_position;
    write_token(ctx.render_mode.feedback, token);
    write_vertex(ctx.render_mode.feedback, position.window.data(), position.color.data(),
                 position.texture_coordinates[0].data());
}

GLint render_mode(Context& ctx, GLenum mode) {
    RenderModeState& state = ctx.render_mode;
    if (mode != GL_RENDER && mode != GL_SELECT && mode != GL_FEEDBACK) {
        record_error(ctx, GL_INVALID_ENUM, "no such render mode");
        return 0;
    }
    if ((mode == GL_SELECT && state.selection.size == 0) ||
        (mode == GL_FEEDBACK && state.feedback.size == 0)) {
        record_error(ctx, GL_INVALID_OPERATION, "the mode has no buffer");
        return 0;
    }
    finish_hits(ctx);
    GLint result = 0;
    if (state.mode == GL_SELECT) {
        SelectionState& selection = state.selection;
        result = selection.written > static_cast<std::size_t>(selection.size) ? -1 : selection.hits;
        selection.written = 0;
        selection.hits = 0;
        selection.depth = 0;
    } else if (state.mode == GL_FEEDBACK) {
        FeedbackState& feedback = state.feedback;
        const auto size = static_cast<std::size_t>(feedback.size);
        result = feedback.written > size ? -1 : static_cast<GLint>(feedback.written);
        feedback.written = 0;
    }
    state.mode = mode;
    return result;
}

void select_buffer(Context& ctx, GLsizei size, GLuint* buffer) {
    RenderModeState& state = ctx.render_mode;
    if (size < 0) return record_error(ctx, GL_INVALID_VALUE, "size is negative");
    if (state.mode == GL_SELECT) return record_error(ctx, GL_INVALID_OPERATION, "selection is going on");
    state.selection.buffer = buffer;
    state.selection.size = size;
    state.selection.written = 0;
}

void feedback_buffer(Context& ctx, GLsizei size, GLenum type, GLfloat* buffer) {
    RenderModeState& state = ctx.render_mode;
    if (state.mode == GL_FEEDBACK) return record_error(ctx, GL_INVALID_OPERATION, "feedback is going on");
    if (size < 0) return record_error(ctx, GL_INVALID_VALUE, "size is negative");
    if (type < GL_2D || type > GL_4D_COLOR_TEXTURE) return record_error(ctx, GL_INVALID_ENUM, "no such type");
    state.feedback.buffer = buffer;
    state.feedback.size = size;
    state.feedback.type = type;
    state.feedback.written = 0;
}

void pass_through(Context& ctx, GLfloat token) {
    if (ctx.render_mode.mode != GL_FEEDBACK) return;
    flush_vertices(ctx);
    write_token(ctx.render_mode.feedback, GL_PASS_THROUGH_TOKEN);
    write(ctx.render_mode.feedback, token);
}

void init_names(Context& ctx) {
    if (ctx.render_mode.mode != GL_SELECT) return;
    finish_hits(ctx);
    ctx.render_mode.selection.depth = 0;
}

void load_name(Context& ctx, GLuint name) {
    SelectionState& selection = ctx.render_mode.selection;
    if (ctx.render_mode.mode != GL_SELECT) return;
    if (selection.depth == 0) return record_error(ctx, GL_INVALID_OPERATION, "the name stack is empty");
    finish_hits(ctx);
    selection.names[static_cast<std::size_t>(selection.depth - 1)] = name;
}

void push_name(Context& ctx, GLuint name) {
    SelectionState& selection = ctx.render_mode.selection;
    if (ctx.render_mode.mode != GL_SELECT) return;
    if (selection.depth == kMaxNameStackDepth)
        return record_error(ctx, GL_STACK_OVERFLOW, "the name stack is full");
    finish_hits(ctx);
    selection.names[static_cast<std::size_t>(selection.depth++)] = name;
}

void pop_name(Context& ctx) {
    SelectionState& selection = ctx.render_mode.selection;
    if (ctx.render_mode.mode != GL_SELECT) return;
    if (selection.depth == 0) return record_error(ctx, GL_STACK_UNDERFLOW, "the name stack is empty");
    finish_hits(ctx);
    --selection.depth;
}

}  // namespace terrazzo::gl
