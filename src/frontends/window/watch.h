// What `terrazzo run` is told of a program's frames: pictures and times, through a socket whose path
// TERRAZZO_WATCH names.
//
// Without that variable a frame costs one test. A watcher that goes away is forgotten, and so is one that reads
// nothing for three seconds; the program waits for it no longer, and never hears of it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace terrazzo::window {

// What comes through the socket for each frame, followed by `picture_bytes` bytes: rows from the top, 4 bytes
// a pixel, red first, or none if the watcher wants no pictures. Same machine, same byte order.
struct WatchedFrame {
    static constexpr std::uint32_t kMagic = 0x315a5254;  // "TRZ1"

    std::uint32_t magic = kMagic;
    std::uint32_t process = 0;
    std::uint32_t width = 0, height = 0;
    std::uint64_t picture_bytes = 0;
    // Since the frame before.
    std::uint64_t primitives = 0;   // set up for drawing
    std::uint64_t pixels = 0;       // their fragments that passed all tests
    std::uint64_t nanoseconds = 0;  // altogether
    std::uint64_t vertex_nanoseconds = 0;
    std::uint64_t pixel_nanoseconds = 0;  // drawing bins; with the copy to the window
    std::uint64_t show_nanoseconds = 0;   // waiting for and talking to the window system
};

// Whether anybody watches, and wants pictures (TERRAZZO_WATCH_PICTURES is set).
bool is_watched();
bool wants_pictures();

// Sends a frame. `rows` is null or `height` rows of `width` pixels as above. Completes the header's process,
// counts and times itself, all but `show_nanoseconds`. Threads: any.
void watch_frame(int width, int height, std::uint64_t show_nanoseconds, const std::byte* rows);

}  // namespace terrazzo::window
