// Runs a program with memory that runs out in one of its commands.
#pragma once

#include <string>
#include <vector>

#include "program.h"

namespace terrazzo::test {

// Where memory runs out: at allocation `number` of command `command`, for it alone or for good. There is
// memory again when the command is over.
struct Shortage {
    std::size_t command = 0;
    long number = 0;
    bool for_good = false;
};

class Exhaustion {
  public:
    // Runs the program undisturbed.
    Exhaustion(const kit::Library& library, const Program& program);

    // How many allocations each command has when nothing fails.
    const std::vector<long>& allocations() const { return m_allocations; }

    // False, and nothing is tested, where the command comes to its end before memory runs out.
    bool test(const Shortage& shortage);

  private:
    struct Ending {
        std::vector<std::uint8_t> picture, large, huge;
        std::vector<std::uint32_t> depth;
        std::vector<std::uint8_t> stencil;
        std::array<std::vector<float>, 4> results;
    };

    void begin(Run& run) const;
    void run(Run& run, std::size_t first, std::size_t end) const;
    Ending end(Run& run) const;
    const std::vector<std::string>& state_before(std::size_t command);

    const kit::Library& m_library;
    const Program& m_program;
    std::vector<long> m_allocations;
    std::vector<std::vector<std::string>>
        m_states;  // before each command and after the last; made when needed
    Ending m_ending;
};

// Everything that can be asked of a context, its objects' contents included.
std::vector<std::string> dump_with_objects(const kit::Gl& gl);

}  // namespace terrazzo::test
