// stress-frame-memory: how much memory triangles take that wait for their pixels.
//
// usage: stress-frame-memory arrays|immediate TRIANGLES MEGABYTES. Draws that many triangles between two
// reads, from one small array again and again or between one Begin and End, and fails when the process ever
// held more than MEGABYTES.
#include <cstdio>
#include <cstdlib>
#include <cstring>
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

void draw(const kit::Gl& gl, bool immediate, long count) {
    constexpr int kInArray = 1000;
    const std::vector<float> positions = triangles(kInArray);
    if (!immediate) {
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
        std::fprintf(stderr, "usage: stress-frame-memory arrays|immediate TRIANGLES MEGABYTES\n");
        return 2;
    }
    try {
        const kit::Library library(TERRAZZO_OWN_LIBRARY);
        const kit::OffscreenContext context(library, {.width = 512, .height = 512});
        library.gl.Enable(GL_DEPTH_TEST);
        library.gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw(library.gl, std::strcmp(argv[1], "immediate") == 0, std::atol(argv[2]));
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
