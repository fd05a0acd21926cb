// Large draws on all threads; see parallel_draw.h.
#include "pipeline/geometry/parallel_draw.h"

#include <algorithm>
#include <atomic>
#include <new>

#include "pipeline/schedule/float_environment.h"
#include "pipeline/schedule/workers.h"

namespace terrazzo::pipeline {

namespace {

// The pieces whose lists wait: more of them would keep threads from waiting for the slowest one less often,
// but their lists are long.
constexpr uint32_t kPiecesOfWave = 64;
}  // namespace

struct ParallelDraw::Wave {
    Frame& frame;
    PieceVertices& own;
    const DrawState& state;
    const VertexInput& input;
    const Pieces& pieces;
    const uint32_t first, count;
    std::atomic<uint32_t> next = 0;     // counted from `first`, as pieces are taken
    std::atomic<bool> is_over = false;  // no more pieces are to be taken
    std::atomic<uint32_t> first_failed = UINT32_MAX;

    void fail(uint32_t piece) {
        is_over = true;
        for (uint32_t before = first_failed; piece < before;)
            if (first_failed.compare_exchange_weak(before, piece)) return;
    }
    // Those that are all drawn. What was taken was taken in order.
    uint32_t drawn() const { return std::min({count, next.load(), first_failed.load()}); }
};

bool ParallelDraw::is_worthwhile(const DrawState& state, const Pieces& pieces) const {
    // A stipple runs on from line to line.
    return pieces.primitives_beyond_first() >= m_worth_waking && !state.raster.line_stipple &&
           thread_count() > 1;
}

// False where there is no memory.
bool ParallelDraw::prepare(Frame& frame, uint32_t pieces) try {
    // Any of the threads may come.
    while (m_threads.size() < static_cast<size_t>(thread_count()))
        m_threads.push_back(std::make_unique<Thread>(frame));
    const size_t parts = std::min(pieces, kPiecesOfWave);
    if (m_parts.size() < parts) m_parts.resize(parts);
    return true;
} catch (const std::bad_alloc&) {
    return false;
}

uint32_t ParallelDraw::draw(Frame& frame, PieceVertices& own, const DrawState& state,
                            const VertexInput& input, const Pieces& pieces) {
    if (!prepare(frame, pieces.count())) return 0;
    uint32_t drawn = 0;
    while (drawn < pieces.count()) {
        if (frame.full()) frame.draw();
        frame.keep(state.fragment);
        Wave wave{frame, own, state, input, pieces, drawn, std::min(pieces.count() - drawn, kPiecesOfWave)};
        const Arena::Mark before = frame.lists().arena().mark();
        run_parallel(static_cast<int>(std::min<size_t>(m_threads.size(), wave.count)),
                     [&](int, int thread) { work(wave, thread); });
        for (uint32_t i = 0; i < wave.drawn(); ++i) frame.lists().append(m_parts[i]);
        for (const auto& thread : m_threads) {
            if (wave.drawn() != 0) frame.lists().arena().take_rest(thread->lists.arena());
            thread->lists.clear();
        }
        drawn += wave.drawn();
        if (wave.drawn() == 0) frame.lists().arena().rewind(before);
        if (wave.drawn() == 0 || wave.first_failed != UINT32_MAX) break;
    }
    return drawn;
}

void ParallelDraw::work(Wave& wave, int number) noexcept {
    if (wave.next.load(std::memory_order_relaxed) >= wave.count) return;
    const FloatEnvironment environment;
    Thread& thread = *m_threads[static_cast<size_t>(number)];
    uint32_t stipple_counter = 0;  // of lines that have none
    uint32_t piece = UINT32_MAX;   // none yet: without this thread the others go on
    try {
        thread.lists.take_grid_of(wave.frame.lists());
        PrimitiveAssembler assembler(thread.lists, number == 0 ? wave.own : thread.vertices, stipple_counter,
                                     wave.state, wave.input);
        while (!wave.is_over && (piece = wave.next.fetch_add(1)) < wave.count) {
            assembler.draw(wave.pieces[wave.first + piece]);
            thread.lists.cut(m_parts[piece]);
            // Of each wave at least one piece is drawn.
            if (wave.frame.full()) wave.is_over = true;
        }
    } catch (const std::bad_alloc&) {
        if (piece != UINT32_MAX) wave.fail(piece);
    }
}

}  // namespace terrazzo::pipeline
