// The commands behind a seed; see random_draws.h.
//
// Numbers that belong together are drawn into a variable first: in which order a call's arguments are
// evaluated is the compiler's choice, and a seed must mean the same on every processor.
#include "random_draws.h"

#include <vector>

#include "random.h"

namespace terrazzo::stress {
namespace {

constexpr GLenum kCompares[] = {GL_NEVER,   GL_LESS,     GL_EQUAL,  GL_LEQUAL,
                                GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};

class Player {
  public:
    Player(const kit::Gl& gl, std::uint64_t seed, int width, int height)
        : gl(gl), m_random(seed), m_width(width), m_height(height) {}

    void play() {
        gl.Viewport(0, 0, m_width, m_height);
        clear();
        make_textures();
        const int rounds = 3 + m_random.below(6);
        for (int i = 0; i < rounds; ++i) {
            change_state();
            for (int draws = 1 + m_random.below(4); draws > 0; --draws) draw();
            if (m_random.once_in(3)) draw_pixels();
            if (m_random.once_in(6)) clear();
            if (m_random.once_in(6)) change_texture();
        }
        gl.DeleteTextures(kTextures, m_textures);
        gl.Finish();
    }

  private:
    static constexpr int kTextures = 3;

    struct Color {
        float values[4];
    };
    Color color() {
        return {
            {m_random.between(0, 1), m_random.between(0, 1), m_random.between(0, 1), m_random.between(0, 1)}};
    }
    void enable(GLenum what, bool on) { on ? gl.Enable(what) : gl.Disable(what); }

    void clear() {
        const Color c = color();
        gl.ClearColor(c.values[0], c.values[1], c.values[2], c.values[3]);
        gl.ClearDepth(m_random.coin() ? 1.0 : static_cast<double>(m_random.between(0, 1)));
        gl.ClearStencil(m_random.below(256));
        gl.Clear(m_random.once_in(4) ? GL_COLOR_BUFFER_BIT
                                     : GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }

    std::vector<std::uint8_t> texels(int count) {
        std::vector<std::uint8_t> bytes(static_cast<std::size_t>(count));
        for (std::uint8_t& b : bytes) b = m_random.byte();
        return bytes;
    }
    void image(GLenum target, int level, int width, int height) {
        constexpr GLint kInternal[] = {
            GL_RGBA8,      GL_RGB8,    GL_ALPHA8, GL_LUMINANCE8, GL_LUMINANCE8_ALPHA8,
            GL_INTENSITY8, GL_RGB5_A1, GL_RGBA16};
        if (level == 0) m_internal = m_random.one_of(kInternal);
        const auto data = texels(width * height * 4);
        if (target == GL_TEXTURE_1D)
            gl.TexImage1D(target, level, m_internal, width, 0, GL_RGBA, GL_UNSIGNED_BYTE, data.data());
        else
            gl.TexImage2D(target, level, m_internal, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                          data.data());
    }
    void make_textures() {
        gl.GenTextures(kTextures, m_textures);
        for (int i = 0; i < kTextures; ++i) {
            const GLenum target = target_of(i);
            gl.BindTexture(target, m_textures[i]);
            int width = 1 << m_random.below(7), height = target == GL_TEXTURE_1D ? 1 : 1 << m_random.below(7);
            for (int level = 0;; ++level) {
                image(target, level, width, height);
                if (width == 1 && height == 1) break;
                width = width > 1 ? width / 2 : 1;
                height = height > 1 ? height / 2 : 1;
            }
        }
    }
    static GLenum target_of(int texture) { return texture == 0 ? GL_TEXTURE_1D : GL_TEXTURE_2D; }
    // A new picture in a texture that queued draws sample.
    void change_texture() {
        const int i = m_random.below(kTextures);
        gl.BindTexture(target_of(i), m_textures[i]);
        const auto data = texels(4);
        if (target_of(i) == GL_TEXTURE_1D)
            gl.TexSubImage1D(GL_TEXTURE_1D, 0, 0, 1, GL_RGBA, GL_UNSIGNED_BYTE, data.data());
        else
            gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, data.data());
    }

