// A context in which every command has something to work on, and all that a command did there: state, error,
// pixels, feedback. Two runs from the same seed give the same outcome, whatever else is different between
// them.
#pragma once

#include <string>
#include <vector>

#include "kit/offscreen.h"
#include "random_arguments.h"
#include "state_dump.h"

namespace terrazzo::test {

struct Outcome {
    std::vector<std::string> state;
    std::vector<std::uint8_t> color;
    std::vector<std::uint32_t> depth;
    std::vector<std::uint8_t> stencil;
    std::vector<GLfloat> feedback;
    std::vector<GLenum> errors;
};

// "" where both are equal, else what differs; `other` is the name of the second.
std::string difference(const Outcome& one, const Outcome& other);

class Trial {
  public:
    static constexpr int kSize = 32;

    // Textures, lists 50 to 53, arrays, maps, a raster position, noise in all buffers, some capabilities on.
    Trial(const kit::Library& library, unsigned seed);

    Outcome outcome();

    // Geometry that shows lighting, texturing, fog, offsets, stipples, points, lines, bitmaps and pixel
    // rectangles.
    void draw();
    // A few triangles that the next ones join, where nothing comes in between.
    void draw_triangles();
    // Primitives outside of the clip volume: everything is made ready for a draw, and no pixel changes.
    void draw_nothing();

    void start_feedback();

    const kit::Gl& gl;
    RandomArguments arguments;

  private:
    void fill_buffers();
    void make_textures();
    void make_lists();
    void set_arrays();
    void set_evaluators();
    void set_capabilities();

    kit::OffscreenContext m_context;
    std::vector<GLfloat> m_positions, m_normals, m_colors, m_coordinates;
    std::vector<GLfloat> m_feedback;
};

}  // namespace terrazzo::test
