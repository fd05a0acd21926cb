// The accumulation buffer (GL 1.5 §4.2.4): four signed 16-bit fractions a pixel, part of the drawable.
#pragma once

#include <GL/gl.h>

#include <cstdint>
#include <memory>
#include <mutex>

namespace terrazzo::gl {

struct Context;

// Rows in the order of the target's, one after the other; 32767 stands for 1. Zeros at first. Contexts of
// several threads may share it: whoever reads or writes holds its mutex.
class AccumulationPlane {
  public:
    // Throws std::bad_alloc.
    AccumulationPlane(int width, int height);

    std::int16_t* pixel(int x, int row) { return m_values.get() + 4 * (std::ptrdiff_t{row} * m_width + x); }

    std::mutex& mutex() { return m_mutex; }

  private:
    std::mutex m_mutex;
    int m_width;
    std::unique_ptr<std::int16_t[]> m_values;
};

// Makes sure that it has memory, where there is one. Throws std::bad_alloc.
void allocate_accumulation(Context& ctx);

// What Clear does to it, within the scissor box; nothing where there is none. It has memory.
void clear_accumulation(Context& ctx);

}  // namespace terrazzo::gl
