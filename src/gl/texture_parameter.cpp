// glTexParameter and its queries (GL 1.5 §3.8.4, §6.1.3).
#include <algorithm>
#include <cmath>

#include "gl/client_pixel.h"
#include "gl/context.h"
#include "gl/generated/commands.h"
#include "gl/texture.h"

namespace terrazzo::gl {
namespace {

GLint to_integer(GLfloat value) {
    if (!(value == value)) return 0;
    const double rounded = std::round(static_cast<double>(value));
    return static_cast<GLint>(std::clamp(rounded, -2147483648.0, 2147483647.0));
}

GLenum to_enum(GLfloat value) {
    return static_cast<GLenum>(to_integer(value));
}

bool is_min_filter(GLenum filter) {
    switch (filter) {
        case GL_NEAREST:
        case GL_LINEAR:
        case GL_NEAREST_MIPMAP_NEAREST:
        case GL_LINEAR_MIPMAP_NEAREST:
        case GL_NEAREST_MIPMAP_LINEAR:
        case GL_LINEAR_MIPMAP_LINEAR:
            return true;
        default:
            return false;
    }
}

bool is_wrap_mode(GLenum mode) {
    switch (mode) {
        case GL_CLAMP:
        case GL_REPEAT:
        case GL_CLAMP_TO_EDGE:
        case GL_CLAMP_TO_BORDER:
        case GL_MIRRORED_REPEAT:
            return true;
        default:
            return false;
    }
}

bool is_one_of(GLenum value, std::initializer_list<GLenum> allowed) {
    return std::find(allowed.begin(), allowed.end(), value) != allowed.end();
}

GLfloat clamp_to_unit(GLfloat value) {
    return value > 0.0f ? std::min(value, 1.0f) : 0.0f;
}

Rule set_wrap(GLenum& wrap, GLfloat value) {
    if (!is_wrap_mode(to_enum(value))) return {GL_INVALID_ENUM, "unknown wrap mode"};
    wrap = to_enum(value);
    return {};
}

Rule set_level(GLint& level, GLfloat value) {
    if (to_integer(value) < 0) return {GL_INVALID_VALUE, "the level is negative"};
    level = to_integer(value);
    return {};
}

// Of a parameter that is unknown no value is read: there need not be any.
Rule set_parameter(TextureParameters& parameters, GLenum pname, const GLfloat* values) {
    switch (pname) {
        case GL_TEXTURE_MIN_FILTER:
            if (!is_min_filter(to_enum(*values))) return {GL_INVALID_ENUM, "unknown minification filter"};
            parameters.min_filter = to_enum(*values);
            return {};
        case GL_TEXTURE_MAG_FILTER:
            if (to_enum(*values) != GL_NEAREST && to_enum(*values) != GL_LINEAR) {
                return {GL_INVALID_ENUM, "unknown magnification filter"};
            }
            parameters.mag_filter = to_enum(*values);
            return {};
        case GL_TEXTURE_WRAP_S:
            return set_wrap(parameters.wrap_s, *values);
        case GL_TEXTURE_WRAP_T:
            return set_wrap(parameters.wrap_t, *values);
        case GL_TEXTURE_WRAP_R:
            return set_wrap(parameters.wrap_r, *values);
        case GL_DEPTH_TEXTURE_MODE:
            if (!is_one_of(to_enum(*values), {GL_LUMINANCE, GL_INTENSITY, GL_ALPHA}))
                return {GL_INVALID_ENUM, "unknown depth texture mode"};
            parameters.depth_mode = to_enum(*values);
            return {};
        case GL_TEXTURE_COMPARE_MODE:
            if (!is_one_of(to_enum(*values), {GL_NONE, GL_COMPARE_R_TO_TEXTURE}))
                return {GL_INVALID_ENUM, "unknown compare mode"};
            parameters.compare_mode = to_enum(*values);
            return {};
        case GL_TEXTURE_COMPARE_FUNC:
            if (to_enum(*values) < GL_NEVER || to_enum(*values) > GL_ALWAYS)
                return {GL_INVALID_ENUM, "unknown compare function"};
            parameters.compare_func = to_enum(*values);
            return {};
        case GL_TEXTURE_BASE_LEVEL:
            return set_level(parameters.base_level, *values);
        case GL_TEXTURE_MAX_LEVEL:
            return set_level(parameters.max_level, *values);
        case GL_TEXTURE_MIN_LOD:
            parameters.min_lod = *values;
            return {};
        case GL_TEXTURE_MAX_LOD:
            parameters.max_lod = *values;
            return {};
        case GL_TEXTURE_LOD_BIAS:
            parameters.lod_bias = *values;
            return {};
        case GL_TEXTURE_MAX_ANISOTROPY_EXT:
            if (!(*values >= 1)) return {GL_INVALID_VALUE, "the degree of anisotropy is less than 1"};
            parameters.max_anisotropy = std::min(*values, kMaxTextureAnisotropy);
            return {};
        case GL_GENERATE_MIPMAP:
            parameters.generate_mipmap = to_integer(*values) != 0;
            return {};
        case GL_TEXTURE_PRIORITY:
            parameters.priority = clamp_to_unit(*values);
            return {};
        case GL_TEXTURE_BORDER_COLOR:
            for (size_t i = 0; i < 4; ++i) parameters.border_color[i] = clamp_to_unit(values[i]);
            return {};
        default:
            return {GL_INVALID_ENUM, "unknown texture parameter"};
    }
}

// Writes the parameter's value or values; false for an unknown parameter.
bool query(const TextureParameters& parameters, GLenum pname, GLfloat* values) {
    switch (pname) {
        case GL_TEXTURE_MIN_FILTER:
            *values = static_cast<GLfloat>(parameters.min_filter);
            return true;
        case GL_TEXTURE_MAG_FILTER:
            *values = static_cast<GLfloat>(parameters.mag_filter);
            return true;
        case GL_TEXTURE_WRAP_S:
            *values = static_cast<GLfloat>(parameters.wrap_s);
            return true;
        case GL_TEXTURE_WRAP_T:
            *values = static_cast<GLfloat>(parameters.wrap_t);
            return true;
        case GL_TEXTURE_WRAP_R:
            *values = static_cast<GLfloat>(parameters.wrap_r);
            return true;
        case GL_DEPTH_TEXTURE_MODE:
            *values = static_cast<GLfloat>(parameters.depth_mode);
            return true;
        case GL_TEXTURE_COMPARE_MODE:
            *values = static_cast<GLfloat>(parameters.compare_mode);
            return true;
        case GL_TEXTURE_COMPARE_FUNC:
            *values = static_cast<GLfloat>(parameters.compare_func);
            return true;
        case GL_TEXTURE_BASE_LEVEL:
            *values = static_cast<GLfloat>(parameters.base_level);
            return true;
        case GL_TEXTURE_MAX_LEVEL:
            *values = static_cast<GLfloat>(parameters.max_level);
            return true;
        case GL_TEXTURE_MIN_LOD:
            *values = parameters.min_lod;
            return true;
        case GL_TEXTURE_MAX_LOD:
            *values = parameters.max_lod;
            return true;
        case GL_TEXTURE_LOD_BIAS:
            *values = parameters.lod_bias;
            return true;
        case GL_TEXTURE_MAX_ANISOTROPY_EXT:
            *values = parameters.max_anisotropy;
            return true;
        case GL_GENERATE_MIPMAP:
            *values = parameters.generate_mipmap;
            return true;
        case GL_TEXTURE_RESIDENT:
            *values = GL_TRUE;
            return true;
        case GL_TEXTURE_PRIORITY:
            *values = parameters.priority;
            return true;
        case GL_TEXTURE_BORDER_COLOR:
            std::copy_n(parameters.border_color.begin(), 4, values);
            return true;
        default:
            return false;
    }
}

}  // namespace

void tex_parameterfv(Context& ctx, GLenum target, GLenum pname, const GLfloat* params) {
    TextureObject* object = bound_texture(ctx, target);
    if (!object) return record_error(ctx, GL_INVALID_ENUM, "unknown texture target");
    auto lock = lock_textures(ctx);
    TextureParameters changed = object->parameters;
    lock.unlock();
    if (const Rule rule = set_parameter(changed, pname, params); rule.code != GL_NO_ERROR) {
        return record_error(ctx, rule.code, rule.words);
    }
    begin_change(ctx, Dirty::kTexture);
    lock.lock();
    object->parameters = changed;
}

void get_tex_parameterfv(Context& ctx, GLenum target, GLenum pname, GLfloat* params) {
    const TextureObject* object = bound_texture(ctx, target);
    if (!object) return record_error(ctx, GL_INVALID_ENUM, "unknown texture target");
    const auto lock = lock_textures(ctx);
    if (!query(object->parameters, pname, params)) {
        record_error(ctx, GL_INVALID_ENUM, "unknown texture parameter");
    }
}

}  // namespace terrazzo::gl
