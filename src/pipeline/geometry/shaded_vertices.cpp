// Memory of shaded vertices.
#include "pipeline/geometry/shaded_vertices.h"

#include <cstdlib>
#include <new>

namespace terrazzo::pipeline {

void ShadedVertices::Free::operator()(float* memory) const {
    std::free(memory);
}

void ShadedVertices::reserve(int columns) {
    if (columns <= m_columns) return;
    const size_t bytes = static_cast<size_t>(columns) * kCapacity * sizeof(float);
    float* const memory = static_cast<float*>(std::aligned_alloc(64, (bytes + 63) & ~size_t{63}));
    if (memory == nullptr) throw std::bad_alloc();
    m_memory.reset(memory);
    m_columns = columns;
}

}  // namespace terrazzo::pipeline
