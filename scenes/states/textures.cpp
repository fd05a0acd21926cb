// Texels: patches and grain in each channel, alpha between a quarter and one. Levels are means of four
// texels.
#include "textures.h"

#include <algorithm>
#include <vector>

#include "blocks.h"
#include "study/textures.h"

namespace terrazzo::states {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::size_t size_of(int width, int height) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

// Patches of a sixteenth of the width.
int patch_bits(int width) {
    int bits = 1;
    while (16 << bits < width) ++bits;
    return bits;
}

Bytes make_texels(int width, int height, std::uint32_t seed) {
    Bytes bytes(size_of(width, height) * 4);
    std::uint8_t* texel = bytes.data();
    const int bits = patch_bits(width);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x, texel += 4) {
            const int grain = static_cast<int>(
                study::hash(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), seed) >> 27);
            const int red = study::value_noise(x, y, bits, seed),
                      green = study::value_noise(x, y, bits + 1, seed + 1);
            texel[0] = static_cast<std::uint8_t>(std::min(96 + red / 2 + grain, 255));
            texel[1] = static_cast<std::uint8_t>(std::min(80 + green / 2 + grain, 255));
            texel[2] = static_cast<std::uint8_t>(200 - (red + green) / 4 + grain);
            texel[3] = static_cast<std::uint8_t>(std::clamp(2 * green - 96, 64, 255));
        }
    return bytes;
}

Bytes halved(const Bytes& texels, int width, int height) {
    const int new_width = std::max(width / 2, 1), new_height = std::max(height / 2, 1);
    Bytes result(size_of(new_width, new_height) * 4);
    const auto at = [&](int x, int y, int channel) {
        return static_cast<int>(texels[size_of(width, std::min(y, height - 1)) * 4 +
                                       static_cast<std::size_t>(std::min(x, width - 1) * 4 + channel)]);
    };
    for (int y = 0; y < new_height; ++y)
        for (int x = 0; x < new_width; ++x)
            for (int c = 0; c < 4; ++c)
                result[(size_of(new_width, y) + static_cast<std::size_t>(x)) * 4 +
                       static_cast<std::size_t>(c)] =
                    static_cast<std::uint8_t>((at(2 * x, 2 * y, c) + at(2 * x + 1, 2 * y, c) +
                                               at(2 * x, 2 * y + 1, c) + at(2 * x + 1, 2 * y + 1, c) + 2) /
                                              4);
    return result;
}

// One channel as depths between a quarter and three quarters.
std::vector<std::uint32_t> depths_of(const Bytes& texels) {
    std::vector<std::uint32_t> depths(texels.size() / 4);
    for (std::size_t i = 0; i < depths.size(); ++i) depths[i] = (64U + texels[4 * i] / 2U) << 24;
    return depths;
}

void upload_compressed(const kit::Gl& gl, GLenum target, const TextureKind& kind, int level, int width,
                       int height, const Bytes& texels) {
    const bool with_alpha = kind.internal_format == GL_COMPRESSED_RGBA_S3TC_DXT5_EXT;
    const Bytes blocks = encode_blocks(texels, width, height, with_alpha);
    gl.CompressedTexImage2D(target, level, kind.internal_format, width, height, 0,
                            static_cast<GLsizei>(blocks.size()), blocks.data());
}

void upload(const kit::Gl& gl, GLenum target, const TextureKind& kind, int level, int width, int height,
            int depth, const Bytes& texels) {
    if (kind.format == 0) {
        upload_compressed(gl, target, kind, level, width, height, texels);
        return;
    }
    std::vector<std::uint32_t> depths;
    if (kind.format == GL_DEPTH_COMPONENT) depths = depths_of(texels);
    const void* data = depths.empty() ? static_cast<const void*>(texels.data()) : depths.data();
    const auto internal = static_cast<GLint>(kind.internal_format);
    if (target == GL_TEXTURE_1D)
        gl.TexImage1D(target, level, internal, width, 0, kind.format, kind.type, data);
    else if (target == GL_TEXTURE_3D)
        gl.TexImage3D(target, level, internal, width, height, depth, 0, kind.format, kind.type, data);
    else
        gl.TexImage2D(target, level, internal, width, height, 0, kind.format, kind.type, data);
}

