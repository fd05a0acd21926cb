// The tables of the instruction sets that were compiled in, and the choice among them.
#include "raster/kernel_table.h"

#include "simd/environment.h"
#include "simd/isa.h"

#define TERRAZZO_DECLARE_ISA(isa)                      \
    namespace isa_##isa {                              \
        extern const raster::KernelTable kKernelTable; \
    }

namespace terrazzo {
TERRAZZO_DECLARE_ISA(scalar)
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

// Best first.
constexpr const KernelTable* kCompiled[] = {
#ifdef TERRAZZO_HAVE_AVX512
    &isa_avx512::kKernelTable,
#endif
#ifdef TERRAZZO_HAVE_AVX2
    &isa_avx2::kKernelTable,
#endif
#ifdef TERRAZZO_HAVE_SSE4
    &isa_sse4::kKernelTable,
#endif
#ifdef TERRAZZO_HAVE_NEON
    &isa_neon::kKernelTable,
#endif
    &isa_scalar::kKernelTable,
};

const KernelTable& choose() {
    simd::Isa wanted = simd::Isa::kScalar;
    const char* const name = setting("TERRAZZO_ISA");
    const bool forced = name != nullptr && simd::parse_isa(name, wanted);
    for (const KernelTable* table : kCompiled)
        if (forced && table->isa == wanted && simd::processor_has(wanted)) return *table;
    for (const KernelTable* table : kCompiled)
        if (simd::processor_has(table->isa)) return *table;
    return isa_scalar::kKernelTable;
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
            for (const KernelTable* table : kCompiled)
                if (simd::processor_has(table->isa)) tables[count++] = table;
        }
    } runnable;
    return {runnable.tables, runnable.count};
}

}  // namespace terrazzo::raster
