// Lives of OSMesa contexts: sharing, threads, destruction in odd places, arguments that make no sense.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <future>
#include <memory>
#include <thread>
#include <vector>

namespace {

constexpr int kSize = 70;  // more than one bin

struct ContextDeleter {
    void operator()(OSMesaContext context) const { OSMesaDestroyContext(context); }
};
using ContextPointer = std::unique_ptr<osmesa_context, ContextDeleter>;

ContextPointer make_context(OSMesaContext partner = nullptr) {
    return ContextPointer(OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, partner));
}

class OsmesaContexts : public testing::Test {
  protected:
    ~OsmesaContexts() override { OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0); }

    bool make_current(const ContextPointer& context) {
        return OSMesaMakeCurrent(context.get(), m_pixels.data(), GL_UNSIGNED_BYTE, kSize, kSize);
    }

    std::array<GLubyte, 4> pixel(int x, int y) const {
        std::array<GLubyte, 4> value;
        std::memcpy(value.data(), &m_pixels[static_cast<std::size_t>(y * kSize + x) * 4], 4);
        return value;
    }

    std::vector<GLubyte> m_pixels = std::vector<GLubyte>(kSize * kSize * 4);
};

constexpr std::array<GLubyte, 4> kRed = {255, 0, 0, 255};

TEST_F(OsmesaContexts, APictureIsTheRightWayUp) {
    const auto context = make_context();
    ASSERT_TRUE(make_current(context));
    glClear(GL_COLOR_BUFFER_BIT);
    glColor3f(1, 0, 0);
    glRectf(-1, -1, 0, 0);  // the lower left quarter
    glFinish();
    EXPECT_EQ(pixel(0, 0), kRed);
    EXPECT_EQ(pixel(kSize / 2 - 1, kSize / 2 - 1), kRed);
    EXPECT_NE(pixel(kSize / 2, 0), kRed);
    EXPECT_NE(pixel(0, kSize / 2), kRed);

    OSMesaPixelStore(OSMESA_Y_UP, 0);
    glRectf(-1, -1, 0, 0);
    glFinish();
    EXPECT_EQ(pixel(0, kSize - 1), kRed);
    EXPECT_NE(pixel(0, 0), kRed);
}

// Whether OSMesaGetDepthBuffer answers with this size, and with this depth, of 0 to 1, everywhere.
void expect_depth(OSMesaContext context, GLint width, GLint height, GLint bytes, double depth) {
    GLint found_width = 0, found_height = 0, found_bytes = 0;
    void* buffer = nullptr;
    ASSERT_TRUE(OSMesaGetDepthBuffer(context, &found_width, &found_height, &found_bytes, &buffer));
    EXPECT_EQ(found_width, width);
    EXPECT_EQ(found_height, height);
    ASSERT_EQ(found_bytes, bytes);
    for (GLint i = 0; i < width * height; ++i) {
        GLuint value = 0;
        std::memcpy(&value, static_cast<const GLubyte*>(buffer) + i * bytes, static_cast<std::size_t>(bytes));
        const double most = bytes == 2 ? 65535 : 16777215;
        ASSERT_NEAR((bytes == 2 ? value : value & 0xffffff) / most, depth, 2 / most) << i;
    }
}

TEST_F(OsmesaContexts, TheDepthBufferFollowsTheSize) {
    for (const GLint bits : {24, 16}) {
        const GLint bytes = bits == 16 ? 2 : 4;
        const ContextPointer context(OSMesaCreateContextExt(OSMESA_RGBA, bits, 0, 0, nullptr));
        const struct {
            GLint width, height;
            double depth;
        } sizes[] = {{60, 50, 0.25}, {33, 20, 0.75}, {20, 33, 0.5}, {70, 70, 0.125}, {1, 1, 1}, {70, 1, 0.25}};
        for (const auto& [width, height, depth] : sizes) {
            ASSERT_TRUE(OSMesaMakeCurrent(context.get(), m_pixels.data(), GL_UNSIGNED_BYTE, width, height));
            glClearDepth(depth);
            glClear(GL_DEPTH_BUFFER_BIT);
            expect_depth(context.get(), width, height, bytes, depth);
            // Once asked for it follows each picture.
            glClearDepth(depth / 2);
            glClear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
            glFinish();
            expect_depth(context.get(), width, height, bytes, depth / 2);
        }
        // The same size again: what was drawn is still there.
        ASSERT_TRUE(OSMesaMakeCurrent(context.get(), m_pixels.data(), GL_UNSIGNED_BYTE, 70, 1));
        expect_depth(context.get(), 70, 1, bytes, 0.125);
    }
}

