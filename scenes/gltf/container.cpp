// Files, and the chunks of binary ones (glTF 2.0 §4.4).
#include "container.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "notes.h"

namespace terrazzo::gltf {
namespace {

constexpr std::size_t kHeader = 12, kChunkHeader = 8;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

std::uint32_t word_at(const Bytes& bytes, std::size_t offset) {
    return static_cast<std::uint32_t>(bytes[offset]) | static_cast<std::uint32_t>(bytes[offset + 1]) << 8 |
           static_cast<std::uint32_t>(bytes[offset + 2]) << 16 |
           static_cast<std::uint32_t>(bytes[offset + 3]) << 24;
}

Container split(const Bytes& bytes) {
    if (bytes.size() < kHeader + kChunkHeader) refuse("the binary file ends within its header");
    if (const std::uint32_t version = word_at(bytes, 4); version != 2)
        refuse("the binary file has version " + std::to_string(version) + "; only version 2 is read");
    const std::size_t end = std::min<std::size_t>(word_at(bytes, 8), bytes.size());
    Container container;
    container.is_binary = true;
    bool has_json = false, has_binary = false;
    for (std::size_t offset = kHeader; offset < end && end - offset >= kChunkHeader;) {
        const std::size_t length = word_at(bytes, offset);
        const std::uint32_t kind = word_at(bytes, offset + 4);
        offset += kChunkHeader;
        if (length > end - offset) refuse("a chunk of the binary file is longer than the file");
        const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(offset);
        const auto last = first + static_cast<std::ptrdiff_t>(length);
        if (kind == kJsonChunk && !has_json) container.json.assign(first, last), has_json = true;
        if (kind == kBinaryChunk && !has_binary) container.binary.assign(first, last), has_binary = true;
        offset += length;
    }
    if (!has_json) refuse("the binary file has no JSON chunk");
    return container;
}

}  // namespace

void Budget::spend(std::size_t amount) {
    if (!has(amount)) refuse("it needs more than " + std::string(m_name) + " allows");
    m_left -= amount;
}

Bytes read_file(const std::string& path, Budget& bytes, std::size_t most) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) refuse("there is no file " + path);
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    std::ifstream file(path, std::ios::binary);
    if (error || !file) refuse("the file " + path + " cannot be read");
    const auto length = static_cast<std::size_t>(std::min<std::uintmax_t>(size, most));
    bytes.spend(length);
    Bytes content(length);
    file.read(reinterpret_cast<char*>(content.data()), static_cast<std::streamsize>(length));
    content.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
    return content;
}

Container open_container(const std::string& path, Budget& bytes) {
    const Bytes content = read_file(path, bytes);
    if (content.size() >= 4 && std::memcmp(content.data(), "glTF", 4) == 0) return split(content);
    Container container;
    container.json.assign(content.begin(), content.end());
    return container;
}

}  // namespace terrazzo::gltf
