// The library that is tried: its exported functions, found by name as a program's loader finds them.
#pragma once

#include <string>
#include <vector>

#include "fuzz/table.h"
#include "kit/library.h"

namespace terrazzo::fuzz {

class Library {
  public:
    // Ends the process with a message where it cannot be loaded. Commands whose names do not match `only`, a
    // regular expression, are left out; all are there where it is empty.
    Library(const std::string& path, const std::string& only);

    Function find(const char* name) const;
    // The function of a command of the table; null where the library does not export it, or it is left out.
    Function function(const Command& command) const {
        return m_functions[static_cast<std::size_t>(&command - commands().data())];
    }

    template <typename Type>
    void find(const char* name, Type*& out) const {
        out = reinterpret_cast<Type*>(find(name));
    }

    kit::Gl gl{};  // for what the fuzzer asks between calls
    // The commands that are implemented, by family, and the exported names of all others.
    std::vector<std::vector<const Command*>> families;
    std::vector<const Command*> not_implemented;

  private:
    void* m_handle;
    std::vector<Function> m_functions;
};

}  // namespace terrazzo::fuzz
