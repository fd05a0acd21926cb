// Which OSMesa context is current in which thread; see current.h.
//
// `users` counts the threads that have a context current, so that destroying it under another thread's feet
// waits for that thread to let go, which it does at the latest when it ends.
#include "frontends/osmesa/current.h"

#include <mutex>
#include <utility>

#include "frontends/osmesa/osmesa_context.h"
#include "gl/current.h"
#include "gl/surface.h"

namespace terrazzo::osmesa {
namespace {

constinit std::mutex users_mutex;

void take(osmesa_context& context) {
    const std::lock_guard lock(users_mutex);
    ++context.users;
}

void let_go(osmesa_context* context) {
    std::unique_lock lock(users_mutex);
    const bool last = --context->users == 0 && context->destroyed;
    lock.unlock();
    if (last) delete context;
}

struct ThreadContext {
    osmesa_context* context = nullptr;

    ~ThreadContext() {
        gl::make_current(nullptr);
        if (context) let_go(context);
    }
};

thread_local ThreadContext this_thread;

}  // namespace

osmesa_context* current_context() {
    return this_thread.context;
}

void present_before(const osmesa_context* next) {
    const osmesa_context* const now = this_thread.context;
    if (now && now != next) gl::present_window(*now->gl);
}

void set_current(osmesa_context* context) noexcept {
    osmesa_context* const before = this_thread.context;
    if (context != before) {
        if (context) take(*context);
        this_thread.context = context;
    }
    gl::make_current(context ? context->gl.get() : nullptr);
    if (before && context != before) let_go(before);
}

void destroy(osmesa_context* context) {
    if (context == this_thread.context) {
        this_thread.context = nullptr;
        gl::make_current(nullptr);
        const std::lock_guard lock(users_mutex);
        --context->users;
    }
    std::unique_lock lock(users_mutex);
    context->destroyed = true;
    const bool unused = context->users == 0;
    lock.unlock();
    if (unused) delete context;
}

}  // namespace terrazzo::osmesa
