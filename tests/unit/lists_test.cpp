// Display lists (GL 1.5 §5.4): what is recorded, what is carried out at once, and the errors.
#include <GL/gl.h>
#include <sys/mman.h>

#include <array>
#include <map>
#include <thread>
#include <vector>

#include "attach_picture.h"
#include "gl/generated/calls.h"
#include "gl/list_primitives.h"
#include "gl/share.h"
#include "gl_fixture.h"
#include "guarded_memory.h"

namespace terrazzo::gl {
namespace {

class ListTest : public GlTest {
  protected:
    static GLint integer(GLenum pname) {
        GLint value = -1;
        glGetIntegerv(pname, &value);
        return value;
    }

    // A list that sets the stencil clear value to a number of its own.
    static void make_list(GLuint name, GLint mark) {
        glNewList(name, GL_COMPILE);
        glClearStencil(mark);
        glEndList();
    }

    // What the lists called by `call` set last.
    template <typename Call>
    GLint mark_after(Call call) {
        glClearStencil(0);
        call();
        return integer(GL_STENCIL_CLEAR_VALUE);
    }

    void expect_error(GLenum code) { EXPECT_EQ(glGetError(), code); }
};

TEST_F(ListTest, CompilingDoesNotExecute) {
    glNewList(5, GL_COMPILE);
    EXPECT_EQ(integer(GL_LIST_INDEX), 5);
    EXPECT_EQ(integer(GL_LIST_MODE), GL_COMPILE);
    glClearStencil(3);
    glEnable(GL_BLEND);
    EXPECT_EQ(integer(GL_STENCIL_CLEAR_VALUE), 0);
    EXPECT_FALSE(glIsEnabled(GL_BLEND));
    glEndList();
    EXPECT_EQ(integer(GL_LIST_INDEX), 0);
    glCallList(5);
    EXPECT_EQ(integer(GL_STENCIL_CLEAR_VALUE), 3);
    EXPECT_TRUE(glIsEnabled(GL_BLEND));
    expect_error(GL_NO_ERROR);
}

TEST_F(ListTest, CompileAndExecuteDoesBoth) {
    glNewList(1, GL_COMPILE_AND_EXECUTE);
    EXPECT_EQ(integer(GL_LIST_MODE), GL_COMPILE_AND_EXECUTE);
    glClearStencil(3);
    EXPECT_EQ(integer(GL_STENCIL_CLEAR_VALUE), 3);
    glEndList();
    EXPECT_EQ(mark_after([] { glCallList(1); }), 3);
}

TEST_F(ListTest, ErrorsOfNewListAndEndList) {
    glNewList(0, GL_COMPILE);
    expect_error(GL_INVALID_VALUE);
    glNewList(1, GL_RENDER);
    expect_error(GL_INVALID_ENUM);
    glEndList();
    expect_error(GL_INVALID_OPERATION);
    glNewList(1, GL_COMPILE);
    glNewList(2, GL_COMPILE);
    expect_error(GL_INVALID_OPERATION);
    EXPECT_EQ(integer(GL_LIST_INDEX), 1);
    glEndList();
    expect_error(GL_NO_ERROR);
    EXPECT_TRUE(glIsList(1));
    EXPECT_FALSE(glIsList(2));
}

TEST_F(ListTest, ErrorsBelongToTheCall) {
    glNewList(1, GL_COMPILE);
    glMatrixMode(GL_ONE);
    glLightfv(GL_LIGHT0, GL_AMBIENT, nullptr);  // known to be wrong when it is compiled
    glFogfv(GL_FOG_COLOR, nullptr);
    glEndList();
    expect_error(GL_NO_ERROR);
    glCallList(1);
    expect_error(GL_INVALID_ENUM);
    EXPECT_EQ(ctx().error.count, 3u);
}

TEST_F(ListTest, ArraysAreCopied) {
    std::vector<GLfloat> colour = {0.25f, 0.5f, 0.75f, 1};
    std::vector<GLdouble> matrix(16, 2.0);
    glNewList(1, GL_COMPILE);
    glFogfv(GL_FOG_COLOR, colour.data());
    glLoadMatrixd(matrix.data());
    glEndList();
    colour.assign(4, 0.0f);
    matrix.assign(16, 0.0);
    glCallList(1);
    std::array<GLfloat, 16> value;
    glGetFloatv(GL_FOG_COLOR, value.data());
    EXPECT_EQ(value[2], 0.75f);
    glGetFloatv(GL_MODELVIEW_MATRIX, value.data());
    EXPECT_EQ(value[7], 2.0f);
}

TEST_F(ListTest, ImagesAreUnpackedWhenTheyAreCompiled) {
    std::array<GLubyte, 128> mask{};
    for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = static_cast<GLubyte>(i * 37);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_LSB_FIRST, GL_TRUE);
    glPolygonStipple(mask.data());
    std::array<GLubyte, 128> expected{}, found{};
    glGetPolygonStipple(expected.data());

