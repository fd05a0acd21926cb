// EGL without windows: displays, contexts, pbuffers and syncs, named by handles of which many are dead or
// were never given out; see window_system.h. EGL itself must refuse a context that another thread has.
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
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
#define TERRAZZO_FIND(name) library.find("egl" #name, name)
        TERRAZZO_FIND(GetPlatformDisplay), TERRAZZO_FIND(Initialize), TERRAZZO_FIND(Terminate),
            TERRAZZO_FIND(GetConfigs), TERRAZZO_FIND(ChooseConfig);
        TERRAZZO_FIND(GetConfigAttrib), TERRAZZO_FIND(BindAPI), TERRAZZO_FIND(QueryAPI),
            TERRAZZO_FIND(CreateContext), TERRAZZO_FIND(DestroyContext);
        TERRAZZO_FIND(MakeCurrent), TERRAZZO_FIND(GetCurrentContext), TERRAZZO_FIND(GetCurrentSurface),
            TERRAZZO_FIND(QueryContext), TERRAZZO_FIND(QuerySurface);
        TERRAZZO_FIND(CreatePbufferSurface), TERRAZZO_FIND(DestroySurface), TERRAZZO_FIND(SurfaceAttrib),
            TERRAZZO_FIND(SwapBuffers), TERRAZZO_FIND(SwapInterval);
        TERRAZZO_FIND(CopyBuffers), TERRAZZO_FIND(BindTexImage), TERRAZZO_FIND(ReleaseTexImage),
            TERRAZZO_FIND(CreateSync), TERRAZZO_FIND(DestroySync);
        TERRAZZO_FIND(ClientWaitSync), TERRAZZO_FIND(WaitSync), TERRAZZO_FIND(GetSyncAttrib),
            TERRAZZO_FIND(WaitClient), TERRAZZO_FIND(WaitGL), TERRAZZO_FIND(WaitNative);
        TERRAZZO_FIND(ReleaseThread), TERRAZZO_FIND(QueryString), TERRAZZO_FIND(GetError),
            TERRAZZO_FIND(GetProcAddress), TERRAZZO_FIND(CreateWindowSurface);
        TERRAZZO_FIND(CreatePixmapSurface), TERRAZZO_FIND(CreatePlatformWindowSurface),
            TERRAZZO_FIND(CreateImage), TERRAZZO_FIND(DestroyImage);
        TERRAZZO_FIND(CreatePbufferFromClientBuffer);
#undef TERRAZZO_FIND
    }

    decltype(eglGetPlatformDisplay)* GetPlatformDisplay;
    decltype(eglInitialize)* Initialize;
    decltype(eglTerminate)* Terminate;
    decltype(eglGetConfigs)* GetConfigs;
    decltype(eglChooseConfig)* ChooseConfig;
    decltype(eglGetConfigAttrib)* GetConfigAttrib;
    decltype(eglBindAPI)* BindAPI;
    decltype(eglQueryAPI)* QueryAPI;
    decltype(eglCreateContext)* CreateContext;
    decltype(eglDestroyContext)* DestroyContext;
    decltype(eglMakeCurrent)* MakeCurrent;
    decltype(eglGetCurrentContext)* GetCurrentContext;
    decltype(eglGetCurrentSurface)* GetCurrentSurface;
    decltype(eglQueryContext)* QueryContext;
    decltype(eglQuerySurface)* QuerySurface;
    decltype(eglCreatePbufferSurface)* CreatePbufferSurface;
    decltype(eglDestroySurface)* DestroySurface;
    decltype(eglSurfaceAttrib)* SurfaceAttrib;
    decltype(eglSwapBuffers)* SwapBuffers;
    decltype(eglSwapInterval)* SwapInterval;
    decltype(eglCopyBuffers)* CopyBuffers;
    decltype(eglBindTexImage)* BindTexImage;
    decltype(eglReleaseTexImage)* ReleaseTexImage;
    decltype(eglCreateSync)* CreateSync;
    decltype(eglDestroySync)* DestroySync;
    decltype(eglClientWaitSync)* ClientWaitSync;
    decltype(eglWaitSync)* WaitSync;
    decltype(eglGetSyncAttrib)* GetSyncAttrib;
    decltype(eglWaitClient)* WaitClient;
    decltype(eglWaitGL)* WaitGL;
    decltype(eglWaitNative)* WaitNative;
    decltype(eglReleaseThread)* ReleaseThread;
    decltype(eglQueryString)* QueryString;
    decltype(eglGetError)* GetError;
    decltype(eglGetProcAddress)* GetProcAddress;
    decltype(eglCreateWindowSurface)* CreateWindowSurface;
    decltype(eglCreatePixmapSurface)* CreatePixmapSurface;
    decltype(eglCreatePlatformWindowSurface)* CreatePlatformWindowSurface;
    decltype(eglCreateImage)* CreateImage;
    decltype(eglDestroyImage)* DestroyImage;
    decltype(eglCreatePbufferFromClientBuffer)* CreatePbufferFromClientBuffer;
};

