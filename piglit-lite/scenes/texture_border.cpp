// Chapter: border colours (GL 1.5 §3.8.8): what a texture's base format leaves of them.
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

constexpr GLint kFormats[] = {GL_ALPHA4,
                              GL_ALPHA8,
                              GL_ALPHA16,
                              GL_LUMINANCE4,
                              GL_LUMINANCE8,
                              GL_LUMINANCE16,
                              GL_LUMINANCE4_ALPHA4,
                              GL_LUMINANCE8_ALPHA8,
                              GL_LUMINANCE16_ALPHA16,
                              GL_INTENSITY4,
                              GL_INTENSITY8,
                              GL_INTENSITY16,
                              GL_R3_G3_B2,
                              GL_RGB4,
                              GL_RGB5,
                              GL_RGB8,
                              GL_RGB10,
                              GL_RGB16,
                              GL_RGBA2,
                              GL_RGBA4,
                              GL_RGB5_A1,
                              GL_RGBA8,
                              GL_RGB10_A2,
                              GL_RGBA16};
constexpr int kColumns = 6, kRows = 4;
static_assert(std::size(kFormats) == kColumns * kRows);

constexpr GLfloat kBorder[4] = {0.2F, 0.4F, 0.6F, 0.8F};

void set_up(const Gl& gl, GLenum target, GLenum filter, GLenum wrap) {
    gl.Enable(target);
    for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        gl.TexParameteri(target, name, static_cast<GLint>(filter));
    for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        gl.TexParameteri(target, name, static_cast<GLint>(wrap));
    gl.TexParameterfv(target, GL_TEXTURE_BORDER_COLOR, kBorder);
}

// Half of the rectangle shows the border.
void surrounded_rectangle(const Gl& gl, float x, float y, float w, float h) {
    gl.Begin(GL_QUADS);
    for (const auto& [s, t] : {std::array{0.0F, 0.0F}, {1.0F, 0.0F}, {1.0F, 1.0F}, {0.0F, 1.0F}}) {
        gl.TexCoord3f(-0.5F + 2 * s, -0.5F + 2 * t, -0.2F + 1.4F * s);
        gl.Vertex2f(x + 1 + s * (w - 2), y + 1 + t * (h - 2));
    }
    gl.End();
}

void formats(const Gl& gl, GLenum filter, GLenum wrap, GLenum environment) {
    pixel_projection(gl);
    striped_backdrop(gl, 8);
    set_up(gl, GL_TEXTURE_2D, filter, wrap);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, static_cast<GLint>(environment));
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    const auto texels = painted_texels(8, 8);
    for_cells(kColumns, kRows, [&](int cell, float x, float y, float w, float h) {
        gl.TexImage2D(GL_TEXTURE_2D, 0, kFormats[cell], 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
        gl.Color4f(0.9F, 0.8F, 0.7F, 0.9F);
        surrounded_rectangle(gl, x, y, w, h);
    });
}

}  // namespace

SCENE(border_of_every_format, "CLAMP_TO_BORDER, REPLACE") {
    formats(gl, GL_NEAREST, GL_CLAMP_TO_BORDER, GL_REPLACE);
}

SCENE(border_of_every_format_mixed, "the same mixed with texels, MODULATE") {
    formats(gl, GL_LINEAR, GL_CLAMP_TO_BORDER, GL_MODULATE);
}

SCENE(border_of_every_format_clamped, "CLAMP, which mixes half of the border in, ADD") {
    formats(gl, GL_LINEAR, GL_CLAMP, GL_ADD);
}

SCENE(border_through_a_combiner, "what a combiner sees of a border's colour and alpha") {
    formats(gl, GL_LINEAR, GL_CLAMP_TO_BORDER, GL_COMBINE);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_INTERPOLATE);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_SRC2_RGB, GL_TEXTURE);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_OPERAND2_RGB, GL_ONE_MINUS_SRC_ALPHA);
    gl.Color4f(0.3F, 0.9F, 0.2F, 1);
    surrounded_rectangle(gl, 60, 60, 140, 140);
}

SCENE(border_of_other_images, "1D, 3D, S3TC, and colours beyond 0 and 1, which are clamped") {
    pixel_projection(gl);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    const auto texels = painted_texels(16, 8);
    const GLint few[] = {GL_ALPHA8, GL_LUMINANCE8, GL_LUMINANCE8_ALPHA8, GL_INTENSITY16, GL_RGB8, GL_RGBA8};
    const std::vector<std::uint8_t> blocks(64, 0x5A);
    for_cells(6, 4, [&](int cell, float x, float y, float w, float h) {
        const GLint format = few[cell % 6];
        const GLenum target = cell < 6 ? GL_TEXTURE_1D : cell < 12 ? GL_TEXTURE_3D : GL_TEXTURE_2D;
        set_up(gl, target, cell % 2 ? GL_LINEAR : GL_NEAREST, GL_CLAMP_TO_BORDER);
        if (cell >= 18) {
            const GLfloat beyond[4] = {1.7F, -0.4F, 0.5F, static_cast<float>(cell) - 20};
            gl.TexParameterfv(target, GL_TEXTURE_BORDER_COLOR, beyond);
        }
        if (target == GL_TEXTURE_1D)
            gl.TexImage1D(target, 0, format, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
        else if (target == GL_TEXTURE_3D)
            gl.TexImage3D(target, 0, format, 4, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
        else if (cell < 15)
            gl.CompressedTexImage2D(target, 0,
                                    cell == 12   ? GL_COMPRESSED_RGB_S3TC_DXT1_EXT
                                    : cell == 13 ? GL_COMPRESSED_RGBA_S3TC_DXT1_EXT
                                                 : GL_COMPRESSED_RGBA_S3TC_DXT5_EXT,
                                    8, 8, 0, cell == 14 ? 64 : 32, blocks.data());
        else
            gl.TexImage2D(target, 0, format, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
        surrounded_rectangle(gl, x, y, w, h);
        gl.Disable(target);
    });
}

SCENE(border_of_depth_textures, "each depth mode, with and without comparison, nearest and linear") {
    pixel_projection(gl);
    striped_backdrop(gl, 8);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    const GLenum modes[] = {GL_LUMINANCE, GL_INTENSITY, GL_ALPHA};
    std::vector<float> depths;
    for (int i = 0; i < 64; ++i) depths.push_back(static_cast<float>(i * 37 % 64) / 63);
    for_cells(3, 4, [&](int cell, float x, float y, float w, float h) {
        set_up(gl, GL_TEXTURE_2D, cell / 3 % 2 ? GL_LINEAR : GL_NEAREST, GL_CLAMP_TO_BORDER);
        gl.TexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, static_cast<GLint>(modes[cell % 3]));
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE,
                         cell < 6 ? GL_NONE : GL_COMPARE_R_TO_TEXTURE);
        gl.TexImage2D(GL_TEXTURE_2D, 0, cell % 2 ? GL_DEPTH_COMPONENT16 : GL_DEPTH_COMPONENT24, 8, 8, 0,
                      GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
        gl.Color4f(0.9F, 0.8F, 0.7F, 0.9F);
        surrounded_rectangle(gl, x, y, w, h);
    });
}
