// OSMesa's own functions with arguments that make no sense, without a context and between Begin and End:
// refused, nothing written, and the current context, its buffer and its state as they were.
#include <GL/osmesa.h>
#include <gmock/gmock.h>

#include <array>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "kit/library.h"
#include "state_dump.h"

namespace terrazzo::test {
namespace {

using testing::Each;
using testing::IsEmpty;

constexpr int kSize = 8;
constexpr int kLeast = std::numeric_limits<int>::min(), kMost = std::numeric_limits<int>::max();
constexpr int kUnknown[] = {0,     -1,     0xdead,
                            kMost, kLeast, 0x1900 /* GL_COLOR_INDEX, no format that can be drawn in */};
constexpr std::array<int, 6> kQueries = {OSMESA_WIDTH, OSMESA_HEIGHT,     OSMESA_FORMAT,
                                         OSMESA_TYPE,  OSMESA_ROW_LENGTH, OSMESA_Y_UP};

class BadOsmesaInput : public testing::Test {
  protected:
    BadOsmesaInput() {
        EXPECT_TRUE(OSMesaMakeCurrent(m_context, m_pixels.data(), GL_UNSIGNED_BYTE, kSize, kSize));
        m_before = everything();
    }
    ~BadOsmesaInput() override {
        OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
        OSMesaDestroyContext(m_context);
    }

    // All that a program can ask OSMesa and the GL.
    std::vector<std::string> everything() const {
        std::vector<std::string> lines = dump_state(m_library.gl);
        for (int query : kQueries) {
            GLint value = -7;
            OSMesaGetIntegerv(query, &value);
            lines.push_back(std::to_string(value));
        }
        lines.push_back(OSMesaGetCurrentContext() == m_context ? "current" : "not current");
        return lines;
    }

