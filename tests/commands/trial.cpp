// Setting the stage and reading what came of it; see trial.h.
#include "trial.h"

#include <algorithm>
#include <array>
#include <initializer_list>

namespace terrazzo::test {
namespace {

constexpr int kVertices = 16;

void compare(std::string& out, const char* what, const auto& one, const auto& other) {
    if (one == other) return;
    out += std::string("\n  ") + what + " differ";
    const auto at = std::ranges::mismatch(one, other);
    if (at.in1 != one.end() && at.in2 != other.end())
        out += " first at " + std::to_string(at.in1 - one.begin()) + ": " + std::to_string(*at.in1) +
               " and " + std::to_string(*at.in2);
}

}  // namespace

std::string difference(const Outcome& one, const Outcome& other) {
    std::string out;
    for (std::size_t i = 0; i < std::min(one.state.size(), other.state.size()); ++i) {
        if (one.state[i] != other.state[i]) out += "\n  " + one.state[i] + "\n  other: " + other.state[i];
    }
    if (one.state.size() != other.state.size()) out += "\n  the number of state lines differs";
    if (one.errors != other.errors) {
        out += "\n  errors";
        for (GLenum error : one.errors) out += " " + kit::error_name(error);
        out += ", other:";
        for (GLenum error : other.errors) out += " " + kit::error_name(error);
    }
    compare(out, "colours", one.color, other.color);
    compare(out, "depths", one.depth, other.depth);
    compare(out, "stencil values", one.stencil, other.stencil);
    compare(out, "feedback values", one.feedback, other.feedback);
    return out;
}

Trial::Trial(const kit::Library& library, unsigned seed)
    : gl(library.gl),
      arguments(seed),
      m_context(library, {.accum_bits = 16, .width = kSize, .height = kSize}) {
    fill_buffers();
    make_textures();
    make_lists();
    set_arrays();
    set_evaluators();
    set_capabilities();
    gl.RasterPos3f(-0.4f, -0.3f, 0.1f);
    gl.PushAttrib(GL_FOG_BIT | GL_LINE_BIT);
    gl.PushMatrix();
    gl.Translatef(0.125f, -0.0625f, 0);
}

void Trial::fill_buffers() {
    std::vector<GLfloat> depths(kSize * kSize);
    std::vector<GLubyte> bytes(kSize * kSize * 4);
    for (GLfloat& depth : depths) depth = arguments.number(0.2f, 1);
    for (GLubyte& byte : bytes) byte = static_cast<GLubyte>(arguments.pick(256));
    gl.RasterPos2f(-1, -1);
    gl.DrawPixels(kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    gl.DrawPixels(kSize, kSize, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, bytes.data());
    gl.Accum(GL_LOAD, 0.5f);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_ALWAYS);
    gl.ColorMask(0, 0, 0, 0);
    gl.DrawPixels(kSize, kSize, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    gl.ColorMask(1, 1, 1, 1);
    gl.DepthFunc(GL_LEQUAL);
}

void Trial::make_textures() {
    std::vector<GLubyte> texels(8 * 8 * 8 * 4);
    for (GLubyte& texel : texels) texel = static_cast<GLubyte>(arguments.pick(256));
    const auto* data = texels.data();
    for (int level = 0, size = 8; size > 0; ++level, size /= 2) {
        gl.TexImage1D(GL_TEXTURE_1D, level, GL_RGBA8, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, data);
        gl.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA8, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, data);
        gl.TexImage3D(GL_TEXTURE_3D, level, GL_RGBA8, size, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, data);
        for (GLenum face = GL_TEXTURE_CUBE_MAP_POSITIVE_X; face <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z; ++face) {
            gl.TexImage2D(face, level, GL_RGBA8, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                          data + 16 * (face - GL_TEXTURE_CUBE_MAP_POSITIVE_X));
        }
    }
    for (GLenum unit : {GL_TEXTURE1, GL_TEXTURE0}) {
        gl.ActiveTexture(unit);
        gl.Enable(GL_TEXTURE_2D);
        for (GLuint name = 1; name <= 3 && unit == GL_TEXTURE0; ++name) {
            gl.BindTexture(name == 2 ? GL_TEXTURE_1D : GL_TEXTURE_2D, name);
            gl.BindTexture(name == 2 ? GL_TEXTURE_1D : GL_TEXTURE_2D, 0);
        }
    }
}

void Trial::make_lists() {
    gl.NewList(50, GL_COMPILE);
    gl.Translatef(0.125f, 0.25f, 0.5f);
    gl.EndList();
    gl.NewList(51, GL_COMPILE);
    gl.Color4f(0.1f, 0.2f, 0.3f, 0.4f);
    gl.MultiTexCoord4f(GL_TEXTURE2, 1, 2, 3, 4);
    gl.EndList();
    gl.NewList(52, GL_COMPILE);
    gl.LineWidth(5);
    gl.CallList(51);
    gl.EndList();
    gl.NewList(53, GL_COMPILE);
    gl.Begin(GL_TRIANGLES);
    for (GLfloat x : {-0.5f, 0.5f, 0.25f}) {
        gl.Color3f(x, 0.5f, 1 - x);
        gl.Vertex3f(x, x * x, -x);
    }
    gl.End();
    gl.EndList();
    gl.ListBase(50);
}

void Trial::set_arrays() {
    for (auto* values : {&m_positions, &m_normals, &m_colors, &m_coordinates}) {
        values->resize(kVertices * 4);
        for (GLfloat& value : *values) value = arguments.number(-1, 1);
    }
    for (std::size_t i = 3; i < m_positions.size(); i += 4) m_positions[i] = arguments.number(0.75f, 1.5f);
    gl.VertexPointer(4, GL_FLOAT, 0, m_positions.data());
    gl.NormalPointer(GL_FLOAT, 16, m_normals.data());
    gl.ColorPointer(4, GL_FLOAT, 0, m_colors.data());
    gl.SecondaryColorPointer(3, GL_FLOAT, 16, m_normals.data());
    gl.FogCoordPointer(GL_FLOAT, 8, m_colors.data());
    gl.EdgeFlagPointer(5, m_colors.data());
    gl.IndexPointer(GL_FLOAT, 12, m_colors.data());
    gl.EnableClientState(GL_VERTEX_ARRAY);
    const GLenum others[] = {GL_NORMAL_ARRAY,         GL_COLOR_ARRAY,     GL_SECONDARY_COLOR_ARRAY,
                             GL_FOG_COORDINATE_ARRAY, GL_EDGE_FLAG_ARRAY, GL_INDEX_ARRAY};
    for (GLenum array : others) {
        if (arguments.pick(2)) gl.EnableClientState(array);
    }
    for (GLenum unit : {GL_TEXTURE3, GL_TEXTURE1, GL_TEXTURE0}) {
        gl.ClientActiveTexture(unit);
        gl.TexCoordPointer(static_cast<GLint>(1 + arguments.pick(4)), GL_FLOAT, 16, m_coordinates.data());
        if (arguments.pick(2)) gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
    }
}

void Trial::set_evaluators() {
    std::array<GLfloat, 64> points;
    for (GLfloat& point : points) point = arguments.number(-1, 1);
    gl.Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, 4, points.data());
    gl.Map1f(GL_MAP1_COLOR_4, 0, 1, 4, 3, points.data());
    gl.Map1f(GL_MAP1_TEXTURE_COORD_2, 0, 1, 2, 2, points.data());
    gl.Map2f(GL_MAP2_VERTEX_3, 0, 1, 3, 3, 0, 1, 9, 3, points.data());
    gl.Map2f(GL_MAP2_NORMAL, 0, 1, 3, 2, 0, 1, 6, 2, points.data());
    for (GLenum map :
         {GL_MAP1_VERTEX_3, GL_MAP1_COLOR_4, GL_MAP1_TEXTURE_COORD_2, GL_MAP2_VERTEX_3, GL_MAP2_NORMAL})
        gl.Enable(map);
    gl.MapGrid1f(4, 0.1f, 0.9f);
    gl.MapGrid2f(3, 0, 1, 4, 0.2f, 0.8f);
}

