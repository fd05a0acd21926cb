// Sizes of client memory; see documented_size.h.
#include "fuzz/documented_size.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <string>

namespace terrazzo::fuzz {
namespace {

bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

// Vectors of parameters, by what takes them.
unsigned values_of_vector(std::string_view family, GLenum pname) {
    const auto is_color = [&](std::initializer_list<GLenum> names) {
        return std::ranges::find(names, pname) != names.end();
    };
    if (contains(family, "Fog")) return pname == GL_FOG_COLOR ? 4 : 1;
    if (contains(family, "LightModel")) return pname == GL_LIGHT_MODEL_AMBIENT ? 4 : 1;
    if (contains(family, "Light")) {
        if (pname == GL_SPOT_DIRECTION) return 3;
        return is_color({GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_POSITION}) ? 4 : 1;
    }
    if (contains(family, "Material")) {
        if (pname == GL_COLOR_INDEXES) return 3;
        return is_color({GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_AMBIENT_AND_DIFFUSE}) ? 4 : 1;
    }
    if (contains(family, "PointParameter")) return pname == GL_POINT_DISTANCE_ATTENUATION ? 3 : 1;
    if (contains(family, "TexEnv")) return pname == GL_TEXTURE_ENV_COLOR ? 4 : 1;
    if (contains(family, "TexGen")) return is_color({GL_OBJECT_PLANE, GL_EYE_PLANE}) ? 4 : 1;
    if (contains(family, "TexParameter")) return pname == GL_TEXTURE_BORDER_COLOR ? 4 : 1;
    return 1;
}

// Of glGet; names that are not here have one value.
unsigned values_of_variable(GLenum pname, std::uint64_t list_formats) {
    switch (pname) {
        case GL_MODELVIEW_MATRIX:
        case GL_PROJECTION_MATRIX:
        case GL_TEXTURE_MATRIX:
        case GL_COLOR_MATRIX:
        case GL_TRANSPOSE_MODELVIEW_MATRIX:
        case GL_TRANSPOSE_PROJECTION_MATRIX:
        case GL_TRANSPOSE_TEXTURE_MATRIX:
        case GL_TRANSPOSE_COLOR_MATRIX:
            return 16;
        case GL_ACCUM_CLEAR_VALUE:
        case GL_BLEND_COLOR:
        case GL_COLOR_CLEAR_VALUE:
        case GL_COLOR_WRITEMASK:
        case GL_CURRENT_COLOR:
        case GL_CURRENT_SECONDARY_COLOR:
        case GL_CURRENT_TEXTURE_COORDS:
        case GL_CURRENT_RASTER_COLOR:
        case GL_CURRENT_RASTER_SECONDARY_COLOR:
        case GL_CURRENT_RASTER_POSITION:
        case GL_CURRENT_RASTER_TEXTURE_COORDS:
        case GL_FOG_COLOR:
        case GL_LIGHT_MODEL_AMBIENT:
        case GL_MAP2_GRID_DOMAIN:
        case GL_SCISSOR_BOX:
        case GL_VIEWPORT:
            return 4;
        case GL_CURRENT_NORMAL:
        case GL_POINT_DISTANCE_ATTENUATION:
            return 3;
        case GL_ALIASED_LINE_WIDTH_RANGE:
        case GL_ALIASED_POINT_SIZE_RANGE:
        case GL_DEPTH_RANGE:
        case GL_LINE_WIDTH_RANGE:
        case GL_MAP1_GRID_DOMAIN:
        case GL_MAP2_GRID_SEGMENTS:
        case GL_MAX_VIEWPORT_DIMS:
        case GL_POINT_SIZE_RANGE:
        case GL_POLYGON_MODE:
            return 2;
        case GL_COMPRESSED_TEXTURE_FORMATS:
            return static_cast<unsigned>(list_formats);
    }
    return 1;
}

bool is_plain_get(std::string_view family) {
    return family == "glGetBooleanv" || family == "glGetIntegerv" || family == "glGetFloatv" ||
           family == "glGetDoublev";
}

std::uint64_t bytes_of_points(const Command& command, const NamedValues& given, unsigned element) {
    const auto components = std::int64_t{components_of_map(static_cast<GLenum>(given.integer("target")))};
    const bool two = contains(command.name, "2");
    const auto side = [&](const char* stride, const char* order, std::int64_t& extent) {
        const std::int64_t count = given.integer(order), step = given.integer(stride);
        extent = (count - 1) * step;
        return count >= 1 && count <= 64 && step >= components;
    };
    std::int64_t u = 0, v = 0;
    const bool valid =
        two ? side("ustride", "uorder", u) && side("vstride", "vorder", v) : side("stride", "order", u);
    return components == 0 || !valid ? 0 : static_cast<std::uint64_t>(u + v + components) * element;
}

std::uint64_t bytes_of_array(const Command& command, const NamedValues& given) {
    const std::int64_t stride = given.integer("stride");
    std::uint64_t element = 1;  // edge flags
    if (command.family == "glInterleavedArrays") {
        element = 15 * 4 + 4;  // the largest format, so that the later draws' few bytes need not be known
    } else if (given.has("type")) {
        const bool normal = contains(command.name, "Normal");
        const std::int64_t size = given.integer("size", normal ? 3 : 1);
        element = bytes_of_element(static_cast<GLint>(size == GL_BGRA ? 4 : size),
                                   static_cast<GLenum>(given.integer("type")));
    }
    if (stride < 0 || element == 0) return 0;
    return (kArrayElements - 1) * (stride == 0 ? element : static_cast<std::uint64_t>(stride)) + element;
}

std::uint64_t bytes_of_image(const Command& command, const NamedValues& given, const SizeState& state) {
    const std::string_view family = command.family;
    if (family == "glGetTexImage") {
        ImageShape image = state.image;
        image.format = static_cast<GLenum>(given.integer("format"));
        image.type = static_cast<GLenum>(given.integer("type"));
        return image_bytes(state.pack, image);
    }
    const bool reads = family == "glReadPixels" || family == "glGetPolygonStipple";
    ImageShape image{.width = given.integer("width", 1),
                     .height = given.integer("height", 1),
                     .depth = given.integer("depth", 1),
                     .has_images = given.has("depth")};
    image.format = static_cast<GLenum>(given.integer("format", GL_COLOR_INDEX));
    image.type = static_cast<GLenum>(given.integer("type", GL_BITMAP));
    if (contains(family, "PolygonStipple")) image.width = image.height = 32;
    return image_bytes(reads ? state.pack : state.unpack, image);
}

std::uint64_t positive(std::int64_t value) {
    return value > 0 ? static_cast<std::uint64_t>(value) : 0;
}

}  // namespace

bool NamedValues::has(std::string_view name) const {
    return std::ranges::find(m_command.parameters, name, &Parameter::name) != m_command.parameters.end();
}

std::int64_t NamedValues::integer(std::string_view name, std::int64_t otherwise) const {
    const auto found = std::ranges::find(m_command.parameters, name, &Parameter::name);
    return found == m_command.parameters.end() ? otherwise
                                               : m_values[found - m_command.parameters.begin()].integer;
}

unsigned values_of_parameter(std::string_view family, GLenum pname, std::uint64_t list_formats) {
    if (is_plain_get(family)) return values_of_variable(pname, list_formats);
    return values_of_vector(family, pname);
}

unsigned components_of_map(GLenum target) {
    switch (target) {
        case GL_MAP1_INDEX:
        case GL_MAP2_INDEX:
        case GL_MAP1_TEXTURE_COORD_1:
        case GL_MAP2_TEXTURE_COORD_1:
            return 1;
        case GL_MAP1_TEXTURE_COORD_2:
        case GL_MAP2_TEXTURE_COORD_2:
            return 2;
        case GL_MAP1_VERTEX_3:
        case GL_MAP2_VERTEX_3:
        case GL_MAP1_NORMAL:
        case GL_MAP2_NORMAL:
        case GL_MAP1_TEXTURE_COORD_3:
        case GL_MAP2_TEXTURE_COORD_3:
            return 3;
        case GL_MAP1_VERTEX_4:
        case GL_MAP2_VERTEX_4:
        case GL_MAP1_COLOR_4:
        case GL_MAP2_COLOR_4:
        case GL_MAP1_TEXTURE_COORD_4:
        case GL_MAP2_TEXTURE_COORD_4:
            return 4;
    }
    return 0;
}

std::uint64_t bytes_of_element(GLint size, GLenum type) {
    if (size < 1 || size > 4) return 0;
    const auto count = static_cast<std::uint64_t>(size);
    switch (type) {
        case GL_BYTE:
        case GL_UNSIGNED_BYTE:
            return count;
        case GL_SHORT:
        case GL_UNSIGNED_SHORT:
            return 2 * count;
        case GL_INT:
        case GL_UNSIGNED_INT:
        case GL_FLOAT:
            return 4 * count;
        case GL_DOUBLE:
            return 8 * count;
    }
    return 0;
}

unsigned bytes_of_list_name(GLenum type) {
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
    }
    return 0;
}

