// See exhaust.h. Every test is a run of its own, in contexts of its own.
#include "exhaust.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "failing_memory.h"
#include "kit/offscreen.h"
#include "state_dump.h"

namespace terrazzo::test {

bool GuardedBuffer::is_intact() const {
    return std::all_of(m_bytes.begin() + static_cast<std::ptrdiff_t>(m_size), m_bytes.end(),
                       [](std::uint8_t byte) { return byte == kPattern; });
}

void Exhaustion::begin(Run& run) const {
    run.context = run.osmesa.CreateContextExt(OSMESA_RGBA, 24, 8, 16, nullptr);
    ASSERT_NE(run.context, nullptr);
    ASSERT_TRUE(run.osmesa.MakeCurrent(run.context, run.picture.data(), m_program.type, kWidth, kHeight));
}

void Exhaustion::run(Run& run, std::size_t first, std::size_t end) const {
    for (std::size_t i = first; i < end; ++i) {
        m_program.commands[i].run(run);
        ASSERT_EQ(run.gl.GetError(), GLenum{GL_NO_ERROR}) << m_program.commands[i].name;
        ASSERT_FALSE(run.refused) << m_program.commands[i].name;
    }
}

Exhaustion::Ending Exhaustion::end(Run& run) const {
    const kit::Gl& gl = run.gl;
    Ending ending;
    if (run.osmesa.GetCurrentContext()) {
        gl.Finish();
        gl.PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
        gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
        GLint width = 0, height = 0;
        run.osmesa.GetIntegerv(OSMESA_WIDTH, &width);
        run.osmesa.GetIntegerv(OSMESA_HEIGHT, &height);
        const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
        ending.depth.resize(pixels);
        ending.stencil.resize(pixels);
        gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
        gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
        gl.ReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, ending.depth.data());
        GLint bits = 0;
        gl.GetIntegerv(GL_STENCIL_BITS, &bits);
        if (bits != 0)
            gl.ReadPixels(0, 0, width, height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, ending.stencil.data());
        gl.PopClientAttrib();
        EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
    }
    ending.picture = run.picture.picture();
    ending.large = run.large.picture();
    EXPECT_TRUE(run.picture.is_intact());
    EXPECT_TRUE(run.large.is_intact());
    if (run.huge) {
        EXPECT_TRUE(run.huge->is_intact());
        ending.huge = run.huge->picture();
    }
    ending.results = run.results;
    if (run.other) run.osmesa.DestroyContext(run.other);
    run.osmesa.DestroyContext(run.context);
    run.other = run.context = nullptr;
    return ending;
}

Exhaustion::Exhaustion(const kit::Library& library, const Program& program)
    : m_library(library), m_program(program), m_states(program.commands.size() + 1) {
    for (int round = 0; round < 2; ++round) {  // the first fills what the library keeps for good
        Run now(library, program.type);
        begin(now);
        m_allocations.clear();
        for (std::size_t i = 0; i < program.commands.size(); ++i) {
            count_allocations();
            run(now, i, i + 1);
            m_allocations.push_back(stop_failing().asked);
        }
        m_ending = end(now);
    }
    // Two pictures of nothing would always be equal.
    const auto varies = [](const auto& values) {
        return std::adjacent_find(values.begin(), values.end(), std::not_equal_to<>()) != values.end();
    };
    EXPECT_TRUE(varies(m_ending.picture) || varies(m_ending.large) || varies(m_ending.huge))
        << program.name << " draws nothing";
}

const std::vector<std::string>& Exhaustion::state_before(std::size_t command) {
    std::vector<std::string>& state = m_states[command];
    if (!state.empty()) return state;
    Run now(m_library, m_program.type);
    begin(now);
    run(now, 0, command);
    state = dump_with_objects(now.gl);
    end(now);
    return state;
}

bool Exhaustion::test(const Shortage& shortage) {
    const Command& command = m_program.commands[shortage.command];
    SCOPED_TRACE(m_program.name + ": " + command.name + ", allocation " + std::to_string(shortage.number) +
                 (shortage.for_good ? " and all behind it" : ""));
    // Runs of their own, before this one.
    const std::vector<std::string>&before = state_before(shortage.command),
          &after = state_before(shortage.command + 1);
    Run now(m_library, m_program.type);
    begin(now);
    run(now, 0, shortage.command);
    fail_allocations(shortage.number, shortage.for_good ? kAllBehind : 1);
    command.run(now);
    const bool ran_out = stop_failing().failed != 0;
    const GLenum error = now.gl.GetError();
    EXPECT_TRUE(error == GL_NO_ERROR || error == GL_OUT_OF_MEMORY) << kit::error_name(error);
    EXPECT_EQ(now.gl.GetError(), GLenum{GL_NO_ERROR});
    const bool has_failed = error != GL_NO_ERROR || now.refused;
    EXPECT_TRUE(ran_out || !has_failed) << "without need";
    // What has gone without is as it was, and works the next time.
    if (has_failed) {
        if (!command.is_block) {
            EXPECT_EQ(changed(before, dump_with_objects(now.gl)), std::vector<std::string>());
        }
        now.refused = false;
        run(now, shortage.command, shortage.command + 1);
    }
    EXPECT_EQ(changed(after, dump_with_objects(now.gl)), std::vector<std::string>());
    run(now, shortage.command + 1, m_program.commands.size());
    const Ending ending = end(now);
    EXPECT_TRUE(ending.picture == m_ending.picture) << "another picture";
    EXPECT_TRUE(ending.large == m_ending.large) << "another large picture";
    EXPECT_TRUE(ending.huge == m_ending.huge) << "another huge picture";
    EXPECT_TRUE(ending.depth == m_ending.depth) << "other depths";
    EXPECT_TRUE(ending.stencil == m_ending.stencil) << "other stencil values";
    EXPECT_EQ(ending.results, m_ending.results);
    return ran_out;
}

}  // namespace terrazzo::test
