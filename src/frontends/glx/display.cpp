// See display.h.
#include "frontends/glx/display.h"

#include <GL/glx.h>
#include <X11/Xlib-xcb.h>
#include <X11/Xlibint.h>

#include "frontends/glx/protocol.h"
#undef min
#undef max

#include <algorithm>

namespace terrazzo::glx {

namespace {

// Xlib finds out about a server that has gone when it is asked something, and calls the program's handler.
void ask_xlib(void* display) {
    XSync(static_cast<::Display*>(display), False);
}

}  // namespace

Registry& registry() {
    // Never destroyed: programs call GLX from their own destructors.
    static Registry& the_registry = *new Registry;
    return the_registry;
}

std::shared_ptr<DisplayState> Registry::display(::Display* display) {
    const std::lock_guard lock(m_mutex);
    if (const auto known = m_displays.find(display); known != m_displays.end()) return known->second;
    auto state = std::make_shared<DisplayState>();
    state->display = display;
    const auto connection = x11::inspect(XGetXCBConnection(display), false);
    connection->lost = ask_xlib;
    connection->owner = display;
    state->connection = connection;
    int first_id = 1;
    for (std::size_t s = 0; s < connection->screens.size(); ++s) {
        state->configs.push_back(make_configs(connection->screens[s], static_cast<int>(s), first_id));
        first_id += static_cast<int>(state->configs.back().size());
    }
    for (const auto& configs : state->configs) {
        for (const Config& config : configs) state->visual_configs.emplace(config.visual.id, &config);
    }
    if (XExtCodes* codes = XAddExtension(display))
        XESetCloseDisplay(display, codes->extension, &close_display);
    m_displays.emplace(display, state);
    return state;
}

std::shared_ptr<DisplayState> Registry::find_display(::Display* display) {
    const std::lock_guard lock(m_mutex);
    const auto known = m_displays.find(display);
    return known == m_displays.end() ? nullptr : known->second;
}

// Called by XCloseDisplay.
int Registry::close_display(::Display* display, XExtCodes*) {
    registry().forget(display);
    return 0;
}

void Registry::forget(::Display* display) {
    std::shared_ptr<DisplayState> state;
    std::map<XID, std::shared_ptr<Drawable>> last;  // die without the lock
    {
        const std::lock_guard lock(m_mutex);
        const auto known = m_displays.find(display);
        if (known == m_displays.end()) return;
        state = std::move(known->second);
        m_displays.erase(known);
        last.swap(state->drawables);
    }
    state->display = nullptr;
    x11::abandon_drawables(*state->connection);
}

std::shared_ptr<Context> Registry::context(GLXContext handle) {
    const std::lock_guard lock(m_mutex);
    const auto known = m_contexts.find(handle);
    return known == m_contexts.end() ? nullptr : known->second.living.lock();
}

GLXContext Registry::add(std::shared_ptr<Context> context) {
    const std::lock_guard lock(m_mutex);
    std::erase_if(m_contexts, [](const auto& known) { return known.second.living.expired(); });
    const GLXContext handle = context.get();
    m_contexts.insert_or_assign(handle, KnownContext{context, context});
    return handle;
}

void Registry::remove(GLXContext handle) {
    std::shared_ptr<Context> last;  // dies without the lock
    const std::lock_guard lock(m_mutex);
    const auto known = m_contexts.find(handle);
    if (known != m_contexts.end()) last = std::move(known->second.owner);
}

std::shared_ptr<Drawable> Registry::drawable(DisplayState& display, GLXDrawable name) {
    const std::lock_guard lock(m_mutex);
    const auto known = display.drawables.find(name);
    return known == display.drawables.end() ? nullptr : known->second;
}

bool Registry::add(DisplayState& display, GLXDrawable name, const std::shared_ptr<Drawable>& before,
                   std::shared_ptr<Drawable> drawable) {
    const std::lock_guard lock(m_mutex);
    const auto known = display.drawables.find(name);
    if ((known == display.drawables.end() ? nullptr : known->second) != before) return false;
    display.drawables.insert_or_assign(name, std::move(drawable));
    return true;
}

std::shared_ptr<Drawable> Registry::remove(DisplayState& display, GLXDrawable name) {
    const std::lock_guard lock(m_mutex);
    const auto known = display.drawables.find(name);
    if (known == display.drawables.end()) return nullptr;
    std::shared_ptr<Drawable> last = std::move(known->second);
    display.drawables.erase(known);
    return last;
}

std::vector<XID> Registry::unused_windows(DisplayState& display) {
    const std::lock_guard lock(m_mutex);
    std::vector<XID> names;
    for (const auto& [name, drawable] : display.drawables) {
        if (drawable->is_x_window && drawable->buffers.use_count() == 1) names.push_back(name);
    }
    return names;
}

const Config* Registry::config_of_visual(DisplayState& display, int screen, VisualID visual) {
    const std::lock_guard lock(m_mutex);
    const auto known = display.visual_configs.find(visual);
    return known != display.visual_configs.end() && known->second->screen == screen ? known->second : nullptr;
}

void Registry::use_for_visual(DisplayState& display, const Config& config) {
    const std::lock_guard lock(m_mutex);
    display.visual_configs[config.visual.id] = &config;
}

bool Registry::is_config(DisplayState& display, GLXFBConfig config) {
    return std::ranges::any_of(display.configs, [&](const std::vector<Config>& configs) {
        return std::ranges::any_of(configs, [&](const Config& c) { return &c == config; });
    });
}

std::shared_ptr<Drawable> find_drawable(::Display* display, GLXDrawable name) {
    const auto state = registry().find_display(display);
    return state ? registry().drawable(*state, name) : nullptr;
}

std::shared_ptr<Context> current_context() {
    const window::Binding& binding = window::current_binding();
    if (!binding.context || binding.context->interface != window::Interface::kGlx) return nullptr;
    return std::static_pointer_cast<Context>(binding.context);
}

namespace {

// The core error that comes nearest, for servers without GLX: they have set aside no numbers for its errors.
int core_error(int glx_error) {
    switch (glx_error) {
        case GLXBadDrawable:
        case GLXBadPbuffer:
            return BadDrawable;
        case GLXBadPixmap:
            return BadPixmap;
        case GLXBadWindow:
            return BadWindow;
        default:
            return BadValue;
    }
}

}  // namespace

void send_error(::Display* display, int code, bool is_glx, XID resource, int minor) {
    int opcode = 0, first_event = 0, first_error = 0;
    const bool has_glx = XQueryExtension(display, GLX_EXTENSION_NAME, &opcode, &first_event, &first_error);
    if (is_glx) code = has_glx ? first_error + code : core_error(code);
    LockDisplay(display);
    xError error{};
    error.type = X_Error;
    error.errorCode = static_cast<CARD8>(code);
    error.sequenceNumber = static_cast<CARD16>(display->request);
    error.resourceID = static_cast<CARD32>(resource);
    error.minorCode = static_cast<CARD16>(minor);
    error.majorCode = static_cast<CARD8>(opcode);
    _XError(display, &error);
    UnlockDisplay(display);
}

}  // namespace terrazzo::glx
