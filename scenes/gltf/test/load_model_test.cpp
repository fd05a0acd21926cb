// Model files good and bad: what is drawn, and that damage is refused in words.
#include "load_model.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace terrazzo::gltf {
namespace {

namespace fs = std::filesystem;

// A glTF file with one triangle, its buffer inside; `change` replaces parts of the text.
class ModelFile {
  public:
    explicit ModelFile(const std::string& from = "", const std::string& to = "") {
        std::string text = kTriangle;
        if (const std::size_t place = text.find(from); !from.empty() && place != std::string::npos)
            text.replace(place, from.size(), to);
        m_path = fs::temp_directory_path() /
                 ("terrazzo-model-" + std::to_string(++s_count) + "-" + std::to_string(getpid()) + ".gltf");
        std::ofstream(m_path) << text;
    }
    ~ModelFile() { fs::remove(m_path); }
    ModelFile(const ModelFile&) = delete;
    ModelFile& operator=(const ModelFile&) = delete;
    std::string path() const { return m_path.string(); }

  private:
    // Positions (0,0,0) (1,0,0) (0,1,0) as floats, then indices 0 1 2 as shorts.
    static constexpr const char* kTriangle = R"({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "translation": [2, 0, 0], "scale": [1, 2, 1]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
        "buffers": [{"byteLength": 42, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAABAAIA"}]
    })";
    static inline int s_count = 0;
    fs::path m_path;
};

TEST(LoadModel, OneTriangleGetsFlatNormalsBoundsAndItsMatrix) {
    const Model model = load_model(ModelFile().path());
    ASSERT_EQ(model.parts.size(), 1U);
    const Part& part = model.parts[0];
    EXPECT_EQ(part.mode, GL_TRIANGLES);
    EXPECT_EQ(part.indices, (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(part.normals, (std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}));
    EXPECT_EQ(part.matrix[12], 2);
    EXPECT_EQ(part.matrix[5], 2);
    EXPECT_FALSE(part.mirrored);
    EXPECT_FLOAT_EQ(model.centre[0], 2.5F);
    EXPECT_FLOAT_EQ(model.centre[1], 1);
}

TEST(LoadModel, NegativeScaleTurnsTheWinding) {
    EXPECT_TRUE(load_model(ModelFile("[1, 2, 1]", "[-1, 2, 1]").path()).parts[0].mirrored);
}

TEST(LoadModel, PackedModelsComeBackWhole) {
    const Model model = load_model(ModelFile().path());
    const Model copy = unpack(pack(model));
    EXPECT_EQ(copy.parts[0].positions, model.parts[0].positions);
    EXPECT_EQ(copy.parts[0].indices, model.parts[0].indices);
    EXPECT_EQ(copy.materials.size(), model.materials.size());
    EXPECT_EQ(copy.radius, model.radius);
    EXPECT_ANY_THROW(unpack(std::vector<std::uint8_t>{1, 2, 3}));
}

TEST(LoadModel, DamageIsRefused) {
    const char* const damages[][2] = {
        {"\"count\": 3, \"type\": \"VEC3\"", "\"count\": 4, \"type\": \"VEC3\""},
        {"\"count\": 3, \"type\": \"SCALAR\"", "\"count\": 3000000000, \"type\": \"SCALAR\""},
        {"AAABAAIA", "AAABAAkA"},
        {"\"mesh\": 0", "\"mesh\": 5"},
        {"\"nodes\": [0]}", "\"nodes\": [3]}"},
        {"\"mesh\": 0,", "\"mesh\": 0, \"children\": [0],"},
        {"\"POSITION\": 0", "\"POSITION\": 9"},
        {"\"indices\": 1", "\"indices\": 1, \"material\": 4"},
        {"\"indices\": 1", "\"indices\": 1, \"mode\": 9"},
        {"\"asset\"", "\"asset"},
    };
    for (const auto& [from, to] : damages)
        EXPECT_THROW(load_model(ModelFile(from, to).path()), std::runtime_error) << to;
    EXPECT_THROW(load_model("/no/such/model.gltf"), std::runtime_error);
}

}  // namespace
}  // namespace terrazzo::gltf
