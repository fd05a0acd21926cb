// The frame buffer as a source of pixels for ReadPixels and the copies into textures (GL 1.5 §4.3.2, §3.8.2).
#pragma once

#include <GL/gl.h>

#include <cstdint>

#include "gl/drawable.h"
#include "raster/target.h"

namespace terrazzo::gl {

struct Context;
struct PixelState;

// A rectangle of window coordinates cut to the window, and how far its corner moved.
struct ReadRect {
    GLint x, y;
    GLsizei width, height;  // 0 where nothing is left
    GLsizei skipped_columns, skipped_rows;
};

// Whether there is a buffer to read from; a context may be current without.
bool has_read_source(const Context& ctx);

// The buffer that ReadBuffer chose when everything is drawn.
class ReadSource {
  public:
    // Draws what is queued; there must be a buffer to read from. Throws std::bad_alloc.
    explicit ReadSource(Context& ctx);
    ~ReadSource();
    ReadSource(const ReadSource&) = delete;
    ReadSource& operator=(const ReadSource&) = delete;

    ReadRect clip(GLint x, GLint y, GLsizei width, GLsizei height) const;

    // Whether colours go through bytes or floats: bytes when the target and pixel transfer let them.
    bool has_bytes(const PixelState& pixels) const;

    // `count` pixels from (x, y) on, which lie in the window. Floats are those after pixel transfer, clamped
    // to 0..1 unless the target's are not.
    void read(int x, int y, int count, uint8_t* rgba) const;
    void read(int x, int y, int count, const PixelState& pixels, float* rgba) const;

    raster::Target& target() const { return m_target; }

  private:
    Drawable& m_drawable;
    ColorBuffer m_selected;  // before
    raster::Target& m_target;
};

}  // namespace terrazzo::gl
