// Pixel rectangles, bitmaps, reading back, pixel buffers, accumulation.
#include "program.h"

namespace terrazzo::test {
namespace {

std::vector<GLubyte> pixels(std::size_t count) {
    std::vector<GLubyte> out(count);
    for (std::size_t i = 0; i < count; ++i) out[i] = static_cast<GLubyte>(i * 37 + i / 7);
    return out;
}

template <typename Value>
void read(Run& r, std::size_t result, GLenum format, GLenum type) {
    std::vector<Value> values(4 * 20 * 20);
    r.gl.ReadPixels(2, 3, 20, 20, format, type, values.data());
    r.results[result].assign(values.begin(), values.end());
}

Program rectangles() {
    return {"PixelRectangles",
            {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT)),
             TERRAZZO_BLOCK("triangle", draw_triangle(gl);),
             TERRAZZO_CALL(gl.RasterPos2f(-0.8f, -0.8f)),
             TERRAZZO_CALL(gl.DrawPixels(20, 12, GL_RGBA, GL_UNSIGNED_BYTE, pixels(960).data())),
             TERRAZZO_CALL(gl.PixelZoom(1.5f, -1.25f)),
             TERRAZZO_CALL(gl.WindowPos2i(9, 30)),
             TERRAZZO_CALL(gl.DrawPixels(12, 12, GL_RGB, GL_FLOAT, std::vector<GLfloat>(432, 0.6f).data())),
             TERRAZZO_CALL(gl.CopyPixels(0, 0, 14, 9, GL_COLOR)),
             TERRAZZO_CALL(gl.DrawPixels(10, 10, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, pixels(128).data())),
             TERRAZZO_CALL(gl.DrawPixels(8, 8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, pixels(256).data())),
             TERRAZZO_CALL(gl.CopyPixels(1, 1, 9, 9, GL_DEPTH)),
             TERRAZZO_CALL(gl.WindowPos2i(3, 3)),
             TERRAZZO_CALL(gl.Bitmap(8, 8, 0, 0, 9, 1, pixels(32).data())),
             TERRAZZO_CALL(gl.Bitmap(8, 8, 0, 0, 9, 1, pixels(32).data())),
             TERRAZZO_CALL(gl.Bitmap(32, 40, 0, 0, 1, 2, pixels(160).data())),
             TERRAZZO_CALL(read<GLubyte>(r, 0, GL_RGBA, GL_UNSIGNED_BYTE)),
             TERRAZZO_CALL(gl.PixelTransferf(GL_RED_SCALE, 0.5f)),
             TERRAZZO_BLOCK("map", std::vector<GLfloat> map(32, 0.25f);
                            gl.PixelMapfv(GL_PIXEL_MAP_R_TO_R, 32, map.data());
                            gl.PixelTransferi(GL_MAP_COLOR, 1);),
             TERRAZZO_CALL(gl.DrawPixels(6, 6, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, pixels(72).data())),
             TERRAZZO_CALL(read<GLfloat>(r, 1, GL_RGBA, GL_FLOAT)),
             TERRAZZO_CALL(read<GLuint>(r, 2, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT)),
             TERRAZZO_CALL(gl.Finish())}};
}

Program buffers() {
    return {
        "PixelBuffers",
        {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)),
         TERRAZZO_CALL(gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 1)),
         TERRAZZO_CALL(gl.BufferData(GL_PIXEL_UNPACK_BUFFER, 1024, pixels(1024).data(), GL_STATIC_DRAW)),
         TERRAZZO_CALL(gl.RasterPos2f(-0.7f, -0.2f)),
         TERRAZZO_CALL(gl.DrawPixels(16, 16, GL_RGBA, GL_UNSIGNED_BYTE, nullptr)),
         TERRAZZO_CALL(gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr)),
         TERRAZZO_BLOCK(
             "read", gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 2);
             gl.BufferData(GL_PIXEL_PACK_BUFFER, 4 * 64, nullptr, GL_STREAM_READ);
             gl.ReadPixels(9, 18, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, nullptr); std::vector<GLubyte> bytes(256);
             gl.GetBufferSubData(GL_PIXEL_PACK_BUFFER, 0, 256, bytes.data());
             gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0); r.results[0].assign(bytes.begin(), bytes.end());),
         TERRAZZO_CALL(gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0)), TERRAZZO_CALL(gl.Finish())}};
}

Program accumulation() {
    return {"Accumulation",
            {TERRAZZO_CALL(gl.ClearAccum(0.1f, 0.2f, 0.3f, 0.4f)),
             TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT | GL_ACCUM_BUFFER_BIT)),
             TERRAZZO_BLOCK("triangle", draw_triangle(gl);), TERRAZZO_CALL(gl.Accum(GL_ACCUM, 0.5f)),
             TERRAZZO_CALL(gl.Rectf(-0.4f, -0.4f, 0.7f, 0.7f)), TERRAZZO_CALL(gl.Accum(GL_ACCUM, 0.25f)),
             TERRAZZO_CALL(gl.Accum(GL_MULT, 0.9f)), TERRAZZO_CALL(gl.Accum(GL_ADD, 0.05f)),
             TERRAZZO_CALL(gl.Accum(GL_RETURN, 1)), TERRAZZO_CALL(gl.Finish()),
             TERRAZZO_CALL(gl.Accum(GL_LOAD, 1)), TERRAZZO_CALL(gl.Accum(GL_RETURN, 0.8f)),
             TERRAZZO_CALL(gl.Finish())}};
}

Program with_floats() {
    Program out = rectangles();
    out.name = "PixelRectanglesInFloats";
    out.type = GL_FLOAT;
    return out;
}

Program accumulation_in_floats() {
    Program out = accumulation();
    out.name = "AccumulationInFloats";
    out.type = GL_FLOAT;
    return out;
}

}  // namespace

std::vector<Program> pixel_programs() {
    return {rectangles(), buffers(), accumulation(), with_floats(), accumulation_in_floats()};
}

}  // namespace terrazzo::test
