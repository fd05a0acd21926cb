// Objects, contexts, processes and the library itself that come and go while draws are queued or threads run.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>

#include "kit/offscreen.h"
#include "random_draws.h"

namespace terrazzo::stress {
namespace {

using Pixel = std::array<std::uint8_t, 4>;

constexpr int kWidth = 128, kHeight = 96;
constexpr Pixel kRed{255, 0, 0, 255}, kGreen{0, 255, 0, 255}, kBlue{0, 0, 255, 255};

const kit::Library& library() {
    static const kit::Library own(TERRAZZO_OWN_LIBRARY);
    return own;
}

kit::ContextOptions options(OSMesaContext share = nullptr) {
    return {.width = kWidth, .height = kHeight, .share = share};
}

Pixel pixel(const kit::OffscreenContext& context, int x, int y) {
    Pixel p;
    std::copy_n(context.colour_buffer().begin() + (y * kWidth + x) * 4, 4, p.begin());
    return p;
}

// A one-texel texture drawn over a vertical third of the picture.
class QueuedTexture : public testing::Test {
  protected:
    QueuedTexture() {
        gl.GenTextures(2, textures);
        gl.BindTexture(GL_TEXTURE_2D, textures[0]);
        nearest();
        upload(kRed);
        gl.Enable(GL_TEXTURE_2D);
        gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        gl.Clear(GL_COLOR_BUFFER_BIT);
    }
    void nearest() {
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    void upload(const Pixel& texel) {
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel.data());
    }
    // Many strips, so that the pool of threads takes part.
    void cover_third(int third) {
        const float left = -1 + 2 * static_cast<float>(third) / 3, step = 2.0f / 3 / 64;
        gl.Begin(GL_QUADS);
        for (int i = 0; i < 64; ++i) {
            const float x = left + step * static_cast<float>(i);
            gl.Vertex2f(x, -1), gl.Vertex2f(x + step, -1), gl.Vertex2f(x + step, 1), gl.Vertex2f(x, 1);
        }
        gl.End();
    }
    Pixel third(int number) { return pixel(context, kWidth / 6 + number * kWidth / 3, kHeight / 2); }

    const kit::Gl& gl = library().gl;
    kit::OffscreenContext context{library(), options()};
    GLuint textures[2] = {};
};

TEST_F(QueuedTexture, NewImage) {
    cover_third(0);
    upload(kGreen);
    cover_third(1);
    gl.Finish();
    EXPECT_EQ(third(0), kRed);
    EXPECT_EQ(third(1), kGreen);
}

TEST_F(QueuedTexture, PartOfTheImage) {
    cover_third(0);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, kBlue.data());
    cover_third(1);
    upload(kGreen);
    cover_third(2);
    gl.Finish();
    EXPECT_EQ(third(0), kRed);
    EXPECT_EQ(third(1), kBlue);
    EXPECT_EQ(third(2), kGreen);
}

TEST_F(QueuedTexture, CopyFromTheFrameBuffer) {
    cover_third(0);
    upload(kGreen);
    cover_third(1);
    gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kWidth / 6, kHeight / 2, 1, 1);
    cover_third(2);
    gl.Finish();
    EXPECT_EQ(third(1), kGreen);
    EXPECT_EQ(third(2), kRed);
}

TEST_F(QueuedTexture, Deleted) {
    cover_third(0);
    gl.DeleteTextures(1, &textures[0]);
    gl.BindTexture(GL_TEXTURE_2D, textures[1]);
    nearest();
    upload(kGreen);
    cover_third(1);
    gl.Finish();
    EXPECT_EQ(third(0), kRed);
    EXPECT_EQ(third(1), kGreen);
}

TEST_F(QueuedTexture, ReplacedThousandsOfTimes) {
    for (int i = 0; i < 3000; ++i) {
        upload({static_cast<std::uint8_t>(i), 0, 0, 255});
        cover_third(i % 3);
    }
    gl.Finish();
    for (int i = 0; i < 3; ++i) EXPECT_EQ(third(i), (Pixel{static_cast<std::uint8_t>(2997 + i), 0, 0, 255}));
}

std::vector<std::uint8_t> picture_of_seed(std::uint64_t seed) {
    const kit::OffscreenContext context(library(), options());
    draw_random(library().gl, seed, kWidth, kHeight);
    const auto picture = context.colour_buffer();
    return {picture.begin(), picture.end()};
}

TEST(Threads, ContextsDrawAtTheSameTime) {
    constexpr int kThreads = 4, kSeeds = 12;
    std::vector<std::vector<std::uint8_t>> expected;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) expected.push_back(picture_of_seed(seed));
    std::atomic<int> wrong = 0;
    std::vector<std::thread> threads;
    for (int t = 0; t < kThreads; ++t)
        threads.emplace_back([&, t] {
            for (std::uint64_t i = 0; i < kSeeds; ++i) {
                const std::uint64_t seed = (i + static_cast<std::uint64_t>(t) * 3) % kSeeds;
                wrong += picture_of_seed(seed) != expected[seed];
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, 0);
}

// A texture and a list of one context drawn by others while each makes and deletes objects of its own.
TEST(Threads, SharedObjects) {
    const kit::Gl& gl = library().gl;
    const kit::OffscreenContext owner(library(), options());
    GLuint texture = 0;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, kGreen.data());
    const GLuint list = gl.GenLists(1);
    gl.NewList(list, GL_COMPILE);
    gl.Enable(GL_TEXTURE_2D);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.Rectf(-1, -1, 1, 1);
    gl.EndList();
    const OSMesaContext handle = library().osmesa.GetCurrentContext();

    std::atomic<int> wrong = 0;
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&] {
            const kit::OffscreenContext context(library(), options(handle));
            for (int i = 0; i < 100; ++i) {
                GLuint own[2] = {};
                gl.GenTextures(2, own);
                gl.BindTexture(GL_TEXTURE_2D, own[0]);
                gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, kRed.data());
                const GLuint own_list = gl.GenLists(1);
                gl.NewList(own_list, GL_COMPILE);
                gl.CallList(list);
                gl.EndList();
                gl.CallList(own_list);
                gl.Finish();
                wrong += pixel(context, kWidth / 2, kHeight / 2) != kGreen;
                gl.DeleteTextures(2, own);
                gl.DeleteLists(own_list, 1);
            }
            wrong += gl.GetError() != GL_NO_ERROR;
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, 0);
}