    const kit::Library m_library{TERRAZZO_OWN_LIBRARY};
    const OSMesaContext m_context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, nullptr);
    std::vector<GLubyte> m_pixels = std::vector<GLubyte>(kSize * kSize * 4, 0xcd);
    std::vector<std::string> m_before;
};

TEST_F(BadOsmesaInput, NoContextIsMade) {
    for (int value : {-1, 0xdead, kMost, kLeast}) {
        EXPECT_EQ(OSMesaCreateContext(static_cast<GLenum>(value), nullptr), nullptr) << value;
        const int unknown[] = {value, 1, 0};
        EXPECT_EQ(OSMesaCreateContextAttribs(unknown, nullptr), nullptr) << value;
    }
    for (int value : {-1, kLeast}) {
        EXPECT_EQ(OSMesaCreateContextExt(OSMESA_RGBA, value, 0, 0, nullptr), nullptr) << value;
        EXPECT_EQ(OSMesaCreateContextExt(OSMESA_RGBA, 0, value, 0, nullptr), nullptr) << value;
        EXPECT_EQ(OSMesaCreateContextExt(OSMESA_RGBA, 0, 0, value, nullptr), nullptr) << value;
        for (int attribute : {OSMESA_FORMAT, OSMESA_DEPTH_BITS, OSMESA_STENCIL_BITS, OSMESA_ACCUM_BITS,
                              OSMESA_PROFILE, OSMESA_CONTEXT_MAJOR_VERSION, OSMESA_CONTEXT_MINOR_VERSION}) {
            const int list[] = {attribute, value, 0};
            EXPECT_EQ(OSMesaCreateContextAttribs(list, nullptr), nullptr) << attribute;
        }
    }
    for (int version : {2, 5, kMost}) {
        const int list[] = {OSMESA_CONTEXT_MAJOR_VERSION, version, 0};
        EXPECT_EQ(OSMesaCreateContextAttribs(list, nullptr), nullptr) << version;
    }
    EXPECT_THAT(changed(m_before, everything()), IsEmpty());
}

TEST_F(BadOsmesaInput, NothingIsMadeCurrent) {
    std::vector<GLubyte> other(kSize * kSize * 4, 0xcd);
    EXPECT_FALSE(OSMesaMakeCurrent(nullptr, other.data(), GL_UNSIGNED_BYTE, kSize, kSize));
    EXPECT_FALSE(OSMesaMakeCurrent(m_context, nullptr, GL_UNSIGNED_BYTE, kSize, kSize));
    for (int type : kUnknown)
        EXPECT_FALSE(OSMesaMakeCurrent(m_context, other.data(), static_cast<GLenum>(type), kSize, kSize))
            << type;
    for (int size : {0, -1, kLeast, kMost, 16385}) {
        EXPECT_FALSE(OSMesaMakeCurrent(m_context, other.data(), GL_UNSIGNED_BYTE, size, kSize)) << size;
        EXPECT_FALSE(OSMesaMakeCurrent(m_context, other.data(), GL_UNSIGNED_BYTE, kSize, size)) << size;
    }
    EXPECT_THAT(changed(m_before, everything()), IsEmpty());
    m_library.gl.Finish();
    EXPECT_THAT(other, Each(0xcd));
}

TEST_F(BadOsmesaInput, NothingIsStoredOrAnswered) {
    for (int name : {0, -1, 0xdead, kMost, kLeast, OSMESA_WIDTH, OSMESA_FORMAT}) {
        OSMesaPixelStore(name, 5);
        OSMesaPixelStore(name, -5);
    }
    for (int name : {0, -1, 0xdead, kMost, kLeast}) {
        GLint value = -7;
        OSMesaGetIntegerv(name, &value);
        EXPECT_EQ(value, -7) << name;
    }
    for (int name : kQueries) OSMesaGetIntegerv(name, nullptr);
    EXPECT_THAT(changed(m_before, everything()), IsEmpty());
}

TEST_F(BadOsmesaInput, NullPointersGetNoBuffers) {
    GLint a = 5, b = 5, c = 5;
    void* buffer = &a;
    for (int missing = 0; missing < 4; ++missing) {
        GLint* const width = missing == 0 ? nullptr : &a;
        GLint* const height = missing == 1 ? nullptr : &b;
        GLint* const third = missing == 2 ? nullptr : &c;
        void** const address = missing == 3 ? nullptr : &buffer;
        EXPECT_FALSE(OSMesaGetDepthBuffer(m_context, width, height, third, address));
        EXPECT_FALSE(OSMesaGetColorBuffer(m_context, width, height, third, address));
    }
    EXPECT_EQ(std::tie(a, b, c), std::tuple(5, 5, 5));
    EXPECT_EQ(buffer, &a);
    EXPECT_FALSE(OSMesaGetDepthBuffer(nullptr, &a, &b, &c, &buffer));
    EXPECT_EQ(buffer, nullptr);
    EXPECT_FALSE(OSMesaGetColorBuffer(nullptr, &a, &b, &c, &buffer));
}

TEST_F(BadOsmesaInput, NamesThatAreNoFunctionsHaveNoAddress) {
    EXPECT_EQ(OSMesaGetProcAddress(nullptr), nullptr);
    const std::string longest(100000, 'g');
    for (const char* name :
         {"", "g", "gl", "OSMesa", "glNoSuchCommand", "OSMesaMakeCurren", "\xff\xfe", longest.c_str()})
        EXPECT_EQ(OSMesaGetProcAddress(name), nullptr) << name;
}

// A row shorter than the picture's width, or none: rows overlap as told, or have the picture's width.
TEST_F(BadOsmesaInput, AnyRowLengthStaysInTheBuffer) {
    for (int length : {-1, kLeast, 0, 1, kSize}) {
        OSMesaPixelStore(OSMESA_ROW_LENGTH, length);
        m_library.gl.Clear(GL_COLOR_BUFFER_BIT);
        m_library.gl.Finish();
    }
    EXPECT_THAT(m_pixels, Each(0));
}

TEST_F(BadOsmesaInput, BetweenBeginAndEndContextsComeAndGo) {
    const kit::Gl& gl = m_library.gl;
    GLint a = 0, b = 0, c = 0;
    void* buffer = nullptr;
    std::vector<GLubyte> bigger(4 * kSize * kSize * 4);
    gl.Begin(GL_TRIANGLES);
    gl.Vertex2f(0, 0);
    EXPECT_TRUE(OSMesaGetDepthBuffer(m_context, &a, &b, &c, &buffer));
    EXPECT_TRUE(OSMesaGetColorBuffer(m_context, &a, &b, &c, &buffer));
    OSMesaPixelStore(OSMESA_Y_UP, 0);
    OSMesaColorClamp(GL_TRUE);
    OSMesaPostprocess(m_context, nullptr, kMost);
    EXPECT_TRUE(OSMesaMakeCurrent(m_context, bigger.data(), GL_FLOAT, kSize, kSize));
    EXPECT_TRUE(OSMesaMakeCurrent(m_context, bigger.data(), GL_UNSIGNED_BYTE, 2 * kSize, 2 * kSize));
    gl.Vertex2f(1, 0);
    EXPECT_TRUE(OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0));
    gl.Vertex2f(1, 0);
    EXPECT_TRUE(OSMesaMakeCurrent(m_context, bigger.data(), GL_UNSIGNED_BYTE, 2 * kSize, 2 * kSize));
    gl.Vertex2f(0, 1);
    gl.End();
    gl.Finish();
    EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});

    const OSMesaContext other = OSMesaCreateContext(OSMESA_RGBA, m_context);
    ASSERT_TRUE(OSMesaMakeCurrent(other, m_pixels.data(), GL_UNSIGNED_BYTE, kSize, kSize));
    gl.Begin(GL_LINES);
    gl.Vertex2f(0, 0);
    OSMesaDestroyContext(other);
    gl.Vertex2f(1, 1);
    gl.End();
    EXPECT_EQ(OSMesaGetCurrentContext(), nullptr);
    EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

TEST_F(BadOsmesaInput, WithoutAContextNothingIsDone) {
    OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    for (int value : {0, 1, -1, kMost, kLeast}) {
        OSMesaPixelStore(value, value);
        OSMesaPixelStore(OSMESA_ROW_LENGTH, value);
        OSMesaPixelStore(OSMESA_Y_UP, value);
        OSMesaPostprocess(nullptr, nullptr, static_cast<unsigned>(value));
        OSMesaColorClamp(static_cast<GLboolean>(value));
    }
    OSMesaDestroyContext(nullptr);
    EXPECT_EQ(OSMesaGetCurrentContext(), nullptr);
    ASSERT_TRUE(OSMesaMakeCurrent(m_context, m_pixels.data(), GL_UNSIGNED_BYTE, kSize, kSize));
    EXPECT_THAT(changed(m_before, everything()), IsEmpty());
}

}  // namespace
}  // namespace terrazzo::test
