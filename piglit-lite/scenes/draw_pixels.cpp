// Chapter: pixel rectangles from client memory (GL 1.5 §3.6.4, §3.6.5).
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

struct Type {
    GLenum type;
    int bytes;       // of a component or of a packed pixel
    int components;  // of a packed pixel, else 0
};
constexpr Type kTypes[] = {
    {GL_UNSIGNED_BYTE, 1, 0},
    {GL_BYTE, 1, 0},
    {GL_UNSIGNED_SHORT, 2, 0},
    {GL_SHORT, 2, 0},
    {GL_UNSIGNED_INT, 4, 0},
    {GL_INT, 4, 0},
    {GL_FLOAT, 4, 0},
    {GL_UNSIGNED_BYTE_3_3_2, 1, 3},
    {GL_UNSIGNED_BYTE_2_3_3_REV, 1, 3},
    {GL_UNSIGNED_SHORT_5_6_5, 2, 3},
    {GL_UNSIGNED_SHORT_5_6_5_REV, 2, 3},
    {GL_UNSIGNED_SHORT_4_4_4_4, 2, 4},
    {GL_UNSIGNED_SHORT_4_4_4_4_REV, 2, 4},
    {GL_UNSIGNED_SHORT_5_5_5_1, 2, 4},
    {GL_UNSIGNED_SHORT_1_5_5_5_REV, 2, 4},
    {GL_UNSIGNED_INT_8_8_8_8, 4, 4},
    {GL_UNSIGNED_INT_8_8_8_8_REV, 4, 4},
    {GL_UNSIGNED_INT_10_10_10_2, 4, 4},
    {GL_UNSIGNED_INT_2_10_10_10_REV, 4, 4},
};
constexpr GLenum kFormats[] = {GL_RED, GL_GREEN, GL_BLUE,      GL_ALPHA,           GL_RGB,
                               GL_BGR, GL_RGBA,  GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_BGRA};

// Random memory; floats among it are in [0, 1].
std::vector<GLubyte> random_memory(Random& random, std::size_t bytes, GLenum type) {
    std::vector<GLubyte> memory(bytes);
    if (type == GL_FLOAT) {
        for (std::size_t i = 0; i + 4 <= bytes; i += 4) {
            const float value = random(0, 1);
            std::copy_n(reinterpret_cast<const GLubyte*>(&value), 4,
                        memory.begin() + static_cast<std::ptrdiff_t>(i));
        }
        return memory;
    }
    for (GLubyte& byte : memory) byte = static_cast<GLubyte>(random.bits() >> 9);
    return memory;
}

}  // namespace

SCENE(draw_pixels_formats, "every format in every type") {
    pixel_projection(gl);
    striped_backdrop(gl);
    Random random(21);
    int cell = 0;
    for (const Type& type : kTypes) {
        for (const GLenum format : kFormats) {
            if (type.components != 0 && type.components != component_count(format)) continue;
            if (type.components == 3 && format == GL_BGR) continue;
            gl.RasterPos2i(2 + cell % 12 * 21, 2 + cell / 12 * 28);
            gl.DrawPixels(19, 26, format, type.type,
                          random_memory(random, 19 * 26 * 16 + 64, type.type).data());
            ++cell;
        }
    }
}

SCENE(draw_pixels_store, "pixel store modes") {
    pixel_projection(gl);
    Random random(22);
    const std::vector<GLubyte> memory = random_memory(random, 1 << 16, GL_UNSIGNED_BYTE);
    constexpr GLenum kFew[] = {GL_RGB, GL_LUMINANCE, GL_RGBA, GL_BGR};
    constexpr GLenum kFewTypes[] = {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT};
    for (int i = 0; i < 32; ++i) {
        gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1 << i % 4);
        gl.PixelStorei(GL_UNPACK_ROW_LENGTH, i % 3 ? 40 + i : 0);
        gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, i % 3 ? i % 7 : 0);
        gl.PixelStorei(GL_UNPACK_SKIP_ROWS, i % 5);
        gl.RasterPos2i(2 + i % 8 * 31, 2 + i / 8 * 63);
        gl.DrawPixels(29, 59, kFew[i % 4], kFewTypes[i / 16], memory.data());
    }
}

