// What the library says of itself; window systems ask before there is a context.
#pragma once

namespace terrazzo::gl {

const char* vendor_string();
const char* renderer_string();

}  // namespace terrazzo::gl
