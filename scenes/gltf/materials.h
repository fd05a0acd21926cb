// Stage: models from files, surfaces. Input: a material's number. Output: what fixed-function lighting makes
// of it (doc/models.md), and which sets of coordinates its textures want. Invariant: each material is made
// once, when it is first asked for.
#pragma once

#include <map>
#include <vector>

#include "textures.h"

namespace terrazzo::gltf {

struct Surface {
    Material material;
    int base_set = -1;  // of TEXCOORD_n; -1: no texture
    int emissive_set = -1;
    bool invisible = false;  // an alpha cutoff that nothing reaches
};

class Materials {
  public:
    Materials(const Document& document, Textures& textures, Notes& notes)
        : m_document(document), m_textures(textures), m_notes(notes) {}

    // A place in `surfaces`; the default material for -1 and for numbers that are none.
    int find(int material);
    const Surface& surface(int place) const { return m_surfaces[static_cast<std::size_t>(place)]; }
    std::vector<Material> take() const;

  private:
    Surface make(const tinygltf::Material& source);

    const Document& m_document;
    Textures& m_textures;
    Notes& m_notes;
    std::map<int, int> m_known;
    std::vector<Surface> m_surfaces;
};

}  // namespace terrazzo::gltf
