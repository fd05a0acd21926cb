// The server and client attribute stacks (GL 1.5 §6.1.14): what glPushAttrib and glPushClientAttrib saved.
//
// Entries are made and applied in attrib.cpp only, which knows all chapters; here they are opaque.
#pragma once

#include <GL/gl.h>

#include <memory>
#include <vector>

namespace terrazzo::gl {

struct Context;
struct SavedAttributes;
struct SavedClientAttributes;

struct AttribState {
    // shared_ptr because it can destroy a type that is incomplete here; entries are never shared.
    std::vector<std::shared_ptr<const SavedAttributes>> server;
    std::vector<std::shared_ptr<const SavedClientAttributes>> client;
};

// Gives one context the groups of attributes that another has (glXCopyContext). Neither is current elsewhere. Throws
// std::bad_alloc.
void copy_attributes(Context& from, Context& to, GLbitfield mask);

}  // namespace terrazzo::gl
