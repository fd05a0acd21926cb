// What a program gets through with Terrazzo though little is left to it: small stacks, floating-point traps,
// no threads, no memory. Each in a process of its own, which draws what a process without such troubles
// draws.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cfenv>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "kit/offscreen.h"
#include "random_draws.h"

namespace {

bool threads_fail = false;
int refused_threads = 0;

}  // namespace

// The library's call comes here: the program's definitions are everybody's.
extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*start)(void*),
                              void* argument) {
    static const auto next = reinterpret_cast<decltype(&pthread_create)>(dlsym(RTLD_NEXT, "pthread_create"));
    if (!threads_fail) return next(thread, attributes, start, argument);
    ++refused_threads;
    return EAGAIN;
}

namespace terrazzo::survival {
namespace {

constexpr int kSize = 160;
constexpr std::uint64_t kSeeds = 6;

const kit::Library& library() {
    static const kit::Library own(TERRAZZO_OWN_LIBRARY);
    return own;
}

using Bytes = std::vector<std::uint8_t>;

Bytes picture_of_seed(std::uint64_t seed) {
    const kit::OffscreenContext context(library(), {.width = kSize, .height = kSize});
    stress::draw_random(library().gl, seed, kSize, kSize);
    const auto picture = context.colour_buffer();
    return {picture.begin(), picture.end()};
}

std::vector<Bytes> pictures() {
    std::vector<Bytes> out;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) out.push_back(picture_of_seed(seed));
    return out;
}

// Those that nothing stands in the way of, drawn in a child: this process is to have no pool of threads.
const std::vector<Bytes>& expected_pictures() {
    static const std::vector<Bytes> expected = [] {
        int ends[2];
        if (pipe(ends) != 0) std::abort();
        if (fork() == 0) {
            for (const Bytes& picture : pictures())
                if (write(ends[1], picture.data(), picture.size()) != static_cast<ssize_t>(picture.size()))
                    _exit(1);
            _exit(0);
        }
        close(ends[1]);
        std::vector<Bytes> out(kSeeds, Bytes(kSize * kSize * 4));
        for (Bytes& picture : out) {
            for (std::size_t at = 0; at < picture.size();) {
                const ssize_t got = read(ends[0], picture.data() + at, picture.size() - at);
                if (got <= 0) std::abort();
                at += static_cast<std::size_t>(got);
            }
        }
        close(ends[0]);
        wait(nullptr);
        return out;
    }();
    return expected;
}

// Whether `body` says so in a process of its own.
void expect_in_child(const std::function<bool()>& body, const std::string& what) {
    expected_pictures();  // drawn without what `body` is about to bring
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        alarm(200);
        _exit(body() ? 0 : 1);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0)
        << what << (WIFSIGNALED(status) ? ": signal " : ": status ")
        << (WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status));
}

// Coordinates that arithmetic stumbles over.
void draw_odd_numbers() {
    const kit::Gl& gl = library().gl;
    const float infinity = std::numeric_limits<float>::infinity(),
                none = std::numeric_limits<float>::quiet_NaN(), huge = std::numeric_limits<float>::max(),
                tiny = std::numeric_limits<float>::denorm_min();
    const float odd[] = {0, -0.0f, 1, huge, -huge, tiny, infinity, -infinity, none};
    gl.Enable(GL_LIGHTING), gl.Enable(GL_LIGHT0), gl.Enable(GL_NORMALIZE), gl.Enable(GL_FOG),
        gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_TEXTURE_GEN_S), gl.Enable(GL_TEXTURE_2D);
    gl.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 30), gl.Lightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 1);
    gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
    const GLubyte texel[] = {255, 128, 0, 255};
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    for (const GLenum mode : {GL_POINTS, GL_LINES, GL_TRIANGLES, GL_QUAD_STRIP, GL_POLYGON}) {
        gl.Begin(mode);
        for (const float x : odd) {
            for (const float w : odd) {
                gl.Normal3f(x, w, 0), gl.TexCoord4f(x, 1, 0, w), gl.Color4f(w, x, 1, 1), gl.FogCoordf(x);
                gl.Vertex4f(x, 0.5f, w, w);
                gl.Vertex4f(0.25f, x, 0, w);
            }
        }
        gl.End();
    }
    gl.RasterPos4f(huge, 1, 1, tiny);
    gl.PixelZoom(huge, tiny);
    gl.DrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    gl.MultMatrixf(std::vector<float>(16, 0.0f).data());
    gl.Rectf(-1, -1, 1, 1);
    gl.PushMatrix();
    gl.Scalef(huge, huge, huge), gl.Scalef(huge, huge, huge);
    gl.Rectf(-1, -1, 1, 1);
    gl.PopMatrix();
    gl.Finish();
}

