// The frame buffer as a source of pixels for ReadPixels and the copies into textures (GL 1.5 §4.3.2, §3.8.2).
#pragma once

#include <GL/gl.h>

#include <cstddef>
#include <cstdint>
#include <memory>

#include "gl/drawable.h"
#include "raster/target/copy_out.h"
#include "raster/target/target.h"

namespace terrazzo::gl {

struct Context;
struct PixelState;

// A rectangle of window coordinates cut to the window, and how far its corner moved.
struct ReadRect {
    GLint x, y;
    GLsizei width, height;  // 0 where nothing is left
    GLsizei skipped_columns, skipped_rows;
};

// What there is to read from: null where there is none, as a context may be current without. The one to draw
// to, if it is the same drawable's; else what the drawable has at the moment.
std::shared_ptr<raster::Target> read_target(const Context& ctx);
inline bool has_read_source(const Context& ctx) {
    return read_target(ctx) != nullptr;
}

// Of what there is to read from: whether it has colours. Windows have; objects, which are their context's
// own, may have none.
bool has_read_colors(const Context& ctx);

// The buffer that ReadBuffer chose when everything is drawn. It is held while pixels are read and not in
// between: other threads may draw to it then, and whoever reads may draw to other buffers.
class ReadSource {
  public:
    // Draws what is queued; there must be a buffer to read from. Throws std::bad_alloc.
    explicit ReadSource(Context& ctx);

    ReadRect clip(GLint x, GLint y, GLsizei width, GLsizei height) const;

    // Whether colours go through bytes or floats: bytes when the target and pixel transfer let them.
    bool has_bytes(const PixelState& pixels) const;

    // `count` pixels from (x, y) on, which lie in the window. Floats are those after pixel transfer, clamped
    // to 0..1 unless the target's are not.
    void read(int x, int y, int count, uint8_t* rgba) const;
    void read(int x, int y, int count, const PixelState& pixels, float* rgba) const;

    // (x, y) and the rows above it, each `stride` bytes behind the one before, in a layout that the target
    // has.
    void read(const ReadRect& rect, raster::PixelLayout layout, std::byte* out, std::ptrdiff_t stride) const;
    // Depth as an integer of the target's depth_bits.
    void read_depths(int x, int y, int count, uint32_t* depths) const;
    void read_stencils(int x, int y, int count, uint8_t* stencils) const;

    raster::Target& target() const { return *m_target; }
    const raster::TargetFormat& format() const { return m_target->format(); }
    raster::ColorPlane plane() const { return m_plane; }

  private:
    std::shared_ptr<raster::Target> m_target;
    raster::ColorPlane m_plane;
};

}  // namespace terrazzo::gl
