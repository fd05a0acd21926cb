// Choosing the state and drawing; see styles.h.
#include "styles.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "kit/offscreen.h"
#include "random.h"

// Random numbers are drawn into variables and lists, not into arguments, whose order is the compiler's.
namespace terrazzo::coverage {
namespace {

using kit::Gl;

void enable(const Gl& gl, GLenum what, bool on) {
    on ? gl.Enable(what) : gl.Disable(what);
}

struct Vertex {
    std::array<float, 3> position, normal;
    std::array<float, 4> color;
    std::array<float, 4> texture{0, 0, 0, 1};
    GLboolean edge;
};

void set_view(const Gl& gl, Random& random) {
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadIdentity();
    if (random.chance(2)) {
        gl.MatrixMode(GL_PROJECTION);
        gl.Ortho(-1.3, 1.3, -1.3, 1.3, -1.2, 1.2);
    } else {
        gl.MatrixMode(GL_PROJECTION);
        gl.Frustum(-0.5, 0.5, -0.5, 0.5, 1, 6);
        gl.MatrixMode(GL_MODELVIEW);
        const GLfloat to[3] = {random.number(-0.3f, 0.3f), random.number(-0.3f, 0.3f),
                               random.number(-3.5f, -1.7f)};
        gl.Translatef(to[0], to[1], to[2]);
    }
    gl.MatrixMode(GL_MODELVIEW);
    const GLfloat turn[4] = {random.number(-70, 70), random.number(-1, 1), random.number(-1, 1),
                             random.number(-1, 1)};
    gl.Rotatef(turn[0], turn[1], turn[2], turn[3]);
    const bool cut = random.chance(4);
    const GLdouble plane[4] = {random.number(-1, 1), random.number(-1, 1), random.number(-1, 1),
                               random.number(0, 0.6f)};
    gl.ClipPlane(GL_CLIP_PLANE1, plane);
    enable(gl, GL_CLIP_PLANE1, cut);
}

void set_polygons(const Gl& gl, Random& random) {
    const GLenum mode = random.one_of<GLenum>({GL_FILL, GL_FILL, GL_LINE, GL_LINE, GL_POINT});
    gl.PolygonMode(GL_FRONT_AND_BACK, mode);
    enable(gl, GL_CULL_FACE, random.chance(3));
    gl.CullFace(random.one_of<GLenum>({GL_FRONT, GL_BACK}));
    gl.FrontFace(random.one_of<GLenum>({GL_CW, GL_CCW}));
    gl.ShadeModel(random.one_of<GLenum>({GL_FLAT, GL_SMOOTH}));
    // The reference moves filled polygons with any of the three: these are never the only ones.
    const bool any = mode != GL_FILL || random.chance(2);
    for (const GLenum which : {GL_POLYGON_OFFSET_FILL, GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_POINT}) {
        const bool on = random.chance(2);
        enable(gl, which, any && (on || (mode == GL_FILL && which == GL_POLYGON_OFFSET_FILL)));
    }
    const GLfloat offset[2] = {random.number(-3, 3), random.number(-400, 400)};
    gl.PolygonOffset(offset[0], offset[1]);
    enable(gl, GL_POLYGON_STIPPLE, random.chance(5));
    GLubyte pattern[128];
    for (GLubyte& byte : pattern) byte = static_cast<GLubyte>(random.below(256) | random.below(256));
    gl.PolygonStipple(pattern);
}

void set_lines_and_points(const Gl& gl, Random& random) {
    gl.LineWidth(random.one_of({1.0f, 1.0f, 2.0f, 3.4f, 6.0f}));
    gl.PointSize(random.one_of({1.0f, 2.0f, 3.5f, 6.0f, 9.0f}));
    enable(gl, GL_LINE_STIPPLE, random.chance(3));
    const GLint factor = random.one_of<GLint>({1, 2, 3, 7});
    gl.LineStipple(factor, static_cast<GLushort>(random.chance(6) ? 0xffff : random.below(65536)));
    const bool smooth = random.chance(4);
    enable(gl, GL_LINE_SMOOTH, smooth && random.chance(2));
    enable(gl, GL_POINT_SMOOTH, smooth && random.chance(2));
    enable(gl, GL_BLEND, smooth || random.chance(4));
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    enable(gl, GL_ALPHA_TEST, random.chance(6));
    gl.AlphaFunc(GL_GREATER, 0.25f);
}

void set_lights(const Gl& gl, Random& random) {
    enable(gl, GL_LIGHTING, random.chance(4));
    gl.Enable(GL_LIGHT0);
    gl.Enable(GL_NORMALIZE);
    gl.Enable(GL_COLOR_MATERIAL);
    gl.ColorMaterial(GL_FRONT, GL_DIFFUSE);
    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, random.chance(2));
    const GLfloat back[4] = {random.number(0, 1), random.number(0, 1), random.number(0, 1), 1};
    gl.Materialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, back);
}