TEST_F(OsmesaContexts, TheDepthBufferHasWhatIsQueuedToo) {
    const auto context = make_context();
    ASSERT_TRUE(make_current(context));
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glBegin(GL_POINTS);
    glVertex3f(-1 + 1.0f / kSize, -1 + 1.0f / kSize, 0);
    glEnd();
    GLint width = 0, height = 0, bytes = 0;
    void* depth = nullptr;
    ASSERT_TRUE(OSMesaGetDepthBuffer(context.get(), &width, &height, &bytes, &depth));
    ASSERT_EQ(bytes, 4);
    const auto* values = static_cast<const GLuint*>(depth);
    EXPECT_EQ(values[0] & 0xffffff, 0x800000u);  // 0.5 of 2^24 - 1, to the nearest even
    EXPECT_EQ(values[1] & 0xffffff, 0xffffffu);
}

// The window's depth buffer, whatever is drawn to by then.
TEST_F(OsmesaContexts, TheDepthBufferIsTheWindowsWhileAnObjectIsBound) {
    const auto context = make_context();
    ASSERT_TRUE(make_current(context));
    glClearDepth(0.5);
    glClear(GL_DEPTH_BUFFER_BIT);
    const auto expect_windows = [&](GLuint expected) {
        GLint width = 0, height = 0, bytes = 0;
        void* depth = nullptr;
        ASSERT_TRUE(OSMesaGetDepthBuffer(context.get(), &width, &height, &bytes, &depth));
        EXPECT_EQ(width, kSize);
        EXPECT_EQ(height, kSize);
        ASSERT_EQ(bytes, 4);
        const auto* values = static_cast<const GLuint*>(depth);
        EXPECT_EQ(values[0] & 0xffffff, expected);
        EXPECT_EQ(values[kSize * kSize - 1] & 0xffffff, expected);
    };
    glBindFramebuffer(GL_FRAMEBUFFER, 4);
    expect_windows(0x800000);  // of an object without anything
    const auto attach = [](GLenum attachment, GLuint name, GLenum format, GLsizei size) {
        glBindRenderbuffer(GL_RENDERBUFFER, name);
        glRenderbufferStorage(GL_RENDERBUFFER, format, size, size);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, name);
    };
    for (const GLsizei size : {8, 1000}) {
        glBindFramebuffer(GL_FRAMEBUFFER, 4);
        attach(GL_COLOR_ATTACHMENT0, 1, GL_RGBA8, size);
        glClearDepth(0.25);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);  // colour alone
        expect_windows(0x800000);
        attach(GL_DEPTH_ATTACHMENT, 2, GL_DEPTH24_STENCIL8, size);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        ASSERT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_COMPLETE});
        expect_windows(0x800000);
        GLuint drawn = 0;
        glReadPixels(1, 1, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, &drawn);
        EXPECT_EQ(drawn >> 24, 0x40u);  // and what is in the object is still there
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glClearDepth(0);
    glClear(GL_DEPTH_BUFFER_BIT);
    expect_windows(0);  // what has been asked for once is not what is asked for now
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(OsmesaContexts, PartnersShareListsAndSurviveEachOther) {
    auto first = make_context();
    const auto second = make_context(first.get());
    ASSERT_TRUE(make_current(first));
    glNewList(3, GL_COMPILE);
    glClearColor(1, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glEndList();
    first.reset();  // while it is current
    EXPECT_EQ(OSMesaGetCurrentContext(), nullptr);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    ASSERT_TRUE(make_current(second));
    EXPECT_TRUE(glIsList(3));
    glCallList(3);
    glFinish();
    EXPECT_EQ(pixel(kSize - 1, kSize - 1), kRed);
}

TEST_F(OsmesaContexts, DestroyedWhileAnotherThreadDraws) {
    auto context = make_context();
    std::promise<void> drawing, destroyed;
    std::thread thread([&] {
        std::vector<GLubyte> pixels(kSize * kSize * 4);
        OSMesaMakeCurrent(context.get(), pixels.data(), GL_UNSIGNED_BYTE, kSize, kSize);
        glClearColor(1, 0, 0, 1);
        drawing.set_value();
        destroyed.get_future().wait();
        glClear(GL_COLOR_BUFFER_BIT);
        glFinish();
        EXPECT_EQ(pixels[0], 255);
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    });
    drawing.get_future().wait();
    context.reset();
    destroyed.set_value();
    thread.join();  // the thread ends with the context current: that frees it
}

// To make a context current once more takes nothing away: it is still in use when another thread destroys it.
TEST_F(OsmesaContexts, DestroyedWhileCurrentForTheSecondTime) {
    auto context = make_context();
    ASSERT_TRUE(make_current(context));
    ASSERT_TRUE(make_current(context));
    glClearColor(1, 0, 0, 1);
    std::thread([&] {
        context.reset();
        // Whatever has been let go of is somebody else's now.
        std::vector<ContextPointer> others;
        for (int i = 0; i < 4; ++i) {
            others.push_back(make_context());
            std::vector<GLubyte> pixels(kSize * kSize * 4);
            OSMesaMakeCurrent(others.back().get(), pixels.data(), GL_UNSIGNED_BYTE, kSize, kSize);
            glClearColor(0, 1, 0, 1);
            glFinish();
            OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
        }
        std::thread([&] { others.clear(); }).join();
    }).join();
    std::array<GLfloat, 4> color{};
    glGetFloatv(GL_COLOR_CLEAR_VALUE, color.data());
    EXPECT_EQ(color, (std::array<GLfloat, 4>{1, 0, 0, 1}));
    glClear(GL_COLOR_BUFFER_BIT);
    glFinish();
    EXPECT_EQ(pixel(1, 1), kRed);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(OsmesaContexts, AThreadThatEndsLetsGo) {
    const auto context = make_context();
    std::thread([&] {
        OSMesaMakeCurrent(context.get(), m_pixels.data(), GL_UNSIGNED_BYTE, kSize, kSize);
        glClearColor(1, 0, 0, 1);
    }).join();
    EXPECT_EQ(OSMesaGetCurrentContext(), nullptr);
    ASSERT_TRUE(make_current(context));
    glClear(GL_COLOR_BUFFER_BIT);
    glFinish();
    EXPECT_EQ(pixel(1, 1), kRed);
}

TEST_F(OsmesaContexts, ThreadsDrawAtTheSameTime) {
    const auto partner = make_context();
    const auto draw = [&](GLubyte shade) {
        const auto context = make_context(partner.get());
        std::vector<GLubyte> pixels(kSize * kSize * 4);
        OSMesaMakeCurrent(context.get(), pixels.data(), GL_UNSIGNED_BYTE, kSize, kSize);
        glColor3ub(shade, 0, 0);
        const GLuint list = glGenLists(1);
        glNewList(list, GL_COMPILE);
        glRectf(-1, -1, 1, 1);
        glEndList();
        bool right = true;
        for (int i = 0; i < 50; ++i) {
            glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
            glCallList(list);
            glFinish();
            right = right && pixels[0] == shade && pixels[pixels.size() - 4] == shade;
        }
        OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
        return right;
    };
    std::vector<std::future<bool>> results;
    for (GLubyte shade = 1; shade <= 6; ++shade)
        results.push_back(std::async(std::launch::async, draw, shade));
    for (auto& result : results) EXPECT_TRUE(result.get());
}

TEST_F(OsmesaContexts, ArgumentsWithoutSenseAreRefused) {
    const auto context = make_context();
    GLint a = 5, b = 5, c = 5;
    void* buffer = &a;
    EXPECT_FALSE(OSMesaGetDepthBuffer(context.get(), &a, &b, &c, &buffer));  // never current
    EXPECT_EQ(buffer, nullptr);
    EXPECT_FALSE(OSMesaGetDepthBuffer(nullptr, &a, &b, &c, &buffer));
    EXPECT_FALSE(OSMesaGetColorBuffer(nullptr, &a, &b, &c, &buffer));
    EXPECT_FALSE(OSMesaGetColorBuffer(context.get(), nullptr, nullptr, nullptr, nullptr));
    EXPECT_FALSE(OSMesaMakeCurrent(context.get(), m_pixels.data(), GL_UNSIGNED_BYTE, 16385, 1));
    EXPECT_FALSE(OSMesaMakeCurrent(context.get(), m_pixels.data(), GL_UNSIGNED_BYTE, 0x7fffffff, 0x7fffffff));
    OSMesaPixelStore(OSMESA_Y_UP, 1);  // with no context
    OSMesaGetIntegerv(OSMESA_WIDTH, nullptr);
    OSMesaGetIntegerv(OSMESA_FORMAT, &a);
    OSMesaColorClamp(GL_TRUE);
    OSMesaPostprocess(nullptr, nullptr, 1);
    EXPECT_EQ(OSMesaGetProcAddress(nullptr), nullptr);
    EXPECT_TRUE(ContextPointer(OSMesaCreateContextAttribs(nullptr, nullptr)));
    const int core[] = {OSMESA_PROFILE, OSMESA_CORE_PROFILE, 0};
    EXPECT_EQ(OSMesaCreateContextAttribs(core, nullptr), nullptr);
    const int too_new[] = {OSMESA_CONTEXT_MAJOR_VERSION, 2, OSMESA_CONTEXT_MINOR_VERSION, 1, 0};
    EXPECT_EQ(OSMesaCreateContextAttribs(too_new, nullptr), nullptr);
}

// Pixels of three components, which compare_libraries.py cannot ask Mesa about.
TEST_F(OsmesaContexts, PixelsWithoutAlpha) {
    const ContextPointer context(OSMesaCreateContext(OSMESA_RGB, nullptr));
    std::vector<GLubyte> bytes(kSize * kSize * 3 + 1, 0xcd);
    ASSERT_TRUE(OSMesaMakeCurrent(context.get(), bytes.data(), GL_UNSIGNED_BYTE, kSize, kSize));
    glClearColor(1, 0.5f, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    glFinish();
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 3) {
        ASSERT_EQ(std::vector(&bytes[i], &bytes[i] + 3), (std::vector<GLubyte>{255, 128, 0})) << i;
    }
    EXPECT_EQ(bytes.back(), 0xcd);
    GLint bits = -1;
    glGetIntegerv(GL_ALPHA_BITS, &bits);
    EXPECT_EQ(bits, 0);

    std::vector<GLushort> words(kSize * kSize * 3 + 1, 0xcdcd);
    ASSERT_TRUE(OSMesaMakeCurrent(context.get(), words.data(), GL_UNSIGNED_SHORT, kSize, kSize));
    glClear(GL_COLOR_BUFFER_BIT);
    glFinish();
    EXPECT_EQ(words[words.size() - 4], 65535);
    EXPECT_EQ(words[words.size() - 3], 32768);
    EXPECT_EQ(words[words.size() - 2], 0);
    EXPECT_EQ(words.back(), 0xcdcd);
}

}  // namespace