constexpr EGLint kAttributes[] = {EGL_RED_SIZE,
                                  EGL_ALPHA_SIZE,
                                  EGL_DEPTH_SIZE,
                                  EGL_STENCIL_SIZE,
                                  EGL_SAMPLES,
                                  EGL_SAMPLE_BUFFERS,
                                  EGL_SURFACE_TYPE,
                                  EGL_RENDERABLE_TYPE,
                                  EGL_CONFIG_ID,
                                  EGL_NATIVE_VISUAL_ID,
                                  EGL_TRANSPARENT_TYPE,
                                  EGL_BIND_TO_TEXTURE_RGBA,
                                  EGL_MAX_PBUFFER_WIDTH,
                                  EGL_CONFIG_CAVEAT,
                                  EGL_LEVEL,
                                  EGL_WIDTH,
                                  EGL_HEIGHT,
                                  EGL_LARGEST_PBUFFER,
                                  EGL_TEXTURE_FORMAT,
                                  EGL_TEXTURE_TARGET,
                                  EGL_MIPMAP_TEXTURE,
                                  EGL_RENDER_BUFFER,
                                  EGL_SWAP_BEHAVIOR,
                                  EGL_MULTISAMPLE_RESOLVE,
                                  EGL_CONTEXT_MAJOR_VERSION,
                                  EGL_CONTEXT_MINOR_VERSION,
                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                  EGL_CONTEXT_OPENGL_DEBUG,
                                  EGL_CONTEXT_CLIENT_TYPE,
                                  EGL_BUFFER_AGE_EXT,
                                  EGL_SYNC_TYPE,
                                  EGL_SYNC_STATUS,
                                  EGL_SYNC_CONDITION,
                                  EGL_VENDOR,
                                  EGL_VERSION,
                                  EGL_EXTENSIONS,
                                  EGL_CLIENT_APIS,
                                  EGL_GL_COLORSPACE};

// Attributes and values in memory of exactly their size.
template <typename Attribute>
class AttributeList {
  public:
    AttributeList(Random& random, std::initializer_list<Attribute> first)
        : m_block(size(random, first.size())) {
        std::size_t at = 0;
        for (const Attribute value : first) store(at++, value);
        for (; at + 1 < m_block.size() / sizeof(Attribute); at += 2) {
            store(at, random.one_in(8) ? static_cast<Attribute>(draw_integer(random))
                                       : kAttributes[random.below(std::size(kAttributes))]);
            store(at + 1, random.one_in(4) ? static_cast<Attribute>(draw_integer(random))
                                           : static_cast<Attribute>(random.below(20)));
        }
        store(at, EGL_NONE);
        m_null = first.size() == 0 && random.one_in(3);
    }
    const Attribute* data() const {
        return m_null ? nullptr : reinterpret_cast<const Attribute*>(m_block.data());
    }

  private:
    static std::size_t size(Random& random, std::size_t first) {
        return (first + 2 * (random.one_in(2) ? 0 : random.below(4)) + 1) * sizeof(Attribute);
    }
    void store(std::size_t index, Attribute value) {
        reinterpret_cast<Attribute*>(m_block.data())[index] = value;
    }

    Block m_block;
    bool m_null = false;
};

EGLint draw_attribute(Random& random) {
    return random.one_in(8) ? static_cast<EGLint>(draw_integer(random))
                            : kAttributes[random.below(std::size(kAttributes))];
}

