// Small glTF documents for tests: made of values, written to files that are gone afterwards.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gltf/load_model.h"

namespace terrazzo::gltf::test {

using nlohmann::json;

// A temporary file; `extension` with its dot.
class File {
  public:
    explicit File(const std::string& content, const std::string& extension = ".gltf");
    explicit File(const json& document) : File(document.dump()) {}
    ~File();
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    const std::string& path() const { return m_path; }

  private:
    std::string m_path;
};

std::string data_uri(const void* bytes, std::size_t size);
// "glTF", version and the chunks.
std::string binary_file(const json& document, const std::string& binary);

// Appends bytes as a buffer with a view of its own; the view's number.
int add_view(json& document, const void* bytes, std::size_t size);
template <typename T>
int add_view(json& document, const std::vector<T>& values) {
    return add_view(document, values.data(), values.size() * sizeof(T));
}
// Appends an accessor: a vector of floats (5126) or of unsigned shorts (5123), bytes (5121), words (5125).
int add_accessor(json& document, const std::vector<float>& values, const std::string& type);
int add_accessor(json& document, const std::vector<std::uint16_t>& values, const std::string& type);

// One node, one mesh, one primitive: the triangle (0,0,0) (1,0,0) (0,1,0), accessor 0, indices accessor 1.
json triangle();
json& primitive_of(json& document);

// A PNG file's bytes of RGBA pixels, colours not multiplied by alpha.
std::vector<unsigned char> png_of(const std::vector<std::uint8_t>& rgba, int width, int height);
// Gives the primitive a material with this image as its base colour, and coordinates for three vertices.
void add_texture(json& document, const std::vector<unsigned char>& png);

LoadedModel load(const json& document, const LoadOptions& options = {});
// The notes in one line each.
std::string notes_of(const LoadedModel& loaded);
// What load_model throws, or nothing.
std::string refusal_of_file(const std::string& path, const LoadOptions& options = {});
std::string refusal_of(const json& document, const LoadOptions& options = {});

}  // namespace terrazzo::gltf::test
