// A current context without a window system, for tests of commands that need no pixels.
#pragma once

#include <gtest/gtest.h>

#include "gl/context.h"

namespace terrazzo::gl {

class GlTest : public testing::Test {
  protected:
    GlTest() : m_ctx(create_context(Config{}, nullptr)) { make_current(m_ctx.get()); }
    ~GlTest() override { make_current(nullptr); }

    Context& ctx() { return *m_ctx; }

    // The pending error, fetched without glGetError so that it can be asked for between Begin and End.
    GLenum take_error() { return std::exchange(m_ctx->error.code, GLenum{GL_NO_ERROR}); }

  private:
    std::unique_ptr<Context> m_ctx;
};

}  // namespace terrazzo::gl
