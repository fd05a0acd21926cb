// The tables of the instruction sets that were compiled in, and the choice among them.
#include "raster/kernel_table.h"

#include "simd/environment.h"
#include "simd/isas.h"

namespace terrazzo {
#define X(isa, enumerator)                             \
    namespace isa_##isa {                              \
        extern const raster::KernelTable kKernelTable; \
    }
TERRAZZO_ISAS(X)
#undef X
}  // namespace terrazzo

namespace terrazzo::raster {

namespace {

// Best first.
constexpr const KernelTable* kCompiled[] = {
#define X(isa, enumerator) &isa_##isa::kKernelTable,
    TERRAZZO_ISAS(X)
#undef X
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

const PlaneKernels& plane_kernels() {
    return kernels().planes;
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
