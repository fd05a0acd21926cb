// Copies between targets; see copy_between.h. Rows of tiles are moved as they are, whichever way they run.
#include "raster/target/copy_between.h"

#include <algorithm>
#include <cstring>

#include "raster/target/clear.h"
#include "raster/target/mean_of_samples.h"

namespace terrazzo::raster {
namespace {

// `row` lies in the same row of bins as `end` - 1, in both targets.
struct Part {
    int x, end_x, row, end, to_row, step;

    // Of the target that is written to.
    int low_row() const { return step > 0 ? to_row : to_row - (end - row - 1); }
    int height() const { return end - row; }
};

// From row `from` of one bin to row `to` of another, in columns `x` to `end` - 1; `kSize` bytes a pixel.
template <size_t kSize>
void copy_row(const std::byte* source, int from, std::byte* destination, int to, int x, int end) {
    constexpr size_t kTileBytes = kTilePixels * kSize;
    const auto place = [](int column, int row) {
        return static_cast<size_t>(pixel_index(column, row)) * kSize;
    };
    const auto copy_some = [&](int next) {
        std::memcpy(destination + place(x, to), source + place(x, from),
                    static_cast<size_t>(next - x) * kSize);
        x = next;
    };
    if (x % kTileSize != 0) copy_some(std::min(end, x - x % kTileSize + kTileSize));
    const std::byte* in = source + place(x, from);
    std::byte* out = destination + place(x, to);
    for (; x + kTileSize <= end; x += kTileSize, in += kTileBytes, out += kTileBytes)
        std::memcpy(out, in, kTileSize * kSize);
    if (x < end) copy_some(end);
}

// A bin's share of a copy that was only cleared in the source.
void clear_instead(Target& to, int index, const Part& part, ClearPlanes planes, const ClearValues& values) {
    BinClear clear{};
    clear.planes = planes;
    clear.values = values;
    clear.color_mask = 0xf;
    clear.x0 = static_cast<int16_t>(part.x), clear.x1 = static_cast<int16_t>(part.end_x);
    clear.y0 = static_cast<int16_t>(part.low_row());
    clear.y1 = static_cast<int16_t>(part.low_row() + part.height());
    clear_bin(clear, to, index);
}

// Calls copy(index in `from`, index in `to`, part) for each pair of bins that share pixels.
template <typename CopyPart>
void for_each_part(const Target& from, const Target& to, const Copy& copy, CopyPart copy_part) {
    const RowRect& rect = copy.from;
    const int step = copy.turned ? -1 : 1;
    for (int row = rect.row, end = rect.row + rect.height; row < end;) {
        const int to_row = copy.to_row + step * (row - rect.row);
        const int left = std::min(kBinSize - row % kBinSize,
                                  copy.turned ? to_row % kBinSize + 1 : kBinSize - to_row % kBinSize);
        const int next = std::min(end, row + left);
        for (int x = rect.x, end_x = rect.x + rect.width; x < end_x;) {
            const int next_x = std::min(end_x, x - x % kBinSize + kBinSize);
            copy_part(row / kBinSize * from.bins_across() + x / kBinSize,
                      to_row / kBinSize * to.bins_across() + x / kBinSize,
                      Part{x, next_x, row, next, to_row, step});
            x = next_x;
        }
        row = next;
    }
}

// Of planes with `kSize` bytes a pixel.
template <size_t kSize>
void copy_rows(const void* source, void* destination, const Part& part) {
    const int x = part.x % kBinSize, end_x = x + part.end_x - part.x;
    for (int row = part.row, to_row = part.to_row; row < part.end; ++row, to_row += part.step)
        copy_row<kSize>(static_cast<const std::byte*>(source), row % kBinSize,
                        static_cast<std::byte*>(destination), to_row % kBinSize, x, end_x);
}

}  // namespace

void copy_rgba8(Target& from, Target& to, const Copy& copy) {
    constexpr ClearPlanes kColors{true, false, false};
    for_each_part(from, to, copy, [&](int source_index, int index, const Part& part) {
        if (const auto value = from.uniform_values(source_index, kColors))
            return clear_instead(to, index, part, kColors, *value);
        to.materialize(index, kColors);
        const Bin source = from.bin(source_index);
        std::byte* const destination = to.bin(index).color;
        if (from.format().samples == 1) return copy_rows<4>(source.color, destination, part);
        ResolvedPixels pixels;
        const int first = part.row % kBinSize / kTileSize, last = (part.end - 1) % kBinSize / kTileSize;
        resolve_samples(source, from.format().color, first * kTilesAcross, (last - first + 1) * kTilesAcross,
                        pixels);
        copy_rows<4>(pixels.bytes, destination, part);
    });
}

void copy_depths(Target& from, Target& to, const Copy& copy) {
    constexpr ClearPlanes kDepths{false, true, false};
    for_each_part(from, to, copy, [&](int source_index, int index, const Part& part) {
        if (const auto value = from.uniform_values(source_index, kDepths))
            return clear_instead(to, index, part, kDepths, *value);
        from.materialize(source_index, kDepths, {});
        to.materialize(index, kDepths);
        copy_rows<4>(from.bin(source_index).depth, to.bin(index).depth, part);
        to.forget_farthest(index);
    });
}

}  // namespace terrazzo::raster
