// Bytes in a memory file that children of this process can open by name.
#include "shared_bytes.h"

#include <sys/mman.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace terrazzo::kit {

SharedBytes::SharedBytes(std::span<const std::uint8_t> bytes)
    : m_descriptor(memfd_create("terrazzo-data", MFD_CLOEXEC)) {
    std::size_t done = 0;
    while (m_descriptor >= 0 && done < bytes.size()) {
        const ssize_t count = write(m_descriptor, bytes.data() + done, bytes.size() - done);
        if (count <= 0) break;
        done += static_cast<std::size_t>(count);
    }
    if (m_descriptor < 0 || done < bytes.size()) throw std::runtime_error("no memory for shared data");
}

SharedBytes::~SharedBytes() {
    if (m_descriptor >= 0) close(m_descriptor);
}

std::string SharedBytes::path() const {
    return "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(m_descriptor);
}

std::vector<std::uint8_t> read_bytes(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("cannot read " + path);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace terrazzo::kit
