// Every exported function with null, negative, huge and unknown arguments, without a context, between Begin
// and End: the error that the specification names, the state unchanged, nothing written, and no crash.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>

#include "attach_picture.h"
#include "gl/context.h"
#include "gl/entry.h"
#include "gl/surface.h"
#include "state_dump.h"
#include "valid_calls.h"

namespace terrazzo::test {
namespace {

using gl::Arguments;
using gl::Call;
using testing::IsEmpty;

constexpr std::size_t kBufferBytes = 1 << 18;
constexpr unsigned char kScratchByte = 0xa5;
constexpr int kUnknownEnums[] = {0xdead, -1, 0x7fffffff};

// Zeros to read from: as indices they name the first element, as counts nothing.
std::vector<unsigned char> g_buffer(kBufferBytes);
GLuint g_names[4] = {1, 1, 1, 1};
std::vector<unsigned char> g_scratch(kBufferBytes, kScratchByte);

bool scratch_is_untouched() {
    return std::ranges::count(g_scratch, kScratchByte) == std::ptrdiff_t{kBufferBytes};
}

kit::Gl implemented_commands() {
    kit::Gl table{};
    for (const kit::GlCommand& command : kit::kGlCommands) {
        const auto address = gl::find_proc_address(command.name);
        std::memcpy(reinterpret_cast<char*>(&table) + command.offset, &address, sizeof address);
    }
    return table;
}

class BadInput : public testing::Test {
  protected:
    BadInput() {
        std::ranges::fill(g_scratch, kScratchByte);
        restart();
    }
    ~BadInput() override { gl::make_current(nullptr); }

    // A new context with a small target and the textures that valid_calls.cpp speaks of.
    void restart() {
        gl::make_current(nullptr);
        m_ctx = gl::create_context(gl::Config{.accum_bits = 16}, nullptr);
        gl::attach_picture(*m_ctx, 16, 16);
        gl::make_current(m_ctx.get());
        gl.BindTexture(GL_TEXTURE_2D, g_names[0]);
        gl.BindTexture(GL_TEXTURE_2D, 0);
        gl.TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 4, 0, GL_RGBA, GL_FLOAT, g_buffer.data());
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_FLOAT, g_buffer.data());
        gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 4, 4, 4, 0, GL_RGBA, GL_FLOAT, g_buffer.data());
        gl.CompressedTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 4, 4, 0,
                                16, g_buffer.data());
        ASSERT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
    }

    // What a good call needs that would be in the way of others.
    void prepare(const Call& call) {
        const std::string name = call.name;
        const bool ends = name.starts_with("glEndQuery"), reads = name.starts_with("glGetQueryObject");
        if (ends || reads) gl.BeginQuery(GL_SAMPLES_PASSED, 1);
        if (reads) gl.EndQuery(GL_SAMPLES_PASSED);
        if (name.find("Renderbuffer") != std::string::npos || name.find("Framebuffer") != std::string::npos) {
            gl.BindRenderbuffer(GL_RENDERBUFFER, 1);
            if (name.starts_with("glFramebuffer") || name.starts_with("glGetFramebuffer"))
                gl.BindFramebuffer(GL_FRAMEBUFFER, 1);
            if (name.starts_with("glFramebufferTexture1D")) gl.BindTexture(GL_TEXTURE_1D, 2);
            if (name.starts_with("glFramebufferTexture3D")) gl.BindTexture(GL_TEXTURE_3D, 3);
            return;
        }
        const bool maps = name.starts_with("glUnmapBuffer");
        const bool works_on_a_buffer = maps || name.starts_with("glMapBuffer") ||
                                       name.starts_with("glBuffer") || name.starts_with("glGetBuffer");
        if (!works_on_a_buffer) return;
        gl.BindBuffer(GL_ARRAY_BUFFER, 1);
        gl.BufferData(GL_ARRAY_BUFFER, 64, nullptr, GL_STATIC_DRAW);
        if (maps) gl.MapBuffer(GL_ARRAY_BUFFER, GL_READ_ONLY);
    }

    // Fetches the pending error, between Begin and End too.
    GLenum take_error() { return std::exchange(m_ctx->error.code, GLenum{GL_NO_ERROR}); }

    // Leaves whatever a call may have opened.
    void close() {
        if (m_ctx->vertex.open) gl.End();
        if (m_ctx->lists.compiling) gl.EndList();
    }

    static std::vector<Arguments> good(const Call& call) {
        const auto* valid = valid_arguments(call.name);
        std::vector<Arguments> arguments(std::strlen(call.kinds));
        for (std::size_t i = 0; valid && i < arguments.size(); ++i) {
            const Argument& a = (*valid)[i];
            arguments[i].integer =
                a.kind == Argument::Kind::kReal ? static_cast<long long>(a.real) : a.integer;
            arguments[i].real = a.kind == Argument::Kind::kReal ? a.real : static_cast<double>(a.integer);
            arguments[i].pointer = a.kind == Argument::Kind::kScratch ? static_cast<void*>(g_scratch.data())
                                   : a.kind == Argument::Kind::kNames ? static_cast<void*>(g_names)
                                                                      : g_buffer.data();
        }
        return arguments;
    }

    const kit::Gl gl = implemented_commands();

  private:
    std::unique_ptr<gl::Context> m_ctx;
};

