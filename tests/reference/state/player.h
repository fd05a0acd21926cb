// A program of random state commands, valid and invalid, that depends on its seed alone: two libraries that
// are played the same seed get the same calls.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "kit/library.h"

namespace terrazzo::test {

class StatePlayer {
  public:
    StatePlayer(const kit::Gl& gl, unsigned seed) : m_gl(gl), m_random(seed) {}

    // Calls one command; its text as in C.
    std::string play();

    // For the commands (commands.h).
    struct Enumerant {
        GLenum value;
        const char* name;
    };

    const kit::Gl& gl() const { return m_gl; }
    unsigned pick(unsigned count) { return static_cast<unsigned>(m_random() % count); }
    // Mostly one of `valid`, sometimes none.
    GLenum enumerant(const std::vector<Enumerant>& valid);
    // Small, often one of the special values 0, 1, -1, 0.5; `number` is sometimes large.
    GLfloat number();
    GLfloat moderate_number();
    GLint integer();
    GLuint bits() { return pick(2) ? static_cast<GLuint>(m_random()) : pick(256); }
    GLboolean flag() { return static_cast<GLboolean>(pick(2)); }
    std::vector<GLfloat> numbers(int count);
    std::vector<GLfloat> moderate_numbers(int count);

    // Writes an argument into the text of the command.
    void note(const std::string& argument);

  private:
    const kit::Gl& m_gl;
    std::mt19937 m_random;
    std::string m_text;
};

}  // namespace terrazzo::test
