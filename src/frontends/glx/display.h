// What GLX remembers: displays with their configurations, drawables and contexts.
//
// One lock guards all of it. It is never held while something is drawn or the server is waited for, except
// when a display is met for the first time. Objects are handed out as shared_ptr, so what another thread
// destroys meanwhile stays good. What may change of a drawable or a display that is open is atomic, or the
// registry's.
#pragma once

#include <GL/glx.h>

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "frontends/glx/config.h"
#include "frontends/window/current.h"
#include "frontends/x11/drawable.h"

namespace terrazzo::glx {

enum class Kind { kWindow, kPixmap, kPbuffer };

// A GLXDrawable: what glXCreateWindow, ...Pixmap and ...Pbuffer made, or a window that was made current as it
// was.
struct Drawable {
    Kind kind = Kind::kWindow;
    bool is_x_window = false;  // its name is the window's own
    XID server_id = 0;         // the window or pixmap; 0 for pbuffers
    const Config* config = nullptr;
    std::shared_ptr<gl::Drawable> buffers;
    x11::ServerDrawable* server = nullptr;  // the same, null for pbuffers
    std::atomic<unsigned long> event_mask = 0;
    bool is_largest = false, is_preserved = false;  // of a pbuffer
    int texture_format = GLX_TEXTURE_FORMAT_NONE_EXT, texture_target = 0;
    bool texture_mipmaps = false;
    std::atomic<int> swap_interval = 0;
    std::atomic<std::int64_t> last_msc = 0;  // of the last swap that waited
};

// One per Display; outlives it where contexts still refer to it.
struct DisplayState {
    std::atomic<::Display*> display = nullptr;  // null once it is closed
    std::shared_ptr<const x11::Connection> connection;
    std::vector<std::vector<Config>> configs;  // by screen
    // The registry's.
    std::map<VisualID, const Config*> visual_configs;  // what glXGetConfig says of a visual
    std::map<XID, std::shared_ptr<Drawable>> drawables;

    xcb_connection_t* xcb() const { return connection->xcb; }
};

}  // namespace terrazzo::glx

// What a GLXContext points at.
struct __GLXcontextRec : terrazzo::window::Context {
    __GLXcontextRec() : Context(terrazzo::window::Interface::kGlx) {}

    std::shared_ptr<terrazzo::glx::DisplayState> display;
    const terrazzo::glx::Config* config = nullptr;  // null: made without (GLX_EXT_no_config_context)
    int screen = 0;
    XID id = 0;
    bool asked_for_direct = true;
    // While it is current.
    GLXDrawable draw = 0, read = 0;
};

namespace terrazzo::glx {

using Context = __GLXcontextRec;

class Registry {
  public:
    // Of a display that is open. Asks the server the first time. Throws std::bad_alloc.
    std::shared_ptr<DisplayState> display(::Display* display);
    // Null when nothing is known of it: it need not be open.
    std::shared_ptr<DisplayState> find_display(::Display* display);

    // Null for what is no context of ours. One that was removed is one as long as a thread has it current
    // (GLX 1.4 §3.3.7).
    std::shared_ptr<Context> context(GLXContext handle);
    GLXContext add(std::shared_ptr<Context> context);
    void remove(GLXContext handle);

    std::shared_ptr<Drawable> drawable(DisplayState& display, GLXDrawable name);
    // In place of `before`, null for none; false if it is another thread's by now. Throws std::bad_alloc.
    bool add(DisplayState& display, GLXDrawable name, const std::shared_ptr<Drawable>& before,
             std::shared_ptr<Drawable> drawable);
    // The one of that name, from now on nobody's; null if there is none.
    std::shared_ptr<Drawable> remove(DisplayState& display, GLXDrawable name);
    // Windows that were made current as they were and are so nowhere at the moment. Throws std::bad_alloc.
    std::vector<XID> unused_windows(DisplayState& display);

    // The configuration that stands for a visual: the last one that glXChooseVisual answered with it.
    const Config* config_of_visual(DisplayState& display, int screen, VisualID visual);
    void use_for_visual(DisplayState& display, const Config& config);
    // Whether it is one of the display's.
    bool is_config(DisplayState& display, GLXFBConfig config);

  private:
    static int close_display(::Display* display, XExtCodes* codes);
    void forget(::Display* display);

    struct KnownContext {
        std::shared_ptr<Context> owner;  // null once it was removed
        std::weak_ptr<Context> living;
    };

    std::mutex m_mutex;
    std::map<::Display*, std::shared_ptr<DisplayState>> m_displays;
    std::map<GLXContext, KnownContext> m_contexts;
};

Registry& registry();

// Null for what is no drawable of a display that GLX knows.
std::shared_ptr<Drawable> find_drawable(::Display* display, GLXDrawable name);

// The calling thread's context if it is GLX's, else null.
std::shared_ptr<Context> current_context();

// Sends the program an X error as if the server had (GLX 1.4 §3.2). `code` is a core error, or one of GLX
// when `is_glx`; `minor` is the request's number in GLX's protocol.
void send_error(::Display* display, int code, bool is_glx, XID resource, int minor);

}  // namespace terrazzo::glx
