// Ownership of what xcb hands out, and of errors: on a connection of Xlib's those that nobody asks for would
// reach the program's handler.
#pragma once

#include <xcb/xcb.h>
#include <xcb/xcbext.h>

#include <cstdlib>
#include <memory>

namespace terrazzo::x11 {

struct FreeReply {
    void operator()(void* reply) const { std::free(reply); }
};

// A reply, or an error; null where there is none.
template <class T>
using Reply = std::unique_ptr<T, FreeReply>;

// A checked request whose error, if there is one, is nobody's concern: its window may have gone.
inline void quietly(xcb_connection_t* connection, xcb_void_cookie_t request) {
    xcb_discard_reply(connection, request.sequence);
}

}  // namespace terrazzo::x11
