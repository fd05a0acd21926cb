// Choosing arguments; see random_arguments.h. What a parameter means is told by its name, its group, and for
// parameters that say how another one is meant, by that one.
#include "random_arguments.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace terrazzo::test {
namespace {

constexpr std::size_t kMemoryBytes = 1 << 17;

bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

std::span<const GLenum> group_values(std::string_view name) {
    const auto* found = std::ranges::find(kGroups, name, &Group::name);
    return found == std::end(kGroups) ? std::span<const GLenum>{} : found->values;
}

constexpr GLenum kTargets1d[] = {GL_TEXTURE_1D, GL_TEXTURE_1D, GL_PROXY_TEXTURE_1D};
constexpr GLenum kTargets2d[] = {GL_TEXTURE_2D, GL_TEXTURE_2D, GL_PROXY_TEXTURE_2D,
                                 GL_TEXTURE_CUBE_MAP_POSITIVE_X, GL_TEXTURE_CUBE_MAP_NEGATIVE_Z};
constexpr GLenum kTargets3d[] = {GL_TEXTURE_3D, GL_TEXTURE_3D, GL_PROXY_TEXTURE_3D};
constexpr GLenum kObjectTargets[] = {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP};
constexpr GLenum kInternalFormats[] = {1,
                                       2,
                                       3,
                                       4,
                                       GL_ALPHA,
                                       GL_LUMINANCE,
                                       GL_LUMINANCE_ALPHA,
                                       GL_INTENSITY,
                                       GL_RGB,
                                       GL_RGBA,
                                       GL_RGB5,
                                       GL_RGBA4,
                                       GL_RGBA8,
                                       GL_RGB10_A2,
                                       GL_RGBA16,
                                       GL_DEPTH_COMPONENT,
                                       GL_RGB12,
                                       GL_R3_G3_B2,
                                       GL_LUMINANCE8,
                                       GL_LUMINANCE6_ALPHA2};
constexpr GLenum kClientFormats[] = {GL_RED,
                                     GL_GREEN,
                                     GL_BLUE,
                                     GL_ALPHA,
                                     GL_RGB,
                                     GL_RGBA,
                                     GL_RGBA,
                                     GL_BGR,
                                     GL_BGRA,
                                     GL_LUMINANCE,
                                     GL_LUMINANCE_ALPHA,
                                     GL_DEPTH_COMPONENT,
                                     GL_STENCIL_INDEX,
                                     GL_COLOR_INDEX};
constexpr GLenum kEnvTargets[] = {GL_TEXTURE_ENV, GL_TEXTURE_ENV, GL_TEXTURE_ENV, GL_TEXTURE_FILTER_CONTROL,
                                  GL_POINT_SPRITE};
constexpr GLenum kCombineSources[] = {GL_TEXTURE,  GL_TEXTURE0,      GL_TEXTURE3,
                                      GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS};
constexpr GLenum kCombineOperands[] = {GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_SRC_COLOR,
                                       GL_ONE_MINUS_SRC_COLOR};
constexpr GLenum kCombineFunctions[] = {GL_REPLACE,     GL_MODULATE, GL_ADD,      GL_ADD_SIGNED,
                                        GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA};
constexpr GLenum kWraps[] = {GL_CLAMP, GL_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT};

// Parameters of several values.
constexpr GLenum kVectors[] = {GL_FOG_COLOR,
                               GL_AMBIENT,
                               GL_DIFFUSE,
                               GL_SPECULAR,
                               GL_EMISSION,
                               GL_AMBIENT_AND_DIFFUSE,
                               GL_POSITION,
                               GL_SPOT_DIRECTION,
                               GL_LIGHT_MODEL_AMBIENT,
                               GL_COLOR_INDEXES,
                               GL_POINT_DISTANCE_ATTENUATION,
                               GL_TEXTURE_ENV_COLOR,
                               GL_OBJECT_PLANE,
                               GL_EYE_PLANE,
                               GL_TEXTURE_BORDER_COLOR};

// What parameters whose values are enumerants, or few, may be.
struct ParameterValues {
    GLenum pname;
    std::vector<GLenum> values;
};

const std::vector<ParameterValues>& parameter_values() {
    const auto list = [](std::span<const GLenum> values) {
        return std::vector(values.begin(), values.end());
    };
    static const std::vector<ParameterValues> all = {
        {GL_FOG_MODE, {GL_LINEAR, GL_EXP, GL_EXP2}},
        {GL_FOG_COORDINATE_SOURCE, {GL_FOG_COORDINATE, GL_FRAGMENT_DEPTH}},
        {GL_FOG_DISTANCE_MODE_NV, {GL_EYE_RADIAL_NV, GL_EYE_PLANE, GL_EYE_PLANE_ABSOLUTE_NV}},
        {GL_LIGHT_MODEL_COLOR_CONTROL, {GL_SINGLE_COLOR, GL_SEPARATE_SPECULAR_COLOR}},
        {GL_TEXTURE_ENV_MODE, {GL_MODULATE, GL_DECAL, GL_BLEND, GL_REPLACE, GL_ADD, GL_COMBINE}},
        {GL_COORD_REPLACE, {0, 1}},
        {GL_COMBINE_RGB, list(kCombineFunctions)},
        {GL_COMBINE_ALPHA, list(std::span(kCombineFunctions).first(6))},
        {GL_SRC0_RGB, list(kCombineSources)},
        {GL_SRC1_RGB, list(kCombineSources)},
        {GL_SRC2_RGB, list(kCombineSources)},
        {GL_SRC0_ALPHA, list(kCombineSources)},
        {GL_SRC1_ALPHA, list(kCombineSources)},
        {GL_SRC2_ALPHA, list(kCombineSources)},
        {GL_OPERAND0_RGB, list(kCombineOperands)},
        {GL_OPERAND1_RGB, list(kCombineOperands)},
        {GL_OPERAND2_RGB, list(kCombineOperands)},
        {GL_OPERAND0_ALPHA, list(std::span(kCombineOperands).first(2))},
        {GL_OPERAND1_ALPHA, list(std::span(kCombineOperands).first(2))},
        {GL_OPERAND2_ALPHA, list(std::span(kCombineOperands).first(2))},
        {GL_RGB_SCALE, {1, 2, 4}},
        {GL_ALPHA_SCALE, {1, 2, 4}},
        {GL_TEXTURE_GEN_MODE,
         {GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_NORMAL_MAP, GL_REFLECTION_MAP}},
        {GL_TEXTURE_MIN_FILTER,
         {GL_NEAREST, GL_LINEAR, GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST,
          GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR_MIPMAP_LINEAR}},
        {GL_TEXTURE_MAG_FILTER, {GL_NEAREST, GL_LINEAR}},
        {GL_TEXTURE_WRAP_S, list(kWraps)},
        {GL_TEXTURE_WRAP_T, list(kWraps)},
        {GL_TEXTURE_WRAP_R, list(kWraps)},
        {GL_DEPTH_TEXTURE_MODE, {GL_LUMINANCE, GL_INTENSITY, GL_ALPHA}},
        {GL_TEXTURE_COMPARE_MODE, {GL_NONE, GL_COMPARE_R_TO_TEXTURE}},
        {GL_TEXTURE_COMPARE_FUNC,
         {GL_LEQUAL, GL_GEQUAL, GL_LESS, GL_GREATER, GL_EQUAL, GL_NOTEQUAL, GL_ALWAYS, GL_NEVER}},
        {GL_GENERATE_MIPMAP, {0, 1}},
        {GL_TEXTURE_BASE_LEVEL, {0, 1, 2}},
        {GL_TEXTURE_MAX_LEVEL, {0, 1, 5, 1000}},
        {GL_MAP_COLOR, {0, 1}},
        {GL_MAP_STENCIL, {0, 1}},
        {GL_INDEX_SHIFT, {0, 1, 2}},
        {GL_INDEX_OFFSET, {0, 3, 7}},
        {GL_SPOT_CUTOFF, {0, 37, 90, 91, 180}},
        {GL_SPOT_EXPONENT, {0, 37, 128, 129}},
        {GL_SHININESS, {0, 37, 128, 129}},
    };
    return all;
}

}  // namespace

