// Calls, and what must be asked before them; see session.h. Sizes and memory are in session_memory.cpp.
#include "fuzz/session.h"

#include <algorithm>
#include <cstdio>
#include <mutex>
#include <shared_mutex>

#include "fuzz/arguments.h"
#include "fuzz/bounded_work.h"

namespace terrazzo::fuzz {
namespace {

constexpr unsigned kMostCallsInList = 2;  // of other lists, each of which has a smaller name

bool is_plain(std::int64_t list) {
    return list >= 1 && list <= kPlainLists;
}

// Who shares a buffer keeps apart by himself who writes its bytes and who reads them; everything else about
// it is the library's to synchronise.
std::shared_mutex g_contents;

bool may_write_buffers(const Command& command, const ClientState& client) {
    if (command.family == "glBufferSubData") return true;
    const bool packs = command.family == "glReadPixels" || command.family == "glGetTexImage" ||
                       command.family == "glGetCompressedTexImage" ||
                       command.family == "glGetPolygonStipple" || command.family.starts_with("glGetPixelMap");
    return packs && client.pack_buffer != 0;
}

// What the command's parameter makes of the number.
void truncate(char letter, Value& value) {
    if (letter == 'n' || letter == 'i') value.integer = static_cast<std::int32_t>(value.integer);
    if (letter == 'u' || letter == 'e' || letter == 'm')
        value.integer = static_cast<std::uint32_t>(value.integer);
}

void print_value(std::string& out, const Parameter& parameter, const Value& value) {
    char text[64];
    if (parameter.is_pointer || parameter.letter == 'z' || parameter.letter == 'P') {
        std::snprintf(text, sizeof text, value.pointer ? "(void*)%p" : "NULL", value.pointer);
        out += text;
        return;
    }
    const std::string_view name = enumerant_name(parameter.group, static_cast<std::uint32_t>(value.integer));
    if (!name.empty()) {
        out += name;
        return;
    }
    if (parameter.letter == 'f' || parameter.letter == 'd') {
        std::snprintf(text, sizeof text, "%.9g", value.real);
    } else {
        std::snprintf(text, sizeof text,
                      parameter.letter == 'e' || parameter.letter == 'm' ? "0x%llx" : "%lld",
                      static_cast<long long>(value.integer));
    }
    out += text;
}

}  // namespace

std::string text_of(const Command& command, const Value* values) {
    std::string out(command.name);
    out += '(';
    for (std::size_t i = 0; i < command.parameters.size(); ++i) {
        if (i > 0) out += ", ";
        print_value(out, command.parameters[i], values[i]);
    }
    return out + ")";
}

Session::Announced::Announced(Session& session, const char* name, std::string_view text)
    : m_session(session) {
    session.m_progress.calls.fetch_add(1, std::memory_order_relaxed);
    session.m_progress.call.store(name, std::memory_order_relaxed);
    if (!session.options.trace) return;
    std::fprintf(stderr, "%u:%llu  %.*s;\n", session.options.thread,
                 static_cast<unsigned long long>(session.m_progress.operation.load()),
                 static_cast<int>(text.size()), text.data());
}

Session::Announced::~Announced() {
    m_session.m_progress.call.store(nullptr, std::memory_order_relaxed);
}

bool Session::answers() const {
    return integer(GL_MATRIX_MODE, -1) != -1;
}

GLint Session::integer(GLenum pname, GLint otherwise) const {
    GLint values[16] = {otherwise};
    gl.GetIntegerv(pname, values);
    return values[0];
}

void Session::call(const Command& command, Random& random) {
    Value values[kMostParameters];
    draw_scalars(command, random, values);
    call_with(command, random, values);
}

void Session::call_with(std::string_view name, Random& random, std::initializer_list<double> scalars) {
    const Command& command = find_command(name);
    Value values[kMostParameters];
    std::size_t i = 0;
    for (const double scalar : scalars) {
        values[i].integer = static_cast<std::int64_t>(scalar);
        values[i++].real = scalar;
    }
    call_with(command, random, values);
}

void Session::call_with(const Command& command, Random& random, Value* values) {
    const Function function = library.function(command);
    if (!function || !m_model) return;
    for (std::size_t i = 0; i < command.parameters.size(); ++i)
        truncate(command.parameters[i].letter, values[i]);
    bound_work(command, values, options.shared);
    if (!prepare(command, values)) return;
    ClientMemory transient;
    provide(command, random, values, transient);
    {
        std::unique_lock writing(g_contents, std::defer_lock);
        std::shared_lock reading(g_contents, std::defer_lock);
        if (options.shared) may_write_buffers(command, m_model->client) ? writing.lock() : reading.lock();
        const Announced announced(*this, command.name.data(),
                                  options.trace ? text_of(command, values) : std::string());
        command.invoke(function, values);
    }
    transient.check();
    note_effects(command);
}

// False where the call must not be made: its documented memory would be endless, or its work.
bool Session::prepare(const Command& command, Value* values) {
    const std::string_view family = command.family;
    if (family == "glCallList" || family == "glCallLists") return prepare_list_call(command, values);
    if (family == "glArrayElement" || family.starts_with("glDraw") || family.starts_with("glMultiDraw"))
        return prepare_draw(command, values);
    return true;
}

// Lists call lists of smaller names, and those at most two: what one call carries out stays bounded. Lists of
// greater names call one list of any name: chains, and circles of them.
bool Session::prepare_list_call(const Command& command, Value* values) {
    if (command.family == "glCallLists" && values[0].integer > 8) values[0].integer = 8;
    if (m_model->list == 0) return true;
    const bool plain = is_plain(m_model->list);
    if (m_model->calls_in_list >= (plain ? kMostCallsInList : 1)) return false;
    if (command.family == "glCallLists") {
        if (plain || values[0].integer > 1) return false;
    } else if (plain && (values[0].integer < 1 || values[0].integer >= m_model->list)) {
        return false;
    }
    ++m_model->calls_in_list;
    return true;
}

// Arrays in client memory end: only elements inside may be drawn.
bool Session::prepare_draw(const Command& command, Value* values) {
    if (command.family.starts_with("glDrawPixels") || command.family == "glDrawBuffer") return true;
    return !uses_client_arrays() || fits_arrays(command, values);
}

bool Session::fits_arrays(const Command& command, Value* values) {
    const auto inside = [](std::int64_t& value) { value = value < 0 ? value : value % (kArrayElements / 2); };
    if (command.family == "glArrayElement") {
        if (values[0].integer < 0) return false;
        inside(values[0].integer);
        return true;
    }
    if (command.family == "glDrawArrays") {
        if (values[1].integer < 0) return false;
        inside(values[1].integer);
        inside(values[2].integer);
        return true;
    }
    if (command.family == "glMultiDrawArrays" || m_model->client.element_buffer == 0) return true;
    const NamedValues given(command, values);
    return given.integer("type") == GL_UNSIGNED_BYTE;  // the others may name any element
}

bool Session::uses_client_arrays() {
    if (!m_model->arrays_asked || options.shared) ask_arrays();
    return m_model->client_arrays;
}

void Session::ask_arrays() {
    if (!answers()) {
        m_model->client_arrays |= !m_model->arrays_asked;
        return;
    }
    struct Array {
        GLenum name, buffer;
    };
    constexpr Array kArrays[] = {{GL_VERTEX_ARRAY, GL_VERTEX_ARRAY_BUFFER_BINDING},
                                 {GL_NORMAL_ARRAY, GL_NORMAL_ARRAY_BUFFER_BINDING},
                                 {GL_COLOR_ARRAY, GL_COLOR_ARRAY_BUFFER_BINDING},
                                 {GL_INDEX_ARRAY, GL_INDEX_ARRAY_BUFFER_BINDING},
                                 {GL_EDGE_FLAG_ARRAY, GL_EDGE_FLAG_ARRAY_BUFFER_BINDING},
                                 {GL_SECONDARY_COLOR_ARRAY, GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING},
                                 {GL_FOG_COORDINATE_ARRAY, GL_FOG_COORDINATE_ARRAY_BUFFER_BINDING}};
    const auto in_client_memory = [&](const Array& array) {
        return gl.IsEnabled(array.name) && integer(array.buffer) == 0;
    };
    bool any = std::ranges::any_of(kArrays, in_client_memory);
    const GLint active = integer(GL_CLIENT_ACTIVE_TEXTURE), units = integer(GL_MAX_TEXTURE_UNITS);
    for (GLint unit = 0; unit < units && !any; ++unit) {
        gl.ClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        any = in_client_memory({GL_TEXTURE_COORD_ARRAY, GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING});
    }
    gl.ClientActiveTexture(static_cast<GLenum>(active));
    m_model->client_arrays = any;
    m_model->arrays_asked = true;
}

void Session::ask_again() {
    m_model->arrays_asked = false;
    if (answers()) ask_client_state();
}

void Session::note_effects(const Command& command) {
    const std::string_view family = command.family;
    if (family == "glNewList" || family == "glEndList") {
        const auto list = static_cast<GLuint>(integer(GL_LIST_INDEX, static_cast<GLint>(m_model->list)));
        if (list != m_model->list) m_model->calls_in_list = 0;
        m_model->list = list;
    }
    const bool arrays = family.ends_with("Pointer") || family.ends_with("ClientState") ||
                        family.ends_with("ClientAttrib") || family == "glInterleavedArrays" ||
                        family == "glDeleteBuffers";
    if (arrays) m_model->arrays_asked = false;
    const bool client = family.starts_with("glPixelStore") || family == "glPopClientAttrib" ||
                        family == "glBindBuffer" || family == "glDeleteBuffers";
    if (client && answers()) ask_client_state();
}

}  // namespace terrazzo::fuzz
