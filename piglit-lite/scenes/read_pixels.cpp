// Chapter: reading pixels back in all formats and types (GL 1.5 §4.3.2).
#include <cstring>

#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

// A small picture with all planes filled: colours with alpha, depth slope, stencil steps.
void small_picture(const Gl& gl) {
    pixel_projection(gl);
    striped_backdrop(gl, 16);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_ALWAYS);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    for (int i = 0; i < 6; ++i) {
        gl.StencilFunc(GL_ALWAYS, i * 45 + 3, 255);
        gl.Color4fv(hue(static_cast<float>(i) / 6, 0.9F, static_cast<float>(i) / 6).data());
        gl.Begin(GL_TRIANGLES);
        gl.Vertex3f(static_cast<float>(i) * 30, 10, 0.9F);
        gl.Vertex3f(static_cast<float>(i) * 30 + 90, 40, -0.9F);
        gl.Vertex3f(static_cast<float>(i) * 30 + 20, 250, 0.2F);
        gl.End();
    }
    gl.Disable(GL_STENCIL_TEST);
    gl.Disable(GL_DEPTH_TEST);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
}

// A number for a block of memory, and the first bytes, which tell more when it differs.
void note_block(Notes& notes, const std::string& name, const std::vector<std::uint8_t>& bytes) {
    double sum = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) sum += bytes[i] * static_cast<double>(i % 251 + 1);
    notes.value(name + " checksum", sum);
    for (std::size_t i = 0; i < 8; ++i) notes.value(name + " byte " + std::to_string(i), bytes[i]);
}

}  // namespace

SCENE(read_formats_by_integer_types, "ten colour formats in the types of 8 and 16 bits, and in floats") {
    small_picture(gl);
    const GLenum formats[] = {GL_RED,  GL_GREEN, GL_BLUE, GL_ALPHA,     GL_RGB,
                              GL_RGBA, GL_BGR,   GL_BGRA, GL_LUMINANCE, GL_LUMINANCE_ALPHA};
    const struct {
        GLenum type;
        std::size_t size;
    } types[] = {{GL_UNSIGNED_BYTE, 1}, {GL_BYTE, 1}, {GL_UNSIGNED_SHORT, 2}, {GL_SHORT, 2}};
    for (const GLenum format : formats)
        for (const auto& type : types) {
            std::vector<std::uint8_t> bytes(37 * 21 * 4 * type.size, 0xEE);
            gl.ReadPixels(11, 17, 37, 21, format, type.type, bytes.data());
            note_block(notes, "format " + std::to_string(format) + " type " + std::to_string(type.type),
                       bytes);
        }
    for (const GLenum format : formats) {
        std::vector<GLfloat> values(19 * 7 * 4, -9);
        gl.ReadPixels(40, 90, 19, 7, format, GL_FLOAT, values.data());
        for (std::size_t i = 0; i < values.size(); i += 5)
            notes.value("float of format " + std::to_string(format) + " at " + std::to_string(i), values[i],
                        1e-6);
    }
}

SCENE(read_wide_integers, "INT and UNSIGNED_INT read-back, whose low bits come from a float") {
    small_picture(gl);
    for (const GLenum format : {GL_RGBA, GL_BGR, GL_LUMINANCE}) {
        std::vector<GLuint> words(23 * 5 * 4, 77);
        gl.ReadPixels(60, 60, 23, 5, format, GL_UNSIGNED_INT, words.data());
        // A float carries 24 bits: the low 8 bits of the word are rounding. Mesa rounds a full component up
        // to 2^32 (2^31 when signed), which wraps; half the tolerance is added so that both full values land
        // on the same side.
        for (std::size_t i = 0; i < words.size(); i += 7)
            notes.value("unsigned " + std::to_string(i), words[i] + 256U, 512);
        std::vector<GLint> ints(23 * 5 * 4, 77);
        gl.ReadPixels(60, 60, 23, 5, format, GL_INT, ints.data());
        for (std::size_t i = 0; i < ints.size(); i += 7)
            notes.value("int " + std::to_string(i), static_cast<GLuint>(ints[i]) + 256U, 512);
    }
}

