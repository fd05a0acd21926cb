// Bounds on the work of a call; see bounded_work.h.
#include "fuzz/bounded_work.h"

#include <algorithm>
#include <cstdlib>

namespace terrazzo::fuzz {
namespace {

constexpr std::int64_t kMostTexels = 1 << 18;
constexpr std::int64_t kLargestTexture = 1 << 16;  // more than any library takes
constexpr std::int64_t kLargestShared = 64;  // where no thread knows how large an image is when it reads it
constexpr std::int64_t kMostBufferBytes = 1 << 18;
constexpr std::int64_t kHopelessBytes = std::int64_t{1} << 44;  // no memory has so many
constexpr std::int64_t kMostVertices = 1 << 14;
constexpr std::int64_t kHopelessVertices = 1 << 26;
constexpr std::int64_t kMostNames = 64;
constexpr std::int64_t kMostMeshSteps = 24;

Value* find(const Command& command, Value* values, std::string_view name) {
    const auto found = std::ranges::find(command.parameters, name, &Parameter::name);
    return found == command.parameters.end() ? nullptr : values + (found - command.parameters.begin());
}

void bound_texels(const Command& command, Value* values, bool shared) {
    std::int64_t texels = 1;
    for (const char* name : {"width", "height", "depth"}) {
        Value* const extent = find(command, values, name);
        if (!extent) continue;
        if (extent->integer < 0 || extent->integer > kLargestTexture) return;  // an error
        if (shared && extent->integer > kLargestShared) extent->integer &= kLargestShared - 1;
        const std::int64_t room = kMostTexels / std::max<std::int64_t>(texels, 1);
        extent->integer = std::min(extent->integer, room);
        texels *= extent->integer;
    }
    if (Value* const samples = find(command, values, "samples"); samples && samples->integer > 16)
        samples->integer = -1;
}

void bound_mesh(const Command& command, Value* values, const char* from, const char* to) {
    Value *const first = find(command, values, from), *const last = find(command, values, to);
    if (first && last)
        last->integer = static_cast<std::int32_t>(std::clamp<std::int64_t>(
            last->integer, first->integer - kMostMeshSteps, first->integer + kMostMeshSteps));
}

}  // namespace

void bound_work(const Command& command, Value* values, bool shared) {
    const std::string_view family = command.family;
    const auto limit = [&](const char* name, std::int64_t most) {
        if (Value* const value = find(command, values, name); value && value->integer > most)
            value->integer &= most;
    };
    const bool makes_image = family.starts_with("glTexImage") || family.starts_with("glCopyTexImage") ||
                             family.starts_with("glCompressedTexImage") ||
                             family.starts_with("glRenderbufferStorage");
    if (makes_image) bound_texels(command, values, shared);
    if (family == "glBufferData") {
        Value& size = *find(command, values, "size");
        if (size.integer > kMostBufferBytes && size.integer < kHopelessBytes)
            size.integer &= kMostBufferBytes - 1;
    }
    if (family.starts_with("glEvalMesh")) {
        bound_mesh(command, values, "i1", "i2");
        bound_mesh(command, values, "j1", "j2");
    }
    const bool lists_names =
        family.starts_with("glGen") || (family.starts_with("glDelete") && family != "glDeleteLists") ||
        family == "glPrioritizeTextures" || family == "glAreTexturesResident" || family == "glCallLists";
    if (lists_names && family != "glGenLists" && family != "glGenerateMipmap") limit("n", kMostNames - 1);
    // Larger ones than any library draws from memory that ends are kept: they must be refused.
    if (Value* const count = find(command, values, "count"); count && count->integer < kHopelessVertices)
        limit("count", kMostVertices - 1);
    if (family.starts_with("glMulti")) limit("drawcount", 15), limit("primcount", 15);
    if (family == "glFeedbackBuffer" || family == "glSelectBuffer") limit("size", 4095);
}

}  // namespace terrazzo::fuzz
