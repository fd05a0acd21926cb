// How many bytes the specification says that a command may read or write behind each of its pointers.
// Input: a call's other arguments and the state that the size depends on. Output: bytes; zero where the call
// is an error, for then nothing may be touched.
#pragma once

#include <cstdint>
#include <string_view>

#include "fuzz/image_size.h"
#include "fuzz/table.h"

namespace terrazzo::fuzz {

inline constexpr int kArrayElements = 256;  // of every vertex array in client memory
inline constexpr std::uint64_t kNoLimit = UINT64_MAX;

// What sizes depend on beside arguments, asked of the context before the call.
struct SizeState {
    PixelStore pack, unpack;
    ImageShape image;                     // of the texture's level that is asked for
    std::uint64_t compressed_bytes = 0;   // of the same
    std::uint64_t map_values = 0;         // of the evaluator's parameter that is asked for
    std::uint64_t pixel_map_entries = 0;  // of the pixel map that is asked for
    std::uint64_t list_formats = 0;       // GL_NUM_COMPRESSED_TEXTURE_FORMATS
};

// A call's arguments by name.
class NamedValues {
  public:
    NamedValues(const Command& command, const Value* values) : m_command(command), m_values(values) {}

    bool has(std::string_view name) const;
    std::int64_t integer(std::string_view name, std::int64_t otherwise = 0) const;

  private:
    const Command& m_command;
    const Value* m_values;
};

std::uint64_t documented_bytes(const Command& command, std::size_t parameter, const Value* values,
                               const SizeState& state);
// How many values a parameter vector or a query of this name has; zero for a name that the command does not
// know.
unsigned values_of_parameter(std::string_view family, GLenum pname, std::uint64_t list_formats);
// Components of an evaluator's control points; zero for what is no target.
unsigned components_of_map(GLenum target);
// Bytes of one vertex of an array; zero for what is no array's type.
std::uint64_t bytes_of_element(GLint size, GLenum type);
unsigned bytes_of_list_name(GLenum type);
unsigned bytes_of_index(GLenum type);

}  // namespace terrazzo::fuzz