void Trial::set_capabilities() {
    const GLfloat position[] = {0.3f, 0.5f, 1, 0}, gray[] = {0.25f, 0.3f, 0.35f, 1};
    gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
    gl.Lightfv(GL_LIGHT0, GL_SPECULAR, gray);
    gl.Lightfv(GL_LIGHT1, GL_AMBIENT, gray);
    gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, gray);
    gl.Enable(GL_LIGHT0);
    gl.PointSize(4.5f);
    gl.LineWidth(2);
    gl.LineStipple(2, 0x3f5a);
    gl.PolygonOffset(1, 2);
    gl.StencilFunc(GL_GREATER, 190, 0xff);
    gl.StencilOp(GL_INVERT, GL_INCR_WRAP, GL_REPLACE);
    gl.AlphaFunc(GL_GREATER, 0.3f);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_DST_COLOR);
    gl.Scissor(2, 3, 26, 27);
    gl.Fogf(GL_FOG_DENSITY, 0.6f);
    const GLenum capabilities[] = {GL_LIGHTING,  GL_FOG,          GL_BLEND,         GL_ALPHA_TEST,
                                   GL_CULL_FACE, GL_STENCIL_TEST, GL_SCISSOR_TEST,  GL_LINE_STIPPLE,
                                   GL_NORMALIZE, GL_COLOR_SUM,    GL_POINT_SMOOTH,  GL_COLOR_MATERIAL,
                                   GL_LIGHT1,    GL_CLIP_PLANE0,  GL_TEXTURE_GEN_S, GL_POLYGON_OFFSET_FILL};
    for (GLenum capability : capabilities) {
        if (arguments.pick(3) == 0) gl.Enable(capability);
    }
}

