// Whatever a program has set for its own images does not concern those that are handed to commands on its
// behalf.
#pragma once

#include <utility>

#include "gl/context.h"

namespace terrazzo::gl {

// While it lives, the context takes images from memory as by default: rows follow one another, each beginning
// at a multiple of `alignment` bytes.
class TightUnpack {
  public:
    explicit TightUnpack(Context& ctx, GLint alignment = PixelStore{}.alignment)
        : m_ctx(ctx), m_modes(std::exchange(ctx.pixels.unpack, PixelStore{})) {
        ctx.pixels.unpack.alignment = alignment;
    }
    ~TightUnpack() { m_ctx.pixels.unpack = std::move(m_modes); }
    TightUnpack(const TightUnpack&) = delete;
    TightUnpack& operator=(const TightUnpack&) = delete;

  private:
    Context& m_ctx;
    PixelStore m_modes;
};

}  // namespace terrazzo::gl
