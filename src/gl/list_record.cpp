// Memory of display lists: blocks that grow with the list, so that a short list stays small.
#include "gl/list_record.h"

#include <algorithm>

namespace terrazzo::gl {
namespace {

constexpr std::size_t kFirstBlock = 256;
constexpr std::size_t kLargestBlock = 64 * 1024;

}  // namespace

void* DisplayList::allocate(std::size_t size) {
    if (m_blocks.empty() || m_blocks.back().size - m_blocks.back().used < size) {
        const std::size_t usual =
            m_blocks.empty() ? kFirstBlock : std::min(kLargestBlock, 2 * m_blocks.back().size);
        const std::size_t block_size = std::max(usual, size);
        m_blocks.reserve(m_blocks.size() + 1);
        m_blocks.push_back({std::make_unique_for_overwrite<std::byte[]>(block_size), block_size, 0});
    }
    Block& block = m_blocks.back();
    void* place = block.bytes.get() + block.used;
    block.used += size;
    return place;
}

}  // namespace terrazzo::gl
