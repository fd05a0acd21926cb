// Display-list commands (GL 1.5 §5.4): making, calling, naming and deleting lists.
//
// A list replaces the one of its name at EndList. Whoever plays the old one keeps it alive until done.
#include "gl/lists.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "gl/context.h"
#include "gl/debug_log.h"
#include "gl/generated/commands.h"
#include "gl/generated/compile.h"
#include "gl/generated/records.h"
#include "gl/limits.h"
#include "gl/list_player.h"
#include "gl/list_recorder.h"
#include "gl/share.h"

namespace terrazzo::gl {
namespace {

std::shared_ptr<const DisplayList> find_list(Context& ctx, GLuint name) {
    const std::lock_guard lock(ctx.shared->mutex);
    const auto found = ctx.shared->lists.find(name);
    return found == ctx.shared->lists.end() ? nullptr : found->second;
}

void play(Context& ctx, const DisplayList& list) {
    const bool name_commands = debug_enabled();
    list.for_each([&](const RecordHeader& header) {
        if (name_commands) [[unlikely]]
            ctx.error.command = record_name(header.opcode);
        play_record(ctx, header);
    });
}

// Bytes of one list name in glCallLists; 0 for a type that is not allowed.
std::size_t list_name_bytes(GLenum type) {
    switch (type) {
        case GL_BYTE:
        case GL_UNSIGNED_BYTE:
            return 1;
        case GL_SHORT:
        case GL_UNSIGNED_SHORT:
        case GL_2_BYTES:
            return 2;
        case GL_3_BYTES:
            return 3;
        case GL_INT:
        case GL_UNSIGNED_INT:
        case GL_FLOAT:
        case GL_4_BYTES:
            return 4;
        default:
            return 0;
    }
}

template <typename Value>
Value read_as(const std::byte* bytes) {
    Value value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

// Floats are truncated; one that fits no list name is as good as 0.
GLuint float_list_offset(GLfloat value) {
    return value > -2147483648.0f && value < 4294967296.0f
               ? static_cast<GLuint>(static_cast<long long>(value))
               : 0;
}

// The n-byte types put the most significant byte first (GL 1.5 §5.4).
GLuint big_endian(const std::byte* bytes, std::size_t count) {
    GLuint value = 0;
    for (std::size_t i = 0; i < count; ++i) value = value << 8 | std::to_integer<GLuint>(bytes[i]);
    return value;
}

// What is added to the list base; negative offsets wrap.
GLuint list_offset(const std::byte* bytes, GLenum type) {
    switch (type) {
        case GL_BYTE:
            return static_cast<GLuint>(read_as<GLbyte>(bytes));
        case GL_UNSIGNED_BYTE:
            return read_as<GLubyte>(bytes);
        case GL_SHORT:
            return static_cast<GLuint>(read_as<GLshort>(bytes));
        case GL_UNSIGNED_SHORT:
            return read_as<GLushort>(bytes);
        case GL_INT:
            return static_cast<GLuint>(read_as<GLint>(bytes));
        case GL_UNSIGNED_INT:
            return read_as<GLuint>(bytes);
        case GL_FLOAT:
            return float_list_offset(read_as<GLfloat>(bytes));
        default:
            return big_endian(bytes, list_name_bytes(type));
    }
}

}  // namespace

void list_out_of_memory(Context& ctx) {
    ctx.lists.out_of_memory = true;
    record_error(ctx, GL_OUT_OF_MEMORY, "not enough memory for the display list");
}

void record_list_error(Context& ctx, Allowed allowed, GLenum code, const char* rule) {
    record(ctx, [&](DisplayList& list) {
        auto& r = list.append<ErrorRecord>();
        r.allowed = allowed;
        r.code = code;
        r.rule = rule;
    });
}

void Compile::error(Context& ctx, Allowed allowed, GLenum code, const char* rule) {
    record_list_error(ctx, allowed, code, rule);
    if (ctx.lists.execute_too) play_error(ctx, {{}, allowed, code, rule});
}

void play_error(Context& ctx, const ErrorRecord& record) {
    if (ctx.vertex.open && record.allowed != Allowed::kAnywhere) {
        record_error(ctx, GL_INVALID_OPERATION, "not allowed between glBegin and glEnd");
    } else if (record.code != GL_NO_ERROR) {
        record_error(ctx, record.code, record.rule);
    }
}

void new_list(Context& ctx, GLuint list, GLenum mode) {
    if (list == 0) return record_error(ctx, GL_INVALID_VALUE, "list is 0");
    if (mode != GL_COMPILE && mode != GL_COMPILE_AND_EXECUTE) {
        return record_error(ctx, GL_INVALID_ENUM, "mode is neither GL_COMPILE nor GL_COMPILE_AND_EXECUTE");
    }
    if (ctx.lists.compiling)
        return record_error(ctx, GL_INVALID_OPERATION, "a list is being compiled already");
    ctx.lists.compiling = std::make_shared<DisplayList>();
    ctx.lists.compiling_name = list;
    ctx.lists.mode = mode;
    ctx.lists.execute_too = mode == GL_COMPILE_AND_EXECUTE;
    ctx.lists.out_of_memory = false;
    set_compiling(ctx, true);
}

void end_list(Context& ctx) {
    if (!ctx.lists.compiling) return record_error(ctx, GL_INVALID_OPERATION, "no list is being compiled");
    record(ctx, [](DisplayList&) {});  // what has been collected
    set_compiling(ctx, false);
    ctx.lists.vertices.reset();
    const std::shared_ptr<const DisplayList> finished = std::move(ctx.lists.compiling);
    const GLuint name = std::exchange(ctx.lists.compiling_name, 0);
    ctx.lists.mode = 0;
    ctx.lists.execute_too = false;
    if (ctx.lists.out_of_memory) return;  // the error was recorded when it happened; the old list stays
    std::shared_ptr<const DisplayList> replaced;  // freed after the lock is gone
    const std::lock_guard lock(ctx.shared->mutex);
    const auto [list, is_new] = ctx.shared->lists.try_emplace(name, finished);
    if (!is_new) {
        replaced = std::exchange(list->second, finished);
        return;
    }
    try {
        ctx.shared->list_names.insert(name, name);
    } catch (...) {
        ctx.shared->lists.erase(list);
        throw;
    }
}

void call_list(Context& ctx, GLuint list) {
    if (ctx.lists.nesting >= kMaxListNesting) return;
    const std::shared_ptr<const DisplayList> found = find_list(ctx, list);
    if (!found) return;
    struct Nesting {
        int& depth;
        explicit Nesting(int& now) : depth(now) { ++depth; }
        ~Nesting() { --depth; }
    } const nesting(ctx.lists.nesting);
    play(ctx, *found);
}

std::size_t call_lists_bytes(GLsizei n, GLenum type) {
    return n > 0 ? static_cast<std::size_t>(n) * list_name_bytes(type) : 0;
}

void call_lists(Context& ctx, GLsizei n, GLenum type, const void* lists) {
    if (n < 0) return record_error(ctx, GL_INVALID_VALUE, "n is negative");
    const std::size_t size = list_name_bytes(type);
    if (size == 0) return record_error(ctx, GL_INVALID_ENUM, "type is not one of list names");
    if (!lists && n > 0) return record_error(ctx, GL_INVALID_VALUE, "lists is null");
    const GLuint base = ctx.lists.base;  // a list that changes it changes later calls only
    const auto* bytes = static_cast<const std::byte*>(lists);
    for (GLsizei i = 0; i < n; ++i) {
        call_list(ctx, base + list_offset(bytes + static_cast<std::size_t>(i) * size, type));
    }
}

void list_base(Context& ctx, GLuint base) {
    ctx.lists.base = base;
}

GLuint gen_lists(Context& ctx, GLsizei range) {
    if (range < 0) {
        record_error(ctx, GL_INVALID_VALUE, "range is negative");
        return 0;
    }
    const std::lock_guard lock(ctx.shared->mutex);
    return ctx.shared->list_names.take(static_cast<GLuint>(range));
}

void delete_lists(Context& ctx, GLuint list, GLsizei range) {
    if (range < 0) return record_error(ctx, GL_INVALID_VALUE, "range is negative");
    if (range == 0) return;
    const GLuint more = static_cast<GLuint>(range) - 1;
    const GLuint last = list + std::min(more, ~list);
    const std::lock_guard lock(ctx.shared->mutex);
    auto& lists = ctx.shared->lists;
    ctx.shared->list_names.erase(list, last);
    lists.erase(lists.lower_bound(list), lists.upper_bound(last));
}

GLboolean is_list(Context& ctx, GLuint list) {
    const std::lock_guard lock(ctx.shared->mutex);
    return ctx.shared->list_names.contains(list) ? GL_TRUE : GL_FALSE;
}

}  // namespace terrazzo::gl
