// What a front end asks for when it creates a context.
#pragma once

namespace terrazzo::gl {

struct Config {
    int depth_bits = 24;
    int stencil_bits = 8;
    int accum_bits = 0;  // per component
    bool double_buffered = false;
};

}  // namespace terrazzo::gl
