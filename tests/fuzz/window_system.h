// What gives a session its contexts: OSMesa, EGL or GLX. One object serves all threads of an episode.
// Invariant: a context is current in at most one thread, as the specifications want it; which thread gets it
// when two want it is not decided here.
#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "fuzz/session.h"

namespace terrazzo::fuzz {

class WindowSystem {
  public:
    virtual ~WindowSystem() = default;
    // The thread's first context.
    virtual void enter(Session& session, Random& random) = 0;
    // One call or a few of the window system, valid or not.
    virtual void operate(Session& session, Random& random) = 0;
    // Another context, or none.
    virtual void change_context(Session& session, Random& random) = 0;
    // Lets go of whatever the thread has.
    virtual void leave(Session& session) = 0;
};

std::unique_ptr<WindowSystem> make_osmesa(const Library& library);
std::unique_ptr<WindowSystem> make_egl(const Library& library);
std::unique_ptr<WindowSystem> make_glx(const Library& library);

}  // namespace terrazzo::fuzz
