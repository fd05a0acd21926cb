// Stage: models from files. A model as CBOR, so that the drawing child needs no loader and both libraries
// under comparison get the same arrays.
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <type_traits>

#include "model.h"

namespace terrazzo::gltf {
namespace {

using nlohmann::json;

// Reader and writer are one build, so that a list of plain structs goes as it lies in memory.
template <typename T>
json blob(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
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
    return {{"levels", std::move(levels)},
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

json to_json(const Geometry& geometry) {
    return {{"mode", geometry.mode},
            {"positions", blob(geometry.positions)},
            {"normals", blob(geometry.normals)},
            {"base_coordinates", blob(geometry.base_coordinates)},
            {"emissive_coordinates", blob(geometry.emissive_coordinates)},
            {"colours", blob(geometry.colours)},
            {"indices", blob(geometry.indices)}};
}

Geometry geometry_of(const json& value) {
    Geometry geometry;
    geometry.mode = value.at("mode");
    geometry.positions = unblob<float>(value.at("positions"));
    geometry.normals = unblob<float>(value.at("normals"));
    geometry.base_coordinates = unblob<float>(value.at("base_coordinates"));
    geometry.emissive_coordinates = unblob<float>(value.at("emissive_coordinates"));
    geometry.colours = unblob<float>(value.at("colours"));
    geometry.indices = unblob<std::uint32_t>(value.at("indices"));
    return geometry;
}

json to_json(const Camera& camera) {
    return {{"name", camera.name},
            {"view", camera.view},
            {"perspective", camera.perspective},
            {"field_of_view", camera.field_of_view},
            {"half_size", camera.half_size},
            {"planes", {camera.near_plane, camera.far_plane}}};
}

Camera camera_of(const json& value) {
    Camera camera;
    camera.name = value.at("name");
    copy_array(value.at("view"), camera.view);
    camera.perspective = value.at("perspective");
    camera.field_of_view = value.at("field_of_view");
    copy_array(value.at("half_size"), camera.half_size);
    camera.near_plane = value.at("planes").at(0);
    camera.far_plane = value.at("planes").at(1);
    return camera;
}

template <typename T>
json list_of(const std::vector<T>& values) {
    json list = json::array();
    for (const T& value : values) list.push_back(to_json(value));
    return list;
}

}  // namespace

std::vector<std::uint8_t> pack(const Model& model) {
    return json::to_cbor({{"textures", list_of(model.textures)},
                          {"materials", blob(model.materials)},
                          {"geometries", list_of(model.geometries)},
                          {"parts", blob(model.parts)},
                          {"cameras", list_of(model.cameras)},
                          {"centre", model.centre},
                          {"radius", model.radius}});
}

Model unpack(std::span<const std::uint8_t> bytes) {
    const json value = json::from_cbor(bytes.begin(), bytes.end());
    Model model;
    for (const json& texture : value.at("textures")) model.textures.push_back(texture_of(texture));
    model.materials = unblob<Material>(value.at("materials"));
    for (const json& geometry : value.at("geometries")) model.geometries.push_back(geometry_of(geometry));
    model.parts = unblob<Part>(value.at("parts"));
    for (const json& camera : value.at("cameras")) model.cameras.push_back(camera_of(camera));
    copy_array(value.at("centre"), model.centre);
    model.radius = value.at("radius");
    return model;
}

}  // namespace terrazzo::gltf
