// Frame buffer objects: renderbuffers, textures of every kind, blits, samples.
#include "program.h"

namespace terrazzo::test {
namespace {

void read_bytes(Run& r, std::size_t result) {
    std::vector<GLubyte> bytes(4 * 16 * 16);
    r.gl.ReadPixels(0, 0, 16, 16, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    r.results[result].assign(bytes.begin(), bytes.end());
}

Program renderbuffers() {
    return {"Renderbuffers",
            {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)),
             TERRAZZO_BLOCK("triangle", draw_triangle(gl);),
             TERRAZZO_CALL(gl.GenFramebuffers(2, r.names.data())),
             TERRAZZO_CALL(gl.BindFramebuffer(GL_FRAMEBUFFER, r.names[0])),
             TERRAZZO_CALL(gl.GenRenderbuffers(2, r.names.data() + 2)),
             TERRAZZO_CALL(gl.BindRenderbuffer(GL_RENDERBUFFER, r.names[2])),
             TERRAZZO_CALL(gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 30, 20)),
             TERRAZZO_CALL(gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                                      r.names[2])),
             TERRAZZO_CALL(gl.BindRenderbuffer(GL_RENDERBUFFER, 7)),
             TERRAZZO_CALL(gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, 30, 20)),
             TERRAZZO_CALL(
                 gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, 7)),
             TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT)),
             TERRAZZO_CALL(gl.Enable(GL_DEPTH_TEST)),
             TERRAZZO_BLOCK("triangle", draw_triangle(gl);),
             TERRAZZO_CALL(gl.Rectf(-0.5f, -0.2f, 0.1f, 0.4f)),
             TERRAZZO_CALL(read_bytes(r, 0)),
             TERRAZZO_CALL(gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0)),
             TERRAZZO_CALL(gl.BlitFramebuffer(0, 0, 30, 20, 4, 4, 34, 24, GL_COLOR_BUFFER_BIT, GL_NEAREST)),
             TERRAZZO_CALL(gl.BlitFramebuffer(0, 0, 30, 20, 46, 2, 20, 38, GL_COLOR_BUFFER_BIT, GL_LINEAR)),
             TERRAZZO_CALL(gl.BlitFramebuffer(0, 0, 20, 20, 20, 10, 40, 30, GL_DEPTH_BUFFER_BIT, GL_NEAREST)),
             TERRAZZO_CALL(gl.BindFramebuffer(GL_FRAMEBUFFER, r.names[0])),
             TERRAZZO_CALL(gl.Rectf(-1, -1, 0, 0)),
             TERRAZZO_CALL(gl.DeleteFramebuffers(2, r.names.data())),
             TERRAZZO_CALL(gl.DeleteRenderbuffers(2, r.names.data() + 2)),
             TERRAZZO_CALL(gl.Finish())}};
}

Program samples() {
    return {
        "Multisampling",
        {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)), TERRAZZO_CALL(gl.BindFramebuffer(GL_FRAMEBUFFER, 1)),
         TERRAZZO_CALL(gl.BindRenderbuffer(GL_RENDERBUFFER, 1)),
         TERRAZZO_CALL(gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, 4, GL_RGBA8, 40, 30)),
         TERRAZZO_CALL(gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, 1)),
         TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)), TERRAZZO_BLOCK("triangle", draw_triangle(gl);),
         TERRAZZO_CALL(gl.Enable(GL_SAMPLE_COVERAGE)), TERRAZZO_CALL(gl.SampleCoverage(0.5f, 0)),
         TERRAZZO_CALL(gl.Rectf(-0.2f, -0.9f, 0.3f, 0.6f)),
         TERRAZZO_CALL(gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0)),
         TERRAZZO_CALL(gl.BlitFramebuffer(0, 0, 40, 30, 0, 0, 40, 30, GL_COLOR_BUFFER_BIT, GL_NEAREST)),
         TERRAZZO_CALL(gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0)), TERRAZZO_CALL(gl.Finish())}};
}

