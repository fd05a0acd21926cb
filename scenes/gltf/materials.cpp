// Metals lose part of their diffuse colour to a coloured highlight; a rough surface has a wide, weak one. The
// numbers were chosen by eye: fixed-function lighting has no physical model to match.
#include "materials.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace terrazzo::gltf {
namespace {

// What a surface is before it becomes a Material.
struct Surfacing {
    std::array<double, 4> base{1, 1, 1, 1};
    std::array<double, 3> specular{};  // of a metal its colour, else grey
    double metal = 1, smooth = 0;
    int texture = -1, set = 0;
    const tinygltf::ExtensionMap* place = nullptr;
};

const tinygltf::Value* extension_of(const tinygltf::Material& source, const char* name) {
    const auto found = source.extensions.find(name);
    return found == source.extensions.end() ? nullptr : &found->second;
}

Surfacing metallic_roughness(const tinygltf::PbrMetallicRoughness& source, Textures& textures) {
    Surfacing result;
    if (source.baseColorFactor.size() == 4)
        std::copy(source.baseColorFactor.begin(), source.baseColorFactor.end(), result.base.begin());
    double rough = source.roughnessFactor;
    result.metal = source.metallicFactor;
    if (source.metallicRoughnessTexture.index >= 0) {
        const Colour mean = textures.mean(source.metallicRoughnessTexture.index);
        rough *= mean[1];
        result.metal *= mean[2];
    }
    result.metal = std::clamp(result.metal, 0.0, 1.0);
    result.smooth = 1 - std::clamp(rough, 0.0, 1.0);
    for (std::size_t i = 0; i < 3; ++i)
        result.specular[i] = result.metal * result.base[i] + (1 - result.metal) * 0.6;
    result.texture = source.baseColorTexture.index;
    result.set = source.baseColorTexture.texCoord;
    result.place = &source.baseColorTexture.extensions;
    return result;
}

Surfacing specular_glossiness(const tinygltf::Value& source, tinygltf::ExtensionMap& place) {
    Surfacing result;
    const std::vector<double> diffuse = numbers_in(source, "diffuseFactor", {1, 1, 1, 1});
    const std::vector<double> specular = numbers_in(source, "specularFactor", {1, 1, 1});
    std::copy(diffuse.begin(), diffuse.end(), result.base.begin());
    result.metal = 0;
    result.smooth = std::clamp(number_in(source, "glossinessFactor", 1), 0.0, 1.0);
    const double strongest = std::clamp(*std::max_element(specular.begin(), specular.end()), 0.0, 1.0);
    for (std::size_t i = 0; i < 3; ++i) result.specular[i] = strongest * specular[i] + (1 - strongest) * 0.6;
    if (source.IsObject() && source.Has("diffuseTexture")) {
        const tinygltf::Value& texture = source.Get("diffuseTexture");
        result.texture = static_cast<int>(std::clamp(number_in(texture, "index", -1), -1.0, 1e9));
        result.set = static_cast<int>(std::clamp(number_in(texture, "texCoord", 0), 0.0, 1e9));
        if (texture.IsObject() && texture.Has("extensions") &&
            texture.Get("extensions").Has("KHR_texture_transform"))
            place["KHR_texture_transform"] = texture.Get("extensions").Get("KHR_texture_transform");
    }
    result.place = &place;
    return result;
}

void set_colours(Material& material, const Surfacing& surfacing) {
    const double rest = material.unlit ? 1 : 1 - 0.4 * surfacing.metal;
    for (std::size_t i = 0; i < 3; ++i) {
        material.diffuse[i] = static_cast<float>(surfacing.base[i] * rest);
        material.specular[i] = static_cast<float>((0.15 + 0.6 * surfacing.smooth) * surfacing.specular[i]);
    }
    material.diffuse[3] = static_cast<float>(surfacing.base[3]);
    const double shininess = 4 + 110 * surfacing.smooth * surfacing.smooth;
    material.shininess = static_cast<float>(std::clamp(shininess, 1.0, 128.0));
    material.metal = surfacing.metal > 0.5;
}

void place_texture(TextureUse& use, int& set_wanted, int texture, int set,
                   const tinygltf::ExtensionMap& extensions) {
    if (texture < 0) return;
    const TexturePlace place = place_of(set, extensions);
    use.texture = texture;
    std::copy(std::begin(place.matrix), std::end(place.matrix), use.matrix);
    set_wanted = place.set;
}

Colour emissive_factor(const tinygltf::Material& source) {
    Colour factor{0, 0, 0, 1};
    double strength = 1;
    if (const tinygltf::Value* extension = extension_of(source, "KHR_materials_emissive_strength"))
        strength = std::max(number_in(*extension, "emissiveStrength", 1), 0.0);
    if (source.emissiveFactor.size() == 3)
        for (std::size_t i = 0; i < 3; ++i)
            factor[i] = static_cast<float>(std::max(source.emissiveFactor[i], 0.0) * strength);
    return factor;
}

// Light of its own is added after the texture: in a unit of its own, unless there is no texture.
void set_emission(Surface& surface, const tinygltf::Material& source, Textures& textures) {
    const Colour factor = emissive_factor(source);
    if (surface.material.unlit || (factor[0] <= 0 && factor[1] <= 0 && factor[2] <= 0)) return;
    const tinygltf::TextureInfo& info = source.emissiveTexture;
    place_texture(surface.material.emissive, surface.emissive_set, textures.find(info.index, true, factor),
                  info.texCoord, info.extensions);
    if (surface.material.emissive.texture >= 0) return;
    if (surface.material.base.texture >= 0) {
        surface.material.emissive.texture = textures.plain(factor);
    } else {
        std::copy(factor.begin(), factor.begin() + 3, surface.material.emission);
    }
}

}  // namespace