const Call* find_call(std::string_view name) {
    const auto* found = std::ranges::find(kEveryCall, name, &Call::name);
    return found == std::end(kEveryCall) ? nullptr : found;
}

RandomArguments::RandomArguments(unsigned seed) : m_random(seed), m_memory(kMemoryBytes) {
    spoil();
}

void RandomArguments::spoil() {
    fill_bytes(0);
}

// Cheaper numbers will do for so many.
void RandomArguments::fill_bytes(std::size_t first) {
    std::uint64_t state = m_random();
    for (std::size_t i = first; i < m_memory.size(); i += 4) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        const auto bits = static_cast<std::uint32_t>(state >> 32);
        std::memcpy(&m_memory[i], &bits, sizeof bits);
    }
}

float RandomArguments::number(float low, float high) {
    return low + (high - low) * static_cast<float>(m_random() % 65537) / 65536.0f;
}

GLenum RandomArguments::enumerant(const Call& call, std::size_t i) {
    const auto one_of = [&](std::span<const GLenum> values) {
        return values[pick(static_cast<unsigned>(values.size()))];
    };
    const std::string_view name = call.name, parameter = call.parameters[i], group = call.groups[i];
    if (pick(24) == 0) return pick(2) ? 0x1234 : GL_TRIANGLE_FAN;
    if (group == "TextureTarget") {
        if (contains(name, "Image1D")) return one_of(kTargets1d);
        if (contains(name, "Image2D")) return one_of(kTargets2d);
        if (contains(name, "Image3D")) return one_of(kTargets3d);
        return one_of(kObjectTargets);
    }
    if (group == "TextureEnvTarget") return one_of(kEnvTargets);
    if (group == "InternalFormat" && !contains(name, "Compressed")) return one_of(kInternalFormats);
    if (contains(name, "Compressed") && (parameter == "internalformat" || parameter == "format"))
        return GL_COMPRESSED_RGB_S3TC_DXT1_EXT + pick(4);
    if (group == "PixelFormat") return one_of(kClientFormats);
    if (name == "glClipControl") return pick(2) ? GL_LOWER_LEFT + pick(2) : GL_NEGATIVE_ONE_TO_ONE + pick(2);
    if (name.starts_with("glMultiTexCoord") || (m_plain && group == "TextureUnit"))
        return GL_TEXTURE0 + pick(8);
    if (m_plain && parameter == "pname" && call.parameters.back() == "param") {
        std::vector<GLenum> scalars;
        for (const GLenum value : group_values(group)) {
            if (std::ranges::find(kVectors, value) == std::end(kVectors)) scalars.push_back(value);
        }
        return one_of(scalars);
    }
    if (m_plain && group == "BlendingFactor") return GL_SRC_COLOR + pick(8);
    const auto values = group_values(group);
    const GLenum value = values.empty() ? GLenum{1} : one_of(values);
    const bool client_array = value >= GL_VERTEX_ARRAY && value <= GL_EDGE_FLAG_ARRAY;
    return m_plain && client_array && group == "EnableCap" ? GLenum{GL_FOG} : value;
}

