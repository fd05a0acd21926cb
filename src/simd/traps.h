// Arithmetic of ours may overflow or divide by zero where a program's numbers make it: the results are as
// IEEE 754 has them, and dealt with. A program that has floating-point traps on (feenableexcept) wants those
// of its own arithmetic.
#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace terrazzo {

// While it lives, nothing traps in the calling thread. Costs reading a register where traps are off already,
// as they are in most programs. ARM's processors have no traps.
class WithoutTraps {
  public:
#if defined(__SSE2__)
    WithoutTraps() : m_control(_mm_getcsr()) {
        if (traps()) [[unlikely]]
            _mm_setcsr(m_control | _MM_MASK_MASK);
    }
    ~WithoutTraps() {
        if (traps()) [[unlikely]]
            _mm_setcsr(m_control);
    }
#else
    WithoutTraps() {}
    ~WithoutTraps() {}
#endif
    WithoutTraps(const WithoutTraps&) = delete;
    WithoutTraps& operator=(const WithoutTraps&) = delete;

#if defined(__SSE2__)
  private:
    bool traps() const {
        return (m_control & _MM_MASK_MASK) != _MM_MASK_MASK;
    }

    unsigned m_control;
#endif
};

}  // namespace terrazzo
