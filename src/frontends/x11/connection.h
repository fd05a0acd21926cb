// What we need to know of an X server: its screens' visuals, how their pixels lie in memory, and whether it
// can share memory with us.
#pragma once

#include <xcb/xcb.h>

#include <memory>
#include <optional>
#include <vector>

#include "frontends/x11/image.h"
#include "raster/target/copy_out.h"
#include "raster/target/target.h"

namespace terrazzo::x11 {

// A visual that we can draw for.
struct Visual {
    xcb_visualid_t id = 0;
    std::uint8_t visual_class = 0;  // XCB_VISUAL_CLASS_TRUE_COLOR or _DIRECT_COLOR
    ImageFormat image;
    raster::ColorFormat color = raster::ColorFormat::kRgba8;
    raster::PixelLayout layout = raster::PixelLayout::kBgra8;
    int red_bits = 8, green_bits = 8, blue_bits = 8;
    bool has_alpha = false;  // the server shows or keeps an alpha channel: depth 32
};

struct Screen {
    xcb_window_t root = 0;
    xcb_visualid_t root_visual = 0;
    std::vector<Visual> visuals;  // in the server's order
};

// Shared by those who use it. Constant once it is known, but for its end.
struct Connection {
    xcb_connection_t* xcb = nullptr;
    // Of those who may outlive it; guarded by them (drawable.cpp).
    struct End {
        bool is_closed = false;  // set before it closes: nobody may touch it afterwards
        int being_left = 0;      // by so many at the moment, who are waited for
    };
    mutable End end;
    bool is_own = false;  // ends with this
    bool may_share = false;
    std::vector<Screen> screens;
    // What happens to a program whose server has gone, when it shows a picture; `owner` is the argument. Need
    // not return. Null where the program looks after the connection itself, as xcb's do.
    void (*lost)(void* owner) = nullptr;
    void* owner = nullptr;

    Connection() = default;
    ~Connection();
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    // Whether its server has gone.
    bool is_lost() const { return xcb_connection_has_error(xcb) != 0; }
};

// Asks the server once. The connection must outlive the answer, unless that owns it. Throws std::bad_alloc.
std::shared_ptr<Connection> inspect(xcb_connection_t* connection, bool owns);

// The size of a drawable, and its depth; empty if there is none of that name. Waits for the server.
struct Geometry {
    int width, height, depth;
};
std::optional<Geometry> geometry(xcb_connection_t* connection, xcb_drawable_t drawable);
std::optional<Geometry> geometry_answer(xcb_connection_t* connection, xcb_get_geometry_cookie_t asked);

// The visual of a window, 0 if there is no such window. Waits for the server.
xcb_visualid_t window_visual(xcb_connection_t* connection, xcb_window_t window);

}  // namespace terrazzo::x11