    void change_state() {
        matrices();
        lighting();
        texturing();
        rasterization();
        fragments();
        fog();
        if (bits(GL_SAMPLES) > 0) samples();
    }

    void samples() {
        enable(GL_MULTISAMPLE, !m_random.once_in(4));
        enable(GL_SAMPLE_ALPHA_TO_COVERAGE, m_random.once_in(4));
        enable(GL_SAMPLE_ALPHA_TO_ONE, m_random.once_in(4));
        enable(GL_SAMPLE_COVERAGE, m_random.once_in(4));
        const float value = m_random.between(0, 1);
        gl.SampleCoverage(value, m_random.coin());
    }

    void matrices() {
        gl.MatrixMode(GL_PROJECTION);
        gl.LoadIdentity();
        if (m_random.coin())
            gl.Frustum(-1, 1, -1, 1, 1.5, 12);
        else
            gl.Ortho(-2.5, 2.5, -2.5, 2.5, -8, 8);
        gl.MatrixMode(GL_MODELVIEW);
        gl.LoadIdentity();
        gl.Translatef(0, 0, m_random.between(-5, -2));
        const float turn[3] = {m_random.between(-180, 180), m_random.between(-1, 1), m_random.between(-1, 1)};
        gl.Rotatef(turn[0], turn[1], turn[2], 1);
        if (m_random.once_in(3)) {
            const float scale[2] = {m_random.between(0.3f, 2), m_random.between(0.3f, 2)};
            gl.Scalef(scale[0], scale[1], 1);
        }
        for (int plane = 0; plane < 3; ++plane) {
            const GLdouble equation[4] = {m_random.between(-1, 1), m_random.between(-1, 1),
                                          m_random.between(-1, 1), m_random.between(0, 1)};
            gl.ClipPlane(GL_CLIP_PLANE0 + static_cast<GLenum>(plane), equation);
            enable(GL_CLIP_PLANE0 + static_cast<GLenum>(plane), m_random.once_in(8));
        }
        const float range[2] = {m_random.between(0, 0.3f), m_random.between(0.7f, 1)};
        gl.DepthRange(range[0], range[1]);
    }

