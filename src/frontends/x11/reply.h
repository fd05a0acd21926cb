// Ownership of what xcb hands out.
#pragma once

#include <cstdlib>
#include <memory>

namespace terrazzo::x11 {

struct FreeReply {
    void operator()(void* reply) const { std::free(reply); }
};

// A reply, or an error; null where there is none.
template <class T>
using Reply = std::unique_ptr<T, FreeReply>;

}  // namespace terrazzo::x11
