// Stage: models from files, what is said about a file beside drawing it. Input: sentences. Output: each once,
// in the order in which they came, and how many there was no room for. Invariant: a hostile file cannot make
// the list long.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace terrazzo::gltf {

class Notes {
  public:
    void add(const std::string& sentence);
    // Ends with a line about what was left out, if anything was.
    std::vector<std::string> sentences() const;

  private:
    std::vector<std::string> m_sentences;
    std::size_t m_left_out = 0;
};

// Something that cannot be drawn: a part of a file where it is caught, else the whole file.
[[noreturn]] inline void refuse(const std::string& reason) {
    throw std::runtime_error(reason);
}

template <typename T>
const T& at(const std::vector<T>& list, int index, const char* what) {
    if (index < 0 || static_cast<std::size_t>(index) >= list.size())
        refuse("there is no " + std::string(what) + " " + std::to_string(index));
    return list[static_cast<std::size_t>(index)];
}

}  // namespace terrazzo::gltf
