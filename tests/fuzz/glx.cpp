// GLX on the X server that DISPLAY names: windows, pixmaps and pbuffers, contexts and what is asked of them,
// named by handles of which many are dead or were never given out; see window_system.h. Displays and X's own
// objects are real.
#include <GL/glx.h>
#include <GL/glxext.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "fuzz/arguments.h"
#include "fuzz/handles.h"
#include "fuzz/window_system.h"

namespace terrazzo::fuzz {
namespace {

struct Functions {
    explicit Functions(const Library& library) {
#define TERRAZZO_FIND(name) library.find("glX" #name, name)
        TERRAZZO_FIND(GetFBConfigs), TERRAZZO_FIND(ChooseFBConfig), TERRAZZO_FIND(ChooseVisual),
            TERRAZZO_FIND(GetFBConfigAttrib), TERRAZZO_FIND(GetVisualFromFBConfig);
        TERRAZZO_FIND(CreateNewContext), TERRAZZO_FIND(CreateContext), TERRAZZO_FIND(DestroyContext),
            TERRAZZO_FIND(CopyContext), TERRAZZO_FIND(MakeCurrent);
        TERRAZZO_FIND(MakeContextCurrent), TERRAZZO_FIND(GetCurrentContext),
            TERRAZZO_FIND(GetCurrentDrawable), TERRAZZO_FIND(IsDirect), TERRAZZO_FIND(QueryContext);
        TERRAZZO_FIND(CreateWindow), TERRAZZO_FIND(CreatePixmap), TERRAZZO_FIND(CreatePbuffer),
            TERRAZZO_FIND(DestroyWindow), TERRAZZO_FIND(DestroyPixmap);
        TERRAZZO_FIND(DestroyPbuffer), TERRAZZO_FIND(QueryDrawable), TERRAZZO_FIND(SelectEvent),
            TERRAZZO_FIND(GetSelectedEvent), TERRAZZO_FIND(SwapBuffers);
        TERRAZZO_FIND(WaitGL), TERRAZZO_FIND(WaitX), TERRAZZO_FIND(UseXFont), TERRAZZO_FIND(GetClientString),
            TERRAZZO_FIND(QueryServerString);
        TERRAZZO_FIND(QueryExtensionsString), TERRAZZO_FIND(GetConfig), TERRAZZO_FIND(GetProcAddress);
#undef TERRAZZO_FIND
#define TERRAZZO_FIND(name) proc_address("glX" #name, name)
        TERRAZZO_FIND(CreateContextAttribsARB), TERRAZZO_FIND(BindTexImageEXT),
            TERRAZZO_FIND(ReleaseTexImageEXT), TERRAZZO_FIND(CopySubBufferMESA);
        TERRAZZO_FIND(SwapIntervalEXT), TERRAZZO_FIND(SwapIntervalMESA), TERRAZZO_FIND(GetSyncValuesOML),
            TERRAZZO_FIND(GetVideoSyncSGI);
#undef TERRAZZO_FIND
    }

    template <typename Type>
    void proc_address(const char* name, Type*& out) const {
        out = reinterpret_cast<Type*>(GetProcAddress(reinterpret_cast<const GLubyte*>(name)));
    }

