// Chapter: pixel buffer objects (ARB_pixel_buffer_object): images from buffers and into them.
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

const void* at(std::size_t offset) {
    return reinterpret_cast<const void*>(offset);
}

GLuint buffer(const Gl& gl, GLenum target, const std::vector<std::uint8_t>& bytes) {
    GLuint name = 0;
    gl.GenBuffers(1, &name);
    gl.BindBuffer(target, name);
    gl.BufferData(target, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STREAM_DRAW);
    return name;
}

// The bound buffer's bytes, from the first pixel on, drawn to be seen.
void show(const Gl& gl, GLint x, GLint y, GLsizei width, GLsizei height) {
    gl.WindowPos2i(x, y);
    gl.DrawPixels(width, height, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
}

}  // namespace

SCENE(pixel_buffer_rectangles, "DrawPixels and Bitmap out of a buffer, with offsets, row lengths and skips") {
    const auto image = painted_texels(64, 64);
    buffer(gl, GL_PIXEL_UNPACK_BUFFER, image);
    show(gl, 8, 8, 64, 64);
    gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 64);
    gl.WindowPos2i(90, 8);
    gl.DrawPixels(40, 30, GL_BGRA, GL_UNSIGNED_BYTE, at(4 * (64 * 10 + 12)));
    gl.PixelStorei(GL_UNPACK_SKIP_ROWS, 20);
    gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 9);
    gl.WindowPos2i(150, 8);
    gl.DrawPixels(50, 44, GL_RGBA, GL_UNSIGNED_INT_8_8_8_8_REV, nullptr);
    gl.Color3f(1, 0.8F, 0.3F);
    gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    gl.PixelStorei(GL_UNPACK_SKIP_ROWS, 0);
    gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 3);
    gl.WindowPos2i(10, 100);
    gl.Bitmap(60, 50, 0, 0, 0, 0, static_cast<const GLubyte*>(at(5)));
    gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
    show(gl, 100, 100, 64, 64);
}

SCENE(pixel_buffer_textures, "textures of one to three dimensions and parts of them out of a buffer") {
    pixel_projection(gl);
    const auto image = painted_texels(32, 64);
    buffer(gl, GL_PIXEL_UNPACK_BUFFER, image);
    const auto nearest = [&](GLenum target) {
        gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    };
    gl.Enable(GL_TEXTURE_2D);
    nearest(GL_TEXTURE_2D);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 8, 4, 16, 8, GL_BGRA, GL_UNSIGNED_BYTE, at(4096));
    textured_rectangle(gl, 4, 4, 120, 120);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 64, 64, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, at(100));
    textured_rectangle(gl, 132, 4, 252, 120);
    gl.Disable(GL_TEXTURE_2D);
    gl.Enable(GL_TEXTURE_1D);
    nearest(GL_TEXTURE_1D);
    gl.TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, at(512));
    gl.TexSubImage1D(GL_TEXTURE_1D, 0, 10, 20, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    textured_rectangle(gl, 4, 132, 120, 252);
    gl.Enable(GL_TEXTURE_3D);
    nearest(GL_TEXTURE_3D);
    gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 16, 16, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl.TexSubImage3D(GL_TEXTURE_3D, 0, 2, 2, 2, 8, 8, 4, GL_RGBA, GL_UNSIGNED_BYTE, at(64));
    gl.Begin(GL_QUADS);
    gl.TexCoord3f(0, 0, 0), gl.Vertex2f(132, 132);
    gl.TexCoord3f(1, 0, 0.5F), gl.Vertex2f(252, 132);
    gl.TexCoord3f(1, 1, 1), gl.Vertex2f(252, 252);
    gl.TexCoord3f(0, 1, 0.5F), gl.Vertex2f(132, 252);
    gl.End();
}

