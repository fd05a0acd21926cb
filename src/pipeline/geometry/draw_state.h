// What a draw goes through, from its vertices to its pixels, as plain data: made by src/gl/validate.cpp, the
// same for all of a draw's vertices, which vertex_input.h describes.
#pragma once

#include <cstdint>
#include <memory>

#include "pipeline/geometry/vertex_state.h"
#include "pipeline/schedule/fragment_block.h"

namespace terrazzo::pipeline {

enum class FillMode : uint8_t { kFill, kLine, kPoint };

// How primitives of all kinds become fragments (GL 1.5 chapter 3).
struct RasterState {
    int32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // scissor within the target, in raster rows; x1 and y1 exclusive
    bool row0_is_top = true;
    bool multisample = false;  // as FragmentState's
    bool flat = false;
    bool cull_front = false, cull_back = false;
    bool front_is_clockwise = false;
    FillMode fill[2] = {FillMode::kFill, FillMode::kFill};  // front, back
    bool offset_fill = false, offset_line = false, offset_point = false;
    float offset_factor = 0;
    float offset_units = 0;  // in depth: already times twice the smallest step of the format
    bool polygon_stipple = false;
    float line_width = 1;
    bool line_smooth = false;
    bool line_stipple = false;
    int line_stipple_factor = 1;
    uint16_t line_stipple_pattern = 0xffff;
    float point_size = 1;
    bool point_smooth = false;
    bool point_sprite = false;  // squares of any size, not of whole pixels
    uint8_t sprite_units = 0;   // one bit for each unit whose coordinates span such a square
};

// All that a draw needs besides its vertices.
struct DrawState {
    VertexState vertex;
    RasterState raster;
    std::shared_ptr<const FragmentBlock> fragment;
};

}  // namespace terrazzo::pipeline
