// Stage: models from files, vertex data. Input: an accessor's number, sparse or not, of any component type
// and stride, with or without a view. Output: its values in a row. Invariant: nothing outside a buffer is
// read, and no accessor is longer than the limit, nor all of them together than the budget.
#pragma once

#include <cstdint>
#include <vector>

#include "document.h"

namespace terrazzo::gltf {

class Accessors {
  public:
    // The budget counts the elements of all accessors, each time that they are read.
    Accessors(const Document& document, std::size_t longest, Budget& elements)
        : m_document(document), m_longest(longest), m_elements(elements) {}

    // Finite values, `components` an element; throws std::runtime_error when the accessor has others.
    std::vector<float> floats(int accessor, int components) const;
    // Colours have three or four components; a missing fourth is 1.
    std::vector<float> colours(int accessor) const;
    // Unsigned integers of 8, 16 or 32 bits.
    std::vector<std::uint32_t> integers(int accessor, int components) const;

  private:
    template <typename T, typename Convert>
    std::vector<T> read(int accessor, int components, Convert convert) const;
    const tinygltf::Accessor& find(int accessor) const;

    const Document& m_document;
    std::size_t m_longest;
    Budget& m_elements;
};

}  // namespace terrazzo::gltf
