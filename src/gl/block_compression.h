// Block-compressed images (EXT_texture_compression_s3tc): their sizes, and their texels.
//
// A compressed level keeps the client's blocks, to give them back, and its texels as bytes, to be sampled.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "raster/target/texture_image.h"

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

// The base format in the place of a generic compressed one: whether these compress is left to us (GL 1.5
// §3.8.1), and texels stay as they are.
GLint without_compression(GLint internal_format);

// The colours and alphas that a block chooses from. `always_four`: the order of the two ends says nothing, as
// in the formats with an alpha block; else there may be three, and black.
using BlockPalette = std::array<std::array<std::uint8_t, 4>, 4>;
BlockPalette block_palette(unsigned first_565, unsigned second_565, bool always_four);
using AlphaRamp = std::array<std::uint8_t, 8>;
AlphaRamp alpha_ramp(int first, int second);

// Whether a part of an image begins and ends with a block or with the image.
bool is_whole_blocks(GLint at, GLsizei size, GLsizei image_size);

struct CompressedBlocks {
    const BlockFormat* format;
    std::vector<std::byte> bytes;
};

// Decodes blocks into the texels from (x, y) on, multiples of 4; what reaches beyond the image is left out.
void decode_blocks(const BlockFormat& format, const std::byte* blocks, int width, int height, int x, int y,
                   raster::TextureImage& image);

// The other way: blocks of a part that is_whole_blocks() (block_encoder.cpp).
void encode_blocks(const raster::TextureImage& image, int x, int y, int width, int height,
                   CompressedBlocks& blocks);

// Room for the blocks of an image, all of them 0. Throws std::bad_alloc.
std::shared_ptr<CompressedBlocks> allocate_blocks(const BlockFormat& format, int width, int height);

// Makes blocks of an image of bytes, and its texels what they decode to. Throws std::bad_alloc.
std::shared_ptr<const CompressedBlocks> compress(const BlockFormat& format, raster::TextureImage& image);
// The same for a part that is_whole_blocks().
void recompress(raster::TextureImage& image, int x, int y, int width, int height, CompressedBlocks& blocks);

}  // namespace terrazzo::gl
