// Memory of texture images: allocation with padding that keeps the sampler's vector loads inside, and
// copy-on-write.
#include "pipeline/texture_image.h"

#include <cstring>
#include <new>

namespace terrazzo::pipeline {
std::shared_ptr<TextureImage> TextureImage::create(int width, int height, int border_x, int border_y,
                                                   TexelStorage storage, BaseFormat base_format) {
    std::shared_ptr<TextureImage> image;
    try {
        image = std::make_shared<TextureImage>();
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
    image->width = width;
    image->height = height;
    image->border_x = border_x;
    image->border_y = border_y;
    image->storage = storage;
    image->base_format = base_format;
    image->pitch = image->stored_width();
    image->m_memory = raster::ZeroedMemory(image->size_in_bytes() + 2 * kPaddingBytes);
    if (image->m_memory.data() == nullptr) return nullptr;
    image->m_texels = static_cast<uint8_t*>(image->m_memory.data()) + kPaddingBytes;
    return image;
}

std::shared_ptr<TextureImage> TextureImage::clone() const {
    std::shared_ptr<TextureImage> copy = create(width, height, border_x, border_y, storage, base_format);
    if (copy) std::memcpy(copy->m_texels, m_texels, size_in_bytes());
    return copy;
}

TextureImage* mutable_image(std::shared_ptr<TextureImage>& image) {
    if (image.use_count() > 1) {
        std::shared_ptr<TextureImage> copy = image->clone();
        if (!copy) return nullptr;
        image = std::move(copy);
    }
    return image.get();
}

}  // namespace terrazzo::pipeline
