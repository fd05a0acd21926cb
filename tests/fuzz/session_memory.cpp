// The memory behind a call's pointers: of the documented size, in a buffer object, or null; see session.h.
#include <algorithm>
#include <cstring>

#include "fuzz/arguments.h"
#include "fuzz/session.h"

namespace terrazzo::fuzz {
namespace {

constexpr std::uint64_t kMostBytes = 1 << 23;  // what takes more gets a null pointer

bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

// Memory that a context uses after the call that named it.
bool is_kept(std::string_view family) {
    return family.ends_with("Pointer") || family == "glInterleavedArrays" || family == "glFeedbackBuffer" ||
           family == "glSelectBuffer";
}

template <typename T>
void store(std::byte* memory, std::size_t index, T value) {
    std::memcpy(memory + index * sizeof value, &value, sizeof value);
}

void store_number(std::byte* memory, std::size_t index, char letter, double value) {
    const auto whole =
        static_cast<std::int64_t>(value >= -2147483648.0 && value <= 4294967295.0 ? value : 0x7fffffff);
    if (letter == 'd') return store(memory, index, value);
    if (letter == 'f') return store(memory, index, static_cast<float>(value));
    if (size_of(letter) == 1) return store(memory, index, static_cast<std::uint8_t>(whole));
    if (size_of(letter) == 2) return store(memory, index, static_cast<std::uint16_t>(whole));
    store(memory, index, static_cast<std::uint32_t>(whole));
}

// What a program would put there, some of the time.
void fill_plausibly(std::byte* memory, std::size_t bytes, const Command& command, const Parameter& parameter,
                    const Value* values, Random& random) {
    const std::size_t element = size_of(parameter.letter), count = bytes / element;
    const NamedValues given(command, values);
    if (parameter.object != ObjectClass::kNone) {
        for (std::size_t i = 0; i < count; ++i) store(memory, i, draw_name(random));
    } else if (parameter.name == "indices" || parameter.name == "lists") {
        const auto type = static_cast<GLenum>(given.integer("type"));
        const std::size_t size = parameter.name == "lists" ? bytes_of_list_name(type) : bytes_of_index(type);
        std::memset(memory, 0, bytes);
        for (std::size_t i = 0; size > 0 && i < bytes / size; ++i) {
            const auto value =
                static_cast<float>(random.below(parameter.name == "lists" ? kNames + 4 : kArrayElements));
            if (type == GL_FLOAT)
                store(memory, i, value);
            else
                memory[i * size + (type >= GL_2_BYTES && type <= GL_4_BYTES ? size - 1 : 0)] =
                    static_cast<std::byte>(value);
        }
    } else if (given.has("pname")) {
        for (std::size_t i = 0; i < count; ++i)
            store_number(memory, i, parameter.letter,
                         draw_parameter_value(static_cast<std::uint32_t>(given.integer("pname")), random));
    } else if (parameter.letter != 'v') {
        for (std::size_t i = 0; i < count && i < 4096; ++i)
            store_number(memory, i, parameter.letter, draw_real(random));
    }
}

}  // namespace

// The buffer object in which a pointer is an offset; zero for client memory.
GLint Session::buffer_for(std::string_view family, const Parameter& parameter) const {
    const ClientState& client = m_model->client;
    if (family.ends_with("Pointer") || family == "glInterleavedArrays") return client.array_buffer;
    if (parameter.name == "indices") return client.element_buffer;
    const bool pixels = contains(family, "Image") || contains(family, "Pixel") ||
                        contains(family, "PolygonStipple") || family == "glBitmap";
    if (!pixels) return 0;
    return parameter.is_output ? client.pack_buffer : client.unpack_buffer;
}

void Session::ask_client_state() {
    m_model->client = {ask_pixel_store(true),
                       ask_pixel_store(false),
                       integer(GL_PIXEL_PACK_BUFFER_BINDING),
                       integer(GL_PIXEL_UNPACK_BUFFER_BINDING),
                       integer(GL_ARRAY_BUFFER_BINDING),
                       integer(GL_ELEMENT_ARRAY_BUFFER_BINDING)};
}

PixelStore Session::ask_pixel_store(bool pack) const {
    const auto of = [&](GLenum for_pack, GLenum for_unpack) { return integer(pack ? for_pack : for_unpack); };
    PixelStore store{.alignment = std::max(of(GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT), 1),
                     .row_length = of(GL_PACK_ROW_LENGTH, GL_UNPACK_ROW_LENGTH),
                     .image_height = of(GL_PACK_IMAGE_HEIGHT, GL_UNPACK_IMAGE_HEIGHT),
                     .skip_pixels = of(GL_PACK_SKIP_PIXELS, GL_UNPACK_SKIP_PIXELS),
                     .skip_rows = of(GL_PACK_SKIP_ROWS, GL_UNPACK_SKIP_ROWS),
                     .skip_images = of(GL_PACK_SKIP_IMAGES, GL_UNPACK_SKIP_IMAGES)};
    return store;
}

SizeState Session::ask_sizes(const Command& command, const Value* values) const {
    const std::string_view family = command.family;
    const NamedValues given(command, values);
    SizeState state;
    state.pack = m_model->client.pack;
    state.unpack = m_model->client.unpack;
    const auto target = static_cast<GLenum>(given.integer("target"));
    if (family == "glGetTexImage" || family == "glGetCompressedTexImage") {
        const auto of_level = [&](GLenum pname) {
            GLint value = 0;
            gl.GetTexLevelParameteriv(target, static_cast<GLint>(given.integer("level")), pname, &value);
            return value;
        };
        state.image = {.width = of_level(GL_TEXTURE_WIDTH),
                       .height = of_level(GL_TEXTURE_HEIGHT),
                       .depth = of_level(GL_TEXTURE_DEPTH),
                       .has_images = target == GL_TEXTURE_3D};
        if (of_level(GL_TEXTURE_COMPRESSED))
            state.compressed_bytes = static_cast<std::uint64_t>(of_level(GL_TEXTURE_COMPRESSED_IMAGE_SIZE));
        if (options.shared) {  // another thread may specify the image meanwhile
            state.image = {.width = 66,
                           .height = 66,
                           .depth = target == GL_TEXTURE_3D ? 66 : 1,
                           .has_images = target == GL_TEXTURE_3D};
            state.compressed_bytes = 1 << 20;
        }
    }
    if (family.starts_with("glGetMap")) {
        GLint order[2] = {};
        const bool two = target >= GL_MAP2_COLOR_4 && target <= GL_MAP2_VERTEX_4;
        const unsigned components = components_of_map(target);
        if (components > 0) gl.GetMapiv(target, GL_ORDER, order);
        const auto query = static_cast<GLenum>(given.integer("query"));
        const auto points = static_cast<unsigned>(order[0] * (two ? order[1] : 1));
        if (query == GL_COEFF) state.map_values = std::uint64_t{points} * components;
        if (query == GL_ORDER && components > 0) state.map_values = two ? 2 : 1;
        if (query == GL_DOMAIN && components > 0) state.map_values = two ? 4 : 2;
    }
    const auto map = static_cast<GLenum>(given.integer("map"));
    if (family.starts_with("glGetPixelMap") && map >= GL_PIXEL_MAP_I_TO_I && map <= GL_PIXEL_MAP_A_TO_A)
        state.pixel_map_entries =
            static_cast<std::uint64_t>(integer(GL_PIXEL_MAP_I_TO_I_SIZE + (map - GL_PIXEL_MAP_I_TO_I)));
    state.list_formats = static_cast<std::uint64_t>(integer(GL_NUM_COMPRESSED_TEXTURE_FORMATS));
    return state;
}

void Session::provide(const Command& command, Random& random, Value* values, ClientMemory& transient) {
    if (command.family.starts_with("glMultiDraw")) return provide_draws(command, random, values, transient);
    if (std::ranges::none_of(command.parameters, &Parameter::is_pointer)) return;
    const SizeState state = ask_sizes(command, values);
    for (std::size_t i = 0; i < command.parameters.size(); ++i) {
        if (command.parameters[i].is_pointer)
            values[i].pointer = pointer_for(command, i, random, values, state, transient);
    }
}

void* Session::pointer_for(const Command& command, std::size_t index, Random& random, const Value* values,
                           const SizeState& state, ClientMemory& transient) {
    const Parameter& parameter = command.parameters[index];
    const bool is_null = random.one_in(24), is_plausible = random.one_in(2), is_aligned = random.one_in(2);
    const std::uint64_t offset =
        random.one_in(24) ? random.bits() >> random.below(64) : random.below(96) & (is_aligned ? ~7u : ~0u);
    if (buffer_for(command.family, parameter) != 0) return reinterpret_cast<void*>(offset);
    const std::uint64_t bytes = documented_bytes(command, index, values, state);
    if (bytes > kMostBytes || is_null) return nullptr;
    ClientMemory& memory = is_kept(command.family) ? m_model->memory : transient;
    const bool floats = command.family.ends_with("Pointer") || command.family == "glInterleavedArrays";
    std::byte* const block = memory.add(bytes, random,
                                        parameter.is_output ? Contents::kOutput
                                        : floats            ? Contents::kFloats
                                                            : Contents::kBytes);
    const bool must_fit = parameter.name == "indices" || parameter.object != ObjectClass::kNone;
    if (!parameter.is_output && (is_plausible || must_fit))
        fill_plausibly(block, bytes, command, parameter, values, random);
    return block;
}

// glMultiDrawArrays and glMultiDrawElements: counts, and first elements or where indices are.
void Session::provide_draws(const Command& command, Random& random, Value* values, ClientMemory& transient) {
    const bool elements = contains(command.name, "Elements");
    const NamedValues given(command, values);
    const auto draws = static_cast<std::size_t>(std::clamp<std::int64_t>(
        given.has("drawcount") ? given.integer("drawcount") : given.integer("primcount"), 0, 16));
    std::byte* const counts = transient.add(draws * sizeof(GLsizei), random, Contents::kZeros);
    std::byte* const others =
        transient.add(draws * (elements ? sizeof(void*) : sizeof(GLint)), random, Contents::kZeros);
    const bool in_buffer = elements && m_model->client.element_buffer != 0;
    for (std::size_t i = 0; i < draws; ++i) {
        const int count = random.one_in(40) ? -1 : random.between(0, kArrayElements / 4);
        store(counts, i, count);
        if (!elements) {
            store(others, i, random.between(0, kArrayElements / 2));
            continue;
        }
        const std::size_t bytes = static_cast<std::size_t>(std::max(count, 0)) *
                                  bytes_of_index(static_cast<GLenum>(given.integer("type")));
        std::byte* const indices = transient.add(bytes, random, Contents::kZeros);
        for (std::size_t at = 0; at < bytes; at += bytes_of_index(static_cast<GLenum>(given.integer("type"))))
            indices[at] = static_cast<std::byte>(random.bits());
        store(others, i, in_buffer ? reinterpret_cast<void*>(std::uintptr_t{random.below(64)}) : indices);
    }
    // glMultiDrawArrays(mode, first, count, drawcount); glMultiDrawElements(mode, count, type, indices,
    // drawcount).
    values[elements ? 1 : 2].pointer = counts;
    values[elements ? 3 : 1].pointer = others;
}

}  // namespace terrazzo::fuzz
