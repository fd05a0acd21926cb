// The calling thread's binding; see current.h.
#include "frontends/window/current.h"

#include "gl/current.h"
#include "gl/draw.h"
#include "gl/surface.h"

namespace terrazzo::window {
namespace {

std::mutex reserving;  // held by the one Reservation that lives

bool take(Context& context) {
    return !context.is_current.exchange(true);
}

void let_go(Binding& binding) {
    if (!binding.context) return;
    gl::make_current(nullptr);
    binding.context->is_current = false;
    binding = {};
}

struct ThreadBinding {
    Binding binding;

    ~ThreadBinding() { let_go(binding); }
};

thread_local ThreadBinding this_thread;

}  // namespace

Reservation::Reservation(Context& one, Context* other)
    : m_lock(reserving),
      m_taken{take(one) ? &one : nullptr, other && take(*other) ? other : nullptr},
      m_is_whole(m_taken[0] && m_taken[1] == other) {}

Reservation::~Reservation() {
    for (Context* context : m_taken)
        if (context) context->is_current = false;
}

const Binding& current_binding() {
    return this_thread.binding;
}

bool make_current(const Binding& wanted) {
    Binding& now = this_thread.binding;
    const bool same_context = now.context == wanted.context;
    if (!same_context && wanted.context && !take(*wanted.context)) {
        const std::lock_guard lock(reserving);  // it may only have been reserved
        if (!take(*wanted.context)) return false;
    }
    try {
        if (now.context && (!same_context || now.draw != wanted.draw)) gl::present_window(*now.context->gl);
        if (now.context && !same_context) gl::finish_drawing(*now.context->gl);
        if (wanted.context) gl::attach_drawables(*wanted.context->gl, wanted.draw, wanted.read);
        // The context that is let go of keeps no drawables: those of a closed display must not outlive it
        // there. All is drawn, so that nothing is left to need memory.
        if (now.context && !same_context) gl::attach_drawables(*now.context->gl, nullptr, nullptr);
    } catch (...) {
        if (!same_context && wanted.context) wanted.context->is_current = false;
        throw;
    }
    const Binding before = now;  // may be the last owner: dies after everything else is in place
    now = wanted;
    gl::make_current(wanted.context ? wanted.context->gl.get() : nullptr);
    if (!same_context && before.context) before.context->is_current = false;
    return true;
}

}  // namespace terrazzo::window
