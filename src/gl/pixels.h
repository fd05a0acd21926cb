// Pixel state (GL 1.5 §3.6.1-3.6.3, §3.6.5; tables 6.22-6.24): how client memory is laid out, what happens to
// pixels on their way between client, textures and frame buffer, and the zoom of pixel rectangles.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <memory>

#include "gl/limits.h"

namespace terrazzo::gl {

struct BufferObject;

// GL 1.5 table 3.1. The default is what commands take their pixels from when a display list replays them.
struct PixelStore {
    bool swap_bytes = false;
    bool lsb_first = false;
    GLint row_length = 0;  // 0: the width of the image
    GLint image_height = 0;
    GLint skip_rows = 0;
    GLint skip_pixels = 0;
    GLint skip_images = 0;
    GLint alignment = 4;
    std::shared_ptr<BufferObject> buffer;  // where the pixels are; null: in the client's memory
};

// GL 1.5 table 3.2.
struct PixelTransfer {
    bool map_color = false;
    bool map_stencil = false;
    GLint index_shift = 0;
    GLint index_offset = 0;
    std::array<GLfloat, 4> scale{1, 1, 1, 1};
    std::array<GLfloat, 4> bias{};
    GLfloat depth_scale = 1;
    GLfloat depth_bias = 0;
};

// GL 1.5 table 3.3. Indices and colours alike are kept as floats; colours are clamped to 0..1.
struct PixelMap {
    GLsizei size = 1;
    std::array<GLfloat, kMaxPixelMapTable> values{};
};

// In the order of the enumerants from GL_PIXEL_MAP_I_TO_I on.
enum PixelMapIndex : int {
    kMapIToI,
    kMapSToS,
    kMapIToR,
    kMapIToG,
    kMapIToB,
    kMapIToA,
    kMapRToR,
    kMapGToG,
    kMapBToB,
    kMapAToA,
    kPixelMapCount
};

// The part that glPushAttrib(GL_PIXEL_MODE_BIT) saves (beside the read buffer).
struct PixelMode {
    PixelTransfer transfer;
    GLfloat zoom_x = 1;
    GLfloat zoom_y = 1;
};

struct PixelState {
    // The part that glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT) saves.
    PixelStore pack;
    PixelStore unpack;

    PixelMode mode;
    std::array<PixelMap, kPixelMapCount> maps;
};

}  // namespace terrazzo::gl
