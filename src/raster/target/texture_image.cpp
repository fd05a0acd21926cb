// Memory of texture images: allocation with padding that keeps the sampler's vector loads inside, and
// copy-on-write.
#include "raster/target/texture_image.h"

#include <atomic>
#include <cstring>
#include <new>

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

std::shared_ptr<TextureImage> TextureImage::clone() const {
    std::shared_ptr<TextureImage> copy =
        create({width, height, depth, border_x, border_y, border_z}, storage, base_format);
    if (!copy) return nullptr;
    std::memcpy(copy->m_texels, m_texels, size_in_bytes());
    try {
        copy->m_stencils = m_stencils;
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
    return copy;
}

TextureImage* LevelImage::writable() {
    if (in_use()) {
        std::shared_ptr<TextureImage> copy = m_image->clone();
        if (!copy) return nullptr;
        *this = std::move(copy);
    }
    m_image->content_changes();
    return m_image.get();
}

}  // namespace terrazzo::raster
