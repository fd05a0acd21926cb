// Models as Terrazzo draws them: pixels that say what was done, and every glTF file of assimp-testmodels.
//
// usage: model_pictures_test TERRAZZO-DRAW LIBRARY
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "kit/child.h"
#include "kit/shared_bytes.h"
#include "model_files.h"

namespace terrazzo::gltf::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr int kSize = 64;
std::string s_draw_program, s_library;

using Pixel = std::array<int, 3>;

struct Picture {
    std::vector<std::uint8_t> rgba;  // rows from the bottom
    // Where the whole picture is 1 wide and high.
    Pixel at(double x, double y) const {
        const auto place = [](double part) { return static_cast<std::size_t>(part * kSize); };
        const std::uint8_t* pixel = &rgba[(place(y) * kSize + place(x)) * 4];
        return {pixel[0], pixel[1], pixel[2]};
    }
    std::size_t pixels_unlike(const Pixel& colour) const {
        std::size_t count = 0;
        for (std::size_t i = 0; i < rgba.size(); i += 4)
            count += rgba[i] != colour[0] || rgba[i + 1] != colour[1] || rgba[i + 2] != colour[2];
        return count;
    }
};

constexpr Pixel kBackground{41, 43, 51};

Picture draw(const Model& model, int camera) {
    const kit::SharedBytes packed(pack(model));
    kit::ChildRequest request;
    request.executable = s_draw_program;
    request.task = "draw";
    request.arguments = {{"library", s_library}, {"scene", "model"}, {"model", packed.path()},
                         {"camera", camera},     {"width", kSize},   {"height", kSize},
                         {"picture", true}};
    const kit::ChildReport report = kit::run_in_child(request);
    if (!report.finished()) throw std::runtime_error(report.message + report.output);
    EXPECT_TRUE(report.result["errors"].empty()) << report.result["errors"];
    return {report.result["colour"].get_binary()};
}

// Seen by a parallel camera whose picture is x and y from -1 to 1.
Picture draw(const json& document) {
    return draw(load(document).model, 0);
}

json empty_scene() {
    return {{"asset", {{"version", "2.0"}}},
            {"scenes", {{{"nodes", {0}}}}},
            {"nodes", {{{"camera", 0}, {"translation", {0, 0, 5}}}}},
            {"cameras",
             {{{"type", "orthographic"},
               {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0.1}, {"zfar", 10}}}}}}};
}

json unlit(const std::vector<double>& colour, const char* alpha_mode = "OPAQUE") {
    return {{"pbrMetallicRoughness", {{"baseColorFactor", colour}}},
            {"alphaMode", alpha_mode},
            {"extensions", {{"KHR_materials_unlit", json::object()}}}};
}

