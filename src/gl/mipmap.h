// Automatic mipmap generation (GL 1.5 §3.8.8, EXT_framebuffer_object).
#pragma once

#include <vector>

#include "gl/texture.h"

namespace terrazzo::gl {

// The levels derived from a base level. Everything that needs memory is done when this is made, before the
// base changes; the texels are worked out when it has. The lock is held from the one to the other.
class DerivedLevels {
  public:
    // Those behind `base`, whose image and format are those of the level `number` of the target, or are about
    // to be. None where the texture does not ask for them. Throws std::bad_alloc.
    DerivedLevels(const ImageTarget& target, GLint number, const TextureLevel& base);
    // Whether or not the texture asks for them.
    DerivedLevels(TextureObject& object, int face);
    DerivedLevels(DerivedLevels&&) noexcept;
    ~DerivedLevels();

    // Puts them in their places; the base's texels are there.
    void store() noexcept;

  private:
    void allocate(const TextureObject& object, GLint number, const TextureLevel& base);

    struct Derived;
    TextureLevels* m_levels;
    int m_first = 0;
    std::vector<Derived> m_derived;
};

}  // namespace terrazzo::gl
