// The life of a context, and what must happen before its state changes.
#include "gl/context.h"

#include "gl/share.h"

namespace terrazzo::gl {

std::unique_ptr<Context> create_context(const Config& config, Context* share_partner) {
    auto ctx = std::make_unique<Context>();
    ctx->config = config;
    if (config.double_buffered) ctx->framebuffer.draw_buffer = ctx->framebuffer.read_buffer = GL_BACK;
    ctx->shared = share_partner ? share_partner->shared : std::make_shared<ShareGroup>();
    init_texture_state(*ctx);
    return ctx;
}

}  // namespace terrazzo::gl