SCENE(pixel_buffer_round_trip,
      "what was drawn and what a texture holds goes into a buffer and is drawn from it") {
    striped_backdrop(gl);
    const GLuint name = buffer(gl, GL_PIXEL_PACK_BUFFER, std::vector<std::uint8_t>(4 * 128 * 128, 90));
    gl.ReadPixels(20, 30, 100, 60, GL_RGBA, GL_UNSIGNED_BYTE, reinterpret_cast<void*>(4 * 128 * 64));
    painted_texture(gl, 64, 64, GL_NEAREST, GL_NEAREST);
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, name);
    show(gl, 64, 64, 128, 128);
}

SCENE(pixel_buffer_maps_and_stipples,
      "pixel maps and a polygon stipple out of a buffer, and a list compiled from one") {
    std::vector<std::uint8_t> bytes = painted_texels(32, 16);
    buffer(gl, GL_PIXEL_UNPACK_BUFFER, bytes);
    gl.PixelMapusv(GL_PIXEL_MAP_R_TO_R, 16, nullptr);
    gl.PixelMapuiv(GL_PIXEL_MAP_G_TO_G, 32, static_cast<const GLuint*>(at(256)));
    GLfloat map[32];
    gl.GetPixelMapfv(GL_PIXEL_MAP_R_TO_R, map);
    for (int i = 0; i < 16; ++i) notes.value("red", static_cast<double>(map[i]), 1e-6);
    gl.GetPixelMapfv(GL_PIXEL_MAP_G_TO_G, map);
    for (int i = 0; i < 32; ++i) notes.value("green", static_cast<double>(map[i]), 1e-6);
    gl.PolygonStipple(static_cast<const GLubyte*>(at(64)));
    gl.Enable(GL_POLYGON_STIPPLE);
    pixel_projection(gl);
    gl.Color3f(0.3F, 0.9F, 0.6F);
    rectangle(gl, 10, 10, 120, 120);
    gl.Disable(GL_POLYGON_STIPPLE);
    const GLuint list = gl.GenLists(1);
    gl.NewList(list, GL_COMPILE);
    gl.DrawPixels(32, 16, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl.EndList();
    gl.BufferData(GL_PIXEL_UNPACK_BUFFER, 16, bytes.data(), GL_STREAM_DRAW);
    gl.WindowPos2i(140, 40);
    gl.CallList(list);
}

SCENE(pixel_buffer_errors, "out of bounds, mapped and misaligned pixels", .draws_nothing_visible = true) {
    const auto note = [&](const char* what) { notes.value(what, gl.GetError()); };
    const auto bytes = painted_texels(8, 8);
    GLubyte scratch[256];
    buffer(gl, GL_PIXEL_UNPACK_BUFFER, bytes);
    gl.WindowPos2i(300, 300);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    note("fits");
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, at(1));
    note("one byte beyond");
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 8, 8, GL_RGBA, GL_FLOAT, nullptr);
    note("four times as large");
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_FLOAT, at(2));
    note("misaligned");
    gl.PixelMapfv(GL_PIXEL_MAP_R_TO_R, 64, nullptr);
    note("map that fits");
    gl.PixelMapfv(GL_PIXEL_MAP_R_TO_R, 65, nullptr);
    note("map that does not");
    gl.PolygonStipple(static_cast<const GLubyte*>(at(129)));
    note("stipple that does not");
    gl.MapBuffer(GL_PIXEL_UNPACK_BUFFER, GL_READ_ONLY);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    note("texture out of a mapped one");
    gl.UnmapBuffer(GL_PIXEL_UNPACK_BUFFER);
    gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    buffer(gl, GL_PIXEL_PACK_BUFFER, bytes);
    gl.ReadPixels(0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    note("read that fits");
    gl.ReadPixels(0, 0, 9, 8, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    note("read that does not");
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, nullptr);
    note("texture that does not");
    gl.MapBuffer(GL_PIXEL_PACK_BUFFER, GL_READ_ONLY);
    gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    note("read into a mapped one");
    gl.UnmapBuffer(GL_PIXEL_PACK_BUFFER);
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, scratch);
    note("read to memory");
}
