// See small_frames.h. Objects are given as a physics simulator's renderer gives them: lists, matrices, four
// materials a draw, texture coordinates made by the library.
#include "small_frames.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace terrazzo::small_frames {
namespace {

constexpr const char* kContents[] = {"empty", "triangle", "objects", "shadows"};
constexpr const char* kReadouts[] = {"rgba", "rgb", "depth"};
constexpr const char* kPlaces[] = {"window", "object", "samples"};

constexpr int kObjects = 50, kShadowObjects = 10;
constexpr int kShadowMapSize = 4096;
constexpr int kShapes = 3;

template <std::size_t kCount>
std::size_t index_of(const char* const (&names)[kCount], const std::string& name) {
    const auto found = std::find(std::begin(names), std::end(names), name);
    if (found == std::end(names)) throw std::runtime_error("no such part of a small frame: " + name);
    return static_cast<std::size_t>(found - std::begin(names));
}

// A ball, or a barrel, which is one without poles.
void draw_ball(const kit::Gl& gl, int slices, int stacks, bool is_barrel) {
    const auto vertex = [&](int slice, int stack) {
        const double around = 2 * M_PI * slice / slices,
                     up = M_PI * (static_cast<double>(stack) / stacks - 0.5);
        const double radius = is_barrel ? 1 : std::cos(up);
        const double normal[3] = {radius * std::cos(around), radius * std::sin(around),
                                  is_barrel ? 0 : std::sin(up)};
        gl.Normal3dv(normal);
        gl.Vertex3d(normal[0], normal[1], is_barrel ? 2.0 * stack / stacks - 1 : normal[2]);
    };
    for (int stack = 0; stack < stacks; ++stack) {
        gl.Begin(GL_QUAD_STRIP);
        for (int slice = 0; slice <= slices; ++slice) vertex(slice, stack + 1), vertex(slice, stack);
        gl.End();
    }
}

void draw_box(const kit::Gl& gl) {
    gl.Begin(GL_QUADS);
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0})
            for (const auto& corner : {std::array{-1.0, -1.0}, {side, -side}, {1.0, 1.0}, {-side, side}}) {
                double normal[3] = {}, position[3];
                normal[axis] = position[axis] = side;
                position[(axis + 1) % 3] = corner[0];
                position[(axis + 2) % 3] = corner[1];
                gl.Normal3dv(normal);
                gl.Vertex3dv(position);
            }
    gl.End();
}

void set_material(const kit::Gl& gl, int object) {
    const auto share = [&](int step) { return 0.3F + 0.1F * static_cast<float>((object * step) % 7); };
    const GLfloat colour[] = {share(3), share(5), share(2), 1}, shine[] = {0.3F, 0.3F, 0.3F, 1},
                  glow[] = {0, 0, 0.02F * static_cast<float>(object % 3), 1};
    gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, colour);
    gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, shine);
    gl.Materialfv(GL_FRONT_AND_BACK, GL_EMISSION, glow);
    gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, static_cast<float>(20 + object % 5));
}

// A grid of objects that turn each its own way.
void place(const kit::Gl& gl, int object) {
    const float turn = 0.7F * static_cast<float>(object), size = 0.13F;
    const float c = size * std::cos(turn), s = size * std::sin(turn);
    const auto column = static_cast<float>(object % 8), row = static_cast<float>(object / 8);
    const GLfloat matrix[] = {c,
                              s,
                              0,
                              0,
                              -s * 0.6F,
                              c * 0.6F,
                              size * 0.8F,
                              0,
                              s * 0.8F,
                              -c * 0.8F,
                              size * 0.6F,
                              0,
                              -1.05F + 0.3F * column,
                              -0.9F + 0.3F * row,
                              0,
                              1};
    gl.MultMatrixf(matrix);
}

GLuint make_texture(const kit::Gl& gl, unsigned seed) {
    constexpr int kSize = 64;
    std::vector<std::uint8_t> texels(kSize * kSize * 3);
    for (std::size_t i = 0; i < texels.size(); ++i)
        texels[i] = static_cast<std::uint8_t>(128 + (i / 3 * seed >> 4) % 128);
    GLuint name;
    gl.GenTextures(1, &name);
    gl.BindTexture(GL_TEXTURE_2D, name);
    gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, kSize, kSize, 0, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
    return name;
}

void look_from_above(const kit::Gl& gl, double half_width) {
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    gl.Frustum(-half_width, half_width, -half_width, half_width, 1, 10);
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadIdentity();
    gl.Translatef(0, 0, -3);
}

}  // namespace

std::string Description::name() const {
    return std::string(kContents[static_cast<std::size_t>(content)]) + "/" + std::to_string(size) + "/" +
           kReadouts[static_cast<std::size_t>(readout)] + "/" + kPlaces[static_cast<std::size_t>(place)];
}

