// Textures of all kinds: uploads, parts, copies, mipmaps, compressed blocks.
#include "program.h"

namespace terrazzo::test {
namespace {

std::vector<GLubyte> texels(std::size_t count, unsigned salt = 0) {
    std::vector<GLubyte> out(count);
    for (std::size_t i = 0; i < count; ++i)
        out[i] = static_cast<GLubyte>((i * 2654435761u + salt * 40503u) >> 13);
    return out;
}

void parameters(const kit::Gl& gl, GLenum target, GLint min_filter) {
    gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, min_filter);
    gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

Program images() {
    return {"Textures2D",
            {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)), TERRAZZO_CALL(gl.GenTextures(3, r.names.data())),
             TERRAZZO_CALL(gl.BindTexture(GL_TEXTURE_2D, r.names[0])),
             TERRAZZO_BLOCK("parameters", parameters(gl, GL_TEXTURE_2D, GL_NEAREST);),
             TERRAZZO_CALL(gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                                         texels(1024).data())),
             TERRAZZO_CALL(gl.Enable(GL_TEXTURE_2D)), TERRAZZO_BLOCK("quad", draw_textured(gl);),
             TERRAZZO_CALL(gl.TexSubImage2D(GL_TEXTURE_2D, 0, 3, 4, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE,
                                            texels(256, 1).data())),
             TERRAZZO_CALL(gl.Translatef(0.5f, 0.2f, 0)), TERRAZZO_BLOCK("quad", draw_textured(gl);),
             TERRAZZO_CALL(gl.BindTexture(GL_TEXTURE_2D, 7)),
             TERRAZZO_BLOCK("parameters", parameters(gl, GL_TEXTURE_2D, GL_LINEAR);),
             TERRAZZO_CALL(gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB10, 8, 8, 0, GL_RGB, GL_FLOAT,
                                         std::vector<GLfloat>(192, 0.3f).data())),
             TERRAZZO_CALL(gl.TexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE12_ALPHA4, 4, 4, 0, GL_RGBA,
                                         GL_UNSIGNED_BYTE, texels(64, 2).data())),
             TERRAZZO_CALL(gl.Translatef(-0.9f, 0.2f, 0)), TERRAZZO_BLOCK("quad", draw_textured(gl);),
             TERRAZZO_CALL(gl.DeleteTextures(3, r.names.data())), TERRAZZO_CALL(gl.Finish())}};
}

Program mipmaps() {
    return {"Mipmaps",
            {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)),
             TERRAZZO_CALL(gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, 1)),
             TERRAZZO_CALL(gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 32, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                                         texels(2048).data())),
             TERRAZZO_CALL(gl.Enable(GL_TEXTURE_2D)), TERRAZZO_BLOCK("quad", draw_textured(gl);),
             TERRAZZO_CALL(gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 16, 16, GL_RGBA, GL_UNSIGNED_BYTE,
                                            texels(1024, 1).data())),
             TERRAZZO_CALL(gl.Scalef(0.4f, 0.4f, 1)), TERRAZZO_BLOCK("quad", draw_textured(gl);),
             TERRAZZO_CALL(gl.Finish()),
             // The image is nobody else's: it is filled anew.
             TERRAZZO_CALL(gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 32, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                                         texels(2048, 5).data())),
             TERRAZZO_CALL(gl.Translatef(1, 1, 0)), TERRAZZO_BLOCK("quad", draw_textured(gl);),
             TERRAZZO_CALL(gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 2, 2, 5, 5, 20, 10)),
             TERRAZZO_CALL(gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, 0)),
             TERRAZZO_CALL(gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                                         texels(256, 3).data())),
             TERRAZZO_CALL(gl.GenerateMipmap(GL_TEXTURE_2D)), TERRAZZO_CALL(gl.Translatef(-1, 1, 0)),
             TERRAZZO_BLOCK("quad", draw_textured(gl);), TERRAZZO_CALL(gl.Finish())}};
}

