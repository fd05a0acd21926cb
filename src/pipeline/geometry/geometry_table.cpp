// The geometry code of the instruction set in use.
#include "pipeline/geometry/geometry_table.h"

#include "raster/kernel_table.h"
#include "simd/isas.h"

namespace terrazzo {
#define X(isa, enumerator)                                   \
    namespace isa_##isa {                                    \
        extern const pipeline::GeometryTable kGeometryTable; \
    }
TERRAZZO_ISAS(X)
#undef X
}  // namespace terrazzo

namespace terrazzo::pipeline {

const GeometryTable& geometry_of(simd::Isa isa) {
    switch (isa) {
#define X(isa, enumerator)      \
    case simd::Isa::enumerator: \
        return isa_##isa::kGeometryTable;
        TERRAZZO_ISAS(X)
#undef X
        default:
            return isa_scalar::kGeometryTable;
    }
}

const GeometryTable& geometry() {
    static const GeometryTable& table = geometry_of(raster::kernels().isa);
    return table;
}

}  // namespace terrazzo::pipeline
