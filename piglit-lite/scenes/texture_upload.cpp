// Chapter: texture images: formats, types, pixel store, sub-images, copies (GL 1.5 §3.6.3-3.6.4,
// §3.8.1-3.8.2).
#include <cstring>

#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

void nearest(const Gl& gl, GLenum target = GL_TEXTURE_2D) {
    gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

// Eight-by-eight images whose components are ramps of the type's whole range.
template <typename T>
std::vector<T> ramp(int components, double low, double high) {
    std::vector<T> values;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            for (int c = 0; c < components; ++c) {
                const double t = c == 0   ? x / 7.0
                                 : c == 1 ? y / 7.0
                                 : c == 2 ? (14 - x - y) / 14.0
                                          : (x + 8) / 15.0;
                values.push_back(static_cast<T>(low + (high - low) * t));
            }
    return values;
}

std::vector<std::uint8_t> typed_ramp(GLenum format, GLenum type) {
    const int n = component_count(format);
    const auto bytes = [](const auto& values) {
        std::vector<std::uint8_t> result(values.size() * sizeof values[0]);
        std::memcpy(result.data(), values.data(), result.size());
        return result;
    };
    switch (type) {
        case GL_UNSIGNED_BYTE:
            return bytes(ramp<GLubyte>(n, 0, 255));
        case GL_BYTE:
            return bytes(ramp<GLbyte>(n, -20, 127));
        case GL_UNSIGNED_SHORT:
            return bytes(ramp<GLushort>(n, 0, 65535));
        case GL_SHORT:
            return bytes(ramp<GLshort>(n, -3000, 32767));
        case GL_UNSIGNED_INT:
            return bytes(ramp<GLuint>(n, 0, 4294967295.0));
        case GL_INT:
            return bytes(ramp<GLint>(n, -1e8, 2147483647.0));
        default:
            return bytes(ramp<GLfloat>(n, -0.1, 1.1));
    }
}

void show_over_dark_and_light(const Gl& gl, float x, float y, float w, float h) {
    // Alpha shows by blending over a two-tone ground.
    gl.Disable(GL_TEXTURE_2D);
    gl.Color3f(0.2F, 0.2F, 0.2F);
    rectangle(gl, x, y, x + w / 2, y + h);
    gl.Color3f(0.9F, 0.9F, 0.9F);
    rectangle(gl, x + w / 2, y, x + w, y + h);
    gl.Enable(GL_TEXTURE_2D);
    gl.Color4f(1, 1, 1, 1);
    textured_rectangle(gl, x + 1, y + 1, x + w - 1, y + h - 1);
}

void begin_swatches(const Gl& gl) {
    pixel_projection(gl);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.Enable(GL_TEXTURE_2D);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    nearest(gl);
}

}  // namespace

SCENE(upload_formats_by_types, "ten client formats in seven component types, each a swatch") {
    begin_swatches(gl);
    const GLenum formats[] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA,
                              GL_RGB, GL_RGBA,  GL_BGR,  GL_BGRA};
    const GLenum types[] = {GL_UNSIGNED_BYTE, GL_BYTE, GL_UNSIGNED_SHORT, GL_SHORT,
                            GL_UNSIGNED_INT,  GL_INT,  GL_FLOAT};
    for_cells(10, 7, [&](int cell, float x, float y, float w, float h) {
        const GLenum format = formats[cell % 10], type = types[cell / 10];
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, format, type, typed_ramp(format, type).data());
        show_over_dark_and_light(gl, x, y, w, h);
    });
}

SCENE(upload_packed_types, "the twelve packed pixel types of GL 1.2, with RGB, RGBA and BGRA order") {
    begin_swatches(gl);
    const struct {
        GLenum type, format;
        int bytes;
    } packed[] = {{GL_UNSIGNED_BYTE_3_3_2, GL_RGB, 1},      {GL_UNSIGNED_BYTE_2_3_3_REV, GL_RGB, 1},
                  {GL_UNSIGNED_SHORT_5_6_5, GL_RGB, 2},     {GL_UNSIGNED_SHORT_5_6_5_REV, GL_RGB, 2},
                  {GL_UNSIGNED_SHORT_4_4_4_4, GL_RGBA, 2},  {GL_UNSIGNED_SHORT_4_4_4_4_REV, GL_RGBA, 2},
                  {GL_UNSIGNED_SHORT_5_5_5_1, GL_RGBA, 2},  {GL_UNSIGNED_SHORT_1_5_5_5_REV, GL_RGBA, 2},
                  {GL_UNSIGNED_INT_8_8_8_8, GL_RGBA, 4},    {GL_UNSIGNED_INT_8_8_8_8_REV, GL_RGBA, 4},
                  {GL_UNSIGNED_INT_10_10_10_2, GL_RGBA, 4}, {GL_UNSIGNED_INT_2_10_10_10_REV, GL_RGBA, 4},
                  {GL_UNSIGNED_SHORT_4_4_4_4, GL_BGRA, 2},  {GL_UNSIGNED_SHORT_1_5_5_5_REV, GL_BGRA, 2},
                  {GL_UNSIGNED_INT_8_8_8_8, GL_BGRA, 4},    {GL_UNSIGNED_INT_8_8_8_8_REV, GL_BGRA, 4}};
    std::vector<GLubyte> bits;
    Random random(42);
    for (int i = 0; i < 8 * 8 * 4; ++i) bits.push_back(static_cast<GLubyte>(random.bits() >> 13));
    for_cells(4, 4, [&](int cell, float x, float y, float w, float h) {
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, packed[cell].format, packed[cell].type,
                      bits.data());
        show_over_dark_and_light(gl, x, y, w, h);
    });
}

