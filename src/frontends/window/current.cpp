// The calling thread's binding; see current.h.
#include "frontends/window/current.h"

#include "gl/current.h"
#include "gl/draw.h"
#include "gl/surface.h"

namespace terrazzo::window {
namespace {

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

const Binding& current_binding() {
    return this_thread.binding;
}

bool make_current(const Binding& wanted) {
    Binding& now = this_thread.binding;
    const bool same_context = now.context == wanted.context;
    if (!same_context && wanted.context && wanted.context->is_current.exchange(true)) return false;
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
