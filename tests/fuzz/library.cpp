// Loads the library; see library.h.
#include "fuzz/library.h"

#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <regex>

namespace terrazzo::fuzz {

Library::Library(const std::string& path, const std::string& only)
    : m_handle(dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL)) {
    if (!m_handle) {
        std::fprintf(stderr, "fuzz: %s\n", dlerror());
        std::exit(2);
    }
    for (const kit::GlCommand& command : kit::kGlCommands) {
        const Function address = find(command.name);
        std::memcpy(reinterpret_cast<char*>(&gl) + command.offset, &address, sizeof address);
    }
    std::map<std::string_view, std::vector<const Command*>> by_family;
    const std::regex wanted(only);
    for (const Command& command : commands()) {
        const bool is_wanted = only.empty() || std::regex_search(command.name.data(), wanted);
        m_functions.push_back(is_wanted ? find(command.name.data()) : nullptr);
        if (!m_functions.back()) continue;
        (command.family.empty() ? not_implemented : by_family[command.family]).push_back(&command);
    }
    for (auto& [family, members] : by_family) families.push_back(std::move(members));
}

Function Library::find(const char* name) const {
    return reinterpret_cast<Function>(dlsym(m_handle, name));
}

}  // namespace terrazzo::fuzz
