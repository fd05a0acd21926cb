// The geometry code of the instruction set in use.
#include "pipeline/geometry/geometry_table.h"

#include "raster/kernel_table.h"

namespace terrazzo {
#define TERRAZZO_DECLARE_ISA(isa)                            \
    namespace isa_##isa {                                    \
        extern const pipeline::GeometryTable kGeometryTable; \
    }
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

namespace terrazzo::pipeline {

const GeometryTable& geometry_of(simd::Isa isa) {
    switch (isa) {
#ifdef TERRAZZO_HAVE_SSE4
        case simd::Isa::kSse4:
            return isa_sse4::kGeometryTable;
#endif
#ifdef TERRAZZO_HAVE_AVX2
        case simd::Isa::kAvx2:
            return isa_avx2::kGeometryTable;
#endif
#ifdef TERRAZZO_HAVE_AVX512
        case simd::Isa::kAvx512:
            return isa_avx512::kGeometryTable;
#endif
#ifdef TERRAZZO_HAVE_NEON
        case simd::Isa::kNeon:
            return isa_neon::kGeometryTable;
#endif
        default:
            return isa_scalar::kGeometryTable;
    }
}

const GeometryTable& geometry() {
    static const GeometryTable& table = geometry_of(raster::kernels().isa);
    return table;
}

}  // namespace terrazzo::pipeline
