// The frame of every generated thunk: nothing thrown by a command reaches the caller.
//
// Lack of memory becomes GL_OUT_OF_MEMORY (GL 1.5 §2.5); commands give the strong guarantee themselves.
// The functions standing in for a command that must not run now share one template per signature.
#pragma once

#include <algorithm>
#include <cstddef>
#include <new>

#include "gl/context.h"
#include "gl/current.h"
#include "gl/debug_log.h"
#include "gl/generated/dispatch.h"

namespace terrazzo::gl {

template <typename Body>
auto guarded(Context& ctx, Body body) noexcept -> decltype(body()) {
    try {
        return body();
    } catch (const std::bad_alloc&) {
        record_error(ctx, GL_OUT_OF_MEMORY, "not enough memory");
    }
    return decltype(body())();
}

// A command name as a template argument.
template <std::size_t kSize>
struct Name {
    char text[kSize];
    constexpr Name(const char (&name)[kSize]) { std::copy_n(name, kSize, text); }
};

// Both convert to whatever function type the dispatch table's member has.
struct IllegalInsideBeginEnd {
    template <typename Result, typename... Arguments>
    using Function = Result (*)(Context*, Arguments...);

    template <typename Result, typename... Arguments>
    static Result call(Context* ctx, Arguments...) noexcept {
        record_error(*ctx, GL_INVALID_OPERATION, "not allowed between glBegin and glEnd");
        return Result();
    }
    template <typename Result, typename... Arguments>
    constexpr operator Function<Result, Arguments...>() const {
        return &call<Result, Arguments...>;
    }
};
inline constexpr IllegalInsideBeginEnd illegal_inside_begin_end;

template <Name kName>
struct NoContext {
    template <typename Result, typename... Arguments>
    using Function = Result (*)(Context*, Arguments...);

    template <typename Result, typename... Arguments>
    static Result call(Context*, Arguments...) noexcept {
        debug_log(kName.text, "no context is current");
        return Result();
    }
    template <typename Result, typename... Arguments>
    constexpr operator Function<Result, Arguments...>() const {
        return &call<Result, Arguments...>;
    }
};
template <Name kName>
inline constexpr NoContext<kName> no_context;

}  // namespace terrazzo::gl