// There are no compressed formats of one or three dimensions.
bool refuses_everything(const Call& call) {
    const std::string name = call.name;
    return name.starts_with("glCompressedTex") && name.find("2D") == std::string::npos;
}

bool can_refuse(const Call& call) {
    return call.implemented && std::strpbrk(call.kinds, "enpq") && !refuses_everything(call);
}

// Pointers that may be null: no image, no array, nothing to draw or to write to.
bool may_be_null(const std::string& name, std::size_t argument) {
    const bool array = name.find("Pointer") != std::string::npos && name.find("Get") == std::string::npos;
    return array || name == "glInterleavedArrays" || name == "glBitmap" || name == "glDrawPixels" ||
           name == "glGetTexImage" || name == "glReadPixels" || name.starts_with("glBufferData") ||
           name.starts_with("glTexImage") || name.starts_with("glCompressedTexImage") ||
           name.starts_with("glTexSubImage") || name.starts_with("glDrawElements") ||
           name.starts_with("glDrawRangeElements") ||
           (name.starts_with("glMultiDrawElements") && argument == 3);
}

TEST_F(BadInput, EveryFunctionThatCanRefuseHasGoodArguments) {
    for (const Call& call : gl::kEveryCall) {
        if (!can_refuse(call)) continue;
        const auto* valid = valid_arguments(call.name);
        ASSERT_NE(valid, nullptr) << call.name;
        ASSERT_EQ(valid->size(), std::strlen(call.kinds)) << call.name;
        prepare(call);
        call.with(good(call).data());
        EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR}) << call.name;
        close();
        restart();
    }
}

bool is_vertex(const Call& call) {
    const std::string name = call.name;
    return (name.starts_with("glVertex") && name.find("Pointer") == std::string::npos) ||
           name.starts_with("glEvalCoord");
}

// An invalid unit's effect is undefined (GL 1.5 §2.7).
bool takes_any_unit(const Call& call) {
    return std::string(call.name).starts_with("glMultiTexCoord");
}

