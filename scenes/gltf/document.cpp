// From bytes to tinygltf's model. Buffers and images are not tinygltf's: it gives up the file when one is
// missing, and reads all of them before anybody has asked how large they are.
#include "document.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

#include "json_check.h"

namespace terrazzo::gltf {
namespace {

using nlohmann::json;

const std::set<std::string> kExtensions{"KHR_texture_transform", "KHR_materials_unlit",
                                        "KHR_materials_pbrSpecularGlossiness", "KHR_mesh_quantization",
                                        "KHR_materials_emissive_strength"};

std::vector<std::string> strings_of(const json& document, const char* name) {
    std::vector<std::string> strings;
    if (const auto found = document.find(name); found != document.end() && found->is_array())
        for (const json& element : *found)
            if (element.is_string()) strings.push_back(element.get<std::string>());
    return strings;
}

std::string unknown_of(const std::vector<std::string>& extensions) {
    std::string names;
    for (const std::string& name : extensions) {
        if (kExtensions.count(name) > 0) continue;
        if (!names.empty()) names += ", ";
        names += name;
    }
    return names;
}

// Older exporters wrote a number.
void check_version(json& document) {
    std::string version;
    for (const char* name : {"version", "minVersion"}) {
        if (!document.contains("asset") || !document["asset"].is_object()) break;
        const json value = document["asset"].value(name, json());
        if (value.is_string()) version = value;
        if (value.is_number()) version = value.dump();
    }
    document["asset"] = {{"version", version}};
    if (version.empty()) refuse("it is not glTF: it does not say its version");
    if (version.rfind("2.", 0) != 0 && version != "2") refuse("it is glTF " + version + "; only 2.x is read");
}

void check_extensions(const json& document, Notes& notes) {
    if (const std::string names = unknown_of(strings_of(document, "extensionsRequired")); !names.empty())
        refuse("it requires " + names + ", which is not there");
    if (const std::string names = unknown_of(strings_of(document, "extensionsUsed")); !names.empty())
        notes.add("extensions that are not there are ignored: " + names);
}

std::string percent_decoded(const std::string& text) {
    std::string decoded;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_code = text[i] == '%' && i + 2 < text.size() &&
                             std::isxdigit(static_cast<unsigned char>(text[i + 1])) &&
                             std::isxdigit(static_cast<unsigned char>(text[i + 2]));
        decoded += is_code ? static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16)) : text[i];
        if (is_code) i += 2;
    }
    return decoded;
}

std::vector<ImageSource> take_images(json& document) {
    std::vector<ImageSource> images;
    if (document.contains("images") && document["images"].is_array())
        for (const json& image : document["images"]) {
            ImageSource source;
            if (image.is_object() && image.contains("uri") && image["uri"].is_string())
                source.uri = image["uri"];
            else if (image.is_object() && image.contains("bufferView") &&
                     image["bufferView"].is_number_unsigned() &&
                     image["bufferView"].get<std::uint64_t>() < 0x7FFFFFFF)
                source.buffer_view = image["bufferView"];
            images.push_back(source);
        }
    document.erase("images");
    return images;
}

// glTF 2.0 §3.6.1: the first buffer of a binary file, when it has no URI, is the binary chunk.
Bytes read_buffer(const Document& document, const json& buffer, Container& container, bool is_first,
                  Budget& bytes) {
    if (!buffer.is_object()) refuse("it is not an object");
    const json length = buffer.value("byteLength", json());
    if (!length.is_number_unsigned()) refuse("byteLength is not a whole number from 0");
    const auto wanted = length.get<std::size_t>();
    Bytes content;
    if (buffer.contains("uri") && buffer["uri"].is_string()) {
        content = read_uri(document, buffer["uri"], bytes, wanted);
    } else if (is_first && container.is_binary) {
        content = std::move(container.binary);
    } else {
        refuse("it has neither a URI nor a binary chunk");
    }
    if (content.size() > wanted) content.resize(wanted);
    return content;
}

std::vector<tinygltf::Buffer> take_buffers(json& document, const Document& result, Container& container,
                                           Budget& bytes, Notes& notes) {
    std::vector<tinygltf::Buffer> buffers;
    if (document.contains("buffers") && document["buffers"].is_array())
        for (const json& buffer : document["buffers"]) {
            buffers.emplace_back();
            try {
                buffers.back().data = read_buffer(result, buffer, container, buffers.size() == 1, bytes);
            } catch (const std::exception& failure) {
                notes.add("buffers[" + std::to_string(buffers.size() - 1) +
                          "] is not there: " + failure.what());
            }
        }
    document.erase("buffers");
    return buffers;
}

int add_zeros_view(json& document) {
    json& views = document["bufferViews"];
    if (!views.is_array()) views = json::array();
    const int zeros = static_cast<int>(views.size());
    views.push_back(neutral_element("bufferViews"));
    if (document.contains("accessors"))
        for (json& accessor : document["accessors"])
            if (!accessor.contains("bufferView")) accessor["bufferView"] = zeros;
    return zeros;
}

void note_lines(const std::string& text, Notes& notes) {
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        const std::string line = text.substr(start, end - start);
        // Which a skin may do without (glTF 2.0 §3.7.3.1).
        if (line.rfind("'inverseBindMatrices' property is missing", 0) != 0) notes.add(line);
        start = end + 1;
    }
}

