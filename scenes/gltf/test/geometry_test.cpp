// Accessors of every kind, morph targets, skins, flat normals.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "model_files.h"

namespace terrazzo::gltf::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Geometry geometry_of(const json& document) {
    const LoadedModel loaded = load(document);
    EXPECT_EQ(notes_of(loaded), "");
    return loaded.model.geometries.at(0);
}

TEST(Accessors, SparseOnesReplaceValuesAndZeros) {
    json document = triangle();
    json sparse{
        {"count", 1},
        {"indices",
         {{"bufferView", add_view(document, std::vector<std::uint16_t>{1})}, {"componentType", 5123}}},
        {"values", {{"bufferView", add_view(document, std::vector<float>{5, 6, 7})}}}};
    document["accessors"][0]["sparse"] = sparse;
    EXPECT_THAT(geometry_of(document).positions, ElementsAre(0, 0, 0, 5, 6, 7, 0, 1, 0));
    document["accessors"][0].erase("bufferView");
    EXPECT_THAT(geometry_of(document).positions, ElementsAre(0, 0, 0, 5, 6, 7, 0, 0, 0));
    document["accessors"][0]["sparse"]["indices"]["bufferView"] =
        add_view(document, std::vector<std::uint16_t>{3});
    EXPECT_THAT(refusal_of(document), HasSubstr("an element that it does not have"));
    document["accessors"][0]["sparse"] = sparse;
    for (const char* part : {"indices", "values"}) {
        json broken = document;
        broken["accessors"][0]["sparse"][part]["byteOffset"] = 2'000'000'000;
        EXPECT_THAT(refusal_of(broken), HasSubstr("not within")) << part;
        broken["accessors"][0]["sparse"].erase(part);
        EXPECT_THAT(refusal_of(broken), HasSubstr("sparse part is not complete")) << part;
    }
}

// Indices without a view are all 0, also sparse ones.
TEST(Accessors, IndicesMayHaveNoView) {
    json document = triangle();
    json& indices = document["accessors"][1];
    indices.erase("bufferView");
    EXPECT_THAT(geometry_of(document).positions, ElementsAre(0, 0, 0, 0, 0, 0, 0, 0, 0));
    indices["sparse"] = {
        {"count", 2},
        {"indices",
         {{"bufferView", add_view(document, std::vector<std::uint16_t>{1, 2})}, {"componentType", 5123}}},
        {"values", {{"bufferView", add_view(document, std::vector<std::uint16_t>{2, 1})}}}};
    EXPECT_THAT(geometry_of(document).positions, ElementsAre(0, 0, 0, 0, 1, 0, 1, 0, 0));
}

TEST(Accessors, EveryComponentTypeAndStride) {
    struct {
        std::vector<std::uint8_t> bytes;  // of one coordinate pair
        int type;
        float first, second;
    } const cases[] = {{{255, 51}, 5121, 1, 0.2F},        {{129, 127}, 5120, -1, 1},
                       {{128, 0}, 5120, -1, 0},           {{255, 255, 0, 0}, 5123, 1, 0},
                       {{0, 128, 255, 127}, 5122, -1, 1}, {{0, 0, 128, 63, 0, 0, 0, 192}, 5126, 1, -2}};
    for (const auto& [bytes, type, first, second] : cases)
        for (const std::size_t stride : {std::size_t{12}, std::size_t{20}}) {
            json document = triangle();
            add_texture(document, png_of({1, 2, 3, 255}, 1, 1));
            std::vector<std::uint8_t> data(4, 77);
            for (int i = 0; i < 3; ++i) {
                data.insert(data.end(), bytes.begin(), bytes.end());
                if (i < 2) data.resize(data.size() + stride - bytes.size());
            }
            const int view = add_view(document, data);
            document["bufferViews"][static_cast<std::size_t>(view)]["byteStride"] = stride;
            const int accessor = primitive_of(document)["attributes"]["TEXCOORD_0"];
            document["accessors"][static_cast<std::size_t>(accessor)] = {
                {"bufferView", view}, {"byteOffset", 4}, {"componentType", type},
                {"count", 3},         {"type", "VEC2"},  {"normalized", type != 5126}};
            EXPECT_THAT(geometry_of(document).base_coordinates,
                        ElementsAre(first, second, first, second, first, second))
                << type;
        }
}

TEST(Accessors, ColoursOfThreeComponentsAreOpaqueAndTakeTheFactor) {
    json document = triangle();
    document["materials"] = {
        {{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.25, 1, 0.5}}, {"metallicFactor", 0}}}}};
    primitive_of(document)["material"] = 0;
    primitive_of(document)["attributes"]["COLOR_0"] =
        add_accessor(document, std::vector<float>(9, 1), "VEC3");
    const std::vector<float> colours = geometry_of(document).colours;
    EXPECT_THAT(std::vector<float>(colours.begin(), colours.begin() + 4), ElementsAre(0.5, 0.25, 1, 0.5));
}

