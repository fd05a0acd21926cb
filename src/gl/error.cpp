// Sticky errors (GL 1.5 §2.5), glGetError, and the answer of commands that do not exist yet.
#include "gl/error.h"

#include <cstdio>

#include "gl/context.h"
#include "gl/current.h"
#include "gl/debug_log.h"
#include "gl/entry.h"
#include "gl/generated/commands.h"

namespace terrazzo::gl {
namespace {

const char* error_name(GLenum code) {
    switch (code) {
        case GL_INVALID_ENUM:
            return "GL_INVALID_ENUM";
        case GL_INVALID_VALUE:
            return "GL_INVALID_VALUE";
        case GL_INVALID_OPERATION:
            return "GL_INVALID_OPERATION";
        case GL_STACK_OVERFLOW:
            return "GL_STACK_OVERFLOW";
        case GL_STACK_UNDERFLOW:
            return "GL_STACK_UNDERFLOW";
        case GL_OUT_OF_MEMORY:
            return "GL_OUT_OF_MEMORY";
        default:
            return "error";
    }
}

}  // namespace

void record_error(Context& ctx, GLenum code, const char* rule) {
    if (debug_enabled()) [[unlikely]] {
        char message[256];
        std::snprintf(message, sizeof message, "%s: %s", error_name(code), rule);
        debug_log(ctx.error.command, message);
    }
    ++ctx.error.count;
    if (ctx.error.code == GL_NO_ERROR) ctx.error.code = code;
}

GLenum get_error(Context& ctx) {
    const GLenum code = ctx.error.code;
    ctx.error.code = GL_NO_ERROR;
    return code;
}

void not_implemented(const char* command) {
    if (!current.context) return debug_log(command, "not implemented, and no context is current");
    current.context->error.command = command;
    record_error(*current.context, GL_INVALID_OPERATION, "not implemented");
}

}  // namespace terrazzo::gl