SCENE(upload_internal_formats,
      "the 38 internal formats of 1.1 and component counts 1 to 4, and what each keeps") {
    begin_swatches(gl);
    const GLint formats[] = {1,
                             2,
                             3,
                             4,
                             GL_ALPHA,
                             GL_ALPHA4,
                             GL_ALPHA8,
                             GL_ALPHA12,
                             GL_ALPHA16,
                             GL_LUMINANCE,
                             GL_LUMINANCE4,
                             GL_LUMINANCE8,
                             GL_LUMINANCE12,
                             GL_LUMINANCE16,
                             GL_LUMINANCE_ALPHA,
                             GL_LUMINANCE4_ALPHA4,
                             GL_LUMINANCE6_ALPHA2,
                             GL_LUMINANCE8_ALPHA8,
                             GL_LUMINANCE12_ALPHA4,
                             GL_LUMINANCE12_ALPHA12,
                             GL_LUMINANCE16_ALPHA16,
                             GL_INTENSITY,
                             GL_INTENSITY4,
                             GL_INTENSITY8,
                             GL_INTENSITY12,
                             GL_INTENSITY16,
                             GL_R3_G3_B2,
                             GL_RGB,
                             GL_RGB4,
                             GL_RGB5,
                             GL_RGB8,
                             GL_RGB10,
                             GL_RGB12,
                             GL_RGB16,
                             GL_RGBA,
                             GL_RGBA2,
                             GL_RGBA4,
                             GL_RGB5_A1,
                             GL_RGBA8,
                             GL_RGB10_A2,
                             GL_RGBA12,
                             GL_RGBA16};
    const auto texels = typed_ramp(GL_RGBA, GL_FLOAT);
    for_cells(7, 6, [&](int cell, float x, float y, float w, float h) {
        gl.TexImage2D(GL_TEXTURE_2D, 0, formats[cell], 8, 8, 0, GL_RGBA, GL_FLOAT, texels.data());
        show_over_dark_and_light(gl, x, y, w, h);
        // Which components there are is the format's definition; how many bits they have is the library's
        // choice.
        const GLenum sizes[] = {GL_TEXTURE_RED_SIZE,   GL_TEXTURE_GREEN_SIZE,     GL_TEXTURE_BLUE_SIZE,
                                GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_LUMINANCE_SIZE, GL_TEXTURE_INTENSITY_SIZE};
        for (const GLenum size : sizes) {
            GLint value = 0;
            gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, size, &value);
            notes.value("format " + std::to_string(formats[cell]) + " size " + std::to_string(size),
                        value > 0);
        }
    });
}

SCENE(upload_pixel_store, "row length, skips, alignments and byte swapping, cut out of one large image") {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_2D);
    nearest(gl);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    const auto image = painted_texels(61, 50);
    std::vector<GLushort> shorts;
    for (int i = 0; i < 3 * 40 * 40; ++i) shorts.push_back(static_cast<GLushort>(i * 1021));
    for_cells(4, 3, [&](int cell, float x, float y, float w, float h) {
        gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1 << cell % 4);
        gl.PixelStorei(GL_UNPACK_ROW_LENGTH, cell < 4 || cell >= 8 ? 0 : 61);
        gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, cell < 4 || cell >= 8 ? 0 : cell * 2);
        gl.PixelStorei(GL_UNPACK_SKIP_ROWS, cell < 4 || cell >= 8 ? 0 : cell);
        // Swapping with skips reads uninitialised memory in Mesa 22.3, so it has cells of its own.
        gl.PixelStorei(GL_UNPACK_SWAP_BYTES, cell >= 8);
        if (cell >= 8)
            gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 16, 16, 0, GL_RGB, GL_UNSIGNED_SHORT, shorts.data());
        else if (cell >= 4)
            gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
        else  // rows of 15 bytes, padded to the alignment
            gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 5, 16, 0, GL_RGB, GL_UNSIGNED_BYTE, image.data() + 8);
        textured_rectangle(gl, x + 3, y + 3, x + w - 3, y + h - 3);
    });
}