    decltype(glXGetFBConfigs)* GetFBConfigs;
    decltype(glXChooseFBConfig)* ChooseFBConfig;
    decltype(glXChooseVisual)* ChooseVisual;
    decltype(glXGetFBConfigAttrib)* GetFBConfigAttrib;
    decltype(glXGetVisualFromFBConfig)* GetVisualFromFBConfig;
    decltype(glXCreateNewContext)* CreateNewContext;
    decltype(glXCreateContext)* CreateContext;
    decltype(glXDestroyContext)* DestroyContext;
    decltype(glXCopyContext)* CopyContext;
    decltype(glXMakeCurrent)* MakeCurrent;
    decltype(glXMakeContextCurrent)* MakeContextCurrent;
    decltype(glXGetCurrentContext)* GetCurrentContext;
    decltype(glXGetCurrentDrawable)* GetCurrentDrawable;
    decltype(glXIsDirect)* IsDirect;
    decltype(glXQueryContext)* QueryContext;
    decltype(glXCreateWindow)* CreateWindow;
    decltype(glXCreatePixmap)* CreatePixmap;
    decltype(glXCreatePbuffer)* CreatePbuffer;
    decltype(glXDestroyWindow)* DestroyWindow;
    decltype(glXDestroyPixmap)* DestroyPixmap;
    decltype(glXDestroyPbuffer)* DestroyPbuffer;
    decltype(glXQueryDrawable)* QueryDrawable;
    decltype(glXSelectEvent)* SelectEvent;
    decltype(glXGetSelectedEvent)* GetSelectedEvent;
    decltype(glXSwapBuffers)* SwapBuffers;
    decltype(glXWaitGL)* WaitGL;
    decltype(glXWaitX)* WaitX;
    decltype(glXUseXFont)* UseXFont;
    decltype(glXGetClientString)* GetClientString;
    decltype(glXQueryServerString)* QueryServerString;
    decltype(glXQueryExtensionsString)* QueryExtensionsString;
    decltype(glXGetConfig)* GetConfig;
    decltype(glXGetProcAddress)* GetProcAddress;
    std::remove_pointer_t<PFNGLXCREATECONTEXTATTRIBSARBPROC>* CreateContextAttribsARB;
    std::remove_pointer_t<PFNGLXBINDTEXIMAGEEXTPROC>* BindTexImageEXT;
    std::remove_pointer_t<PFNGLXRELEASETEXIMAGEEXTPROC>* ReleaseTexImageEXT;
    std::remove_pointer_t<PFNGLXCOPYSUBBUFFERMESAPROC>* CopySubBufferMESA;
    std::remove_pointer_t<PFNGLXSWAPINTERVALEXTPROC>* SwapIntervalEXT;
    std::remove_pointer_t<PFNGLXSWAPINTERVALMESAPROC>* SwapIntervalMESA;
    std::remove_pointer_t<PFNGLXGETSYNCVALUESOMLPROC>* GetSyncValuesOML;
    std::remove_pointer_t<PFNGLXGETVIDEOSYNCSGIPROC>* GetVideoSyncSGI;
};

constexpr int kAttributes[] = {GLX_RGBA,
                               GLX_DOUBLEBUFFER,
                               GLX_RED_SIZE,
                               GLX_DEPTH_SIZE,
                               GLX_STENCIL_SIZE,
                               GLX_ACCUM_RED_SIZE,
                               GLX_SAMPLES,
                               GLX_SAMPLE_BUFFERS,
                               GLX_X_VISUAL_TYPE,
                               GLX_DRAWABLE_TYPE,
                               GLX_RENDER_TYPE,
                               GLX_FBCONFIG_ID,
                               GLX_WIDTH,
                               GLX_HEIGHT,
                               GLX_PBUFFER_WIDTH,
                               GLX_PBUFFER_HEIGHT,
                               GLX_LARGEST_PBUFFER,
                               GLX_PRESERVED_CONTENTS,
                               GLX_EVENT_MASK,
                               GLX_SCREEN,
                               GLX_CONTEXT_MAJOR_VERSION_ARB,
                               GLX_CONTEXT_MINOR_VERSION_ARB,
                               GLX_CONTEXT_FLAGS_ARB,
                               GLX_CONTEXT_PROFILE_MASK_ARB,
                               GLX_TEXTURE_TARGET_EXT,
                               GLX_TEXTURE_FORMAT_EXT,
                               GLX_MIPMAP_TEXTURE_EXT,
                               GLX_Y_INVERTED_EXT,
                               GLX_USE_GL,
                               GLX_LEVEL,
                               GLX_CONFIG_CAVEAT};

int draw_attribute(Random& random) {
    return random.one_in(8) ? static_cast<int>(draw_integer(random))
                            : kAttributes[random.below(std::size(kAttributes))];
}

// Attributes and values in memory of exactly their size. Where some attributes have no value, either of the
// two None at the end may be one.
class AttributeList {
  public:
    AttributeList(Random& random, std::initializer_list<int> first, std::size_t ends = 1)
        : m_block((first.size() + 2 * (random.one_in(2) ? 0 : random.below(4)) + ends) * sizeof(int)) {
        int* const list = reinterpret_cast<int*>(m_block.data());
        std::size_t at = 0;
        for (const int value : first) list[at++] = value;
        for (; at + ends < m_block.size() / sizeof(int); ++at) {
            // Neither an attribute nor a value is the end of the list.
            list[at] = at % 2 == first.size() % 2 ? draw_attribute(random)
                       : random.one_in(4)         ? static_cast<int>(draw_integer(random))
                                                  : random.between(1, 20);
            if (list[at] == None) list[at] = 1;
        }
        std::fill_n(list + at, ends, None);
    }
    int* data() const { return reinterpret_cast<int*>(m_block.data()); }