Description Description::parse(const std::string& name) {
    std::vector<std::string> parts{""};
    for (const char c : name) c == '/' ? void(parts.emplace_back()) : parts.back().push_back(c);
    if (parts.size() != 4) throw std::runtime_error("small frames are called CONTENT/SIZE/READOUT/PLACE");
    const int size = std::atoi(parts[1].c_str());
    if (size < 1 || size > 4096) throw std::runtime_error("no such size: " + parts[1]);
    return {static_cast<Content>(index_of(kContents, parts[0])), size,
            static_cast<Readout>(index_of(kReadouts, parts[2])),
            static_cast<Place>(index_of(kPlaces, parts[3]))};
}

std::vector<Description> descriptions() {
    std::vector<Description> all;
    for (const Content content : {Content::kEmpty, Content::kTriangle, Content::kObjects})
        for (const int size : {16, 64, 84, 256})
            all.push_back({content, size, Readout::kRgba, Place::kWindow});
    for (const int size : {64, 256})
        for (const Content content : {Content::kEmpty, Content::kObjects}) {
            all.push_back({content, size, Readout::kRgb, Place::kWindow});
            all.push_back({content, size, Readout::kDepth, Place::kWindow});
            all.push_back({content, size, Readout::kRgb, Place::kObject});
            all.push_back({content, size, Readout::kRgb, Place::kSamples});
            all.push_back({content, size, Readout::kDepth, Place::kSamples});
        }
    all.push_back({Content::kShadows, 64, Readout::kRgb, Place::kWindow});
    all.push_back({Content::kShadows, 64, Readout::kRgb, Place::kSamples});
    return all;
}

Frames::Frames(const kit::Gl& gl, const Description& description) : m_gl(gl), m_description(description) {
    if (m_description.place != Place::kWindow)
        m_object = make_object(m_description.place == Place::kSamples ? 4 : 0);
    if (m_description.place == Place::kSamples) m_resolved = make_object(0);
    const std::size_t pixel_size = m_description.readout == Readout::kRgb ? 3 : 4;
    m_picture.resize(static_cast<std::size_t>(m_description.size) *
                     static_cast<std::size_t>(m_description.size) * pixel_size);
    m_gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    m_gl.ClearColor(0.1F, 0.2F, 0.3F, 1);
    m_gl.Enable(GL_DEPTH_TEST);
    if (m_description.content >= Content::kObjects) prepare_objects();
    if (m_description.content == Content::kShadows) prepare_shadows();
}

GLuint Frames::make_object(int samples) const {
    GLuint object, renderbuffer;
    m_gl.GenFramebuffers(1, &object);
    m_gl.BindFramebuffer(GL_FRAMEBUFFER, object);
    const std::pair<GLenum, GLenum> planes[] = {{GL_COLOR_ATTACHMENT0, GL_RGBA8},
                                                {GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8}};
    for (const auto& [point, format] : planes) {
        m_gl.GenRenderbuffers(1, &renderbuffer);
        m_gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
        m_gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, m_description.size,
                                            m_description.size);
        m_gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, renderbuffer);
    }
    return object;
}

void Frames::prepare_objects() {
    m_lists = m_gl.GenLists(kShapes);
    for (GLuint shape = 0; shape < kShapes; ++shape) {
        m_gl.NewList(m_lists + shape, GL_COMPILE);
        shape == 0 ? draw_box(m_gl) : draw_ball(m_gl, 20, shape == 1 ? 10 : 1, shape == 2);
        m_gl.EndList();
    }
    for (std::size_t i = 0; i < m_textures.size(); ++i)
        m_textures[i] = make_texture(m_gl, 37 + 20 * static_cast<unsigned>(i));
    const GLfloat plane_s[] = {0.5F, 0, 0.1F, 0}, plane_t[] = {0, 0.5F, 0.1F, 0};
    m_gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    m_gl.TexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    m_gl.TexGenfv(GL_S, GL_OBJECT_PLANE, plane_s);
    m_gl.TexGenfv(GL_T, GL_OBJECT_PLANE, plane_t);
    m_gl.Enable(GL_LIGHTING);
    m_gl.Enable(GL_LIGHT0);
    m_gl.Enable(GL_NORMALIZE);
    m_gl.Enable(GL_CULL_FACE);
    m_gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
}

void Frames::prepare_shadows() {
    m_gl.GenTextures(1, &m_shadow_map);
    m_gl.BindTexture(GL_TEXTURE_2D, m_shadow_map);
    m_gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    m_gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    m_gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    m_gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kShadowMapSize, kShadowMapSize, 0,
                    GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
    m_gl.GenFramebuffers(1, &m_shadow_object);
    m_gl.BindFramebuffer(GL_FRAMEBUFFER, m_shadow_object);
    m_gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, m_shadow_map, 0);
    m_gl.DrawBuffer(GL_NONE);
    m_gl.ReadBuffer(GL_NONE);
}

