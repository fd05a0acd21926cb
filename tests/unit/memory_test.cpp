// Lack of memory: whichever allocation fails, a command records GL_OUT_OF_MEMORY, nothing is thrown out of an
// entry point, and the context goes on working.
#include <GL/gl.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <new>
#include <vector>

#include "gl/context.h"
#include "attach_picture.h"

namespace {

// Allocations until one fails; negative: none will. The calling thread's alone, as the pipeline's threads do
// not start where memory has run out.
thread_local long allocations_left = -1;

void* allocate(std::size_t size) {
    if (allocations_left == 0) throw std::bad_alloc();
    if (allocations_left > 0) --allocations_left;
    if (void* memory = std::malloc(size ? size : 1)) return memory;
    throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) {
    return allocate(size);
}
void* operator new[](std::size_t size) {
    return allocate(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace terrazzo::gl {
namespace {

constexpr int kSize = 32;

class MemoryTest : public testing::Test {
  protected:
    MemoryTest() : m_ctx(create_context(Config{}, nullptr)) {
        attach_picture(*m_ctx, kSize, kSize);
        make_current(m_ctx.get());
    }
    ~MemoryTest() override { make_current(nullptr); }

    // Runs `commands` with ever more memory until there is enough; returns how often there was not.
    template <typename Commands>
    static int starve(Commands commands) {
        for (int allocations = 0;; ++allocations) {
            allocations_left = allocations;
            commands();
            allocations_left = -1;
            const GLenum error = glGetError();
            if (error == GL_NO_ERROR) return allocations;
            EXPECT_EQ(error, GLenum{GL_OUT_OF_MEMORY}) << "after " << allocations << " allocations";
            if (HasFailure() || allocations > 10000) return allocations;
        }
    }

    static void finish_list() {
        GLint compiling = 0;
        glGetIntegerv(GL_LIST_INDEX, &compiling);
        if (compiling) glEndList();
    }

    std::unique_ptr<Context> m_ctx;
};

TEST_F(MemoryTest, GeometryAndPixels) {
    const int failures = starve([] {
        glColor3f(1, 0, 0);
        glBegin(GL_TRIANGLES);
        for (int i = 0; i < 3000; ++i) {
            glColor3f(0, 1, static_cast<GLfloat>(i & 1));
            glVertex2i(i % 3 - 1, i % 2);
        }
        glEnd();
        glFlush();
    });
    EXPECT_GT(failures, 0);
    // The context is as good as new.
    glClear(GL_COLOR_BUFFER_BIT);
    glColor3f(1, 1, 1);
    glRectf(-1, -1, 1, 1);
    std::array<GLubyte, 4> pixel{};
    glReadPixels(5, 5, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
    EXPECT_EQ(pixel, (std::array<GLubyte, 4>{255, 255, 255, 255}));
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(MemoryTest, AListThatCouldNotBeMadeLeavesTheOldOne) {
    glNewList(1, GL_COMPILE);
    glClearStencil(7);
    glEndList();
    const auto compile = [] {
        glNewList(1, GL_COMPILE);
        for (int i = 0; i < 200; ++i) glTranslatef(1, 0, 0);
        glBegin(GL_QUADS);
        for (int i = 0; i < 400; ++i) {
            glColor3f(static_cast<GLfloat>(i), 0, 0);
            glVertex2i(i, 0);
        }
        glEnd();
        glClearStencil(8);
        finish_list();
    };
    for (int allocations = 0;; ++allocations) {
        allocations_left = allocations;
        compile();
        allocations_left = -1;
        const GLenum error = glGetError();
        finish_list();
        glCallList(1);
        GLint mark = 0;
        glGetIntegerv(GL_STENCIL_CLEAR_VALUE, &mark);
        ASSERT_EQ(mark, error == GL_NO_ERROR ? 8 : 7) << "after " << allocations << " allocations";
        if (error == GL_NO_ERROR) break;
        ASSERT_EQ(error, GLenum{GL_OUT_OF_MEMORY});
    }
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(MemoryTest, NamesTexturesAndStacks) {
    std::vector<GLubyte> texels(64 * 64 * 4, 200);
    const int failures = starve([&] {
        const GLuint list = glGenLists(4);
        GLuint texture = 0;
        glGenTextures(1, &texture);
        glBindTexture(GL_TEXTURE_2D, texture);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 32, 32, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
        GLint depth[3] = {};
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
        glPushMatrix();
        glGetIntegerv(GL_ATTRIB_STACK_DEPTH, &depth[0]);
        glGetIntegerv(GL_CLIENT_ATTRIB_STACK_DEPTH, &depth[1]);
        glGetIntegerv(GL_MODELVIEW_STACK_DEPTH, &depth[2]);
        if (depth[0] > 0) glPopAttrib();
        if (depth[1] > 0) glPopClientAttrib();
        if (depth[2] > 1) glPopMatrix();
        glDeleteTextures(1, &texture);
        if (list) glDeleteLists(list, 4);
    });
    EXPECT_GT(failures, 0);
}

TEST_F(MemoryTest, ContextsAndSurfaces) {
    for (long allocations = 0; allocations < 200; ++allocations) {
        allocations_left = allocations;
        try {
            const auto ctx = create_context(Config{}, m_ctx.get());
            attach_picture(*ctx, 2 * kSize, 2 * kSize);
        } catch (const std::bad_alloc&) {
        }
        try {
            attach_picture(*m_ctx, kSize + 1, kSize);
        } catch (const std::bad_alloc&) {
            EXPECT_EQ(m_ctx->surface.width, kSize);
        }
        allocations_left = -1;
    }
    EXPECT_EQ(m_ctx->surface.width, kSize + 1);
}

}  // namespace
}  // namespace terrazzo::gl
