// Contexts and pictures of OSMesa; see window_system.h. A picture has exactly the bytes that its context may
// write.
#include <GL/osmesa.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "fuzz/arguments.h"
#include "fuzz/context_pool.h"
#include "fuzz/window_system.h"

namespace terrazzo::fuzz {
namespace {

struct Functions {
    explicit Functions(const Library& library) {
        library.find("OSMesaCreateContext", create);
        library.find("OSMesaCreateContextExt", create_ext);
        library.find("OSMesaCreateContextAttribs", create_attribs);
        library.find("OSMesaDestroyContext", destroy);
        library.find("OSMesaMakeCurrent", make_current);
        library.find("OSMesaGetCurrentContext", get_current);
        library.find("OSMesaPixelStore", pixel_store);
        library.find("OSMesaGetIntegerv", get_integer);
        library.find("OSMesaGetDepthBuffer", get_depth);
        library.find("OSMesaGetColorBuffer", get_color);
        library.find("OSMesaGetProcAddress", get_proc_address);
        library.find("OSMesaColorClamp", color_clamp);
        library.find("OSMesaPostprocess", postprocess);
    }

    decltype(OSMesaCreateContext)* create;
    decltype(OSMesaCreateContextExt)* create_ext;
    decltype(OSMesaCreateContextAttribs)* create_attribs;
    decltype(OSMesaDestroyContext)* destroy;
    decltype(OSMesaMakeCurrent)* make_current;
    decltype(OSMesaGetCurrentContext)* get_current;
    decltype(OSMesaPixelStore)* pixel_store;
    decltype(OSMesaGetIntegerv)* get_integer;
    decltype(OSMesaGetDepthBuffer)* get_depth;
    decltype(OSMesaGetColorBuffer)* get_color;
    decltype(OSMesaGetProcAddress)* get_proc_address;
    decltype(OSMesaColorClamp)* color_clamp;
    decltype(OSMesaPostprocess)* postprocess;
};

struct OsmesaContext {
    OSMesaContext context = nullptr;
    GLenum format = OSMESA_RGBA;
};

std::size_t bytes_of_component(GLenum type) {
    return type == GL_FLOAT ? 4 : type == GL_UNSIGNED_SHORT || type == GL_UNSIGNED_SHORT_5_6_5 ? 2 : 1;
}

std::size_t bytes_of_pixel(GLenum format, GLenum type) {
    if (type == GL_UNSIGNED_SHORT_5_6_5) return 2;
    return bytes_of_component(type) * (format == OSMESA_RGB || format == OSMESA_BGR ? 3
                                       : format == OSMESA_COLOR_INDEX               ? 1
                                                                                    : 4);
}

class Osmesa : public WindowSystem {
  public:
    explicit Osmesa(const Library& library) : m_osmesa(library) {}

    ~Osmesa() override {
        for (auto& slot : m_pool.slots()) {
            if (slot.handle.context) m_osmesa.destroy(slot.handle.context);
        }
    }

    void enter(Session& session, Random& random) override {
        own(session).slot = nullptr;
        own(session).picture.reset();
        for (unsigned i = 0; i < kContexts && !own(session).slot; ++i)
            use(session, random, (session.options.thread + i) % kContexts);
    }

    void leave(Session& session) override {
        Own& mine = own(session);
        let_go(session);
        mine.picture.reset();
    }

    void change_context(Session& session, Random& random) override {
        const unsigned wanted = random.below(kContexts + 1);
        if (wanted == kContexts && random.one_in(4)) return let_go(session);
        use(session, random, wanted % kContexts);
    }

    void operate(Session& session, Random& random) override {
        switch (random.below(12)) {
            case 0:
                return ask(session, random);
            case 1:
                return store(session, random);
            case 2:
                return read_depth(session);
            case 3:
                return read_color(session);
            case 4:
                return refuse(session, random);
            case 5:
                return destroy(session, random);
            case 6:
                return look_at_picture(session);
            case 7: {
                const auto clamp = static_cast<GLboolean>(random.below(3));
                const Session::Announced call(session, "OSMesaColorClamp",
                                              "OSMesaColorClamp(" + std::to_string(clamp) + ")");
                return m_osmesa.color_clamp(clamp);
            }
            default:
                if (Own& mine = own(session); mine.slot) attach(session, random, *mine.slot);
        }
    }

  private:
    using Slot = ContextSlot<OsmesaContext>;

    // What a thread has: a context that is current, and the memory that it draws to.
    struct Own {
        Slot* slot = nullptr;
        std::optional<Block> picture;
        GLenum type = GL_UNSIGNED_BYTE;
    };

    static Own& own(const Session&) {
        static thread_local Own mine;
        return mine;
    }