SCENE(read_packed_types, "packed pixel types of GL 1.2") {
    small_picture(gl);
    const struct {
        GLenum format, type;
    } packed[] = {{GL_RGB, GL_UNSIGNED_BYTE_3_3_2},      {GL_RGB, GL_UNSIGNED_BYTE_2_3_3_REV},
                  {GL_RGB, GL_UNSIGNED_SHORT_5_6_5},     {GL_RGB, GL_UNSIGNED_SHORT_5_6_5_REV},
                  {GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4},  {GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4_REV},
                  {GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1},  {GL_RGBA, GL_UNSIGNED_SHORT_1_5_5_5_REV},
                  {GL_RGBA, GL_UNSIGNED_INT_8_8_8_8},    {GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV},
                  {GL_RGBA, GL_UNSIGNED_INT_10_10_10_2}, {GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV}};
    for (const auto& p : packed) {
        std::vector<std::uint8_t> bytes(31 * 9 * 4, 0x55);
        gl.ReadPixels(70, 30, 31, 9, p.format, p.type, bytes.data());
        note_block(notes, "packed " + std::to_string(p.type), bytes);
    }
}

SCENE(read_depth_and_stencil, "depth and stencil read in all their types") {
    small_picture(gl);
    std::vector<GLfloat> depths(256);
    gl.ReadPixels(0, 100, 256, 1, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    // One step of 24 bits.
    for (std::size_t i = 0; i < 256; i += 9) notes.value("depth " + std::to_string(i), depths[i], 1.2e-7);
    std::vector<GLushort> shorts(256);
    gl.ReadPixels(0, 100, 256, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, shorts.data());
    for (std::size_t i = 0; i < 256; i += 9) notes.value("16-bit depth " + std::to_string(i), shorts[i], 1);
    std::vector<GLuint> words(256);
    gl.ReadPixels(0, 100, 256, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, words.data());
    for (std::size_t i = 0; i < 256; i += 9) notes.value("32-bit depth " + std::to_string(i), words[i], 512);
    std::vector<GLubyte> stencil(256);
    gl.ReadPixels(0, 60, 256, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil.data());
    for (std::size_t i = 0; i < 256; i += 5) notes.value("stencil " + std::to_string(i), stencil[i]);
    std::vector<GLfloat> stencil_floats(256);
    gl.ReadPixels(0, 60, 256, 1, GL_STENCIL_INDEX, GL_FLOAT, stencil_floats.data());
    for (std::size_t i = 0; i < 256; i += 9)
        notes.value("stencil float " + std::to_string(i), stencil_floats[i]);
    std::vector<GLint> stencil_ints(256);
    gl.ReadPixels(0, 60, 256, 1, GL_STENCIL_INDEX, GL_INT, stencil_ints.data());
    for (std::size_t i = 0; i < 256; i += 9) notes.value("stencil int " + std::to_string(i), stencil_ints[i]);
}

SCENE(read_pack_store, "pack alignment, row length, skips and swapped bytes leave the rest of memory alone") {
    small_picture(gl);
    const struct {
        int alignment, row_length, skip_pixels, skip_rows;
    } stores[] = {{1, 0, 0, 0},  {2, 0, 0, 0},  {4, 0, 0, 0},  {8, 0, 0, 0},
                  {1, 20, 0, 0}, {4, 17, 3, 0}, {8, 19, 2, 2}, {2, 13, 0, 4}};
    int i = 0;
    for (const auto& store : stores) {
        gl.PixelStorei(GL_PACK_ALIGNMENT, store.alignment);
        gl.PixelStorei(GL_PACK_ROW_LENGTH, store.row_length);
        gl.PixelStorei(GL_PACK_SKIP_PIXELS, store.skip_pixels);
        gl.PixelStorei(GL_PACK_SKIP_ROWS, store.skip_rows);
        std::vector<std::uint8_t> bytes(2048, 0xAB);
        gl.ReadPixels(30, 30, 13, 9, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
        note_block(notes, "store " + std::to_string(i++), bytes);
    }
    gl.PixelStorei(GL_PACK_SWAP_BYTES, 1);
    std::vector<std::uint8_t> bytes(2048, 0xAB);
    gl.PixelStorei(GL_PACK_ROW_LENGTH, 0);
    gl.PixelStorei(GL_PACK_SKIP_PIXELS, 0);
    gl.PixelStorei(GL_PACK_SKIP_ROWS, 0);
    gl.ReadPixels(30, 30, 13, 9, GL_RGB, GL_UNSIGNED_SHORT, bytes.data());
    note_block(notes, "swapped", bytes);
}

SCENE(read_outside_the_window, "rectangles that hang over the window leave memory outside it untouched") {
    small_picture(gl);
    const GLint boxes[][4] = {
        {-5, -7, 20, 20}, {246, 250, 20, 20}, {-30, 100, 20, 5}, {100, 300, 8, 8}, {-3, 120, 262, 2}};
    int i = 0;
    for (const auto& box : boxes) {
        std::vector<std::uint8_t> bytes(static_cast<std::size_t>(box[2]) * box[3] * 4, 0x11);
        gl.ReadPixels(box[0], box[1], box[2], box[3], GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
        note_block(notes, "box " + std::to_string(i++), bytes);
    }
}

SCENE(read_with_transfer, "scale, bias and maps applied on the way out") {
    small_picture(gl);
    GLfloat curve[8];
    for (int i = 0; i < 8; ++i) curve[i] = static_cast<float>(i * i) / 49;
    gl.PixelTransferf(GL_RED_SCALE, 0.5F);
    gl.PixelTransferf(GL_GREEN_BIAS, 0.25F);
    gl.PixelTransferf(GL_BLUE_SCALE, -1);
    gl.PixelTransferf(GL_BLUE_BIAS, 1);
    gl.PixelTransferf(GL_ALPHA_SCALE, 2);
    std::vector<GLfloat> values(33 * 11 * 4);
    gl.ReadPixels(20, 20, 33, 11, GL_RGBA, GL_FLOAT, values.data());
    for (std::size_t i = 0; i < values.size(); i += 37)
        notes.value("transferred " + std::to_string(i), values[i], 1e-6);
    gl.PixelTransferi(GL_MAP_COLOR, 1);
    for (const GLenum map :
         {GL_PIXEL_MAP_R_TO_R, GL_PIXEL_MAP_G_TO_G, GL_PIXEL_MAP_B_TO_B, GL_PIXEL_MAP_A_TO_A})
        gl.PixelMapfv(map, 8, curve);
    gl.ReadPixels(20, 20, 33, 11, GL_RGBA, GL_FLOAT, values.data());
    for (std::size_t i = 0; i < values.size(); i += 37)
        notes.value("mapped " + std::to_string(i), values[i], 1e-6);
    gl.PixelTransferi(GL_MAP_COLOR, 0);
    gl.PixelTransferf(GL_DEPTH_SCALE, 0.5F);
    gl.PixelTransferf(GL_DEPTH_BIAS, 0.125F);
    GLfloat depth[16];
    gl.ReadPixels(60, 90, 16, 1, GL_DEPTH_COMPONENT, GL_FLOAT, depth);
    notes.values("depth", depth, 1.2e-7);
    gl.PixelTransferi(GL_INDEX_SHIFT, 1);
    gl.PixelTransferi(GL_INDEX_OFFSET, 5);
    GLubyte stencil[16];
    gl.ReadPixels(60, 90, 16, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil);
    notes.values("stencil", stencil);
}

SCENE(read_between_draws, "what is read in mid-frame is what was drawn so far; drawing goes on after it") {
    pixel_projection(gl);
    for (int i = 0; i < 8; ++i) {
        gl.Color4fv(hue(static_cast<float>(i) / 8).data());
        rectangle(gl, static_cast<float>(i) * 30, static_cast<float>(i) * 25, static_cast<float>(i) * 30 + 60,
                  static_cast<float>(i) * 25 + 60);
        GLubyte pixel[4];
        gl.ReadPixels(i * 30 + 45, i * 25 + 40, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
        notes.values("pixel " + std::to_string(i), pixel);
        gl.Color3ub(static_cast<GLubyte>(255 - pixel[0]), pixel[1], pixel[2]);
        rectangle(gl, static_cast<float>(i) * 30 + 20, static_cast<float>(i) * 25 + 20,
                  static_cast<float>(i) * 30 + 40, static_cast<float>(i) * 25 + 40);
    }
}