Outcome Trial::outcome() {
    Outcome out;
    if (!m_feedback.empty()) {
        const GLint values = gl.RenderMode(GL_RENDER);
        m_feedback.resize(static_cast<std::size_t>(std::max(values, 0)));
        out.feedback = m_feedback;
    }
    out.errors = m_context.take_errors();
    out.state = dump_everything(gl);
    // Where client memory lies is each run's own.
    std::erase_if(out.state,
                  [](const std::string& line) { return line.find("_ARRAY_POINTER ") != std::string::npos; });
    gl.Finish();
    const auto colors = m_context.colour_buffer();
    out.color.assign(colors.begin(), colors.end());
    out.depth = m_context.read_depth();
    out.stencil = m_context.read_stencil();
    return out;
}

namespace {
std::vector<GLubyte> repeated(std::initializer_list<GLubyte> bytes, size_t count) {
    std::vector<GLubyte> all;
    while (all.size() < count) all.insert(all.end(), bytes);
    return all;
}
}  // namespace

void Trial::draw() {
    const auto vertex = [&](GLfloat x, GLfloat y) {
        gl.Normal3f(x, y, 0.75f);
        gl.MultiTexCoord4f(GL_TEXTURE1, y * 2, x * 3, 0.5f, 1.25f);
        gl.FogCoordf(x + 1);
        gl.SecondaryColor3f(0.2f, 0.1f, y * y);
        gl.TexCoord4f(x, y, x * y, 1);
        gl.Color4f(0.5f + 0.4f * x, 0.5f, 0.75f - 0.5f * y, 0.6f);
        gl.Vertex4f(x, y, 0.4f * x - 0.3f * y, 1 + 0.2f * x);
    };
    gl.Begin(GL_TRIANGLE_STRIP);
    for (const auto& [x, y] :
         {std::pair{-0.9f, -0.7f}, {0.8f, -0.9f}, {-0.7f, 0.8f}, {1.1f, 0.7f}, {0.1f, 1.2f}})
        vertex(x, y);
    gl.End();
    gl.Begin(GL_TRIANGLES);
    for (const auto& [x, y] : {std::pair{0.9f, -0.5f}, {-0.8f, -0.2f}, {0.3f, 0.6f}}) vertex(x, y);
    gl.End();
    gl.Begin(GL_LINE_STRIP);
    for (const auto& [x, y] : {std::pair{-0.8f, 0.3f}, {0.7f, 0.2f}, {0.1f, -0.9f}}) vertex(x, y);
    gl.End();
    gl.Begin(GL_POINTS);
    for (const auto& [x, y] : {std::pair{-0.5f, -0.5f}, {0.5f, 0.4f}}) vertex(x, y);
    gl.End();
    // As often as the largest rows, skips and alignments that a change sets reach.
    static const std::vector<GLubyte> bits = repeated({0x5a, 0xf0, 0x33, 0x81, 0x7e, 0x18, 0xff, 0x42}, 8192);
    static const std::vector<GLubyte> pixels =
        repeated({250, 130, 20, 200, 10, 90, 180, 160, 60, 240, 120, 70, 30, 50, 220, 110}, 8192);
    gl.PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.Bitmap(8, 8, 1, 2, 9, 3, bits.data());
    gl.DrawPixels(2, 2, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    gl.PopClientAttrib();
}

void Trial::draw_triangles() {
    gl.Begin(GL_TRIANGLES);
    for (const auto& [x, y] : {std::pair{-0.9f, 0.1f}, {0.2f, -0.8f}, {0.7f, 0.9f}}) {
        gl.Normal3f(x, y, 0.75f);
        gl.TexCoord2f(x, y);
        gl.Color4f(0.5f + 0.4f * y, 0.5f, 0.75f - 0.5f * x, 0.6f);
        gl.Vertex3f(x, y, 0.2f * x);
    }
    gl.End();
}

void Trial::draw_nothing() {
    for (GLenum mode : {GL_TRIANGLES, GL_LINES, GL_POINTS}) {
        gl.Begin(mode);
        for (GLfloat x : {8.0f, 9.0f, 8.5f, 8.25f, 9.5f, 9.75f}) gl.Vertex3f(x, x * 1.5f - 3 * (x - 8), 0);
        gl.End();
    }
}

void Trial::start_feedback() {
    m_feedback.assign(4096, 0);
    gl.FeedbackBuffer(static_cast<GLsizei>(m_feedback.size()), GL_4D_COLOR_TEXTURE, m_feedback.data());
    gl.RenderMode(GL_FEEDBACK);
}

}  // namespace terrazzo::test
