// stress-frame-memory: how much memory triangles take that wait for their pixels.
//
// usage: stress-frame-memory arrays|immediate|states|textures|bitmaps|images TRIANGLES MEGABYTES. Draws that
// many triangles between two reads, from one small array again and again, between one Begin and End, each
// under a state of its own, or each with a texture image of its own, or bitmaps or images in their place, and
// fails when the process ever held more than MEGABYTES.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>

#include "kit/offscreen.h"
#include "random.h"

namespace {

using namespace terrazzo;

// The most memory this process has held, in bytes: getrusage would count what ran before exec too.
long peak_bytes() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        if (word != "VmHWM:") continue;
        long kilobytes = 0;
        status >> kilobytes;
        return kilobytes * 1024;
    }
    throw std::runtime_error("/proc/self/status has no VmHWM");
}

std::vector<float> triangles(int count) {
    stress::Random random(7);
    std::vector<float> positions;
    for (int i = 0; i < count; ++i) {
        const float x = random.between(-1, 1), y = random.between(-1, 1);
        for (int corner = 0; corner < 3; ++corner) {
            positions.push_back(x + random.between(-0.02f, 0.02f));
            positions.push_back(y + random.between(-0.02f, 0.02f));
            positions.push_back(random.between(-1, 1));
        }
    }
    return positions;
}

// A small one: what counts is what waits with it.
void draw_triangle(const kit::Gl& gl) {
    gl.Begin(GL_TRIANGLES);
    gl.Vertex2f(-0.02f, -0.02f);
    gl.Vertex2f(0.02f, -0.02f);
    gl.Vertex2f(0, 0.02f);
    gl.End();
}

void draw_states(const kit::Gl& gl, long count) {
    for (long i = 0; i < count; ++i) {
        gl.DepthFunc(i % 2 ? GL_LESS : GL_LEQUAL);
        draw_triangle(gl);
    }
}

// Images are given up when a texture gets another and when it is deleted.
void draw_textures(const kit::Gl& gl, long count) {
    constexpr int kSize = 64;
    const std::vector<unsigned char> texels(4 * kSize * kSize, 255);
    gl.Enable(GL_TEXTURE_2D);
    GLuint texture = 0;
    for (long i = 0; i < count; ++i) {
        if (i % 3 == 0) {
            gl.DeleteTextures(1, &texture);
            gl.GenTextures(1, &texture);
            gl.BindTexture(GL_TEXTURE_2D, texture);
            gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        }
        if (i % 3 == 2) {
            gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
        } else {
            gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                          texels.data());
        }
        draw_triangle(gl);
    }
}

void draw_bitmaps(const kit::Gl& gl, long count) {
    const std::vector<unsigned char> bits(128, 0xff);
    for (long i = 0; i < count; ++i) {
        gl.WindowPos2i(static_cast<GLint>(i % 500), static_cast<GLint>(i % 490));
        gl.Bitmap(8, 13, 0, 0, 0, 0, bits.data());
        if (i % 16 == 0) gl.Color3ub(255, static_cast<GLubyte>(i / 16), 0);
    }
}

void draw_images(const kit::Gl& gl, long count) {
    const std::vector<unsigned char> pixels(4 * 512 * 512, 255);
    gl.WindowPos2i(0, 0);
    for (long i = 0; i < count; ++i) gl.DrawPixels(512, 512, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
}

void draw(const kit::Gl& gl, const std::string& way, long count) {
    if (way == "bitmaps") return draw_bitmaps(gl, count);
    if (way == "images") return draw_images(gl, count);
    if (way == "states") return draw_states(gl, count);
    if (way == "textures") return draw_textures(gl, count);
    constexpr int kInArray = 1000;
    const std::vector<float> positions = triangles(kInArray);
    if (way == "arrays") {
        gl.EnableClientState(GL_VERTEX_ARRAY);
        gl.VertexPointer(3, GL_FLOAT, 0, positions.data());
        for (long drawn = 0; drawn < count; drawn += kInArray) gl.DrawArrays(GL_TRIANGLES, 0, 3 * kInArray);
        return;
    }
    gl.Begin(GL_TRIANGLES);
    for (long drawn = 0; drawn < count; drawn += kInArray)
        for (std::size_t i = 0; i < positions.size(); i += 3) gl.Vertex3fv(&positions[i]);
    gl.End();
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fprintf(stderr,
                     "usage: stress-frame-memory arrays|immediate|states|textures|bitmaps|images TRIANGLES "
                     "MEGABYTES\n");
        return 2;
    }
    try {
        const kit::Library library(TERRAZZO_OWN_LIBRARY);
        const kit::OffscreenContext context(library, {.width = 512, .height = 512});
        library.gl.Enable(GL_DEPTH_TEST);
        library.gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw(library.gl, argv[1], std::atol(argv[2]));
        library.gl.Finish();
        const std::vector<GLenum> errors = context.take_errors();
        bool drawn = false;
        for (const std::uint8_t byte : context.colour_buffer()) drawn = drawn || byte == 255;
        const long peak = peak_bytes(), limit = std::atol(argv[3]) * 1000 * 1000;
        std::printf("%s triangles, %s: %.0f MB at most\n", argv[2], argv[1], static_cast<double>(peak) / 1e6);
        return errors.empty() && drawn && peak < limit ? 0 : 1;
    } catch (const std::exception& failure) {
        std::fprintf(stderr, "stress-frame-memory: %s\n", failure.what());
        return 1;
    }
}
