// Swap intervals and the counters of GLX_OML_sync_control and GLX_SGI_video_sync. A software display has no
// beam: the beat is a timer's (frontends/window/refresh.h).
#include <GL/glx.h>

#include "frontends/glx/display.h"
#include "frontends/glx/protocol.h"
#include "frontends/window/refresh.h"

namespace glx = terrazzo::glx;
namespace window = terrazzo::window;
using terrazzo::glx::registry;

namespace {

// What the calling thread draws to.
std::shared_ptr<glx::Drawable> current_drawable() {
    const auto context = glx::current_context();
    return context ? registry().drawable(*context->display, context->draw) : nullptr;
}

void set_interval(glx::Drawable& drawable, int interval) {
    drawable.swap_interval = interval;
    drawable.last_msc = window::msc_at(window::current_ust());
}

std::int64_t swap_count(const glx::Drawable& drawable) {
    return drawable.server ? drawable.server->swap_count() : 0;
}

}  // namespace

void glXSwapIntervalEXT(Display* display, GLXDrawable name, int interval) {
    const auto drawable = glx::find_drawable(display, name);
    if (!drawable) return glx::send_error(display, BadWindow, false, name, X_GLXVendorPrivate);
    // Below zero: GLX_EXT_swap_control_tear, which is not there.
    if (interval < 0)
        return glx::send_error(display, BadValue, false, static_cast<XID>(interval), X_GLXVendorPrivate);
    set_interval(*drawable, interval);
}

int glXSwapIntervalSGI(int interval) {
    const auto drawable = current_drawable();
    if (!drawable) return GLX_BAD_CONTEXT;
    if (interval <= 0) return GLX_BAD_VALUE;
    set_interval(*drawable, interval);
    return 0;
}

int glXSwapIntervalMESA(unsigned int interval) {
    const auto drawable = current_drawable();
    if (!drawable) return GLX_BAD_CONTEXT;
    if (interval > 0x7fff) return GLX_BAD_VALUE;
    set_interval(*drawable, static_cast<int>(interval));
    return 0;
}

int glXGetSwapIntervalMESA() {
    const auto drawable = current_drawable();
    return drawable ? drawable->swap_interval.load() : 0;
}

Bool glXGetSyncValuesOML(Display* display, GLXDrawable name, int64_t* ust, int64_t* msc, int64_t* sbc) {
    const auto drawable = glx::find_drawable(display, name);
    if (!drawable || !ust || !msc || !sbc) return False;
    *ust = window::current_ust();
    *msc = window::msc_at(*ust);
    *sbc = swap_count(*drawable);
    return True;
}

Bool glXGetMscRateOML(Display* display, GLXDrawable name, int32_t* numerator, int32_t* denominator) {
    if (!glx::find_drawable(display, name) || !numerator || !denominator) return False;
    *numerator = window::kRefreshRate;
    *denominator = 1;
    return True;
}

int64_t glXSwapBuffersMscOML(Display* display, GLXDrawable name, int64_t target, int64_t divisor,
                             int64_t remainder) {
    const auto drawable = glx::find_drawable(display, name);
    const bool wrong = target < 0 || divisor < 0 || remainder < 0 || (divisor > 0 && remainder >= divisor);
    if (!drawable || wrong) return -1;
    if (target > 0 || divisor > 0) window::wait_for_msc(target, divisor, remainder);
    glXSwapBuffers(display, name);
    return swap_count(*drawable);
}

Bool glXWaitForMscOML(Display* display, GLXDrawable name, int64_t target, int64_t divisor, int64_t remainder,
                      int64_t* ust, int64_t* msc, int64_t* sbc) {
    const bool wrong = target < 0 || divisor < 0 || remainder < 0 || (divisor > 0 && remainder >= divisor);
    if (wrong || !glx::find_drawable(display, name)) return False;
    window::wait_for_msc(target, divisor, remainder);
    return glXGetSyncValuesOML(display, name, ust, msc, sbc);
}

// Swaps are done when SwapBuffers returns: a count that lies ahead would be waited for for ever.
Bool glXWaitForSbcOML(Display* display, GLXDrawable name, int64_t target, int64_t* ust, int64_t* msc,
                      int64_t* sbc) {
    const auto drawable = glx::find_drawable(display, name);
    if (!drawable || target < 0 || target > swap_count(*drawable)) return False;
    return glXGetSyncValuesOML(display, name, ust, msc, sbc);
}

int glXGetVideoSyncSGI(unsigned int* count) {
    if (!glx::current_context()) return GLX_BAD_CONTEXT;
    if (!count) return GLX_BAD_VALUE;
    *count = static_cast<unsigned>(window::msc_at(window::current_ust()));
    return 0;
}

int glXWaitVideoSyncSGI(int divisor, int remainder, unsigned int* count) {
    if (!glx::current_context()) return GLX_BAD_CONTEXT;
    if (divisor <= 0 || remainder < 0 || remainder >= divisor || !count) return GLX_BAD_VALUE;
    const std::int64_t next = window::msc_at(window::current_ust()) + 1;
    const std::int64_t target = next + ((remainder - next) % divisor + divisor) % divisor;
    *count = static_cast<unsigned>(window::wait_for_msc(target, 0, 0));
    return 0;
}
