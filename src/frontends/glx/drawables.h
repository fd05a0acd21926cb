// The drawables of GLX; see display.h for what is known of each.
#pragma once

#include <memory>

#include "frontends/glx/display.h"

namespace terrazzo::glx {

// The drawable of that name; a window that nobody has named to GLX before becomes one of `config`, or of its
// visual's configuration where that is null. Null if there is none. Throws std::bad_alloc.
std::shared_ptr<Drawable> drawable_for(DisplayState& display, GLXDrawable name, const Config* config);

}  // namespace terrazzo::glx
