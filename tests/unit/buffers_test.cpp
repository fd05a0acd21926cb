// Buffer objects: names, stores, mapping, sharing, what deleting undoes; arrays in them, also past their end.
#include "gl/buffers.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "attach_picture.h"
#include "gl/generated/commands.h"
#include "gl/generated/dispatch.h"
#include "gl/list_record.h"
#include "gl/share.h"
#include "gl_fixture.h"

namespace terrazzo::gl {
namespace {

using testing::Each;
using testing::ElementsAre;

const void* offset(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes);
}

class BuffersTest : public GlTest {
  protected:
    GLuint make_buffer(GLenum target, GLsizeiptr size, const void* data) {
        GLuint name = 0;
        gen_buffers(ctx(), 1, &name);
        bind_buffer(ctx(), target, name);
        buffer_data(ctx(), target, size, data, GL_STATIC_DRAW);
        EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
        return name;
    }

    GLint parameter(GLenum target, GLenum pname) {
        GLint value = -1;
        get_buffer_parameteriv(ctx(), target, pname, &value);
        return value;
    }

    GLint binding(GLenum pname) {
        GLint value = -1;
        get_integerv(ctx(), pname, &value);
        return value;
    }

    // A window of 8x8 pixels in whose coordinates vertices are given, black.
    void open_window() {
        attach_picture(ctx(), kSize, kSize);
        matrix_mode(ctx(), GL_PROJECTION);
        ortho(ctx(), 0, kSize, 0, kSize, -1, 1);
    }

    int lit_pixels() {
        std::array<GLubyte, 4 * kSize * kSize> rgba{};
        read_pixels(ctx(), 0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
        int count = 0;
        for (std::size_t i = 0; i < rgba.size(); i += 4) count += rgba[i] != 0;
        return count;
    }

    static constexpr int kSize = 8;
    static constexpr GLfloat kSquare[] = {0, 0, kSize, 0, kSize, kSize, 0, kSize};
};

TEST_F(BuffersTest, NamesBecomeObjectsWhenBound) {
    GLuint names[2];
    gen_buffers(ctx(), 2, names);
    EXPECT_NE(names[0], names[1]);
    EXPECT_EQ(is_buffer(ctx(), names[0]), GL_FALSE);
    bind_buffer(ctx(), GL_ARRAY_BUFFER, names[0]);
    EXPECT_EQ(is_buffer(ctx(), names[0]), GL_TRUE);
    EXPECT_EQ(is_buffer(ctx(), names[1]), GL_FALSE);
    EXPECT_EQ(is_buffer(ctx(), 0), GL_FALSE);
    bind_buffer(ctx(), GL_ELEMENT_ARRAY_BUFFER, 77);
    EXPECT_EQ(is_buffer(ctx(), 77), GL_TRUE);
    EXPECT_EQ(binding(GL_ARRAY_BUFFER_BINDING), static_cast<GLint>(names[0]));
    EXPECT_EQ(binding(GL_ELEMENT_ARRAY_BUFFER_BINDING), 77);
}

TEST_F(BuffersTest, StoresAreReadAndWrittenInPart) {
    const GLubyte bytes[] = {1, 2, 3, 4, 5, 6, 7, 8};
    make_buffer(GL_ARRAY_BUFFER, sizeof bytes, bytes);
    const GLubyte part[] = {30, 40};
    buffer_sub_data(ctx(), GL_ARRAY_BUFFER, 2, 2, part);
    GLubyte read[8] = {};
    get_buffer_sub_data(ctx(), GL_ARRAY_BUFFER, 1, 4, read);
    EXPECT_THAT(read, ElementsAre(2, 30, 40, 5, 0, 0, 0, 0));
    for (const auto& [from, size] : {std::pair{-1, 2}, {7, 2}, {0, -1}, {9, 0}}) {
        buffer_sub_data(ctx(), GL_ARRAY_BUFFER, from, size, part);
        EXPECT_EQ(take_error(), GLenum{GL_INVALID_VALUE}) << from << ' ' << size;
        get_buffer_sub_data(ctx(), GL_ARRAY_BUFFER, from, size, read);
        EXPECT_EQ(take_error(), GLenum{GL_INVALID_VALUE}) << from << ' ' << size;
    }
    EXPECT_EQ(parameter(GL_ARRAY_BUFFER, GL_BUFFER_SIZE), 8);
    EXPECT_EQ(parameter(GL_ARRAY_BUFFER, GL_BUFFER_USAGE), GL_STATIC_DRAW);
}

TEST_F(BuffersTest, WithoutABufferNothingWorks) {
    GLubyte byte = 0;
    void* pointer = nullptr;
    buffer_data(ctx(), GL_ARRAY_BUFFER, 1, &byte, GL_STATIC_DRAW);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
    buffer_sub_data(ctx(), GL_ARRAY_BUFFER, 0, 1, &byte);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
    EXPECT_EQ(map_buffer(ctx(), GL_ARRAY_BUFFER, GL_READ_ONLY), nullptr);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
    EXPECT_EQ(unmap_buffer(ctx(), GL_ARRAY_BUFFER), GL_FALSE);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
    get_buffer_pointerv(ctx(), GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER, &pointer);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
}

TEST_F(BuffersTest, MappedBuffersAreTheClients) {
    const GLubyte bytes[] = {1, 2, 3, 4};
    make_buffer(GL_ARRAY_BUFFER, sizeof bytes, bytes);
    auto* const mapped = static_cast<GLubyte*>(map_buffer(ctx(), GL_ARRAY_BUFFER, GL_WRITE_ONLY));
    ASSERT_NE(mapped, nullptr);
    EXPECT_EQ(parameter(GL_ARRAY_BUFFER, GL_BUFFER_MAPPED), GL_TRUE);
    EXPECT_EQ(parameter(GL_ARRAY_BUFFER, GL_BUFFER_ACCESS), GL_WRITE_ONLY);
    void* pointer = nullptr;
    get_buffer_pointerv(ctx(), GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER, &pointer);
    EXPECT_EQ(pointer, mapped);
    mapped[2] = 9;

    GLubyte read[4] = {};
    get_buffer_sub_data(ctx(), GL_ARRAY_BUFFER, 0, 4, read);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
    EXPECT_THAT(read, Each(0));
    EXPECT_EQ(map_buffer(ctx(), GL_ARRAY_BUFFER, GL_READ_ONLY), nullptr);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});

