// Chapter: multisampling (GL 1.5 §3.2.1, §4.1.3; EXT_framebuffer_multisample), in renderbuffers of four
// samples.
#include <cmath>

#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

GLuint renderbuffer(const Gl& gl, int samples, GLenum format, int width, int height) {
    GLuint name;
    gl.GenRenderbuffers(1, &name);
    gl.BindRenderbuffer(GL_RENDERBUFFER, name);
    gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    return name;
}

// A cleared frame buffer object of some samples, bound in the window's place.
class Object {
  public:
    explicit Object(const Gl& gl, int samples = 4, GLenum color = GL_RGBA8,
                    GLenum depth = GL_DEPTH24_STENCIL8, int width = kSize, int height = kSize)
        : m_gl(gl), m_width(width), m_height(height) {
        gl.GenFramebuffers(1, &m_name);
        gl.BindFramebuffer(GL_FRAMEBUFFER, m_name);
        attach(GL_COLOR_ATTACHMENT0, renderbuffer(gl, samples, color, width, height));
        attach(depth == GL_DEPTH24_STENCIL8 ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
               renderbuffer(gl, samples, depth, width, height));
        gl.Viewport(0, 0, width, height);
        gl.ClearColor(kBackground[0], kBackground[1], kBackground[2], kBackground[3]);
        gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }
    void attach(GLenum point, GLuint buffer) const {
        m_gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, buffer);
    }
    GLuint name() const { return m_name; }
    // Its lower left corner comes to (x, y) in the window.
    void show(int x = 0, int y = 0, GLbitfield buffers = GL_COLOR_BUFFER_BIT) const {
        m_gl.BindFramebuffer(GL_READ_FRAMEBUFFER, m_name);
        m_gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
        m_gl.BlitFramebuffer(0, 0, m_width, m_height, x, y, x + m_width, y + m_height, buffers, GL_NEAREST);
        m_gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
        m_gl.Viewport(0, 0, kSize, kSize);
    }

  private:
    const Gl& m_gl;
    int m_width, m_height;
    GLuint m_name = 0;
};

constexpr GLbitfield kAllBuffers = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;

// Slivers and large triangles all round a centre, one behind the other.
void star(const Gl& gl, float x, float y, float radius, int rays, float z = 0) {
    Random random(7);
    // One number after the other: the order of arguments is the compiler's, and the reference drops more of
    // some lines than of others.
    const auto corner = [&](float spread, float depth) {
        const float dz = depth == 0 ? 0 : random(-depth, depth);
        const float dy = random(-spread, spread), dx = random(-spread, spread);
        gl.Vertex3f(x + dx, y + dy, z + dz);
    };
    gl.Begin(GL_TRIANGLES);
    for (int i = 0; i < rays; ++i) {
        const float turn = static_cast<float>(i) / static_cast<float>(rays);
        gl.Color4fv(hue(turn).data());
        corner(3, 0);
        corner(radius, 0.4F);
        gl.Color4fv(hue(turn + 0.3F).data());
        corner(radius, 0.4F);
    }
    gl.End();
}

}  // namespace

SCENE(multisample_triangles, "triangles through one another in four samples, with depth and stencil") {
    const Object object(gl);
    pixel_projection(gl);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    star(gl, 120.3F, 130.6F, 120, 40);
    gl.Disable(GL_DEPTH_TEST);
    gl.StencilFunc(GL_EQUAL, 2, 3);
    gl.Color3f(1, 1, 1);
    rectangle(gl, 100.4F, 20.3F, 200.7F, 200.2F);
    object.show(0, 0, kAllBuffers);
}