void Frames::draw() {
    if (m_description.content == Content::kShadows) draw_shadow_map();
    m_gl.BindFramebuffer(GL_FRAMEBUFFER, m_object);
    m_gl.Viewport(0, 0, m_description.size, m_description.size);
    m_gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    draw_content();
    read();
}

void Frames::draw_content() const {
    switch (m_description.content) {
        case Content::kEmpty:
            return;
        case Content::kTriangle:
            m_gl.Begin(GL_TRIANGLES);
            m_gl.Color3f(1, 0, 0), m_gl.Vertex3f(-0.7F, -0.6F, 0);
            m_gl.Color3f(0, 1, 0), m_gl.Vertex3f(0.8F, -0.5F, 0.5F);
            m_gl.Color3f(0, 0, 1), m_gl.Vertex3f(0.1F, 0.8F, -0.5F);
            m_gl.End();
            return;
        case Content::kObjects:
            look_from_above(m_gl, 0.45);
            return draw_objects(kObjects);
        case Content::kShadows:
            look_from_above(m_gl, 0.45);
            m_gl.BindTexture(GL_TEXTURE_2D, m_shadow_map);
            m_gl.Enable(GL_TEXTURE_2D);
            m_gl.Begin(GL_QUADS);
            m_gl.Normal3f(0, 0, 1);
            m_gl.TexCoord3f(0, 0, 0.9F), m_gl.Vertex3f(-1.2F, -1.2F, 0);
            m_gl.TexCoord3f(1, 0, 0.9F), m_gl.Vertex3f(1.2F, -1.2F, 0);
            m_gl.TexCoord3f(1, 1, 0.9F), m_gl.Vertex3f(1.2F, 1.2F, 0);
            m_gl.TexCoord3f(0, 1, 0.9F), m_gl.Vertex3f(-1.2F, 1.2F, 0);
            m_gl.End();
            m_gl.Disable(GL_TEXTURE_2D);
            return draw_objects(kShadowObjects);
    }
}

void Frames::draw_objects(int count) const {
    const GLfloat light[] = {1, 2, 3, 1};
    m_gl.Lightfv(GL_LIGHT0, GL_POSITION, light);
    for (int object = 0; object < count; ++object) {
        set_material(m_gl, object);
        const bool textured = object % 3 == 0;
        if (textured) {
            m_gl.BindTexture(GL_TEXTURE_2D, m_textures[static_cast<std::size_t>(object % 2)]);
            for (const GLenum what : {GL_TEXTURE_2D, GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T}) m_gl.Enable(what);
        }
        m_gl.PushMatrix();
        place(m_gl, object);
        m_gl.CallList(m_lists + static_cast<GLuint>(object % kShapes));
        m_gl.PopMatrix();
        if (textured)
            for (const GLenum what : {GL_TEXTURE_2D, GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T}) m_gl.Disable(what);
    }
}

// The objects lie in a corner of the map.
void Frames::draw_shadow_map() const {
    m_gl.BindFramebuffer(GL_FRAMEBUFFER, m_shadow_object);
    m_gl.Viewport(0, 0, kShadowMapSize, kShadowMapSize);
    m_gl.Clear(GL_DEPTH_BUFFER_BIT);
    m_gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    m_gl.Enable(GL_POLYGON_OFFSET_FILL);
    m_gl.PolygonOffset(2, 4);
    look_from_above(m_gl, 2);
    draw_objects(kShadowObjects);
    m_gl.Disable(GL_POLYGON_OFFSET_FILL);
    m_gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void Frames::read() {
    const int size = m_description.size;
    const bool depth = m_description.readout == Readout::kDepth;
    if (m_resolved != 0) {
        m_gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, m_resolved);
        m_gl.BlitFramebuffer(0, 0, size, size, 0, 0, size, size,
                             depth ? GL_DEPTH_BUFFER_BIT : GL_COLOR_BUFFER_BIT, GL_NEAREST);
        m_gl.BindFramebuffer(GL_READ_FRAMEBUFFER, m_resolved);
    }
    const GLenum format = depth                                    ? GL_DEPTH_COMPONENT
                          : m_description.readout == Readout::kRgb ? GL_RGB
                                                                   : GL_RGBA;
    m_gl.ReadPixels(0, 0, size, size, format, depth ? GL_FLOAT : GL_UNSIGNED_BYTE, m_picture.data());
}

}  // namespace terrazzo::small_frames
