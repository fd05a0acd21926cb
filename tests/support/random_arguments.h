// Seeded arguments for any command of every_call.h: mostly such as the command takes, all components
// different, a few that it refuses, and client memory of the documented size with the pixel store that goes
// with it.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "every_call.h"

namespace terrazzo::test {

class RandomArguments {
  public:
    explicit RandomArguments(unsigned seed);

    // Valid until the next call; pointers point into memory of this object.
    const std::vector<Arguments>& operator()(const Call& call);

    // Pixel store modes (GL 1.5 §3.6.1) under which the images of the arguments fit into the memory.
    void set_pixel_store(const kit::Gl& gl);

    // Leaves out what libraries may well answer differently: borders, booleans other than 0 and 1, units
    // beyond eight, a single value for a parameter of several, client arrays as capabilities.
    void be_plain() { m_plain = true; }

    // Other bytes in all client memory: whoever reads it later than it may shows.
    void spoil();

    unsigned pick(unsigned count) { return static_cast<unsigned>(m_random() % count); }
    float number(float low, float high);

    // The call as in C, for messages.
    static std::string text(const Call& call, const std::vector<Arguments>& arguments);

  private:
    void fill_bytes(std::size_t first);
    GLenum enumerant(const Call& call, std::size_t i);
    long long integer(const Call& call, std::size_t i);
    double real(const Call& call);
    void* memory(const Call& call, std::size_t i);
    // One of the values that a parameter takes whose values are enumerants; or any number.
    double parameter_value(GLenum pname);
    void fill_parameters(const Call& call, void* out);

    std::mt19937 m_random;
    std::vector<Arguments> m_arguments;
    std::vector<unsigned char> m_memory;
    std::vector<const void*> m_index_lists;
    bool m_plain = false;
    GLenum m_pname = 0;  // of the arguments so far
};

// Null where there is none.
const Call* find_call(std::string_view name);

}  // namespace terrazzo::test
