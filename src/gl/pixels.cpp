// Commands that set pixel state: PixelStore, PixelTransfer, PixelMap, PixelZoom (GL 1.5 §3.6.1-3.6.3, §3.6.5)
// and GetPixelMap (§6.1.3). None of it touches vertices that are already specified.
#include "gl/pixels.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "gl/client_pixel.h"
#include "gl/context.h"
#include "gl/convert.h"
#include "gl/generated/commands.h"
#include "gl/pixel_buffers.h"

namespace terrazzo::gl {
namespace {

GLint to_integer(GLfloat value) {
    if (!(value == value)) return 0;
    const double rounded = std::round(static_cast<double>(value));
    return static_cast<GLint>(std::clamp(rounded, -2147483648.0, 2147483647.0));
}

Rule set_not_negative(GLint& field, GLint value) {
    if (value < 0) return {GL_INVALID_VALUE, "the value is negative"};
    field = value;
    return {};
}

Rule set_alignment(GLint& field, GLint value) {
    if (value != 1 && value != 2 && value != 4 && value != 8) {
        return {GL_INVALID_VALUE, "the alignment is none of 1, 2, 4, 8"};
    }
    field = value;
    return {};
}

bool* find_store_flag(PixelState& state, GLenum pname) {
    switch (pname) {
        case GL_PACK_SWAP_BYTES:
            return &state.pack.swap_bytes;
        case GL_PACK_LSB_FIRST:
            return &state.pack.lsb_first;
        case GL_UNPACK_SWAP_BYTES:
            return &state.unpack.swap_bytes;
        case GL_UNPACK_LSB_FIRST:
            return &state.unpack.lsb_first;
        default:
            return nullptr;
    }
}

Rule set_store_integer(PixelState& state, GLenum pname, GLint value) {
    switch (pname) {
        case GL_PACK_ROW_LENGTH:
            return set_not_negative(state.pack.row_length, value);
        case GL_PACK_IMAGE_HEIGHT:
            return set_not_negative(state.pack.image_height, value);
        case GL_PACK_SKIP_ROWS:
            return set_not_negative(state.pack.skip_rows, value);
        case GL_PACK_SKIP_PIXELS:
            return set_not_negative(state.pack.skip_pixels, value);
        case GL_PACK_SKIP_IMAGES:
            return set_not_negative(state.pack.skip_images, value);
        case GL_PACK_ALIGNMENT:
            return set_alignment(state.pack.alignment, value);
        case GL_UNPACK_ROW_LENGTH:
            return set_not_negative(state.unpack.row_length, value);
        case GL_UNPACK_IMAGE_HEIGHT:
            return set_not_negative(state.unpack.image_height, value);
        case GL_UNPACK_SKIP_ROWS:
            return set_not_negative(state.unpack.skip_rows, value);
        case GL_UNPACK_SKIP_PIXELS:
            return set_not_negative(state.unpack.skip_pixels, value);
        case GL_UNPACK_SKIP_IMAGES:
            return set_not_negative(state.unpack.skip_images, value);
        case GL_UNPACK_ALIGNMENT:
            return set_alignment(state.unpack.alignment, value);
        default:
            return {GL_INVALID_ENUM, "unknown pixel store parameter"};
    }
}

GLfloat* find_transfer_float(PixelTransfer& transfer, GLenum pname) {
    switch (pname) {
        case GL_RED_SCALE:
            return &transfer.scale[0];
        case GL_GREEN_SCALE:
            return &transfer.scale[1];
        case GL_BLUE_SCALE:
            return &transfer.scale[2];
        case GL_ALPHA_SCALE:
            return &transfer.scale[3];
        case GL_RED_BIAS:
            return &transfer.bias[0];
        case GL_GREEN_BIAS:
            return &transfer.bias[1];
        case GL_BLUE_BIAS:
            return &transfer.bias[2];
        case GL_ALPHA_BIAS:
            return &transfer.bias[3];
        case GL_DEPTH_SCALE:
            return &transfer.depth_scale;
        case GL_DEPTH_BIAS:
            return &transfer.depth_bias;
        default:
            return nullptr;
    }
}

bool is_pixel_map(GLenum map) {
    return map >= GL_PIXEL_MAP_I_TO_I && map <= GL_PIXEL_MAP_A_TO_A;
}

bool holds_indices(GLenum map) {
    return map == GL_PIXEL_MAP_I_TO_I || map == GL_PIXEL_MAP_S_TO_S;
}

bool is_indexed_by_indices(GLenum map) {
    return map <= GL_PIXEL_MAP_I_TO_A;
}

PixelMap& pixel_map_of(Context& ctx, GLenum map) {
    return ctx.pixels.maps[map - GL_PIXEL_MAP_I_TO_I];
}

// A map's values in the program's memory or a buffer; unusable, and the error is recorded, where there are
// none.
template <typename T>
PixelMemory find_values(Context& ctx, const PixelStore& store, GLsizei count, T* values) {
    PixelMemory memory = find_elements(ctx, store, count, sizeof(T), values);
    if (memory.is_usable() && !memory.data) memory.rule = {GL_INVALID_VALUE, "values is null"};
    if (!memory.is_usable()) record_error(ctx, memory.rule.code, memory.rule.words);
    return memory;
}

GLfloat as_color(GLfloat value) {
    return value;
}

template <typename Integer>
GLfloat as_color(Integer value) {
    return normalised(value);
}

template <typename T>
void set_pixel_map(Context& ctx, GLenum map, GLsizei size, const T* values) {
    if (!is_pixel_map(map)) return record_error(ctx, GL_INVALID_ENUM, "unknown pixel map");
    if (size < 1 || size > kMaxPixelMapTable) {
        return record_error(ctx, GL_INVALID_VALUE, "the map's size is out of range");
    }
    if (is_indexed_by_indices(map) && !std::has_single_bit(static_cast<unsigned>(size))) {
        return record_error(ctx, GL_INVALID_VALUE, "the size of a map from indices is no power of two");
    }
    const PixelMemory memory = find_values(ctx, ctx.pixels.unpack, size, values);
    if (!memory.is_usable()) return;
    values = reinterpret_cast<const T*>(memory.data);
    PixelMap& target = pixel_map_of(ctx, map);
    target.size = size;
    for (GLsizei i = 0; i < size; ++i) {
        const auto value = static_cast<GLfloat>(values[i]);
        GLfloat kept = value;
        if (map == GL_PIXEL_MAP_S_TO_S) {
            kept = std::round(value);
        } else if (map != GL_PIXEL_MAP_I_TO_I) {
            kept = std::clamp(as_color(values[i]), 0.0f, 1.0f);
        }
        target.values[static_cast<size_t>(i)] = kept;
    }
}

template <typename T>
void get_pixel_map(Context& ctx, GLenum map, T* values, double maximum) {
    if (!is_pixel_map(map)) return record_error(ctx, GL_INVALID_ENUM, "unknown pixel map");
    const PixelMap& source = pixel_map_of(ctx, map);
    const PixelMemory memory = find_values(ctx, ctx.pixels.pack, source.size, values);
    if (!memory.is_usable()) return;
    values = reinterpret_cast<T*>(memory.data);
    for (GLsizei i = 0; i < source.size; ++i) {
        const double value = static_cast<double>(source.values[static_cast<size_t>(i)]);
        const double scaled = holds_indices(map) ? std::round(value) : value * maximum;
        values[i] = static_cast<T>(std::clamp(scaled, 0.0, maximum));
    }
}

constexpr double kMaxUint = 4294967295.0;
constexpr double kMaxUshort = 65535.0;

}  // namespace

void pixel_storei(Context& ctx, GLenum pname, GLint param) {
    if (bool* field = find_store_flag(ctx.pixels, pname)) {
        *field = param != 0;
        return;
    }
    if (const Rule rule = set_store_integer(ctx.pixels, pname, param); rule.code != GL_NO_ERROR) {
        record_error(ctx, rule.code, rule.words);
    }
}

void pixel_transferf(Context& ctx, GLenum pname, GLfloat param) {
    PixelTransfer& transfer = ctx.pixels.mode.transfer;
    if (GLfloat* field = find_transfer_float(transfer, pname)) {
        *field = param;
        return;
    }
    switch (pname) {
        case GL_MAP_COLOR:
            transfer.map_color = param != 0.0f;
            break;
        case GL_MAP_STENCIL:
            transfer.map_stencil = param != 0.0f;
            break;
        case GL_INDEX_SHIFT:
            transfer.index_shift = to_integer(param);
            break;
        case GL_INDEX_OFFSET:
            transfer.index_offset = to_integer(param);
            break;
        default:
            record_error(ctx, GL_INVALID_ENUM, "unknown pixel transfer parameter");
            break;
    }
}

void pixel_mapfv(Context& ctx, GLenum map, GLsizei mapsize, const GLfloat* values) {
    set_pixel_map(ctx, map, mapsize, values);
}

void pixel_mapuiv(Context& ctx, GLenum map, GLsizei mapsize, const GLuint* values) {
    set_pixel_map(ctx, map, mapsize, values);
}

void pixel_mapusv(Context& ctx, GLenum map, GLsizei mapsize, const GLushort* values) {
    set_pixel_map(ctx, map, mapsize, values);
}

void get_pixel_mapfv(Context& ctx, GLenum map, GLfloat* values) {
    if (!is_pixel_map(map)) return record_error(ctx, GL_INVALID_ENUM, "unknown pixel map");
    const PixelMap& source = pixel_map_of(ctx, map);
    const PixelMemory memory = find_values(ctx, ctx.pixels.pack, source.size, values);
    if (memory.is_usable())
        std::copy_n(source.values.begin(), source.size, reinterpret_cast<GLfloat*>(memory.data));
}

void get_pixel_mapuiv(Context& ctx, GLenum map, GLuint* values) {
    get_pixel_map(ctx, map, values, kMaxUint);
}

void get_pixel_mapusv(Context& ctx, GLenum map, GLushort* values) {
    get_pixel_map(ctx, map, values, kMaxUshort);
}

void pixel_zoom(Context& ctx, GLfloat xfactor, GLfloat yfactor) {
    ctx.pixels.mode.zoom_x = xfactor;
    ctx.pixels.mode.zoom_y = yfactor;
}

}  // namespace terrazzo::gl
