// The error rules that the dispatch tables stand for, asked of every exported function.
#include <GL/gl.h>

#include <vector>

#include "gl/generated/calls.h"
#include "gl_fixture.h"

namespace terrazzo::gl {
namespace {

constexpr Arguments kZero{0, 0, nullptr};

TEST(WithoutContext, EveryCommandDoesNothing) {
    make_current(nullptr);
    for (const Call& call : kEveryCall) call.call(kZero);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    EXPECT_EQ(glGetString(GL_VERSION), nullptr);
    EXPECT_EQ(glGenLists(1), 0u);
}

class DispatchTest : public GlTest {};

TEST_F(DispatchTest, CommandsThatAreNotImplementedSaySo) {
    for (const Call& call : kEveryCall) {
        if (call.implemented) continue;
        call.call(kZero);
        EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION}) << call.name;
    }
}

TEST_F(DispatchTest, OnlyImplementedCommandsHaveAnAddress) {
    for (const Call& call : kEveryCall) {
        EXPECT_EQ(find_proc_address(call.name) != nullptr, call.implemented) << call.name;
    }
    EXPECT_EQ(find_proc_address("glNoSuchCommand"), nullptr);
    EXPECT_EQ(find_proc_address(""), nullptr);
    EXPECT_EQ(find_proc_address("glZ"), nullptr);
    EXPECT_EQ(find_proc_address("A"), nullptr);
    EXPECT_EQ(find_proc_address("glGetError"), reinterpret_cast<ProcAddress>(glGetError));
}

TEST_F(DispatchTest, BetweenBeginAndEndOnlyVertexCommandsAreLegal) {
    set_inside_begin_end(ctx(), true);
    for (const Call& call : kEveryCall) {
        if (!call.implemented || call.inside_begin_end) continue;
        call.call(kZero);
        EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION}) << call.name;
    }
    set_inside_begin_end(ctx(), false);
}

TEST_F(DispatchTest, IllegalCommandsChangeNothing) {
    set_inside_begin_end(ctx(), true);
    glBlendFunc(GL_ONE, GL_ONE);
    glMatrixMode(GL_PROJECTION);
    EXPECT_EQ(glIsEnabled(GL_DITHER), GL_FALSE);  // the value of a query that failed is 0
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
    set_inside_begin_end(ctx(), false);
    GLint source = 0, mode = 0;
    glGetIntegerv(GL_BLEND_SRC, &source);
    glGetIntegerv(GL_MATRIX_MODE, &mode);
    EXPECT_EQ(source, GL_ONE);  // the default
    EXPECT_EQ(mode, GL_MODELVIEW);
    EXPECT_EQ(glIsEnabled(GL_DITHER), GL_TRUE);
}

TEST_F(DispatchTest, TheFirstErrorSticksUntilItIsFetched) {
    glMatrixMode(GL_ONE);
    glDeleteLists(1, -1);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    glDeleteLists(1, -1);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
}

// Whatever the arguments, a command returns. With null pointers nothing of the caller's is read or written.
TEST_F(DispatchTest, CommandsSurviveArgumentsOutOfRange) {
    const std::vector<long long> integers = {0,        1, -1, 0x7fffffff, -0x7fffffff - 1, GL_TEXTURE_2D,
                                             GL_FLOAT, 31};
    const std::vector<double> reals = {0, -1, 1e300, __builtin_nan("")};
    for (const Call& call : kEveryCall) {
        if (!call.implemented) continue;
        for (const long long integer : integers) {
            for (const double real : reals) call.call({integer, real, nullptr});
        }
        set_inside_begin_end(ctx(), false);
        if (ctx().lists.compiling) glEndList();
    }
}

TEST_F(DispatchTest, FormsConvertTheirArguments) {
    GLfloat value[16] = {};
    const GLdouble rows[16] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
    glLoadTransposeMatrixd(rows);
    glGetFloatv(GL_MODELVIEW_MATRIX, value);
    EXPECT_EQ(value[1], 5.0f);
    EXPECT_EQ(value[4], 2.0f);

    const GLint colour[4] = {0x7fffffff, -0x7fffffff - 1, 0, 0x40000000};  // (2c + 1)/(2^32 - 1)
    glFogiv(GL_FOG_COLOR, colour);
    glGetFloatv(GL_FOG_COLOR, value);
    EXPECT_EQ(value[0], 1.0f);
    EXPECT_EQ(value[1], 0.0f);          // -1 clamped
    EXPECT_NEAR(value[3], 0.5f, 1e-7);  // half a unit in the last place of 0.5, rounded

    glFogi(GL_FOG_MODE, GL_LINEAR);
    GLint mode = 0;
    glGetIntegerv(GL_FOG_MODE, &mode);
    EXPECT_EQ(mode, GL_LINEAR);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});

    glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, 1);  // a vector
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
    glFogfv(GL_FOG_COLOR, nullptr);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});

    const GLfloat position[4] = {0.25f, 0.5f, 2.5f, 1};
    glLightfv(GL_LIGHT1, GL_POSITION, position);
    const GLfloat diffuse[4] = {1, 0, -1, 1};
    glLightfv(GL_LIGHT1, GL_DIFFUSE, diffuse);
    GLint integers[4] = {};
    glLoadIdentity();
    glLightfv(GL_LIGHT1, GL_POSITION, position);
    glGetLightiv(GL_LIGHT1, GL_POSITION, integers);
    EXPECT_EQ(integers[0], 0);
    EXPECT_EQ(integers[1], 1);
    EXPECT_EQ(integers[2], 3);
    glGetLightiv(GL_LIGHT1, GL_DIFFUSE, integers);
    EXPECT_EQ(integers[0], 0x7fffffff);
    EXPECT_EQ(integers[2], -0x7fffffff - 1);
    integers[0] = 77;
    glGetLightiv(GL_LIGHT1, GL_FOG_MODE, integers);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(integers[0], 77);
    glGetLightiv(GL_LIGHT0 + 8, GL_DIFFUSE, integers);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(integers[0], 77);
}

}  // namespace
}  // namespace terrazzo::gl