    void use(Session& session, Random& random, unsigned index) {
        Own& mine = own(session);
        Slot* const slot = m_pool.take(index);
        if (!slot) return;
        if (!slot->handle.context) create(session, random, *slot, index);
        Slot* const before = mine.slot;
        if (slot->handle.context && attach(session, random, *slot)) {
            mine.slot = slot;
            session.set_model(&slot->model);
            m_pool.give_back(before);
        } else {
            m_pool.give_back(slot);
        }
    }

    void let_go(Session& session) {
        Own& mine = own(session);
        {
            const Session::Announced call(session, "OSMesaMakeCurrent",
                                          "OSMesaMakeCurrent(NULL, NULL, 0, 0, 0)");
            m_osmesa.make_current(nullptr, nullptr, 0, 0, 0);
        }
        session.set_model(nullptr);
        m_pool.give_back(std::exchange(mine.slot, nullptr));
    }

    void create(Session& session, Random& random, Slot& slot, unsigned index) {
        const GLenum format = random.of<GLenum>({OSMESA_RGBA, OSMESA_RGBA, OSMESA_BGRA, OSMESA_ARGB,
                                                 OSMESA_RGB, OSMESA_BGR, OSMESA_RGB_565, OSMESA_COLOR_INDEX});
        const int depth = random.of({24, 16, 32, 0, -1}), stencil = random.of({8, 8, 0}),
                  accum = random.of({16, 16, 0});
        // The other context of the group stays alive while this one is made.
        const std::lock_guard lock(m_making);
        const OSMesaContext share = m_pool.partner(index).context;
        OSMesaContext made = nullptr;
        {
            const Session::Announced call(session, "OSMesaCreateContextExt",
                                          "context" + std::to_string(index) + " = OSMesaCreateContextExt(" +
                                              std::to_string(format) + ", " + std::to_string(depth) + ", " +
                                              std::to_string(stencil) + ", " + std::to_string(accum) +
                                              (share ? ", context" + std::to_string(index ^ 1) : ", NULL") +
                                              ")");
            made = m_osmesa.create_ext(format, depth, stencil, accum, share);
        }
        m_pool.set_handle(slot, {made, format});
        slot.model.memory.clear();
        slot.model = {};
    }

    // Makes the context current with a picture of its own; false where it is refused, and then nothing has
    // changed.
    bool attach(Session& session, Random& random, Slot& slot) {
        Own& mine = own(session);
        const GLenum format = slot.handle.format;
        const GLenum type = format == OSMESA_RGB_565 ? GL_UNSIGNED_SHORT_5_6_5
                            : random.one_in(3) && format != OSMESA_RGB && format != OSMESA_BGR
                                ? random.of<GLenum>({GL_FLOAT, GL_UNSIGNED_SHORT, GL_FLOAT})
                                : GL_UNSIGNED_BYTE;
        const int width = random.one_in(16) ? random.between(1, 300) : random.between(1, 72),
                  height = random.between(1, 72);
        const int row = random.one_in(6) ? width + random.between(0, 20) : 0;
        Block picture(static_cast<std::size_t>(std::max(row, width) * height) * bytes_of_pixel(format, type));
        picture.fill(random, Contents::kOutput);
        GLboolean done = GL_FALSE;
        {
            const auto index = &slot - m_pool.slots().data();
            const Session::Announced call(session, "OSMesaMakeCurrent",
                                          "OSMesaMakeCurrent(context" + std::to_string(index) +
                                              ", picture, " + std::to_string(type) + ", " +
                                              std::to_string(width) + ", " + std::to_string(height) +
                                              ")  /* row length " + std::to_string(row) + " */");
            done = m_osmesa.make_current(slot.handle.context, picture.data(), type, width, height);
            if (done) m_osmesa.pixel_store(OSMESA_ROW_LENGTH, row);
        }
        if (!done) return false;
        // The old picture was written for the last time when this one took its place.
        mine.picture.reset();
        mine.picture.emplace(std::move(picture));
        mine.type = type;
        return true;
    }

    void destroy(Session& session, Random& random) {
        const unsigned index = random.below(kContexts);
        Own& mine = own(session);
        const bool is_own = mine.slot == &m_pool.slots()[index];
        Slot* const slot = is_own ? mine.slot : m_pool.take(index);
        if (!slot) return;
        if (is_own) session.set_model(nullptr);
        {
            const std::lock_guard lock(m_making);
            const Session::Announced call(session, "OSMesaDestroyContext",
                                          "OSMesaDestroyContext(context" + std::to_string(index) + ")");
            m_osmesa.destroy(slot->handle.context);
            m_pool.set_handle(*slot, {});
        }
        slot->model = {};
        if (is_own) mine.slot = nullptr;
        m_pool.give_back(slot);
        if (is_own) use(session, random, index);
    }