    glNewList(1, GL_COMPILE);
    glPolygonStipple(mask.data());
    glEndList();
    glPixelStorei(GL_UNPACK_LSB_FIRST, GL_FALSE);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 3);
    mask.fill(0);
    glPolygonStipple(std::array<GLubyte, 256>{}.data());
    glCallList(1);
    glGetPolygonStipple(found.data());
    EXPECT_EQ(found, expected);
    EXPECT_EQ(integer(GL_UNPACK_SKIP_ROWS), 3);
}

// Sizes with which a command fails do not make it read memory when it is compiled, as they do not outside: no
// size stands for something else.
TEST_F(ListTest, ImagesOfImpossibleSizesAreNotRead) {
    test::GuardedMemory memory(1);
    const auto* const pixels = memory.last<GLubyte>(1);
    for (const GLsizei depth : {-1, -2, 4096}) {
        const auto specify = [&] {
            glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 2048, 2048, depth, 0, GL_RGBA, GL_FLOAT, pixels);
        };
        const auto replace = [&] {
            glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, 2048, 2048, depth, GL_RGBA, GL_FLOAT, pixels);
        };
        specify();
        const GLenum error_of_image = glGetError();
        EXPECT_EQ(error_of_image, GLenum{GL_INVALID_VALUE});
        glNewList(1, GL_COMPILE);
        specify();
        replace();
        glEndList();
        expect_error(GL_NO_ERROR);
        glCallList(1);
        EXPECT_NE(glGetError(), GLenum{GL_NO_ERROR}) << depth;
    }
    for (const GLsizei width : {-1, 1 << 15}) {
        glNewList(1, GL_COMPILE);
        glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, width, 0, GL_RGBA, GL_FLOAT, pixels);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, 1, 0, GL_RGBA, GL_FLOAT, pixels);
        glEndList();
        glCallList(1);
        expect_error(GL_INVALID_VALUE);
    }
    // Pixel rectangles and bitmaps have negative sizes alone that fail.
    glNewList(1, GL_COMPILE);
    glDrawPixels(-1, 1, GL_RGBA, GL_FLOAT, pixels);
    glBitmap(1, -1, 0, 0, 0, 0, pixels);
    glEndList();
    expect_error(GL_NO_ERROR);
    glCallList(1);
    expect_error(GL_INVALID_VALUE);
}