SCENE(upload_sub_images,
      "TexSubImage2D and 1D patches over a whole image, between draws of the same texture") {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_2D);
    painted_texture(gl, 64, 64, GL_NEAREST, GL_NEAREST);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    const auto patch = painted_texels(24, 20, 9);
    for_cells(3, 3, [&](int cell, float x, float y, float w, float h) {
        // Each draw must use the texels of its own time.
        if (cell > 0)
            gl.TexSubImage2D(GL_TEXTURE_2D, 0, cell * 5 - 3, 60 - cell * 6, 12 + cell, 10, GL_RGBA,
                             GL_UNSIGNED_BYTE, patch.data() + cell * 16);
        textured_rectangle(gl, x + 2, y + 2, x + w - 2, y + h - 2);
    });
    gl.Disable(GL_TEXTURE_2D);
    gl.Enable(GL_TEXTURE_1D);
    nearest(gl, GL_TEXTURE_1D);
    gl.TexImage1D(GL_TEXTURE_1D, 0, GL_RGB, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, patch.data());
    gl.TexSubImage1D(GL_TEXTURE_1D, 0, 10, 9, GL_RGBA, GL_UNSIGNED_BYTE, patch.data() + 400);
    textured_rectangle(gl, 100, 100, 156, 156);
}

SCENE(upload_copies, "CopyTexImage and CopyTexSubImage from what was drawn, and on over the window's edge") {
    pixel_projection(gl);
    striped_backdrop(gl, 16);
    gl.Begin(GL_TRIANGLES);
    for (int i = 0; i < 12; ++i) {
        gl.Color4fv(hue(static_cast<float>(i) / 12 + 0.3F).data());
        gl.Vertex2f(static_cast<float>(i * 91 % 256), static_cast<float>(i * 57 % 256));
    }
    gl.End();
    gl.Enable(GL_TEXTURE_2D);
    nearest(gl);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 10, 20, 64, 32, 0);
    textured_rectangle(gl, 8, 180, 120, 248);
    gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 60, 60, 64, 64, 0);
    textured_rectangle(gl, 136, 180, 248, 248);
    gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 8, 8, 150, 190, 40, 48);
    textured_rectangle(gl, 8, 100, 120, 170);
    GLubyte blank[32 * 32 * 4];
    std::memset(blank, 90, sizeof blank);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB5, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, blank);
    gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 230, 100, 24, 24);
    textured_rectangle(gl, 136, 100, 248, 170);
    gl.Disable(GL_TEXTURE_2D);
    gl.Enable(GL_TEXTURE_1D);
    nearest(gl, GL_TEXTURE_1D);
    gl.CopyTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 0, 130, 128, 0);
    gl.CopyTexSubImage1D(GL_TEXTURE_1D, 0, 16, 20, 20, 64);
    textured_rectangle(gl, 8, 8, 248, 40);
}

SCENE(upload_borders, "one-texel borders with CLAMP, in colour and in one dimension") {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_2D);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    const auto texels = painted_texels(18, 18, 4);
    for_cells(2, 2, [&](int cell, float x, float y, float w, float h) {
        const GLint filter = cell % 2 ? GL_LINEAR : GL_NEAREST, wrap = cell / 2 ? GL_CLAMP : GL_REPEAT;
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 18, 18, 1, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
        gl.MatrixMode(GL_TEXTURE);
        gl.LoadIdentity();
        gl.Translatef(-0.25F, -0.25F, 0);
        textured_rectangle(gl, x + 3, y + 3, x + w - 3, y + h - 3, 1.5F, 1.5F);
    });
    // GL_TEXTURE_BORDER is not noted: Mesa strips borders and answers 0, ours keeps what the specification
    // keeps.
}

SCENE(upload_pixel_transfer, "scale, bias and maps applied while a texture is unpacked") {
    pixel_projection(gl);
    gl.Enable(GL_TEXTURE_2D);
    nearest(gl);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    const auto texels = painted_texels(16, 16);
    GLfloat inverse[16], steps[8];
    for (int i = 0; i < 16; ++i) inverse[i] = 1 - static_cast<float>(i) / 15;
    for (int i = 0; i < 8; ++i) steps[i] = static_cast<float>(i / 2) / 3;
    for_cells(2, 2, [&](int cell, float x, float y, float w, float h) {
        gl.PixelTransferf(GL_RED_SCALE, cell == 1 ? 0.5F : 1);
        gl.PixelTransferf(GL_RED_BIAS, cell == 1 ? 0.3F : 0);
        gl.PixelTransferf(GL_BLUE_SCALE, cell == 1 ? -1.0F : 1);
        gl.PixelTransferf(GL_BLUE_BIAS, cell == 1 ? 1.0F : 0);
        gl.PixelTransferi(GL_MAP_COLOR, cell >= 2);
        gl.PixelMapfv(GL_PIXEL_MAP_R_TO_R, 16, inverse);
        gl.PixelMapfv(GL_PIXEL_MAP_G_TO_G, 8, steps);
        gl.PixelMapfv(GL_PIXEL_MAP_B_TO_B, 8, cell == 2 ? steps : inverse);
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
        textured_rectangle(gl, x + 3, y + 3, x + w - 3, y + h - 3);
    });
}