    void ask(Session& session, Random& random) {
        const GLint pname =
            random.one_in(3) ? static_cast<GLint>(draw_integer(random)) : random.between(0, 0x40);
        const Session::Announced call(session, "OSMesaGetIntegerv",
                                      "OSMesaGetIntegerv(" + std::to_string(pname) + ")");
        Block value(sizeof(GLint));
        m_osmesa.get_integer(pname, reinterpret_cast<GLint*>(value.data()));
        m_osmesa.get_proc_address(
            random.of({"glBegin", "glNothing", "", "OSMesaMakeCurrent", "glTexImage2D"}));
    }

    void store(Session& session, Random& random) {
        // The row length says how large the picture is: only attach() sets it.
        const GLint pname = random.of({OSMESA_Y_UP, OSMESA_Y_UP, 0, -1, OSMESA_WIDTH}),
                    value = static_cast<GLint>(random.of<std::int64_t>({0, 1, 2, draw_integer(random)}));
        const Session::Announced call(
            session, "OSMesaPixelStore",
            "OSMesaPixelStore(" + std::to_string(pname) + ", " + std::to_string(value) + ")");
        m_osmesa.pixel_store(pname, value);
    }

    void read_depth(Session& session) {
        Own& mine = own(session);
        if (!mine.slot) return;
        GLint width = 0, height = 0, bytes = 0;
        void* buffer = nullptr;
        const Session::Announced call(session, "OSMesaGetDepthBuffer", "OSMesaGetDepthBuffer(current)");
        if (m_osmesa.get_depth(mine.slot->handle.context, &width, &height, &bytes, &buffer))
            read(buffer, static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                             static_cast<std::size_t>(bytes));
    }

    void read_color(Session& session) {
        Own& mine = own(session);
        if (!mine.slot) return;
        GLint width = 0, height = 0, format = 0;
        void* buffer = nullptr;
        const Session::Announced call(session, "OSMesaGetColorBuffer", "OSMesaGetColorBuffer(current)");
        if (m_osmesa.get_color(mine.slot->handle.context, &width, &height, &format, &buffer))
            read(buffer, static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                             bytes_of_pixel(static_cast<GLenum>(format), mine.type));
    }

    // Calls that must be refused, and leave what is current as it is.
    void refuse(Session& session, Random& random) {
        Own& mine = own(session);
        const Session::Announced call(session, "OSMesaMakeCurrent", "refused OSMesa calls");
        Block little(64);
        const OSMesaContext context = mine.slot ? mine.slot->handle.context : nullptr;
        const int wrong = random.of({-1, 0x7fffffff, -0x7fffffff - 1, 1 << 20});
        bool accepted = false;
        if (context) {
            accepted |= m_osmesa.make_current(context, little.data(), 0xdead, 1, 1);
            accepted |= m_osmesa.make_current(context, little.data(), GL_UNSIGNED_BYTE, wrong, 1);
            accepted |= m_osmesa.make_current(context, little.data(), GL_UNSIGNED_BYTE, 1, wrong);
        }
        accepted |= m_osmesa.create_ext(static_cast<GLenum>(random.of({0, 0xdead, -1})), 24, 8, 0, nullptr) !=
                    nullptr;
        const int attributes[] = {OSMESA_FORMAT, random.of({0, 0xdead, OSMESA_RGBA}),
                                  random.of({0x7777, OSMESA_PROFILE}), 9, 0};
        accepted |= m_osmesa.create_attribs(attributes, nullptr) != nullptr;
        m_osmesa.destroy(nullptr);
        m_osmesa.postprocess(context, random.one_in(2) ? nullptr : "pp_jimenezmlaa", 1);
        if (m_osmesa.get_current() == context && !accepted) return;
        std::fprintf(stderr, "fuzz: OSMesa accepted what it must refuse\n");
        std::abort();
    }

    // The picture belongs to us after glFinish.
    void look_at_picture(Session& session) {
        Own& mine = own(session);
        if (!mine.slot || !mine.picture) return;
        const Session::Announced call(session, "glFinish", "glFinish()");
        session.gl.Finish();
        mine.picture->check();
        read(mine.picture->data(), mine.picture->size());
    }

    // The sanitizers see whether the memory is there and written.
    static void read(const void* memory, std::size_t bytes) {
        volatile unsigned sum = 0;
        for (std::size_t i = 0; i < bytes; ++i) sum = sum + static_cast<const unsigned char*>(memory)[i];
    }

    const Functions m_osmesa;
    ContextPool<OsmesaContext> m_pool;
    std::mutex m_making;
};

}  // namespace

std::unique_ptr<WindowSystem> make_osmesa(const Library& library) {
    return std::make_unique<Osmesa>(library);
}

}  // namespace terrazzo::fuzz
