// What a program has set for its own images does not concern those that GLX hands to GL on its behalf.
#pragma once

#include <utility>

#include "gl/tight_unpack.h"

namespace terrazzo::glx {

// While it lives, the context takes images from the client's memory in rows of whole bytes that follow one
// another, and changes none of their values.
class OwnPixels {
  public:
    explicit OwnPixels(gl::Context& ctx)
        : m_pixels(ctx.pixels), m_unpack(ctx, 1), m_transfer(std::exchange(ctx.pixels.mode.transfer, {})) {}
    ~OwnPixels() { m_pixels.mode.transfer = m_transfer; }
    OwnPixels(const OwnPixels&) = delete;
    OwnPixels& operator=(const OwnPixels&) = delete;

  private:
    gl::PixelState& m_pixels;
    gl::TightUnpack m_unpack;
    gl::PixelTransfer m_transfer;
};

}  // namespace terrazzo::glx
