// Keeps a call's work bounded: extents that are legal but huge become small ones. What is an error stays as
// it is.
#pragma once

#include "fuzz/table.h"

namespace terrazzo::fuzz {

// `shared`: other threads read what this one makes.
void bound_work(const Command& command, Value* values, bool shared);

}  // namespace terrazzo::fuzz