  private:
    Block m_block;
};

int ignore_error(Display*, XErrorEvent*) {
    return 0;
}

class Glx : public WindowSystem {
  public:
    explicit Glx(const Library& library) : glx(library) {
        XInitThreads();
        XSetErrorHandler(ignore_error);
        m_display = XOpenDisplay(nullptr);
        if (!m_display) {
            std::fprintf(stderr, "fuzz: there is no X server\n");
            std::exit(2);
        }
        int count = 0;
        GLXFBConfig* const configs = glx.GetFBConfigs(m_display, DefaultScreen(m_display), &count);
        for (int i = 0; i < count; ++i) m_configs.add(configs[i]);
        XFree(configs);
    }

    ~Glx() override { XCloseDisplay(m_display); }

    void enter(Session& session, Random& random) override {
        create_drawable(session, random);
        create_context(session, random);
        make_current(session, random);
    }

    void leave(Session& session) override {
        glx.MakeCurrent(m_display, None, nullptr);
        session.set_model(nullptr);
    }

    void change_context(Session& session, Random& random) override { make_current(session, random); }

    void operate(Session& session, Random& random) override {
        using Operation = void (Glx::*)(Session&, Random&);
        static constexpr Operation kOperations[] = {&Glx::create_context,
                                                    &Glx::create_drawable,
                                                    &Glx::make_current,
                                                    &Glx::make_current,
                                                    &Glx::destroy,
                                                    &Glx::swap,
                                                    &Glx::swap,
                                                    &Glx::query,
                                                    &Glx::query,
                                                    &Glx::configs,
                                                    &Glx::tex_image,
                                                    &Glx::change_window,
                                                    &Glx::copy,
                                                    &Glx::font,
                                                    &Glx::sync};
        (this->*random.one_of(kOperations))(session, random);
        follow(session);
    }

  private:
    // A context that is destroyed stays current, and its handle may be given out again meanwhile: the model
    // changes with the handle, and when a context has been made current.
    void follow(Session& session, bool is_made_current = false) {
        static thread_local GLXContext before = nullptr;
        const GLXContext now = glx.GetCurrentContext();
        if (is_made_current || now != before || !now) session.set_model(now ? m_models.find(now) : nullptr);
        before = now;
    }

    GLXFBConfig config(Random& random) const {
        return random.one_in(24) ? reinterpret_cast<GLXFBConfig>(random.bits()) : m_configs.draw(random);
    }
    GLXContext context(Random& random) const {
        return random.one_in(24) ? reinterpret_cast<GLXContext>(random.bits()) : m_contexts.draw(random);
    }
    GLXDrawable drawable(Random& random) const {
        return random.one_in(24) ? random.bits() >> random.below(64) : m_drawables.draw(random);
    }

    void create_context(Session& session, Random& random) {
        const GLXFBConfig of = config(random);
        const GLXContext share = random.one_in(2) ? context(random) : nullptr;
        const AttributeList attributes(random, {});
        GLXContext made = nullptr;
        {
            const Session::Announced call(
                session, "glXCreateContext",
                "context = glXCreateContext, glXCreateNewContext or glXCreateContextAttribsARB");
            switch (random.below(3)) {
                case 0:
                    made = glx.CreateNewContext(
                        m_display, of,
                        random.one_in(12) ? static_cast<int>(draw_integer(random)) : GLX_RGBA_TYPE, share,
                        True);
                    break;
                case 1:
                    made = glx.CreateContextAttribsARB(m_display, of, share, True, attributes.data());
                    break;
                default:
                    if (XVisualInfo* const visual = glx.GetVisualFromFBConfig(m_display, of)) {
                        made = glx.CreateContext(m_display, visual, share, True);
                        XFree(visual);
                    }
            }
        }
        if (!made) return;
        m_models.make(made);
        m_contexts.add(made);
    }