    EXPECT_EQ(unmap_buffer(ctx(), GL_ARRAY_BUFFER), GL_TRUE);
    get_buffer_sub_data(ctx(), GL_ARRAY_BUFFER, 0, 4, read);
    EXPECT_THAT(read, ElementsAre(1, 2, 9, 4));
    get_buffer_pointerv(ctx(), GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER, &pointer);
    EXPECT_EQ(pointer, nullptr);
    // New data unmaps.
    map_buffer(ctx(), GL_ARRAY_BUFFER, GL_READ_ONLY);
    buffer_data(ctx(), GL_ARRAY_BUFFER, 2, bytes, GL_STREAM_DRAW);
    EXPECT_EQ(parameter(GL_ARRAY_BUFFER, GL_BUFFER_MAPPED), GL_FALSE);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
}

TEST_F(BuffersTest, PointersLatchTheArrayBuffer) {
    const GLuint first = make_buffer(GL_ARRAY_BUFFER, 64, nullptr);
    vertex_pointer(ctx(), 2, GL_FLOAT, 0, offset(8));
    const GLuint second = make_buffer(GL_ARRAY_BUFFER, 64, nullptr);
    interleaved_arrays(ctx(), GL_C4UB_V3F, 0, offset(16));
    normal_pointer(ctx(), GL_FLOAT, 0, nullptr);
    bind_buffer(ctx(), GL_ARRAY_BUFFER, first);
    EXPECT_EQ(binding(GL_VERTEX_ARRAY_BUFFER_BINDING), static_cast<GLint>(second));
    EXPECT_EQ(binding(GL_COLOR_ARRAY_BUFFER_BINDING), static_cast<GLint>(second));
    EXPECT_EQ(binding(GL_NORMAL_ARRAY_BUFFER_BINDING), static_cast<GLint>(second));
    EXPECT_EQ(binding(GL_INDEX_ARRAY_BUFFER_BINDING), 0);
    void* pointer = nullptr;
    get_pointerv(ctx(), GL_VERTEX_ARRAY_POINTER, &pointer);
    EXPECT_EQ(pointer, offset(20));

    push_client_attrib(ctx(), GL_CLIENT_VERTEX_ARRAY_BIT);
    delete_buffers(ctx(), 1, &second);
    EXPECT_EQ(binding(GL_VERTEX_ARRAY_BUFFER_BINDING), 0);
    EXPECT_EQ(binding(GL_ARRAY_BUFFER_BINDING), static_cast<GLint>(first));
    bind_buffer(ctx(), GL_ARRAY_BUFFER, 0);
    pop_client_attrib(ctx());
    EXPECT_EQ(binding(GL_VERTEX_ARRAY_BUFFER_BINDING), 0) << "deleted buffers stay deleted";
    EXPECT_EQ(binding(GL_ARRAY_BUFFER_BINDING), static_cast<GLint>(first));
}

