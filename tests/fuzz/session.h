// One thread of an episode: it makes calls, and knows what the documented sizes of their memory depend on.
// Input: commands with scalars drawn. Output: the calls, with memory of the size that the context's state
// asks for.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>

#include "fuzz/client_memory.h"
#include "fuzz/documented_size.h"
#include "fuzz/library.h"
#include "fuzz/random.h"

namespace terrazzo::fuzz {

// Client state that sizes depend on. It is asked for when it may have changed: between Begin and End it
// cannot, nor can it be asked for, but a list that is compiled there reads client memory all the same.
struct ClientState {
    PixelStore pack, unpack;
    GLint pack_buffer = 0, unpack_buffer = 0, array_buffer = 0, element_buffer = 0;
};

// What is known of a context beside what it answers.
struct ContextModel {
    ClientMemory memory;  // vertex arrays, feedback and selection: as long as the context
    ClientState client;
    bool arrays_asked = false;   // whether the next holds
    bool client_arrays = true;   // an enabled array is in client memory, which ends
    GLuint list = 0;             // being compiled
    unsigned calls_in_list = 0;  // of other lists
};

// What the watchdog looks at.
struct Progress {
    std::atomic<std::uint64_t> calls{0};
    std::atomic<const char*> call{nullptr};  // null between calls
    std::atomic<std::uint64_t> operation{0};
};

struct SessionOptions {
    bool trace = false;
    bool shared = false;  // other threads change the objects that this one uses
    unsigned thread = 0;
};

class Session {
  public:
    Session(const Library& library, const SessionOptions& options, Progress& progress)
        : gl(library.gl), library(library), options(options), m_progress(progress) {}

    // Draws the arguments and makes the call.
    void call(const Command& command, Random& random);
    // The same with scalars that the caller chose; pointers of them that are null get memory.
    void call_with(const Command& command, Random& random, Value* values);
    void call_with(std::string_view name, Random& random, std::initializer_list<double> scalars);

    // Says that a call begins, for the trace and the watchdog, and counts it; the call ends with the object.
    class Announced {
      public:
        Announced(Session& session, const char* name, std::string_view text);
        ~Announced();

      private:
        Session& m_session;
    };
    bool traces() const { return options.trace; }
    void begin_operation(std::uint64_t index) { m_progress.operation = index; }

    // The context's model changes when another context becomes current; null when none is.
    void set_model(ContextModel* model) { m_model = model; }
    ContextModel* model() { return m_model; }
    // Somebody else has called the library.
    void ask_again();

    // Between Begin and End, or without a context: queries answer nothing.
    bool answers() const;
    GLint integer(GLenum pname, GLint otherwise = 0) const;

    const kit::Gl& gl;
    const Library& library;
    const SessionOptions options;

  private:
    bool prepare(const Command& command, Value* values);
    bool prepare_list_call(const Command& command, Value* values);
    bool prepare_draw(const Command& command, Value* values);
    bool fits_arrays(const Command& command, Value* values);
    bool uses_client_arrays();
    void ask_arrays();
    SizeState ask_sizes(const Command& command, const Value* values) const;
    PixelStore ask_pixel_store(bool pack) const;
    void ask_client_state();
    GLint buffer_for(std::string_view family, const Parameter& parameter) const;
    void provide(const Command& command, Random& random, Value* values, ClientMemory& transient);
    void provide_draws(const Command& command, Random& random, Value* values, ClientMemory& transient);
    void* pointer_for(const Command& command, std::size_t parameter, Random& random, const Value* values,
                      const SizeState& state, ClientMemory& transient);
    void note_effects(const Command& command);

    Progress& m_progress;
    ContextModel* m_model = nullptr;
};

// "glBegin(GL_LINES)"; `bytes` are the sizes of the memory behind its pointers, where that is known.
std::string text_of(const Command& command, const Value* values);

}  // namespace terrazzo::fuzz
