// Automatic mipmap generation: each level is the one before at half the size.
//
// Every new texel is the reference's: a sample of the old level at the new texel's centre, linear and clamped
// to the edge, with the arithmetic of its samplers (doc/reference.md §5). Where sizes are even that is the
// mean of two, four or eight texels, each pair rounded up.
#include "gl/mipmap.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "gl/block_compression.h"
#include "gl/context.h"
#include "gl/generated/commands.h"
#include "gl/pixel_convert.h"
#include "gl/texel_row.h"
#include "gl/texture_spec.h"

namespace terrazzo::gl {
namespace {

using raster::TextureImage;

// The two old texels that a new one lies between, along one axis.
struct Between {
    int first, second;
    int weight;  // of the second, in 256ths
    float float_weight;
};

// For the new texels from -border to new_size + border - 1. Border texels come of border texels.
std::vector<Between> axis(int old_size, int new_size, int border) {
    std::vector<Between> all;
    if (border) all.push_back({-1, -1, 0, 0});
    const auto inside = [&](int i) { return std::clamp(i, 0, old_size - 1); };
    for (int i = 0; i < new_size; ++i) {
        const auto s = static_cast<float>((i + 0.5) / new_size);
        const auto size = static_cast<float>(old_size);
        const int u = static_cast<int>(std::lrint(s * (size * 256.0f))) - 128;
        const float at = s * size - 0.5f;
        all.push_back({inside(u >> 8), inside((u >> 8) + 1), u & 255, at - std::floor(at)});
    }
    if (border) all.push_back({old_size, old_size, 0, 0});
    return all;
}

// Neighbouring rows and layers of the old level, for one row of the new one.
template <typename Texel>
struct Rows {
    const Texel* row[2][2];  // by layer, by row; the first texel, without border
};

void lerp(int& value, int next, const Between& at) {
    value += (at.weight * (next - value) + 128) >> 8;
}
void lerp(float& value, float next, const Between& at) {
    value += at.float_weight * (next - value);
}

// One channel of one new texel.
template <typename Value, typename Texel>
Value mixed(const Rows<Texel>& rows, const Between& x, const Between& y, const Between& z, int channels,
            int c) {
    Value layers[2];
    for (int layer = 0; layer < (z.weight ? 2 : 1); ++layer) {
        Value values[2];
        for (int row = 0; row < (y.weight ? 2 : 1); ++row) {
            const Texel* const texels = rows.row[layer][row];
            values[row] = static_cast<Value>(texels[channels * x.first + c]);
            lerp(values[row], static_cast<Value>(texels[channels * x.second + c]), x);
        }
        if (y.weight) lerp(values[0], values[1], y);
        layers[layer] = values[0];
    }
    if (z.weight) lerp(layers[0], layers[1], z);
    return layers[0];
}

// Whether the texels of a row are means of pairs, in both directions.
bool halves(const std::vector<Between>& x, const Between& y, const Between& z) {
    const auto half = [](const Between& b) { return b.weight == 128; };
    return half(y) && z.weight == 0 && std::all_of(x.begin(), x.end(), half);
}

int mean(int a, int b) {
    return (a + b + 1) >> 1;
}
float mean(float a, float b) {
    return a + 0.5f * (b - a);
}

template <typename Value, typename Texel>
void halve_row(const Rows<Texel>& rows, int count, Texel* out) {
    const Texel *const low = rows.row[0][0], *const high = rows.row[0][1];
    const auto at = [](const Texel* texels, int i) { return static_cast<Value>(texels[i]); };
    for (int i = 0; i < count; ++i) {
        for (int c = 0; c < 4; ++c)
            out[4 * i + c] = static_cast<Texel>(mean(mean(at(low, 8 * i + c), at(low, 8 * i + 4 + c)),
                                                     mean(at(high, 8 * i + c), at(high, 8 * i + 4 + c))));
    }
}

class LevelReducer {
  public:
    LevelReducer(const TextureImage& from, TextureImage& to, const TexelFormat& format)
        : m_from(from),
          m_to(to),
          m_format(format),
          m_x(axis(from.width, to.width, to.border_x)),
          m_y(axis(from.height, to.height, to.border_y)),
          m_z(axis(from.depth, to.depth, to.border_z)),
          m_bytes(4 * m_x.size()),
          m_floats(m_from.storage == raster::TexelStorage::kRgba32F ? 4 * m_x.size() : 0) {}

