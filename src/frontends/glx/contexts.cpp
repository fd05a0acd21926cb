// Contexts: making, sharing, copying and making them current (GLX 1.4 §3.3.7-3.3.10, GLX_ARB_create_context).
#include <GL/glx.h>

#include <exception>
#include <optional>

#include "frontends/glx/display.h"
#include "frontends/glx/drawables.h"
#include "frontends/glx/protocol.h"
#include "gl/attrib.h"
#include "gl/generated/dispatch.h"
#include "gl/surface.h"

namespace gl = terrazzo::gl;
namespace glx = terrazzo::glx;
namespace window = terrazzo::window;
using terrazzo::glx::registry;

namespace {

GLXContext fail(Display* display, int code, bool is_glx, XID resource, int minor) {
    glx::send_error(display, code, is_glx, resource, minor);
    return nullptr;
}

// `config` is null for contexts that go with any drawable.
GLXContext create(Display* display, const glx::Config* config, int screen, GLXContext share_list, bool direct,
                  int minor) try {
    const auto partner = registry().context(share_list);
    if (share_list && !partner) return fail(display, GLXBadContext, true, 0, minor);
    auto context = std::make_shared<glx::Context>();
    context->display = registry().display(display);
    context->config = config;
    context->screen = screen;
    context->asked_for_direct = direct;
    gl::Config wanted;
    if (config) {
        wanted.depth_bits = config->depth_bits;
        wanted.stencil_bits = config->stencil_bits;
        wanted.accum_bits = config->accum_bits;
        wanted.double_buffered = config->double_buffered;
    }
    context->gl = gl::create_context(wanted, partner ? partner->gl.get() : nullptr);
    context->id = xcb_generate_id(context->display->xcb());
    return registry().add(std::move(context));
} catch (const std::exception&) {
    return fail(display, BadAlloc, false, 0, minor);
}

// What glXCreateContextAttribsARB was asked for.
struct Request {
    int major = 1, minor = 0;
    int flags = 0, profile = GLX_CONTEXT_CORE_PROFILE_BIT_ARB;
    int render_type = GLX_RGBA_TYPE;
    // Named where there is no configuration to tell it (GLX_EXT_no_config_context).
    std::optional<int> screen;
    bool no_error = false;
};

// Empty for attributes and values that are none.
std::optional<Request> parse(const int* list) {
    Request out;
    for (; list && *list != None; list += 2) {
        const int value = list[1];
        switch (list[0]) {
            case GLX_CONTEXT_MAJOR_VERSION_ARB:
                out.major = value;
                break;
            case GLX_CONTEXT_MINOR_VERSION_ARB:
                out.minor = value;
                break;
            case GLX_CONTEXT_FLAGS_ARB:
                out.flags = value;
                break;
            case GLX_CONTEXT_PROFILE_MASK_ARB:
                out.profile = value;
                break;
            case GLX_RENDER_TYPE:
                if (value != GLX_RGBA_TYPE && value != GLX_COLOR_INDEX_TYPE) return {};
                out.render_type = value;
                break;
            case GLX_SCREEN:
                out.screen = value;
                break;
            case GLX_CONTEXT_RESET_NOTIFICATION_STRATEGY_ARB:
                if (value != GLX_NO_RESET_NOTIFICATION_ARB && value != GLX_LOSE_CONTEXT_ON_RESET_ARB)
                    return {};
                break;
            case GLX_CONTEXT_RELEASE_BEHAVIOR_ARB:
                if (value != GLX_CONTEXT_RELEASE_BEHAVIOR_FLUSH_ARB &&
                    value != GLX_CONTEXT_RELEASE_BEHAVIOR_NONE_ARB)
                    return {};
                break;
            case GLX_CONTEXT_OPENGL_NO_ERROR_ARB:
                out.no_error = value != 0;
                break;
            default:
                return {};
        }
    }
    return out;
}

bool is_a_version(int major, int minor) {
    constexpr int kLastMinor[] = {5, 1, 3, 6};  // of OpenGL 1 to 4
    return major >= 1 && major <= 4 && minor >= 0 && minor <= kLastMinor[major - 1];
}

struct Refusal {
    int code;
    bool is_glx;
};

// Why there is no such context, if there is none: GLX_ARB_create_context's and _profile's errors.
std::optional<Refusal> check(const Request& wanted) {
    constexpr int kRobust = GLX_CONTEXT_ROBUST_ACCESS_BIT_ARB;
    constexpr int kForward = GLX_CONTEXT_FORWARD_COMPATIBLE_BIT_ARB;
    if (wanted.flags & ~(GLX_CONTEXT_DEBUG_BIT_ARB | kForward | kRobust)) return Refusal{BadValue, false};
    if (!is_a_version(wanted.major, wanted.minor)) return Refusal{BadMatch, false};
    // One profile. Versions before 3.2 have none and take either for what they are.
    if (wanted.profile != GLX_CONTEXT_CORE_PROFILE_BIT_ARB &&
        wanted.profile != GLX_CONTEXT_COMPATIBILITY_PROFILE_BIT_ARB)
        return Refusal{GLXBadProfileARB, true};
    const int version = wanted.major * 10 + wanted.minor;
    if (version < 30 && (wanted.flags & kForward)) return Refusal{BadMatch, false};
    if (wanted.no_error && (wanted.flags & (GLX_CONTEXT_DEBUG_BIT_ARB | kRobust)))
        return Refusal{BadMatch, false};
    if (version > gl::kGlMajorVersion * 10 + gl::kGlMinorVersion) return Refusal{GLXBadFBConfig, true};
    if (wanted.render_type != GLX_RGBA_TYPE) return Refusal{BadMatch, false};
    return {};
}

}  // namespace

