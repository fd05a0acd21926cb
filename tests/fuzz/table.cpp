// Looks up commands, groups and enumerants; see table.h.
#include "fuzz/table.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>

namespace terrazzo::fuzz {

const EnumGroup* find_group(std::string_view name) {
    const auto all = groups();
    const auto found = std::ranges::find(all, name, &EnumGroup::name);
    return found == all.end() ? nullptr : &*found;
}

const Command& find_command(std::string_view name) {
    static const auto by_name = [] {
        std::map<std::string_view, const Command*> out;
        for (const Command& command : commands()) out[command.name] = &command;
        return out;
    }();
    const auto found = by_name.find(name);
    if (found == by_name.end()) {
        std::fprintf(stderr, "%.*s is not in the table\n", static_cast<int>(name.size()), name.data());
        std::abort();
    }
    return *found->second;
}

unsigned size_of(char letter) {
    switch (letter) {
        case 'b':
        case 'B':
        case 'o':
        case 'v':
            return 1;
        case 's':
        case 'S':
            return 2;
        case 'd':
        case 'p':
        case 'P':
        case 'z':
            return 8;
    }
    return 4;
}

std::string_view enumerant_name(int group, std::uint32_t value) {
    if (group < 0) return {};
    const auto enumerants = groups()[static_cast<std::size_t>(group)].enumerants;
    const auto found = std::ranges::find(enumerants, value, &Enumerant::value);
    return found == enumerants.end() ? std::string_view() : found->name;
}

}  // namespace terrazzo::fuzz