long long RandomArguments::integer(const Call& call, std::size_t i) {
    const std::string_view name = call.name, parameter = call.parameters[i], group = call.groups[i];
    const auto between = [&](int low, int high) {
        return low + static_cast<int>(pick(static_cast<unsigned>(high - low + 1)));
    };
    if (pick(40) == 0 && !(m_plain && (parameter == "stride" || parameter == "flag" || group == "Boolean")))
        return -1;
    if (group == "AttribMask" || group == "ClearBufferMask") {
        GLbitfield mask = 0;
        for (const GLenum bit : group_values(group)) mask |= pick(2) ? bit : 0;
        return group == "AttribMask" ? mask & 0xfffff
                                     : mask & (GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT |
                                               GL_STENCIL_BUFFER_BIT | GL_ACCUM_BUFFER_BIT);
    }
    if (group == "Boolean" || parameter == "flag") return pick(3) == 2 && !m_plain ? 7 : pick(2);
    if (group == "InternalFormat") return kInternalFormats[pick(std::size(kInternalFormats))];
    if (parameter == "level") return pick(3) == 0;
    if (parameter == "border") return pick(5) == 0 && !m_plain;
    if (parameter == "imageSize") return 0;  // made to fit below
    if (parameter == "width" || parameter == "height" || parameter == "depth") {
        if (contains(name, "Compressed")) return 4;
        if (name == "glBitmap") return between(0, 37);
        return contains(name, "Tex") && pick(2) ? 1 << pick(4) : between(0, 9);
    }
    if (parameter.ends_with("offset")) return contains(name, "Compressed") ? 4 * pick(2) : between(0, 3);
    if (parameter == "x" || parameter == "y") return between(-3, 20);
    if (parameter == "count" || parameter == "drawcount")
        return between(0, name.starts_with("glMulti") ? 3 : 9);
    if (parameter == "first" || parameter == "start" || parameter == "i") return between(0, 5);
    if (parameter == "end") return between(5, 15);
    if (parameter.ends_with("order")) return between(1, 5);
    if (parameter == "stride" || parameter == "ustride" || parameter == "vstride") return between(4, 30);
    if (name.starts_with("glMapGrid") || name.starts_with("glEvalMesh") || name.starts_with("glEvalPoint"))
        return between(0, 4);
    if (parameter == "n" || parameter == "mapsize")
        return name == "glPixelMapfv" || parameter == "mapsize" ? 1 << pick(5) : between(0, 6);
    if (parameter == "texture") return between(0, 3);
    if (parameter == "id") return between(1, 2);
    if (name == "glCallList" || name == "glListBase") return between(50, 53);
    if (name.starts_with("glBlitFramebuffer")) return between(0, 31);
    if (name == "glLineStipple" && i == 0) return between(0, 258);
    if (parameter == "ref") return between(-2, 258);
    if (parameter == "param") return static_cast<long long>(parameter_value(m_pname));
    if (name.starts_with("glVertex") || name.starts_with("glRasterPos") || name.starts_with("glRect"))
        return between(-3, 3);
    if (name.starts_with("glWindowPos")) return between(-2, 30);
    if (name.starts_with("glTexCoord") || name.starts_with("glMultiTexCoord")) return between(-9, 9);
    return static_cast<long long>(m_random());
}