TEST(Survival, FloatingPointTraps) {
    expect_in_child(
        [] {
            std::feclearexcept(FE_ALL_EXCEPT);
            feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
            bool same = pictures() == expected_pictures();
            const kit::OffscreenContext context(library(), {.width = kSize, .height = kSize});
            draw_odd_numbers();
            // They are the program's, and stay as it has them.
            same &= fegetexcept() == (FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
            return same;
        },
        "with traps");
}

TEST(Survival, ASmallStack) {
    expect_in_child(
        [] {
            bool same = true;
            struct Work {
                std::uint64_t seed;
                bool* same;
            };
            for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
                pthread_attr_t attributes;
                pthread_attr_init(&attributes);
                if (pthread_attr_setstacksize(&attributes, 32 << 10) != 0) return false;
                Work work{seed, &same};
                pthread_t thread;
                const auto draw = [](void* argument) -> void* {
                    const auto* const given = static_cast<const Work*>(argument);
                    *given->same &= picture_of_seed(given->seed) == expected_pictures()[given->seed];
                    return nullptr;
                };
                if (pthread_create(&thread, &attributes, draw, &work) != 0) return false;
                pthread_join(thread, nullptr);
                pthread_attr_destroy(&attributes);
            }
            return same;
        },
        "on 32 KiB of stack");
}

TEST(Survival, NoThreads) {
    expect_in_child(
        [] {
            threads_fail = true;
            return pictures() == expected_pictures() && refused_threads > 0;
        },
        "without threads");
}

std::size_t address_space() {
    std::ifstream file("/proc/self/statm");
    std::size_t pages = 0;
    file >> pages;
    return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

// A large picture with a large texture, or an error that says that there is no memory for it.
bool draws_or_says_so() {
    constexpr int kLarge = 1024;
    try {
        const kit::Gl& gl = library().gl;
        const kit::OffscreenContext context(library(), {.width = kLarge, .height = kLarge});
        const Bytes texels(std::size_t{kLarge} * kLarge * 4, 200);
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, kLarge, kLarge, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl.Enable(GL_TEXTURE_2D);
        gl.Clear(GL_COLOR_BUFFER_BIT);
        gl.Rectf(-1, -1, 1, 1);
        gl.Finish();
        const auto picture = context.colour_buffer();
        const bool is_drawn = picture[0] == 200 && picture[picture.size() - 1] == 200;
        bool told = false;
        for (const GLenum error : context.take_errors()) {
            if (error != GL_OUT_OF_MEMORY) return false;
            told = true;
        }
        return is_drawn || told;
    } catch (const std::exception&) {
        return true;  // no context, or the program itself has no memory
    }
}

TEST(Survival, LittleAddressSpace) {
    constexpr std::size_t kStep = 2 << 20;
    for (std::size_t more = 0; more < 48 * kStep; more += kStep) {
        expect_in_child(
            [=] {
                library();
                const rlimit limit{address_space() + more, RLIM_INFINITY};
                if (setrlimit(RLIMIT_AS, &limit) != 0) return false;
                if (!draws_or_says_so()) return false;
                // With memory again all is well.
                const rlimit none{RLIM_INFINITY, RLIM_INFINITY};
                return setrlimit(RLIMIT_AS, &none) == 0 && picture_of_seed(1) == expected_pictures()[1];
            },
            std::to_string(more >> 20) + " MB");
    }
}

}  // namespace
}  // namespace terrazzo::survival