TEST_F(ListTest, PixelRectanglesMayBeLargerThanTextures) {
    attach_picture(ctx(), 4, 4);
    const std::vector<GLubyte> pixels(std::size_t{4} * 20000, 255);
    glRasterPos2f(-1, -1);
    glNewList(1, GL_COMPILE);
    glDrawPixels(20000, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    glEndList();
    glCallList(1);
    std::array<GLubyte, 4> pixel{};
    glReadPixels(3, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
    EXPECT_EQ(pixel[0], 255);
    expect_error(GL_NO_ERROR);
}

TEST_F(ListTest, SomeCommandsAreCarriedOutAtOnce) {
    glNewList(50, GL_COMPILE);
    glPixelStorei(GL_PACK_ALIGNMENT, 8);
    const GLuint names = glGenLists(2);
    glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    EXPECT_EQ(integer(GL_PACK_ALIGNMENT), 8);
    EXPECT_EQ(integer(GL_CLIENT_ATTRIB_STACK_DEPTH), 1);
    EXPECT_TRUE(glIsList(names));
    EXPECT_FALSE(glIsList(50));  // not yet
    glDeleteLists(names, 2);
    glEndList();
    EXPECT_FALSE(glIsList(names));
    EXPECT_TRUE(glIsList(50));
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glCallList(50);
    EXPECT_EQ(integer(GL_PACK_ALIGNMENT), 4);
    expect_error(GL_NO_ERROR);
}

TEST_F(ListTest, EveryListableCommandIsRecordedAndNotExecuted) {
    // With arguments this wrong an executed command that checks them records an error at once.
    const Arguments wrong{-1, -1, nullptr};
    for (const Call& call : kEveryCall) {
        if (!call.implemented || !call.in_lists) continue;
        glNewList(1, GL_COMPILE);
        const unsigned errors = ctx().error.count;
        call.call(wrong);
        EXPECT_EQ(ctx().error.count, errors) << call.name;
        glEndList();
        glCallList(1);
    }
}

TEST_F(ListTest, ListsCallListsThatMayBeReplacedLater) {
    make_list(2, 20);
    glNewList(1, GL_COMPILE);
    glCallList(2);
    glCallList(99);  // does not exist: ignored
    glEndList();
    EXPECT_EQ(mark_after([] { glCallList(1); }), 20);
    make_list(2, 21);
    EXPECT_EQ(mark_after([] { glCallList(1); }), 21);
    glDeleteLists(2, 1);
    EXPECT_EQ(mark_after([] { glCallList(1); }), 0);
    expect_error(GL_NO_ERROR);
}

TEST_F(ListTest, NestingEndsAtTheLimit) {
    glNewList(1, GL_COMPILE);
    glTranslatef(1, 0, 0);
    glCallList(1);
    glEndList();
    glCallList(1);
    std::array<GLfloat, 16> matrix;
    glGetFloatv(GL_MODELVIEW_MATRIX, matrix.data());
    EXPECT_EQ(matrix[12], static_cast<GLfloat>(integer(GL_MAX_LIST_NESTING)));
    EXPECT_EQ(integer(GL_MAX_LIST_NESTING), 64);
    EXPECT_EQ(ctx().lists.nesting, 0);
}

TEST_F(ListTest, TheOldListStaysUntilTheNewOneIsFinished) {
    make_list(1, 7);
    glNewList(1, GL_COMPILE_AND_EXECUTE);
    glCallList(1);  // still the old one
    EXPECT_EQ(integer(GL_STENCIL_CLEAR_VALUE), 7);
    glClearStencil(8);
    glEndList();
    // Now the list calls itself, 64 deep, and sets 8 last.
    EXPECT_EQ(mark_after([] { glCallList(1); }), 8);
}

template <typename Type>
void call_one(GLenum type, Type offset) {
    glCallLists(1, type, &offset);
}

TEST_F(ListTest, NamesOfAllTypes) {
    make_list(0x0102, 1);
    make_list(0x010203, 2);
    make_list(0x01020304, 3);
    make_list(100, 4);
    make_list(200, 5);
    EXPECT_EQ(mark_after([] { call_one(GL_BYTE, GLbyte{100}); }), 4);
    EXPECT_EQ(mark_after([] { call_one(GL_UNSIGNED_BYTE, GLubyte{200}); }), 5);
    EXPECT_EQ(mark_after([] { call_one(GL_SHORT, GLshort{0x102}); }), 1);
    EXPECT_EQ(mark_after([] { call_one(GL_UNSIGNED_SHORT, GLushort{0x102}); }), 1);
    EXPECT_EQ(mark_after([] { call_one(GL_INT, GLint{0x10203}); }), 2);
    EXPECT_EQ(mark_after([] { call_one(GL_UNSIGNED_INT, GLuint{0x10203}); }), 2);
    EXPECT_EQ(mark_after([] { call_one(GL_FLOAT, GLfloat{200.75f}); }), 5);
    const GLubyte bytes[] = {1, 2, 3, 4};
    EXPECT_EQ(mark_after([&] { glCallLists(1, GL_2_BYTES, bytes); }), 1);
    EXPECT_EQ(mark_after([&] { glCallLists(1, GL_3_BYTES, bytes); }), 2);
    EXPECT_EQ(mark_after([&] { glCallLists(1, GL_4_BYTES, bytes); }), 3);
    glListBase(300);
    EXPECT_EQ(mark_after([] { call_one(GL_BYTE, GLbyte{-100}); }), 5);
    glListBase(0xffffffff);
    EXPECT_EQ(mark_after([] { call_one(GL_SHORT, GLshort{201}); }), 5);
    expect_error(GL_NO_ERROR);
    glCallLists(-1, GL_INT, bytes);
    expect_error(GL_INVALID_VALUE);
    glCallLists(1, GL_DOUBLE, bytes);
    expect_error(GL_INVALID_ENUM);
    glCallLists(0, GL_INT, nullptr);
    expect_error(GL_NO_ERROR);
    call_one(GL_FLOAT, __builtin_nanf(""));
    call_one(GL_FLOAT, -1e30f);
    expect_error(GL_NO_ERROR);
}

TEST_F(ListTest, TheListBaseIsTheOneOfTheCall) {
    make_list(11, 1);
    make_list(21, 2);
    const GLubyte one = 1;
    glNewList(1, GL_COMPILE);
    glCallLists(1, GL_UNSIGNED_BYTE, &one);
    glEndList();
    glListBase(10);
    EXPECT_EQ(mark_after([] { glCallList(1); }), 1);
    glListBase(20);
    EXPECT_EQ(mark_after([] { glCallList(1); }), 2);
    EXPECT_EQ(integer(GL_LIST_BASE), 20);
}

TEST_F(ListTest, NamesAreSetAside) {
    const GLuint first = glGenLists(3);
    for (GLuint i = 0; i < 3; ++i) EXPECT_TRUE(glIsList(first + i));
    EXPECT_FALSE(glIsList(first + 3));
    EXPECT_FALSE(glIsList(0));
    glCallList(first);  // empty
    glDeleteLists(first + 1, 1);
    EXPECT_TRUE(glIsList(first));
    EXPECT_FALSE(glIsList(first + 1));
    EXPECT_TRUE(glIsList(first + 2));
    EXPECT_EQ(glGenLists(0), 0u);
    expect_error(GL_NO_ERROR);
    EXPECT_EQ(glGenLists(-1), 0u);
    expect_error(GL_INVALID_VALUE);
    glDeleteLists(1, -1);
    expect_error(GL_INVALID_VALUE);
    const GLuint many = glGenLists(0x7fffffff);
    EXPECT_NE(many, 0u);
    EXPECT_TRUE(glIsList(many + 0x7ffffffe));
    glDeleteLists(0, 0x7fffffff);
    glDeleteLists(0x7fffffff, 0x7fffffff);
    EXPECT_FALSE(glIsList(many));
    EXPECT_FALSE(glIsList(first));
}

TEST_F(ListTest, GroupsShareLists) {
    const auto partner = create_context(Config{}, &ctx());
    const auto stranger = create_context(Config{}, nullptr);
    make_list(1, 9);
    make_current(partner.get());
    EXPECT_TRUE(glIsList(1));
    EXPECT_EQ(mark_after([] { glCallList(1); }), 9);
    make_current(stranger.get());
    EXPECT_FALSE(glIsList(1));
    make_current(&ctx());
}

// A list that is replaced and deleted while another thread plays it: every call sees a whole list or none.
TEST_F(ListTest, SharedListsMayChangeWhileTheyArePlayed) {
    const auto partner = create_context(Config{}, &ctx());
    const auto make_pair = [](GLint mark) {
        glNewList(1, GL_COMPILE);
        glClearStencil(mark);
        glStencilMask(static_cast<GLuint>(mark));
        glEndList();
    };
    make_pair(1);
    std::thread player([&] {
        make_current(partner.get());
        glStencilMask(0);  // equal to the clear value, until a list sets both
        for (int i = 0; i < 3000; ++i) {
            glCallList(1);
            GLint value = 0, mask = 0;
            glGetIntegerv(GL_STENCIL_CLEAR_VALUE, &value);
            glGetIntegerv(GL_STENCIL_WRITEMASK, &mask);
            ASSERT_EQ(value, mask) << i;
        }
        make_current(nullptr);
    });
    for (GLint i = 0; i < 3000; ++i) {
        make_pair(1 + i % 255);
        if (i % 7 == 0) glDeleteLists(1, 1);
    }
    player.join();
}

// How many records of each kind a list has become.
std::map<Opcode, int> records_of(Context& ctx, GLuint name) {
    std::map<Opcode, int> counts;
    ctx.shared->lists.at(name)->for_each([&](const RecordHeader& header) { ++counts[header.opcode]; });
    return counts;
}

TEST_F(ListTest, GeometryBecomesOneBatch) {
    glNewList(1, GL_COMPILE);
    for (GLint i = 0; i < 1000; ++i) {
        glBegin(GL_QUADS);
        glNormal3f(0, 0, 1);
        for (GLint corner = 0; corner < 4; ++corner) {
            glColor3f(0, static_cast<GLfloat>(corner), 0);
            glVertex2i(i, corner);
        }
        glEnd();
    }
    glTranslatef(1, 0, 0);
    glEndList();
    const std::map<Opcode, int> expected = {{Opcode::kPrimitives, 1}, {Opcode::kTranslatef, 1}};
    EXPECT_EQ(records_of(ctx(), 1), expected);
    ctx().shared->lists.at(1)->for_each([](const RecordHeader& header) {
        if (header.opcode != Opcode::kPrimitives) return;
        const auto& record = record_cast<PrimitivesRecord>(header);
        EXPECT_EQ(record.run_count, 1u);
        EXPECT_EQ(record.vertex_count, 4000u);
        EXPECT_EQ(record.stride, 4 * sizeof(GLfloat));  // x, y; red, green: the rest is as if it were missing
        EXPECT_EQ(record.before_count, 1u);             // the normal
    });
}

TEST_F(ListTest, WhatIsNoBatchIsRecordedCallByCall) {
    glNewList(1, GL_COMPILE);
    glBegin(GL_TRIANGLES);
    glVertex2i(0, 0);
    glColor3f(1, 0, 0);  // the vertex before has the colour that is current when the list is called
    glVertex2i(1, 0);
    glEnd();
    glEndList();
    const std::map<Opcode, int> expected = {
        {Opcode::kBegin, 1}, {Opcode::kVertex4f, 2}, {Opcode::kColor4f, 1}, {Opcode::kEnd, 1}};
    EXPECT_EQ(records_of(ctx(), 1), expected);
}

TEST_F(ListTest, LongListsAreWhole) {
    // Long lists span blocks, and records follow one another whatever their size.
    glNewList(1, GL_COMPILE);
    std::vector<GLubyte> names(70000, 2);
    for (int i = 0; i < 10000; ++i) glTranslatef(1, 0, 0);
    glCallLists(static_cast<GLsizei>(names.size()), GL_UNSIGNED_BYTE, names.data());
    glTranslatef(1, 0, 0);
    glEndList();
    glNewList(2, GL_COMPILE);
    glTranslatef(1, 0, 0);
    glEndList();
    glCallList(1);
    std::array<GLfloat, 16> matrix;
    glGetFloatv(GL_MODELVIEW_MATRIX, matrix.data());
    EXPECT_EQ(matrix[12], 80001.0f);
}

// GL leaves them indeterminate; the reference leaves them alone, and programs draw with what was there
// before.
// The names are read from memory that takes none: all of it is one page of zeros. Where 32 bits are an
// address there is no room for them.
TEST_F(ListTest, CommandsOfFourGigabytesAreRefused) {
    if (sizeof(std::size_t) < 8) GTEST_SKIP();
    constexpr GLsizei kNames = 1 << 30;
    constexpr std::size_t kBytes = 4ull * kNames;
    void* const names = mmap(nullptr, kBytes, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (names == MAP_FAILED) GTEST_SKIP() << "no addresses for it";
    glNewList(1, GL_COMPILE);
    glClearStencil(3);
    glCallLists(kNames, GL_UNSIGNED_INT, names);
    expect_error(GL_OUT_OF_MEMORY);
    glEndList();
    munmap(names, kBytes);
    EXPECT_EQ(mark_after([] { glCallList(1); }), 0);  // a list that has a gap is none
    make_list(1, 5);
    EXPECT_EQ(mark_after([] { glCallList(1); }), 5);
}

TEST_F(ListTest, ArraysInListsLeaveTheCurrentValues) {
    const GLfloat vertices[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const GLfloat normals[] = {1, 0, 0, 1, 0, 0, 1, 0, 0};
    const GLfloat colors[] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, vertices);
    glNormalPointer(GL_FLOAT, 0, normals);
    glColorPointer(3, GL_FLOAT, 0, colors);
    glNewList(77, GL_COMPILE);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glEndList();
    glNormal3f(0, 0, 1);
    glColor4f(0.25f, 0.5f, 0.75f, 1);
    glCallList(77);
    GLfloat value[4];
    glGetFloatv(GL_CURRENT_NORMAL, value);
    EXPECT_EQ(value[0], 0);
    EXPECT_EQ(value[2], 1);
    glGetFloatv(GL_CURRENT_COLOR, value);
    EXPECT_EQ(value[0], 0.25f);
    EXPECT_EQ(value[2], 0.75f);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
}

// The reference forgets the order here.
TEST_F(ListTest, ColorArraysMayHaveBlueFirst) {
    const GLfloat vertices[] = {0, 0, 0, 0};
    const GLubyte colors[] = {1, 2, 3, 4, 255, 51, 102, 153};
    const auto current = [](GLenum name) {
        std::array<GLfloat, 4> value;
        glGetFloatv(name, value.data());
        return value;
    };
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glEnableClientState(GL_SECONDARY_COLOR_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, vertices);
    glColorPointer(GL_BGRA, GL_UNSIGNED_BYTE, 0, colors);
    glSecondaryColorPointer(GL_BGRA, GL_UNSIGNED_BYTE, 0, colors);
    glBegin(GL_POINTS);
    glArrayElement(1);
    glEnd();
    const std::array<GLfloat, 4> expected{0.4f, 0.2f, 1, 0.6f}, opaque{0.4f, 0.2f, 1, 1};
    EXPECT_EQ(current(GL_CURRENT_COLOR), expected);
    EXPECT_EQ(current(GL_CURRENT_SECONDARY_COLOR), opaque);
    glNewList(1, GL_COMPILE);
    glArrayElement(1);
    glEndList();
    glColor3f(1, 1, 1);
    glSecondaryColor3f(1, 1, 1);
    glCallList(1);
    EXPECT_EQ(current(GL_CURRENT_COLOR), expected);
    EXPECT_EQ(current(GL_CURRENT_SECONDARY_COLOR), opaque);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
}

// What a list holds of commands that are not allowed between Begin and End is an error there, whatever else
// is wrong with it and even if it would do nothing.
TEST_F(ListTest, WhatIsNotAllowedBetweenBeginAndEndIsAnErrorThere) {
    struct Recorded {
        const char* text;
        void (*record)();
        GLenum outside, inside;
    };
    const Recorded all[] = {
        {"a draw without a vertex array", [] { glDrawArrays(GL_QUADS, 0, 4); }, GL_NO_ERROR,
         GL_INVALID_OPERATION},
        {"a draw of nothing", [] { glDrawArrays(GL_QUADS, 0, 0); }, GL_NO_ERROR, GL_INVALID_OPERATION},
        {"indices without a vertex array",
         [] {
             const GLubyte indices[3] = {0, 1, 2};
             glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, indices);
         },
         GL_NO_ERROR, GL_INVALID_OPERATION},
        {"no draws",
         [] {
             const GLint first = 0;
             const GLsizei count = 0;
             glMultiDrawArrays(GL_QUADS, &first, &count, 0);
         },
         GL_NO_ERROR, GL_INVALID_OPERATION},
        {"draws of nothing",
         [] {
             const GLint first[2] = {0, 0};
             const GLsizei count[2] = {0, 0};
             glMultiDrawArrays(GL_QUADS, first, count, 2);
         },
         GL_NO_ERROR, GL_INVALID_OPERATION},
        {"a draw of no primitive", [] { glDrawArrays(GL_POLYGON + 1, 0, 4); }, GL_INVALID_ENUM,
         GL_INVALID_OPERATION},
        {"draws of no primitive",
         [] {
             const GLint first = 0;
             const GLsizei count = 0;
             glMultiDrawArrays(GL_POLYGON + 1, &first, &count, 1);
         },
         GL_INVALID_ENUM, GL_INVALID_OPERATION},
        {"a null pointer", [] { glFogfv(GL_FOG_COLOR, nullptr); }, GL_INVALID_VALUE, GL_INVALID_OPERATION},
        {"a single value for a vector", [] { glLightModelf(GL_LIGHT_MODEL_AMBIENT, 1); }, GL_NO_ERROR,
         GL_INVALID_OPERATION},
        // These are allowed: their own errors count.
        {"a material of null", [] { glMaterialfv(GL_FRONT, GL_AMBIENT, nullptr); }, GL_INVALID_VALUE,
         GL_INVALID_VALUE},
        {"a negative element", [] { glArrayElement(-1); }, GL_INVALID_VALUE, GL_INVALID_VALUE},
        {"a single value for a material", [] { glMaterialf(GL_FRONT, GL_AMBIENT, 1); }, GL_NO_ERROR,
         GL_NO_ERROR},
    };
    for (const Recorded& r : all) {
        for (const GLenum mode : {GL_COMPILE, GL_COMPILE_AND_EXECUTE}) {
            SCOPED_TRACE(r.text);
            glNewList(1, mode);
            r.record();
            glEndList();
            expect_error(mode == GL_COMPILE ? GLenum{GL_NO_ERROR} : r.outside);
            glCallList(1);
            expect_error(r.outside);
            glBegin(GL_POINTS);
            glCallList(1);
            glEnd();
            expect_error(r.inside);
            // Begin and End in the list themselves.
            glNewList(2, mode);
            glBegin(GL_POINTS);
            r.record();
            glEnd();
            glEndList();
            expect_error(mode == GL_COMPILE ? GLenum{GL_NO_ERROR} : r.inside);
            glCallList(2);
            expect_error(r.inside);
        }
    }
}

}  // namespace
}  // namespace terrazzo::gl
