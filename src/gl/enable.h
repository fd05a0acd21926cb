// Where the capabilities of glEnable are kept.
#pragma once

#include "gl/context.h"

namespace terrazzo::gl {

struct Capability {
    bool* enabled = nullptr;  // null: there is no such capability
    Dirty dirty = Dirty::kAll;
};

// Texture capabilities are those of the active unit.
Capability find_capability(Context& ctx, GLenum cap);

}  // namespace terrazzo::gl
