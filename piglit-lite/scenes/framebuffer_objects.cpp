// Chapter: frame buffer objects (ARB_framebuffer_object, EXT_framebuffer_object).
#include <algorithm>

#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

GLuint renderbuffer(const Gl& gl, GLenum format, int width, int height) {
    GLuint name;
    gl.GenRenderbuffers(1, &name);
    gl.BindRenderbuffer(GL_RENDERBUFFER, name);
    gl.RenderbufferStorage(GL_RENDERBUFFER, format, width, height);
    return name;
}

GLuint framebuffer(const Gl& gl) {
    GLuint name;
    gl.GenFramebuffers(1, &name);
    gl.BindFramebuffer(GL_FRAMEBUFFER, name);
    return name;
}

void attach(const Gl& gl, GLenum point, GLuint name) {
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, name);
}

void clear(const Gl& gl, float r, float g, float b) {
    gl.ClearColor(r, g, b, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

}  // namespace

SCENE(fbo_renderbuffers, "a lit scene in renderbuffers of several formats, blitted to the window") {
    const GLenum formats[] = {GL_RGBA8, GL_RGB8, GL_RGBA16, GL_RGB};
    const GLenum depths[] = {GL_DEPTH_COMPONENT24, GL_DEPTH24_STENCIL8, GL_DEPTH_COMPONENT16,
                             GL_DEPTH_COMPONENT};
    for (int cell = 0; cell < 4; ++cell) {
        const GLuint name = framebuffer(gl);
        attach(gl, GL_COLOR_ATTACHMENT0, renderbuffer(gl, formats[cell], 100, 90));
        attach(gl, GL_DEPTH_ATTACHMENT, renderbuffer(gl, depths[cell], 100, 90));
        notes.value("status", gl.CheckFramebufferStatus(GL_FRAMEBUFFER));
        gl.Viewport(0, 0, 100, 90);
        clear(gl, 0.2F, 0.1F * static_cast<float>(cell), 0.4F);
        lit_torus(gl, 30.0F * static_cast<float>(cell));
        gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
        const int x = cell % 2 * 128 + 10, y = cell / 2 * 128 + 10;
        gl.BlitFramebuffer(0, 0, 100, 90, x, y, x + 100, y + 90, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
        gl.DeleteFramebuffers(1, &name);
    }
}

SCENE(fbo_textures, "drawing into textures of two levels, a cube's face and a slice, then with them") {
    GLuint textures[3];
    gl.GenTextures(3, textures);
    gl.BindTexture(GL_TEXTURE_2D, textures[0]);
    for (int level = 0; level < 7; ++level)
        gl.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA, 64 >> level, 64 >> level, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                      painted_texels(64 >> level, 64 >> level).data());
    const GLuint name = framebuffer(gl);
    const GLuint depth = renderbuffer(gl, GL_DEPTH_COMPONENT24, 64, 64);
    attach(gl, GL_DEPTH_ATTACHMENT, depth);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textures[0], 0);
    notes.value("status", gl.CheckFramebufferStatus(GL_FRAMEBUFFER));
    gl.Viewport(0, 0, 64, 64);
    gl.Clear(GL_DEPTH_BUFFER_BIT);  // the picture that was there stays
    lit_torus(gl, 40);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, 0);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textures[0], 2);
    gl.Viewport(0, 0, 16, 16);
    clear(gl, 0.9F, 0.3F, 0.1F);

    gl.BindTexture(GL_TEXTURE_CUBE_MAP, textures[1]);
    for (int face = 0; face < 6; ++face)
        gl.TexImage2D(static_cast<GLenum>(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face), 0, GL_RGBA, 32, 32, 0,
                      GL_RGBA, GL_UNSIGNED_BYTE,
                      painted_texels(32, 32, static_cast<std::uint32_t>(face)).data());
    gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, textures[1],
                            0);
    gl.Viewport(0, 0, 32, 32);
    clear(gl, 0.1F, 0.7F, 0.4F);
    gl.Disable(GL_DEPTH_TEST);
    pixel_projection(gl, 32, 32);
    gl.Color4f(1, 1, 0, 1);
    rectangle(gl, 3, 5, 20, 28);

    gl.BindTexture(GL_TEXTURE_3D, textures[2]);
    gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RGB, 16, 16, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
    gl.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    for (int layer = 0; layer < 4; ++layer) {
        gl.FramebufferTexture3D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_3D, textures[2], 0, layer);
        const Colour colour = hue(static_cast<float>(layer) / 4);
        gl.Viewport(0, 0, 16, 16);
        clear(gl, colour[0], colour[1], colour[2]);
    }
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.DeleteFramebuffers(1, &name);
    gl.Viewport(0, 0, kSize, kSize);
    pixel_projection(gl);
    gl.Color4f(1, 1, 1, 1);
    gl.Enable(GL_TEXTURE_2D);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    textured_rectangle(gl, 8, 8, 120, 120);
    textured_rectangle(gl, 8, 136, 24, 152);  // level 2
    gl.Enable(GL_TEXTURE_3D);
    gl.Begin(GL_QUADS);
    for (int i = 0; i < 4; ++i) {
        const float s = i == 1 || i == 2 ? 1.0F : 0.0F, t = i / 2 ? 1.0F : 0.0F;
        gl.TexCoord3f(s, t, s);
        gl.Vertex2f(136 + 100 * s, 8 + 100 * t);
    }
    gl.End();
    gl.Enable(GL_TEXTURE_CUBE_MAP);
    gl.Begin(GL_QUADS);
    for (int i = 0; i < 4; ++i) {
        const float s = i == 1 || i == 2 ? 1.5F : -1.5F, t = i / 2 ? 1.5F : -1.5F;
        gl.TexCoord3f(s, t, -1);
        gl.Vertex2f(180 + 30 * s, 180 + 30 * t);
    }
    gl.End();
}

