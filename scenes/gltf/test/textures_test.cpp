// Images and materials: alpha, smaller levels, samplers, what a surface becomes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model_files.h"

namespace terrazzo::gltf::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

json textured(const std::vector<std::uint8_t>& rgba, int width, int height, const char* alpha_mode) {
    json document = triangle();
    add_texture(document, png_of(rgba, width, height));
    document["materials"][0]["alphaMode"] = alpha_mode;
    return document;
}

TEST(Textures, ColoursAreNotMultipliedByAlpha) {
    const std::vector<std::uint8_t> pixels{200, 100, 50, 128, 10, 20, 30, 0};
    const Model model = load(textured(pixels, 2, 1, "BLEND")).model;
    EXPECT_EQ(model.textures.at(0).levels.at(0).rgba, pixels);
}

TEST(Textures, SmallerLevelsWeighColoursByAlpha) {
    // Red that is seen beside green that is not.
    const Model model =
        load(textured({255, 0, 0, 255, 0, 255, 0, 0, 255, 0, 0, 255, 0, 255, 0, 0}, 2, 2, "BLEND")).model;
    ASSERT_EQ(model.textures.at(0).levels.size(), 2U);
    EXPECT_THAT(model.textures[0].levels[1].rgba, ElementsAre(255, 0, 0, 128));
}

// A material without use for alpha sees colours that a picture has under an alpha of 0.
TEST(Textures, OpaqueMaterialsDoNotLookAtAlpha) {
    const Model model =
        load(textured({255, 0, 0, 255, 0, 255, 0, 0, 255, 0, 0, 255, 0, 255, 0, 0}, 2, 2, "OPAQUE")).model;
    EXPECT_THAT(model.textures.at(0).levels.at(1).rgba, ElementsAre(128, 128, 0, 255));
}

// Three pixels become one: each counts as much as the others. Five become two, which share the middle one.
TEST(Textures, SmallerLevelsOfOddSizesWeighByArea) {
    const Model three = load(textured({0, 0, 0, 255, 90, 0, 0, 255, 210, 0, 0, 255}, 3, 1, "OPAQUE")).model;
    EXPECT_EQ(three.textures.at(0).levels.at(1).rgba.at(0), 100);
    const Model five =
        load(textured({10, 0, 0, 255, 20, 0, 0, 255, 80, 0, 0, 255, 30, 0, 0, 255, 40, 0, 0, 255}, 5, 1,
                      "OPAQUE"))
            .model;
    EXPECT_EQ(five.textures.at(0).levels.at(1).rgba.at(0), 28);  // (10 + 20 + 80 / 2) / 2.5
    EXPECT_EQ(five.textures.at(0).levels.at(1).rgba.at(4), 44);
}

TEST(Textures, SamplersAreRead) {
    json document = textured({1, 2, 3, 255, 4, 5, 6, 255}, 2, 1, "OPAQUE");
    EXPECT_EQ(load(document).model.textures.at(0).min_filter, GL_LINEAR_MIPMAP_LINEAR);
    document["samplers"] = {{{"wrapS", 33648}, {"wrapT", 33071}, {"minFilter", 9728}, {"magFilter", 9728}}};
    document["textures"][0]["sampler"] = 0;
    const Texture texture = load(document).model.textures.at(0);
    EXPECT_EQ(texture.wrap_s, GL_MIRRORED_REPEAT);
    EXPECT_EQ(texture.wrap_t, GL_CLAMP_TO_EDGE);
    EXPECT_EQ(texture.min_filter, GL_NEAREST);
    EXPECT_EQ(texture.mag_filter, GL_NEAREST);
    EXPECT_EQ(texture.levels.size(), 1U);
}

