// What an OSMesaContext is: a GL context, the client's buffer and how its rows lie.
//
// Threads: a context is current in at most one thread at a time. One that is destroyed while another thread
// has it current lives until that thread lets go of it.
#pragma once

#include <GL/osmesa.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "gl/context.h"

struct osmesa_context;

namespace terrazzo::osmesa {

// The client's buffer as something to draw to.
class ClientBuffer : public gl::Drawable {
  public:
    explicit ClientBuffer(osmesa_context& context);

    // Copies the finished picture to the client's buffer, and depth if the client has asked for it.
    void show_front(gl::Context& ctx) override;

  private:
    osmesa_context& m_context;
};

}  // namespace terrazzo::osmesa

struct osmesa_context {
    std::unique_ptr<terrazzo::gl::Context> gl;
    std::shared_ptr<terrazzo::osmesa::ClientBuffer> drawable;
    int format = 0;  // OSMESA_RGBA ...

    // Set by OSMesaMakeCurrent; `buffer` is null before the first one.
    std::byte* buffer = nullptr;
    GLenum type = 0;
    int width = 0;
    int height = 0;

    int row_length = 0;  // pixels from row to row; 0 stands for `width`
    bool y_up = true;    // the bottom row is the first

    std::vector<std::byte> depth;  // what OSMesaGetDepthBuffer hands out; renewed whenever the picture is

    // Guarded by the mutex of current.cpp.
    int users = 0;  // threads that have the context current
    bool destroyed = false;
};

namespace terrazzo::osmesa {

// Fills `context.depth`. Throws std::bad_alloc, and the client is given nothing that was not there before.
void read_depth(osmesa_context& context);

}  // namespace terrazzo::osmesa