    void lighting() {
        enable(GL_LIGHTING, m_random.coin());
        gl.ShadeModel(m_random.once_in(4) ? GL_FLAT : GL_SMOOTH);
        enable(GL_NORMALIZE, m_random.coin());
        enable(GL_COLOR_MATERIAL, m_random.once_in(3));
        gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, m_random.once_in(3));
        gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, m_random.once_in(3));
        gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, m_random.between(0, 128));
        const GLenum face = m_random.coin() ? GL_FRONT : GL_FRONT_AND_BACK;
        gl.Materialfv(face, GL_DIFFUSE, color().values);
        gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, color().values);
        for (GLenum light = GL_LIGHT0; light < GL_LIGHT3; ++light) {
            enable(light, m_random.coin());
            const GLfloat position[4] = {m_random.between(-4, 4), m_random.between(-4, 4),
                                         m_random.between(0, 6), m_random.coin() ? 1.0f : 0.0f};
            gl.Lightfv(light, GL_POSITION, position);
            gl.Lightfv(light, GL_DIFFUSE, color().values);
            gl.Lightfv(light, GL_SPECULAR, color().values);
            gl.Lightf(light, GL_LINEAR_ATTENUATION, m_random.between(0, 0.3f));
            gl.Lightf(light, GL_SPOT_CUTOFF, m_random.once_in(3) ? m_random.between(5, 90) : 180.0f);
            gl.Lightf(light, GL_SPOT_EXPONENT, m_random.between(0, 40));
        }
    }

    void texturing() {
        constexpr GLint kWraps[] = {GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE};
        constexpr GLint kMinFilters[] = {GL_NEAREST,
                                         GL_LINEAR,
                                         GL_NEAREST_MIPMAP_NEAREST,
                                         GL_LINEAR_MIPMAP_NEAREST,
                                         GL_NEAREST_MIPMAP_LINEAR,
                                         GL_LINEAR_MIPMAP_LINEAR};
        constexpr GLint kModes[] = {GL_MODULATE, GL_REPLACE, GL_DECAL, GL_BLEND, GL_ADD};
        constexpr GLint kGenerators[] = {GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP};
        const int texture = m_random.below(kTextures);
        const GLenum target = target_of(texture);
        gl.Disable(GL_TEXTURE_1D);
        gl.Disable(GL_TEXTURE_2D);
        gl.BindTexture(target, m_textures[texture]);
        enable(target, m_random.coin());
        gl.TexParameteri(target, GL_TEXTURE_WRAP_S, m_random.one_of(kWraps));
        gl.TexParameteri(target, GL_TEXTURE_WRAP_T, m_random.one_of(kWraps));
        gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, m_random.one_of(kMinFilters));
        gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, m_random.coin() ? GL_NEAREST : GL_LINEAR);
        gl.TexParameterf(target, GL_TEXTURE_MAX_ANISOTROPY_EXT, m_random.once_in(4) ? 4.0f : 1.0f);
        gl.TexParameterfv(target, GL_TEXTURE_BORDER_COLOR, color().values);
        gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, m_random.one_of(kModes));
        gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color().values);
        const GLint generator = m_random.one_of(kGenerators);
        for (const GLenum coordinate : {GL_S, GL_T}) {
            gl.TexGeni(coordinate, GL_TEXTURE_GEN_MODE, generator);
            enable(coordinate == GL_S ? GL_TEXTURE_GEN_S : GL_TEXTURE_GEN_T, m_random.once_in(4));
        }
        gl.MatrixMode(GL_TEXTURE);
        gl.LoadIdentity();
        if (m_random.once_in(3)) gl.Rotatef(m_random.between(0, 90), 0, 0, 1);
        gl.MatrixMode(GL_MODELVIEW);
    }

    void rasterization() {
        constexpr GLenum kModes[] = {GL_FILL, GL_FILL, GL_FILL, GL_FILL, GL_LINE, GL_POINT};
        gl.PolygonMode(GL_FRONT, m_random.one_of(kModes));
        gl.PolygonMode(GL_BACK, m_random.one_of(kModes));
        enable(GL_CULL_FACE, m_random.once_in(4));
        gl.FrontFace(m_random.coin() ? GL_CW : GL_CCW);
        gl.LineWidth(m_random.between(0.5f, 6));
        gl.PointSize(m_random.between(0.5f, 9));
        enable(GL_POINT_SMOOTH, m_random.once_in(4));
        enable(GL_LINE_SMOOTH, m_random.once_in(4));
        enable(GL_LINE_STIPPLE, m_random.once_in(4));
        const int stipple[2] = {1 + m_random.below(5), m_random.below(65536)};
        gl.LineStipple(stipple[0], static_cast<GLushort>(stipple[1]));
        enable(GL_POLYGON_OFFSET_FILL, m_random.once_in(4));
        const float offset[2] = {m_random.between(-2, 2), m_random.between(-4, 4)};
        gl.PolygonOffset(offset[0], offset[1]);
        enable(GL_POLYGON_STIPPLE, m_random.once_in(6));
        const auto pattern = texels(128);
        gl.PolygonStipple(pattern.data());
    }

    void fragments() {
        constexpr GLenum kFactors[] = {
            GL_ZERO,      GL_ONE,       GL_SRC_ALPHA,           GL_ONE_MINUS_SRC_ALPHA,
            GL_DST_COLOR, GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA, GL_SRC_ALPHA_SATURATE};
        constexpr GLenum kDestinations[] = {
            GL_ZERO,     GL_ONE, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR,
            GL_DST_ALPHA};
        constexpr GLenum kStencilOps[] = {GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT};
        enable(GL_SCISSOR_TEST, m_random.once_in(5));
        const int box[4] = {m_random.below(m_width / 2 + 1), m_random.below(m_height / 2 + 1),
                            m_random.below(m_width), m_random.below(m_height)};
        gl.Scissor(box[0], box[1], box[2], box[3]);
        enable(GL_ALPHA_TEST, m_random.once_in(5));
        const GLenum alpha_test = m_random.one_of(kCompares);
        gl.AlphaFunc(alpha_test, m_random.between(0, 1));
        enable(GL_STENCIL_TEST, m_random.once_in(4));
        const GLenum stencil_test = m_random.one_of(kCompares);
        const int stencil[2] = {m_random.below(256), m_random.below(256)};
        gl.StencilFunc(stencil_test, stencil[0], static_cast<GLuint>(stencil[1]));
        const GLenum fail = m_random.one_of(kStencilOps), depth_fail = m_random.one_of(kStencilOps);
        gl.StencilOp(fail, depth_fail, m_random.one_of(kStencilOps));
        gl.StencilMask(m_random.coin() ? 0xffu : static_cast<GLuint>(m_random.below(256)));
        enable(GL_DEPTH_TEST, !m_random.once_in(3));
        gl.DepthFunc(m_random.coin() ? GL_LESS : m_random.one_of(kCompares));
        gl.DepthMask(!m_random.once_in(5));
        enable(GL_BLEND, m_random.once_in(3));
        const GLenum source = m_random.one_of(kFactors);
        gl.BlendFunc(source, m_random.one_of(kDestinations));
        enable(GL_COLOR_LOGIC_OP, m_random.once_in(10));
        gl.LogicOp(GL_CLEAR + static_cast<GLenum>(m_random.below(16)));
        const auto writes = [&] { return static_cast<GLboolean>(!m_random.once_in(8)); };
        const GLboolean red = writes(), green = writes(), blue = writes();
        gl.ColorMask(red, green, blue, writes());
    }

    void fog() {
        constexpr GLint kModes[] = {GL_LINEAR, GL_EXP, GL_EXP2};
        enable(GL_FOG, m_random.once_in(4));
        gl.Fogi(GL_FOG_MODE, m_random.one_of(kModes));
        gl.Fogf(GL_FOG_DENSITY, m_random.between(0, 0.5f));
        gl.Fogf(GL_FOG_START, m_random.between(0, 3));
        gl.Fogf(GL_FOG_END, m_random.between(4, 9));
        gl.Fogfv(GL_FOG_COLOR, color().values);
    }

    // Mostly inside the view, now and then far outside, once in a while no number at all.
    float coordinate() {
        if (!m_random.once_in(40)) return m_random.between(-3, 3);
        constexpr float kOdd[] = {0.0f,
                                  1e30f,
                                  -1e30f,
                                  1e5f,
                                  -300.0f,
                                  std::numeric_limits<float>::infinity(),
                                  std::numeric_limits<float>::quiet_NaN()};
        return m_random.one_of(kOdd);
    }

    struct Vertex {
        float texture[2], color[4], normal[3], position[4];
    };
    Vertex vertex() {
        Vertex v{};
        for (float& c : v.texture) c = m_random.between(-2, 3);
        for (float& c : v.color) c = m_random.between(0, 1);
        for (float& c : v.normal) c = m_random.between(-1, 1);
        for (int i = 0; i < 3; ++i) v.position[i] = coordinate();
        v.position[3] = m_random.once_in(20) ? m_random.between(-0.5f, 2) : 1.0f;
        return v;
    }

    void draw() {
        const GLenum mode = GL_POINTS + static_cast<GLenum>(m_random.below(GL_POLYGON + 1));
        const int count = 1 + m_random.below(m_random.once_in(8) ? 400 : 40);
        switch (m_random.below(4)) {
            case 0:
                return draw_arrays(mode, count);
            case 1:
                return draw_elements(mode, count);
            case 2: {
                const GLuint list = gl.GenLists(1);
                gl.NewList(list, GL_COMPILE);
                draw_immediate(mode, count);
                gl.EndList();
                gl.CallList(list);
                return gl.DeleteLists(list, 1);
            }
            default:
                return draw_immediate(mode, count);
        }
    }
    void draw_immediate(GLenum mode, int count) {
        const bool colors = m_random.coin();
        gl.Begin(mode);
        for (int i = 0; i < count; ++i) {
            const Vertex v = vertex();
            gl.TexCoord2fv(v.texture);
            if (colors || i == 0) gl.Color4fv(v.color);
            gl.Normal3fv(v.normal);
            gl.Vertex4fv(v.position);
        }
        gl.End();
    }
    GLint bits(GLenum buffer) {
        GLint count = 0;
        gl.GetIntegerv(buffer, &count);
        return count;
    }
    // Bitmaps, images and copies, at a random place that may be outside the window.
    void draw_pixels() {
        const Color c = color();
        gl.Color4fv(c.values);
        gl.WindowPos3f(m_random.between(-40, static_cast<float>(m_width)),
                       m_random.between(-40, static_cast<float>(m_height)), m_random.between(0, 1));
        const int width = 1 + m_random.below(70), height = 1 + m_random.below(70);
        std::vector<std::uint8_t> bytes(static_cast<std::size_t>(width * height * 4));
        for (std::uint8_t& byte : bytes) byte = m_random.byte();
        const float zoom = m_random.coin() ? 1.0f : m_random.between(-3, 3);
        gl.PixelZoom(zoom, m_random.coin() ? zoom : 1.0f);
        gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
        switch (m_random.below(6)) {
            case 0:
                gl.DrawPixels(width, height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
                break;
            case 1:
                gl.DrawPixels(width, height, GL_LUMINANCE_ALPHA, GL_UNSIGNED_SHORT, bytes.data());
                break;
            case 2:
                if (bits(GL_DEPTH_BITS) == 0) break;
                gl.DrawPixels(width, height, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, bytes.data());
                break;
            case 3:
                if (bits(GL_STENCIL_BITS) == 0) break;
                gl.DrawPixels(width, height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, bytes.data());
                break;
            case 4:
                if (bits(GL_SAMPLES) > 0) break;  // they are not read one a pixel
                gl.CopyPixels(m_random.below(m_width), m_random.below(m_height), width, height,
                              m_random.coin() || bits(GL_DEPTH_BITS) == 0 ? GL_COLOR : GL_DEPTH);
                break;
            default:
                for (int i = 0; i < 5; ++i)
                    gl.Bitmap(width, height, 0, 0, static_cast<float>(width) + 0.5f, 1, bytes.data());
        }
    }
    std::vector<Vertex> point_at_vertices(int count) {
        std::vector<Vertex> vertices;
        for (int i = 0; i < count; ++i) vertices.push_back(vertex());
        gl.InterleavedArrays(GL_T2F_C4F_N3F_V3F, sizeof(Vertex), vertices.data());
        if (m_random.coin()) gl.VertexPointer(4, GL_FLOAT, sizeof(Vertex), vertices.front().position);
        return vertices;
    }
    void let_go_of_arrays() {
        for (const GLenum array : {GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY})
            gl.DisableClientState(array);
    }
    void draw_arrays(GLenum mode, int count) {
        const auto vertices = point_at_vertices(count);
        gl.DrawArrays(mode, 0, count);
        let_go_of_arrays();
    }
    void draw_elements(GLenum mode, int count) {
        const int vertex_count = 1 + m_random.below(60);
        const auto vertices = point_at_vertices(vertex_count);
        std::vector<GLushort> indices;
        for (int i = 0; i < count; ++i)
            indices.push_back(static_cast<GLushort>(m_random.below(vertex_count)));
        gl.DrawElements(mode, count, GL_UNSIGNED_SHORT, indices.data());
        let_go_of_arrays();
    }

    const kit::Gl& gl;
    Random m_random;
    int m_width, m_height;
    GLuint m_textures[kTextures] = {};
    GLint m_internal = GL_RGBA8;
};

}  // namespace

void draw_random(const kit::Gl& gl, std::uint64_t seed, int width, int height) {
    Player(gl, seed, width, height).play();
}

}  // namespace terrazzo::stress
