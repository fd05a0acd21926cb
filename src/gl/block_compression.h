// Block-compressed images (EXT_texture_compression_s3tc): their sizes, and their texels.
//
// A compressed level keeps the client's blocks, to give them back, and its texels as bytes, to be sampled.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "pipeline/texture_image.h"

namespace terrazzo::gl {

inline constexpr int kBlockSize = 4;  // texels each way

struct BlockFormat {
    GLenum name;
    GLenum base;      // GL_RGB or GL_RGBA
    int block_bytes;  // 8 or 16

    int blocks_across(int width) const { return width / kBlockSize + (width % kBlockSize != 0); }
    std::size_t image_bytes(int width, int height) const {
        return static_cast<std::size_t>(blocks_across(width)) *
               static_cast<std::size_t>(blocks_across(height)) * static_cast<std::size_t>(block_bytes);
    }
};

// Null for a name that is no compressed format.
const BlockFormat* find_block_format(GLenum name);

// The formats that a program may be told about: those without surprises for one that picks by its base alone.
inline constexpr GLenum kOfferedBlockFormats[] = {
    GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT};

// The internal format that texels keep which come uncompressed for a compressed one: they stay as they are
// (GL 1.5 §3.8.1 allows that).
GLint without_compression(GLint internal_format);

struct CompressedBlocks {
    const BlockFormat* format;
    std::vector<std::byte> bytes;
};

// Decodes blocks into the texels from (x, y) on, multiples of 4; what reaches beyond the image is left out.
void decode_blocks(const BlockFormat& format, const std::byte* blocks, int width, int height, int x, int y,
                   pipeline::TextureImage& image);

}  // namespace terrazzo::gl