SCENE(multisample_lit_torus, "a lit solid, its silhouette smooth, cut by user planes and the view volume") {
    const Object object(gl);
    lit_torus(gl, 40);
    gl.LoadIdentity();
    gl.Translatef(0, 0, -1.4F);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_CLIP_PLANE0);
    const GLdouble plane[4] = {1, 0.3, 0, 0.1};
    gl.ClipPlane(GL_CLIP_PLANE0, plane);
    draw_solid(gl, make_sphere(0.7F, 20, 20), kNormals);
    object.show(0, 0, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

SCENE(multisample_textures, "textures in perspective under fog and blending") {
    const Object object(gl);
    painted_texture(gl, 64, 64, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
    gl.Enable(GL_TEXTURE_2D);
    camera(gl, 60, 1);
    gl.Enable(GL_FOG);
    gl.Fogi(GL_FOG_MODE, GL_LINEAR);
    gl.Fogf(GL_FOG_START, 1);
    gl.Fogf(GL_FOG_END, 9);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (int i = 0; i < 5; ++i) {
        gl.PushMatrix();
        gl.Rotatef(20.0F * static_cast<float>(i), 0, 0, 1);
        gl.Translatef(0, -0.6F, 0);
        gl.Rotatef(-70, 1, 0, 0);
        gl.Color4f(1, 1, 1, 0.3F + 0.15F * static_cast<float>(i));
        gl.Scalef(1, 4, 1);
        textured_rectangle(gl, -0.7F, 0.1F, 0.7F, 1, 3, 3);
        gl.PopMatrix();
    }
    object.show();
}

SCENE(multisample_points, "points of all sizes, smooth ones and sprites") {
    const Object object(gl);
    pixel_projection(gl);
    for (int i = 0; i < 16; ++i) {
        const float x = 10.3F + 15.4F * static_cast<float>(i);
        gl.PointSize(0.5F + 0.7F * static_cast<float>(i));
        gl.Color4fv(hue(static_cast<float>(i) / 16).data());
        gl.Begin(GL_POINTS);
        for (int j = 0; j < 6; ++j)
            gl.Vertex3f(x + 0.13F * static_cast<float>(j), 12.2F + 17.31F * static_cast<float>(j), 0);
        gl.End();
    }
    painted_texture(gl, 16, 16, GL_LINEAR, GL_LINEAR);
    gl.Enable(GL_TEXTURE_2D);
    gl.Enable(GL_POINT_SPRITE);
    gl.TexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, GL_TRUE);
    gl.Color3f(1, 1, 1);
    gl.PointSize(21.6F);
    gl.Begin(GL_POINTS);
    for (int i = 0; i < 8; ++i)
        gl.Vertex2f(20.1F + 30.37F * static_cast<float>(i), 160.3F + 7.7F * static_cast<float>(i));
    gl.End();
    object.show();
}

// The reference drops what a line covers of the column left of and the row below its first pixel centres
// where a block of pixels ends there: a few pixels.
constexpr Tolerance kDroppedPixels = {.coverage_share = 0.0002};

SCENE(multisample_lines, "lines of all directions and widths", .tolerance = kDroppedPixels) {
    const Object object(gl);
    pixel_projection(gl);
    for (int cell = 0; cell < 9; ++cell) {
        const float x = 43.2F + 84.9F * static_cast<float>(cell % 3),
                    y = 42.7F + 85.1F * static_cast<float>(cell / 3);
        gl.LineWidth(0.6F + 0.65F * static_cast<float>(cell));
        gl.Begin(GL_LINES);
        for (int i = 0; i < 12; ++i) {
            const float angle = 0.37F + 6.2831853F * static_cast<float>(i) / 12;
            gl.Color4fv(hue(static_cast<float>(i) / 12).data());
            gl.Vertex2f(x + 9 * std::cos(angle), y + 9 * std::sin(angle));
            gl.Color3f(1, 1, 1);
            gl.Vertex2f(x + 38 * std::cos(angle), y + 38 * std::sin(angle));
        }
        gl.End();
    }
    object.show();
}

SCENE(multisample_line_stipple, "stippled lines, and polygons drawn as lines", .tolerance = kDroppedPixels) {
    const Object object(gl);
    pixel_projection(gl);
    gl.Enable(GL_LINE_STIPPLE);
    gl.LineStipple(3, 0x6b35);
    gl.LineWidth(3);
    gl.Begin(GL_LINE_STRIP);
    for (int i = 0; i < 20; ++i) {
        gl.Color4fv(hue(static_cast<float>(i) / 20).data());
        gl.Vertex2f(8.3F + 12.6F * static_cast<float>(i), i % 2 ? 20.7F : 90.4F);
    }
    gl.End();
    gl.Disable(GL_LINE_STIPPLE);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    gl.LineWidth(1.4F);
    star(gl, 130, 180, 70, 9);
    object.show();
}

SCENE(multisample_smooth, "smooth points, lines and polygons: multisampling takes their place") {
    const Object object(gl);
    pixel_projection(gl);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl.Enable(GL_LINE_SMOOTH);
    gl.Enable(GL_POLYGON_SMOOTH);
    gl.LineWidth(2.5F);
    gl.Begin(GL_LINES);
    for (int i = 0; i < 12; ++i) {
        gl.Color4fv(hue(static_cast<float>(i) / 12, 1, 0.8F).data());
        gl.Vertex2f(20.3F, 20.8F + 9.1F * static_cast<float>(i));
        gl.Vertex2f(120.6F, 10.1F + 11.7F * static_cast<float>(i));
    }
    gl.End();
    star(gl, 190, 80, 50, 7);
    object.show();
}

// The reference leaves the depths of all samples but the first, against GL 1.5 §4.1.9: none is looked at
// afterwards.
SCENE(multisample_disabled, "fragments that cover all samples or none, over and under such that do not") {
    const Object object(gl);
    pixel_projection(gl);
    gl.Enable(GL_DEPTH_TEST);
    star(gl, 90, 90, 90, 12);
    gl.Disable(GL_MULTISAMPLE);
    star(gl, 150.4F, 130.3F, 100, 12, 0.05F);
    gl.LineWidth(3);
    gl.PointSize(7);
    gl.Color3f(1, 1, 1);
    gl.Begin(GL_LINES);
    gl.Vertex2f(10, 20);
    gl.Vertex2f(240, 130);
    gl.End();
    gl.Begin(GL_POINTS);
    gl.Vertex2f(30.6F, 200.2F);
    gl.Vertex2f(60.1F, 200.8F);
    gl.End();
    gl.Enable(GL_MULTISAMPLE);
    gl.Disable(GL_DEPTH_TEST);
    star(gl, 120, 190, 60, 12, -0.05F);
    object.show();
}

SCENE(multisample_coverage, "sample coverage of several values, straight and inverted") {
    const Object object(gl);
    pixel_projection(gl);
    gl.Enable(GL_SAMPLE_COVERAGE);
    for_cells(6, 4, [&](int cell, float x, float y, float width, float height) {
        const float value = static_cast<float>(cell % 12) / 11;
        gl.SampleCoverage(value, cell >= 12);
        gl.Color4fv(hue(static_cast<float>(cell) / 24).data());
        rectangle(gl, x + 3.3F, y + 3.6F, x + width - 3.2F, y + height - 3.7F);
    });
    gl.Disable(GL_MULTISAMPLE);  // and with it the coverage
    gl.Color3f(1, 1, 1);
    rectangle(gl, 20, 120, 230, 128);
    object.show();
    float value = 0;
    GLboolean inverted = GL_FALSE;
    gl.GetFloatv(GL_SAMPLE_COVERAGE_VALUE, &value);
    gl.GetBooleanv(GL_SAMPLE_COVERAGE_INVERT, &inverted);
    notes.value("value", value);
    notes.value("inverted", inverted);
}

// The reference's alpha test looks at the alpha before it has become one, against GL 1.5 §4.1.3.
SCENE(multisample_alpha, "alpha to coverage and alpha to one, with the alpha test and blending") {
    const Object object(gl);
    pixel_projection(gl);
    gl.Enable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    for (int row = 0; row < 8; ++row) {
        (row & 1 ? gl.Enable : gl.Disable)(GL_SAMPLE_ALPHA_TO_ONE);
        (row & 2 ? gl.Enable : gl.Disable)(GL_BLEND);
        (row == 4 || row == 6 ? gl.Enable : gl.Disable)(GL_ALPHA_TEST);
        gl.AlphaFunc(GL_GREATER, 0.6F);
        gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        const float y = 6.3F + 31 * static_cast<float>(row);
        gl.Begin(GL_QUADS);
        gl.Color4f(1, 0.8F, 0.2F, 0);
        gl.Vertex2f(6.2F, y);
        gl.Color4f(0.2F, 1, 0.6F, 1);
        gl.Vertex2f(250.4F, y + 2.3F);
        gl.Vertex2f(250.4F, y + 25.6F);
        gl.Color4f(1, 0.8F, 0.2F, 0);
        gl.Vertex2f(6.2F, y + 22.1F);
        gl.End();
    }
    object.show();
}

SCENE(multisample_masks, "blending, logic operations and colour masks on pixels whose samples differ") {
    const Object object(gl);
    pixel_projection(gl);
    star(gl, 128, 128, 128, 30);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ONE);
    gl.Color4f(0.3F, 0.1F, 0.2F, 0.5F);
    rectangle(gl, 20.3F, 20.6F, 110.2F, 110.9F);
    gl.BlendEquation(GL_FUNC_REVERSE_SUBTRACT);
    rectangle(gl, 60.3F, 70.6F, 150.2F, 160.9F);
    gl.Disable(GL_BLEND);
    gl.Enable(GL_COLOR_LOGIC_OP);
    gl.LogicOp(GL_XOR);
    gl.Color4f(0.9F, 0.3F, 0.6F, 1);
    rectangle(gl, 130.2F, 20.1F, 240.8F, 100.4F);
    gl.Disable(GL_COLOR_LOGIC_OP);
    gl.ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
    rectangle(gl, 130.2F, 140.1F, 240.8F, 230.4F);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(30, 170, 90, 70);
    gl.ClearColor(0.1F, 1, 0.9F, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Disable(GL_SCISSOR_TEST);
    object.show();
}

// The reference's pixel rectangles ignore sample coverage, against GL 1.5 §4.1.3.
SCENE(multisample_pixels, "bitmaps, pixel rectangles and polygon stipple") {
    const Object object(gl);
    pixel_projection(gl);
    star(gl, 128, 128, 128, 20);
    const GLubyte bits[8] = {0x18, 0x3c, 0x66, 0xdb, 0xff, 0x24, 0x5a, 0xa5};
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.Color3f(1, 1, 1);
    gl.RasterPos2f(20, 20);
    for (int i = 0; i < 12; ++i) gl.Bitmap(8, 8, 0, 0, 11.3F, 2.2F, bits);
    gl.RasterPos2f(100, 100);
    gl.DrawPixels(64, 64, GL_RGBA, GL_UNSIGNED_BYTE, painted_texels(64, 64).data());
    gl.RasterPos2f(180, 30);
    gl.DrawPixels(32, 64, GL_RGBA, GL_UNSIGNED_BYTE, painted_texels(32, 64).data());
    GLubyte stipple[128];
    for (int i = 0; i < 128; ++i) stipple[i] = static_cast<GLubyte>(i / 4 % 8 < 4 ? 0xcc : 0x33);
    gl.PolygonStipple(stipple);
    gl.Enable(GL_POLYGON_STIPPLE);
    gl.Color3f(0.2F, 0.5F, 1);
    gl.Begin(GL_TRIANGLES);
    gl.Vertex2f(20.3F, 120.8F);
    gl.Vertex2f(240.1F, 190.2F);
    gl.Vertex2f(60.6F, 250.4F);
    gl.End();
    object.show();
}

SCENE(multisample_queries, "samples that pass are counted one by one") {
    const Object object(gl);
    pixel_projection(gl);
    gl.Enable(GL_DEPTH_TEST);
    GLuint query;
    gl.GenQueries(1, &query);
    const auto count = [&](const char* name, auto draw) {
        gl.BeginQuery(GL_SAMPLES_PASSED, query);
        draw();
        gl.EndQuery(GL_SAMPLES_PASSED);
        GLuint samples = 0;
        gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &samples);
        notes.value(name, samples);
    };
    count("triangles", [&] { star(gl, 128, 128, 110, 15); });
    count("behind", [&] { rectangle(gl, 30.4F, 40.3F, 220.7F, 190.6F, -0.1F); });
    gl.Enable(GL_SAMPLE_COVERAGE);
    gl.SampleCoverage(0.75F, GL_FALSE);
    count("three of four", [&] { rectangle(gl, 30, 40, 50, 60, 0.6F); });
    gl.Disable(GL_SAMPLE_COVERAGE);
    object.show();
}

