// Buffer objects (GL 1.5 §2.9, table 6.8): memory of the library that vertex arrays, indices and pixels are
// read from, and pixels are written to.
//
// Buffer objects are shared between contexts; everything in one but the bytes of its store is accessed under
// the mutex of the share group. The store itself is replaced as a whole, so that who reads it takes a
// reference under the mutex and then needs it no more.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <unordered_map>

namespace terrazzo::gl {

struct Context;

class BufferStore {
  public:
    // A copy of `data`, or zeros where that is null. Throws std::bad_alloc.
    BufferStore(std::size_t size, const void* data);

    std::byte* data() const { return m_bytes.get(); }
    std::size_t size() const { return m_size; }

  private:
    struct Free {
        void operator()(std::byte* bytes) const { std::free(bytes); }
    };
    std::unique_ptr<std::byte, Free> m_bytes;
    std::size_t m_size;
};

struct BufferObject {
    GLuint name = 0;
    GLenum usage = GL_STATIC_DRAW;
    GLenum access = GL_READ_WRITE;
    bool mapped = false;
    std::shared_ptr<const BufferStore> store;  // null while nothing is specified
};

// Buffer objects by name, part of the share group. A name that GenBuffers returned and nothing has bound yet
// maps to null.
struct BufferNames {
    std::unordered_map<GLuint, std::shared_ptr<BufferObject>> objects;
    GLuint next_name = 1;
};

// Bytes that a command may read: of a buffer object from an offset on, or of the client, where nobody knows
// how many there are.
struct ReadableBytes {
    const std::byte* data = nullptr;  // null where there are none
    std::size_t size = 0;
    bool mapped = false;  // the command must fail then
    std::shared_ptr<const BufferStore> keep;
};

// What `pointer` means while `buffer` is bound, which may be null.
ReadableBytes find_bytes(const Context& ctx, const BufferObject* buffer, const void* pointer);

// The name of a binding that may be empty.
inline GLuint name_of(const std::shared_ptr<BufferObject>& buffer) {
    return buffer ? buffer->name : 0;
}

// Whether the object has not been deleted. Holds the mutex of the share group meanwhile.
bool is_live(const Context& ctx, const BufferObject& buffer);

}  // namespace terrazzo::gl
