// See connection.h.
#include "frontends/x11/connection.h"

#include <xcb/shm.h>

#include <bit>

#include "frontends/x11/reply.h"
#include "simd/environment.h"

namespace terrazzo::x11 {
namespace {

std::optional<ImageFormat> image_format(const xcb_setup_t* setup, std::uint8_t depth) {
    for (auto it = xcb_setup_pixmap_formats_iterator(setup); it.rem; xcb_format_next(&it)) {
        if (it.data->depth == depth)
            return ImageFormat{depth, it.data->bits_per_pixel, it.data->scanline_pad};
    }
    return {};
}

// Empty for what we do not draw: palettes, grey scales, ten bits a component.
std::optional<Visual> describe(const xcb_visualtype_t& visual, const ImageFormat& image) {
    if (visual._class != XCB_VISUAL_CLASS_TRUE_COLOR && visual._class != XCB_VISUAL_CLASS_DIRECT_COLOR)
        return {};
    Visual out;
    out.id = visual.visual_id;
    out.visual_class = visual._class;
    out.image = image;
    const auto masks = [&](std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
        return visual.red_mask == red && visual.green_mask == green && visual.blue_mask == blue;
    };
    if (image.bits_per_pixel == 32 && masks(0xff0000, 0xff00, 0xff)) {
        out.layout = raster::PixelLayout::kBgra8;
    } else if (image.bits_per_pixel == 32 && masks(0xff, 0xff00, 0xff0000)) {
        out.layout = raster::PixelLayout::kRgba8;
    } else if (image.bits_per_pixel == 16 && masks(0xf800, 0x7e0, 0x1f)) {
        out.layout = raster::PixelLayout::kRgb565;
        out.color = raster::ColorFormat::kRgb565;
        out.red_bits = out.blue_bits = 5;
        out.green_bits = 6;
    } else {
        return {};
    }
    out.has_alpha = image.depth == 32;
    return out;
}

}  // namespace

Connection::~Connection() {
    if (is_own) xcb_disconnect(xcb);
}

std::shared_ptr<Connection> inspect(xcb_connection_t* connection, bool owns) {
    auto made = std::make_shared<Connection>();
    Connection& out = *made;
    out.xcb = connection;
    out.is_own = owns;
    if (out.is_lost()) return made;
    const xcb_setup_t* setup = xcb_get_setup(connection);
    // Layouts are in the order of our addresses: a server of the other order would need its bytes swapped.
    const bool little = std::endian::native == std::endian::little;
    if ((setup->image_byte_order == XCB_IMAGE_ORDER_LSB_FIRST) != little) return made;
    const xcb_query_extension_reply_t* shm = xcb_get_extension_data(connection, &xcb_shm_id);
    out.may_share = shm && shm->present && !setting("TERRAZZO_NO_SHM");
    for (auto screen = xcb_setup_roots_iterator(setup); screen.rem; xcb_screen_next(&screen)) {
        Screen& to = out.screens.emplace_back();
        to.root = screen.data->root;
        to.root_visual = screen.data->root_visual;
        for (auto depth = xcb_screen_allowed_depths_iterator(screen.data); depth.rem;
             xcb_depth_next(&depth)) {
            const auto image = image_format(setup, depth.data->depth);
            if (!image) continue;
            for (auto visual = xcb_depth_visuals_iterator(depth.data); visual.rem;
                 xcb_visualtype_next(&visual)) {
                if (const auto known = describe(*visual.data, *image)) to.visuals.push_back(*known);
            }
        }
    }
    return made;
}

std::optional<Geometry> geometry(xcb_connection_t* connection, xcb_drawable_t drawable) {
    return geometry_answer(connection, xcb_get_geometry(connection, drawable));
}

std::optional<Geometry> geometry_answer(xcb_connection_t* connection, xcb_get_geometry_cookie_t asked) {
    const Reply<xcb_get_geometry_reply_t> reply(xcb_get_geometry_reply(connection, asked, nullptr));
    if (!reply) return {};
    return Geometry{reply->width, reply->height, reply->depth};
}

xcb_visualid_t window_visual(xcb_connection_t* connection, xcb_window_t window) {
    const Reply<xcb_get_window_attributes_reply_t> reply(
        xcb_get_window_attributes_reply(connection, xcb_get_window_attributes(connection, window), nullptr));
    return reply ? reply->visual : 0;
}

}  // namespace terrazzo::x11