// What is left of a pointer is an offset into nothing: no address that a draw may read from. The reference
// does.
TEST_F(BuffersTest, ArraysWhoseBufferIsDeletedAreNotRead) {
    open_window();
    const auto specify = [&] {
        const GLuint name = make_buffer(GL_ARRAY_BUFFER, 400, nullptr);
        vertex_pointer(ctx(), 2, GL_FLOAT, 0, offset(16));
        color_pointer(ctx(), 4, GL_UNSIGNED_BYTE, 0, offset(24));
        index_pointer(ctx(), GL_FLOAT, 0, offset(32));
        enable_client_state(ctx(), GL_VERTEX_ARRAY);
        enable_client_state(ctx(), GL_COLOR_ARRAY);
        enable_client_state(ctx(), GL_INDEX_ARRAY);
        return name;
    };
    const auto use = [&] {
        EXPECT_EQ(binding(GL_VERTEX_ARRAY_BUFFER_BINDING), 0);
        void* pointer = nullptr;
        get_pointerv(ctx(), GL_VERTEX_ARRAY_POINTER, &pointer);
        EXPECT_EQ(pointer, offset(16)) << "what the client gave";
        const GLubyte indices[] = {0, 1, 2};
        draw_arrays(ctx(), GL_TRIANGLES, 0, 3);
        draw_elements(ctx(), GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, indices);
        begin(ctx(), GL_POINTS);
        array_element(ctx(), 0);
        end(ctx());
        new_list(ctx(), 1, GL_COMPILE);
        current.table->DrawArrays(&ctx(), GL_TRIANGLES, 0, 3);
        current.table->ArrayElement(&ctx(), 0);
        end_list(ctx());
        call_list(ctx(), 1);
        finish(ctx());
        EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
    };
    const GLuint deleted = specify();
    delete_buffers(ctx(), 1, &deleted);
    use();
    const GLuint saved = specify();
    push_client_attrib(ctx(), GL_CLIENT_VERTEX_ARRAY_BIT);
    delete_buffers(ctx(), 1, &saved);
    pop_client_attrib(ctx());
    use();
    // In another context: what is bound there stays, what is only saved does not come back.
    const std::unique_ptr<Context> other = create_context({}, &ctx());
    const GLuint shared = specify();
    push_client_attrib(ctx(), GL_CLIENT_VERTEX_ARRAY_BIT);
    delete_buffers(*other, 1, &shared);
    EXPECT_EQ(binding(GL_VERTEX_ARRAY_BUFFER_BINDING), static_cast<GLint>(shared));
    pop_client_attrib(ctx());
    use();

    // New pointers are the client's.
    vertex_pointer(ctx(), 2, GL_FLOAT, 0, kSquare);
    disable_client_state(ctx(), GL_COLOR_ARRAY);
    current.table->Color4f(&ctx(), 1, 1, 1, 1);
    draw_arrays(ctx(), GL_QUADS, 0, 4);
    EXPECT_EQ(lit_pixels(), kSize * kSize);
}

// The offsets of interleaved arrays are from a null pointer no addresses either.
TEST_F(BuffersTest, InterleavedArraysOfNoMemoryAreNotRead) {
    open_window();
    for (const GLenum format : {GL_T4F_C4F_N3F_V4F, GL_C4UB_V2F, GL_T2F_V3F, GL_V3F}) {
        interleaved_arrays(ctx(), format, 0, nullptr);
        draw_arrays(ctx(), GL_TRIANGLES, 0, 3);
        begin(ctx(), GL_POINTS);
        array_element(ctx(), 0);
        end(ctx());
        EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
    }
    EXPECT_EQ(lit_pixels(), 0);
    interleaved_arrays(ctx(), GL_V2F, 0, kSquare);
    draw_arrays(ctx(), GL_QUADS, 0, 4);
    EXPECT_EQ(lit_pixels(), kSize * kSize) << "the client's memory";
    make_buffer(GL_ARRAY_BUFFER, sizeof kSquare, kSquare);
    interleaved_arrays(ctx(), GL_V2F, 0, nullptr);
    clear(ctx(), GL_COLOR_BUFFER_BIT);
    draw_arrays(ctx(), GL_QUADS, 0, 4);
    EXPECT_EQ(lit_pixels(), kSize * kSize) << "the beginning of a buffer";
}

