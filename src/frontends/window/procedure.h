// A function of a window system's interface by name, and libglvnd's way to it.
#pragma once

#include <cstring>
#include <span>

namespace terrazzo::window {

using Function = void (*)();

struct Procedure {
    const char* name;
    Function address;
    // For functions that libglvnd does not know by itself: the way from there to the vendor, and the number
    // that libglvnd has given the function. Null for others.
    Function dispatch = nullptr;
    int* dispatch_index = nullptr;
};

// Null for what is not among them.
inline const Procedure* find_procedure(std::span<const Procedure> all, const char* name) {
    for (const Procedure& procedure : all)
        if (std::strcmp(procedure.name, name) == 0) return &procedure;
    return nullptr;
}

}  // namespace terrazzo::window
