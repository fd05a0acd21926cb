// How a state command stores a checked value: a value that changes nothing leaves the queued vertices alone,
// so that programs which repeat themselves keep their batches.
#pragma once

#include "gl/context.h"

namespace terrazzo::gl {

template <typename Field, typename Value>
void change(Context& ctx, Dirty what, Field& field, const Value& value) {
    if (field == static_cast<Field>(value)) return;
    begin_change(ctx, what);
    field = static_cast<Field>(value);
}

}  // namespace terrazzo::gl