// The program that runs this one where it is for another processor; null where nothing does.
const char* emulator() {
    return std::getenv("MESON_EXE_WRAPPER");
}

// The child of fork has none of the parent's threads.
TEST(Process, ForkAfterDrawing) {
    if (emulator()) GTEST_SKIP() << "qemu's user mode cannot fork where there are threads";
    const std::vector<std::uint8_t> expected = picture_of_seed(5);
    for (int round = 0; round < 5; ++round) {
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            alarm(60);  // a child that waits for a thread that is not there
            _exit(picture_of_seed(5) == expected && picture_of_seed(6) != expected ? 0 : 1);
        }
        EXPECT_EQ(picture_of_seed(5), expected);
        int status = 0;
        ASSERT_EQ(waitpid(child, &status, 0), child);
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "status " << status;
    }
}

// Draws queued before fork belong to both.
TEST(Process, ForkInTheMiddleOfAFrame) {
    if (emulator()) GTEST_SKIP() << "qemu's user mode cannot fork where there are threads";
    const kit::OffscreenContext context(library(), options());
    const kit::Gl& gl = library().gl;
    gl.Color3f(0, 1, 0);
    for (int i = 0; i < 200; ++i) gl.Rectf(-1, -1, 1, 1);
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    gl.Finish();
    const bool right = pixel(context, 3, 3) == kGreen;
    if (child == 0) _exit(right ? 0 : 1);
    EXPECT_TRUE(right);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "status " << status;
}

template <class Function>
Function function_of(void* handle, const char* name) {
    return reinterpret_cast<Function>(dlsym(handle, name));
}

// Draws with a library loaded by hand, in a thread of its own: its thread-local destructors run before the
// library goes.
void draw_with(void* handle) {
    const auto create = function_of<decltype(&::OSMesaCreateContext)>(handle, "OSMesaCreateContext");
    const auto make_current = function_of<decltype(&::OSMesaMakeCurrent)>(handle, "OSMesaMakeCurrent");
    const auto destroy = function_of<decltype(&::OSMesaDestroyContext)>(handle, "OSMesaDestroyContext");
    const auto rectf = function_of<decltype(&::glRectf)>(handle, "glRectf");
    const auto finish = function_of<decltype(&::glFinish)>(handle, "glFinish");
    ASSERT_TRUE(create && make_current && destroy && rectf && finish);
    std::vector<std::uint8_t> buffer(kWidth * kHeight * 4);
    const OSMesaContext context = create(OSMESA_RGBA, nullptr);
    ASSERT_TRUE(make_current(context, buffer.data(), GL_UNSIGNED_BYTE, kWidth, kHeight));
    for (int i = 0; i < 100; ++i) rectf(-1, -1, 1, 1);
    finish();
    EXPECT_EQ(buffer[0], 255);
    destroy(context);
}

int threads_of_this_process() {
    const std::filesystem::directory_iterator tasks("/proc/self/task");
    return static_cast<int>(std::distance(begin(tasks), end(tasks)));
}

// A thread that has been joined is listed for a moment longer, until the kernel has taken it down.
bool threads_go_down_to(int count) {
    using namespace std::chrono_literals;
    const auto end = std::chrono::steady_clock::now() + 20s;
    while (threads_of_this_process() > count) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(1ms);
    }
    return true;
}

// Runs in a process of its own: the other tests load the library for good.
TEST(Library, LoadedAndUnloadedAgain) {
    const std::string self = std::filesystem::read_symlink("/proc/self/exe");
    const std::string command = (emulator() ? emulator() + std::string(" ") : "") + "'" + self +
                                "' --gtest_filter=Library.DISABLED_Reload --gtest_also_run_disabled_tests";
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
        _exit(127);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "status " << status;
}

TEST(Library, DISABLED_Reload) {
    std::thread([] {}).join();  // a sanitizer starts a thread of its own beside the first
    const int before = threads_of_this_process();
    const char* const wanted = std::getenv("TERRAZZO_RELOADS");
    const int rounds = wanted ? std::atoi(wanted) : 40;
    for (int round = 0; round < rounds; ++round) {
        void* const handle = dlopen(TERRAZZO_OWN_LIBRARY, RTLD_NOW | RTLD_LOCAL);
        ASSERT_NE(handle, nullptr) << dlerror();
        std::thread(draw_with, handle).join();
        ASSERT_EQ(dlclose(handle), 0);
        ASSERT_EQ(dlopen(TERRAZZO_OWN_LIBRARY, RTLD_NOW | RTLD_NOLOAD), nullptr) << "it stayed loaded";
        ASSERT_TRUE(threads_go_down_to(before)) << "a thread outlived the library";
    }
}

}  // namespace
}  // namespace terrazzo::stress