// A square that fills the picture, facing the camera, with coordinates from 0 to `repeat`, t downwards.
std::size_t add_square(json& document, const json& material, double z = 0, float repeat = 1) {
    document["materials"].push_back(material);
    const int positions =
        add_accessor(document, std::vector<float>{-1, -1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0}, "VEC3");
    const int coordinates =
        add_accessor(document, std::vector<float>{0, repeat, repeat, repeat, 0, 0, repeat, 0}, "VEC2");
    document["meshes"].push_back({{"primitives",
                                   {{{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", coordinates}}},
                                     {"mode", GL_TRIANGLE_STRIP},
                                     {"material", document["materials"].size() - 1}}}}});
    document["nodes"].push_back({{"mesh", document["meshes"].size() - 1}, {"translation", {0.0, 0.0, z}}});
    document["scenes"][0]["nodes"].push_back(document["nodes"].size() - 1);
    return document["nodes"].size() - 1;
}

// The material's base colour: an image of nearest texels.
void add_image(json& document, json& material, const std::vector<std::uint8_t>& rgba, int width, int height,
               int wrap_s = GL_REPEAT) {
    document["images"].push_back({{"bufferView", add_view(document, png_of(rgba, width, height))}});
    document["samplers"].push_back({{"minFilter", GL_NEAREST}, {"magFilter", GL_NEAREST}, {"wrapS", wrap_s}});
    document["textures"].push_back(
        {{"source", document["images"].size() - 1}, {"sampler", document["samplers"].size() - 1}});
    material["pbrMetallicRoughness"]["baseColorTexture"]["index"] = document["textures"].size() - 1;
}

MATCHER_P(IsNear, pixel, "") {
    for (std::size_t i = 0; i < 3; ++i)
        if (std::abs(arg[i] - pixel[i]) > 1) return false;
    return true;
}

TEST(ModelPictures, BlendedTexturesShowTheirOwnColours) {
    json document = empty_scene(), material = unlit({1, 1, 1, 1}, "BLEND");
    add_image(document, material, {200, 100, 0, 128, 255, 255, 255, 0}, 2, 1);
    add_square(document, material);
    const Picture picture = draw(document);
    const double part = 128 / 255.0;
    EXPECT_THAT(picture.at(0.25, 0.5), IsNear(Pixel{static_cast<int>(200 * part + 41 * (1 - part) + 0.5),
                                                    static_cast<int>(100 * part + 43 * (1 - part) + 0.5),
                                                    static_cast<int>(51 * (1 - part) + 0.5)}));
    EXPECT_EQ(picture.at(0.75, 0.5), kBackground);
}

// Red in front of green in front of blue, in any order of the file, the opaque one last as well.
TEST(ModelPictures, BlendedPartsAreDrawnBackToFrontAfterTheOthers) {
    struct {
        double z;
        json material;
    } const squares[] = {
        {2, unlit({1, 0, 0, 0.5}, "BLEND")}, {1, unlit({0, 1, 0, 0.5}, "BLEND")}, {0, unlit({0, 0, 1, 1})}};
    for (const auto& order : {std::array{0, 1, 2}, std::array{2, 1, 0}, std::array{1, 0, 2}}) {
        json document = empty_scene();
        for (const int i : order) add_square(document, squares[i].material, squares[i].z);
        EXPECT_THAT(draw(document).at(0.5, 0.5), IsNear(Pixel{128, 64, 64}));
    }
}

TEST(ModelPictures, VertexColoursFactorAndTextureAreMultiplied) {
    json document = empty_scene(), material = unlit({0.5, 1, 1, 1});
    add_image(document, material, {255, 128, 255, 255}, 1, 1);
    add_square(document, material);
    primitive_of(document)["attributes"]["COLOR_0"] =
        add_accessor(document, std::vector<float>{1, 1, .25, 1, 1, .25, 1, 1, .25, 1, 1, .25}, "VEC3");
    EXPECT_THAT(draw(document).at(0.5, 0.5), IsNear(Pixel{128, 128, 64}));
}

TEST(ModelPictures, OwnLightIsAddedToTheTexture) {
    json document = empty_scene(), material = unlit({0.3, 0.3, 0.3, 1});
    material.erase("extensions");
    material["pbrMetallicRoughness"].update({{"metallicFactor", 0}, {"roughnessFactor", 1}});
    add_image(document, material, {255, 0, 255, 255}, 1, 1);
    add_square(document, material);
    const Pixel before = draw(document).at(0.5, 0.5);
    EXPECT_LT(before[0], 200);
    document["materials"][0]["emissiveFactor"] = {0.1, 0.2, 0};
    const Pixel lit = draw(document).at(0.5, 0.5);
    EXPECT_NEAR(lit[0], before[0] + 25.5, 1.5);
    EXPECT_NEAR(lit[1], before[1] + 51, 1.5);
    EXPECT_NEAR(lit[2], before[2], 1);
}

TEST(ModelPictures, MasksCutAtTheirCutoff) {
    json document = empty_scene(), material = unlit({1, 1, 1, 1}, "MASK");
    add_image(document, material, {255, 0, 0, 120, 255, 0, 0, 140}, 2, 1);
    add_square(document, material);
    const Picture picture = draw(document);
    EXPECT_EQ(picture.at(0.25, 0.5), kBackground);
    EXPECT_EQ(picture.at(0.75, 0.5), (Pixel{255, 0, 0}));
}

TEST(ModelPictures, BackSidesAreDrawnOfDoubleSidedSurfacesOnly) {
    json document = empty_scene();
    const std::size_t node = add_square(document, unlit({1, 0, 0, 1}));
    EXPECT_EQ(draw(document).pixels_unlike({255, 0, 0}), 0U);
    document["nodes"][node]["scale"] = {-1, 1, 1};  // its front is still its front
    EXPECT_EQ(draw(document).pixels_unlike({255, 0, 0}), 0U);
    document["nodes"][node]["scale"] = {1, 1, 1};
    document["nodes"][node]["rotation"] = {0, 1, 0, 0};
    EXPECT_EQ(draw(document).pixels_unlike(kBackground), 0U);
    document["materials"][0]["doubleSided"] = true;
    EXPECT_EQ(draw(document).pixels_unlike({255, 0, 0}), 0U);
}

TEST(ModelPictures, MirroredTexturesTurnRoundEveryTime) {
    const Pixel red{255, 0, 0}, blue{0, 0, 255};
    for (const bool mirrored : {false, true}) {
        json document = empty_scene(), material = unlit({1, 1, 1, 1});
        add_image(document, material, {255, 0, 0, 255, 0, 0, 255, 255}, 2, 1,
                  mirrored ? GL_MIRRORED_REPEAT : GL_REPEAT);
        add_square(document, material, 0, 2);
        const Picture picture = draw(document);
        EXPECT_EQ(picture.at(0.1, 0.5), red);
        EXPECT_EQ(picture.at(0.4, 0.5), blue);
        EXPECT_EQ(picture.at(0.6, 0.5), mirrored ? blue : red);
        EXPECT_EQ(picture.at(0.9, 0.5), mirrored ? red : blue);
    }
}

// Of four texels in a square one is seen everywhere; turned by a quarter, counter-clockwise with t downwards.
TEST(ModelPictures, TextureTransformsScaleTurnAndShift) {
    const auto draw_with = [](const json& transform) {
        json document = empty_scene(), material = unlit({1, 1, 1, 1});
        add_image(document, material, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 9, 9, 9, 255}, 2, 2);
        material["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"] =
            transform;
        add_square(document, material);
        return draw(document);
    };
    const Pixel red{255, 0, 0}, green{0, 255, 0}, blue{0, 0, 255};
    EXPECT_EQ(draw_with(json::object()).at(0.25, 0.75), red);
    EXPECT_EQ(draw_with({{"scale", {0.5, 0.5}}}).pixels_unlike(red), 0U);
    EXPECT_EQ(draw_with({{"scale", {0.5, 0.5}}, {"offset", {0.5, 0}}}).pixels_unlike(green), 0U);
    const Picture turned = draw_with({{"rotation", std::acos(-1.0) / 2}, {"offset", {0, 1}}});
    EXPECT_EQ(turned.at(0.25, 0.75), blue);  // (s, t) -> (t, 1 - s)
    EXPECT_EQ(turned.at(0.25, 0.25), (Pixel{9, 9, 9}));
    EXPECT_EQ(turned.at(0.75, 0.75), red);
}