    void reduce() {
        for (std::size_t z = 0; z < m_z.size(); ++z)
            for (std::size_t y = 0; y < m_y.size(); ++y)
                reduce_row(static_cast<int>(y) - m_to.border_y, static_cast<int>(z) - m_to.border_z, m_y[y],
                           m_z[z]);
    }

  private:
    template <typename Texel, typename Get>
    static Rows<Texel> rows_of(const Between& y, const Between& z, Get get) {
        return {{{get(y.first, z.first), get(y.second, z.first)},
                 {get(y.first, z.second), get(y.second, z.second)}}};
    }

    void reduce_row(int y, int z, const Between& at_y, const Between& at_z) {
        switch (m_from.storage) {
            case raster::TexelStorage::kRgba8:
                return reduce_bytes(y, z, at_y, at_z);
            case raster::TexelStorage::kRgba32F:
                return reduce_floats(y, z, at_y, at_z);
            case raster::TexelStorage::kDepth:
                return reduce_depths(y, at_y);
        }
    }

    template <typename Value>
    void store(const std::vector<Value>& row, Rounding rounding, int y, int z) {
        const int count = static_cast<int>(m_x.size());
        for (int x = 0; x < count; x += kPixelChunk)
            store_texels(m_format, row.data() + 4 * x, rounding, std::min(kPixelChunk, count - x), m_to,
                         x - m_to.border_x, y, z);
    }

    void reduce_bytes(int y, int z, const Between& at_y, const Between& at_z) {
        const auto rows =
            rows_of<uint8_t>(at_y, at_z, [&](int row, int layer) { return m_from.rgba8(0, row, layer); });
        if (halves(m_x, at_y, at_z)) {
            halve_row<int>(rows, static_cast<int>(m_x.size()), m_bytes.data());
        } else {
            for (std::size_t x = 0; x < m_x.size(); ++x)
                for (int c = 0; c < 4; ++c)
                    m_bytes[4 * x + static_cast<std::size_t>(c)] =
                        static_cast<uint8_t>(mixed<int>(rows, m_x[x], at_y, at_z, 4, c));
        }
        store(m_bytes, Rounding::kAsDrawn, y, z);
    }

    void reduce_floats(int y, int z, const Between& at_y, const Between& at_z) {
        const auto rows =
            rows_of<float>(at_y, at_z, [&](int row, int layer) { return m_from.rgba32f(0, row, layer); });
        if (halves(m_x, at_y, at_z)) {
            halve_row<float>(rows, static_cast<int>(m_x.size()), m_floats.data());
        } else {
            for (std::size_t x = 0; x < m_x.size(); ++x)
                for (int c = 0; c < 4; ++c)
                    m_floats[4 * x + static_cast<std::size_t>(c)] =
                        mixed<float>(rows, m_x[x], at_y, at_z, 4, c);
        }
        store(m_floats, Rounding::kOnce, y, z);
    }

    // Depth textures have one layer.
    void reduce_depths(int y, const Between& at_y) {
        const double maximum = static_cast<double>((std::uint64_t{1} << m_format.bits[0]) - 1);
        const std::uint32_t *const low = m_from.depths(0, at_y.first), *const high =
                                                                           m_from.depths(0, at_y.second);
        std::uint32_t* const out = m_to.depths(-m_to.border_x, y);
        for (std::size_t x = 0; x < m_x.size(); ++x) {
            const Between& b = m_x[x];
            const auto lerp = [](double from, double to, double t) { return from + t * (to - from); };
            const double sum = lerp(lerp(low[b.first], low[b.second], b.float_weight),
                                    lerp(high[b.first], high[b.second], b.float_weight), at_y.float_weight);
            out[x] = static_cast<std::uint32_t>(std::clamp(std::rint(sum), 0.0, maximum));
        }
    }

