// Chapter: bitmaps (GL 1.5 §3.7).
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

std::vector<GLubyte> random_bits(Random& random, std::size_t bytes) {
    std::vector<GLubyte> bits(bytes);
    for (GLubyte& byte : bits) byte = static_cast<GLubyte>(random.bits() >> 8);
    return bits;
}

void note_position(const Gl& gl, Notes& notes, const char* name) {
    GLfloat position[4];
    gl.GetFloatv(GL_CURRENT_RASTER_POSITION, position);
    notes.values(name, position);
}

// A capital R of 8 by 8 pixels, the lowest row first.
const GLubyte kLetter[8] = {0xc3, 0xc6, 0xcc, 0xd8, 0xfc, 0xc6, 0xc6, 0xfc};

void write_letters(const Gl& gl, int count) {
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (int i = 0; i < count; ++i) gl.Bitmap(8, 8, 0, 0, 9, 0, kLetter);
}

}  // namespace

SCENE(bitmap_sizes, "widths from 1 to 40 at every place relative to a tile, in colours") {
    pixel_projection(gl);
    striped_backdrop(gl);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    Random random(11);
    for (int i = 0; i < 120; ++i) {
        const auto width = static_cast<GLsizei>(random(1, 41)), height = static_cast<GLsizei>(random(1, 25));
        const std::vector<GLubyte> bits = random_bits(random, 8 * 32);
        gl.Color4fv(hue(static_cast<float>(i) / 120).data());
        InOrder{gl.RasterPos2f, random(0, 250), random(0, 250)};
        InOrder{gl.Bitmap, width, height, random(-4, 4), random(-4, 4), 0, 0, bits.data()};
    }
}

SCENE(bitmap_origin, "corners are rounded down from the position less the origin; the position moves on") {
    pixel_projection(gl);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.Color3f(1, 1, 0);
    for (int i = 0; i < 16; ++i) {
        const float part = static_cast<float>(i) / 16;
        gl.RasterPos2f(4 + 15 * static_cast<float>(i) + part, 20 + part);
        gl.Bitmap(8, 8, 0, 0, 0.25F, 60.5F, kLetter);
        gl.Bitmap(8, 8, 0.5F, -2.75F, -3, 60, kLetter);
        gl.Bitmap(8, 8, 4, 4, 1, 1, kLetter);
        if (i % 5 == 0) note_position(gl, notes, ("moved " + std::to_string(i)).c_str());
    }
    gl.RasterPos2f(20, 20);
    gl.Bitmap(0, 0, 0, 0, 100.5F, 50.25F, nullptr);
    note_position(gl, notes, "without pixels");
    write_letters(gl, 3);
}

SCENE(bitmap_edges, "over every edge of the window and of the scissor; a position moved out of the window") {
    pixel_projection(gl);
    Random random(2);
    const std::vector<GLubyte> bits = random_bits(random, 60 * 8);
    gl.Color3f(0.2F, 1, 0.4F);
    const float places[][2] = {{128, 128},   {-128, 128}, {128, -128}, {0, 120},
                               {-140, -140}, {-300, 0},   {140, 0}};
    for (const auto& place : places) {
        gl.WindowPos2f(128, 128);
        gl.Bitmap(0, 0, 0, 0, place[0] - 30, place[1] - 30, nullptr);
        gl.Bitmap(60, 60, 0, 0, 0, 0, bits.data());
    }
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(101, 31, 37, 41);
    gl.Color3f(1, 0.3F, 0.3F);
    gl.WindowPos2i(80, 20);
    gl.Bitmap(60, 60, 0, 0, 0, 0, bits.data());
}

SCENE(bitmap_unpack, "pixel store modes of bitmaps") {
    pixel_projection(gl);
    Random random(5);
    const std::vector<GLubyte> bits = random_bits(random, 4096);
    for (int i = 0; i < 24; ++i) {
        gl.PixelStorei(GL_UNPACK_LSB_FIRST, i & 1);
        gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1 << (i / 2 % 4));
        gl.PixelStorei(GL_UNPACK_ROW_LENGTH, i % 3 ? 50 + i : 0);
        gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, i % 3 ? i : 0);
        gl.PixelStorei(GL_UNPACK_SKIP_ROWS, i % 5);
        gl.Color4fv(hue(static_cast<float>(i) / 24).data());
        gl.RasterPos2i(4 + i % 6 * 42, 4 + i / 6 * 62);
        gl.Bitmap(33, 47, 0, 0, 0, 0, bits.data());
    }
}

