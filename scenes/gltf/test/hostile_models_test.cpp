// Damaged and malicious models, made from small good ones and a seed: each is loaded in a child with limits
// of memory and time, which must end by itself, with a model whose invariants hold or with a sentence.
//
// TERRAZZO_MODEL_SEEDS: how many files of each kind (default 60); TERRAZZO_MODEL_SEED: the first seed.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>

#include "model_files.h"

namespace terrazzo::gltf::test {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kLimitsMemory = false;  // shadow memory takes more than any limit
#else
constexpr bool kLimitsMemory = true;
#endif
constexpr rlim_t kMostMemory = rlim_t{1} << 30;
constexpr rlim_t kMostSeconds = 10;

using Random = std::mt19937;

std::size_t below(Random& random, std::size_t end) {
    return end == 0 ? 0 : random() % end;
}

unsigned number_from(const char* name, unsigned otherwise) {
    const char* text = std::getenv(name);
    return text ? static_cast<unsigned>(std::strtoul(text, nullptr, 10)) : otherwise;
}

// --- what a loaded model promises ---

bool is_list(std::size_t size, std::size_t vertices, std::size_t width) {
    return size == 0 || size == vertices * width;
}

const char* broken_promise(const Model& model) {
    for (const Geometry& geometry : model.geometries) {
        const std::size_t vertices = geometry.positions.size() / 3;
        for (const std::uint32_t index : geometry.indices)
            if (index >= vertices) return "an index";
        if (!is_list(geometry.normals.size(), vertices, 3) ||
            !is_list(geometry.colours.size(), vertices, 4) ||
            !is_list(geometry.base_coordinates.size(), vertices, 2) ||
            !is_list(geometry.emissive_coordinates.size(), vertices, 2))
            return "a list's length";
        for (const float value : geometry.positions)
            if (!std::isfinite(value)) return "a position";
    }
    for (const Part& part : model.parts)
        if (part.geometry < 0 || static_cast<std::size_t>(part.geometry) >= model.geometries.size() ||
            part.material < 0 || static_cast<std::size_t>(part.material) >= model.materials.size())
            return "a part";
    for (const Material& material : model.materials)
        for (const int texture : {material.base.texture, material.emissive.texture})
            if (texture < -1 || texture >= static_cast<int>(model.textures.size())) return "a texture";
    for (const Texture& texture : model.textures)
        for (const Level& level : texture.levels)
            if (level.width < 1 || level.height < 1 ||
                level.rgba.size() !=
                    static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height) * 4)
                return "a level";
    return std::isfinite(model.radius) && model.radius > 0 ? nullptr : "the radius";
}

// Exit codes of the child.
enum { kDrawn = 0, kRefused = 1, kBroken = 3 };

int load_within_limits(const std::string& path) {
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        const rlimit memory{kMostMemory, kMostMemory}, seconds{kMostSeconds, kMostSeconds}, no_core{0, 0};
        setrlimit(RLIMIT_CORE, &no_core);
        setrlimit(RLIMIT_CPU, &seconds);
        if (kLimitsMemory) setrlimit(RLIMIT_AS, &memory);
        int code = kRefused;
        try {
            const LoadedModel loaded = load_model(path);
            if (const char* broken = broken_promise(loaded.model)) {
                std::fprintf(stderr, "broken: %s\n", broken);
                code = kBroken;
            } else {
                unpack(pack(loaded.model));
                code = kDrawn;
            }
        } catch (const std::bad_alloc&) {
            code = kRefused;  // of packing, which the command tells as a sentence
        } catch (const std::runtime_error& refusal) {
            code = std::string(refusal.what()).size() > path.size() + 2 ? kRefused : kBroken;
        }
        std::fflush(nullptr);
        _exit(code);
    }
    int status = 0;
    if (waitpid(child, &status, 0) != child) return -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

// --- good models ---