    void create_drawable(Session& session, Random& random) {
        const GLXFBConfig of = config(random);
        const unsigned width = static_cast<unsigned>(random.between(1, 90)),
                       height = static_cast<unsigned>(random.between(1, 90));
        const AttributeList none(random, {}),
            size(random, {GLX_PBUFFER_WIDTH, random.one_in(16) ? -1 : static_cast<int>(width),
                          GLX_PBUFFER_HEIGHT, static_cast<int>(height)});
        const Session::Announced call(
            session, "glXCreateWindow",
            "drawable = XCreateWindow, glXCreateWindow, glXCreatePixmap or glXCreatePbuffer");
        const unsigned kind = random.below(4);
        if (kind == 3) return m_drawables.add(glx.CreatePbuffer(m_display, of, size.data()));
        XVisualInfo* const visual = glx.GetVisualFromFBConfig(m_display, of);
        if (!visual) return;
        const Window root = RootWindow(m_display, visual->screen);
        if (kind == 2) {
            const Pixmap pixmap =
                XCreatePixmap(m_display, root, width, height, static_cast<unsigned>(visual->depth));
            m_drawables.add(glx.CreatePixmap(m_display, of, pixmap, none.data()));
        } else {
            XSetWindowAttributes values{};
            values.colormap = XCreateColormap(m_display, root, visual->visual, AllocNone);
            const Window window =
                XCreateWindow(m_display, root, 0, 0, width, height, 0, visual->depth, InputOutput,
                              visual->visual, CWColormap | CWBorderPixel, &values);
            XMapWindow(m_display, window);
            m_windows.add(window);
            m_drawables.add(kind == 0 ? window : glx.CreateWindow(m_display, of, window, none.data()));
        }
        XFree(visual);
    }

    void make_current(Session& session, Random& random) {
        const GLXContext wanted = random.one_in(12) ? nullptr : context(random);
        const GLXDrawable draw = random.one_in(12) ? None : drawable(random),
                          read = random.one_in(4) ? drawable(random) : draw;
        bool done = false;
        {
            const Session::Announced call(
                session, "glXMakeContextCurrent",
                "glXMakeCurrent or glXMakeContextCurrent(display, draw, read, context)");
            if (random.one_in(2))
                done = glx.MakeCurrent(m_display, draw, wanted);
            else
                done = glx.MakeContextCurrent(m_display, draw, read, wanted);
        }
        follow(session, done);
    }

    void destroy(Session& session, Random& random) {
        const Session::Announced call(
            session, "glXDestroyContext",
            "glXDestroyContext, glXDestroyWindow, glXDestroyPixmap, glXDestroyPbuffer or XDestroyWindow");
        switch (random.below(6)) {
            case 0:
                return glx.DestroyWindow(m_display, drawable(random));
            case 1:
                return glx.DestroyPixmap(m_display, drawable(random));
            case 2:
                return glx.DestroyPbuffer(m_display, drawable(random));
            case 3:
                if (const Window window = m_windows.draw(random)) XDestroyWindow(m_display, window);
                return;
            default:
                glx.DestroyContext(m_display, context(random));
        }
    }

    void swap(Session& session, Random& random) {
        const GLXDrawable shown = random.one_in(3) ? drawable(random) : glx.GetCurrentDrawable();
        const Session::Announced call(session, "glXSwapBuffers",
                                      "glXSwapBuffers or glXCopySubBufferMESA(display, drawable)");
        if (!random.one_in(4)) return glx.SwapBuffers(m_display, shown);
        const auto coordinate = [&] {
            return random.one_in(8) ? static_cast<int>(draw_integer(random)) : random.between(-4, 60);
        };
        glx.CopySubBufferMESA(m_display, shown, coordinate(), coordinate(), coordinate(), coordinate());
    }

    void query(Session& session, Random& random) {
        const int attribute = draw_attribute(random);
        Block value(sizeof(unsigned long));
        const auto as = [&]<typename T>(T) {
            return random.one_in(16) ? nullptr : reinterpret_cast<T*>(value.data());
        };
        const Session::Announced call(
            session, "glXQueryDrawable",
            "glXQueryDrawable, glXQueryContext, glXGetFBConfigAttrib, glXSelectEvent, glXGetClientString");
        switch (random.below(6)) {
            case 0:
                return glx.QueryDrawable(m_display, drawable(random), attribute, as(0u));
            case 1:
                return void(glx.QueryContext(m_display, context(random), attribute, as(0)));
            case 2:
                return void(glx.GetFBConfigAttrib(m_display, config(random), attribute, as(0)));
            case 3:
                return glx.SelectEvent(m_display, drawable(random), random.bits());
            case 4:
                return glx.GetSelectedEvent(m_display, drawable(random), as(0ul));
            default:
                glx.GetClientString(m_display, attribute);
                glx.QueryServerString(m_display, 0, attribute);
                glx.QueryExtensionsString(m_display, 0);
                glx.IsDirect(m_display, context(random));
        }
    }

