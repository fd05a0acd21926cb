// Names of instruction sets and what this processor has of them.
#include "simd/isa.h"

#include <cstring>

namespace terrazzo::simd {

namespace {
constexpr Isa kAll[] = {Isa::kScalar, Isa::kSse4, Isa::kAvx2, Isa::kAvx512, Isa::kNeon};
}

const char* isa_name(Isa isa) {
    switch (isa) {
        case Isa::kScalar:
            return "scalar";
        case Isa::kSse4:
            return "sse4";
        case Isa::kAvx2:
            return "avx2";
        case Isa::kAvx512:
            return "avx512";
        case Isa::kNeon:
            return "neon";
    }
    return "";
}

bool processor_has(Isa isa) {
    switch (isa) {
        case Isa::kScalar:
            return true;
#if defined(__x86_64__) || defined(__i386__)
        case Isa::kSse4:
            return __builtin_cpu_supports("sse4.2");
        case Isa::kAvx2:
            return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                   __builtin_cpu_supports("bmi2");
        case Isa::kAvx512:
            return processor_has(Isa::kAvx2) && __builtin_cpu_supports("avx512f") &&
                   __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
                   __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512cd");
        case Isa::kNeon:
            return false;
#else
        // ARM builds have one instruction set beside scalar: the baseline they were compiled for.
        case Isa::kNeon:
            return true;
        default:
            return false;
#endif
    }
    return false;
}

bool parse_isa(const char* name, Isa& isa) {
    for (const Isa candidate : kAll) {
        if (std::strcmp(name, isa_name(candidate)) == 0) {
            isa = candidate;
            return true;
        }
    }
    return false;
}

}  // namespace terrazzo::simd