unsigned bytes_of_index(GLenum type) {
    return type == GL_UNSIGNED_BYTE ? 1 : type == GL_UNSIGNED_SHORT ? 2 : type == GL_UNSIGNED_INT ? 4 : 0;
}

std::uint64_t documented_bytes(const Command& command, std::size_t index, const Value* values,
                               const SizeState& state) {
    const Parameter& parameter = command.parameters[index];
    const NamedValues given(command, values);
    const std::uint64_t element = size_of(parameter.letter);
    const std::string_view length = parameter.length, family = command.family;
    if (family.empty()) return 0;
    if (!length.empty() && std::isdigit(static_cast<unsigned char>(length[0])))
        return element * std::strtoul(length.data(), nullptr, 10);
    if (given.has(length)) return element * positive(given.integer(length));
    if (contains(family, "PolygonStipple") || contains(length, "width") || family == "glGetTexImage" ||
        family == "glBitmap")
        return bytes_of_image(command, given, state);
    if (family == "glGetCompressedTexImage") return state.compressed_bytes;
    if (family.starts_with("glMap") && parameter.name == "points")
        return bytes_of_points(command, given, static_cast<unsigned>(element));
    if (family.starts_with("glGetMap")) return state.map_values * element;
    if (family.starts_with("glGetPixelMap")) return state.pixel_map_entries * element;
    if (family == "glCallLists")
        return positive(given.integer("n")) * bytes_of_list_name(static_cast<GLenum>(given.integer("type")));
    if (length == "COMPSIZE(count,type)")
        return positive(given.integer("count")) * bytes_of_index(static_cast<GLenum>(given.integer("type")));
    if (family.ends_with("Pointer") || family == "glInterleavedArrays") return bytes_of_array(command, given);
    if (given.has("pname"))
        return element *
               values_of_parameter(family, static_cast<GLenum>(given.integer("pname")), state.list_formats);
    return 0;
}

}  // namespace terrazzo::fuzz