SCENE(fbo_shadow, "a shadow map drawn into a depth texture without a colour buffer") {
    GLuint texture;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, 128, 128, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8,
                  nullptr);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    const GLuint name = framebuffer(gl);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
    notes.value("no colour to draw to", gl.CheckFramebufferStatus(GL_FRAMEBUFFER));
    gl.DrawBuffer(GL_NONE);
    gl.ReadBuffer(GL_NONE);
    notes.value("status", gl.CheckFramebufferStatus(GL_FRAMEBUFFER));
    gl.Viewport(1, 1, 126, 126);
    gl.Clear(GL_DEPTH_BUFFER_BIT);
    camera(gl, 50, 3);
    gl.Enable(GL_DEPTH_TEST);
    gl.Rotatef(30, 1, 1, 0);
    draw_solid(gl, make_torus(0.8F, 0.35F, 28, 14), kPositions);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.DeleteFramebuffers(1, &name);
    gl.Viewport(0, 0, kSize, kSize);
    gl.Disable(GL_DEPTH_TEST);
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_2D);
    textured_rectangle(gl, 4, 4, 124, 124);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    gl.Begin(GL_QUADS);
    for (int i = 0; i < 4; ++i) {
        const float s = i == 1 || i == 2 ? 1.0F : 0.0F, t = i / 2 ? 1.0F : 0.0F;
        gl.TexCoord3f(s, t, 0.5F + 0.5F * s);
        gl.Vertex2f(132 + 120 * s, 132 + 120 * t);
    }
    gl.End();
}