SCENE(draw_pixels_place, "positions are rounded; every edge of the window and of the scissor cuts") {
    pixel_projection(gl);
    const std::vector<std::uint8_t> picture = painted_texels(40, 40);
    for (int i = 0; i < 16; ++i) {
        const float part = static_cast<float>(i) / 8;
        gl.RasterPos2f(static_cast<float>(i % 4) * 60 + part, static_cast<float>(i / 4) * 60 + 0.499F);
        gl.DrawPixels(13, 13, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
    }
    for (int x = -30; x < 256; x += 250) {
        for (int y = -30; y < 256; y += 250) {
            gl.WindowPos2i(x, y);
            gl.DrawPixels(40, 40, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
        }
    }
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(110, 121, 23, 14);
    gl.WindowPos2i(100, 100);
    gl.DrawPixels(40, 40, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
}

SCENE(draw_pixels_zoom, "magnified, mirrored and reduced",
      .window_only = "the reference's rows lie up to a pixel off in objects") {
    pixel_projection(gl);
    const std::vector<std::uint8_t> picture = painted_texels(16, 16);
    constexpr float kZooms[] = {2, 3, 1.5F, -1, -2, 3.7F, 0.8F, -0.6F};
    for_cells(4, 4, [&](int cell, float x, float y, float, float) {
        const float zoom_x = kZooms[cell % 8], zoom_y = kZooms[(cell * 5 + cell / 8) % 8];
        gl.PixelZoom(zoom_x, zoom_y);
        gl.RasterPos2f(x + (zoom_x < 0 ? 60 : 2), y + (zoom_y < 0 ? 60 : 2));
        gl.DrawPixels(16, 16, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
    });
}

SCENE(draw_pixels_zoom_edges, "magnified over the edges of the window") {
    pixel_projection(gl);
    const std::vector<std::uint8_t> picture = painted_texels(64, 64);
    gl.PixelZoom(3, 3);
    gl.WindowPos2i(-50, -70);
    gl.DrawPixels(64, 64, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
    gl.PixelZoom(5, 2);
    gl.WindowPos2i(160, 190);
    gl.DrawPixels(64, 64, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
}

SCENE(draw_pixels_transfer, "scale, bias and colour maps; colour indices and bitmaps through theirs") {
    pixel_projection(gl);
    const std::vector<std::uint8_t> picture = painted_texels(60, 60);
    gl.PixelTransferf(GL_RED_SCALE, 0.5F);
    gl.PixelTransferf(GL_GREEN_BIAS, 0.25F);
    gl.PixelTransferf(GL_BLUE_SCALE, 2);
    gl.PixelTransferf(GL_BLUE_BIAS, -0.5F);
    gl.RasterPos2i(2, 2);
    gl.DrawPixels(60, 60, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
    GLfloat map[256];
    for (int i = 0; i < 256; ++i) map[i] = static_cast<float>((i * 7) % 256) / 255;
    gl.PixelMapfv(GL_PIXEL_MAP_G_TO_G, 256, map);
    for (const GLenum name : {GL_PIXEL_MAP_R_TO_R, GL_PIXEL_MAP_B_TO_B, GL_PIXEL_MAP_A_TO_A})
        gl.PixelMapfv(name, 256, map);
    for (const GLenum scale : {GL_RED_SCALE, GL_BLUE_SCALE}) gl.PixelTransferf(scale, 1);
    for (const GLenum bias : {GL_GREEN_BIAS, GL_BLUE_BIAS}) gl.PixelTransferf(bias, 0);
    gl.PixelTransferi(GL_MAP_COLOR, 1);
    gl.ColorMask(1, 1, 0, 0);  // the reference maps blue and alpha wrongly
    gl.RasterPos2i(66, 2);
    gl.DrawPixels(60, 60, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
    gl.PixelTransferi(GL_MAP_COLOR, 0);
    gl.ColorMask(1, 1, 1, 1);

    GLfloat ramps[4][16];
    for (int i = 0; i < 16; ++i) {
        const Colour color = hue(static_cast<float>(i) / 16, 1, 0.5F);
        for (std::size_t c = 0; c < 4; ++c) ramps[c][i] = color[c];
    }
    for (GLenum c = 0; c < 4; ++c) gl.PixelMapfv(GL_PIXEL_MAP_I_TO_R + c, 16, ramps[c]);
    std::vector<GLubyte> indices(60 * 60);
    for (std::size_t i = 0; i < indices.size(); ++i)
        indices[i] = static_cast<GLubyte>(i / 60 / 4 + i % 60 / 6);
    gl.RasterPos2i(2, 66);
    gl.DrawPixels(60, 60, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, indices.data());
    gl.RasterPos2i(66, 66);
    gl.DrawPixels(64, 50, GL_COLOR_INDEX, GL_BITMAP, indices.data());
}

SCENE(draw_pixels_fragment_operations, "alpha and depth test, blending, logic op, masks, fog off") {
    pixel_projection(gl);
    striped_backdrop(gl);
    const std::vector<std::uint8_t> picture = painted_texels(60, 60);
    gl.Enable(GL_DEPTH_TEST);
    sloping_triangle(gl);
    gl.ClearStencil(1);
    gl.Clear(GL_STENCIL_BUFFER_BIT);
    std::vector<std::uint8_t> glass = picture;
    for (std::size_t i = 3; i < glass.size(); i += 4) glass[i] = static_cast<std::uint8_t>(i * 37);
    for_cells(4, 4, [&](int cell, float x, float y, float, float) {
        gl.PushAttrib(GL_ALL_ATTRIB_BITS);
        gl.DepthFunc(static_cast<GLenum>(GL_NEVER + cell % 8));
        if (cell & 1) {
            gl.Enable(GL_BLEND);
            gl.BlendFunc(GL_SRC_ALPHA, cell & 2 ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA);
        }
        if (cell & 4) {
            gl.Enable(GL_ALPHA_TEST);
            gl.AlphaFunc(GL_GEQUAL, 0.5F);
            gl.Enable(GL_STENCIL_TEST);
            gl.StencilFunc(GL_ALWAYS, 1, 0xff);
            gl.StencilOp(GL_KEEP, GL_INCR, GL_INVERT);
        }
        if (cell & 8) gl.ColorMask(1, 1, cell & 2 ? 0 : 1, 0);
        if (cell == 9) {
            gl.Enable(GL_COLOR_LOGIC_OP);
            gl.LogicOp(GL_XOR);
        }
        gl.RasterPos3f(x + 2, y + 2, 0.1F);
        gl.DrawPixels(60, 60, GL_RGBA, GL_UNSIGNED_BYTE, glass.data());
        gl.PopAttrib();
    });
}

// Not of 32-bit integers: the reference drops their lowest 9 bits, ours give a depth that was read so back.
SCENE(draw_pixels_depth, "depths of several types: tested, and in the colour of the raster position") {
    pixel_projection(gl);
    gl.Enable(GL_DEPTH_TEST);
    gl.Color3f(0.1F, 0.2F, 0.6F);
    sloping_triangle(gl);
    constexpr GLenum kDepthTypes[] = {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_FLOAT, GL_FLOAT};
    Random random(8);
    for (int i = 0; i < 12; ++i) {
        const GLenum type = kDepthTypes[i % 4];
        gl.DepthFunc(i < 4 ? GL_LESS : i < 8 ? GL_ALWAYS : GL_GREATER);
        if (i >= 8) {
            gl.PixelTransferf(GL_DEPTH_SCALE, 0.5F);
            gl.PixelTransferf(GL_DEPTH_BIAS, 0.25F);
        }
        gl.Color4fv(hue(static_cast<float>(i) / 12).data());
        gl.RasterPos2i(2 + i % 4 * 64, 2 + i / 4 * 64);
        gl.DrawPixels(60, 60, GL_DEPTH_COMPONENT, type, random_memory(random, 60 * 60 * 4, type).data());
    }
}

SCENE(draw_pixels_stencil, "stencil values through their mask and map, past every test") {
    pixel_projection(gl);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_NEVER);
    Random random(9);
    GLfloat map[16];
    for (int i = 0; i < 16; ++i) map[i] = static_cast<float>(i * 5 % 16);
    gl.PixelMapfv(GL_PIXEL_MAP_S_TO_S, 16, map);
    for (int i = 0; i < 12; ++i) {
        gl.StencilMask(i % 3 == 1 ? 0x3c : 0xff);
        // The reference leaves out shift and offset, and the map of bytes.
        gl.PixelTransferi(GL_MAP_STENCIL, i >= 6 && i % 2 == 0);
        gl.RasterPos2i(2 + i % 4 * 64, 2 + i / 4 * 64);
        gl.DrawPixels(60, 60, GL_STENCIL_INDEX, i % 2 ? GL_UNSIGNED_BYTE : GL_UNSIGNED_SHORT,
                      random_memory(random, 60 * 60 * 2, GL_UNSIGNED_BYTE).data());
    }
    gl.StencilMask(0xff);
    gl.DepthFunc(GL_ALWAYS);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilFunc(GL_LESS, 0x50, 0xff);
    striped_backdrop(gl);
}

SCENE(draw_pixels_lists, "recorded with the memory of that time; errors; invalid positions") {
    pixel_projection(gl);
    std::vector<std::uint8_t> picture = painted_texels(50, 40);
    const GLuint list = gl.GenLists(1);
    gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 50);
    gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 7);
    gl.NewList(list, GL_COMPILE);
    gl.DrawPixels(33, 40, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
    gl.EndList();
    gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
    gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    picture.assign(picture.size(), 0);
    for (int i = 0; i < 5; ++i) {
        gl.RasterPos2i(5 + 50 * i, 5 + 40 * i);
        gl.CallList(list);
    }
    gl.RasterPos2i(-5, 0);
    gl.CallList(list);
    gl.DrawPixels(-1, 1, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
    notes.value("negative width", gl.GetError());
    gl.DrawPixels(1, 1, GL_RGBA, GL_BITMAP, picture.data());
    notes.value("bitmap of colours", gl.GetError());
    gl.DrawPixels(1, 1, GL_RGB, GL_UNSIGNED_SHORT_4_4_4_4, picture.data());
    notes.value("packed pixel of another size", gl.GetError());
    gl.DrawPixels(1, 1, GL_DEPTH_TEST, GL_UNSIGNED_BYTE, picture.data());
    notes.value("no format", gl.GetError());
}

SCENE(draw_pixels_float_target, "colours beyond 1 in a buffer of floats", .context = {.type = GL_FLOAT}) {
    pixel_projection(gl);
    Random random(12);
    std::vector<GLfloat> colors(100 * 100 * 4);
    for (GLfloat& value : colors) value = random(-0.5F, 2);
    gl.RasterPos2i(10, 10);
    gl.DrawPixels(100, 100, GL_RGBA, GL_FLOAT, colors.data());
    gl.RasterPos2i(120, 20);
    gl.DrawPixels(64, 64, GL_RGBA, GL_UNSIGNED_BYTE, painted_texels(64, 64).data());
}

SCENE(copy_pixels_color, "copied, overlapping, zoomed, transferred and blended") {
    pixel_projection(gl);
    striped_backdrop(gl, 13);
    gl.RasterPos2i(10, 10);
    gl.DrawPixels(64, 64, GL_RGBA, GL_UNSIGNED_BYTE, painted_texels(64, 64).data());
    gl.RasterPos2i(100, 20);
    gl.CopyPixels(10, 10, 64, 64, GL_COLOR);
    gl.RasterPos2i(110, 30);
    gl.CopyPixels(90, 15, 70, 70, GL_COLOR);
    gl.PixelZoom(-2, 1.5F);
    gl.RasterPos2i(250, 120);
    gl.CopyPixels(10, 10, 50, 50, GL_COLOR);
    gl.PixelZoom(1, 1);
    gl.PixelTransferf(GL_GREEN_SCALE, 0.3F);
    gl.RasterPos2i(10, 180);
    gl.CopyPixels(10, 10, 64, 64, GL_COLOR);
    gl.PixelTransferf(GL_GREEN_SCALE, 1);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ONE);
    gl.RasterPos2i(60, 100);
    gl.CopyPixels(0, 0, 90, 90, GL_COLOR);
}

// 16 bits, which survive the reference's way through floats. Ours stay what they are, however many.
SCENE(copy_pixels_depth, "depths under GL_ALWAYS, with and without colour",
      .context = {.depth_bits = 16, .stencil_bits = 0}) {
    pixel_projection(gl);
    gl.Enable(GL_DEPTH_TEST);
    gl.Begin(GL_TRIANGLES);
    gl.Color3f(1, 0, 0);
    gl.Vertex3f(0, 0, -0.9F);
    gl.Color3f(0, 1, 0);
    gl.Vertex3f(150, 0, 0.9F);
    gl.Vertex3f(0, 150, 0.2F);
    gl.End();
    gl.DepthFunc(GL_ALWAYS);
    gl.ColorMask(0, 0, 0, 0);
    gl.RasterPos2i(100, 100);
    gl.CopyPixels(0, 0, 120, 120, GL_DEPTH);
    gl.PixelZoom(2, 2);
    gl.RasterPos2i(150, 2);
    gl.CopyPixels(10, 10, 40, 40, GL_DEPTH);
    gl.ColorMask(1, 1, 1, 1);
    gl.DepthFunc(GL_LESS);
    gl.Color3f(1, 1, 0);
    rectangle(gl, 60, 5, 250, 250, 0.2F);
}

SCENE(copy_pixels_stencil, "stencil values") {
    pixel_projection(gl);
    gl.Enable(GL_STENCIL_TEST);
    for (int i = 0; i < 10; ++i) {
        gl.StencilFunc(GL_ALWAYS, i * 3, 0xff);
        gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        gl.Color4fv(hue(static_cast<float>(i) / 10).data());
        rectangle(gl, static_cast<float>(i * 9), static_cast<float>(i * 5), 120, 110);
    }
    gl.RasterPos2i(130, 130);
    gl.CopyPixels(5, 5, 110, 110, GL_STENCIL);
    gl.StencilFunc(GL_LESS, 9, 0xff);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    gl.Color3f(1, 1, 1);
    rectangle(gl, 100, 100, 256, 256);
    gl.CopyPixels(0, 0, 4, 4, GL_RGBA);
    notes.value("no type", gl.GetError());
    gl.CopyPixels(0, 0, -4, 4, GL_COLOR);
    notes.value("negative width", gl.GetError());
}

namespace {

// Depths that rise to the right and stencil values that rise upwards.
std::vector<GLuint> depths_and_stencils(GLuint width, GLuint height) {
    std::vector<GLuint> pixels;
    for (GLuint y = 0; y < height; ++y)
        for (GLuint x = 0; x < width; ++x)
            pixels.push_back((0xfffffe / width * x + 77 * y) << 8 | (y * 5 + x / 8) % 256);
    return pixels;
}

// Colours where the stencil values and the depths are.
void show_depths_and_stencils(const Gl& gl) {
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_STENCIL_TEST);
    gl.DepthMask(GL_FALSE);
    for (GLint bit = 0; bit < 8; ++bit) {
        gl.Color4fv(hue(static_cast<float>(bit) / 8).data());
        gl.StencilFunc(GL_EQUAL, 255, 1U << bit);
        gl.DepthFunc(bit % 2 ? GL_LESS : GL_GREATER);
        rectangle(gl, 0, 0, kSize, kSize, 0.1F * static_cast<float>(bit) - 0.5F);
    }
}

}  // namespace

SCENE(draw_pixels_depth_stencil,
      "GL_DEPTH_STENCIL: past all tests, through both masks, the scissor, zoom, stores and transfers") {
    const auto pixels = depths_and_stencils(64, 48);
    const auto draw = [&](GLint x, GLint y) {
        gl.WindowPos2i(x, y);
        gl.DrawPixels(64, 48, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, pixels.data());
    };
    pixel_projection(gl);
    draw(4, 4);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_NEVER);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilFunc(GL_NEVER, 1, 255);
    draw(72, 4);
    gl.DepthMask(GL_FALSE);
    draw(140, 4);
    gl.DepthMask(GL_TRUE);
    gl.StencilMask(0x3c);
    draw(4, 60);
    gl.StencilMask(0xff);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(80, 70, 30, 99);
    draw(72, 60);
    gl.Disable(GL_SCISSOR_TEST);
    gl.PixelZoom(1.5F, -1);
    draw(140, 110);
    gl.PixelZoom(1, 1);
    gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 64);
    gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 9);
    gl.PixelStorei(GL_UNPACK_SKIP_ROWS, 5);
    gl.WindowPos2i(4, 120);
    gl.DrawPixels(40, 40, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, pixels.data());
    std::vector<GLuint> read(64 * 48);
    gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
    gl.PixelStorei(GL_UNPACK_SKIP_ROWS, 0);
    gl.ReadPixels(4, 4, 64, 48, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, read.data());
    for (std::size_t i = 0; i < read.size(); i += 100) {
        notes.value("depth", read[i] >> 8, 1);
        notes.value("stencil", read[i] & 255);
    }
    show_depths_and_stencils(gl);
}

// The reference copies depths by way of floats, two steps off at most; ours stay what they are.
SCENE(copy_pixels_depth_stencil, "GL_DEPTH_STENCIL copied past all tests, overlapping and zoomed",
      .tolerance = {.depth_steps = 2}) {
    pixel_projection(gl);
    const auto pixels = depths_and_stencils(64, 48);
    gl.WindowPos2i(4, 4);
    gl.DrawPixels(64, 48, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, pixels.data());
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_NEVER);
    gl.WindowPos2i(100, 30);
    gl.CopyPixels(4, 4, 64, 48, GL_DEPTH_STENCIL);
    gl.WindowPos2i(20, 20);
    gl.CopyPixels(4, 4, 64, 48, GL_DEPTH_STENCIL);
    gl.PixelZoom(2, 2);
    gl.WindowPos2i(100, 120);
    gl.CopyPixels(4, 4, 64, 48, GL_DEPTH_STENCIL);
    show_depths_and_stencils(gl);
}

SCENE(depth_stencil_textures, "GL_DEPTH_STENCIL into textures, parts of them, sampled and given back") {
    const auto pixels = depths_and_stencils(64, 64);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, 64, 64, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8,
                  pixels.data());
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 10, 20, 30, 17, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8,
                     pixels.data() + 300);
    std::vector<GLuint> read(64 * 64);
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, read.data());
    gl.WindowPos2i(180, 180);
    gl.DrawPixels(64, 64, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, read.data());
    GLint size = 0;
    gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_STENCIL_SIZE, &size);
    notes.value("stencil bits", size);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.Enable(GL_TEXTURE_2D);
    pixel_projection(gl);
    textured_rectangle(gl, 10, 10, 170, 170);
}

SCENE(depth_stencil_errors, "pairs of format and type, and buffers that are missing",
      .draws_nothing_visible = true) {
    const auto note = [&](const char* what) { notes.value(what, gl.GetError()); };
    GLuint pixels[64] = {};
    gl.WindowPos2i(300, 300);
    gl.DrawPixels(1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT, pixels);
    note("type");
    gl.DrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_INT_24_8, pixels);
    note("format");
    gl.ReadPixels(0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT_24_8, pixels);
    note("depths alone");
    gl.ReadPixels(0, 0, 1, 1, GL_DEPTH_STENCIL, GL_FLOAT, pixels);
    note("floats");
    gl.CopyPixels(0, 0, 1, 1, GL_DEPTH_COMPONENT);
    note("copies of a format");
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 4, 4, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                  pixels);
    note("depth texture");
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, pixels);
    note("stencil of a depth texture");
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, pixels);
    note("colours from depths");
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    note("depths from colours");
}