Program solids() {
    return {"Textures1D3DAndCubes",
            {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)),
             TERRAZZO_CALL(gl.BindTexture(GL_TEXTURE_3D, 3)),
             TERRAZZO_BLOCK("parameters", parameters(gl, GL_TEXTURE_3D, GL_LINEAR);),
             TERRAZZO_CALL(gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 4, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                                         texels(256).data())),
             TERRAZZO_CALL(gl.Enable(GL_TEXTURE_3D)),
             TERRAZZO_BLOCK("quad", draw_textured(gl);),
             TERRAZZO_CALL(gl.TexSubImage3D(GL_TEXTURE_3D, 0, 1, 1, 1, 2, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE,
                                            texels(32, 1).data())),
             TERRAZZO_CALL(gl.CopyTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 2, 4, 4, 4, 4)),
             TERRAZZO_CALL(gl.Disable(GL_TEXTURE_3D)),
             TERRAZZO_CALL(gl.BindTexture(GL_TEXTURE_CUBE_MAP, 4)),
             TERRAZZO_CALL(
                 gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST)),
             TERRAZZO_BLOCK("faces", for (GLenum face = 0; face < 6; ++face) gl.TexImage2D(
                                         GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGB, 8, 8, 0, GL_RGB,
                                         GL_UNSIGNED_BYTE, texels(192, face).data());),
             TERRAZZO_CALL(gl.GenerateMipmap(GL_TEXTURE_CUBE_MAP)),
             TERRAZZO_CALL(gl.Enable(GL_TEXTURE_CUBE_MAP)),
             TERRAZZO_CALL(gl.Scalef(0.6f, 0.6f, 1)),
             TERRAZZO_BLOCK("quad", draw_textured(gl);),
             TERRAZZO_CALL(gl.Disable(GL_TEXTURE_CUBE_MAP)),
             TERRAZZO_CALL(gl.TexImage1D(GL_TEXTURE_1D, 0, GL_INTENSITY, 16, 0, GL_LUMINANCE,
                                         GL_UNSIGNED_BYTE, texels(16).data())),
             TERRAZZO_BLOCK("parameters", parameters(gl, GL_TEXTURE_1D, GL_NEAREST);),
             TERRAZZO_CALL(gl.Enable(GL_TEXTURE_1D)),
             TERRAZZO_CALL(gl.CopyTexImage1D(GL_TEXTURE_1D, 0, GL_RGB, 2, 20, 32, 0)),
             TERRAZZO_CALL(gl.Translatef(0.5f, 0.5f, 0)),
             TERRAZZO_BLOCK("quad", draw_textured(gl);),
             TERRAZZO_CALL(gl.Finish())}};
}

Program compressed() {
    return {"CompressedTextures",
            {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)),
             TERRAZZO_BLOCK("parameters", parameters(gl, GL_TEXTURE_2D, GL_NEAREST);),
             TERRAZZO_CALL(gl.CompressedTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 16, 16,
                                                   0, 128, texels(128).data())),
             TERRAZZO_CALL(gl.Enable(GL_TEXTURE_2D)), TERRAZZO_BLOCK("quad", draw_textured(gl);),
             TERRAZZO_CALL(gl.CompressedTexSubImage2D(
                 GL_TEXTURE_2D, 0, 4, 8, 8, 4, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 16, texels(16, 1).data())),
             TERRAZZO_CALL(gl.Scalef(0.6f, 0.7f, 1)), TERRAZZO_BLOCK("quad", draw_textured(gl);),
             TERRAZZO_CALL(gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, 1)),
             TERRAZZO_CALL(gl.CompressedTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 8, 8,
                                                   0, 64, texels(64, 2).data())),
             TERRAZZO_BLOCK("quad", draw_textured(gl);),
             TERRAZZO_CALL(gl.CompressedTexSubImage2D(
                 GL_TEXTURE_2D, 0, 0, 0, 4, 4, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 16, texels(16, 3).data())),
             TERRAZZO_CALL(gl.TexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE,
                                            texels(64, 4).data())),
             TERRAZZO_CALL(gl.Scalef(0.4f, 0.3f, 1)), TERRAZZO_BLOCK("quad", draw_textured(gl);),
             TERRAZZO_CALL(gl.Finish())}};
}

