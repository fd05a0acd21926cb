// Memory of texture images: allocation with padding that keeps the sampler's vector loads inside, and
// copy-on-write.
#include "raster/target/texture_image.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <new>

#include "raster/target/target.h"

namespace terrazzo::raster {

namespace {
std::atomic<size_t> abandoned{0};
std::atomic<uint64_t> contents{0};
}  // namespace

size_t TextureImage::abandoned_bytes() {
    return abandoned.load(std::memory_order_relaxed);
}

void TextureImage::content_changes() {
    m_content = 1 + contents.fetch_add(1, std::memory_order_relaxed);
}

void TextureImage::abandon() {
    m_abandoned = true;
    abandoned.fetch_add(size_in_bytes(), std::memory_order_relaxed);
}

TextureImage::~TextureImage() {
    if (m_abandoned) abandoned.fetch_sub(size_in_bytes(), std::memory_order_relaxed);
}

std::shared_ptr<TextureImage> TextureImage::create(const Size& size, TexelStorage storage,
                                                   BaseFormat base_format) {
    std::shared_ptr<TextureImage> image;
    try {
        image = std::make_shared<TextureImage>();
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
    image->width = size.width;
    image->height = size.height;
    image->depth = size.depth;
    image->border_x = size.border_x;
    image->border_y = size.border_y;
    image->border_z = size.border_z;
    image->storage = storage;
    image->base_format = base_format;
    image->pitch = image->stored_width();
    image->m_memory = ZeroedMemory(image->size_in_bytes() + 2 * kPaddingBytes);
    if (image->m_memory.data() == nullptr) return nullptr;
    image->content_changes();
    image->m_texels = static_cast<uint8_t*>(image->m_memory.data()) + kPaddingBytes;
    return image;
}

std::shared_ptr<TextureImage> TextureImage::clone(bool with_texels) const {
    std::shared_ptr<TextureImage> copy =
        create({width, height, depth, border_x, border_y, border_z}, storage, base_format);
    if (!copy) return nullptr;
    if (with_texels && m_tiles) {
        copy->m_tiles = m_tiles;
        copy->m_rows_are_old = true;
    } else if (with_texels) {
        std::memcpy(copy->m_texels, m_texels, size_in_bytes());
    }
    try {
        copy->m_stencils = m_stencils;
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
    return copy;
}

// The rows' memory goes back to the system once: who reads rows again and again should not wait for it each
// time.
void TextureImage::show_tiles(std::shared_ptr<PlanePixels> tiles) {
    m_tiles = std::move(tiles);
    m_rows_are_old = true;
    if (!std::exchange(m_gave_rows_back, true)) m_memory.give_back_pages();
}

void TextureImage::copy_tiles_to_rows() const {
    m_rows_are_old = false;
    const int across = (width + kBinSize - 1) / kBinSize;
    auto* const rows = reinterpret_cast<uint32_t*>(m_texels);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; x += kTileSize) {
            const auto bin = static_cast<size_t>(y / kBinSize * across + x / kBinSize);
            const auto* const depths = reinterpret_cast<const uint32_t*>(m_tiles->bin(bin));
            std::copy_n(depths + pixel_index(x % kBinSize, y % kBinSize), std::min(kTileSize, width - x),
                        rows + index(x, y, 0));
        }
    }
}

TextureImage* LevelImage::in_place_of_used(bool with_texels) {
    if (in_use()) {
        std::shared_ptr<TextureImage> copy = m_image->clone(with_texels);
        if (!copy) return nullptr;
        *this = std::move(copy);
    }
    m_image->content_changes();
    return m_image.get();
}

TextureImage* LevelImage::writable() {
    TextureImage* const image = in_place_of_used(true);
    if (image) image->keep_rows_alone();
    return image;
}

TextureImage* LevelImage::writable_beside_texels() {
    return in_place_of_used(true);
}

TextureImage* LevelImage::replaceable() {
    return in_place_of_used(false);
}

}  // namespace terrazzo::raster
