// Model files good and bad: what is drawn, what is left out with a word, what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "model_files.h"

namespace terrazzo::gltf::test {
namespace {

using testing::HasSubstr;

TEST(LoadModel, OneTriangleGetsFlatNormalsBoundsAndItsMatrix) {
    json document = triangle();
    document["nodes"][0].update({{"translation", {2, 0, 0}}, {"scale", {1, 2, 1}}});
    const LoadedModel loaded = load(document);
    const Model& model = loaded.model;
    ASSERT_EQ(model.parts.size(), 1U);
    const Geometry& geometry = model.geometries.at(0);
    EXPECT_EQ(geometry.mode, GL_TRIANGLES);
    EXPECT_EQ(geometry.indices, (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(geometry.normals, (std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}));
    EXPECT_EQ(model.parts[0].matrix[12], 2);
    EXPECT_EQ(model.parts[0].matrix[5], 2);
    EXPECT_FALSE(model.parts[0].mirrored);
    EXPECT_FLOAT_EQ(model.centre[0], 2.5F);
    EXPECT_FLOAT_EQ(model.centre[1], 1);
    EXPECT_EQ(notes_of(loaded), "");
}

TEST(LoadModel, NegativeScaleTurnsTheWinding) {
    json document = triangle();
    document["nodes"][0]["scale"] = {-1, 2, 1};
    EXPECT_TRUE(load(document).model.parts[0].mirrored);
}

TEST(LoadModel, PackedModelsComeBackWhole) {
    json document = triangle();
    add_texture(document, png_of({255, 0, 0, 255}, 1, 1));
    document["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.5}}}}};
    document["nodes"][0]["camera"] = 0;
    const Model model = load(document).model;
    const Model copy = unpack(pack(model));
    ASSERT_EQ(copy.parts.size(), 1U);
    EXPECT_EQ(copy.geometries.at(0).positions, model.geometries.at(0).positions);
    EXPECT_EQ(copy.geometries.at(0).indices, model.geometries.at(0).indices);
    EXPECT_EQ(copy.materials.size(), model.materials.size());
    EXPECT_EQ(copy.textures.at(0).levels.at(0).rgba, model.textures.at(0).levels.at(0).rgba);
    EXPECT_EQ(copy.cameras.at(0).near_plane, 0.5F);
    EXPECT_EQ(copy.radius, model.radius);
    EXPECT_ANY_THROW(unpack(std::vector<std::uint8_t>{1, 2, 3}));
}

TEST(LoadModel, BinaryFilesAreKnownByTheirContent) {
    json document = triangle();
    const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    document["buffers"][0] = {{"byteLength", sizeof positions}};
    const std::string bytes =
        binary_file(document, std::string(reinterpret_cast<const char*>(positions), sizeof positions));
    for (const char* extension : {".glb", ".GLB", ".gltf", ""})
        EXPECT_EQ(load_model(File(bytes, extension).path()).model.parts.size(), 1U) << extension;
}

TEST(LoadModel, WhatIsNotAFileOfGltf2IsRefusedInWords) {
    EXPECT_THAT(refusal_of_file("/no/such/model.gltf"), HasSubstr("there is no file"));
    EXPECT_THAT(refusal_of_file("/dev/zero"), HasSubstr("there is no file"));
    EXPECT_THAT(refusal_of_file("/tmp"), HasSubstr("there is no file"));
    for (const char* text : {"", "{", "[]", "null", "{\"asset\": 3}", "{\"asset\": {\"version\": []}}"})
        EXPECT_THAT(refusal_of_file(File(std::string(text)).path()), HasSubstr("not glTF")) << text;
    EXPECT_THAT(refusal_of_file(File(std::string("glTF")).path()), HasSubstr("ends within its header"));
    json document = triangle();
    document["asset"]["version"] = "1.0";
    EXPECT_THAT(refusal_of(document), HasSubstr("glTF 1.0; only 2.x"));
    EXPECT_THAT(refusal_of_file(File(std::string(100'000, '[')).path()), HasSubstr("nested too deeply"));
}

TEST(LoadModel, ARequiredExtensionThatIsNotThereIsNamed) {
    json document = triangle();
    document["extensionsUsed"] = {"EXT_beauty", "KHR_materials_unlit"};
    EXPECT_THAT(notes_of(load(document)), HasSubstr("ignored: EXT_beauty\n"));
    document["extensionsRequired"] = {"KHR_materials_unlit"};
    EXPECT_EQ(refusal_of(document), "");
    document["extensionsRequired"] = {"KHR_materials_unlit", "EXT_beauty"};
    EXPECT_THAT(refusal_of(document), HasSubstr("requires EXT_beauty, which is not there"));
}

// Forty nodes, each the child of the one before, twice: 2^40 ways to the last.
TEST(LoadModel, NodesThatAreNoTreesAreRefused) {
    json twice = triangle();
    for (int node = 1; node <= 40; ++node) {
        twice["nodes"].push_back({{"mesh", 0}});
        twice["nodes"][static_cast<std::size_t>(node) - 1]["children"] = {node, node};
    }
    EXPECT_THAT(refusal_of(twice), HasSubstr("form trees"));
    json circle = triangle();
    circle["nodes"][0]["children"] = {1};
    circle["nodes"].push_back({{"children", {0}}});
    EXPECT_THAT(refusal_of(circle), HasSubstr("form trees"));
    json root_and_child = triangle();
    root_and_child["nodes"].push_back({{"children", {0}}});
    root_and_child["scenes"][0]["nodes"] = {0, 1};
    EXPECT_THAT(refusal_of(root_and_child), HasSubstr("form trees"));
    json root_twice = triangle();
    root_twice["scenes"][0]["nodes"] = {0, 0};
    EXPECT_THAT(refusal_of(root_twice), HasSubstr("form trees"));
}

TEST(LoadModel, NodesMayNestAsDeeplyAsTheyLike) {
    json document = triangle();
    constexpr int kDepth = 20'000;
    for (int node = 1; node <= kDepth; ++node) {
        document["nodes"].push_back({{"translation", {0, 0, 1}}});
        document["nodes"][static_cast<std::size_t>(node) - 1]["children"] = {node};
    }
    document["nodes"][kDepth]["mesh"] = 0;
    document["nodes"][0].erase("mesh");
    EXPECT_EQ(load(document).model.parts.at(0).matrix[14], kDepth);
}

TEST(LoadModel, ScenesAreChosen) {
    json document = triangle();
    document["nodes"].push_back({{"mesh", 0}, {"translation", {5, 0, 0}}});
    document["scenes"].push_back({{"nodes", {1}}});
    EXPECT_EQ(load(document).model.parts.at(0).matrix[12], 0);
    LoadOptions options;
    options.scene = 1;
    EXPECT_EQ(load(document, options).model.parts.at(0).matrix[12], 5);
    document["scene"] = 1;
    EXPECT_EQ(load(document).model.parts.at(0).matrix[12], 5);
    options.scene = 2;
    EXPECT_THAT(refusal_of(document, options), HasSubstr("there is no scene 2"));
    document.erase("scene");
    document.erase("scenes");
    EXPECT_EQ(load(document).model.parts.size(), 2U);
}

// A file with one primitive: when that cannot be drawn, nothing can.
TEST(LoadModel, DamageToTheOnlyPrimitiveIsRefused) {
    const auto with = [](auto change) {
        json document = triangle();
        change(document);
        return refusal_of(document);
    };
    EXPECT_THAT(with([](json& d) { d["accessors"][0]["count"] = 4; }), HasSubstr("not within"));
    EXPECT_THAT(with([](json& d) { d["accessors"][1]["count"] = 3000000000U; }), HasSubstr("--max-vertices"));
    EXPECT_THAT(with([](json& d) { d["accessors"][0]["byteOffset"] = -4; }), HasSubstr("byteOffset"));
    EXPECT_THAT(with([](json& d) { d["accessors"][0]["byteOffset"] = 1ULL << 63; }), HasSubstr("not within"));
    EXPECT_THAT(with([](json& d) { d["accessors"][0]["byteOffset"] = ~0ULL - 3; }), HasSubstr("not within"));
    EXPECT_THAT(with([](json& d) { d["accessors"][0]["bufferView"] = 4294967296U; }),
                HasSubstr("bufferView"));
    EXPECT_THAT(with([](json& d) { d["accessors"][0]["bufferView"] = "a"; }), HasSubstr("bufferView"));
    EXPECT_THAT(with([](json& d) { d["bufferViews"][0]["byteStride"] = 7; }), HasSubstr("byteStride"));
    EXPECT_THAT(with([](json& d) { d["bufferViews"][0]["byteLength"] = ~0ULL; }), HasSubstr("not within"));
    EXPECT_THAT(with([](json& d) { d["bufferViews"][0]["buffer"] = 9; }), HasSubstr("no buffer 9"));
    EXPECT_THAT(with([](json& d) { d["buffers"][0]["uri"] = "no/such/file.bin"; }), HasSubstr("no file"));
    EXPECT_THAT(with([](json& d) { d["buffers"][0].erase("uri"); }), HasSubstr("neither a URI"));
    EXPECT_THAT(with([](json& d) { d["nodes"][0]["mesh"] = 5; }), HasSubstr("no mesh 5"));
    EXPECT_THAT(with([](json& d) { d["scenes"][0]["nodes"] = {3}; }), HasSubstr("nothing to draw"));
    EXPECT_THAT(with([](json& d) { d["scene"] = 7; }), HasSubstr("no scene 7"));
    EXPECT_THAT(with([](json& d) { primitive_of(d)["attributes"]["POSITION"] = 9; }),
                HasSubstr("accessor 9"));
    EXPECT_THAT(with([](json& d) { primitive_of(d)["indices"] = 9; }), HasSubstr("indices are not there"));
    EXPECT_THAT(with([](json& d) { primitive_of(d)["mode"] = 9; }), HasSubstr("unknown mode"));
    EXPECT_THAT(with([](json& d) {
                    primitive_of(d)["indices"] = add_accessor(d, std::vector<std::uint16_t>{9}, "SCALAR");
                }),
                HasSubstr("beyond the vertices"));
    EXPECT_THAT(with([](json& d) { d["scenes"][0]["nodes"] = 0; }), HasSubstr("scenes[0] is ignored"));
    EXPECT_THAT(with([](json& d) { d["meshes"] = 3; }), HasSubstr("meshes is not a list"));
    EXPECT_THAT(with([](json& d) { d["nodes"][0]["scale"] = {1e300, 1e300, 1e300}; }), HasSubstr("finite"));
    const std::vector<float> endless{0, 0, 0, INFINITY, 0, 0, 0, 1, 0};
    EXPECT_THAT(
        with([&](json& d) { primitive_of(d)["attributes"]["POSITION"] = add_accessor(d, endless, "VEC3"); }),
        HasSubstr("not finite"));
}

// Beside damage the rest is drawn, and a sentence says what is missing.
TEST(LoadModel, OddPartsAreLeftOutWithANote) {
    const auto with = [](auto change) {
        json document = triangle();
        change(document);
        const LoadedModel loaded = load(document);
        EXPECT_EQ(loaded.model.parts.size(), 1U);
        return notes_of(loaded);
    };
    EXPECT_THAT(with([](json& d) { d["images"] = {{{"uri", "no-such.png"}}}; }), "");
    EXPECT_THAT(with([](json& d) { d["textures"] = {json::object(), 3}; }), HasSubstr("textures[1]"));
    EXPECT_THAT(with([](json& d) { d["cameras"] = {{{"type", "pinhole"}}}; }), HasSubstr("cameras[0]"));
    EXPECT_THAT(with([](json& d) {
                    d["materials"] = {{{"emissiveFactor", {1, 1}}}};
                }),
                HasSubstr("materials[0]"));
    EXPECT_THAT(with([](json& d) {
                    d["bufferViews"].push_back({{"byteStride", 999}});
                }),
                HasSubstr("bufferViews[2]"));
    EXPECT_THAT(with([](json& d) { d["accessors"].push_back({{"sparse", 3}}); }), HasSubstr("accessors[2]"));
    EXPECT_THAT(with([](json& d) {
                    d["buffers"].push_back({{"byteLength", 4}, {"uri", "gone.bin"}});
                }),
                HasSubstr("buffers[2] is not there: there is no file"));
    EXPECT_THAT(with([](json& d) { primitive_of(d)["material"] = 4; }), HasSubstr("no material 4"));
    EXPECT_THAT(with([](json& d) { primitive_of(d)["attributes"]["NORMAL"] = 9; }),
                HasSubstr("NORMAL is ignored"));
    EXPECT_THAT(with([](json& d) { d["nodes"].push_back({{"rotation", {1, 2}}}); }), HasSubstr("nodes[1]"));
    EXPECT_THAT(with([](json& d) { d["nodes"][0]["children"] = {8}; }), HasSubstr("not there"));
    EXPECT_THAT(with([](json& d) { d["animations"] = {{{"channels", 3}}}; }), HasSubstr("not played"));
    EXPECT_THAT(
        with([](json& d) {
            d["meshes"][0]["primitives"].push_back({{"indices", 77}, {"attributes", {{"POSITION", 0}}}});
        }),
        HasSubstr("indices are not there"));
    json many = triangle();
    for (int i = 0; i < 100; ++i) many["textures"].push_back(i);
    EXPECT_THAT(notes_of(load(many)), HasSubstr("and 84 more like these"));
}

TEST(LoadModel, LimitsHold) {
    json document = triangle();
    add_texture(document, png_of(std::vector<std::uint8_t>(200 * 100 * 4, 255), 200, 100));
    LoadOptions options;
    options.limits.pixels = 20'000;
    EXPECT_EQ(load(document, options).model.textures.size(), 1U);
    options.limits.pixels = 19'999;
    EXPECT_THAT(notes_of(load(document, options)), HasSubstr("--max-pixels"));
    options.limits.vertices = 2;
    EXPECT_THAT(refusal_of(document, options), HasSubstr("--max-vertices"));
    options = {};
    options.limits.bytes = 100;
    EXPECT_THAT(refusal_of(document, options), HasSubstr("--max-bytes"));
}

// A mesh drawn from many places is kept once.
TEST(LoadModel, PlacesShareTheirGeometry) {
    json document = triangle();
    for (int i = 1; i < 1000; ++i) {
        document["nodes"].push_back({{"mesh", 0}, {"translation", {i, 0, 0}}});
        document["scenes"][0]["nodes"].push_back(i);
    }
    const Model model = load(document).model;
    EXPECT_EQ(model.parts.size(), 1000U);
    EXPECT_EQ(model.geometries.size(), 1U);
}

TEST(LoadModel, CamerasLookFromTheirNodes) {
    json document = triangle();
    document["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.5}}}},
        {{"type", "orthographic"}, {"orthographic", {{"xmag", 2}, {"ymag", 3}, {"znear", 0}, {"zfar", 9}}}},
        {{"type", "perspective"}, {"perspective", {{"yfov", 9.0}, {"znear", 0.5}}}}};
    document["nodes"][0]["children"] = {1, 2, 3};
    document["nodes"][0]["translation"] = {1, 0, 0};
    document["nodes"].push_back({{"camera", 0}, {"translation", {0, 0, 7}}, {"scale", {2, 2, 2}}});
    document["nodes"].push_back({{"camera", 1}, {"name", "above"}});
    document["nodes"].push_back({{"camera", 2}});
    const LoadedModel loaded = load(document);
    ASSERT_EQ(loaded.model.cameras.size(), 2U);
    const Camera& first = loaded.model.cameras[0];
    EXPECT_TRUE(first.perspective);
    EXPECT_EQ(first.far_plane, 0);
    EXPECT_EQ((std::vector<float>(first.view, first.view + 16)),
              (std::vector<float>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, -7, 1}));
    EXPECT_EQ(loaded.model.cameras[1].name, "above");
    EXPECT_EQ(loaded.model.cameras[1].half_size[1], 3);
    EXPECT_THAT(notes_of(loaded), HasSubstr("the camera of nodes[3] sees nothing"));
    EXPECT_THROW(create_drawing(loaded.model, 2), std::runtime_error);
}

}  // namespace
}  // namespace terrazzo::gltf::test
