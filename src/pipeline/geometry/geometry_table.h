// The geometry code that is compiled once per instruction set; one table a set, beside raster's KernelTable.
#pragma once

#include <cstdint>

#include "pipeline/geometry/shaded_vertices.h"
#include "pipeline/geometry/vertex_input.h"
#include "pipeline/geometry/vertex_state.h"
#include "raster/primitive.h"
#include "simd/isa.h"

namespace terrazzo::pipeline {

// Which side of a polygon the fragments of a triangle belong to: its own, or that of the line or point whose
// shape it is.
enum class Side : uint8_t { kOwn, kFront, kBack };

// How triangles become primitives.
struct TriangleSetup {
    const raster::FragmentState* state = nullptr;
    int32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // scissor and target, in raster rows; x1 and y1 exclusive
    bool cull_front = false, cull_back = false;
    bool cull_unsnapped = false;      // faces also by the window positions before snapping
    bool front_is_clockwise = false;  // in GL's upward y
    bool row0_is_top = true;
    bool multisample = false;  // edges are stepped to samples, and planes begin at pixels' corners
    bool flat = false;
    bool two_sided = false;
    Side side = Side::kOwn;
    bool offset = false;
    float offset_factor = 0, offset_units = 0;
};

// Up to sixteen triangles by the index of their vertices.
struct TriangleBatch {
    int count = 0;
    alignas(64) int32_t v0[16], v1[16], v2[16];
};

// Where set-up puts its primitives.
struct PrimitiveSink {
    // Memory for one primitive with `plane_count` planes; null drops it.
    raster::Primitive* (*allocate)(PrimitiveSink&, int plane_count);
    // The primitive is complete: into the bins with it.
    void (*commit)(PrimitiveSink&, raster::Primitive&);
};

struct GeometryTable {
    // Shades the vertices `elements[0..count)` (or first, first + 1, ... where `elements` is null) into
    // out[0..count).
    void (*shade_vertices)(const VertexState&, const VertexInput&, const uint32_t* elements, uint32_t first,
                           int count, ShadedVertices& out);
    // Sets a batch up: culls, orients, computes planes and edges.
    void (*setup_triangles)(const TriangleSetup&, const ShadedVertices&, const TriangleBatch&,
                            PrimitiveSink&);
};

// The table that goes with raster::kernels().
const GeometryTable& geometry();
// The table of one compiled instruction set, for tests that compare them.
const GeometryTable& geometry_of(simd::Isa isa);

}  // namespace terrazzo::pipeline