    const TextureImage& m_from;
    TextureImage& m_to;
    const TexelFormat& m_format;
    std::vector<Between> m_x, m_y, m_z;
    std::vector<uint8_t> m_bytes;
    std::vector<float> m_floats;
};

int dimensions_of(GLenum target) {
    return target == GL_TEXTURE_1D ? 1 : target == GL_TEXTURE_3D ? 3 : 2;
}

// Whether all faces have the base level that a cube map needs.
bool is_cube_complete(const TextureObject& object) {
    const auto base = static_cast<std::size_t>(object.parameters.base_level);
    const TextureLevel& first = object.levels[base];
    for (int face = 1; face < object.face_count(); ++face) {
        const TextureLevel& level = object.face(face)[base];
        if (!level.image || level.width != first.width || level.internal_format != first.internal_format)
            return false;
    }
    return true;
}

}  // namespace

struct DerivedLevels::Derived {
    TextureLevel level;
    std::shared_ptr<CompressedBlocks> blocks;  // null where texels stay as they are
    LevelReducer reducer;
};

DerivedLevels::DerivedLevels(const ImageTarget& target, GLint number, const TextureLevel& base)
    : m_levels(&target.object->face(target.face)) {
    const TextureParameters& parameters = target.object->parameters;
    if (parameters.generate_mipmap && number == parameters.base_level) allocate(*target.object, number, base);
}

DerivedLevels::DerivedLevels(TextureObject& object, int face) : m_levels(&object.face(face)) {
    const int number = object.parameters.base_level;
    if (number < kMaxTextureLevels) allocate(object, number, (*m_levels)[static_cast<std::size_t>(number)]);
}

DerivedLevels::DerivedLevels(DerivedLevels&&) noexcept = default;
DerivedLevels::~DerivedLevels() = default;

// Levels base + 1 to q of GL 1.5 §3.8.8; all others stay as they are.
void DerivedLevels::allocate(const TextureObject& object, GLint number, const TextureLevel& base) {
    if (!base.image) return;
    const TextureImage& largest = *base.image;
    const auto longest = static_cast<unsigned>(std::max({largest.width, largest.height, largest.depth}));
    const int smallest = number + static_cast<int>(std::bit_width(longest)) - 1;
    const int last = std::min({smallest, object.parameters.max_level, kMaxTextureLevels - 1});
    m_first = number + 1;
    if (last < m_first) return;
    m_derived.reserve(static_cast<std::size_t>(last - number));
    const BlockFormat* const block_format = find_block_format(static_cast<GLenum>(base.internal_format));
    const TextureImage* from = &largest;
    for (int level = m_first; level <= last; ++level) {
        const auto half = [](int size, int border) { return std::max(1, size >> 1) + 2 * border; };
        const LevelSpec spec{level,
                             base.internal_format,
                             half(from->width, from->border_x),
                             half(from->height, from->border_y),
                             half(from->depth, from->border_z),
                             base.border,
                             dimensions_of(object.target)};
        TextureLevel made = make_level(spec, *base.format);
        TextureImage& to = *made.image;
        auto blocks = block_format ? allocate_blocks(*block_format, to.width, to.height) : nullptr;
        m_derived.push_back({std::move(made), std::move(blocks), LevelReducer(*from, to, *base.format)});
        from = &to;
    }
}

void DerivedLevels::store() noexcept {
    for (std::size_t i = 0; i < m_derived.size(); ++i) {
        Derived& derived = m_derived[i];
        derived.reducer.reduce();
        if (derived.blocks) {
            raster::TextureImage& image = *derived.level.image;
            recompress(image, 0, 0, image.width, image.height, *derived.blocks);
            derived.level.blocks = std::move(derived.blocks);
        }
        (*m_levels)[static_cast<std::size_t>(m_first) + i] = std::move(derived.level);
    }
    m_derived.clear();
}

void generate_mipmap(Context& ctx, GLenum target) {
    TextureObject* const object = bound_texture(ctx, target);
    if (!object) return record_error(ctx, GL_INVALID_ENUM, "unknown texture target");
    settle_framebuffers(ctx);
    begin_change(ctx, Dirty::kTexture);
    const auto lock = lock_textures(ctx);
    const int base = object->parameters.base_level;
    const bool has_base = base < kMaxTextureLevels && object->levels[static_cast<std::size_t>(base)].image;
    if (!has_base || !is_cube_complete(*object))
        return record_error(ctx, GL_INVALID_OPERATION, "the texture has no complete base level");
    std::vector<DerivedLevels> faces;
    faces.reserve(static_cast<std::size_t>(object->face_count()));
    for (int face = 0; face < object->face_count(); ++face) faces.emplace_back(*object, face);
    for (DerivedLevels& face : faces) face.store();
}

}  // namespace terrazzo::gl
