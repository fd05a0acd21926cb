// small_frames LIBRARY NAME COUNT: draws a small frame so many times, for profilers
// (bench/small_instructions.py).
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "kit/offscreen.h"
#include "small_frames.h"

int main(int argc, char** argv) try {
    using namespace terrazzo;
    if (argc != 4) {
        std::fputs("small_frames LIBRARY NAME COUNT\n", stderr);
        return 2;
    }
    const kit::Library library(argv[1]);
    const auto description = small_frames::Description::parse(argv[2]);
    kit::ContextOptions options;
    options.width = options.height = description.size;
    const kit::OffscreenContext context(library, options);
    small_frames::Frames frames(library.gl, description);
    for (int i = std::atoi(argv[3]); i > 0; --i) frames.draw();
    for (const GLenum error : context.take_errors()) {
        std::fprintf(stderr, "%s\n", kit::error_name(error).c_str());
        return 1;
    }
    return 0;
} catch (const std::exception& failure) {
    std::fprintf(stderr, "small_frames: %s\n", failure.what());
    return 1;
}
