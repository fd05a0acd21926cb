// Stage: models from files. A model as CBOR, so that the drawing child needs no loader and both libraries
// under comparison get the same arrays.
#include <cstring>
#include <nlohmann/json.hpp>

#include "model.h"

namespace terrazzo::gltf {
namespace {

using nlohmann::json;

template <typename T>
json blob(const std::vector<T>& values) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(values.data());
    return json::binary({bytes, bytes + values.size() * sizeof(T)});
}

template <typename T>
std::vector<T> unblob(const json& value) {
    const std::vector<std::uint8_t>& bytes = value.get_binary();
    std::vector<T> values(bytes.size() / sizeof(T));
    if (!values.empty()) std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
}

template <typename T, std::size_t Count>
void copy_array(const json& from, T (&to)[Count]) {
    for (std::size_t i = 0; i < Count; ++i) to[i] = from.at(i).get<T>();
}

json to_json(const Texture& texture) {
    json levels = json::array();
    for (const Level& level : texture.levels) levels.push_back({level.width, level.height, blob(level.rgba)});
    return {{"levels", levels},
            {"sampler", {texture.wrap_s, texture.wrap_t, texture.mag_filter, texture.min_filter}}};
}

Texture texture_of(const json& value) {
    Texture texture;
    for (const json& level : value.at("levels"))
        texture.levels.push_back({level.at(0), level.at(1), unblob<std::uint8_t>(level.at(2))});
    const json& sampler = value.at("sampler");
    texture.wrap_s = sampler.at(0);
    texture.wrap_t = sampler.at(1);
    texture.mag_filter = sampler.at(2);
    texture.min_filter = sampler.at(3);
    return texture;
}

json to_json(const Material& material) {
    return {{"diffuse", material.diffuse},   {"specular", material.specular},
            {"emission", material.emission}, {"shininess", material.shininess},
            {"texture", material.texture},   {"double_sided", material.double_sided},
            {"blended", material.blended},   {"alpha_cutoff", material.alpha_cutoff}};
}

Material material_of(const json& value) {
    Material material;
    copy_array(value.at("diffuse"), material.diffuse);
    copy_array(value.at("specular"), material.specular);
    copy_array(value.at("emission"), material.emission);
    material.shininess = value.at("shininess");
    material.texture = value.at("texture");
    material.double_sided = value.at("double_sided");
    material.blended = value.at("blended");
    material.alpha_cutoff = value.at("alpha_cutoff");
    return material;
}

json to_json(const Part& part) {
    return {{"mode", part.mode},
            {"material", part.material},
            {"matrix", part.matrix},
            {"mirrored", part.mirrored},
            {"positions", blob(part.positions)},
            {"normals", blob(part.normals)},
            {"textures", blob(part.textures)},
            {"colours", blob(part.colours)},
            {"indices", blob(part.indices)}};
}

Part part_of(const json& value) {
    Part part;
    part.mode = value.at("mode");
    part.material = value.at("material");
    copy_array(value.at("matrix"), part.matrix);
    part.mirrored = value.at("mirrored");
    part.positions = unblob<float>(value.at("positions"));
    part.normals = unblob<float>(value.at("normals"));
    part.textures = unblob<float>(value.at("textures"));
    part.colours = unblob<float>(value.at("colours"));
    part.indices = unblob<std::uint32_t>(value.at("indices"));
    return part;
}

}  // namespace

std::vector<std::uint8_t> pack(const Model& model) {
    json value{{"textures", json::array()},
               {"materials", json::array()},
               {"parts", json::array()},
               {"centre", model.centre},
               {"radius", model.radius}};
    for (const Texture& texture : model.textures) value["textures"].push_back(to_json(texture));
    for (const Material& material : model.materials) value["materials"].push_back(to_json(material));
    for (const Part& part : model.parts) value["parts"].push_back(to_json(part));
    return json::to_cbor(value);
}

Model unpack(std::span<const std::uint8_t> bytes) {
    const json value = json::from_cbor(bytes.begin(), bytes.end());
    Model model;
    for (const json& texture : value.at("textures")) model.textures.push_back(texture_of(texture));
    for (const json& material : value.at("materials")) model.materials.push_back(material_of(material));
    for (const json& part : value.at("parts")) model.parts.push_back(part_of(part));
    copy_array(value.at("centre"), model.centre);
    model.radius = value.at("radius");
    return model;
}

}  // namespace terrazzo::gltf
