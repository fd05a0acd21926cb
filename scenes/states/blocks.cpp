// EXT_texture_compression_s3tc's block layouts.
#include "blocks.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace terrazzo::states {
namespace {

struct Texel {
    int channels[4];
};
using Block = std::array<Texel, 16>;

Block block_at(const std::vector<std::uint8_t>& rgba, int width, int height, int left, int bottom) {
    Block block{};
    for (int i = 0; i < 16; ++i) {
        const int x = std::min(left + i % 4, width - 1), y = std::min(bottom + i / 4, height - 1);
        for (int c = 0; c < 4; ++c)
            block[static_cast<std::size_t>(i)].channels[c] =
                rgba[static_cast<std::size_t>((y * width + x) * 4 + c)];
    }
    return block;
}

int lightness(const Texel& texel) {
    return 2 * texel.channels[0] + 4 * texel.channels[1] + texel.channels[2];
}

std::uint32_t packed_565(const Texel& texel) {
    return static_cast<std::uint32_t>((texel.channels[0] >> 3) << 11 | (texel.channels[1] >> 2) << 5 |
                                      texel.channels[2] >> 3);
}

void put(std::vector<std::uint8_t>& bytes, std::uint64_t value, int count) {
    for (int i = 0; i < count; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

// How far from low to high in `steps` steps, rounded.
int step_of(int value, int low, int high, int steps) {
    return high == low ? 0 : ((value - low) * steps * 2 + (high - low)) / (2 * (high - low));
}

void put_colours(std::vector<std::uint8_t>& bytes, const Block& block) {
    const auto darker = [](const Texel& a, const Texel& b) { return lightness(a) < lightness(b); };
    const auto [low, high] = std::minmax_element(block.begin(), block.end(), darker);
    std::uint32_t first = packed_565(*high), second = packed_565(*low);
    const bool swapped = first < second;
    if (swapped) std::swap(first, second);
    // The first end point is the greater number: four opaque colours, 0 the first, 1 the second, 2 and 3
    // between.
    constexpr std::uint32_t kCodes[] = {1, 3, 2, 0};
    std::uint32_t codes = 0;
    for (std::size_t i = 0; i < block.size() && first != second; ++i) {
        const int step = step_of(lightness(block[i]), lightness(*low), lightness(*high), 3);
        codes |= kCodes[swapped ? 3 - step : step] << (2 * i);
    }
    put(bytes, first, 2);
    put(bytes, second, 2);
    put(bytes, codes, 4);
}

void put_alphas(std::vector<std::uint8_t>& bytes, const Block& block) {
    int low = 255, high = 0;
    for (const Texel& texel : block) {
        low = std::min(low, texel.channels[3]);
        high = std::max(high, texel.channels[3]);
    }
    // Eight alphas, the greater end point first: code 0 is it, 1 the other, 2 to 7 lie between from it
    // downwards.
    std::uint64_t codes = 0;
    for (std::size_t i = 0; i < block.size() && low != high; ++i) {
        const int step = step_of(block[i].channels[3], low, high, 7);
        const int code = step == 7 ? 0 : step == 0 ? 1 : 8 - step;
        codes |= static_cast<std::uint64_t>(code) << (3 * i);
    }
    put(bytes, static_cast<std::uint64_t>(high), 1);
    put(bytes, static_cast<std::uint64_t>(low), 1);
    put(bytes, codes, 6);
}

}  // namespace

std::vector<std::uint8_t> encode_blocks(const std::vector<std::uint8_t>& rgba, int width, int height,
                                        bool with_alpha) {
    std::vector<std::uint8_t> bytes;
    for (int y = 0; y < height; y += 4)
        for (int x = 0; x < width; x += 4) {
            const Block block = block_at(rgba, width, height, x, y);
            if (with_alpha) put_alphas(bytes, block);
            put_colours(bytes, block);
        }
    return bytes;
}

}  // namespace terrazzo::states