GLXContext glXCreateContext(Display* display, XVisualInfo* visual, GLXContext share_list, Bool direct) try {
    if (!visual) return fail(display, BadValue, false, 0, X_GLXCreateContext);
    const auto state = registry().display(display);
    const glx::Config* config = registry().config_of_visual(*state, visual->screen, visual->visualid);
    if (!config) return fail(display, BadValue, false, visual->visualid, X_GLXCreateContext);
    return create(display, config, visual->screen, share_list, direct, X_GLXCreateContext);
} catch (const std::exception&) {
    return fail(display, BadAlloc, false, 0, X_GLXCreateContext);
}

GLXContext glXCreateNewContext(Display* display, GLXFBConfig config, int render_type, GLXContext share_list,
                               Bool direct) {
    const auto state = registry().find_display(display);
    if (!state || !registry().is_config(*state, config))
        return fail(display, GLXBadFBConfig, true, 0, X_GLXCreateNewContext);
    if (render_type != GLX_RGBA_TYPE) {
        const bool known = render_type == GLX_COLOR_INDEX_TYPE;
        return fail(display, known ? BadMatch : BadValue, false, 0, X_GLXCreateNewContext);
    }
    return create(display, config, config->screen, share_list, direct, X_GLXCreateNewContext);
}

GLXContext glXCreateContextAttribsARB(Display* display, GLXFBConfig config, GLXContext share_list,
                                      Bool direct, const int* attributes) try {
    constexpr int kMinor = X_GLXCreateContextAttribsARB;
    const auto state = registry().display(display);
    if (config && !registry().is_config(*state, config))
        return fail(display, GLXBadFBConfig, true, 0, kMinor);
    const auto wanted = parse(attributes);
    if (!wanted) return fail(display, BadValue, false, 0, kMinor);
    const int screen = wanted->screen.value_or(config ? config->screen : DefaultScreen(display));
    if (screen < 0 || screen >= ScreenCount(display)) return fail(display, BadValue, false, 0, kMinor);
    if (config && screen != config->screen) return fail(display, BadMatch, false, 0, kMinor);
    if (const auto refusal = check(*wanted)) return fail(display, refusal->code, refusal->is_glx, 0, kMinor);
    return create(display, config, screen, share_list, direct, kMinor);
} catch (const std::exception&) {
    return fail(display, BadAlloc, false, 0, X_GLXCreateContextAttribsARB);
}

void glXDestroyContext(Display* display, GLXContext handle) {
    if (!registry().context(handle))
        return glx::send_error(display, GLXBadContext, true, 0, X_GLXDestroyContext);
    // A thread that has it current keeps it; to destroy it again then does nothing.
    registry().remove(handle);
}

void glXCopyContext(Display* display, GLXContext source, GLXContext destination, unsigned long mask) try {
    const auto from = registry().context(source), to = registry().context(destination);
    if (!from || !to) return glx::send_error(display, GLXBadContext, true, 0, X_GLXCopyContext);
    // Neither of the two becomes current elsewhere while one is copied.
    const bool is_reachable = from != glx::current_context() && from != to;
    const window::Reservation reserved(*to, is_reachable ? from.get() : nullptr);
    if (!reserved) return glx::send_error(display, BadAccess, false, 0, X_GLXCopyContext);
    if (from->display != to->display || from->screen != to->screen)
        return glx::send_error(display, BadMatch, false, 0, X_GLXCopyContext);
    gl::copy_attributes(*from->gl, *to->gl, static_cast<GLbitfield>(mask));
} catch (const std::exception&) {
    glx::send_error(display, BadAlloc, false, 0, X_GLXCopyContext);
}