TEST_F(BuffersTest, ContextsShareThem) {
    const GLubyte bytes[] = {5, 6};
    const GLuint name = make_buffer(GL_ARRAY_BUFFER, sizeof bytes, bytes);
    const std::unique_ptr<Context> other = create_context({}, &ctx());
    bind_buffer(*other, GL_ARRAY_BUFFER, name);
    delete_buffers(ctx(), 1, &name);
    EXPECT_EQ(is_buffer(*other, name), GL_FALSE);
    GLubyte read[2] = {};
    get_buffer_sub_data(*other, GL_ARRAY_BUFFER, 0, 2, read);
    EXPECT_THAT(read, ElementsAre(5, 6)) << "what is bound elsewhere stays there";
}

TEST_F(BuffersTest, ArraysAndIndicesAreReadFromBuffers) {
    open_window();
    make_buffer(GL_ARRAY_BUFFER, sizeof kSquare, kSquare);
    vertex_pointer(ctx(), 2, GL_FLOAT, 0, nullptr);
    bind_buffer(ctx(), GL_ARRAY_BUFFER, 0);
    enable_client_state(ctx(), GL_VERTEX_ARRAY);
    const GLushort indices[] = {77, 0, 1, 2, 3};
    make_buffer(GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices);
    draw_elements(ctx(), GL_QUADS, 4, GL_UNSIGNED_SHORT, offset(2));
    EXPECT_EQ(lit_pixels(), kSize * kSize);
}

TEST_F(BuffersTest, MappedBuffersAreNotDrawnFrom) {
    open_window();
    make_buffer(GL_ARRAY_BUFFER, sizeof kSquare, kSquare);
    vertex_pointer(ctx(), 2, GL_FLOAT, 0, nullptr);
    enable_client_state(ctx(), GL_VERTEX_ARRAY);
    map_buffer(ctx(), GL_ARRAY_BUFFER, GL_READ_ONLY);
    draw_arrays(ctx(), GL_QUADS, 0, 4);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
    array_element(ctx(), 0);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
    unmap_buffer(ctx(), GL_ARRAY_BUFFER);

    const GLubyte indices[] = {0, 1, 2, 3};
    make_buffer(GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices);
    map_buffer(ctx(), GL_ELEMENT_ARRAY_BUFFER, GL_READ_ONLY);
    draw_elements(ctx(), GL_QUADS, 4, GL_UNSIGNED_BYTE, nullptr);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
    EXPECT_EQ(lit_pixels(), 0);
}

// The window's last row and column show whether the missing corner was taken for (0, 0).
TEST_F(BuffersTest, WhatIsPastTheEndIsZero) {
    open_window();
    make_buffer(GL_ARRAY_BUFFER, sizeof kSquare - 4, kSquare);  // half of the last vertex is missing
    vertex_pointer(ctx(), 2, GL_FLOAT, 0, nullptr);
    enable_client_state(ctx(), GL_VERTEX_ARRAY);
    draw_arrays(ctx(), GL_TRIANGLE_FAN, 0, 4);
    EXPECT_EQ(lit_pixels(), kSize * (kSize + 1) / 2) << "one triangle, and one without area";

    const GLuint indices[] = {0, 1, 2, 0x40000000, 0xffffffff};
    clear(ctx(), GL_COLOR_BUFFER_BIT);
    draw_elements(ctx(), GL_TRIANGLE_FAN, 5, GL_UNSIGNED_INT, indices);
    EXPECT_EQ(lit_pixels(), kSize * (kSize + 1) / 2);
    draw_arrays(ctx(), GL_POINTS, 0x7fffffff, 1);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
    begin(ctx(), GL_POINTS);
    array_element(ctx(), 0x7fffffff);
    end(ctx());
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});

    // Indices that are not there are not drawn.
    make_buffer(GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices);
    clear(ctx(), GL_COLOR_BUFFER_BIT);
    draw_elements(ctx(), GL_TRIANGLES, 0x7fffffff, GL_UNSIGNED_INT, nullptr);
    EXPECT_EQ(lit_pixels(), kSize * (kSize + 1) / 2);
    draw_elements(ctx(), GL_TRIANGLES, 3, GL_UNSIGNED_INT, offset(1000));
    draw_elements(ctx(), GL_TRIANGLES, 3, GL_UNSIGNED_INT, offset(static_cast<std::size_t>(-4)));
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
}