// A 3D texture's slices are pictures above each other; its levels are pictures of their own.
Bytes texels_of_volume(int width, int height, int depth, std::uint32_t seed) {
    Bytes texels;
    for (int z = 0; z < depth; ++z) {
        const Bytes slice = make_texels(width, height, seed + static_cast<std::uint32_t>(z));
        texels.insert(texels.end(), slice.begin(), slice.end());
    }
    return texels;
}

void upload_volume(const kit::Gl& gl, const TextureKind& kind, std::uint32_t seed) {
    int width = kind.width, height = kind.height, depth = kind.depth;
    for (int level = 0;; ++level) {
        upload(gl, kind.target, kind, level, width, height, depth,
               texels_of_volume(width, height, depth, seed));
        if (!kind.mipmapped || (width == 1 && height == 1 && depth == 1)) return;
        width = std::max(width / 2, 1), height = std::max(height / 2, 1), depth = std::max(depth / 2, 1);
    }
}

void upload_pictures(const kit::Gl& gl, GLenum target, const TextureKind& kind, std::uint32_t seed) {
    int width = kind.width, height = kind.height;
    Bytes texels = make_texels(width, height, seed);
    for (int level = 0;; ++level) {
        upload(gl, target, kind, level, width, height, 1, texels);
        if (!kind.mipmapped || (width == 1 && height == 1)) return;
        texels = halved(texels, width, height);
        width = std::max(width / 2, 1), height = std::max(height / 2, 1);
    }
}

bool is_mipmapped(GLenum filter) {
    return filter != GL_NEAREST && filter != GL_LINEAR;
}

}  // namespace

TextureKind kind_of(const State& state) {
    TextureKind kind;
    kind.target = state.number(Axis::kTarget);
    kind.internal_format = state.number(Axis::kFormat, 0);
    kind.format = state.number(Axis::kFormat, 1);
    kind.type = state.number(Axis::kFormat, 2);
    kind.mipmapped = is_mipmapped(state.number(Axis::kFilter));
    const bool is_volume = kind.target == GL_TEXTURE_3D;
    kind.width = static_cast<int>(state.number(Axis::kSize, is_volume ? 2 : 0));
    kind.height = static_cast<int>(state.number(Axis::kSize, is_volume ? 3 : 1));
    if (is_volume) kind.depth = kind.height;
    if (kind.target == GL_TEXTURE_CUBE_MAP) kind.width = kind.height;
    if (kind.target == GL_TEXTURE_1D) kind.height = 1;
    return kind;
}

GLuint create_texture(const kit::Gl& gl, const TextureKind& kind, std::uint32_t seed) {
    GLuint name = 0;
    gl.GenTextures(1, &name);
    gl.BindTexture(kind.target, name);
    if (kind.target == GL_TEXTURE_CUBE_MAP) {
        for (GLenum face = 0; face < 6; ++face)
            upload_pictures(gl, GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, kind, seed + face);
    } else if (kind.target == GL_TEXTURE_3D) {
        upload_volume(gl, kind, seed);
    } else {
        upload_pictures(gl, kind.target, kind, seed);
    }
    return name;
}

MovingTexels::MovingTexels(const TextureKind& kind, std::uint32_t seed) : m_kind(kind) {
    m_kind.height = std::max(kind.height / 2, 1);
    m_texels = make_texels(m_kind.width, m_kind.height, seed);
    if (kind.format == GL_DEPTH_COMPONENT) m_depths = depths_of(m_texels);
}

void MovingTexels::give(const kit::Gl& gl) const {
    const void* data = m_depths.empty() ? static_cast<const void*>(m_texels.data()) : m_depths.data();
    gl.TexSubImage2D(m_kind.target, 0, 0, 0, m_kind.width, m_kind.height, m_kind.format, m_kind.type, data);
}

}  // namespace terrazzo::states