SCENE(fbo_depth_stencil_texture, "a texture of depths and stencil values: written, drawn to, given back") {
    std::vector<GLuint> pixels(64 * 64);
    for (GLuint i = 0; i < pixels.size(); ++i) pixels[i] = (0xc00000 + i * 500) << 8 | i / 64 % 16;
    GLuint texture;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, 64, 64, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8,
                  pixels.data());
    const GLuint name = framebuffer(gl);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
    gl.DrawBuffer(GL_NONE);
    gl.ReadBuffer(GL_NONE);
    const auto draw = [&](GLenum function, float size) {
        gl.BindFramebuffer(GL_FRAMEBUFFER, name);
        gl.Viewport(0, 0, 64, 64);
        pixel_projection(gl, 64, 64);
        gl.Enable(GL_DEPTH_TEST);
        gl.Enable(GL_STENCIL_TEST);
        gl.StencilFunc(function, 9, 15);
        gl.StencilOp(GL_INCR, GL_REPLACE, GL_INVERT);
        rectangle(gl, 10, 5, size, size + 3, -0.6F);
        gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
        gl.Viewport(0, 0, kSize, kSize);
        gl.Disable(GL_STENCIL_TEST);
        gl.GetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, pixels.data());
    };
    draw(GL_LESS, 50);
    gl.WindowPos2i(8, 8);
    gl.DrawPixels(64, 64, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, pixels.data());
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 20, 30, 40, 20, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, pixels.data());
    draw(GL_NOTEQUAL, 40);
    gl.WindowPos2i(90, 8);
    gl.DrawPixels(64, 64, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, pixels.data());
    pixel_projection(gl);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilFunc(GL_LESS, 7, 255);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    gl.Color3f(0.9F, 0.6F, 0.1F);
    rectangle(gl, 0, 0, kSize, kSize, -0.7F);
}