template <typename Handle>
Handle unknown_handle(Random& random) {
    return reinterpret_cast<Handle>(random.one_in(2) ? random.bits() : random.below(64));
}

class Egl : public WindowSystem {
  public:
    explicit Egl(const Library& library) : egl(library) {
        m_display = egl.GetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
        start();
    }

    ~Egl() override { egl.Terminate(m_display); }

    void enter(Session& session, Random& random) override {
        egl.BindAPI(EGL_OPENGL_API);
        create_context(session, random);
        create_pbuffer(session, random);
        make_current(session, random);
    }

    void leave(Session& session) override {
        egl.ReleaseThread();
        session.set_model(nullptr);
    }

    void change_context(Session& session, Random& random) override { make_current(session, random); }

    void operate(Session& session, Random& random) override {
        using Operation = void (Egl::*)(Session&, Random&);
        static constexpr Operation kOperations[] = {&Egl::create_context,
                                                    &Egl::create_context,
                                                    &Egl::create_pbuffer,
                                                    &Egl::create_pbuffer,
                                                    &Egl::make_current,
                                                    &Egl::make_current,
                                                    &Egl::destroy_context,
                                                    &Egl::destroy_surface,
                                                    &Egl::swap,
                                                    &Egl::swap,
                                                    &Egl::query,
                                                    &Egl::query,
                                                    &Egl::sync,
                                                    &Egl::configs,
                                                    &Egl::wait,
                                                    &Egl::tex_image,
                                                    &Egl::refused_surfaces,
                                                    &Egl::restart,
                                                    &Egl::release_thread};
        (this->*random.one_of(kOperations))(session, random);
        // Whatever happened to it, this is the thread's context now.
        follow(session);
        const EGLint error = egl.GetError();
        if (error >= EGL_SUCCESS && error <= EGL_CONTEXT_LOST) return;
        std::fprintf(stderr, "fuzz: 0x%x is no error of EGL\n", static_cast<unsigned>(error));
        std::abort();
    }

  private:
    void start() {
        EGLint major = 0, minor = 0, count = 0;
        EGLConfig configs[64] = {};
        if (!egl.Initialize(m_display, &major, &minor) || !egl.GetConfigs(m_display, configs, 64, &count)) {
            std::fprintf(stderr, "fuzz: EGL does not start\n");
            std::exit(2);
        }
        for (EGLint i = 0; i < count && m_configs.size() < 64; ++i) m_configs.add(configs[i]);
    }

    // A context that is destroyed stays current, and its handle may be given out again meanwhile: the model
    // changes with the handle, and when a context has been made current.
    void follow(Session& session, bool is_made_current = false) {
        static thread_local EGLContext before = EGL_NO_CONTEXT;
        const EGLContext now = egl.GetCurrentContext();
        if (is_made_current || now != before || !now) session.set_model(now ? m_models.find(now) : nullptr);
        before = now;
    }

    EGLDisplay display(Random& random) const {
        return random.one_in(24) ? random.one_in(2) ? EGL_NO_DISPLAY : unknown_handle<EGLDisplay>(random)
                                 : m_display;
    }
    EGLConfig config(Random& random) const {
        return random.one_in(24) ? unknown_handle<EGLConfig>(random) : m_configs.draw(random);
    }
    EGLContext context(Random& random) const {
        return random.one_in(24) ? unknown_handle<EGLContext>(random) : m_contexts.draw(random);
    }
    EGLSurface surface(Random& random) const {
        return random.one_in(24) ? unknown_handle<EGLSurface>(random) : m_surfaces.draw(random);
    }
    EGLSync sync_handle(Random& random) const {
        return random.one_in(24) ? unknown_handle<EGLSync>(random) : m_syncs.draw(random);
    }

    void create_context(Session& session, Random& random) {
        const AttributeList<EGLint> attributes(random, {});
        const EGLContext share = random.one_in(2) ? context(random) : EGL_NO_CONTEXT;
        const Session::Announced call(session, "eglCreateContext",
                                      "eglCreateContext(display, config, share or none, attributes)");
        const EGLContext made = egl.CreateContext(display(random), config(random), share, attributes.data());
        if (!made) return;
        m_models.make(made);
        m_contexts.add(made);
    }

