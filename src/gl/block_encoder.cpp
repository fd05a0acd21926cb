// Compression of texels to S3TC blocks (EXT_texture_compression_s3tc): for uploads and copies to these
// formats, and for generated mipmaps. Input: up to 16 texels of a block. Output: the block whose decoding is
// nearest to them among those that were tried. All in integers, so that every processor finds the same block.
#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "gl/block_compression.h"

namespace terrazzo::gl {
namespace {

constexpr int kTexels = kBlockSize * kBlockSize;
// Alphas below become transparent where alpha has a single bit.
constexpr int kOpaque = 128;

struct Rgb {
    int c[3];
};

// What is beyond the image's edge repeats a texel at the edge.
struct BlockTexels {
    std::array<std::array<std::uint8_t, 4>, kTexels> rgba;
};

int squared_distance(const Rgb& a, const Rgb& b) {
    int sum = 0;
    for (int i = 0; i < 3; ++i) sum += (a.c[i] - b.c[i]) * (a.c[i] - b.c[i]);
    return sum;
}

Rgb color_of(const std::array<std::uint8_t, 4>& texel) {
    return {{texel[0], texel[1], texel[2]}};
}

int nearest(int value, int maximum) {
    return (std::clamp(value, 0, 255) * maximum + 127) / 255;
}

unsigned to_565(const Rgb& color) {
    return static_cast<unsigned>(nearest(color.c[0], 31) << 11 | nearest(color.c[1], 63) << 5 |
                                 nearest(color.c[2], 31));
}

void store_little_endian(std::uint64_t value, int bytes, std::byte* to) {
    for (int i = 0; i < bytes; ++i) to[i] = static_cast<std::byte>(value >> 8 * i & 0xff);
}

// The colours of a block as one possible choice of its two ends and sixteen indices.
struct ColorBlock {
    unsigned ends[2] = {0, 0};
    std::uint32_t indices = 0;
    int error = std::numeric_limits<int>::max();
};

class ColorEncoder {
  public:
    // `transparent`: one bit for each texel that is to have no colour, which only some formats know.
    ColorEncoder(const BlockTexels& block, unsigned transparent, bool always_four)
        : m_transparent(transparent), m_always_four(always_four) {
        for (std::size_t i = 0; i < kTexels; ++i) m_colors[i] = color_of(block.rgba[i]);
    }

    ColorBlock encode() {
        if (m_transparent == 0xffff) return {{0, 0}, 0xffffffff, 0};
        const auto [first, second] = most_distant();
        try_ends(first, second);
        // Ends that fit the indices found so far better than two of the texels do.
        for (int round = 0; round < 2; ++round) {
            Rgb a, b;
            const int before = m_best.error;
            if (!fit_ends(a, b)) break;
            try_ends(a, b);
            if (m_best.error >= before) break;
        }
        return m_best;
    }

  private:
    bool is_transparent(std::size_t i) const { return m_transparent >> i & 1; }

    std::pair<Rgb, Rgb> most_distant() const {
        std::size_t first = 0;
        while (is_transparent(first)) ++first;
        std::pair<Rgb, Rgb> found{m_colors[first], m_colors[first]};
        int longest = 0;
        for (std::size_t i = first; i < kTexels; ++i) {
            for (std::size_t j = i + 1; j < kTexels && !is_transparent(i); ++j) {
                const int distance = is_transparent(j) ? 0 : squared_distance(m_colors[i], m_colors[j]);
                if (distance > longest) longest = distance, found = {m_colors[i], m_colors[j]};
            }
        }
        return found;
    }

    void try_ends(const Rgb& a, const Rgb& b) {
        ColorBlock block;
        block.ends[0] = to_565(a), block.ends[1] = to_565(b);
        // The order of the ends says whether there are four colours, or three and transparency.
        const bool three = m_transparent != 0;
        if ((block.ends[0] < block.ends[1]) != three) std::swap(block.ends[0], block.ends[1]);
        const BlockPalette palette = block_palette(block.ends[0], block.ends[1], m_always_four);
        const std::size_t usable = three || (!m_always_four && block.ends[0] == block.ends[1]) ? 3 : 4;
        block.error = 0;
        for (std::size_t i = 0; i < kTexels; ++i) {
            std::uint32_t index = 3;
            if (!is_transparent(i)) {
                int least = std::numeric_limits<int>::max();
                for (std::size_t p = 0; p < usable; ++p) {
                    const int distance = squared_distance(m_colors[i], color_of(palette[p]));
                    if (distance < least) least = distance, index = static_cast<std::uint32_t>(p);
                }
                block.error += least;
            }
            block.indices |= index << 2 * i;
        }
        if (block.error < m_best.error) m_best = block;
    }

