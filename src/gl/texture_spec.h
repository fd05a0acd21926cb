// Checks that the commands defining texture images share (GL 1.5 §3.8.1-3.8.3), and the writing of client
// rows into an image.
#pragma once

#include <GL/gl.h>

#include "gl/client_pixel.h"
#include "gl/texture.h"

namespace terrazzo::gl {

// What a command says about a level. Sizes that its dimensions do not have are 1, without a border.
struct LevelSpec {
    GLint level;
    GLint internal_format;
    GLsizei width;  // with border
    GLsizei height;
    GLsizei depth;
    GLint border;
    int dimensions;

    GLint border_y() const { return dimensions > 1 ? border : 0; }
    GLint border_z() const { return dimensions > 2 ? border : 0; }
};

// A box of a level, relative to its interior: from -border on.
struct LevelBox {
    GLint x, y, z;
    GLsizei width, height, depth;

    bool is_empty() const { return width == 0 || height == 0 || depth == 0; }
};

bool is_level(GLint level);

// Level, sizes and border that are wrong whatever the implementation can do.
Rule check_level_spec(const LevelSpec& spec, bool is_cube);

// Whether an image of this size can be made at this level; if not, GL_INVALID_VALUE, or an empty proxy.
bool is_supported_size(const LevelSpec& spec, bool is_cube);

// Whether the memory for one image is within bounds; if not, GL_OUT_OF_MEMORY, or an empty proxy.
bool is_supported_memory(const LevelSpec& spec, const TexelFormat& format);

// Whether `format` and `type` can describe texels.
Rule check_texture_pixels(GLenum format, GLenum type);

// Whether pixels of `client_format` can become or be made of texels of `format`: depths of depths, colours of
// colours.
Rule check_pixels_fit(GLenum client_format, const TexelFormat& format);

// EXT_texture_compression_s3tc: what TexImage and CopyTexImage may ask for.
Rule check_compression(const LevelSpec& spec);
// ... and which parts of a compressed level TexSubImage and CopyTexSubImage may replace: whole blocks.
Rule check_blocks(const TextureLevel& level, const LevelBox& box);
// Makes the texels of a new image, which are zero, what an upload of zeros would: opaque where the format has
// no alpha. For images that are not written as a whole.
void clear_texels(raster::TextureImage& image);
// Compresses a new level's texels where its internal format says so. Throws std::bad_alloc.
void compress_level(TextureLevel& level);

// A level ready to be put into a texture object, its image zero. Throws std::bad_alloc.
TextureLevel make_level(const LevelSpec& spec, const TexelFormat& format);

// Whether `box` lies within the level; `level` is specified.
bool contains(const TextureLevel& level, const LevelBox& box);

// The level's image, to be written to; a copy takes its place if queued draws refer to it. `level` has one,
// and `begin_change` was called. Whoever writes also resets the level's blocks. Throws std::bad_alloc and
// changes nothing then.
raster::TextureImage& writable_image(Context& ctx, TextureLevel& level);

// Pixels in client memory.
struct ClientImage {
    GLenum format, type;
    const void* pixels;
};

// Converts a client image through the unpack and pixel transfer state into texels.
void upload(const PixelState& state, const ClientImage& client, const TexelFormat& format,
            const LevelBox& box, int dimensions, raster::TextureImage& image);

}  // namespace terrazzo::gl
