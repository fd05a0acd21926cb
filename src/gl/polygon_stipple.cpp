// PolygonStipple and GetPolygonStipple (GL 1.5 §3.5.2): a 32x32 bitmap in client memory, laid out as the
// pixel store modes say (GL 1.5 §3.6.4, figure 3.9).
#include <cstddef>

#include "gl/change.h"
#include "gl/generated/commands.h"
#include "gl/pixel_buffers.h"
#include "gl/rasterization.h"

namespace terrazzo::gl {
namespace {

constexpr int kStippleSize = 32;

// One bit of a bitmap in client memory.
struct BitAddress {
    std::ptrdiff_t byte;
    GLubyte mask;
};

BitAddress bit_address(const PixelStore& store, int x, int y) {
    const std::ptrdiff_t row_bits = store.row_length > 0 ? store.row_length : kStippleSize;
    const std::ptrdiff_t alignment_bits = std::ptrdiff_t{8} * store.alignment;
    const std::ptrdiff_t row_bytes = (row_bits + alignment_bits - 1) / alignment_bits * store.alignment;
    const std::ptrdiff_t column = std::ptrdiff_t{store.skip_pixels} + x;
    const int bit = static_cast<int>(column % 8);
    return {(std::ptrdiff_t{store.skip_rows} + y) * row_bytes + column / 8,
            static_cast<GLubyte>(store.lsb_first ? 1u << bit : 0x80u >> bit)};
}

// The pattern's bytes; unusable, and the error is recorded, where there are none.
PixelMemory find_pattern(Context& ctx, const PixelStore& store, const GLubyte* mask) {
    PixelMemory memory =
        find_image(ctx, store, {kStippleSize, kStippleSize}, GL_COLOR_INDEX, GL_BITMAP, mask);
    if (memory.is_usable() && !memory.data) memory.rule = {GL_INVALID_VALUE, "mask is null"};
    if (!memory.is_usable()) record_error(ctx, memory.rule.code, memory.rule.words);
    return memory;
}

}  // namespace

void polygon_stipple(Context& ctx, const GLubyte* mask) {
    const PixelMemory memory = find_pattern(ctx, ctx.pixels.unpack, mask);
    if (!memory.is_usable()) return;
    const auto* const source_bytes = reinterpret_cast<const GLubyte*>(memory.data);
    PolygonStipple pattern;
    for (int y = 0; y < kStippleSize; ++y) {
        pattern.rows[y] = 0;
        for (int x = 0; x < kStippleSize; ++x) {
            const BitAddress source = bit_address(ctx.pixels.unpack, x, y);
            if (source_bytes[source.byte] & source.mask) pattern.rows[y] |= 0x80000000u >> x;
        }
    }
    change(ctx, Dirty::kRasterization, ctx.rasterization.polygon_stipple.rows, pattern.rows);
}

void get_polygon_stipple(Context& ctx, GLubyte* mask) {
    const PixelMemory memory = find_pattern(ctx, ctx.pixels.pack, mask);
    if (!memory.is_usable()) return;
    auto* const bytes = reinterpret_cast<GLubyte*>(memory.data);
    for (int y = 0; y < kStippleSize; ++y) {
        for (int x = 0; x < kStippleSize; ++x) {
            const BitAddress target = bit_address(ctx.pixels.pack, x, y);
            const bool set = ctx.rasterization.polygon_stipple.rows[y] & (0x80000000u >> x);
            bytes[target.byte] = static_cast<GLubyte>(set ? bytes[target.byte] | target.mask
                                                          : bytes[target.byte] & ~target.mask);
        }
    }
}

}  // namespace terrazzo::gl
