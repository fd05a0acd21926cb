// What the generated recorder (Compile::FooBar) is made of.
#pragma once

#include <GL/gl.h>

#include <cstring>
#include <exception>
#include <limits>
#include <type_traits>

#include "gl/context.h"
#include "gl/limits.h"
#include "gl/list_image.h"
#include "gl/list_record.h"
#include "gl/pixel_buffers.h"

namespace terrazzo::gl {

// The list being compiled cannot grow: records GL_OUT_OF_MEMORY; EndList will drop the list.
void list_out_of_memory(Context& ctx);

// The largest sizes of images that commands take: textures' with both borders, and any that memory holds.
inline constexpr GLsizei kLargestTextureImage = kMaxTextureSize + 2;
inline constexpr GLsizei kLargest3dTextureImage = kMax3dTextureSize + 2;
inline constexpr GLsizei kLargestPixelRectangle = std::numeric_limits<GLsizei>::max();

// Appends what is not Begin/End geometry.
template <typename Append>
void record(Context& ctx, Append append) noexcept {
    if (ctx.lists.out_of_memory) return;
    try {
        ctx.lists.vertices.finish(*ctx.lists.compiling);
        append(*ctx.lists.compiling);
    } catch (const std::exception&) {
        list_out_of_memory(ctx);
    }
}

// Records an error that belongs to the call of the list; GL_NO_ERROR for a command that does nothing unless
// it is called where it is not allowed.
void record_list_error(Context& ctx, Allowed allowed, GLenum code, const char* rule);

// An array argument on its way behind a record.
class CopiedArray {
  public:
    template <typename Element>
    CopiedArray(const Element* elements, std::ptrdiff_t count)
        : m_bytes(elements),
          m_size(elements && count > 0 ? static_cast<std::size_t>(count) * element_size<Element>() : 0) {}

    std::size_t padded_size() const { return padded(m_size); }

    // Returns the offset to put into the record; 0 stands for a null pointer.
    template <typename Record>
    std::uint32_t store(Record& record, std::size_t offset) const {
        if (!m_bytes) return 0;
        if (m_size > 0) std::memcpy(reinterpret_cast<std::byte*>(&record) + offset, m_bytes, m_size);
        return static_cast<std::uint32_t>(offset);
    }

  private:
    template <typename Element>
    static constexpr std::size_t element_size() {
        if constexpr (std::is_void_v<Element>)
            return 1;
        else
            return sizeof(Element);
    }

    const void* m_bytes;
    std::size_t m_size;
};

// The pixels that a command reads when it is compiled (GL 1.5 §5.4), in the client's memory or the unpack
// buffer.
inline PixelMemory find_list_image(const Context& ctx, const ImageSize& size, GLenum format, GLenum type,
                                   const void* pixels) {
    return find_image(ctx, ctx.pixels.unpack, size, format, type, pixels);
}
template <typename Element>
PixelMemory find_list_elements(const Context& ctx, GLsizei count, const Element* elements) {
    if constexpr (std::is_void_v<Element>)
        return find_elements(ctx, ctx.pixels.unpack, count, 1, elements);
    else
        return find_elements(ctx, ctx.pixels.unpack, count, sizeof(Element), elements);
}

// An image argument on its way behind a record.
class UnpackedImage {
  public:
    // `largest`: of a size in any direction that the command takes.
    UnpackedImage(const Context& ctx, GLsizei largest, const ImageSize& size, GLenum format, GLenum type,
                  const void* pixels)
        : m_image(unpack_for_list(ctx.pixels.unpack, size, largest, format, type, pixels)) {}

    std::size_t padded_size() const { return padded(m_image.size()); }

    template <typename Record>
    std::uint32_t store(Record& record, std::size_t offset) const {
        return CopiedArray(m_image.data(), static_cast<std::ptrdiff_t>(m_image.size()))
            .store(record, m_image.empty() ? 0 : offset);
    }

  private:
    std::vector<std::byte> m_image;
};

inline bool is_proxy_target(GLenum target) {
    return target == GL_PROXY_TEXTURE_1D || target == GL_PROXY_TEXTURE_2D || target == GL_PROXY_TEXTURE_3D ||
           target == GL_PROXY_TEXTURE_CUBE_MAP;
}

}  // namespace terrazzo::gl
