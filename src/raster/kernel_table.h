// What each compiled instruction set offers to the code above it; one instance of the table per set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "raster/primitive.h"
#include "raster/target/plane_kernels.h"
#include "raster/target/target.h"
#include "simd/isa.h"

namespace terrazzo::raster {

struct KernelTable {
    simd::Isa isa;
    // Chooses how the fragments of a state whose key and textures are there get their colours: its kernels,
    // or stages of its own and of its texture units.
    void (*choose)(FragmentState&, std::span<TextureStage> units);
    // Draws one primitive into one bin, whose planes are materialised; or leaves it in the batch, which
    // belongs to the bin until it is flushed.
    void (*draw_primitive)(const Primitive&, Bin&, Batch&);
    // The same for a bin of a multisampled target.
    void (*draw_multisampled)(const Primitive&, Bin&, Batch&);
    // Draws what is left in the batch.
    void (*flush)(Bin&, Batch&);
    PlaneKernels planes;
};

// The table in use: the best for this processor, or what TERRAZZO_ISA asks for where it can be had. Chosen
// once.
const KernelTable& kernels();

// Every table this processor can run, best first; for tests that compare them.
std::span<const KernelTable* const> compiled_kernels();

}  // namespace terrazzo::raster
