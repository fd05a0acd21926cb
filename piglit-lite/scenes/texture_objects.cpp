// Chapter: texture objects, completeness, proxies and read-back of images (GL 1.5 §3.8.8-3.8.12, §6.1.4).
#include "helpers.h"

using namespace terrazzo::piglit;

SCENE(texobj_binding, "twelve objects, bound in turn between draws; deleting one brings the default back") {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_2D);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    GLuint names[12];
    for (int i = 0; i < 12; ++i)
        names[i] = painted_texture(gl, 8 << i % 4, 8 << i / 4, GL_NEAREST, i % 2 ? GL_LINEAR : GL_NEAREST,
                                   static_cast<std::uint32_t>(i));
    gl.BindTexture(GL_TEXTURE_2D, 0);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, painted_texels(4, 4).data());
    for_cells(4, 4, [&](int cell, float x, float y, float w, float h) {
        gl.BindTexture(GL_TEXTURE_2D, names[cell * 5 % 12]);
        if (cell == 12) gl.DeleteTextures(1, &names[0]);
        textured_rectangle(gl, x + 2, y + 2, x + w - 2, y + h - 2);
    });
    notes.value("deleted is a texture", gl.IsTexture(names[0]));
    notes.value("kept is a texture", gl.IsTexture(names[5]));
    GLint bound = 0;
    gl.BindTexture(GL_TEXTURE_2D, names[7]);
    gl.DeleteTextures(12, names);
    gl.GetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    notes.value("binding after its deletion", bound);
}

SCENE(texobj_one_dimensional, "1D textures, enabled together with 2D: the 2D one wins") {
    pixel_projection(gl);
    const auto texels = painted_texels(64, 1);
    gl.TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    gl.TexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    painted_texture(gl, 16, 16, GL_NEAREST, GL_NEAREST);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    for_cells(2, 2, [&](int cell, float x, float y, float w, float h) {
        if (cell & 1)
            gl.Enable(GL_TEXTURE_1D);
        else
            gl.Disable(GL_TEXTURE_1D);
        if (cell & 2)
            gl.Enable(GL_TEXTURE_2D);
        else
            gl.Disable(GL_TEXTURE_2D);
        gl.Color4fv(hue(0.3F).data());
        textured_rectangle(gl, x + 4, y + 4, x + w - 4, y + h - 4, 2, 1);
    });
}

SCENE(texobj_incomplete,
      "incomplete textures draw as if texturing were off; completing them brings them in") {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_2D);
    const auto texels = painted_texels(16, 16);
    for_cells(3, 2, [&](int cell, float x, float y, float w, float h) {
        GLuint name = 0;
        gl.GenTextures(1, &name);
        gl.BindTexture(GL_TEXTURE_2D, name);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        const auto image = [&](GLint level, GLsizei size) {
            gl.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                          texels.data());
        };
        if (cell >= 1) image(0, 16);
        if (cell >= 2) image(1, 8), image(2, 4);
        if (cell == 3) image(3, 2), image(4, 1);
        if (cell == 4) image(3, 4), image(4, 1);
        if (cell == 5) gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 2);
        gl.Color4fv(hue(static_cast<float>(cell) / 6).data());
        textured_rectangle(gl, x + 4, y + 4, x + w - 4, y + h - 4);
    });
}

SCENE(texobj_read_back,
      "GetTexImage in several formats and types, and the parameters of levels and objects") {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_2D);
    painted_texture(gl, 16, 8, GL_NEAREST, GL_NEAREST, 3);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    textured_rectangle(gl, 8, 8, 248, 248);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    GLubyte rgba[16 * 8 * 4], luminance[16 * 8];
    GLfloat rgb[16 * 8 * 3];
    GLushort packed[16 * 8];
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_UNSIGNED_BYTE, luminance);
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGB, GL_FLOAT, rgb);
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, packed);
    notes.values("RGBA", rgba);
    notes.values("RED", luminance);
    notes.values("RGB float", rgb, 1e-6);
    notes.values("5_6_5", packed);
    for (const GLenum parameter : {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_BORDER}) {
        GLint value = 0;
        gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, parameter, &value);
        notes.value("level " + std::to_string(parameter), value);
    }
    const GLfloat border[] = {0.1F, 0.2F, 2, -1};
    gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border);
    GLfloat got[4];
    gl.GetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, got);
    notes.values("border colour", got, 1e-6);
    for (const GLenum parameter :
         {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
        GLint value = 0;
        gl.GetTexParameteriv(GL_TEXTURE_2D, parameter, &value);
        notes.value("parameter " + std::to_string(parameter), value);
    }
}

SCENE(texobj_proxy_and_priority, "proxy queries, PrioritizeTextures and AreTexturesResident") {
    pixel_projection(gl);
    gl.TexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA8, 64, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    GLint width = -1;
    gl.GetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    notes.value("proxy that fits", width);
    gl.TexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA8, 1 << 16, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl.GetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    notes.value("proxy that does not fit", width);
    gl.TexImage1D(GL_PROXY_TEXTURE_1D, 0, GL_RGB, 128, 0, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
    gl.GetTexLevelParameteriv(GL_PROXY_TEXTURE_1D, 0, GL_TEXTURE_WIDTH, &width);
    notes.value("1D proxy", width);
    GLuint names[3];
    gl.GenTextures(3, names);
    for (const GLuint name : names) {
        gl.BindTexture(GL_TEXTURE_2D, name);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                      painted_texels(8, 8).data());
    }
    const GLclampf priorities[] = {0.25F, 2, -1};
    gl.PrioritizeTextures(3, names, priorities);
    for (const GLuint name : names) {
        gl.BindTexture(GL_TEXTURE_2D, name);
        GLfloat priority = -1;
        gl.GetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_PRIORITY, &priority);
        notes.value("priority", priority);
    }
    GLboolean resident[3] = {};
    notes.value("all resident", gl.AreTexturesResident(3, names, resident));
    gl.Enable(GL_TEXTURE_2D);
    textured_rectangle(gl, 20, 20, 236, 236);
}

SCENE(texobj_reshaped,
      "an image replaced by one of another size and format while earlier draws still use the old") {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_2D);
    painted_texture(gl, 16, 16, GL_NEAREST, GL_NEAREST, 0);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    for_cells(4, 2, [&](int cell, float x, float y, float w, float h) {
        const GLint formats[] = {GL_RGBA,    GL_RGB,   GL_LUMINANCE,       GL_INTENSITY,
                                 GL_RGB5_A1, GL_RGBA4, GL_LUMINANCE_ALPHA, GL_RGB};
        const int width = 4 << cell % 5, height = 32 >> cell % 4;
        gl.TexImage2D(GL_TEXTURE_2D, 0, formats[cell], width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                      painted_texels(width, height, static_cast<std::uint32_t>(cell)).data());
        textured_rectangle(gl, x + 3, y + 3, x + w - 3, y + h - 3);
    });
}