TEST(Textures, WhatCannotBeReadIsLeftOut) {
    const auto with = [](auto change) {
        json document = textured({1, 2, 3, 255}, 1, 1, "OPAQUE");
        change(document);
        const LoadedModel loaded = load(document);
        EXPECT_EQ(loaded.model.materials.at(0).base.texture, -1);
        return notes_of(loaded);
    };
    EXPECT_THAT(with([](json& d) { d["textures"][0].erase("source"); }), HasSubstr("it has no image"));
    EXPECT_THAT(with([](json& d) { d["textures"][0]["source"] = 5; }), HasSubstr("no image 5"));
    EXPECT_THAT(with([](json& d) { d["textures"][0]["sampler"] = 5; }), HasSubstr("no sampler 5"));
    EXPECT_THAT(with([](json& d) {
                    d["images"][0] = {{"uri", "no-such.png"}};
                }),
                HasSubstr("there is no file"));
    EXPECT_THAT(with([](json& d) { d["images"][0] = 4; }), HasSubstr("neither a URI nor"));
    EXPECT_THAT(with([](json& d) { d["images"][0]["bufferView"] = 99; }), HasSubstr("no buffer view 99"));
    EXPECT_THAT(with([](json& d) {
                    d["images"][0] = {{"uri", data_uri("GIF89a....", 10)}};
                }),
                HasSubstr("neither PNG nor JPEG"));
    EXPECT_THAT(
        with([](json& d) { d["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 7; }),
        HasSubstr("no texture 7"));
}

TEST(Textures, AnImageThatSaysItIsHugeIsNotDecoded) {
    std::vector<unsigned char> png = png_of({1, 2, 3, 255}, 1, 1);
    // Width and height of the header, and its checksum: libpng ignores nothing there.
    const unsigned char header[] = {0x00, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0xFF, 0xFF, 8, 6, 0, 0, 0};
    std::copy(std::begin(header), std::end(header), png.begin() + 16);
    std::uint32_t checksum = ~0U;
    for (std::size_t i = 12; i < 29; ++i) {
        checksum ^= png[i];
        for (int bit = 0; bit < 8; ++bit) checksum = checksum >> 1 ^ (checksum & 1 ? 0xEDB88320U : 0U);
    }
    for (std::size_t i = 0; i < 4; ++i)
        png[29 + i] = static_cast<unsigned char>(~checksum >> (24 - 8 * i) & 0xFF);
    json document = triangle();
    add_texture(document, png);
    EXPECT_THAT(notes_of(load(document)), HasSubstr("it needs more than --max-pixels allows"));
}

TEST(Materials, BecomeWhatFixedFunctionKnows) {
    json document = triangle();
    document["materials"] = {
        {{"pbrMetallicRoughness",
          {{"baseColorFactor", {0.5, 1, 0, 0.5}}, {"metallicFactor", 0}, {"roughnessFactor", 1}}},
         {"emissiveFactor", {0, 0.25, 0}},
         {"alphaMode", "MASK"},
         {"alphaCutoff", 0.25},
         {"doubleSided", true}}};
    primitive_of(document)["material"] = 0;
    const Material material = load(document).model.materials.at(0);
    EXPECT_THAT(material.diffuse, ElementsAre(0.5, 1, 0, 0.5));
    EXPECT_THAT(material.specular, testing::Each(testing::FloatEq(0.15F * 0.6F)));
    EXPECT_THAT(material.emission, ElementsAre(0, 0.25, 0));
    EXPECT_EQ(material.alpha_cutoff, 0.25F);
    EXPECT_TRUE(material.double_sided);
    EXPECT_FALSE(material.blended);
    EXPECT_FALSE(material.metal);
    document["materials"][0]["extensions"]["KHR_materials_unlit"] = json::object();
    EXPECT_TRUE(load(document).model.materials.at(0).unlit);
    EXPECT_THAT(load(document).model.materials.at(0).emission, testing::Each(0));
    document["materials"][0]["alphaCutoff"] = 1.5;
    EXPECT_THAT(refusal_of(document), HasSubstr("nothing to draw"));
    document["materials"][0]["alphaMode"] = "BLEND";
    EXPECT_TRUE(load(document).model.materials.at(0).blended);
    EXPECT_EQ(load(document).model.materials.at(0).alpha_cutoff, 0);
}

TEST(Materials, EmissiveTexturesHaveTheirFactorInThem) {
    json document = textured({200, 100, 50, 128}, 1, 1, "BLEND");
    document["materials"][0]["emissiveFactor"] = {0.5, 1, 0};
    const Model plain = load(document).model;
    EXPECT_THAT(
        plain.textures.at(static_cast<std::size_t>(plain.materials.at(0).emissive.texture)).levels.at(0).rgba,
        ElementsAre(128, 255, 0, 255));
    document["materials"][0]["emissiveTexture"] = {{"index", 0}};
    const Model model = load(document).model;
    EXPECT_THAT(
        model.textures.at(static_cast<std::size_t>(model.materials.at(0).emissive.texture)).levels.at(0).rgba,
        ElementsAre(100, 100, 0, 255));
    document["materials"][0]["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", 2}};
    const Model strong = load(document).model;
    EXPECT_THAT(strong.textures.at(static_cast<std::size_t>(strong.materials.at(0).emissive.texture))
                    .levels.at(0)
                    .rgba,
                ElementsAre(200, 200, 0, 255));
}

TEST(Materials, MetalAndRoughnessOfATextureAreItsMean) {
    json document = textured({0, 255, 0, 255, 0, 51, 255, 255}, 2, 1, "OPAQUE");
    json& surface = document["materials"][0]["pbrMetallicRoughness"];
    surface["metallicRoughnessTexture"] = {{"index", 0}};
    surface["metallicFactor"] = 1;
    const Material material = load(document).model.materials.at(0);
    EXPECT_FLOAT_EQ(material.diffuse[0], 1 - 0.4F * 0.5F);
    EXPECT_NEAR(material.shininess, 4 + 110 * 0.4 * 0.4, 1e-4);
}

TEST(Materials, WhatIsIgnoredIsSaid) {
    json document = textured({1, 2, 3, 255}, 1, 1, "GLOW");
    document["materials"][0]["normalTexture"] = {{"index", 0}};
    document["materials"][0]["occlusionTexture"] = {{"index", 0}};
    const std::string notes = notes_of(load(document));
    EXPECT_THAT(notes, HasSubstr("normal maps are ignored"));
    EXPECT_THAT(notes, HasSubstr("occlusion maps are ignored"));
    EXPECT_THAT(notes, HasSubstr("alpha mode GLOW is taken for OPAQUE"));
}

}  // namespace
}  // namespace terrazzo::gltf::test
