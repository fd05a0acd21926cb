// Vertices after the vertex program, as columns: one array a quantity, one element a vertex.
//
// Columns: clip coordinates, window coordinates (x, y, z, 1/w; y counts downwards for windows as the target's
// rows do), snapped window x and y (integers, 8 sub-pixel bits, pixel centres at multiples of 256), the clip
// outcode, then the varyings in the order of raster::Varyings and, where lighting is two-sided, the back
// colours (and secondary colours).
#pragma once

#include <cstdint>
#include <memory>

namespace terrazzo::pipeline {

enum Column : int {
    kClipX,
    kClipY,
    kClipZ,
    kClipW,
    kWindowX,
    kWindowY,
    kWindowZ,
    kWindowOow,
    kSnappedX,
    kSnappedY,
    kOutcode,
    kEdgeFlagColumn,   // integers; written only where polygons may be drawn unfilled
    kPointSizeColumn,  // written only where points are attenuated
    kFirstVarying,
};

// Bits of the outcode: the six planes of the view volume in the order they are clipped, then the user's.
enum Outcode : uint32_t {
    kOutsideRight = 1,
    kOutsideLeft = 2,
    kOutsideTop = 4,
    kOutsideBottom = 8,
    kOutsideNear = 16,
    kOutsideFar = 32,
    kOutsideUser = 64,
};

class ShadedVertices {
  public:
    // The vertices of a chunk and its pivot, then what clipping makes, then what the stages behind it make.
    // The sum is no multiple of 1024: columns whole pages apart would share their cache sets.
    static constexpr int kChunkSlots = 12288 + 16;
    static constexpr int kFirstStageSlot = kChunkSlots + 896;
    static constexpr int kCapacity = kFirstStageSlot + 128;
    static constexpr int kMaxColumns = 64;

    // Makes room for `columns` columns; throws std::bad_alloc.
    void reserve(int columns);

    float* column(int index) { return m_memory.get() + static_cast<size_t>(index) * kCapacity; }
    const float* column(int index) const { return m_memory.get() + static_cast<size_t>(index) * kCapacity; }
    int32_t* integers(int index) { return reinterpret_cast<int32_t*>(column(index)); }
    const int32_t* integers(int index) const { return reinterpret_cast<const int32_t*>(column(index)); }

  private:
    struct Free {
        void operator()(float* memory) const;
    };
    std::unique_ptr<float[], Free> m_memory;
    int m_columns = 0;
};

}  // namespace terrazzo::pipeline
