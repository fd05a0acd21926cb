// Which instruction set the kernels run on: the best one that was compiled in and that the processor has, or
// the one that TERRAZZO_ISA names (scalar, sse4, avx2, avx512, neon). All draw the same bits.
#pragma once

#include <cstdint>

namespace terrazzo::simd {

enum class Isa : uint8_t { kScalar, kSse4, kAvx2, kAvx512, kNeon };

// The name TERRAZZO_ISA uses, such as "avx2".
const char* isa_name(Isa isa);

// Whether this processor runs code compiled for `isa`.
bool processor_has(Isa isa);

// Parses a name; returns false and leaves `isa` alone when there is no such instruction set.
bool parse_isa(const char* name, Isa& isa);

}  // namespace terrazzo::simd