// Without vertices: outside Begin and End they are ignored, whatever their argument.
TEST_F(BadInput, OneBadArgumentIsRefusedAndChangesNothing) {
    const auto expect_refused = [&](const Call& call, const std::vector<Arguments>& bad, std::size_t i,
                                    GLenum error) {
        call.with(bad.data());
        EXPECT_EQ(take_error(), error) << call.name << ", argument " << i << " = " << bad[i].integer;
    };
    for (const Call& call : gl::kEveryCall) {
        if (!can_refuse(call) || is_vertex(call)) continue;
        prepare(call);
        const auto before = dump_state(gl);
        for (std::size_t i = 0; call.kinds[i] != 0; ++i) {
            std::vector<Arguments> bad = good(call);
            bad[i].pointer = nullptr;
            if (call.kinds[i] == 'e') {
                if (takes_any_unit(call)) continue;
                // Internal formats are values, in the one command too that gives them an enumerant's type.
                const bool is_format = call.name == std::string("glTexImage3DEXT") && i == 2;
                for (int value : kUnknownEnums) {
                    bad[i].integer = value;
                    expect_refused(call, bad, i, is_format ? GL_INVALID_VALUE : GL_INVALID_ENUM);
                }
            } else if (call.kinds[i] == 'n') {
                for (int value : {-1, std::numeric_limits<int>::min()}) {
                    bad[i].integer = value;
                    expect_refused(call, bad, i, GL_INVALID_VALUE);
                }
            } else if (call.kinds[i] != 'i' && call.kinds[i] != 'f' && !may_be_null(call.name, i)) {
                expect_refused(call, bad, i, GL_INVALID_VALUE);
            }
        }
        EXPECT_THAT(changed(before, dump_state(gl)), IsEmpty()) << call.name;
        close();
        restart();
    }
    EXPECT_TRUE(scratch_is_untouched());
}

TEST_F(BadInput, BetweenBeginAndEndGoodArgumentsAreRefusedToo) {
    const auto before = dump_state(gl);
    for (const Call& call : gl::kEveryCall) {
        if (!call.implemented || call.inside_begin_end) continue;
        gl.Begin(GL_TRIANGLES);
        call.with(good(call).data());
        EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION}) << call.name;
        gl.End();
        EXPECT_THAT(changed(before, dump_state(gl)), IsEmpty()) << call.name;
    }
    EXPECT_TRUE(scratch_is_untouched());
}

// Arguments for functions that must not look at them.
const Arguments kWorst[] = {{0, 0, nullptr},
                            {-1, -1, nullptr},
                            {0x7fffffff, std::numeric_limits<double>::infinity(), g_scratch.data()},
                            {-0x7fffffff - 1, std::numeric_limits<double>::quiet_NaN(), g_scratch.data()}};

TEST_F(BadInput, WhatIsNotImplementedSaysSoAndChangesNothing) {
    const auto before = dump_state(gl);
    for (const Call& call : gl::kEveryCall) {
        if (call.implemented) continue;
        for (const bool open : {false, true}) {
            if (open) gl.Begin(GL_TRIANGLES);
            for (const Arguments& arguments : kWorst) {
                call.call(arguments);
                EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION}) << call.name;
            }
            close();
        }
    }
    EXPECT_THAT(changed(before, dump_state(gl)), IsEmpty());
    EXPECT_TRUE(scratch_is_untouched());
}

TEST_F(BadInput, WithoutAContextNothingIsDone) {
    gl::make_current(nullptr);
    for (const Call& call : gl::kEveryCall) {
        call.with(good(call).data());
        for (const Arguments& arguments : kWorst) call.call(arguments);
    }
    EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
    EXPECT_EQ(gl.GetString(GL_VERSION), nullptr);
    EXPECT_EQ(gl.GenLists(1), 0u);
    EXPECT_EQ(gl.IsEnabled(GL_DITHER), GL_FALSE);
    EXPECT_TRUE(scratch_is_untouched());
}

// Any mixture of good, bad and extreme arguments. What a call reads stays inside the buffer: elements and
// sizes are small wherever a pointer is not null.
class RandomArguments {
  public:
    explicit RandomArguments(unsigned seed) : m_random(seed) {}

    unsigned pick(unsigned count) { return static_cast<unsigned>(m_random() % count); }