    void create_pbuffer(Session& session, Random& random) {
        const AttributeList<EGLint> attributes(
            random,
            {EGL_WIDTH, random.one_in(16) ? -1 : random.between(0, 80), EGL_HEIGHT, random.between(1, 80)});
        const Session::Announced call(session, "eglCreatePbufferSurface",
                                      "eglCreatePbufferSurface(display, config, attributes)");
        m_surfaces.add(egl.CreatePbufferSurface(display(random), config(random), attributes.data()));
    }

    void make_current(Session& session, Random& random) {
        const EGLContext wanted = random.one_in(12) ? EGL_NO_CONTEXT : context(random);
        const EGLSurface draw = random.one_in(6) ? EGL_NO_SURFACE : surface(random),
                         read = random.one_in(4) ? surface(random) : draw;
        bool done = false;
        {
            const Session::Announced call(session, "eglMakeCurrent",
                                          "eglMakeCurrent(display, draw, read, context)");
            done = egl.MakeCurrent(display(random), draw, read, wanted);
        }
        follow(session, done);
    }

    void destroy_context(Session& session, Random& random) {
        const Session::Announced call(session, "eglDestroyContext", "eglDestroyContext(display, context)");
        egl.DestroyContext(display(random), context(random));
    }

    void destroy_surface(Session& session, Random& random) {
        const Session::Announced call(session, "eglDestroySurface", "eglDestroySurface(display, surface)");
        egl.DestroySurface(display(random), surface(random));
    }

    void swap(Session& session, Random& random) {
        const EGLSurface shown = random.one_in(3) ? surface(random) : egl.GetCurrentSurface(EGL_DRAW);
        const Session::Announced call(session, "eglSwapBuffers", "eglSwapBuffers(display, surface)");
        if (random.one_in(4)) egl.SwapInterval(display(random), random.between(-1, 1));
        if (random.one_in(6))
            egl.CopyBuffers(display(random), shown, static_cast<EGLNativePixmapType>(random.below(99)));
        egl.SwapBuffers(display(random), shown);
    }

    void query(Session& session, Random& random) {
        const EGLint attribute = draw_attribute(random);
        const bool null = random.one_in(16);
        Block value(sizeof(EGLint));
        EGLint* const out = null ? nullptr : reinterpret_cast<EGLint*>(value.data());
        const Session::Announced call(
            session, "eglQuerySurface",
            "eglQuerySurface, eglQueryContext, eglGetConfigAttrib, eglSurfaceAttrib or eglQueryString");
        switch (random.below(5)) {
            case 0:
                return void(egl.QuerySurface(display(random), surface(random), attribute, out));
            case 1:
                return void(egl.QueryContext(display(random), context(random), attribute, out));
            case 2:
                return void(egl.GetConfigAttrib(display(random), config(random), attribute, out));
            case 3:
                return void(egl.SurfaceAttrib(display(random), surface(random), attribute,
                                              random.between(0x3080, 0x3098)));
            default:
                egl.QueryString(display(random), attribute);
                egl.GetProcAddress(random.of({"glBegin", "eglSwapBuffers", "glNothing", ""}));
        }
    }

    void sync(Session& session, Random& random) {
        const AttributeList<EGLAttrib> attributes(random, {});
        Block value(sizeof(EGLAttrib));
        const Session::Announced call(
            session, "eglCreateSync",
            "eglCreateSync, eglDestroySync, eglClientWaitSync, eglWaitSync or eglGetSyncAttrib");
        switch (random.below(5)) {
            case 0:
                return m_syncs.add(egl.CreateSync(display(random), random.one_in(6) ? 0x1234 : EGL_SYNC_FENCE,
                                                  attributes.data()));
            case 1:
                return void(egl.DestroySync(display(random), sync_handle(random)));
            case 2:
                return void(egl.ClientWaitSync(display(random), sync_handle(random), random.between(0, 2),
                                               random.one_in(2) ? EGL_FOREVER : 0));
            case 3:
                return void(egl.WaitSync(display(random), sync_handle(random), random.below(2) ? 0 : 7));
            default:
                egl.GetSyncAttrib(display(random), sync_handle(random), draw_attribute(random),
                                  random.one_in(16) ? nullptr : reinterpret_cast<EGLAttrib*>(value.data()));
        }
    }

