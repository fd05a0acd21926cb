// Something to draw to for a context without a window system.
#pragma once

#include <memory>

#include "gl/context.h"

namespace terrazzo::gl {

// Gives the context a new single-buffered drawable that nobody sees.
inline void attach_picture(Context& ctx, int width, int height, const raster::TargetFormat& format = {}) {
    const auto drawable = std::make_shared<Drawable>(Buffering::kSingleByEitherName);
    drawable->allocate(width, height, format);
    attach_drawables(ctx, drawable, drawable);
}

}  // namespace terrazzo::gl