Program textures() {
    return {
        "AttachedTextures",
        {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)),
         TERRAZZO_CALL(gl.BindTexture(GL_TEXTURE_2D, 1)),
         TERRAZZO_CALL(gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR)),
         TERRAZZO_CALL(
             gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr)),
         TERRAZZO_CALL(gl.Enable(GL_TEXTURE_2D)),
         TERRAZZO_BLOCK("quad", draw_textured(gl);),  // which holds the image while it waits
         TERRAZZO_CALL(gl.BindFramebuffer(GL_FRAMEBUFFER, 3)),
         TERRAZZO_CALL(gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 1, 0)),
         TERRAZZO_CALL(gl.BindTexture(GL_TEXTURE_2D, 2)),
         TERRAZZO_CALL(gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, 16, 16, 0, GL_DEPTH_STENCIL,
                                     GL_UNSIGNED_INT_24_8, nullptr)),
         TERRAZZO_CALL(
             gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, 2, 0)),
         TERRAZZO_CALL(gl.Disable(GL_TEXTURE_2D)),
         TERRAZZO_CALL(gl.ClearColor(0.2f, 0.4f, 0.6f, 1)),
         TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)),
         TERRAZZO_CALL(gl.Enable(GL_DEPTH_TEST)),
         TERRAZZO_BLOCK("triangle", draw_triangle(gl);),
         TERRAZZO_CALL(gl.Flush()),
         TERRAZZO_CALL(gl.BindFramebuffer(GL_FRAMEBUFFER, 4)),
         TERRAZZO_CALL(gl.BindFramebuffer(GL_FRAMEBUFFER, 0)),
         TERRAZZO_CALL(gl.Disable(GL_DEPTH_TEST)),
         TERRAZZO_CALL(gl.BindTexture(GL_TEXTURE_2D, 1)),
         TERRAZZO_CALL(gl.Enable(GL_TEXTURE_2D)),
         TERRAZZO_BLOCK("quad", draw_textured(gl);),
         TERRAZZO_CALL(gl.BindFramebuffer(GL_FRAMEBUFFER, 3)),
         TERRAZZO_CALL(gl.Disable(GL_TEXTURE_2D)),
         TERRAZZO_CALL(gl.Rectf(-0.5f, -0.5f, 0.5f, 0)),
         TERRAZZO_CALL(gl.GenerateMipmap(GL_TEXTURE_2D)),
         TERRAZZO_CALL(gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 8, 0, 0, 8, 8)),
         TERRAZZO_CALL(const GLuint name = 3; gl.DeleteFramebuffers(1, &name)),
         TERRAZZO_CALL(gl.Finish())}};
}

Program slices() {
    return {
        "AttachedSlices",
        {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)), TERRAZZO_CALL(gl.BindTexture(GL_TEXTURE_3D, 1)),
         TERRAZZO_CALL(gl.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_NEAREST)),
         TERRAZZO_CALL(
             gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RGB10, 8, 8, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, nullptr)),
         TERRAZZO_CALL(gl.BindFramebuffer(GL_FRAMEBUFFER, 2)),
         TERRAZZO_CALL(gl.FramebufferTexture3D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_3D, 1, 0, 1)),
         TERRAZZO_CALL(gl.ClearColor(1, 0.5f, 0, 1)), TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)),
         TERRAZZO_CALL(gl.FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, 1, 0, 2)),
         TERRAZZO_BLOCK("triangle", draw_triangle(gl);),
         TERRAZZO_CALL(gl.BindTexture(GL_TEXTURE_CUBE_MAP, 5)),
         TERRAZZO_BLOCK("faces", for (GLenum face = 0; face < 6; ++face)
                                     gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA, 8, 8, 0,
                                                   GL_RGBA, GL_UNSIGNED_BYTE, nullptr);),
         TERRAZZO_CALL(gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                                               GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, 5, 0)),
         TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)), TERRAZZO_CALL(gl.BindFramebuffer(GL_FRAMEBUFFER, 0)),
         TERRAZZO_CALL(gl.Enable(GL_TEXTURE_3D)), TERRAZZO_BLOCK("quad", draw_textured(gl);),
         TERRAZZO_CALL(gl.Finish())}};
}

}  // namespace

std::vector<Program> object_programs() {
    return {renderbuffers(), samples(), textures(), slices()};
}

}  // namespace terrazzo::test
