// Stage: client side, an OSMesa context with its own colour buffer.
// Input: a loaded library and the wanted format. Output: a current context and, after a frame, its pixels.
// Invariant: the colour buffer belongs to this object and outlives the context.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "library.h"

namespace terrazzo::kit {

struct ContextOptions {
    GLenum format = OSMESA_RGBA;
    GLenum type = GL_UNSIGNED_BYTE;
    int depth_bits = 24;
    int stencil_bits = 8;
    int accum_bits = 0;
    int width = 256;
    int height = 256;
    bool y_up = true;
    int row_length = 0;  // in pixels; 0 means width
    OSMesaContext share = nullptr;
};

// Zeros that nobody has touched yet, in huge pages where there are any: a first frame is to be the library's
// time, not that of the client's page faults.
class Pages {
  public:
    explicit Pages(std::size_t bytes);  // throws std::bad_alloc
    ~Pages();
    Pages(const Pages&) = delete;
    Pages& operator=(const Pages&) = delete;
    std::uint8_t* data() const { return m_data; }

  private:
    std::size_t m_mapped;
    void* m_mapping;
    std::uint8_t* m_data;
};

class OffscreenContext {
  public:
    // Throws std::runtime_error when the library refuses the format or the buffer.
    OffscreenContext(const Library& library, const ContextOptions& options);
    ~OffscreenContext();
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

    // The client's buffer as the library left it; finish the frame first.
    std::span<const std::uint8_t> colour_buffer() const { return {m_buffer.data(), m_buffer_size}; }
    // Raw window depth, in steps of the depth buffer's own format; `height` rows from the bottom.
    std::vector<std::uint32_t> read_depth() const;
    std::vector<std::uint8_t> read_stencil() const;
    // Takes and clears every pending GL error.
    std::vector<GLenum> take_errors() const;

    const Library& library() const { return m_library; }
    const ContextOptions& options() const { return m_options; }

  private:
    void reset_read_state() const;

    const Library& m_library;
    ContextOptions m_options;
    Pages m_buffer;
    std::size_t m_buffer_size;
    OSMesaContext m_context;
};

std::string error_name(GLenum error);

}  // namespace terrazzo::kit