SCENE(multisample_formats, "colour and depth formats of renderbuffers") {
    const GLenum formats[] = {GL_RGB565, GL_RGBA16, GL_RGB8, GL_RGBA8};
    const GLenum depths[] = {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH24_STENCIL8,
                             GL_DEPTH_COMPONENT16};
    for (int cell = 0; cell < 4; ++cell) {
        const Object object(gl, 4, formats[cell], depths[cell], 100, 90);
        notes.value("status", gl.CheckFramebufferStatus(GL_FRAMEBUFFER));
        lit_torus(gl, 30 + 20.0F * static_cast<float>(cell));
        object.show(cell % 2 * 128 + 10, cell / 2 * 128 + 10);
    }
}

SCENE(multisample_blits, "blits between multisampled objects, into one and out of it") {
    const Object first(gl);
    lit_torus(gl, 20);
    const Object plain(gl, 0);
    lit_torus(gl, 100);
    gl.Disable(GL_DEPTH_TEST);
    const Object second(gl);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, first.name());
    gl.BlitFramebuffer(30, 40, 180, 220, 10, 20, 160, 200, kAllBuffers, GL_NEAREST);
    gl.BlitFramebuffer(60, 60, 180, 200, 250, 240, 130, 100, GL_COLOR_BUFFER_BIT, GL_NEAREST);  // turned
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, plain.name());
    gl.BlitFramebuffer(40, 40, 140, 140, 140, 10, 240, 110, kAllBuffers, GL_NEAREST);
    gl.BlitFramebuffer(0, 0, 256, 256, 0, 0, 100, 100, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    notes.value("scaled", gl.GetError());
    gl.BindFramebuffer(GL_FRAMEBUFFER, second.name());
    pixel_projection(gl);
    gl.Enable(GL_DEPTH_TEST);
    star(gl, 128, 128, 100, 8, 0.2F);
    second.show(0, 0, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

SCENE(multisample_state, "what is said of samples, and errors", .draws_nothing_visible = true) {
    const auto integer = [&](GLenum name) {
        GLint value = -1;
        gl.GetIntegerv(name, &value);
        return value;
    };
    notes.value("most samples", integer(GL_MAX_SAMPLES));
    notes.value("window", integer(GL_SAMPLES) + 10 * integer(GL_SAMPLE_BUFFERS));
    for (const int samples : {0, 1, 2, 3, 4, -1}) {
        const GLuint buffer = renderbuffer(gl, samples, GL_RGBA8, 16, 16);
        notes.value("error " + std::to_string(samples), gl.GetError());
        GLint given = -1;
        gl.GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &given);
        notes.value("given " + std::to_string(samples), given);
        gl.DeleteRenderbuffers(1, &buffer);
    }
    const Object object(gl, 4, GL_RGBA8, GL_DEPTH24_STENCIL8, 64, 64);
    notes.value("object", integer(GL_SAMPLES) + 10 * integer(GL_SAMPLE_BUFFERS));
    std::uint8_t pixels[4 * 64] = {};
    gl.ReadPixels(0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    notes.value("read pixels", gl.GetError());
    GLuint texture;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 8, 8, 0);
    notes.value("copy to texture", gl.GetError());
    gl.CopyPixels(0, 0, 8, 8, GL_COLOR);
    notes.value("copy pixels", gl.GetError());
    object.attach(GL_DEPTH_STENCIL_ATTACHMENT, renderbuffer(gl, 0, GL_DEPTH24_STENCIL8, 64, 64));
    notes.value("mixed", gl.CheckFramebufferStatus(GL_FRAMEBUFFER));
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}