// A count that is wrong must not take all memory, neither when it is drawn nor when it is recorded.
TEST_F(BuffersTest, DrawsFarBeyondTheEndAreRefused) {
    open_window();
    make_buffer(GL_ARRAY_BUFFER, 2028, nullptr);
    interleaved_arrays(ctx(), GL_T2F_C4F_N3F_V3F, 0, nullptr);
    draw_arrays(ctx(), GL_POINTS, 14, 1 << 16);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
    const Dispatch& execute = kNormalTable;
    execute.DrawArrays(&ctx(), GL_LINES, 14, 0x7fffffff);
    EXPECT_EQ(take_error(), GLenum{GL_OUT_OF_MEMORY});
    new_list(ctx(), 1, GL_COMPILE);
    current.table->DrawArrays(&ctx(), GL_LINES, 14, 0x7fffffff);
    EXPECT_EQ(take_error(), GLenum{GL_OUT_OF_MEMORY});
    end_list(ctx());
    EXPECT_EQ(is_list(ctx(), 1), GL_FALSE);
}

// Many indices that name few elements keep their few elements in lists.
TEST_F(BuffersTest, ListsKeepIndicesThatRepeatElements) {
    open_window();
    const std::vector<GLfloat> all(2 * 300, 0);
    std::vector<GLfloat> vertices = all;
    std::ranges::copy(kSquare, vertices.begin() + 2 * 200);  // elements 200 to 203
    vertex_pointer(ctx(), 2, GL_FLOAT, 0, vertices.data());
    enable_client_state(ctx(), GL_VERTEX_ARRAY);
    std::vector<GLubyte> indices(std::size_t{3} << 20);
    for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<GLubyte>(200 + i % 4);
    new_list(ctx(), 1, GL_COMPILE);
    current.table->DrawElements(&ctx(), GL_QUADS, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_BYTE,
                                indices.data());
    end_list(ctx());
    std::size_t bytes = 0;
    ctx().shared->lists.at(1)->for_each([&](const RecordHeader& header) { bytes += header.size; });
    EXPECT_LT(bytes, 5 * indices.size()) << "an index each";
    vertices = all;
    call_list(ctx(), 1);
    EXPECT_EQ(lit_pixels(), kSize * kSize);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
}

TEST_F(BuffersTest, ListsReadTheArraysWhenTheyAreCompiled) {
    open_window();
    make_buffer(GL_ARRAY_BUFFER, sizeof kSquare, kSquare);
    vertex_pointer(ctx(), 2, GL_FLOAT, 0, nullptr);
    enable_client_state(ctx(), GL_VERTEX_ARRAY);
    const GLubyte indices[] = {0, 1, 2, 3};
    const GLuint elements = make_buffer(GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices);
    new_list(ctx(), 1, GL_COMPILE);
    current.table->DrawElements(&ctx(), GL_QUADS, 4, GL_UNSIGNED_BYTE, nullptr);
    end_list(ctx());
    const GLfloat zeros[8] = {};
    buffer_sub_data(ctx(), GL_ARRAY_BUFFER, 0, sizeof zeros, zeros);
    delete_buffers(ctx(), 1, &elements);
    call_list(ctx(), 1);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
    EXPECT_EQ(lit_pixels(), kSize * kSize);
}

TEST_F(BuffersTest, NewDataDoesNotReachDrawsBefore) {
    open_window();
    make_buffer(GL_ARRAY_BUFFER, sizeof kSquare, kSquare);
    vertex_pointer(ctx(), 2, GL_FLOAT, 0, nullptr);
    enable_client_state(ctx(), GL_VERTEX_ARRAY);
    draw_arrays(ctx(), GL_QUADS, 0, 4);
    const GLfloat zeros[8] = {};
    buffer_data(ctx(), GL_ARRAY_BUFFER, sizeof zeros, zeros, GL_STREAM_DRAW);
    EXPECT_EQ(lit_pixels(), kSize * kSize);
}

}  // namespace
}  // namespace terrazzo::gl
