// Documents as JSON values, buffers as data URIs.
#include "model_files.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace terrazzo::gltf::test {
namespace {

namespace fs = std::filesystem;

void append_word(std::string& bytes, std::size_t word) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 0xFF);
}

std::string padded(std::string bytes, char filler) {
    while (bytes.size() % 4 != 0) bytes += filler;
    return bytes;
}

int components(const std::string& type) {
    if (type == "SCALAR") return 1;
    if (type == "MAT4") return 16;
    return type.back() - '0';
}

template <typename T>
int append_accessor(json& document, const std::vector<T>& values, const std::string& type, int component) {
    const auto count = values.size() / static_cast<std::size_t>(components(type));
    const int view = add_view(document, values);
    document["accessors"].push_back(
        {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
    return static_cast<int>(document["accessors"].size()) - 1;
}

}  // namespace

File::File(const std::string& content, const std::string& extension) {
    static int s_count = 0;
    m_path = (fs::temp_directory_path() /
              ("terrazzo-model-" + std::to_string(++s_count) + "-" + std::to_string(getpid()) + extension))
                 .string();
    std::ofstream(m_path, std::ios::binary) << content;
}

File::~File() {
    std::error_code error;
    fs::remove(m_path, error);
}

std::string data_uri(const void* bytes, std::size_t size) {
    return "data:application/octet-stream;base64," +
           OIIO::Strutil::base64_encode({static_cast<const char*>(bytes), size});
}

std::string binary_file(const json& document, const std::string& binary) {
    const std::string text = padded(document.dump(), ' '), data = padded(binary, '\0');
    std::string file = "glTF";
    append_word(file, 2);
    append_word(file, 12 + 8 + text.size() + (data.empty() ? 0 : 8 + data.size()));
    append_word(file, text.size());
    file += "JSON" + text;
    if (data.empty()) return file;
    append_word(file, data.size());
    return file + std::string("BIN\0", 4) + data;
}

int add_view(json& document, const void* bytes, std::size_t size) {
    document["buffers"].push_back({{"byteLength", size}, {"uri", data_uri(bytes, size)}});
    document["bufferViews"].push_back({{"buffer", document["buffers"].size() - 1}, {"byteLength", size}});
    return static_cast<int>(document["bufferViews"].size()) - 1;
}

int add_accessor(json& document, const std::vector<float>& values, const std::string& type) {
    return append_accessor(document, values, type, 5126);
}

int add_accessor(json& document, const std::vector<std::uint16_t>& values, const std::string& type) {
    return append_accessor(document, values, type, 5123);
}

json triangle() {
    json document{{"asset", {{"version", "2.0"}}},
                  {"scene", 0},
                  {"scenes", {{{"nodes", {0}}}}},
                  {"nodes", {{{"mesh", 0}}}},
                  {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}}}};
    add_accessor(document, std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    add_accessor(document, std::vector<std::uint16_t>{0, 1, 2}, "SCALAR");
    return document;
}

json& primitive_of(json& document) {
    return document["meshes"][0]["primitives"][0];
}

std::vector<unsigned char> png_of(const std::vector<std::uint8_t>& rgba, int width, int height) {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput target(bytes);
    const auto output = OIIO::ImageOutput::create("png", &target);
    OIIO::ImageSpec spec(width, height, 4, OIIO::TypeDesc::UINT8);
    spec["oiio:UnassociatedAlpha"] = 1;
    if (!output || !output->open("image.png", spec) ||
        !output->write_image(OIIO::TypeDesc::UINT8, rgba.data()) || !output->close())
        throw std::runtime_error("no PNG could be written");
    return bytes;
}

void add_texture(json& document, const std::vector<unsigned char>& png) {
    document["images"].push_back({{"bufferView", add_view(document, png)}, {"mimeType", "image/png"}});
    document["textures"].push_back({{"source", document["images"].size() - 1}});
    document["materials"].push_back(
        {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", document["textures"].size() - 1}}}}}});
    json& primitive = primitive_of(document);
    primitive["material"] = document["materials"].size() - 1;
    primitive["attributes"]["TEXCOORD_0"] =
        add_accessor(document, std::vector<float>{0, 0, 1, 0, 0, 1}, "VEC2");
}

LoadedModel load(const json& document, const LoadOptions& options) {
    return load_model(File(document).path(), options);
}

std::string notes_of(const LoadedModel& loaded) {
    std::string lines;
    for (const std::string& note : loaded.notes) lines += note + "\n";
    return lines;
}

std::string refusal_of_file(const std::string& path, const LoadOptions& options) {
    try {
        load_model(path, options);
    } catch (const std::runtime_error& refusal) {
        return refusal.what();
    }
    return {};
}

std::string refusal_of(const json& document, const LoadOptions& options) {
    return refusal_of_file(File(document).path(), options);
}

}  // namespace terrazzo::gltf::test