void set_depth(const Gl& gl, Random& random) {
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilFunc(GL_ALWAYS, 0, 0xff);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(random.one_of<GLenum>({GL_ALWAYS, GL_ALWAYS, GL_LESS, GL_GEQUAL}));
    gl.ClearDepth(random.one_of({1.0, 0.0}));
}

void send(const Gl& gl, const Vertex& v) {
    gl.Color4fv(v.color.data());
    gl.Normal3fv(v.normal.data());
    gl.TexCoord4fv(v.texture.data());
    gl.EdgeFlag(v.edge);
    gl.Vertex3fv(v.position.data());
}

void draw_arrays(const Gl& gl, GLenum mode, const std::vector<Vertex>& vertices, bool indexed) {
    constexpr GLsizei kStride = sizeof(Vertex);
    const GLenum arrays[] = {GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY,
                             GL_EDGE_FLAG_ARRAY};
    for (const GLenum array : arrays) gl.EnableClientState(array);
    gl.VertexPointer(3, GL_FLOAT, kStride, vertices[0].position.data());
    gl.ColorPointer(4, GL_FLOAT, kStride, vertices[0].color.data());
    gl.NormalPointer(GL_FLOAT, kStride, vertices[0].normal.data());
    gl.TexCoordPointer(4, GL_FLOAT, kStride, vertices[0].texture.data());
    gl.EdgeFlagPointer(kStride, &vertices[0].edge);
    if (indexed) {
        std::vector<GLuint> indices;
        for (GLuint i = 0; i < vertices.size(); ++i) indices.push_back(i);
        gl.DrawElements(mode, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, indices.data());
    } else {
        gl.DrawArrays(mode, 0, static_cast<GLsizei>(vertices.size()));
    }
    for (const GLenum array : arrays) gl.DisableClientState(array);
}

void draw_immediately(const Gl& gl, GLenum mode, const std::vector<Vertex>& vertices) {
    gl.Begin(mode);
    for (const Vertex& v : vertices) send(gl, v);
    gl.End();
}

std::vector<Vertex> make_vertices(Random& random, bool edges) {
    const float reach = random.one_of({0.15f, 0.6f, 1.6f});
    const float center[3] = {random.number(-0.8f, 0.8f), random.number(-0.8f, 0.8f),
                             random.number(-0.6f, 0.6f)};
    std::vector<Vertex> vertices(3 + random.below(16));
    for (Vertex& v : vertices) {
        for (size_t c = 0; c < 3; ++c) {
            v.position[c] = center[c] + random.number(-reach, reach);
            v.normal[c] = random.number(-1, 1);
            v.color[c] = random.number(0, 1);
        }
        v.color[3] = random.number(0, 1.2f);
        v.edge = !edges || random.chance(2);
    }
    return vertices;
}

void lead_astray(Random& random, std::vector<Vertex>& vertices) {
    const auto some = [&](auto& numbers) {
        for (float& number : numbers)
            if (random.chance(8)) number = random.stray();
    };
    for (Vertex& v : vertices) {
        for (float& coordinate : v.texture) coordinate = random.number(-2, 2);
        some(v.position), some(v.normal), some(v.color), some(v.texture);
    }
}

void set_textures(const Gl& gl, Random& random) {
    GLubyte texels[16 * 16 * 4];
    for (GLubyte& byte : texels) byte = static_cast<GLubyte>(random.below(256));
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    for (GLint level = 1; level <= 4; ++level)
        gl.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA, 16 >> level, 16 >> level, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                      texels);
    const GLint filter =
        random.one_of<GLint>({GL_NEAREST, GL_LINEAR, GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_LINEAR});
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, random.one_of<GLint>({GL_NEAREST, GL_LINEAR}));
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, random.one_of<GLint>({GL_REPEAT, GL_CLAMP}));
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, random.one_of<GLint>({GL_REPEAT, GL_CLAMP}));
    enable(gl, GL_TEXTURE_2D, random.chance(2));
    gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE,
               random.one_of<GLint>({GL_SPHERE_MAP, GL_EYE_LINEAR, GL_OBJECT_LINEAR}));
    enable(gl, GL_TEXTURE_GEN_S, random.chance(3));
    gl.Fogi(GL_FOG_MODE, random.one_of<GLint>({GL_LINEAR, GL_EXP, GL_EXP2}));
    enable(gl, GL_FOG, random.chance(3));
}