TEST(Geometry, TheNamedSetOfCoordinatesIsTaken) {
    json document = triangle();
    add_texture(document, png_of({1, 2, 3, 255}, 1, 1));
    primitive_of(document)["attributes"]["TEXCOORD_1"] =
        add_accessor(document, std::vector<float>{.5, .5, .5, .5, .5, .5}, "VEC2");
    json& texture = document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
    texture["texCoord"] = 1;
    EXPECT_THAT(geometry_of(document).base_coordinates, testing::Each(0.5F));
    // The extension has the last word.
    texture["extensions"]["KHR_texture_transform"] = {{"texCoord", 0}};
    EXPECT_THAT(geometry_of(document).base_coordinates, ElementsAre(0, 0, 1, 0, 0, 1));
    texture["extensions"]["KHR_texture_transform"] = {{"texCoord", 2}};
    EXPECT_THAT(notes_of(load(document)), HasSubstr("has no TEXCOORD_2"));
}

TEST(Geometry, StripsAndFansWithoutNormalsAreFlat) {
    json document = triangle();
    json& primitive = primitive_of(document);
    primitive.erase("indices");
    // A square folded along its diagonal.
    primitive["attributes"]["POSITION"] =
        add_accessor(document, std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 1}, "VEC3");
    primitive["mode"] = GL_TRIANGLE_STRIP;
    const Geometry strip = geometry_of(document);
    EXPECT_EQ(strip.mode, GL_TRIANGLES);
    EXPECT_THAT(strip.positions, ElementsAre(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1, 0, 1, 0));
    const float third = 1 / std::sqrt(3.0F);
    EXPECT_THAT(std::vector<float>(strip.normals.begin(), strip.normals.begin() + 3), ElementsAre(0, 0, 1));
    EXPECT_THAT(std::vector<float>(strip.normals.begin() + 9, strip.normals.begin() + 12),
                ElementsAre(testing::FloatEq(-third), testing::FloatEq(-third), testing::FloatEq(third)));
    primitive["mode"] = GL_TRIANGLE_FAN;
    EXPECT_THAT(geometry_of(document).positions,
                ElementsAre(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 1, 1, 1));
    primitive["mode"] = GL_LINE_STRIP;
    EXPECT_TRUE(geometry_of(document).normals.empty());
}

TEST(Geometry, MorphTargetsHaveTheirDefaultWeights) {
    json document = triangle();
    const int shift = add_accessor(document, std::vector<float>{0, 0, 4, 0, 0, 4, 0, 0, 4}, "VEC3");
    primitive_of(document)["targets"] = {{{"POSITION", shift}}, {{"POSITION", shift}}};
    EXPECT_EQ(geometry_of(document).positions[2], 0);
    document["meshes"][0]["weights"] = {0.5, 0.25};
    EXPECT_EQ(geometry_of(document).positions[2], 3);
    document["nodes"][0]["weights"] = {0, 1};
    EXPECT_EQ(geometry_of(document).positions[2], 4);
    primitive_of(document)["targets"][1]["POSITION"] =
        add_accessor(document, std::vector<float>{1, 2, 3}, "VEC3");
    EXPECT_THAT(refusal_of(document), HasSubstr("morph target of another length"));
}

// Two joints, one moved up by 1, the other turned: a vertex in the middle gets half of each.
TEST(Geometry, SkinsPlaceTheirVerticesByJoints) {
    json document = triangle();
    json& attributes = primitive_of(document)["attributes"];
    attributes["NORMAL"] = add_accessor(document, std::vector<float>{0, 1, 0, 0, 1, 0, 0, 1, 0}, "VEC3");
    attributes["JOINTS_0"] =
        add_accessor(document, std::vector<std::uint16_t>{0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4");
    attributes["WEIGHTS_0"] =
        add_accessor(document, std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, .5, .5, 0, 0}, "VEC4");
    const std::vector<float> inverses(
        {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    document["skins"] = {
        {{"joints", {1, 2}}, {"inverseBindMatrices", add_accessor(document, inverses, "MAT4")}}};
    document["nodes"][0].update({{"skin", 0}, {"translation", {100, 0, 0}}});  // which a skin overrides
    const double half = std::sqrt(0.5);
    document["nodes"].push_back({{"translation", {0, 1, 0}}});
    document["nodes"].push_back({{"rotation", {0, 0, half, half}}});  // a quarter turn about z
    document["scenes"][0]["nodes"] = {0, 1, 2};
    const LoadedModel loaded = load(document);
    EXPECT_EQ(notes_of(loaded), "");
    EXPECT_EQ(loaded.model.parts.at(0).matrix[12], 0);
    const Geometry& geometry = loaded.model.geometries.at(0);
    const auto near = [](float value) { return testing::FloatNear(value, 1e-6F); };
    EXPECT_THAT(geometry.positions, ElementsAre(near(0), near(1), near(0), near(0), near(1), near(0),
                                                near(-0.5), near(1), near(0)));
    EXPECT_THAT(std::vector<float>(geometry.normals.begin() + 3, geometry.normals.begin() + 6),
                ElementsAre(near(-1), near(0), near(0)));
    attributes["JOINTS_0"] = add_accessor(document, std::vector<std::uint16_t>(12, 2), "VEC4");
    EXPECT_THAT(refusal_of(document), HasSubstr("a joint is beyond"));
}

}  // namespace
}  // namespace terrazzo::gltf::test