    // The least squares of the ends for the best block's indices; false where these leave them open.
    bool fit_ends(Rgb& a, Rgb& b) const {
        const bool three = m_transparent != 0;
        const int whole = three ? 2 : 3;
        const int weights[4] = {whole, 0, three ? 1 : 2, 1};  // of the first end, in parts of `whole`
        int aa = 0, ab = 0, bb = 0, ax[3] = {}, bx[3] = {};
        for (std::size_t i = 0; i < kTexels; ++i) {
            if (is_transparent(i)) continue;
            const int wa = weights[m_best.indices >> 2 * i & 3], wb = whole - wa;
            aa += wa * wa, ab += wa * wb, bb += wb * wb;
            for (int c = 0; c < 3; ++c) ax[c] += wa * m_colors[i].c[c], bx[c] += wb * m_colors[i].c[c];
        }
        const int determinant = aa * bb - ab * ab;
        if (determinant == 0) return false;
        for (int c = 0; c < 3; ++c) {
            a.c[c] = whole * (ax[c] * bb - bx[c] * ab) / determinant;
            b.c[c] = whole * (bx[c] * aa - ax[c] * ab) / determinant;
        }
        return true;
    }

    std::array<Rgb, kTexels> m_colors;
    unsigned m_transparent;
    bool m_always_four;
    ColorBlock m_best;
};

void encode_colors(const BlockTexels& block, const BlockFormat& format, std::byte* to) {
    const bool always_four = format.block_bytes == 16;
    unsigned transparent = 0;
    if (format.name == GL_COMPRESSED_RGBA_S3TC_DXT1_EXT)
        for (std::size_t i = 0; i < kTexels; ++i)
            if (block.rgba[i][3] < kOpaque) transparent |= 1u << i;
    const ColorBlock best = ColorEncoder(block, transparent, always_four).encode();
    store_little_endian(best.ends[0] | best.ends[1] << 16 | std::uint64_t{best.indices} << 32, 8, to);
}

void encode_alpha_4_bits(const BlockTexels& block, std::byte* to) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < kTexels; ++i)
        bits |= static_cast<std::uint64_t>(nearest(block.rgba[i][3], 15)) << 4 * i;
    store_little_endian(bits, 8, to);
}

struct AlphaBlock {
    std::uint64_t bits = 0;
    int error = 0;
};

AlphaBlock try_alphas(const BlockTexels& block, int first, int second) {
    const AlphaRamp ramp = alpha_ramp(first, second);
    AlphaBlock found;
    found.bits = static_cast<std::uint64_t>(first) | static_cast<std::uint64_t>(second) << 8;
    for (std::size_t i = 0; i < kTexels; ++i) {
        int least = std::numeric_limits<int>::max();
        std::uint64_t index = 0;
        for (std::size_t p = 0; p < ramp.size(); ++p) {
            const int apart = block.rgba[i][3] - ramp[p];
            if (apart * apart < least) least = apart * apart, index = p;
        }
        found.error += least;
        found.bits |= index << (16 + 3 * i);
    }
    return found;
}

// Eight alphas from the highest to the lowest, or six between those that are neither 0 nor 255 beside these.
void encode_alpha_ramp(const BlockTexels& block, std::byte* to) {
    int low = 255, high = 0, inner_low = 255, inner_high = 0;
    for (const auto& texel : block.rgba) {
        const int alpha = texel[3];
        low = std::min(low, alpha), high = std::max(high, alpha);
        if (alpha == 0 || alpha == 255) continue;
        inner_low = std::min(inner_low, alpha), inner_high = std::max(inner_high, alpha);
    }
    AlphaBlock best = try_alphas(block, high, low);
    if (best.error != 0 && inner_low <= inner_high) {
        const AlphaBlock other = try_alphas(block, inner_low, inner_high);
        if (other.error < best.error) best = other;
    }
    store_little_endian(best.bits, 8, to);
}

}  // namespace

void encode_blocks(const raster::TextureImage& image, int x, int y, int width, int height,
                   CompressedBlocks& blocks) {
    const BlockFormat& format = *blocks.format;
    const auto size = static_cast<std::size_t>(format.block_bytes);
    const auto pitch = static_cast<std::size_t>(format.blocks_across(image.width));
    for (int top = y; top < y + height; top += kBlockSize) {
        for (int left = x; left < x + width; left += kBlockSize) {
            BlockTexels block;
            for (int i = 0; i < kTexels; ++i) {
                const int column = std::min(left + i % kBlockSize, image.width - 1);
                const int row = std::min(top + i / kBlockSize, image.height - 1);
                std::copy_n(image.rgba8(column, row), 4, block.rgba[static_cast<std::size_t>(i)].begin());
            }
            std::byte* to = blocks.bytes.data() + size * (static_cast<std::size_t>(top / kBlockSize) * pitch +
                                                          static_cast<std::size_t>(left / kBlockSize));
            if (format.name == GL_COMPRESSED_RGBA_S3TC_DXT3_EXT) encode_alpha_4_bits(block, to);
            if (format.name == GL_COMPRESSED_RGBA_S3TC_DXT5_EXT) encode_alpha_ramp(block, to);
            encode_colors(block, format, size == 16 ? to + 8 : to);
        }
    }
}

}  // namespace terrazzo::gl