// Whether primitives of this mode are several lines or triangles, the first of which may be clipped away
// alone.
bool may_lose_restart(GLenum mode) {
    return mode == GL_LINE_STRIP || mode == GL_LINE_LOOP || mode >= GL_QUADS;
}

// A line of no length: the reference's line stipple does not restart where the first line of a strip is
// clipped away (doc/reference.md §3.3, defects).
void restart_stipple(const Gl& gl) {
    const GLboolean cut = gl.IsEnabled(GL_CLIP_PLANE1);
    gl.Disable(GL_CLIP_PLANE1);
    for (const GLenum matrix : {GL_PROJECTION, GL_MODELVIEW}) {
        gl.MatrixMode(matrix);
        gl.PushMatrix();
        gl.LoadIdentity();
    }
    gl.Begin(GL_LINES);
    gl.Vertex2f(0, 0);
    gl.Vertex2f(0, 0);
    gl.End();
    for (const GLenum matrix : {GL_PROJECTION, GL_MODELVIEW}) {
        gl.MatrixMode(matrix);
        gl.PopMatrix();
    }
    enable(gl, GL_CLIP_PLANE1, cut);
}

// Display lists do without quads of fewer than four vertices: doc/reference.md §3.3, defects.
void draw_primitives(const Gl& gl, Random& random, bool strays) {
    constexpr uint32_t kList = 2;
    for (int i = 0; i < 9; ++i) {
        const GLenum mode = random.below(GL_POLYGON + 1);
        const uint32_t way = random.below(5);
        std::vector<Vertex> vertices = make_vertices(random, random.chance(3));
        if (strays) lead_astray(random, vertices);
        // One quad: what follows a polygon that is culled or clipped away does not restart there either.
        if (mode == GL_QUADS || mode == GL_QUAD_STRIP) vertices.resize(std::min<size_t>(vertices.size(), 4));
        if (may_lose_restart(mode)) restart_stipple(gl);
        switch (way) {
            case 0:
                draw_arrays(gl, mode, vertices, false);
                break;
            case 1:
                draw_arrays(gl, mode, vertices, true);
                break;
            case kList:
                if (vertices.size() < 4) break;
                gl.NewList(1, GL_COMPILE);
                draw_immediately(gl, mode, vertices);
                gl.EndList();
                gl.CallList(1);
                break;
            default:
                draw_immediately(gl, mode, vertices);
        }
        gl.EdgeFlag(GL_TRUE);
    }
}

}  // namespace

std::vector<StylePicture> draw_styles(const std::string& path, uint32_t seed, uint32_t first, uint32_t count,
                                      bool strays) {
    const kit::Library library(path);
    const Gl& gl = library.gl;
    std::vector<StylePicture> pictures;
    for (uint32_t i = first; i < first + count; ++i) {
        const kit::OffscreenContext context(library, {.depth_bits = i % 4 == 3 ? 16 : 24,
                                                      .stencil_bits = i % 4 == 3 ? 0 : 8,
                                                      .width = kStyleSize,
                                                      .height = kStyleSize});
        Random random(seed, i);
        gl.ClearColor(0.2f, 0.3f, 0.4f, 0.5f);
        set_depth(gl, random);
        gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        set_view(gl, random);
        set_polygons(gl, random);
        set_lines_and_points(gl, random);
        set_lights(gl, random);
        if (strays) set_textures(gl, random);
        draw_primitives(gl, random, strays);
        gl.Finish();
        const auto colors = context.colour_buffer();
        pictures.push_back({{colors.begin(), colors.end()}, context.read_stencil(), context.read_depth()});
        if (const auto errors = context.take_errors(); !errors.empty())
            throw std::runtime_error("picture " + std::to_string(i) + " leaves " +
                                     kit::error_name(errors[0]));
    }
    return pictures;
}

}  // namespace terrazzo::coverage
