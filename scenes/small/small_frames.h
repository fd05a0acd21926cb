// Stage: client side, pictures as reinforcement learning has them drawn: small, thousands of them, read back
// one by one. Input: a current context. Output: one frame per draw(), read into the client's memory.
// Invariant: every frame is the same picture; what a frame changes of the state it changes back.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "kit/library.h"

namespace terrazzo::small_frames {

enum class Content : std::uint8_t {
    kEmpty,     // a clear
    kTriangle,  // a clear and a triangle
    kObjects,   // fifty lit display lists, each with a matrix and a material, some textured
    kShadows,   // ten of them, drawn to a shadow map of 4096x4096 first
};

enum class Readout : std::uint8_t { kRgba, kRgb, kDepth };

// Where a frame is drawn to before it is read.
enum class Place : std::uint8_t {
    kWindow,   // the client's buffer
    kObject,   // a frame buffer object
    kSamples,  // one of four samples, whose mean another takes over
};

struct Description {
    Content content = Content::kEmpty;
    int size = 64;
    Readout readout = Readout::kRgba;
    Place place = Place::kWindow;

    // "objects/64/rgb/samples"
    std::string name() const;
    // Throws std::runtime_error where that is no name.
    static Description parse(const std::string& name);
};

// What `terrazzo bench small` draws.
std::vector<Description> descriptions();

class Frames {
  public:
    // The window must be of the description's size.
    Frames(const kit::Gl& gl, const Description& description);
    void draw();
    // What the last frame has read.
    const std::vector<std::uint8_t>& picture() const { return m_picture; }

  private:
    GLuint make_object(int samples) const;
    void prepare_objects();
    void prepare_shadows();
    void draw_objects(int count) const;
    void draw_shadow_map() const;
    void draw_content() const;
    void read();

    const kit::Gl& m_gl;
    Description m_description;
    GLuint m_object = 0, m_resolved = 0, m_shadow_object = 0, m_shadow_map = 0;
    GLuint m_lists = 0;
    std::array<GLuint, 2> m_textures{};
    std::vector<std::uint8_t> m_picture;
};

}  // namespace terrazzo::small_frames