bool parse(const json& document, tinygltf::Model& file, std::string& error, std::string& warning) {
    tinygltf::TinyGLTF loader;
    const std::string text = document.dump();
    return loader.LoadASCIIFromString(&file, &error, &warning, text.data(),
                                      static_cast<unsigned int>(text.size()), "");
}

// One element that tinygltf refuses makes it refuse the file: it is found by halves, and replaced.
void replace_refused(json& document, const std::string& section, std::size_t first, std::size_t last,
                     std::size_t& replaced, Notes& notes) {
    json& elements = document[section];
    const auto begin = elements.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = elements.begin() + static_cast<std::ptrdiff_t>(last);
    tinygltf::Model file;
    std::string error, warning;
    const json alone{{"asset", {{"version", "2.0"}}}, {section, json(std::vector<json>(begin, end))}};
    if (first == last || parse(alone, file, error, warning)) return;
    if (last - first == 1) {
        constexpr std::size_t kMostReplaced = 100;
        if (++replaced > kMostReplaced) refuse(error);
        notes.add(section + "[" + std::to_string(first) + "] is ignored: " + error);
        elements[first] = neutral_element(section);
        return;
    }
    const std::size_t middle = (first + last) / 2;
    replace_refused(document, section, first, middle, replaced, notes);
    replace_refused(document, section, middle, last, replaced, notes);
}

void replace_refused_elements(json& document, Notes& notes) {
    std::size_t replaced = 0;
    // Meshes alone are refused for the accessors that are not beside them, and for nothing else.
    for (const std::string& section : section_names())
        if (document.contains(section) && section != "meshes")
            replace_refused(document, section, 0, document[section].size(), replaced, notes);
}

// tinygltf refuses a file for indices that name no accessor.
void remove_lost_indices(json& document, Notes& notes) {
    const std::size_t accessors = document.contains("accessors") ? document["accessors"].size() : 0;
    const std::size_t views = document["bufferViews"].size();
    const auto is_lost = [&](const json& primitive) {
        if (!primitive.is_object() || !primitive.contains("indices")) return false;
        const auto accessor = primitive["indices"].get<std::size_t>();
        return accessor >= accessors ||
               document["accessors"][accessor]["bufferView"].get<std::size_t>() >= views;
    };
    if (!document.contains("meshes")) return;
    for (json& mesh : document["meshes"]) {
        if (!mesh.contains("primitives") || !mesh["primitives"].is_array()) continue;
        for (json& primitive : mesh["primitives"])
            if (is_lost(primitive)) {
                notes.add("a primitive is not drawn: its indices are not there");
                primitive = json::object();
            }
    }
}

void parse_cleaned(json& document, Document& result, Notes& notes) {
    std::string error, warning;
    if (!parse(document, result.file, error, warning)) {
        replace_refused_elements(document, notes);
        error.clear();
        warning.clear();
        result.file = tinygltf::Model();
        if (!parse(document, result.file, error, warning)) refuse(error);
    }
    note_lines(error + "\n" + warning, notes);
}

}  // namespace

Bytes read_uri(const Document& document, const std::string& uri, Budget& bytes, std::size_t most) {
    if (uri.rfind("data:", 0) != 0) {
        const std::filesystem::path path = percent_decoded(uri);
        return read_file((std::filesystem::path(document.folder) / path).string(), bytes, most);
    }
    bytes.spend(uri.size());
    Bytes content;
    std::string type;
    if (tinygltf::IsDataURI(uri)) {
        if (!tinygltf::DecodeDataURI(&content, type, uri, 0, false)) refuse("its data URI is damaged");
        return content;
    }
    // tinygltf knows a handful of media types; what a URI holds does not depend on what it calls it.
    const std::size_t comma = uri.find(";base64,");
    if (comma == std::string::npos) refuse("its data URI is not base64");
    const std::string same = "data:application/octet-stream" + uri.substr(comma);
    if (!tinygltf::DecodeDataURI(&content, type, same, 0, false)) refuse("its data URI is damaged");
    return content;
}

std::span<const unsigned char> bytes_of_view(const tinygltf::Model& file, int index) {
    const tinygltf::BufferView& view = at(file.bufferViews, index, "buffer view");
    const Bytes& bytes = at(file.buffers, view.buffer, "buffer").data;
    if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset)
        refuse("a buffer view is not within its buffer");
    return std::span(bytes).subspan(view.byteOffset, view.byteLength);
}

Document read_document(const std::string& path, Budget& bytes, Notes& notes) {
    Container container = open_container(path, bytes);
    json document = parse_document(container.json);
    container.json = {};
    check_version(document);
    check_extensions(document, notes);

    Document result;
    result.folder = std::filesystem::path(path).parent_path().string();
    result.images = take_images(document);
    std::vector<tinygltf::Buffer> buffers = take_buffers(document, result, container, bytes, notes);
    if (document.contains("animations")) notes.add("its animations are not played");
    for (const char* unused : {"animations", "extensions", "extras"}) document.erase(unused);
    check_sections(document, notes);
    result.zeros_view = add_zeros_view(document);
    remove_lost_indices(document, notes);
    parse_cleaned(document, result, notes);
    result.file.buffers = std::move(buffers);
    return result;
}

}  // namespace terrazzo::gltf
