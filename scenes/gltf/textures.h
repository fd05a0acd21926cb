// Stage: models from files, textures. Input: a texture's number and how a material uses it. Output: its place
// in the model's list. Invariant: only textures that are asked for are read, each (image, sampler, use) once;
// one that cannot be read is -1 and has a note.
#pragma once

#include <array>
#include <map>
#include <tuple>
#include <vector>

#include "document.h"
#include "model.h"

namespace terrazzo::gltf {

using Colour = std::array<float, 4>;

class Textures {
  public:
    Textures(const Document& document, Budget& pixels, Budget& bytes, Notes& notes)
        : m_document(document), m_pixels(pixels), m_bytes(bytes), m_notes(notes) {}

    // The texture's colours times the factor; alpha 255 where the material has no use for it.
    int find(int texture, bool opaque, const Colour& factor = {1, 1, 1, 1});
    // One pixel.
    int plain(const Colour& colour);
    // The mean of the whole image; ones when it cannot be read.
    Colour mean(int texture);

    std::vector<Texture> take() { return std::move(m_textures); }

  private:
    using Key = std::tuple<bool, Colour, int, int>;  // opaque, factor, image, sampler
    Level image_of(int texture);
    Texture make(int texture, bool opaque, const Colour& factor);

    const Document& m_document;
    Budget& m_pixels;
    Budget& m_bytes;
    Notes& m_notes;
    std::vector<Texture> m_textures;
    std::map<Key, int> m_known;
    std::map<int, Colour> m_means;
};

// Where a material's coordinates for a texture come from: KHR_texture_transform and texCoord.
struct TexturePlace {
    int set = 0;
    float matrix[16];
};
TexturePlace place_of(int set, const tinygltf::ExtensionMap& extensions);

// A number of an extension's object, or its default.
double number_in(const tinygltf::Value& object, const char* name, double otherwise);
// As many numbers as there are defaults.
std::vector<double> numbers_in(const tinygltf::Value& object, const char* name,
                               std::vector<double> otherwise);

}  // namespace terrazzo::gltf
