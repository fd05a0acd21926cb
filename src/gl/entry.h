// What the generated exported functions need: the visibility mark, the answer of commands that are not
// implemented, and the name -> address table behind OSMesaGetProcAddress.
#pragma once

#include <GL/gl.h>

#include <cstddef>
#include <iterator>

#define TERRAZZO_EXPORT __attribute__((visibility("default")))

using GLclampx = GLint;  // a type of OpenGL ES that the desktop headers lack

namespace terrazzo::gl {

// Records GL_INVALID_OPERATION on the current context, if there is one, and says so in the debug log.
void not_implemented(const char* command);

using ProcAddress = void (*)();

struct NamedAddress {
    const char* name;
    ProcAddress address;
};

extern const NamedAddress kProcAddresses[];  // implemented commands and their aliases, sorted by name
extern const std::size_t kProcAddressCount;

// The exported function called `name`; null when it does not exist or is not implemented.
ProcAddress find_proc_address(const char* name);

}  // namespace terrazzo::gl
