// Bytes in a memory file that children of this process can open by name, for as long as this object lives.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace terrazzo::kit {

class SharedBytes {
  public:
    explicit SharedBytes(std::span<const std::uint8_t> bytes);  // throws std::runtime_error
    ~SharedBytes();
    SharedBytes(SharedBytes&& other) noexcept : m_descriptor(other.m_descriptor) { other.m_descriptor = -1; }
    SharedBytes(const SharedBytes&) = delete;
    SharedBytes& operator=(const SharedBytes&) = delete;
    SharedBytes& operator=(SharedBytes&&) = delete;

    std::string path() const;  // valid in this process and its children

  private:
    int m_descriptor;
};

std::vector<std::uint8_t> read_bytes(const std::string& path);  // throws std::runtime_error

}  // namespace terrazzo::kit
