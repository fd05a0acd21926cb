// Stage: client side, an OSMesa context with its own colour buffer. Input: format. Output: pixels, depth,
// stencil. Read-back sets all pixel state to its defaults, so that a scene's own state cannot change what is
// compared.
#include "offscreen.h"

#include <sys/mman.h>

#include <new>
#include <stdexcept>

namespace terrazzo::kit {
namespace {

std::size_t bytes_per_pixel(const ContextOptions& options) {
    if (options.type == GL_UNSIGNED_SHORT_5_6_5) return 2;
    const std::size_t channels = options.format == OSMESA_RGB || options.format == OSMESA_BGR ? 3 : 4;
    const std::size_t size = options.type == GL_FLOAT ? 4 : options.type == GL_UNSIGNED_SHORT ? 2 : 1;
    return channels * size;
}

std::size_t buffer_size(const ContextOptions& options) {
    const int row = options.row_length ? options.row_length : options.width;
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(options.height) *
           bytes_per_pixel(options);
}

constexpr std::size_t kHugePage = std::size_t{2} << 20;

}  // namespace

Pages::Pages(std::size_t bytes)
    : m_mapped(bytes + kHugePage),
      m_mapping(mmap(nullptr, m_mapped, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)) {
    if (m_mapping == MAP_FAILED) throw std::bad_alloc();
    const auto first = reinterpret_cast<std::uintptr_t>(m_mapping);
    m_data = reinterpret_cast<std::uint8_t*>((first + kHugePage - 1) / kHugePage * kHugePage);
    madvise(m_data, bytes / kHugePage * kHugePage, MADV_HUGEPAGE);
}

Pages::~Pages() {
    munmap(m_mapping, m_mapped);
}

OffscreenContext::OffscreenContext(const Library& library, const ContextOptions& options)
    : m_library(library),
      m_options(options),
      m_buffer(buffer_size(options)),
      m_buffer_size(buffer_size(options)) {
    m_context = library.osmesa.CreateContextExt(options.format, options.depth_bits, options.stencil_bits,
                                                options.accum_bits, options.share);
    if (!m_context) throw std::runtime_error("OSMesaCreateContextExt refused the format");
    if (!library.osmesa.MakeCurrent(m_context, m_buffer.data(), options.type, options.width,
                                    options.height)) {
        library.osmesa.DestroyContext(m_context);
        throw std::runtime_error("OSMesaMakeCurrent refused the buffer");
    }
    if (!options.y_up) library.osmesa.PixelStore(OSMESA_Y_UP, 0);
    if (options.row_length) library.osmesa.PixelStore(OSMESA_ROW_LENGTH, options.row_length);
}

OffscreenContext::~OffscreenContext() {
    m_library.osmesa.DestroyContext(m_context);
}

void OffscreenContext::reset_read_state() const {
    const Gl& gl = m_library.gl;
    for (GLenum parameter :
         {GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS})
        gl.PixelStorei(parameter, 0);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.PixelTransferf(GL_DEPTH_SCALE, 1);
    gl.PixelTransferf(GL_DEPTH_BIAS, 0);
    gl.PixelTransferi(GL_INDEX_SHIFT, 0);
    gl.PixelTransferi(GL_INDEX_OFFSET, 0);
    gl.PixelTransferi(GL_MAP_STENCIL, GL_FALSE);
}

std::vector<std::uint32_t> OffscreenContext::read_depth() const {
    if (m_options.depth_bits == 0) return {};
    std::vector<std::uint32_t> depth(static_cast<std::size_t>(m_options.width) *
                                     static_cast<std::size_t>(m_options.height));
    reset_read_state();
    m_library.gl.ReadPixels(0, 0, m_options.width, m_options.height, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                            depth.data());
    // A fixed-point buffer is widened to 32 bits with its own value in the high bits.
    GLint bits = 0;
    m_library.gl.GetIntegerv(GL_DEPTH_BITS, &bits);
    const int shift = bits > 0 && bits < 32 ? 32 - bits : 0;
    for (std::uint32_t& value : depth) value >>= shift;
    return depth;
}

std::vector<std::uint8_t> OffscreenContext::read_stencil() const {
    if (m_options.stencil_bits == 0) return {};
    std::vector<std::uint8_t> stencil(static_cast<std::size_t>(m_options.width) *
                                      static_cast<std::size_t>(m_options.height));
    reset_read_state();
    m_library.gl.ReadPixels(0, 0, m_options.width, m_options.height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE,
                            stencil.data());
    return stencil;
}

std::vector<GLenum> OffscreenContext::take_errors() const {
    std::vector<GLenum> errors;
    // A library whose glGetError never returns to GL_NO_ERROR must not hang its tester.
    constexpr std::size_t kMostErrors = 16;
    for (GLenum error = m_library.gl.GetError(); error != GL_NO_ERROR && errors.size() < kMostErrors;
         error = m_library.gl.GetError())
        errors.push_back(error);
    return errors;
}

std::string error_name(GLenum error) {
    switch (error) {
        case GL_NO_ERROR:
            return "GL_NO_ERROR";
        case GL_INVALID_ENUM:
            return "GL_INVALID_ENUM";
        case GL_INVALID_VALUE:
            return "GL_INVALID_VALUE";
        case GL_INVALID_OPERATION:
            return "GL_INVALID_OPERATION";
        case GL_STACK_OVERFLOW:
            return "GL_STACK_OVERFLOW";
        case GL_STACK_UNDERFLOW:
            return "GL_STACK_UNDERFLOW";
        case GL_OUT_OF_MEMORY:
            return "GL_OUT_OF_MEMORY";
        default:
            return "error " + std::to_string(error);
    }
}

}  // namespace terrazzo::kit
