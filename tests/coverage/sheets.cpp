// Drawing the sheets; see sheets.h.
#include "sheets.h"

#include <cstring>

#include "kit/offscreen.h"

namespace terrazzo::coverage {
namespace {

constexpr int kSheetSize = 1024;

// Cells across a sheet, in turn: mostly small ones, so that there are many; powers of two and others.
constexpr int kAcross[] = {16, 16, 15, 16, 8, 16, 13, 3, 16, 16, 11, 16, 1, 16, 9, 4};

class Sheet {
  public:
    explicit Sheet(const std::string& path)
        : m_library(path), m_context(m_library, {.width = kSheetSize, .height = kSheetSize}) {
        const kit::Gl& gl = m_library.gl;
        gl.Enable(GL_BLEND);
        gl.BlendFunc(GL_ONE, GL_ONE);
        gl.ShadeModel(GL_FLAT);
        gl.Enable(GL_SCISSOR_TEST);
    }

    void clear() {
        m_library.gl.Disable(GL_SCISSOR_TEST);
        m_library.gl.Clear(GL_COLOR_BUFFER_BIT);
        m_library.gl.Enable(GL_SCISSOR_TEST);
    }
    void add(const Cell& cell, const Rectangle& viewport) { draw(m_library.gl, cell, viewport); }
    void finish() { m_library.gl.Finish(); }
    // Bit i: primitive i of the cell that the pixel is in.
    uint32_t bits_at(int x, int y) const {
        uint32_t bits;
        std::memcpy(&bits,
                    m_context.colour_buffer().data() +
                        4 * (static_cast<size_t>(y) * kSheetSize + static_cast<size_t>(x)),
                    sizeof bits);
        return bits;
    }

  private:
    kit::Library m_library;
    kit::OffscreenContext m_context;
};

uint64_t scrambled(uint64_t v) {
    v = (v ^ v >> 33) * 0xff51afd7ed558ccdu;
    v = (v ^ v >> 33) * 0xc4ceb9fe1a85ec53u;
    return v ^ v >> 33;
}

void add_cell(Sheet& sheet, uint32_t seed, uint32_t number) {
    const Rectangle r = place_of(number).viewport;
    sheet.add(make_cell(seed, number, is_perspective(number), r.width, r.height), r);
}

void add_footprints(const Sheet& sheet, const Rectangle& r, Footprint* out) {
    for (int y = 0; y < r.height; ++y) {
        for (int x = 0; x < r.width; ++x) {
            uint32_t bits = sheet.bits_at(r.x + x, r.y + y);
            if (bits == 0) continue;
            const uint64_t pixel =
                scrambled(static_cast<uint64_t>(y) * kSheetSize + static_cast<uint64_t>(x) + 1);
            for (; bits != 0; bits &= bits - 1) {
                Footprint& footprint = out[__builtin_ctz(bits)];
                footprint.sum += pixel;
                ++footprint.pixels;
            }
        }
    }
}

}  // namespace

Place place_of(uint32_t cell) {
    int sheet = 0;
    uint32_t first = 0;
    for (;; ++sheet) {
        const auto across = static_cast<uint32_t>(kAcross[sheet % static_cast<int>(std::size(kAcross))]);
        if (cell < first + across * across) {
            const int size = kSheetSize / static_cast<int>(across);
            const uint32_t at = cell - first;
            return {sheet,
                    {static_cast<int>(at % across) * size, static_cast<int>(at / across) * size, size, size}};
        }
        first += across * across;
    }
}

std::vector<Footprint> draw_cells(const std::string& library, uint32_t seed, uint32_t count) {
    Sheet sheet(library);
    std::vector<Footprint> footprints(static_cast<size_t>(count) * kCellPrimitives);
    for (uint32_t first = 0, end; first < count; first = end) {
        sheet.clear();
        const int number = place_of(first).sheet;
        for (end = first; end < count && place_of(end).sheet == number; ++end) add_cell(sheet, seed, end);
        sheet.finish();
        for (uint32_t cell = first; cell < end; ++cell)
            add_footprints(sheet, place_of(cell).viewport,
                           footprints.data() + static_cast<size_t>(cell) * kCellPrimitives);
    }
    return footprints;
}

std::vector<uint32_t> draw_cell(const std::string& library, uint32_t seed, uint32_t cell) {
    Sheet sheet(library);
    sheet.clear();
    add_cell(sheet, seed, cell);
    sheet.finish();
    const Rectangle r = place_of(cell).viewport;
    std::vector<uint32_t> bits;
    for (int y = 0; y < r.height; ++y)
        for (int x = 0; x < r.width; ++x) bits.push_back(sheet.bits_at(r.x + x, r.y + y));
    return bits;
}

std::vector<StrayResult> draw_strays(const std::string& library, uint32_t seed, uint32_t sheets) {
    constexpr int kSize = 64, kSquares = kSheetSize / kSize;
    static_assert(kSquares * kSquares == 2 * kStraysOfSheet);
    const auto is_drawn_to = [](int column, int row) { return (column + row) % 2 == 0; };
    Sheet sheet(library);
    std::vector<StrayResult> results;
    uint32_t number = static_cast<uint32_t>(Family::kNotFinite);
    for (uint32_t i = 0; i < sheets; ++i) {
        sheet.clear();
        for (int row = 0; row < kSquares; ++row) {
            for (int column = row % 2; column < kSquares; column += 2, number += kFamilies)
                sheet.add(make_cell(seed, number, is_perspective(number), kSize, kSize, Strays::kAll),
                          {column * kSize, row * kSize, kSize, kSize});
        }
        sheet.finish();
        StrayResult result{0, 0, 0};
        for (int y = 0; y < kSheetSize; ++y) {
            for (int x = 0; x < kSheetSize; ++x) {
                const uint32_t bits = sheet.bits_at(x, y);
                if (bits != 0) ++(is_drawn_to(x / kSize, y / kSize) ? result.inside : result.outside);
                result.picture = scrambled(result.picture + bits + 1);
            }
        }
        results.push_back(result);
    }
    return results;
}

}  // namespace terrazzo::coverage
