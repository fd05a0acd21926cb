// Draws arguments; see arguments.h.
#include "fuzz/arguments.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <limits>

#include "fuzz/image_size.h"

namespace terrazzo::fuzz {
namespace {

constexpr int kMost = std::numeric_limits<int>::max(), kLeast = std::numeric_limits<int>::min();

bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

std::int64_t whole(double value) {
    return value >= kLeast && value <= kMost ? static_cast<std::int64_t>(value) : kMost;
}

std::int64_t draw_size(Random& random) {
    if (random.one_in(30)) return draw_integer(random);
    if (random.one_in(3)) return std::int64_t{1} << random.below(7);
    return random.one_in(200) ? random.between(0, 2100) : random.between(0, 40);
}

std::uint32_t draw_bits(const EnumGroup* group, Random& random) {
    if (!group || random.one_in(16)) return static_cast<std::uint32_t>(random.bits());
    if (random.one_in(8)) return ~0u;
    std::uint32_t bits = 0;
    for (unsigned i = 0; i < group->offered; ++i) bits |= random.one_in(2) ? group->enumerants[i].value : 0;
    return bits;
}

// The targets that a command of so many dimensions takes.
std::uint32_t draw_texture_target(std::string_view command, Random& random) {
    if (contains(command, "1D"))
        return random.of<std::uint32_t>({GL_TEXTURE_1D, GL_TEXTURE_1D, GL_TEXTURE_1D, GL_PROXY_TEXTURE_1D});
    if (contains(command, "3D"))
        return random.of<std::uint32_t>({GL_TEXTURE_3D, GL_TEXTURE_3D, GL_TEXTURE_3D, GL_PROXY_TEXTURE_3D});
    const std::uint32_t face = GL_TEXTURE_CUBE_MAP_POSITIVE_X + random.below(6);
    if (contains(command, "2D"))
        return random.of<std::uint32_t>(
            {GL_TEXTURE_2D, GL_TEXTURE_2D, face, face, GL_PROXY_TEXTURE_2D, GL_PROXY_TEXTURE_CUBE_MAP});
    if (contains(command, "Image") || contains(command, "Level"))
        return random.of<std::uint32_t>({GL_TEXTURE_1D, GL_TEXTURE_2D, face, GL_TEXTURE_3D});
    return random.of<std::uint32_t>(
        {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_2D, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_3D});
}

std::uint32_t draw_internal_format(Random& random) {
    return random.of<std::uint32_t>({1,
                                     2,
                                     3,
                                     4,
                                     GL_ALPHA,
                                     GL_ALPHA8,
                                     GL_LUMINANCE,
                                     GL_LUMINANCE8,
                                     GL_LUMINANCE_ALPHA,
                                     GL_LUMINANCE8_ALPHA8,
                                     GL_INTENSITY,
                                     GL_INTENSITY16,
                                     GL_RGB,
                                     GL_RGB8,
                                     GL_RGB5,
                                     GL_R3_G3_B2,
                                     GL_RGB16,
                                     GL_RGBA,
                                     GL_RGBA8,
                                     GL_RGBA4,
                                     GL_RGB5_A1,
                                     GL_RGB10_A2,
                                     GL_RGBA16,
                                     GL_DEPTH_COMPONENT,
                                     GL_DEPTH_COMPONENT16,
                                     GL_DEPTH_COMPONENT24,
                                     GL_DEPTH_COMPONENT32,
                                     GL_DEPTH_STENCIL,
                                     GL_DEPTH24_STENCIL8,
                                     GL_STENCIL_INDEX8,
                                     GL_COMPRESSED_RGB,
                                     GL_COMPRESSED_RGBA,
                                     GL_COMPRESSED_RGB_S3TC_DXT1_EXT,
                                     GL_COMPRESSED_RGBA_S3TC_DXT1_EXT,
                                     GL_COMPRESSED_RGBA_S3TC_DXT3_EXT,
                                     GL_COMPRESSED_RGBA_S3TC_DXT5_EXT});
}

std::uint32_t draw_enum(const Command& command, const Parameter& parameter, Random& random) {
    if (random.one_in(40))
        return static_cast<std::uint32_t>(random.one_in(2) ? draw_integer(random)
                                                           : static_cast<std::int64_t>(random.below(0x9500)));
    if (random.one_in(40))
        return draw_enumerant(groups()[random.below(static_cast<unsigned>(groups().size()))], random);
    if (parameter.name == "texture" && contains(command.name, "exture")) return GL_TEXTURE0 + random.below(9);
    if (parameter.name == "target" && contains(command.name, "MultiTexCoord"))
        return GL_TEXTURE0 + random.below(9);
    if (parameter.group < 0)
        return draw_enumerant(groups()[random.below(static_cast<unsigned>(groups().size()))], random);
    const EnumGroup& group = groups()[static_cast<std::size_t>(parameter.group)];
    if (group.name == "TextureTarget" && !random.one_in(6)) return draw_texture_target(command.name, random);
    if (group.name == "InternalFormat" && !random.one_in(6)) return draw_internal_format(random);
    return draw_enumerant(group, random);
}

std::int64_t draw_whole(const Command& command, const Parameter& parameter, Random& random) {
    const std::string_view name = parameter.name, of = command.name;
    if (parameter.group >= 0) return draw_enum(command, parameter, random);
    if (parameter.object == ObjectClass::kList || contains(of, "List")) return draw_name(random);
    if (parameter.object != ObjectClass::kNone) return draw_name(random);
    if (name == "width" || name == "height") return draw_size(random);
    if (name == "depth" && parameter.letter == 'n')
        return random.one_in(30) ? draw_integer(random) : random.between(0, 9);
    if (name == "level")
        return random.one_in(20) ? draw_integer(random) : random.one_in(2) ? 0 : random.between(0, 6);
    if (name == "border") return random.one_in(50) ? draw_integer(random) : random.one_in(6);
    if (contains(of, "PixelStore"))
        return random.one_in(24)  ? draw_integer(random)
               : random.one_in(2) ? 1 << random.below(4)
                                  : random.between(0, 40);
    if (name == "stride")
        return random.one_in(24) ? draw_integer(random) : random.one_in(2) ? 0 : random.between(0, 72);
    if (name == "ustride" || name == "vstride")
        return random.one_in(24) ? draw_integer(random) : random.between(1, 20);
    if (contains(name, "order")) return random.one_in(24) ? draw_integer(random) : random.between(1, 8);
    if (name == "size" && contains(of, "Pointer"))
        return random.one_in(24) ? draw_integer(random) : random.one_in(12) ? GL_BGRA : random.between(1, 4);
    if (contains(of, "MapGrid")) return random.one_in(24) ? draw_integer(random) : random.between(1, 12);
    if (contains(of, "Eval")) return random.one_in(24) ? draw_integer(random) : random.between(-3, 14);
    if (parameter.letter == 'p') return random.one_in(24) ? draw_integer(random) : random.between(0, 600);
    return random.one_in(12) ? draw_integer(random) : random.between(-2, 48);
}

// Makes format and type, or internal format and format, fit each other as they do in programs.
void match_formats(const Command& command, Random& random, Value* values) {
    Value *format = nullptr, *type = nullptr, *internal = nullptr;
    for (std::size_t i = 0; i < command.parameters.size(); ++i) {
        const std::string_view name = command.parameters[i].name;
        if (name == "format") format = &values[i];
        if (name == "type") type = &values[i];
        if (name == "internalformat") internal = &values[i];
    }
    if (!format || !type || random.one_in(5)) return;
    const auto kind = internal ? static_cast<GLenum>(internal->integer) : GL_RGBA;
    const bool depth = kind >= GL_DEPTH_COMPONENT16 && kind <= GL_DEPTH_COMPONENT32;
    if (depth || kind == GL_DEPTH_COMPONENT) format->integer = GL_DEPTH_COMPONENT;
    if (kind == GL_DEPTH_STENCIL || kind == GL_DEPTH24_STENCIL8 || format->integer == GL_DEPTH_STENCIL) {
        format->integer = GL_DEPTH_STENCIL;
        type->integer = GL_UNSIGNED_INT_24_8;
        return;
    }
    const unsigned packed = packed_components(static_cast<GLenum>(type->integer));
    if (packed == 3) format->integer = GL_RGB;
    if (packed == 4 && !random.one_in(4)) format->integer = random.of<std::int64_t>({GL_RGBA, GL_BGRA});
    if (packed == 2 || packed == 0)
        type->integer = random.of<std::int64_t>({GL_UNSIGNED_BYTE, GL_FLOAT, GL_SHORT, GL_UNSIGNED_INT});
    const bool index = format->integer == GL_COLOR_INDEX || format->integer == GL_STENCIL_INDEX;
    if (type->integer == GL_BITMAP && !index) type->integer = GL_UNSIGNED_BYTE;
}

}  // namespace

std::uint32_t draw_enumerant(const EnumGroup& group, Random& random) {
    const bool offered = group.offered > 0 && !random.one_in(12);
    const auto count = offered ? group.offered : static_cast<unsigned>(group.enumerants.size());
    return group.enumerants[random.below(count)].value;
}

std::uint32_t draw_name(Random& random) {
    if (random.one_in(30)) return static_cast<std::uint32_t>(draw_integer(random));
    return random.below(kNames + 1);
}

std::int64_t draw_integer(Random& random) {
    const std::int64_t power = std::int64_t{1} << random.below(33);
    return random.of<std::int64_t>({0,
                                    1,
                                    -1,
                                    2,
                                    3,
                                    4,
                                    255,
                                    256,
                                    65535,
                                    65536,
                                    kMost,
                                    kMost - 1,
                                    kLeast,
                                    kLeast + 1,
                                    0xffffffff,
                                    power,
                                    power - 1,
                                    -power,
                                    power + 1,
                                    std::numeric_limits<std::int64_t>::max(),
                                    std::numeric_limits<std::int64_t>::min()});
}

double draw_real(Random& random) {
    using Floats = std::numeric_limits<float>;
    using Doubles = std::numeric_limits<double>;
    if (!random.one_in(10)) return random.between(-100, 100) / (random.one_in(2) ? 100.0 : 8.0);
    return random.of<double>({0.0, -0.0, 1.0, -1.0, 0.5, 1e30, -1e30, 1e-30, Floats::max(), -Floats::max(),
                              Floats::denorm_min(), Doubles::infinity(), -Doubles::infinity(),
                              Doubles::quiet_NaN(), 1e300, -1e300, 2147483648.0, 65536.0, 16777217.0});
}

double draw_parameter_value(std::uint32_t pname, Random& random) {
    if (random.one_in(12)) return draw_real(random);
    const auto one_of_group = [&](std::string_view name) {
        return static_cast<double>(draw_enumerant(*find_group(name), random));
    };
    switch (pname) {
        case GL_TEXTURE_MIN_FILTER:
        case GL_TEXTURE_MAG_FILTER:
            return random.of<double>({GL_NEAREST, GL_LINEAR, GL_NEAREST, GL_LINEAR, GL_NEAREST_MIPMAP_NEAREST,
                                      GL_LINEAR_MIPMAP_NEAREST, GL_NEAREST_MIPMAP_LINEAR,
                                      GL_LINEAR_MIPMAP_LINEAR});
        case GL_TEXTURE_WRAP_S:
        case GL_TEXTURE_WRAP_T:
        case GL_TEXTURE_WRAP_R:
            return random.of<double>(
                {GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT});
        case GL_FOG_MODE:
            return random.of<double>({GL_LINEAR, GL_EXP, GL_EXP2});
        case GL_TEXTURE_ENV_MODE:
            return random.of<double>(
                {GL_MODULATE, GL_DECAL, GL_BLEND, GL_REPLACE, GL_ADD, GL_COMBINE, GL_COMBINE});
        case GL_COMBINE_RGB:
        case GL_COMBINE_ALPHA:
            return random.of<double>({GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE,
                                      GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA});
        case GL_SRC0_RGB:
        case GL_SRC1_RGB:
        case GL_SRC2_RGB:
        case GL_SRC0_ALPHA:
        case GL_SRC1_ALPHA:
        case GL_SRC2_ALPHA:
            return random.of<double>({GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS, GL_TEXTURE0,
                                      GL_TEXTURE0 + 5.0, GL_TEXTURE0 + 8.0, GL_ZERO, GL_ONE});
        case GL_TEXTURE_GEN_MODE:
            return random.of<double>(
                {GL_EYE_LINEAR, GL_OBJECT_LINEAR, GL_SPHERE_MAP, GL_NORMAL_MAP, GL_REFLECTION_MAP});
        case GL_DEPTH_TEXTURE_MODE:
            return random.of<double>({GL_LUMINANCE, GL_INTENSITY, GL_ALPHA});
        case GL_TEXTURE_COMPARE_MODE:
            return random.of<double>({GL_NONE, GL_COMPARE_R_TO_TEXTURE});
        case GL_TEXTURE_COMPARE_FUNC:
            return one_of_group("DepthFunction");
        case GL_LIGHT_MODEL_COLOR_CONTROL:
            return random.of<double>({GL_SINGLE_COLOR, GL_SEPARATE_SPECULAR_COLOR});
        case GL_FOG_COORDINATE_SOURCE:
            return random.of<double>({GL_FOG_COORDINATE, GL_FRAGMENT_DEPTH});
        case GL_OPERAND0_RGB:
        case GL_OPERAND1_RGB:
        case GL_OPERAND2_RGB:
            return random.of<double>(
                {GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA});
        case GL_RGB_SCALE:
        case GL_ALPHA_SCALE:
            return random.of<double>({1, 2, 4});
        case GL_SHININESS:
        case GL_SPOT_EXPONENT:
            return random.between(0, 128);
        case GL_SPOT_CUTOFF:
            return random.one_in(2) ? 180 : random.between(0, 90);
        case GL_TEXTURE_BASE_LEVEL:
        case GL_TEXTURE_MAX_LEVEL:
            return random.one_in(8) ? draw_real(random) : random.between(0, 6);
    }
    return random.one_in(3) ? random.between(0, 1) : draw_real(random);
}

void draw_scalars(const Command& command, Random& random, Value* values) {
    std::uint32_t pname = 0;
    for (std::size_t i = 0; i < command.parameters.size(); ++i) {
        const Parameter& parameter = command.parameters[i];
        Value& value = values[i];
        value = {};
        if (parameter.is_pointer || parameter.letter == 'z' || parameter.letter == 'P') continue;
        switch (parameter.letter) {
            case 'e':
                value.integer = draw_enum(command, parameter, random);
                break;
            case 'm':
                value.integer = draw_bits(
                    parameter.group < 0 ? nullptr : &groups()[static_cast<std::size_t>(parameter.group)],
                    random);
                break;
            case 'f':
            case 'd':
                value.real =
                    parameter.name == "param" ? draw_parameter_value(pname, random) : draw_real(random);
                break;
            case 'b':
            case 'B':
            case 's':
            case 'S':
            case 'o':
                value.integer = random.one_in(2) ? random.between(-2, 8)
                                                 : static_cast<std::int64_t>(random.bits() & 0xffff);
                break;
            default:
                value.integer = parameter.name == "param" && !contains(command.name, "PixelStore")
                                    ? whole(draw_parameter_value(pname, random))
                                    : draw_whole(command, parameter, random);
        }
        if (parameter.name == "pname") pname = static_cast<std::uint32_t>(value.integer);
    }
    match_formats(command, random, values);
}

}  // namespace terrazzo::fuzz
