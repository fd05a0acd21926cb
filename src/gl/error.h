// GL errors (GL 1.5 §2.5) and the debug log that names the offending call (TERRAZZO_DEBUG=1).
//
// The first error sticks until glGetError fetches it. A command that records an error has no other effect.
#pragma once

#include <GL/gl.h>

namespace terrazzo::gl {

struct Context;

struct ErrorState {
    GLenum code = GL_NO_ERROR;
    unsigned count = 0;        // how many were recorded, so that a caller can tell whether a command failed
    const char* command = "";  // the GL command being executed, for the log; set in debug mode only
};

// Where a command is allowed (GL 1.5 §2.6.3): of those that are not allowed between Begin and End no other
// error counts there.
enum class Allowed : unsigned char { kOutsideBeginEnd, kAnywhere };

// Records `code` unless one is pending. `rule` says which rule was broken, in words for the debug log, such
// as "width is negative".
void record_error(Context& ctx, GLenum code, const char* rule);

}  // namespace terrazzo::gl
