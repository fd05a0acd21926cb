// The pieces of a large draw on all threads: each is shaded, assembled, set up and sorted into bins by one of
// them, with vertices, memory and bin lists of its own; the lists come to the frame's in the pieces' order.
//
// Input: a draw of several pieces. Output: the frame's lists are what one thread would have made of them, and
// no thread reads the draw's vertices any more. What is drawn does not depend on how many threads there are.
#pragma once

#include <memory>
#include <vector>

#include "pipeline/geometry/assemble/assemble.h"
#include "pipeline/geometry/assemble/pieces.h"
#include "pipeline/geometry/draw_state.h"
#include "pipeline/geometry/vertex_input.h"
#include "pipeline/schedule/frame.h"

namespace terrazzo::pipeline {

class ParallelDraw {
  public:
    // Whether the threads would be done before one alone.
    bool is_worthwhile(const DrawState& state, const Pieces& pieces) const;
    // For tests: how many primitives there have to be beyond the first piece, at least 1.
    void set_worth_waking(uint32_t primitives) { m_worth_waking = primitives; }

    // Draws pieces from the first on and returns how many, which may be none: where memory is missing the
    // others are left to the caller, which has less need of it. Draws the frame early whenever it has grown
    // full. `own` is for the calling thread.
    uint32_t draw(Frame& frame, PieceVertices& own, const DrawState& state, const VertexInput& input,
                  const Pieces& pieces);

  private:
    // What a thread needs of its own.
    struct Thread {
        explicit Thread(Frame& frame) : lists(frame.blocks()) {}

        PieceVertices vertices;
        BinLists lists;
    };
    // Pieces that are drawn before their lists come to the frame's.
    struct Wave;

    bool prepare(Frame& frame, uint32_t pieces);
    void work(Wave& wave, int thread) noexcept;

    // A thread that sleeps takes as long to wake up as some of these take to be set up.
    uint32_t m_worth_waking = 512;
    std::vector<std::unique_ptr<Thread>> m_threads;
    std::vector<BinLists::Part> m_parts;  // one a piece of a wave
};

}  // namespace terrazzo::pipeline
