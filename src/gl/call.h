// The frame of every generated thunk: nothing thrown by a command reaches the caller, and nothing in it
// traps.
//
// All that is thrown is lack of memory: std::bad_alloc, and what the standard library throws where a
// container or a lock cannot be had. It becomes GL_OUT_OF_MEMORY (GL 1.5 §2.5); commands give the strong
// guarantee themselves. The functions standing in for a command that must not run now share one template per
// signature.
#pragma once

#include <algorithm>
#include <cstddef>
#include <exception>

#include "gl/context.h"
#include "gl/current.h"
#include "gl/debug_log.h"
#include "gl/generated/dispatch.h"
#include "simd/traps.h"

namespace terrazzo::gl {

template <typename Result, typename... Arguments>
using Function = Result (*)(Context*, Arguments...);

template <typename Body>
auto guarded(Context& ctx, Body body) noexcept -> decltype(body()) {
    const WithoutTraps without_traps;
    try {
        return body();
    } catch (const std::exception&) {
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

// The following convert to, or are, functions of whatever type the dispatch table's member has.

// A command that is not allowed where it is called: between Begin and End, or outside (GL 1.5 §2.6.3).
template <Name kRule>
struct Illegal {
    template <typename Result, typename... Arguments>
    static Result call(Context* ctx, Arguments...) noexcept {
        record_error(*ctx, GL_INVALID_OPERATION, kRule.text);
        return Result();
    }
    template <typename Result, typename... Arguments>
    constexpr operator Function<Result, Arguments...>() const {
        return &call<Result, Arguments...>;
    }
};
inline constexpr Illegal<"not allowed between glBegin and glEnd"> illegal_inside_begin_end;
inline constexpr Illegal<"not allowed outside glBegin and glEnd"> illegal_outside_begin_end;

// A command without effect where it is called, such as Vertex outside Begin and End.
struct Ignored {
    template <typename... Arguments>
    static void call(Context*, Arguments...) noexcept {}

    template <typename... Arguments>
    constexpr operator Function<void, Arguments...>() const {
        return &call<Arguments...>;
    }
};
inline constexpr Ignored ignored;

// Any command while no context is current.
template <Name kName>
struct NoContext {
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

// A command that is not recorded while a list is compiled.
template <auto kMember>
struct ExecutedAtOnce;

template <typename Result, typename... Arguments, Function<Result, Arguments...> Dispatch::*kMember>
struct ExecutedAtOnce<kMember> {
    static Result call(Context* ctx, Arguments... arguments) noexcept {
        return (ctx->dispatch.execute->*kMember)(ctx, arguments...);
    }
};

// Any command in debug mode: tells the error state its name, then takes the ordinary way.
template <auto kMember, Name kName>
struct Named;

template <typename Result, typename... Arguments, Function<Result, Arguments...> Dispatch::*kMember,
          Name kName>
struct Named<kMember, kName> {
    static Result call(Context* ctx, Arguments... arguments) noexcept {
        ctx->error.command = kName.text;
        return (ctx->dispatch.table->*kMember)(ctx, arguments...);
    }
};

}  // namespace terrazzo::gl
