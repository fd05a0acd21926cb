// What the generated player (play_record) is made of.
#pragma once

#include "gl/context.h"
#include "gl/list_record.h"
#include "gl/tight_unpack.h"  // images in lists are laid out in the default way

namespace terrazzo::gl {

// Carries out one record through ctx.dispatch.execute.
void play_record(Context& ctx, const RecordHeader& header);

// Records the error that a command was known to make when it was compiled.
struct ErrorRecord;
void play_error(Context& ctx, const ErrorRecord& record);

// Name of the GL command that a record carries out.
const char* record_name(Opcode opcode);

// An array or image behind a record; see CopiedArray::store.
template <typename Pointer, typename Record>
Pointer behind(const Record& record, std::uint32_t offset) {
    return offset ? reinterpret_cast<Pointer>(reinterpret_cast<const std::byte*>(&record) + offset) : nullptr;
}

}  // namespace terrazzo::gl
