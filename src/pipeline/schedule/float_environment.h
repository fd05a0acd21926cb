// The floating-point environment of everything that makes vertices and pixels: rounding to nearest, no traps,
// denormals are zero (as in the reference while it draws). What the program has set is put back at the end.
//
// Promise P3 needs it: a program may have changed the rounding, and ARMv7's vectors know no denormals. So
// does P6: a program that asks for traps would get one from the division by a vertex's w of 0.
#pragma once

#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace terrazzo::pipeline {

class FloatEnvironment {
  public:
    FloatEnvironment() : m_saved(read()) {
        if ((m_saved & ~kFlags) != kWanted) write(kWanted);
    }
    ~FloatEnvironment() {
        if ((m_saved & ~kFlags) != kWanted) write(m_saved);
    }
    FloatEnvironment(const FloatEnvironment&) = delete;
    FloatEnvironment& operator=(const FloatEnvironment&) = delete;

  private:
#if defined(__SSE2__)
    using Control = unsigned;
    // All exceptions masked (0x1f80), results flushed to zero (0x8000), denormal operands zero (0x0040).
    static constexpr Control kWanted = 0x9fc0;
    static constexpr Control kFlags = 0x3f;  // what exceptions there were
    static Control read() {
        return _mm_getcsr();
    }
    static void write(Control control) {
        _mm_setcsr(control);
    }
#elif defined(__aarch64__)
    using Control = std::uint64_t;
    static constexpr Control kWanted = Control{1} << 24;  // FZ
    static constexpr Control kFlags = 0;
    static Control read() {
        Control control;
        __asm__ volatile("mrs %0, fpcr" : "=r"(control));
        return control;
    }
    static void write(Control control) {
        __asm__ volatile("msr fpcr, %0" ::"r"(control));
    }
#elif defined(__arm__) && defined(__VFP_FP__) && !defined(__SOFTFP__)
    using Control = std::uint32_t;
    static constexpr Control kWanted = Control{1} << 24;  // FZ
    static constexpr Control kFlags = 0xf000009f;         // of the last comparison and of exceptions
    static Control read() {
        Control control;
        __asm__ volatile("vmrs %0, fpscr" : "=r"(control));
        return control;
    }
    static void write(Control control) {
        __asm__ volatile("vmsr fpscr, %0" ::"r"(control));
    }
#else
    using Control = int;
    static constexpr Control kWanted = 0, kFlags = 0;
    static Control read() {
        return kWanted;
    }
    static void write(Control) {}
#endif

    const Control m_saved;
};

}  // namespace terrazzo::pipeline
