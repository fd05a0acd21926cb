// Commands of buffer objects (GL 1.5 §2.9).
#include "gl/buffers.h"

#include <algorithm>
#include <cstring>
#include <mutex>
#include <new>
#include <span>

#include "gl/context.h"
#include "gl/generated/commands.h"
#include "gl/share.h"
#include "raster/target/sole_owner.h"

namespace terrazzo::gl {
namespace {

std::unique_lock<std::mutex> lock_buffers(const Context& ctx) {
    return std::unique_lock(ctx.shared->mutex);
}

// The binding that `target` names, null when it names none.
std::shared_ptr<BufferObject>* find_binding(Context& ctx, GLenum target) {
    switch (target) {
        case GL_ARRAY_BUFFER:
            return &ctx.arrays.array_buffer;
        case GL_ELEMENT_ARRAY_BUFFER:
            return &ctx.arrays.element_buffer;
        case GL_PIXEL_PACK_BUFFER:
            return &ctx.pixels.pack.buffer;
        case GL_PIXEL_UNPACK_BUFFER:
            return &ctx.pixels.unpack.buffer;
    }
    return nullptr;
}

// The buffer bound to `target`; records the error and returns null where there is none.
BufferObject* bound_buffer(Context& ctx, GLenum target) {
    const auto* const binding = find_binding(ctx, target);
    if (!binding) return record_error(ctx, GL_INVALID_ENUM, "unknown buffer target"), nullptr;
    if (!*binding) record_error(ctx, GL_INVALID_OPERATION, "no buffer object is bound");
    return binding->get();
}

bool is_usage(GLenum usage) {
    switch (usage) {
        case GL_STREAM_DRAW:
        case GL_STREAM_READ:
        case GL_STREAM_COPY:
        case GL_STATIC_DRAW:
        case GL_STATIC_READ:
        case GL_STATIC_COPY:
        case GL_DYNAMIC_DRAW:
        case GL_DYNAMIC_READ:
        case GL_DYNAMIC_COPY:
            return true;
    }
    return false;
}

// The part of the bound buffer's store that a SubData command works on; empty where it must fail or has
// nothing to do. The store stays even if another context replaces it meanwhile.
struct StorePart {
    std::shared_ptr<const BufferStore> store;
    std::span<std::byte> bytes;
};
StorePart sub_data(Context& ctx, GLenum target, GLintptr offset, GLsizeiptr size) {
    const BufferObject* const buffer = bound_buffer(ctx, target);
    if (!buffer) return {};
    const auto lock = lock_buffers(ctx);
    const auto whole = buffer->store ? static_cast<GLsizeiptr>(buffer->store->size()) : 0;
    if (offset < 0 || size < 0 || offset > whole || size > whole - offset) {
        return record_error(ctx, GL_INVALID_VALUE, "the range is not in the buffer's store"), StorePart{};
    }
    if (buffer->mapped) return record_error(ctx, GL_INVALID_OPERATION, "the buffer is mapped"), StorePart{};
    if (size == 0) return {};
    return {buffer->store, {buffer->store->data() + offset, static_cast<std::size_t>(size)}};
}

// A deleted object is unbound from everything in this context; others keep what they have bound.
void unbind(Context& ctx, const BufferObject* buffer) {
    forget_buffers(ctx.arrays, [&](const BufferObject& bound) { return &bound == buffer; });
    for (PixelStore* const store : {&ctx.pixels.pack, &ctx.pixels.unpack})
        if (store->buffer.get() == buffer) store->buffer.reset();
}

}  // namespace

BufferStore::BufferStore(std::size_t size, const void* data) : m_size(size) {
    // Memory from calloc is not touched until it is used.
    const std::size_t bytes = size == 0 ? 1 : size;
    m_bytes.reset(static_cast<std::byte*>(data ? std::malloc(bytes) : std::calloc(bytes, 1)));
    if (!m_bytes) throw std::bad_alloc();
    if (data) std::memcpy(m_bytes.get(), data, size);
}

ReadableBytes find_bytes(const Context& ctx, const BufferObject* buffer, const void* pointer) {
    ReadableBytes found;
    if (!buffer) {
        found.data = static_cast<const std::byte*>(pointer);
        found.size = static_cast<std::size_t>(-1);
        return found;
    }
    const auto lock = lock_buffers(ctx);
    found.mapped = buffer->mapped;
    const auto offset = reinterpret_cast<std::size_t>(pointer);
    if (!buffer->store || offset >= buffer->store->size()) return found;
    found.keep = buffer->store;
    found.data = buffer->store->data() + offset;
    found.size = buffer->store->size() - offset;
    return found;
}

bool is_live(const Context& ctx, const BufferObject& buffer) {
    const auto lock = lock_buffers(ctx);
    const auto found = ctx.shared->buffers.objects.find(buffer.name);
    return found != ctx.shared->buffers.objects.end() && found->second.get() == &buffer;
}

void gen_buffers(Context& ctx, GLsizei n, GLuint* buffers) {
    if (n < 0) return record_error(ctx, GL_INVALID_VALUE, "n is negative");
    const auto lock = lock_buffers(ctx);
    BufferNames& names = ctx.shared->buffers;
    GLsizei made = 0;
    try {
        for (; made < n; ++made) {
            while (names.next_name == 0 || names.objects.contains(names.next_name)) ++names.next_name;
            names.objects.emplace(names.next_name, nullptr);
            buffers[made] = names.next_name++;
        }
    } catch (...) {
        while (made > 0) names.objects.erase(buffers[--made]);
        throw;
    }
}

void delete_buffers(Context& ctx, GLsizei n, const GLuint* buffers) {
    if (n < 0) return record_error(ctx, GL_INVALID_VALUE, "n is negative");
    const auto lock = lock_buffers(ctx);
    auto& objects = ctx.shared->buffers.objects;
    for (GLsizei i = 0; i < n; ++i) {
        const auto found = objects.find(buffers[i]);
        if (found == objects.end()) continue;
        if (found->second) {
            found->second->mapped = false;
            unbind(ctx, found->second.get());
        }
        objects.erase(found);
    }
}

GLboolean is_buffer(Context& ctx, GLuint buffer) {
    const auto lock = lock_buffers(ctx);
    const auto found = ctx.shared->buffers.objects.find(buffer);
    return found != ctx.shared->buffers.objects.end() && found->second;
}

// Names need not come from GenBuffers (GL 1.5 §2.9).
void bind_buffer(Context& ctx, GLenum target, GLuint buffer) {
    auto* const binding = find_binding(ctx, target);
    if (!binding) return record_error(ctx, GL_INVALID_ENUM, "unknown buffer target");
    if (buffer == 0) return binding->reset();
    const auto lock = lock_buffers(ctx);
    auto& objects = ctx.shared->buffers.objects;
    const auto found = objects.find(buffer);
    std::shared_ptr<BufferObject> object = found == objects.end() ? nullptr : found->second;
    if (!object) {
        object = std::make_shared<BufferObject>();
        object->name = buffer;
        objects[buffer] = object;
    }
    *binding = std::move(object);
}

void buffer_data(Context& ctx, GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
    BufferObject* const buffer = bound_buffer(ctx, target);
    if (!buffer) return;
    if (size < 0) return record_error(ctx, GL_INVALID_VALUE, "the size is negative");
    if (!is_usage(usage)) return record_error(ctx, GL_INVALID_ENUM, "unknown usage");
    const auto bytes = static_cast<std::size_t>(size);
    const auto lock = lock_buffers(ctx);
    // Programs that stream vertices save the page faults of a new store.
    if (data && buffer->store && buffer->store->size() == bytes && raster::is_sole_owner(buffer->store)) {
        std::memcpy(buffer->store->data(), data, bytes);
    } else {
        buffer->store = std::make_shared<const BufferStore>(bytes, data);
    }
    buffer->usage = usage;
    buffer->access = GL_READ_WRITE;
    buffer->mapped = false;
}

void buffer_sub_data(Context& ctx, GLenum target, GLintptr offset, GLsizeiptr size, const void* data) {
    const StorePart to = sub_data(ctx, target, offset, size);
    std::copy_n(static_cast<const std::byte*>(data), to.bytes.size(), to.bytes.data());
}

void get_buffer_sub_data(Context& ctx, GLenum target, GLintptr offset, GLsizeiptr size, void* data) {
    const StorePart from = sub_data(ctx, target, offset, size);
    std::ranges::copy(from.bytes, static_cast<std::byte*>(data));
}

void* map_buffer(Context& ctx, GLenum target, GLenum access) {
    if (access != GL_READ_ONLY && access != GL_WRITE_ONLY && access != GL_READ_WRITE)
        return record_error(ctx, GL_INVALID_ENUM, "unknown access"), nullptr;
    BufferObject* const buffer = bound_buffer(ctx, target);
    if (!buffer) return nullptr;
    const auto lock = lock_buffers(ctx);
    if (buffer->mapped)
        return record_error(ctx, GL_INVALID_OPERATION, "the buffer is mapped already"), nullptr;
    // There is no pointer to nothing; the reference's error.
    if (!buffer->store || buffer->store->size() == 0)
        return record_error(ctx, GL_INVALID_OPERATION, "the buffer has no store"), nullptr;
    buffer->mapped = true;
    buffer->access = access;
    return buffer->store->data();
}

GLboolean unmap_buffer(Context& ctx, GLenum target) {
    BufferObject* const buffer = bound_buffer(ctx, target);
    if (!buffer) return GL_FALSE;
    const auto lock = lock_buffers(ctx);
    if (!buffer->mapped) return record_error(ctx, GL_INVALID_OPERATION, "the buffer is not mapped"), GL_FALSE;
    buffer->mapped = false;
    buffer->access = GL_READ_WRITE;
    return GL_TRUE;
}

void get_buffer_parameteriv(Context& ctx, GLenum target, GLenum pname, GLint* params) {
    const BufferObject* const buffer = bound_buffer(ctx, target);
    if (!buffer) return;
    const auto lock = lock_buffers(ctx);
    switch (pname) {
        case GL_BUFFER_SIZE:
            *params = buffer->store ? static_cast<GLint>(buffer->store->size()) : 0;
            return;
        case GL_BUFFER_USAGE:
            *params = static_cast<GLint>(buffer->usage);
            return;
        case GL_BUFFER_ACCESS:
            *params = static_cast<GLint>(buffer->access);
            return;
        case GL_BUFFER_MAPPED:
            *params = buffer->mapped;
            return;
    }
    record_error(ctx, GL_INVALID_ENUM, "no such buffer parameter");
}

void get_buffer_pointerv(Context& ctx, GLenum target, GLenum pname, void** params) {
    if (pname != GL_BUFFER_MAP_POINTER) return record_error(ctx, GL_INVALID_ENUM, "no such buffer pointer");
    const BufferObject* const buffer = bound_buffer(ctx, target);
    if (!buffer) return;
    const auto lock = lock_buffers(ctx);
    *params = buffer->mapped ? buffer->store->data() : nullptr;
}

}  // namespace terrazzo::gl
