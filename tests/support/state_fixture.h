// A current context of our libOSMesa, for tests that drive it through its exported functions only.
#pragma once

#include <gtest/gtest.h>

#include "kit/offscreen.h"
#include "state_dump.h"

namespace terrazzo::test {

class StateTest : public testing::Test {
  protected:
    GLenum take_error() { return gl.GetError(); }

    GLint integer(GLenum pname) {
        GLint values[16] = {};
        gl.GetIntegerv(pname, values);
        return values[0];
    }

    std::vector<std::string> dump() { return dump_state(gl); }

    // Loaded once: a library stays in the process anyway.
    static const kit::Library& library() {
        static const kit::Library own(TERRAZZO_OWN_LIBRARY);
        return own;
    }

    const kit::Gl& gl = library().gl;
    kit::OffscreenContext context{library(), {.width = 64, .height = 32}};
};

}  // namespace terrazzo::test
