// Stage: client side, the textures of `terrazzo bench states`.
// Input: target, format, size, and how its texels come. Output: a complete texture object with every mip
// level. Invariant: texels are integer arithmetic from a seed, the same for every library; compressed ones
// are given as blocks, so that no library's compressor is compared.
#pragma once

#include <vector>

#include "state.h"

namespace terrazzo::states {

struct TextureKind {
    GLenum target = GL_TEXTURE_2D;
    int width = 0, height = 0, depth = 1;
    GLenum internal_format = GL_RGB8, format = GL_RGBA, type = GL_UNSIGNED_BYTE;
    bool mipmapped = false;
};

// Unit 0's texture in a state; the size is that of level 0.
TextureKind kind_of(const State& state);

// Bound to its target afterwards; filters and wraps are the caller's.
GLuint create_texture(const kit::Gl& gl, const TextureKind& kind, std::uint32_t seed);
// New texels for the lower half of level 0, as a program with moving pictures has them.
class MovingTexels {
  public:
    MovingTexels() = default;
    MovingTexels(const TextureKind& kind, std::uint32_t seed);
    // To the bound texture.
    void give(const kit::Gl& gl) const;

  private:
    TextureKind m_kind;
    std::vector<std::uint8_t> m_texels;
    std::vector<std::uint32_t> m_depths;
};

}  // namespace terrazzo::states
