// What the registry says of the commands that the libraries export: signatures, groups of enumerants, classes
// of objects, lengths of client memory. The tables are written by tools/generate.py.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace terrazzo::fuzz {

struct Value {
    std::int64_t integer = 0;
    double real = 0;
    void* pointer = nullptr;
};

struct Enumerant {
    std::uint32_t value;
    const char* name;
};

struct EnumGroup {
    std::string_view name;
    std::span<const Enumerant> enumerants;
    unsigned offered;  // so many of them, the first, belong to what the library offers
};

enum class ObjectClass : std::uint8_t {
    kNone,
    kTexture,
    kQuery,
    kRenderbuffer,
    kBuffer,
    kFramebuffer,
    kList
};

struct Parameter {
    std::string_view name;
    // e GLenum, m GLbitfield, n GLsizei, i GLint, u GLuint, f GLfloat, d GLdouble, b GLbyte, B GLubyte, s
    // GLshort, S GLushort, o GLboolean, p GLintptr, v void, P another pointer, z any other: of the value, or
    // of what it points at.
    char letter;
    bool is_pointer;
    bool is_output;  // the command writes behind the pointer
    int group;       // index into groups(), -1 for none
    ObjectClass object;
    std::string_view length;
};

using Function = void (*)();

struct Command {
    std::string_view name;
    std::string_view family;  // the command of which this is a form; empty where it is not implemented
    std::int64_t (*invoke)(Function, const Value* one_for_each_parameter);
    std::span<const Parameter> parameters;
};

inline constexpr int kMostParameters = 16;

std::span<const EnumGroup> groups();
std::span<const Command> commands();

// The group of this name; null where no parameter has it.
const EnumGroup* find_group(std::string_view name);
// The command of this name, which must be one.
const Command& find_command(std::string_view name);
// The bytes of one element behind a pointer, or of the value.
unsigned size_of(char letter);
// The enumerant's name, of its group if possible; empty for a number that has none.
std::string_view enumerant_name(int group, std::uint32_t value);

}  // namespace terrazzo::fuzz
