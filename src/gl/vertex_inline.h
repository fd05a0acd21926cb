// The commands called once per vertex, small enough to be inlined into the generated thunks.
#pragma once

#include "gl/context.h"

namespace terrazzo::gl {}  // namespace terrazzo::gl