    void configs(Session& session, Random& random) {
        const AttributeList<EGLint> attributes(random, {});
        const EGLint size = random.between(-1, 9);
        Block found(static_cast<std::size_t>(std::max(size, 0)) * sizeof(EGLConfig));
        Block count(sizeof(EGLint));
        const Session::Announced call(
            session, "eglChooseConfig",
            "eglChooseConfig(display, attributes, configs, " + std::to_string(size) + ", count)");
        EGLConfig* const out = random.one_in(6) ? nullptr : reinterpret_cast<EGLConfig*>(found.data());
        EGLint* const counted = random.one_in(16) ? nullptr : reinterpret_cast<EGLint*>(count.data());
        if (random.one_in(3))
            egl.GetConfigs(display(random), out, size, counted);
        else
            egl.ChooseConfig(display(random), attributes.data(), out, size, counted);
    }

    void wait(Session& session, Random& random) {
        const Session::Announced call(session, "eglWaitClient",
                                      "eglWaitClient(), eglWaitGL() and eglWaitNative()");
        egl.WaitClient();
        egl.WaitGL();
        egl.WaitNative(random.one_in(2) ? EGL_CORE_NATIVE_ENGINE : static_cast<EGLint>(draw_integer(random)));
    }

    void tex_image(Session& session, Random& random) {
        const Session::Announced call(session, "eglBindTexImage",
                                      "eglBindTexImage or eglReleaseTexImage(display, surface, buffer)");
        const EGLint buffer = random.one_in(3) ? static_cast<EGLint>(draw_integer(random)) : EGL_BACK_BUFFER;
        if (random.one_in(2))
            egl.BindTexImage(display(random), surface(random), buffer);
        else
            egl.ReleaseTexImage(display(random), surface(random), buffer);
    }

    // There are no windows here: every kind of surface but pbuffers is refused.
    void refused_surfaces(Session& session, Random& random) {
        const AttributeList<EGLint> attributes(random, {});
        const AttributeList<EGLAttrib> others(random, {});
        const Session::Announced call(session, "eglCreateWindowSurface",
                                      "surfaces of windows, pixmaps and images without a window system");
        const bool made =
            egl.CreateWindowSurface(display(random), config(random),
                                    static_cast<EGLNativeWindowType>(random.below(99)), attributes.data()) ||
            egl.CreatePixmapSurface(display(random), config(random),
                                    static_cast<EGLNativePixmapType>(random.below(99)), attributes.data()) ||
            egl.CreatePlatformWindowSurface(display(random), config(random), nullptr, others.data());
        egl.CreateImage(display(random), context(random), 0x3000, nullptr, others.data());
        egl.DestroyImage(display(random), unknown_handle<EGLImage>(random));
        egl.CreatePbufferFromClientBuffer(display(random), 0x3096, nullptr, config(random),
                                          attributes.data());
        if (!made) return;
        std::fprintf(stderr, "fuzz: EGL made a surface of a window that there is not\n");
        std::abort();
    }

    // Terminates the display under whatever is current, and begins anew.
    void restart(Session& session, Random& random) {
        if (!random.one_in(3)) return;
        const Session::Announced call(session, "eglTerminate",
                                      "eglTerminate(display), eglInitialize(display)");
        egl.Terminate(m_display);
        const std::lock_guard lock(m_starting);
        start();
    }

    void release_thread(Session& session, Random&) {
        const Session::Announced call(session, "eglReleaseThread", "eglReleaseThread()");
        egl.ReleaseThread();
        egl.BindAPI(EGL_OPENGL_API);
    }

    const Functions egl;
    EGLDisplay m_display;
    std::mutex m_starting;
    Handles<EGLConfig> m_configs;
    Handles<EGLContext> m_contexts;
    Handles<EGLSurface> m_surfaces;
    Handles<EGLSync> m_syncs;
    Models<EGLContext> m_models;
};

}  // namespace

std::unique_ptr<WindowSystem> make_egl(const Library& library) {
    return std::make_unique<Egl>(library);
}

}  // namespace terrazzo::fuzz