SCENE(fbo_sizes, "attachments of different sizes: what they have in common is drawn to, the rest stays") {
    const GLuint name = framebuffer(gl);
    const GLuint wide = renderbuffer(gl, GL_RGBA8, 200, 90), high = renderbuffer(gl, GL_RGBA8, 70, 150),
                 depth = renderbuffer(gl, GL_DEPTH24_STENCIL8, 110, 140);
    attach(gl, GL_DEPTH_STENCIL_ATTACHMENT, depth);
    gl.ClearDepth(0.5);
    clear(gl, 0, 0, 0);
    gl.ClearDepth(1);
    for (const GLuint colour : {wide, high}) {
        attach(gl, GL_DEPTH_STENCIL_ATTACHMENT, 0);
        attach(gl, GL_COLOR_ATTACHMENT0, colour);
        gl.Viewport(0, 0, 200, 150);
        clear(gl, 0.3F, 0.1F, 0.2F);
        attach(gl, GL_DEPTH_STENCIL_ATTACHMENT, depth);
        notes.value("status", gl.CheckFramebufferStatus(GL_FRAMEBUFFER));
        clear(gl, 0.1F, 0.4F, 0.5F);
        gl.Viewport(0, 0, 110, 90);
        lit_torus(gl, 50);
        // Without the other attachment all of one can be read.
        attach(gl, GL_DEPTH_STENCIL_ATTACHMENT, 0);
        gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
        const int x = colour == wide ? 2 : 180, y = colour == wide ? 2 : 100;
        gl.BlitFramebuffer(0, 0, 200, 150, x, y, x + 200, y + 150, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        gl.BindFramebuffer(GL_FRAMEBUFFER, name);
    }
    attach(gl, GL_COLOR_ATTACHMENT0, 0);
    attach(gl, GL_DEPTH_STENCIL_ATTACHMENT, depth);
    gl.DrawBuffer(GL_NONE);
    gl.ReadBuffer(GL_NONE);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl.BlitFramebuffer(0, 0, 110, 140, 10, 100, 120, 240, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.Viewport(0, 0, kSize, kSize);
    pixel_projection(gl);
    gl.Enable(GL_DEPTH_TEST);
    gl.Color4f(0.8F, 0.8F, 0.2F, 1);
    rectangle(gl, 4, 96, 170, 250, -0.8F);
}

SCENE(fbo_blit,
      "blits scaled, mirrored, cut by scissor and edges, linear and nearest, of depth and stencil") {
    framebuffer(gl);
    attach(gl, GL_COLOR_ATTACHMENT0, renderbuffer(gl, GL_RGBA8, 80, 60));
    attach(gl, GL_DEPTH_STENCIL_ATTACHMENT, renderbuffer(gl, GL_DEPTH24_STENCIL8, 80, 60));
    gl.Viewport(0, 0, 80, 60);
    clear(gl, 0.3F, 0.4F, 0.2F);
    lit_torus(gl, 60);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilFunc(GL_ALWAYS, 5, 255);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    pixel_projection(gl, 80, 60);
    gl.Color4f(0.9F, 0.5F, 0.1F, 1);
    rectangle(gl, 20, 6, 41, 50, 0.25F);
    gl.Disable(GL_STENCIL_TEST);
    std::vector<std::uint8_t> pixels(80 * 60 * 4);
    gl.ReadPixels(0, 0, 80, 60, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    double sum = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) sum += pixels[i] * static_cast<double>(i % 83);
    notes.value("read back", sum, 400);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    constexpr GLbitfield kAll = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
    gl.BlitFramebuffer(0, 0, 80, 60, 4, 4, 84, 64, kAll, GL_NEAREST);
    gl.BlitFramebuffer(0, 0, 80, 60, 250, 4, 90, 124, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl.BlitFramebuffer(10, 10, 70, 50, 4, 250, 64, 210, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl.BlitFramebuffer(0, 0, 80, 60, 4, 130, 124, 190, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(140, 140, 60, 70);
    gl.BlitFramebuffer(0, 0, 80, 60, 130, 130, 290, 250, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl.BlitFramebuffer(0, 0, 80, 60, 0, 0, 10, 10, GL_DEPTH_BUFFER_BIT, GL_LINEAR);
    notes.value("depth is not filtered", gl.GetError());
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
}

SCENE(fbo_rules, "what is complete and what is not, errors, queries", .draws_nothing_visible = true) {
    GLint values[4] = {};
    gl.GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT,
                                           GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, values);
    gl.GetError();  // versions of GL differ about the window's
    notes.value("window", gl.CheckFramebufferStatus(GL_FRAMEBUFFER));
    const GLuint name = framebuffer(gl);
    notes.value("a frame buffer", gl.IsFramebuffer(name));
    notes.value("nothing attached", gl.CheckFramebufferStatus(GL_FRAMEBUFFER));
    gl.Begin(GL_TRIANGLES);
    notes.value("no drawing", gl.GetError());
    gl.Clear(GL_COLOR_BUFFER_BIT);
    notes.value("no clearing", gl.GetError());
    gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, values);
    notes.value("no reading", gl.GetError());
    gl.DrawBuffer(GL_FRONT);
    notes.value("not the window's", gl.GetError());
    attach(gl, GL_DEPTH_ATTACHMENT, renderbuffer(gl, GL_RGBA8, 8, 8));
    notes.value("colour is no depth", gl.CheckFramebufferStatus(GL_FRAMEBUFFER));
    const GLuint depth = renderbuffer(gl, GL_DEPTH24_STENCIL8, 8, 8);
    attach(gl, GL_DEPTH_STENCIL_ATTACHMENT, depth);
    notes.value("no colour to draw to", gl.CheckFramebufferStatus(GL_FRAMEBUFFER));
    const GLuint colour = renderbuffer(gl, GL_RGB, 8, 8);
    attach(gl, GL_COLOR_ATTACHMENT0, colour);
    notes.value("complete", gl.CheckFramebufferStatus(GL_FRAMEBUFFER));
    gl.GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                                           GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, values);
    gl.GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT,
                                           GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, values + 1);
    gl.GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH, values + 2);
    gl.GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_GREEN_SIZE, values + 3);
    notes.values("queries", values);
    gl.GetIntegerv(GL_DEPTH_BITS, values);
    gl.GetIntegerv(GL_STENCIL_BITS, values + 1);
    gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, values + 2);
    gl.GetIntegerv(GL_RENDERBUFFER_BINDING, values + 3);
    values[3] = values[3] == static_cast<GLint>(colour);
    notes.values("bits", values);
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_COLOR_INDEX, 8, 8);
    notes.value("no such format", gl.GetError());
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA, -1, 8);
    notes.value("negative", gl.GetError());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 77, 0);
    notes.value("no such texture", gl.GetError());
    gl.DeleteRenderbuffers(1, &colour);
    notes.value("deleted", gl.CheckFramebufferStatus(GL_FRAMEBUFFER));
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    notes.value("the window keeps its own", gl.GetError());
}
