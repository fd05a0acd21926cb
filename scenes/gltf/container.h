// Stage: models from files, the bytes. Input: the path of a .gltf or .glb file, told apart by their content.
// Output: the JSON text and the binary chunk. Invariant: only regular files are opened, and never more bytes
// are read than the budget holds.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace terrazzo::gltf {

using Bytes = std::vector<unsigned char>;

// What is left of a limit, for everything that a model reads.
class Budget {
  public:
    // The name is the option that sets the limit.
    Budget(std::size_t limit, const char* name) : m_left(limit), m_name(name) {}
    bool has(std::size_t amount) const { return amount <= m_left; }
    void spend(std::size_t amount);  // throws std::runtime_error when there is not so much left

  private:
    std::size_t m_left;
    const char* m_name;
};

struct Container {
    std::string json;
    Bytes binary;  // empty unless the file is binary and has such a chunk
    bool is_binary = false;
};

// Both throw std::runtime_error. `most` bytes are read of a file that has more.
Bytes read_file(const std::string& path, Budget& bytes, std::size_t most = SIZE_MAX);
Container open_container(const std::string& path, Budget& bytes);

}  // namespace terrazzo::gltf