double RandomArguments::parameter_value(GLenum pname) {
    const auto& all = parameter_values();
    const auto found = std::ranges::find(all, pname, &ParameterValues::pname);
    if (found == all.end() || pick(12) == 0)
        return static_cast<double>(number(-1.5f, 2.5f)) * (pick(4) ? 1 : 100);
    return found->values[pick(static_cast<unsigned>(found->values.size()))];
}

double RandomArguments::real(const Call& call) {
    const std::string_view name = call.name;
    if (name.starts_with("glWindowPos")) return static_cast<double>(number(0, 30));
    if (name == "glPixelZoom") return static_cast<double>(number(-2, 2));
    if (name == "glLineWidth" || name == "glPointSize") return static_cast<double>(number(-0.5f, 9));
    if (name.starts_with("glPixelTransfer") || name.starts_with("glRotate") || name == "glPolygonOffset")
        return static_cast<double>(number(-2, 3));
    if (name == "glBitmap") return static_cast<double>(number(-6, 6));
    return static_cast<double>(number(-1.25f, 1.5f));
}

void RandomArguments::fill_parameters(const Call& call, void* out) {
    for (int i = 0; i < 16; ++i) {
        const double value = parameter_value(m_pname);
        const bool color = std::ranges::find(parameter_values(), m_pname, &ParameterValues::pname) ==
                           parameter_values().end();
        if (call.name.ends_with("iv")) {
            static_cast<GLint*>(out)[i] =
                color && pick(2) ? static_cast<GLint>(m_random()) : static_cast<GLint>(value);
        } else if (call.name.ends_with("dv")) {
            static_cast<GLdouble*>(out)[i] = value;
        } else {
            static_cast<GLfloat*>(out)[i] = static_cast<GLfloat>(value);
        }
    }
}

