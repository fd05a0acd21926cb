// Which context, GLX's or EGL's, is current in which thread, and with which drawables.
//
// A thread has one current context whatever the interface it was made current with. A context and the
// drawables that are current live at least until the thread lets go of them, which it does at the latest when
// it ends.
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <mutex>

#include "gl/context.h"

namespace terrazzo::window {

// The interface a context belongs to; GLX's functions do not see EGL's contexts and the other way round.
enum class Interface { kGlx, kEgl };

struct Context {
    explicit Context(Interface owner) : interface(owner) {}
    virtual ~Context() = default;

    const Interface interface;
    std::unique_ptr<gl::Context> gl;
    std::atomic<bool> is_current = false;  // in some thread, or set aside by one
};

// Takes one context or two out of all threads' reach while it lives, unless some thread has one of them
// current. Reservations wait for each other, and make_current for them: who only copies a context refuses it
// to nobody.
class Reservation {
  public:
    explicit Reservation(Context& one, Context* other = nullptr);
    ~Reservation();
    Reservation(const Reservation&) = delete;
    Reservation& operator=(const Reservation&) = delete;
    explicit operator bool() const { return m_is_whole; }

  private:
    const std::lock_guard<std::mutex> m_lock;
    std::array<Context*, 2> m_taken = {};
    bool m_is_whole;
};

struct Binding {
    std::shared_ptr<Context> context;          // null: none
    std::shared_ptr<gl::Drawable> draw, read;  // null: none, also where there is a context
};

// The calling thread's.
const Binding& current_binding();

// Makes the context, or none, current in the calling thread; what the thread had drawn before becomes visible
// as by Flush. False, and nothing changes, when another thread has it current. Throws std::bad_alloc and
// changes nothing then.
bool make_current(const Binding& binding);

}  // namespace terrazzo::window
