// The tables of the instruction sets that were compiled in, and the choice among them.
#include "raster/kernel_table.h"

#include <cstdlib>

#include "simd/isa.h"

#define TERRAZZO_DECLARE_ISA(isa) \
    namespace isa_##isa {         \
    extern const raster::KernelTable kKernelTable; \
    }

namespace terrazzo {
#ifdef TERRAZZO_HAVE_SCALAR
TERRAZZO_DECLARE_ISA(scalar)
#endif
#ifdef TERRAZZO_HAVE_SSE4
TERRAZZO_DECLARE_ISA(sse4)
#endif
#ifdef TERRAZZO_HAVE_AVX2
TERRAZZO_DECLARE_ISA(avx2)
#endif
#ifdef TERRAZZO_HAVE_AVX512
TERRAZZO_DECLARE_ISA(avx512)
#endif
#ifdef TERRAZZO_HAVE_NEON
TERRAZZO_DECLARE_ISA(neon)
#endif
}  // namespace terrazzo

namespace terrazzo::raster {

namespace {

struct Compiled {
    simd::Isa isa;
    const KernelTable* table;
};

// Best first.
constexpr Compiled kCompiled[] = {
#ifdef TERRAZZO_HAVE_AVX512
    {simd::Isa::kAvx512, &isa_avx512::kKernelTable},
#endif
#ifdef TERRAZZO_HAVE_AVX2
    {simd::Isa::kAvx2, &isa_avx2::kKernelTable},
#endif
#ifdef TERRAZZO_HAVE_SSE4
    {simd::Isa::kSse4, &isa_sse4::kKernelTable},
#endif
#ifdef TERRAZZO_HAVE_NEON
    {simd::Isa::kNeon, &isa_neon::kKernelTable},
#endif
#ifdef TERRAZZO_HAVE_SCALAR
    {simd::Isa::kScalar, &isa_scalar::kKernelTable},
#endif
};

const KernelTable& choose() {
    simd::Isa wanted;
    const char* const name = std::getenv("TERRAZZO_ISA");
    const bool forced = name != nullptr && simd::parse_isa(name, wanted);
    for (const Compiled& c : kCompiled)
        if (forced && c.isa == wanted && simd::processor_has(c.isa)) return *c.table;
    for (const Compiled& c : kCompiled)
        if (simd::processor_has(c.isa)) return *c.table;
    return *kCompiled[std::size(kCompiled) - 1].table;
}

}  // namespace

const KernelTable& kernels() {
    static const KernelTable& table = choose();
    return table;
}

std::span<const KernelTable* const> compiled_kernels() {
    static const struct Runnable {
        const KernelTable* tables[std::size(kCompiled)];
        size_t count = 0;
        Runnable() {
            for (const Compiled& c : kCompiled)
                if (simd::processor_has(c.isa)) tables[count++] = c.table;
        }
    } runnable;
    return {runnable.tables, runnable.count};
}

}  // namespace terrazzo::raster
