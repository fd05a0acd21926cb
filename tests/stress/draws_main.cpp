// stress-draws: the pictures of seeds as checksums, a line a seed.
//
// usage: stress-draws FIRST COUNT [PREFIX]. With PREFIX the buffers' bytes go to the file PREFIX<seed> too:
// colour, depth (four bytes a pixel), stencil. Each seed also chooses the buffer's format and size, and whether there
// is a multisampled object in its place. The
// instruction set and the threads come from the environment: the library chooses once a process, so
// compare_runs.py starts one for each choice.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <optional>
#include <span>
#include <string>

#include "kit/object_in_window.h"
#include "kit/offscreen.h"
#include "random.h"
#include "random_draws.h"

namespace {

using namespace terrazzo;

// FNV-1a of 64 bits.
class Checksum {
  public:
    void add(std::span<const std::byte> bytes) {
        for (const std::byte byte : bytes)
            m_value = (m_value ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
    }
    std::uint64_t value() const { return m_value; }

  private:
    std::uint64_t m_value = 0xcbf29ce484222325u;
};

kit::ContextOptions options_of(std::uint64_t seed) {
    stress::Random random(seed ^ 0x9e3779b97f4a7c15u);
    constexpr GLenum kTypes[] = {GL_UNSIGNED_BYTE, GL_UNSIGNED_BYTE, GL_UNSIGNED_BYTE, GL_FLOAT,
                                 GL_UNSIGNED_SHORT};
    constexpr GLenum kFormats[] = {OSMESA_RGBA, OSMESA_BGRA, OSMESA_RGB};
    kit::ContextOptions options;
    options.type = random.one_of(kTypes);
    options.format = options.type == GL_UNSIGNED_BYTE ? random.one_of(kFormats) : OSMESA_RGBA;
    options.depth_bits = random.once_in(4) ? 16 : 24;
    options.stencil_bits = options.depth_bits == 24 ? 8 : 0;
    options.width = 1 + random.below(300);
    options.height = 1 + random.below(200);
    return options;
}

void run_seed(const kit::Library& library, std::uint64_t seed, const char* prefix) {
    const kit::ContextOptions options = options_of(seed);
    const kit::OffscreenContext context(library, options);
    std::optional<kit::ObjectInWindow> object;
    if (stress::Random(~seed).once_in(3)) object.emplace(library.gl, options, 4);
    stress::draw_random(library.gl, seed, options.width, options.height);
    if (object) object->show();
    const std::vector<GLenum> errors = context.take_errors();
    Checksum checksum;
    std::ofstream file;
    if (prefix != nullptr) file.open(prefix + std::to_string(seed), std::ios::binary);
    const auto keep = [&](const auto& values) {
        checksum.add(std::as_bytes(std::span(values)));
        file.write(reinterpret_cast<const char*>(values.data()),
                   static_cast<std::streamsize>(values.size() * sizeof values[0]));
    };
    keep(context.colour_buffer());
    keep(context.read_depth());
    if (options.stencil_bits != 0) keep(context.read_stencil());
    std::printf("%" PRIu64 " %016" PRIx64 "%s%s\n", seed, checksum.value(), errors.empty() ? "" : " ",
                errors.empty() ? "" : kit::error_name(errors.front()).c_str());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3 && argc != 4) {
        std::fprintf(stderr, "usage: stress-draws FIRST COUNT [PREFIX]\n");
        return 2;
    }
    std::setvbuf(stdout, nullptr, _IOLBF, 0);  // what was drawn before a crash is known
    try {
        const kit::Library library(TERRAZZO_OWN_LIBRARY);
        const std::uint64_t first = std::strtoull(argv[1], nullptr, 10),
                            count = std::strtoull(argv[2], nullptr, 10);
        for (std::uint64_t seed = first; seed < first + count; ++seed)
            run_seed(library, seed, argc == 4 ? argv[3] : nullptr);
    } catch (const std::exception& failure) {
        std::fprintf(stderr, "stress-draws: %s\n", failure.what());
        return 1;
    }
    return 0;
}
