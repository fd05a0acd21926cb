// Decoding of S3TC blocks; see block_compression.h. Colours and alphas between the two that a block names are
// the reference's, whose weights are 256ths (doc/reference.md §5).
#include "gl/block_compression.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace terrazzo::gl {
namespace {

constexpr BlockFormat kFormats[] = {
    {GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GL_RGB, 8},
    {GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, GL_RGBA, 8},
    {GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, GL_RGBA, 16},
    {GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, GL_RGBA, 16},
};

using Rgba = std::array<std::uint8_t, 4>;
using Texels = std::array<Rgba, kBlockSize * kBlockSize>;

// Little-endian, as the files and the specification have it.
std::uint64_t little_endian(const std::byte* from, int bytes) {
    std::uint64_t value = 0;
    for (int i = bytes; i-- > 0;) value = value << 8 | std::to_integer<std::uint64_t>(from[i]);
    return value;
}

std::uint8_t between(int from, int to, int weight) {
    return static_cast<std::uint8_t>(from + ((weight * (to - from)) >> 8));
}

Rgba color_of_565(std::uint64_t c) {
    const auto r = static_cast<unsigned>(c >> 11 & 31), g = static_cast<unsigned>(c >> 5 & 63),
               b = static_cast<unsigned>(c & 31);
    return {static_cast<std::uint8_t>(r << 3 | r >> 2), static_cast<std::uint8_t>(g << 2 | g >> 4),
            static_cast<std::uint8_t>(b << 3 | b >> 2), 255};
}

void decode_colors(const std::byte* block, bool always_four, bool has_alpha, Texels& out) {
    const auto c0 = static_cast<unsigned>(little_endian(block, 2)),
               c1 = static_cast<unsigned>(little_endian(block + 2, 2));
    const std::uint64_t bits = little_endian(block + 4, 4);
    BlockPalette palette = block_palette(c0, c1, always_four);
    if (!always_four && c0 <= c1 && has_alpha) palette[3][3] = 0;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = palette[bits >> 2 * i & 3];
}

void decode_alpha_4_bits(const std::byte* block, Texels& out) {
    const std::uint64_t bits = little_endian(block, 8);
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i][3] = static_cast<std::uint8_t>((bits >> 4 * i & 15) * 17);
}

void decode_alpha_ramp(const std::byte* block, Texels& out) {
    const AlphaRamp ramp = alpha_ramp(std::to_integer<int>(block[0]), std::to_integer<int>(block[1]));
    const std::uint64_t bits = little_endian(block + 2, 6);
    for (std::size_t i = 0; i < out.size(); ++i) out[i][3] = ramp[bits >> 3 * i & 7];
}

void decode_block(const BlockFormat& format, const std::byte* block, Texels& out) {
    const bool has_alpha_block = format.block_bytes == 16;
    decode_colors(has_alpha_block ? block + 8 : block, has_alpha_block, format.base == GL_RGBA, out);
    if (format.name == GL_COMPRESSED_RGBA_S3TC_DXT3_EXT) decode_alpha_4_bits(block, out);
    if (format.name == GL_COMPRESSED_RGBA_S3TC_DXT5_EXT) decode_alpha_ramp(block, out);
}

}  // namespace

BlockPalette block_palette(unsigned c0, unsigned c1, bool always_four) {
    BlockPalette palette{color_of_565(c0), color_of_565(c1), Rgba{0, 0, 0, 255}, Rgba{0, 0, 0, 255}};
    const bool four = always_four || c0 > c1;
    for (std::size_t c = 0; c < 3; ++c) {
        const int a = palette[0][c], b = palette[1][c];
        palette[2][c] = four ? between(a, b, 85) : static_cast<std::uint8_t>((a + b + 1) >> 1);
        if (four) palette[3][c] = between(a, b, 170);
    }
    return palette;
}

AlphaRamp alpha_ramp(int a, int b) {
    constexpr int kSevenths[] = {36, 72, 109, 145, 182, 218}, kFifths[] = {51, 102, 153, 204};
    AlphaRamp ramp{static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b), 0, 0, 0, 0, 0, 255};
    const auto fill = [&](const auto& weights) {
        std::transform(std::begin(weights), std::end(weights), ramp.begin() + 2,
                       [&](int weight) { return between(a, b, weight); });
    };
    a > b ? fill(kSevenths) : fill(kFifths);
    return ramp;
}

const BlockFormat* find_block_format(GLenum name) {
    const auto found = std::find_if(std::begin(kFormats), std::end(kFormats),
                                    [&](const BlockFormat& format) { return format.name == name; });
    return found == std::end(kFormats) ? nullptr : found;
}

GLint without_compression(GLint internal_format) {
    switch (internal_format) {
        case GL_COMPRESSED_ALPHA:
            return GL_ALPHA;
        case GL_COMPRESSED_LUMINANCE:
            return GL_LUMINANCE;
        case GL_COMPRESSED_LUMINANCE_ALPHA:
            return GL_LUMINANCE_ALPHA;
        case GL_COMPRESSED_INTENSITY:
            return GL_INTENSITY;
        case GL_COMPRESSED_RGB:
            return GL_RGB;
        case GL_COMPRESSED_RGBA:
            return GL_RGBA;
    }
    return internal_format;
}

bool is_whole_blocks(GLint at, GLsizei size, GLsizei image_size) {
    return at % kBlockSize == 0 && (size % kBlockSize == 0 || at + size == image_size);
}

void decode_blocks(const BlockFormat& format, const std::byte* blocks, int width, int height, int x, int y,
                   raster::TextureImage& image) {
    Texels texels;
    for (int top = 0; top < height; top += kBlockSize) {
        for (int left = 0; left < width; left += kBlockSize, blocks += format.block_bytes) {
            decode_block(format, blocks, texels);
            const int columns = std::min(kBlockSize, image.width - (x + left));
            const int rows = std::min(kBlockSize, image.height - (y + top));
            for (int row = 0; row < rows; ++row)
                std::memcpy(image.rgba8(x + left, y + top + row), texels.data() + kBlockSize * row,
                            static_cast<std::size_t>(columns) * sizeof(Rgba));
        }
    }
}

std::shared_ptr<CompressedBlocks> allocate_blocks(const BlockFormat& format, int width, int height) {
    auto blocks = std::make_shared<CompressedBlocks>();
    blocks->format = &format;
    blocks->bytes.resize(format.image_bytes(width, height));
    return blocks;
}

std::shared_ptr<const CompressedBlocks> compress(const BlockFormat& format, raster::TextureImage& image) {
    const auto blocks = allocate_blocks(format, image.width, image.height);
    encode_blocks(image, 0, 0, image.width, image.height, *blocks);
    decode_blocks(format, blocks->bytes.data(), image.width, image.height, 0, 0, image);
    return blocks;
}

void recompress(raster::TextureImage& image, int x, int y, int width, int height, CompressedBlocks& blocks) {
    encode_blocks(image, x, y, width, height, blocks);
    const BlockFormat& format = *blocks.format;
    const auto block = static_cast<std::size_t>(format.block_bytes);
    const auto pitch = static_cast<std::size_t>(format.blocks_across(image.width));
    for (int top = y; top < y + height; top += kBlockSize)
        decode_blocks(format,
                      blocks.bytes.data() + block * (static_cast<std::size_t>(top / kBlockSize) * pitch +
                                                     static_cast<std::size_t>(x / kBlockSize)),
                      width, std::min(kBlockSize, y + height - top), x, top, image);
}

}  // namespace terrazzo::gl
