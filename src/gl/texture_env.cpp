// Texture environments and texture coordinate generation (GL 1.5 §3.8.13, §2.11.4).
#include "gl/texture_env.h"

#include <algorithm>

#include "gl/change.h"
#include "gl/generated/commands.h"

namespace terrazzo::gl {
namespace {

TextureUnit& active_unit(Context& ctx) {
    return ctx.texture.units[ctx.texture.active_unit];
}

bool is_environment_mode(GLfloat mode) {
    return mode == GL_MODULATE || mode == GL_DECAL || mode == GL_BLEND || mode == GL_REPLACE ||
           mode == GL_ADD || mode == GL_COMBINE;
}

TexgenCoordinate* find_coordinate(Context& ctx, GLenum coord) {
    if (coord >= GL_S && coord <= GL_Q) return &active_unit(ctx).texgen.coordinates[coord - GL_S];
    record_error(ctx, GL_INVALID_ENUM, "no such texture coordinate");
    return nullptr;
}

// Sphere mapping makes s and t only, reflections and normals have no q.
bool is_texgen_mode(GLenum coord, GLfloat mode) {
    return mode == GL_OBJECT_LINEAR || mode == GL_EYE_LINEAR ||
           (mode == GL_SPHERE_MAP && (coord == GL_S || coord == GL_T)) ||
           ((mode == GL_REFLECTION_MAP || mode == GL_NORMAL_MAP) && coord != GL_Q);
}

// Of the active unit; points, not textures, own it.
void set_coord_replace(Context& ctx, GLfloat value) {
    if (value != GL_TRUE && value != GL_FALSE)
        return record_error(ctx, GL_INVALID_VALUE, "the value is neither GL_TRUE nor GL_FALSE");
    std::uint8_t& units = ctx.rasterization.point.coord_replace;
    const int bit = 1 << ctx.texture.active_unit;
    change(ctx, Dirty::kRasterization, units, value == GL_TRUE ? units | bit : units & ~bit);
}

}  // namespace

void tex_envfv(Context& ctx, GLenum target, GLenum pname, const GLfloat* params) {
    if (target == GL_TEXTURE_FILTER_CONTROL && pname == GL_TEXTURE_LOD_BIAS)
        return change(ctx, Dirty::kTexture, active_unit(ctx).env.lod_bias, *params);
    if (target == GL_POINT_SPRITE && pname == GL_COORD_REPLACE) return set_coord_replace(ctx, *params);
    if (target != GL_TEXTURE_ENV) return record_error(ctx, GL_INVALID_ENUM, "target is not GL_TEXTURE_ENV");
    TextureEnv& env = active_unit(ctx).env;
    if (set_combine_parameter(ctx, env, pname, params)) return;
    switch (pname) {
        case GL_TEXTURE_ENV_MODE:
            if (!is_environment_mode(*params)) return record_error(ctx, GL_INVALID_ENUM, "no such mode");
            return change(ctx, Dirty::kTexture, env.mode, *params);
        case GL_TEXTURE_ENV_COLOR:
            return change(ctx, Dirty::kTexture, env.color,
                          std::array{params[0], params[1], params[2], params[3]});
    }
    record_error(ctx, GL_INVALID_ENUM, "no such environment parameter");
}

void tex_genfv(Context& ctx, GLenum coord, GLenum pname, const GLfloat* params) {
    TexgenCoordinate* coordinate = find_coordinate(ctx, coord);
    if (!coordinate) return;
    switch (pname) {
        case GL_TEXTURE_GEN_MODE:
            if (!is_texgen_mode(coord, *params)) return record_error(ctx, GL_INVALID_ENUM, "no such mode");
            return change(ctx, Dirty::kTexture, coordinate->mode, *params);
        case GL_OBJECT_PLANE:
            return change(ctx, Dirty::kTexture, coordinate->object_plane,
                          std::array{params[0], params[1], params[2], params[3]});
        case GL_EYE_PLANE:
            return change(ctx, Dirty::kTexture, coordinate->eye_plane, plane_to_eye(ctx.matrix, params));
    }
    record_error(ctx, GL_INVALID_ENUM, "no such coordinate generation parameter");
}

void get_tex_envfv(Context& ctx, GLenum target, GLenum pname, GLfloat* params) {
    if (target == GL_TEXTURE_FILTER_CONTROL && pname == GL_TEXTURE_LOD_BIAS) {
        *params = active_unit(ctx).env.lod_bias;
        return;
    }
    if (target == GL_POINT_SPRITE && pname == GL_COORD_REPLACE) {
        *params = static_cast<GLfloat>(ctx.rasterization.point.coord_replace >> ctx.texture.active_unit & 1);
        return;
    }
    if (target != GL_TEXTURE_ENV) return record_error(ctx, GL_INVALID_ENUM, "target is not GL_TEXTURE_ENV");
    const TextureEnv& env = active_unit(ctx).env;
    if (get_combine_parameter(env, pname, *params)) return;
    switch (pname) {
        case GL_TEXTURE_ENV_MODE:
            *params = static_cast<GLfloat>(env.mode);
            return;
        case GL_TEXTURE_ENV_COLOR:
            for (int i = 0; i < 4; ++i) params[i] = std::clamp(env.color[i], 0.0f, 1.0f);
            return;
    }
    record_error(ctx, GL_INVALID_ENUM, "no such environment parameter");
}

void get_tex_genfv(Context& ctx, GLenum coord, GLenum pname, GLfloat* params) {
    const TexgenCoordinate* coordinate = find_coordinate(ctx, coord);
    if (!coordinate) return;
    switch (pname) {
        case GL_TEXTURE_GEN_MODE:
            *params = static_cast<GLfloat>(coordinate->mode);
            return;
        case GL_OBJECT_PLANE:
            std::ranges::copy(coordinate->object_plane, params);
            return;
        case GL_EYE_PLANE:
            std::ranges::copy(coordinate->eye_plane, params);
            return;
    }
    record_error(ctx, GL_INVALID_ENUM, "no such coordinate generation parameter");
}

}  // namespace terrazzo::gl
