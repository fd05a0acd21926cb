// Programs for lack of memory: a few commands each, with what the client keeps for them.
//
// A command runs again when it has failed. One that is a `block` is several of the library's, such as Begin,
// vertices and End: those before the one that failed have had their effect, so that only its repetition is
// looked at.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "kit/library.h"

namespace terrazzo::test {

inline constexpr int kWidth = 48, kHeight = 40;

// A client's colour buffer, with bytes behind it that nobody may touch.
class GuardedBuffer {
  public:
    explicit GuardedBuffer(std::size_t size) : m_size(size), m_bytes(size + kGuard, kPattern) {
        std::fill_n(m_bytes.begin(), size, std::uint8_t{0});
    }
    std::uint8_t* data() { return m_bytes.data(); }
    std::vector<std::uint8_t> picture() const {
        return {m_bytes.begin(), m_bytes.begin() + static_cast<std::ptrdiff_t>(m_size)};
    }
    bool is_intact() const;

  private:
    static constexpr std::size_t kGuard = 1 << 16;
    static constexpr std::uint8_t kPattern = 0xa5;
    std::size_t m_size;
    std::vector<std::uint8_t> m_bytes;
};

struct Run {
    const kit::Gl& gl;
    const kit::Osmesa& osmesa;
    OSMesaContext context = nullptr;
    OSMesaContext other = nullptr;  // a command may make it; destroyed in the end
    GuardedBuffer picture;
    GuardedBuffer large{std::size_t{4} * 2 * kWidth * 2 * kHeight};
    std::optional<GuardedBuffer> huge;  // where a command makes it
    // What commands have read; compared in the end.
    std::array<std::vector<float>, 4> results;
    std::array<GLuint, 8> names{};
    // For selection and feedback; in the same place in every run, because the state has their addresses.
    static inline std::array<GLfloat, 4096> floats;
    static inline std::array<GLuint, 256> selected;
    // Set by commands that tell by other means than glGetError that they have not worked.
    bool refused = false;

    Run(const kit::Library& library, GLenum type)
        : gl(library.gl),
          osmesa(library.osmesa),
          picture(std::size_t{kWidth} * kHeight * (type == GL_FLOAT ? 16 : 4)) {
        floats.fill(0);
        selected.fill(0);
    }
    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;
};

struct Command {
    std::string name;
    std::function<void(Run&)> run;
    bool is_block = false;
};

struct Program {
    std::string name;
    std::vector<Command> commands;
    GLenum type = GL_UNSIGNED_BYTE;
};

// All of them; one function a file.
std::vector<Program> vertex_programs();
std::vector<Program> state_programs();
std::vector<Program> list_programs();
std::vector<Program> texture_programs();
std::vector<Program> pixel_programs();
std::vector<Program> object_programs();
std::vector<Program> context_programs();
std::vector<Program> all_programs();

// A command of one call, and a block.
#define TERRAZZO_COMMAND(name, is_block, ...)              \
    Command {                                              \
        name,                                              \
            [](Run& r) {                                   \
                [[maybe_unused]] const kit::Gl& gl = r.gl; \
                __VA_ARGS__;                               \
            },                                             \
            is_block                                       \
    }
#define TERRAZZO_CALL(...) TERRAZZO_COMMAND(#__VA_ARGS__, false, __VA_ARGS__)
#define TERRAZZO_BLOCK(name, ...) TERRAZZO_COMMAND(name, true, __VA_ARGS__)

// What several programs begin with.
inline void draw_triangle(const kit::Gl& gl) {
    gl.Begin(GL_TRIANGLES);
    gl.Color3f(1, 0, 0);
    gl.Vertex3f(-0.9f, -0.8f, 0.1f);
    gl.Color3f(0, 1, 0);
    gl.Vertex3f(0.9f, -0.7f, -0.2f);
    gl.Color3f(0, 0, 1);
    gl.Vertex3f(0.1f, 0.9f, 0.3f);
    gl.End();
}

inline void draw_textured(const kit::Gl& gl) {
    gl.Begin(GL_QUADS);
    gl.Color3f(1, 1, 1);
    for (int i = 0; i < 4; ++i) {
        const GLfloat s = i == 1 || i == 2 ? 1.0f : 0.0f, t = i >= 2 ? 1.0f : 0.0f;
        gl.TexCoord3f(s, t, 0.4f);
        gl.Vertex2f(1.8f * s - 0.9f, 1.8f * t - 0.9f);
    }
    gl.End();
}

}  // namespace terrazzo::test