json rich_model() {
    json document = triangle();
    add_texture(document, png_of(std::vector<std::uint8_t>(8 * 8 * 4, 200), 8, 8));
    json& attributes = primitive_of(document)["attributes"];
    attributes["NORMAL"] = add_accessor(document, std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    attributes["COLOR_0"] = add_accessor(document, std::vector<float>(12, 0.5F), "VEC4");
    attributes["JOINTS_0"] = add_accessor(document, std::vector<std::uint16_t>(12, 0), "VEC4");
    attributes["WEIGHTS_0"] =
        add_accessor(document, std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
    primitive_of(document)["targets"] = {{{"POSITION", 0}}};
    document["meshes"][0]["weights"] = {0.5};
    document["skins"] = {{{"joints", {1}}}};
    document["nodes"][0]["skin"] = 0;
    document["nodes"].push_back({{"translation", {1, 2, 3}}, {"rotation", {0, 0, 0, 1}}, {"camera", 0}});
    document["nodes"].push_back({{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}, {"mesh", 0}});
    document["scenes"][0]["nodes"] = {0, 1, 2};
    document["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
    document["samplers"] = {{{"wrapS", 33648}, {"minFilter", 9987}}};
    document["textures"][0]["sampler"] = 0;
    document["accessors"][0]["sparse"] = {
        {"count", 1},
        {"indices",
         {{"bufferView", add_view(document, std::vector<std::uint16_t>{1})}, {"componentType", 5123}}},
        {"values", {{"bufferView", add_view(document, std::vector<float>{5, 6, 7})}}}};
    return document;
}

std::string binary_model() {
    json document = rich_model();
    const std::string uri = document["buffers"][0]["uri"];
    const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    document["buffers"][0] = {{"byteLength", sizeof positions}};
    return binary_file(document, std::string(reinterpret_cast<const char*>(positions), sizeof positions));
}

// --- damage ---

void damage_bytes(std::string& text, Random& random, std::size_t changes) {
    for (std::size_t i = 0; i < changes && !text.empty(); ++i) {
        const std::size_t place = below(random, text.size());
        switch (random() % 5) {
            case 0:
                text[place] = static_cast<char>(random());
                break;
            case 1:
                text[place] = static_cast<char>(text[place] ^ 1 << random() % 8);
                break;
            case 2:
                text.erase(place, 1 + below(random, 8));
                break;
            case 3:
                text.insert(place, text.substr(below(random, text.size()), below(random, 40)));
                break;
            default:
                for (std::size_t k = place; k < std::min(place + 4, text.size()); ++k)
                    text[k] = random() % 2 ? '\xFF' : '\0';
        }
    }
    if (random() % 8 == 0) text.resize(below(random, text.size() + 1));
}

json odd_value(Random& random) {
    const json kValues[] = {-1,
                            0,
                            1,
                            2,
                            3,
                            255,
                            65535,
                            2147483647,
                            2147483648U,
                            4294967295U,
                            4294967296ULL,
                            ~0ULL,
                            1ULL << 63,
                            -9e18,
                            1e300,
                            0.5,
                            nullptr,
                            true,
                            "",
                            "data:,",
                            "data:application/octet-stream;base64,%%%%",
                            json::array(),
                            json::object(),
                            {1, 2},
                            {{"a", 1}},
                            5121,
                            5123,
                            5125,
                            5126,
                            5130,
                            "VEC3",
                            "MAT4",
                            "SCALAR",
                            "BLEND",
                            "MASK"};
    return kValues[below(random, std::size(kValues))];
}

// Walks down to a random value.
json& random_value(json& value, Random& random) {
    json* place = &value;
    while (place->is_structured() && !place->empty() && (place == &value || random() % 6 != 0)) {
        auto child = place->begin();
        std::advance(child, static_cast<std::ptrdiff_t>(below(random, place->size())));
        place = &*child;
    }
    return *place;
}

void damage_values(json& document, Random& random) {
    for (std::size_t i = 0, count = 1 + below(random, 4); i < count; ++i) {
        json& value = random_value(document, random);
        if (random() % 5 == 0) {
            json copy = random_value(document, random);
            value = std::move(copy);
        } else {
            value = odd_value(random);
        }
        if (!document.is_object()) document = rich_model();
    }
}

class HostileModels : public testing::Test {
  protected:
    // Runs `make` for each seed; none may crash or last, and most kinds of damage leave something to draw.
    void expect_survival(const std::function<std::string(Random&)>& make, bool some_drawn = true) {
        const unsigned first = number_from("TERRAZZO_MODEL_SEED", 1),
                       count = number_from("TERRAZZO_MODEL_SEEDS", 60);
        unsigned drawn = 0, refused = 0;
        for (unsigned seed = first; seed < first + count; ++seed) {
            Random random(seed);
            const File file(make(random));
            const int code = load_within_limits(file.path());
            drawn += code == kDrawn;
            refused += code == kRefused;
            ASSERT_TRUE(code == kDrawn || code == kRefused)
                << "seed " << seed << ": code " << code << (code > 128 ? ", a signal" : "");
        }
        std::printf("%u drawn, %u refused, seeds from %u\n", drawn, refused, first);
        if (count < 60) return;
        EXPECT_GT(refused, 0U);
        if (some_drawn) {
            EXPECT_GT(drawn, 0U);
        }
    }
};

TEST_F(HostileModels, AreGoodBefore) {
    EXPECT_EQ(load_within_limits(File(rich_model()).path()), kDrawn);
    EXPECT_EQ(load_within_limits(File(binary_model()).path()), kDrawn);
    EXPECT_EQ(notes_of(load(rich_model())), "");
}

TEST_F(HostileModels, WithBytesChanged) {
    const std::string good = rich_model().dump();
    expect_survival([&](Random& random) {
        std::string text = good;
        damage_bytes(text, random, 1 + below(random, 4));
        return text;
    });
}

TEST_F(HostileModels, BinaryWithBytesChanged) {
    const std::string good = binary_model();
    expect_survival([&](Random& random) {
        std::string text = good;
        if (random() % 2) {  // within the headers
            text[below(random, 24)] = static_cast<char>(random());
        } else {
            damage_bytes(text, random, 1 + below(random, 4));
        }
        return text;
    });
}

TEST_F(HostileModels, WithValuesChanged) {
    expect_survival([](Random& random) {
        json document = rich_model();
        damage_values(document, random);
        return document.dump();
    });
}

TEST_F(HostileModels, WithImagesChanged) {
    expect_survival([](Random& random) {
        json document = triangle();
        std::vector<unsigned char> png = png_of(std::vector<std::uint8_t>(16 * 16 * 4, 99), 16, 16);
        std::string bytes(png.begin(), png.end());
        damage_bytes(bytes, random, 1 + below(random, 3));
        if (random() % 4 == 0) bytes.replace(0, 3, "\xFF\xD8\xFF");
        add_texture(document, {bytes.begin(), bytes.end()});
        if (random() % 4 == 0) document["accessors"][0]["count"] = odd_value(random);
        return document.dump();
    });
}

// --- what a mutation would not find ---

TEST_F(HostileModels, ThatAskForTooMuch) {
    const auto expect_end = [](const json& document, const char* what) {
        const int code = load_within_limits(File(document).path());
        EXPECT_TRUE(code == kDrawn || code == kRefused) << what << ": code " << code;
    };
    json zeros = triangle();
    for (json& accessor : zeros["accessors"]) {
        accessor.erase("bufferView");
        accessor["count"] = 3'000'000;
    }
    expect_end(zeros, "three million vertices that lie nowhere");

    json many = triangle();
    many["meshes"][0]["primitives"] = json::array();
    for (int i = 0; i < 1000; ++i)
        many["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}});
    for (int i = 1; i < 5000; ++i) {
        many["nodes"].push_back({{"mesh", 0}});
        many["scenes"][0]["nodes"].push_back(i);
    }
    expect_end(many, "five million parts");

    json targets = triangle();
    targets["accessors"][0].update({{"count", 1'000'000}});
    targets["accessors"][0].erase("bufferView");
    for (int i = 0; i < 20'000; ++i) {
        primitive_of(targets)["targets"].push_back({{"POSITION", 0}});
        targets["meshes"][0]["weights"].push_back(1);
    }
    expect_end(targets, "twenty thousand morph targets of a million vertices");

    json skins = triangle();
    json& attributes = primitive_of(skins)["attributes"];
    attributes["JOINTS_0"] = add_accessor(skins, std::vector<std::uint16_t>(12, 0), "VEC4");
    attributes["WEIGHTS_0"] = add_accessor(skins, std::vector<float>(12, 1), "VEC4");
    skins["skins"] = {{{"joints", std::vector<int>(20'000, 0)}}};
    for (int i = 1; i < 20'000; ++i) {
        skins["nodes"].push_back({{"mesh", 0}, {"skin", 0}});
        skins["scenes"][0]["nodes"].push_back(i);
    }
    expect_end(skins, "twenty thousand skins of twenty thousand joints");

    json odd = triangle();
    for (int i = 0; i < 20'000; ++i) odd["materials"].push_back({{"emissiveFactor", {1, 2}}});
    expect_end(odd, "twenty thousand odd materials");

    const int code = load_within_limits(
        File("{\"asset\":{\"version\":\"2.0\"},\"nodes\":[" + std::string(3'000'000, '[')).path());
    EXPECT_EQ(code, kRefused);
}

}  // namespace
}  // namespace terrazzo::gltf::test