TEST(ModelPictures, PerspectiveCamerasWithAndWithoutAnEnd) {
    for (const bool endless : {false, true}) {
        json document = empty_scene();
        json lens{{"yfov", 2 * std::atan(0.4)}, {"znear", 0.1}};
        if (!endless) lens["zfar"] = 10;
        document["cameras"][0] = {{"type", "perspective"}, {"perspective", lens}};
        add_square(document, unlit({1, 0, 0, 1}));
        const Picture picture = draw(document);  // 5 away the picture is 4 wide
        EXPECT_EQ(picture.at(0.3, 0.3), (Pixel{255, 0, 0}));
        EXPECT_EQ(picture.at(0.2, 0.5), kBackground);
        EXPECT_EQ(picture.pixels_unlike(kBackground), static_cast<std::size_t>(kSize) * kSize / 4);
    }
}

// --- Debian's test models ---

std::vector<std::string> test_models() {
    std::vector<std::string> models;
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator("/usr/share/assimp/models", error)) {
        const std::string extension = entry.path().extension().string();
        if (extension == ".gltf" || extension == ".glb") models.push_back(entry.path().string());
    }
    std::sort(models.begin(), models.end());
    return models;
}

// Files that are damaged or of another version on purpose, and why nothing of them can be drawn.
std::string expected_refusal(const std::string& path) {
    const std::pair<const char*, const char*> kReasons[] = {
        {"/glTF/", "only "},
        {"/draco/", "requires KHR_draco_mesh_compression, which is not there"},
        {"techniqueWebGL", "requires KHR_technique_webgl, which is not there"},
        {"RecursiveNodes", "form trees"},
        {"TestNoRootNode", "nothing to draw"},
        {"BoxWithInfinites", "not finite"},
        {"IndexOutOfRange", "beyond the vertices"},
        {"MissingBin", "there is no file"},
        {"SchemaFailures", "there is no file"},
        {"badArray", "meshes[0] is ignored: primitives is not a list"},
    };
    for (const auto& [name, reason] : kReasons)
        if (path.find(name) != std::string::npos) return reason;
    return {};
}

TEST(TestModels, AreDrawnOrRefusedInWords) {
    const std::vector<std::string> models = test_models();
    if (models.empty()) GTEST_SKIP() << "assimp-testmodels is not installed";
    std::set<std::vector<std::uint8_t>> pictures;
    std::size_t drawn = 0;
    for (const std::string& path : models) {
        SCOPED_TRACE(path);
        const std::string reason = expected_refusal(path);
        if (!reason.empty()) {
            EXPECT_THAT(refusal_of_file(path), HasSubstr(reason));
            continue;
        }
        const Picture picture = draw(load_model(path).model, -1);
        EXPECT_GT(picture.pixels_unlike(kBackground), 20U);
        pictures.insert(picture.rgba);
        ++drawn;
    }
    EXPECT_GE(drawn, 35U);
    EXPECT_GT(pictures.size(), 12U);
}

}  // namespace
}  // namespace terrazzo::gltf::test

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    if (argc != 3) return 2;
    terrazzo::gltf::test::s_draw_program = argv[1];
    terrazzo::gltf::test::s_library = argv[2];
    return RUN_ALL_TESTS();
}
