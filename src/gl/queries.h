// Occlusion queries (GL 1.5 §4.1.7, table 6.33): how many samples of the primitives between BeginQuery and
// EndQuery pass all tests.
//
// Query objects belong to one context. Draws are deferred, so a counter is complete when the frames that hold
// its primitives are drawn: whoever reads a result sees to that.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <cstdint>
#include <memory>
#include <unordered_map>

namespace terrazzo::gl {

// Queued primitives keep it alive; drawing threads add to it.
struct SampleCounter {
    std::uint64_t samples = 0;
};

struct QueryObject {
    GLuint name = 0;
    std::shared_ptr<SampleCounter> counter;  // null before the first BeginQuery
};

struct QueryState {
    // Names that GenQueries returned and no query has begun with map to objects without a counter.
    std::unordered_map<GLuint, std::shared_ptr<QueryObject>> objects;
    GLuint next_name = 1;
    std::shared_ptr<QueryObject> active;  // null outside BeginQuery and EndQuery
};

}  // namespace terrazzo::gl