void* RandomArguments::memory(const Call& call, std::size_t i) {
    const std::string_view name = call.name, parameter = call.parameters[i];
    unsigned char* const here = m_memory.data() + 8192 * i;  // images come last, and are longest
    const auto fill = [&]<typename Value>(Value*, auto value) {
        for (std::size_t k = 0; k < 400; ++k) {
            const Value v = static_cast<Value>(value(k));
            std::memcpy(here + k * sizeof v, &v, sizeof v);
        }
        return static_cast<void*>(here);
    };
    const auto reals = [&](std::size_t) { return number(-1.25f, 1.5f); };
    if (parameter == "params") {
        fill_parameters(call, here);
        return here;
    }
    if (parameter == "indices") {
        const bool several = name.starts_with("glMultiDraw");
        unsigned char* const indices = several ? m_memory.data() + 8192 * 7 : here;
        const auto type = static_cast<GLenum>(m_arguments[i - 1].integer);
        const std::size_t size = type == GL_UNSIGNED_INT ? 4 : type == GL_UNSIGNED_SHORT ? 2 : 1;
        std::fill_n(indices, 64 * size, static_cast<unsigned char>(0));
        for (std::size_t k = 0; k < 64; ++k) indices[k * size] = static_cast<unsigned char>(pick(16));
        m_index_lists.assign(8, indices);
        return several ? static_cast<void*>(m_index_lists.data()) : indices;
    }
    if (parameter == "first" || parameter == "count")
        return fill(static_cast<GLint*>(nullptr), [&](auto) { return pick(6); });
    if (name == "glCallLists") return fill(static_cast<GLubyte*>(nullptr), [&](auto) { return pick(4); });
    if (parameter == "textures")
        return fill(static_cast<GLuint*>(nullptr), [](std::size_t k) { return k + 1; });
    if (parameter == "pixels" || parameter == "data" || parameter == "bitmap" || parameter == "mask") {
        const bool floats = parameter == "pixels" && i > 0 && m_arguments[i - 1].integer == GL_FLOAT;
        fill_bytes(8192 * i);
        for (std::size_t k = 0; floats && k < kMemoryBytes / 4 - 2048 * i; ++k) {
            const float value = -0.1f + 1.3f / 256 * static_cast<float>(here[4 * k]);
            std::memcpy(here + 4 * k, &value, sizeof value);
        }
        return here;
    }
    if (name == "glPixelMapfv") return fill(static_cast<GLfloat*>(nullptr), reals);
    if (name.ends_with("dv") || name.ends_with("d")) return fill(static_cast<GLdouble*>(nullptr), reals);
    if (name == "glClipPlane") return fill(static_cast<GLdouble*>(nullptr), reals);
    if (name.ends_with("fv") || name.ends_with("f") || name == "glPrioritizeTextures")
        return fill(static_cast<GLfloat*>(nullptr), reals);
    const auto coordinates = [&](std::size_t) { return static_cast<int>(pick(7)) - 3; };
    const bool positions = name.starts_with("glVertex") || name.starts_with("glRasterPos") ||
                           name.starts_with("glRect") || name.starts_with("glTexCoord") ||
                           name.starts_with("glMultiTexCoord") || name.starts_with("glWindowPos") ||
                           name.starts_with("glIndex");
    if (positions && name.ends_with("iv")) return fill(static_cast<GLint*>(nullptr), coordinates);
    if (positions && name.ends_with("sv")) return fill(static_cast<GLshort*>(nullptr), coordinates);
    return fill(static_cast<GLubyte*>(nullptr),
                [&](auto) { return m_plain && name == "glEdgeFlagv" ? m_random() % 2 : m_random(); });
}