    std::vector<Arguments> of(const Call& call, std::vector<Arguments> arguments) {
        const bool null = pick(4) == 0;
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            arguments[i].pointer = null ? nullptr : call.kinds[i] == 'q' ? g_scratch.data() : g_buffer.data();
            if (pick(3) == 0) arguments[i].integer = integer(call, call.kinds[i], null);
            if (pick(3) == 0) arguments[i].real = real();
        }
        return arguments;
    }

  private:
    long long integer(const Call& call, char kind, bool null) {
        if (kind == 'e') {
            constexpr long long kEnums[] = {0,
                                            1,
                                            3,
                                            GL_FRONT,
                                            GL_TEXTURE_1D,
                                            GL_TEXTURE_2D,
                                            GL_TEXTURE_3D,
                                            GL_TEXTURE_CUBE_MAP_NEGATIVE_Z,
                                            GL_PROXY_TEXTURE_2D,
                                            GL_RGBA,
                                            GL_DEPTH_COMPONENT,
                                            GL_COLOR_INDEX,
                                            GL_UNSIGNED_BYTE,
                                            GL_BITMAP,
                                            GL_FLOAT,
                                            GL_UNSIGNED_INT,
                                            GL_UNSIGNED_SHORT_5_6_5,
                                            GL_COMPILE,
                                            0xdead,
                                            -1};
            return pick(2) ? kEnums[pick(std::size(kEnums))] : static_cast<long long>(pick(0x9000));
        }
        const std::string name = call.name;
        // Elements of arrays that may be set, the strides of maps, and what later calls go by: in the buffer.
        const bool is_map = name.starts_with("glMap1") || name.starts_with("glMap2");
        const bool small = name.find("Draw") != std::string::npos || name.starts_with("glArrayElement") ||
                           name.starts_with("glPixelStore") || name.starts_with("glBufferData") ||
                           ((kind == 'n' || is_map) && !null);
        if (small || pick(3)) return static_cast<long long>(pick(12)) - 3;
        constexpr long long kExtreme[] = {0x7fffffff, -0x7fffffff - 1, 0x10000, 255, -1};
        return kExtreme[pick(std::size(kExtreme))];
    }

    double real() {
        constexpr double kReals[] = {0, -1, 0.5, 1e30, -1e300, std::numeric_limits<double>::infinity()};
        return pick(8) ? kReals[pick(std::size(kReals))] : std::numeric_limits<double>::quiet_NaN();
    }

    std::mt19937 m_random;
};

// A call's arguments are the least of it: it may come between Begin and End or while a list is compiled,
// which is carried out afterwards.
TEST_F(BadInput, AfterAnyErrorTheStateIsWhatItWas) {
    const char* wanted = std::getenv("TERRAZZO_BAD_INPUT_SEEDS");
    const unsigned seeds = wanted ? static_cast<unsigned>(std::atoi(wanted)) : 12;
    constexpr int kCalls = 700;
    constexpr GLuint kList = 5;
    const auto is_error = [](GLenum code) { return code >= GL_INVALID_ENUM && code <= GL_INVALID_FRAMEBUFFER_OPERATION; };
    std::vector<unsigned char> scratch = g_scratch;
    for (unsigned seed = 1; seed <= seeds; ++seed) {
        restart();
        RandomArguments random(seed);
        auto before = dump_state(gl);
        for (int i = 0; i < kCalls; ++i) {
            const Call& call = gl::kEveryCall[random.pick(std::size(gl::kEveryCall))];
            if (!call.implemented) continue;
            SCOPED_TRACE(std::string(call.name) + ", seed " + std::to_string(seed) + ", call " +
                         std::to_string(i));
            const unsigned place = random.pick(8);
            // A frame buffer object that is not complete lets nothing begin.
            if (place == 0) gl.Begin(GL_POINTS);
            const bool begun = place == 0 && take_error() == GL_NO_ERROR;
            if (place == 1) gl.NewList(kList, GL_COMPILE);
            call.with(random.of(call, good(call)).data());
            const GLenum error = take_error();
            close();
            take_error();
            auto after = dump_state(gl);
            if (begun && !call.inside_begin_end) {
                EXPECT_EQ(error, GLenum{GL_INVALID_OPERATION});
            }
            if (error != GL_NO_ERROR) {
                EXPECT_TRUE(is_error(error)) << error;
                EXPECT_THAT(changed(before, after), IsEmpty());
                EXPECT_EQ(std::memcmp(scratch.data(), g_scratch.data(), kBufferBytes), 0);
            }
            if (place == 1) {
                gl.CallList(kList);
                take_error();
                close();
                after = dump_state(gl);
            }
            scratch = g_scratch;
            before = std::move(after);
        }
    }
}

}  // namespace
}  // namespace terrazzo::test
