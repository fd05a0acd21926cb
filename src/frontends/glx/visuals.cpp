// Visuals, configurations and what can be asked of the library (GLX 1.4 §3.3.1-3.3.3).
#include <GL/glx.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>

#include "frontends/glx/display.h"
#include "frontends/glx/procs.h"
#include "frontends/glx/protocol.h"
#include "gl/entry.h"

namespace glx = terrazzo::glx;
using terrazzo::glx::registry;

namespace {

// The configurations of a screen; none where there is no such screen.
const std::vector<glx::Config>& configs_of(glx::DisplayState& state, int screen) {
    static const std::vector<glx::Config> none;
    return screen >= 0 && static_cast<std::size_t>(screen) < state.configs.size()
               ? state.configs[static_cast<std::size_t>(screen)]
               : none;
}

// An array that the program frees with XFree; null for an empty one.
GLXFBConfig* to_client(const std::vector<const glx::Config*>& configs, int* count) {
    if (count) *count = 0;
    if (configs.empty()) return nullptr;
    auto* out = static_cast<GLXFBConfig*>(std::malloc(configs.size() * sizeof(GLXFBConfig)));
    if (!out) return nullptr;
    if (count) *count = static_cast<int>(configs.size());
    std::ranges::transform(configs, out, [](const glx::Config* c) { return const_cast<GLXFBConfig>(c); });
    return out;
}

XVisualInfo* visual_info(Display* display, const glx::Config& config) {
    XVisualInfo wanted{};
    wanted.visualid = config.visual.id;
    wanted.screen = config.screen;
    int count = 0;
    return XGetVisualInfo(display, VisualIDMask | VisualScreenMask, &wanted, &count);
}

constexpr const char* kVendor = "Terrazzo";
constexpr const char* kVersion = "1.4";

const char* client_string(int name) {
    switch (name) {
        case GLX_VENDOR:
            return kVendor;
        case GLX_VERSION:
            return kVersion;
        case GLX_EXTENSIONS:
            return glx::extensions();
    }
    return nullptr;
}

}  // namespace

XVisualInfo* glXChooseVisual(Display* display, int screen, int* attributes) try {
    const auto state = registry().display(display);
    const auto fitting = glx::choose_for_visual(configs_of(*state, screen), attributes);
    if (fitting.empty()) return nullptr;
    // The program will say which of a visual's configurations it means by the visual alone.
    registry().use_for_visual(*state, *fitting.front());
    return visual_info(display, *fitting.front());
} catch (const std::exception&) {
    return nullptr;
}

int glXGetConfig(Display* display, XVisualInfo* visual, int name, int* value) try {
    if (!visual || !value) return GLX_BAD_VALUE;
    const auto state = registry().display(display);
    if (visual->screen < 0 || visual->screen >= ScreenCount(display)) return GLX_BAD_SCREEN;
    const glx::Config* config = registry().config_of_visual(*state, visual->screen, visual->visualid);
    if (name == GLX_USE_GL || name == GLX_RGBA) {
        *value = config != nullptr;
        return Success;
    }
    if (!config) return GLX_BAD_VISUAL;
    const auto answer = glx::attribute(*config, name);
    if (!answer) return GLX_BAD_ATTRIBUTE;
    *value = *answer;
    return Success;
} catch (const std::exception&) {
    return GLX_NO_EXTENSION;
}

GLXFBConfig* glXChooseFBConfig(Display* display, int screen, const int* attributes, int* count) try {
    const auto state = registry().display(display);
    return to_client(glx::choose(configs_of(*state, screen), attributes), count);
} catch (const std::exception&) {
    return to_client({}, count);
}

GLXFBConfig* glXGetFBConfigs(Display* display, int screen, int* count) try {
    const auto state = registry().display(display);
    std::vector<const glx::Config*> all;
    for (const glx::Config& config : configs_of(*state, screen)) all.push_back(&config);
    return to_client(all, count);
} catch (const std::exception&) {
    return to_client({}, count);
}

int glXGetFBConfigAttrib(Display* display, GLXFBConfig config, int name, int* value) {
    const auto state = registry().find_display(display);
    if (!state || !registry().is_config(*state, config)) {
        glx::send_error(display, GLXBadFBConfig, true, 0, X_GLXGetFBConfigs);
        return GLX_BAD_VALUE;
    }
    const auto answer = glx::attribute(*config, name);
    if (!answer) return GLX_BAD_ATTRIBUTE;
    if (value) *value = *answer;
    return Success;
}

XVisualInfo* glXGetVisualFromFBConfig(Display* display, GLXFBConfig config) {
    const auto state = registry().find_display(display);
    if (!state || !registry().is_config(*state, config)) {
        glx::send_error(display, GLXBadFBConfig, true, 0, X_GLXGetFBConfigs);
        return nullptr;
    }
    // A context made from this visual is to be one of this configuration.
    registry().use_for_visual(*state, *config);
    return visual_info(display, *config);
}

GLXFBConfig glXGetFBConfigFromVisualSGIX(Display* display, XVisualInfo* visual) try {
    if (!visual) return nullptr;
    const auto state = registry().display(display);
    return const_cast<GLXFBConfig>(registry().config_of_visual(*state, visual->screen, visual->visualid));
} catch (const std::exception&) {
    return nullptr;
}

Bool glXQueryExtension(Display* display, int* error_base, int* event_base) {
    int opcode = 0, event = 0, error = 0;
    // The server need not know GLX: nothing is asked of it.
    XQueryExtension(display, GLX_EXTENSION_NAME, &opcode, &event, &error);
    if (error_base) *error_base = error;
    if (event_base) *event_base = event;
    return True;
}

Bool glXQueryVersion(Display*, int* major, int* minor) {
    if (major) *major = 1;
    if (minor) *minor = 4;
    return True;
}

const char* glXQueryExtensionsString(Display*, int) {
    return glx::extensions();
}

const char* glXGetClientString(Display*, int name) {
    return client_string(name);
}

// There is no server's part: what it would say is what we say.
const char* glXQueryServerString(Display*, int, int name) {
    return client_string(name);
}

Bool glXQueryCurrentRendererIntegerMESA(int attribute, unsigned int* value) {
    const auto context = glx::current_context();
    return context && context->display->display
               ? glXQueryRendererIntegerMESA(context->display->display, context->screen, 0, attribute, value)
               : False;
}

Bool glXQueryRendererIntegerMESA(Display* display, int screen, int renderer, int attribute,
                                 unsigned int* value) try {
    const auto state = registry().display(display);
    if (!value || renderer != 0 || configs_of(*state, screen).empty()) return False;
    return glx::renderer_integer(attribute, value);
} catch (const std::exception&) {
    return False;
}

const char* glXQueryCurrentRendererStringMESA(int attribute) {
    return glx::current_context() ? glx::renderer_string(attribute) : nullptr;
}

const char* glXQueryRendererStringMESA(Display* display, int screen, int renderer, int attribute) try {
    const auto state = registry().display(display);
    return renderer == 0 && !configs_of(*state, screen).empty() ? glx::renderer_string(attribute) : nullptr;
} catch (const std::exception&) {
    return nullptr;
}