const std::vector<Arguments>& RandomArguments::operator()(const Call& call) {
    m_arguments.assign(call.kinds.size(), {});
    m_pname = 0;
    for (std::size_t i = 0; i < call.kinds.size(); ++i) {
        Arguments& a = m_arguments[i];
        switch (call.kinds[i]) {
            case 'e':
                a.integer = enumerant(call, i);
                if (call.parameters[i] == "pname") m_pname = static_cast<GLenum>(a.integer);
                break;
            case 'f':
                a.real = call.parameters[i] == "param" ? parameter_value(m_pname) : real(call);
                break;
            case 'p':
            case 'q':
                a.pointer = memory(call, i);
                break;
            default:
                a.integer = integer(call, i);
        }
        if (call.kinds[i] != 'f') a.real = static_cast<double>(a.integer);
    }
    // Compressed images of one block, or of the size that their format asks for.
    for (std::size_t i = 0; i < call.kinds.size(); ++i) {
        if (call.parameters[i] != "imageSize") continue;
        const auto format = std::ranges::find_if(m_arguments, [](const Arguments& a) {
            return a.integer >= GL_COMPRESSED_RGB_S3TC_DXT1_EXT &&
                   a.integer <= GL_COMPRESSED_RGBA_S3TC_DXT5_EXT;
        });
        const bool long_blocks =
            format != m_arguments.end() && format->integer > GL_COMPRESSED_RGBA_S3TC_DXT1_EXT;
        m_arguments[i].integer = pick(8) ? (long_blocks ? 16 : 8) : 7;
    }
    return m_arguments;
}

void RandomArguments::set_pixel_store(const kit::Gl& gl) {
    const GLint values[] = {static_cast<GLint>(pick(2)),
                            static_cast<GLint>(pick(2)),
                            pick(2) ? 9 + static_cast<GLint>(pick(4)) : 0,
                            static_cast<GLint>(pick(3)),
                            static_cast<GLint>(pick(4)),
                            1 << pick(4),
                            static_cast<GLint>(pick(3)),
                            pick(2) ? 9 + static_cast<GLint>(pick(3)) : 0};
    constexpr GLenum kNames[] = {GL_UNPACK_SWAP_BYTES,  GL_UNPACK_LSB_FIRST,   GL_UNPACK_ROW_LENGTH,
                                 GL_UNPACK_SKIP_ROWS,   GL_UNPACK_SKIP_PIXELS, GL_UNPACK_ALIGNMENT,
                                 GL_UNPACK_SKIP_IMAGES, GL_UNPACK_IMAGE_HEIGHT};
    for (std::size_t i = 0; i < std::size(kNames); ++i) gl.PixelStorei(kNames[i], values[i]);
}

std::string RandomArguments::text(const Call& call, const std::vector<Arguments>& arguments) {
    std::string out(call.name);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        out += i == 0 ? '(' : ' ';
        out += call.kinds[i] == 'f'   ? std::to_string(arguments[i].real)
               : call.kinds[i] == 'p' ? std::string("memory")
                                      : std::to_string(arguments[i].integer);
    }
    return out + (arguments.empty() ? "()" : ")");
}

}  // namespace terrazzo::test