SCENE(bitmap_text, "two thousand letters of a display-list font in strings") {
    pixel_projection(gl);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    Random random(9);
    const GLuint font = gl.GenLists(64);
    for (GLuint letter = 0; letter < 64; ++letter) {
        const std::vector<GLubyte> bits = random_bits(random, 13);
        gl.NewList(font + letter, GL_COMPILE);
        gl.Bitmap(8, 13, 0, 2, 8, 0, bits.data());
        gl.EndList();
    }
    gl.ListBase(font);
    for (int line = 0; line < 64; ++line) {
        GLubyte text[32];
        for (GLubyte& letter : text) letter = static_cast<GLubyte>(random.bits() % 64);
        gl.Color4fv(hue(static_cast<float>(line) / 64).data());
        gl.RasterPos2f(0, 4 * static_cast<float>(line));
        gl.CallLists(32, GL_UNSIGNED_BYTE, text);
    }
}

SCENE(bitmap_fragment_operations, "depth, stencil and alpha test, blending, logic op and masks") {
    pixel_projection(gl);
    striped_backdrop(gl);
    Random random(4);
    const std::vector<GLubyte> bits = random_bits(random, 40 * 8);
    gl.Enable(GL_DEPTH_TEST);
    gl.Color3f(0, 0, 0.3F);
    sloping_triangle(gl);
    gl.ClearStencil(3);
    gl.Clear(GL_STENCIL_BUFFER_BIT);
    for_cells(4, 4, [&](int cell, float x, float y, float, float) {
        gl.PushAttrib(GL_ALL_ATTRIB_BITS);
        gl.DepthFunc(static_cast<GLenum>(GL_NEVER + cell % 8));
        if (cell >= 4) {
            gl.Enable(GL_STENCIL_TEST);
            gl.StencilFunc(GL_EQUAL, 3, 0xff);
            gl.StencilOp(GL_ZERO, GL_INCR, GL_INVERT);
        }
        if (cell >= 6) gl.Enable(GL_BLEND);
        gl.BlendFunc(GL_SRC_ALPHA, cell % 2 ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA);
        if (cell >= 10) gl.ColorMask(1, cell % 3 != 0, 1, 0);
        if (cell >= 12) {
            gl.Enable(GL_COLOR_LOGIC_OP);
            gl.LogicOp(GL_XOR);
        }
        if (cell == 9) {
            gl.Enable(GL_ALPHA_TEST);
            gl.AlphaFunc(GL_GREATER, 0.7F);
        }
        gl.Color4f(1, 0.6F, 0.2F, 0.6F);
        gl.RasterPos3f(x + 4, y + 4, 0.3F);
        gl.Bitmap(56, 40, 0, 0, 0, 0, bits.data());
        gl.PopAttrib();
    });
}

SCENE(bitmap_lists, "recorded as they are at that time; carried out too; an invalid position draws nothing") {
    pixel_projection(gl);
    Random random(6);
    std::vector<GLubyte> bits = random_bits(random, 256);
    const GLuint list = gl.GenLists(2);
    gl.PixelStorei(GL_UNPACK_LSB_FIRST, 1);
    gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 3);
    gl.NewList(list, GL_COMPILE);
    gl.Color3f(0, 1, 1);
    gl.RasterPos2f(20, 20);
    gl.Bitmap(29, 30, 1, 1, 31, 31, bits.data());
    gl.EndList();
    gl.PixelStorei(GL_UNPACK_LSB_FIRST, 0);
    gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
    bits.assign(bits.size(), 0xff);
    gl.CallList(list);
    note_position(gl, notes, "after the list");
    gl.NewList(list + 1, GL_COMPILE_AND_EXECUTE);
    gl.Bitmap(10, 10, 0, 0, 12, 1, bits.data());
    gl.EndList();
    gl.CallList(list + 1);
    note_position(gl, notes, "after both");
    gl.RasterPos2f(-1, 3);
    gl.Bitmap(10, 10, 0, 0, 12, 1, bits.data());
    note_position(gl, notes, "invalid");
    gl.Bitmap(-1, 4, 0, 0, 0, 0, bits.data());
    notes.value("error of a negative width", gl.GetError());
}