namespace {

// A context goes with drawables of its screen, depth of colour and kind of buffers (GLX 1.4 §2.1).
bool compatible(const glx::Context& context, const glx::Drawable& drawable) {
    if (!context.config || !drawable.config) return true;
    const glx::Config &a = *context.config, &b = *drawable.config;
    return a.screen == b.screen && a.visual.color == b.visual.color;
}

Bool make_current(Display* display, GLXDrawable draw, GLXDrawable read, GLXContext handle, int minor) try {
    if (!handle && !draw && !read) {
        if (glx::current_context()) window::make_current({});
        return True;
    }
    const auto refuse = [&](int code, bool is_glx, XID resource) {
        glx::send_error(display, code, is_glx, resource, minor);
        return False;
    };
    const auto context = registry().context(handle);
    if (!context) return handle ? refuse(GLXBadContext, true, 0) : refuse(BadMatch, false, 0);
    if (!draw != !read) return refuse(BadMatch, false, 0);
    const auto state = registry().display(display);
    if (context->display != state) return refuse(BadMatch, false, 0);
    std::shared_ptr<glx::Drawable> to, from;
    if (draw) {
        to = glx::drawable_for(*state, draw, context->config);
        from = read == draw ? to : glx::drawable_for(*state, read, context->config);
        if (!to) return refuse(GLXBadDrawable, true, draw);
        if (!from) return refuse(GLXBadDrawable, true, read);
        if (!compatible(*context, *to) || !compatible(*context, *from)) return refuse(BadMatch, false, draw);
        to->buffers->follow_window(gl::Follow::kOncePerPicture);
        if (from != to) from->buffers->follow_window(gl::Follow::kOncePerPicture);
    }
    if (!window::make_current({context, to ? to->buffers : nullptr, from ? from->buffers : nullptr}))
        return refuse(BadAccess, false, 0);
    context->draw = draw;
    context->read = read;
    return True;
} catch (const std::exception&) {
    glx::send_error(display, BadAlloc, false, 0, minor);
    return False;
}

}  // namespace

Bool glXMakeCurrent(Display* display, GLXDrawable drawable, GLXContext context) {
    return make_current(display, drawable, drawable, context, X_GLXMakeCurrent);
}

Bool glXMakeContextCurrent(Display* display, GLXDrawable draw, GLXDrawable read, GLXContext context) {
    return make_current(display, draw, read, context, X_GLXMakeContextCurrent);
}

GLXContext glXGetCurrentContext() {
    return glx::current_context().get();
}

GLXDrawable glXGetCurrentDrawable() {
    const auto context = glx::current_context();
    return context ? context->draw : 0;
}

GLXDrawable glXGetCurrentReadDrawable() {
    const auto context = glx::current_context();
    return context ? context->read : 0;
}

Display* glXGetCurrentDisplay() {
    const auto context = glx::current_context();
    return context ? context->display->display.load() : nullptr;
}

Bool glXIsDirect(Display* display, GLXContext handle) {
    if (registry().context(handle)) return True;
    glx::send_error(display, GLXBadContext, true, 0, X_GLXIsDirect);
    return False;
}

int glXQueryContext(Display* display, GLXContext handle, int name, int* value) {
    const auto context = registry().context(handle);
    if (!context) {
        glx::send_error(display, GLXBadContext, true, 0, X_GLXQueryContext);
        return GLX_BAD_CONTEXT;
    }
    int answer = 0;
    switch (name) {
        case GLX_FBCONFIG_ID:
            answer = context->config ? context->config->id : 0;
            break;
        case GLX_VISUAL_ID:
            answer = context->config ? static_cast<int>(context->config->visual.id) : 0;
            break;
        case GLX_RENDER_TYPE:
            answer = GLX_RGBA_TYPE;
            break;
        case GLX_SCREEN:
            answer = context->screen;
            break;
        default:
            return GLX_BAD_ATTRIBUTE;
    }
    if (value) *value = answer;
    return Success;
}

GLXContextID glXGetContextIDEXT(const GLXContext handle) {
    const auto context = registry().context(handle);
    return context ? context->id : 0;
}