Program depths() {
    return {"DepthTexturesAndCopies",
            {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)),
             TERRAZZO_CALL(gl.Enable(GL_DEPTH_TEST)), TERRAZZO_BLOCK("triangle", draw_triangle(gl);),
             TERRAZZO_BLOCK("parameters", parameters(gl, GL_TEXTURE_2D, GL_NEAREST);),
             TERRAZZO_CALL(gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 3, 4, 16, 16, 0)),
             TERRAZZO_CALL(gl.Enable(GL_TEXTURE_2D)), TERRAZZO_CALL(gl.Scalef(0.5f, 0.5f, 1)),
             TERRAZZO_BLOCK("quad", draw_textured(gl);),
             TERRAZZO_CALL(gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, 8, 8, 0, GL_DEPTH_STENCIL,
                                         GL_UNSIGNED_INT_24_8, texels(256).data())),
             TERRAZZO_CALL(gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, GL_DEPTH_STENCIL,
                                            GL_UNSIGNED_INT_24_8, texels(64, 1).data())),
             TERRAZZO_CALL(gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE)),
             TERRAZZO_CALL(gl.Translatef(0.8f, 0.8f, -0.5f)), TERRAZZO_BLOCK("quad", draw_textured(gl);),
             TERRAZZO_CALL(gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB5_A1, 0, 0, 32, 32, 0)),
             TERRAZZO_CALL(gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_NONE)),
             TERRAZZO_CALL(gl.Translatef(-1.8f, 0, 0)), TERRAZZO_BLOCK("quad", draw_textured(gl);),
             TERRAZZO_CALL(gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 9, 9, 20, 12, 8, 8)),
             TERRAZZO_CALL(gl.Finish())}};
}

// Images and targets that are mapped instead of allocated.
Program large() {
    return {"LargeTextures",
            {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)),
             TERRAZZO_BLOCK("parameters", parameters(gl, GL_TEXTURE_2D, GL_NEAREST);),
             TERRAZZO_CALL(
                 gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1024, 512, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr)),
             TERRAZZO_CALL(gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 64, 64, GL_RGBA, GL_UNSIGNED_BYTE,
                                            texels(16384).data())),
             TERRAZZO_CALL(gl.Enable(GL_TEXTURE_2D)), TERRAZZO_BLOCK("quad", draw_textured(gl);),
             TERRAZZO_CALL(gl.TexSubImage2D(GL_TEXTURE_2D, 0, 512, 256, 64, 64, GL_RGBA, GL_UNSIGNED_BYTE,
                                            texels(16384, 1).data())),
             TERRAZZO_CALL(gl.Scalef(0.5f, 0.5f, 1)), TERRAZZO_BLOCK("quad", draw_textured(gl);),
             TERRAZZO_CALL(gl.Finish())}};
}

Program units() {
    return {"TextureUnits",
            {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)),
             TERRAZZO_BLOCK("unit 0", parameters(gl, GL_TEXTURE_2D, GL_LINEAR); gl.TexImage2D(
                 GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels(256).data());
                            gl.Enable(GL_TEXTURE_2D);),
             TERRAZZO_CALL(gl.ActiveTexture(GL_TEXTURE1)), TERRAZZO_CALL(gl.BindTexture(GL_TEXTURE_2D, 2)),
             TERRAZZO_BLOCK("unit 1", parameters(gl, GL_TEXTURE_2D, GL_LINEAR); gl.TexImage2D(
                 GL_TEXTURE_2D, 0, GL_RGB, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels(64, 1).data());
                            gl.Enable(GL_TEXTURE_2D);),
             TERRAZZO_CALL(gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE)),
             TERRAZZO_CALL(gl.TexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_ADD_SIGNED)),
             TERRAZZO_CALL(gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR)),
             TERRAZZO_CALL(gl.Enable(GL_TEXTURE_GEN_S)), TERRAZZO_BLOCK("quad", draw_textured(gl);),
             TERRAZZO_CALL(gl.PushAttrib(GL_TEXTURE_BIT)), TERRAZZO_CALL(gl.BindTexture(GL_TEXTURE_2D, 0)),
             TERRAZZO_CALL(gl.PopAttrib()), TERRAZZO_CALL(gl.MultiTexCoord2f(GL_TEXTURE1, 0.3f, 0.7f)),
             TERRAZZO_CALL(gl.Scalef(0.5f, 0.5f, 1)), TERRAZZO_BLOCK("quad", draw_textured(gl);),
             TERRAZZO_CALL(gl.Finish())}};
}

}  // namespace

std::vector<Program> texture_programs() {
    return {images(), mipmaps(), solids(), compressed(), depths(), large(), units()};
}

}  // namespace terrazzo::test