    void configs(Session& session, Random& random) {
        const AttributeList attributes(random, {}), unpaired(random, {}, 2);
        const int screen = random.one_in(12) ? static_cast<int>(draw_integer(random)) : 0;
        const Session::Announced call(session, "glXChooseFBConfig",
                                      "glXChooseFBConfig, glXChooseVisual and glXGetConfig");
        int count = 0;
        if (GLXFBConfig* const found = glx.ChooseFBConfig(m_display, screen, attributes.data(), &count))
            XFree(found);
        if (XVisualInfo* const visual = glx.ChooseVisual(m_display, screen, unpaired.data())) {
            glx.GetConfig(m_display, visual, draw_attribute(random), random.one_in(16) ? nullptr : &count);
            XFree(visual);
        }
    }

    void tex_image(Session& session, Random& random) {
        const Session::Announced call(session, "glXBindTexImageEXT",
                                      "glXBindTexImageEXT or glXReleaseTexImageEXT");
        const int buffer = random.one_in(3) ? static_cast<int>(draw_integer(random)) : GLX_FRONT_LEFT_EXT;
        if (random.one_in(2))
            glx.BindTexImageEXT(m_display, drawable(random), buffer, nullptr);
        else
            glx.ReleaseTexImageEXT(m_display, drawable(random), buffer);
    }

    void change_window(Session& session, Random& random) {
        const Window window = m_windows.draw(random);
        if (!window) return;
        const Session::Announced call(session, "XResizeWindow",
                                      "XResizeWindow, XMapWindow or XUnmapWindow(display, window)");
        if (random.one_in(2))
            XResizeWindow(m_display, window, static_cast<unsigned>(random.between(1, 120)),
                          static_cast<unsigned>(random.between(1, 120)));
        else if (random.one_in(2))
            XUnmapWindow(m_display, window);
        else
            XMapWindow(m_display, window);
        glx.WaitX();
        glx.WaitGL();
    }

    void copy(Session& session, Random& random) {
        const Session::Announced call(session, "glXCopyContext",
                                      "glXCopyContext(display, source, destination, mask)");
        glx.CopyContext(m_display, context(random), context(random),
                        random.one_in(2) ? GL_ALL_ATTRIB_BITS : random.bits());
    }

    void font(Session& session, Random& random) {
        if (!random.one_in(4)) return;
        const Font font = XLoadFont(m_display, "fixed");
        const Session::Announced call(session, "glXUseXFont", "glXUseXFont(font, first, count, base)");
        glx.UseXFont(random.one_in(6) ? 12345 : font, random.between(-4, 300), random.between(-1, 5),
                     random.between(0, 6));
        XUnloadFont(m_display, font);
    }

    void sync(Session& session, Random& random) {
        Block values(3 * sizeof(std::int64_t));
        auto* const value = reinterpret_cast<std::int64_t*>(values.data());
        const Session::Announced call(session, "glXGetSyncValuesOML",
                                      "glXGetSyncValuesOML, glXGetVideoSyncSGI and swap intervals");
        glx.GetSyncValuesOML(m_display, drawable(random), value, value + 1,
                             random.one_in(16) ? nullptr : value + 2);
        glx.GetVideoSyncSGI(reinterpret_cast<unsigned*>(value));
        // An interval makes swaps wait: none is left behind.
        glx.SwapIntervalEXT(m_display, drawable(random), random.between(-1, 0));
        glx.SwapIntervalMESA(0);
    }

    const Functions glx;
    Display* m_display = nullptr;
    Handles<GLXFBConfig> m_configs;
    Handles<GLXContext> m_contexts;
    Handles<GLXDrawable> m_drawables;
    Handles<Window> m_windows;
    Models<GLXContext> m_models;
};

}  // namespace

std::unique_ptr<WindowSystem> make_glx(const Library& library) {
    return std::make_unique<Glx>(library);
}

}  // namespace terrazzo::fuzz