Surface Materials::make(const tinygltf::Material& source) {
    Surface surface;
    Material& material = surface.material;
    material.unlit = extension_of(source, "KHR_materials_unlit") != nullptr;
    material.double_sided = source.doubleSided;
    material.blended = source.alphaMode == "BLEND";
    const bool masked = source.alphaMode == "MASK";
    if (!material.blended && !masked && source.alphaMode != "OPAQUE")
        m_notes.add("an alpha mode " + source.alphaMode + " is taken for OPAQUE");
    if (masked) material.alpha_cutoff = static_cast<float>(source.alphaCutoff);
    surface.invisible = material.alpha_cutoff > 1;
    if (source.normalTexture.index >= 0) m_notes.add("normal maps are ignored");
    if (source.occlusionTexture.index >= 0) m_notes.add("occlusion maps are ignored");

    tinygltf::ExtensionMap place;
    const tinygltf::Value* older = extension_of(source, "KHR_materials_pbrSpecularGlossiness");
    const Surfacing surfacing = older ? specular_glossiness(*older, place)
                                      : metallic_roughness(source.pbrMetallicRoughness, m_textures);
    set_colours(material, surfacing);
    const bool opaque = !material.blended && !masked;
    place_texture(material.base, surface.base_set, m_textures.find(surfacing.texture, opaque), surfacing.set,
                  *surfacing.place);
    set_emission(surface, source, m_textures);
    return surface;
}

int Materials::find(int index) {
    const std::vector<tinygltf::Material>& materials = m_document.file.materials;
    if (const auto known = m_known.find(index); known != m_known.end()) return known->second;
    const bool is_there = index >= 0 && index < static_cast<int>(materials.size());
    if (!is_there && index >= 0)
        m_notes.add("there is no material " + std::to_string(index) + "; the default one is in its place");
    m_surfaces.push_back(make(is_there ? materials[static_cast<std::size_t>(index)] : tinygltf::Material()));
    return m_known[index] = static_cast<int>(m_surfaces.size()) - 1;
}

std::vector<Material> Materials::take() const {
    std::vector<Material> materials;
    for (const Surface& surface : m_surfaces) materials.push_back(surface.material);
    return materials;
}

}  // namespace terrazzo::gltf
