// Texturing state (GL 1.5 §3.8, tables 6.14-6.18): texture objects with their parameters and mipmap levels,
// and the texture units that bind them.
//
// Texture objects are shared between contexts. Every access to an object of another context's making, its
// parameters and its levels, holds the mutex of the share group (`TextureLock`); the images themselves are
// copied on write, so a draw takes references under the mutex and then needs it no more.
#pragma once

#include <GL/gl.h>

#include <array>
#include <memory>
#include <mutex>
#include <unordered_map>

#include "gl/limits.h"
#include "gl/texture_env.h"
#include "gl/texture_format.h"
#include "pipeline/texture_image.h"

namespace terrazzo::gl {

struct Context;

// Indices of the texture targets in bindings and default objects. The later one has precedence when several
// are enabled (GL 1.5 §3.8.15).
enum TextureTarget : int { kTexture1D, kTexture2D, kTextureTargetCount };

// The part of a texture object that glPushAttrib(GL_TEXTURE_BIT) saves.
struct TextureParameters {
    std::array<GLfloat, 4> border_color{};
    GLenum min_filter = GL_NEAREST_MIPMAP_LINEAR;
    GLenum mag_filter = GL_LINEAR;
    GLenum wrap_s = GL_REPEAT;
    GLenum wrap_t = GL_REPEAT;
    GLenum wrap_r = GL_REPEAT;
    GLfloat priority = 1;
    GLfloat min_lod = -1000;
    GLfloat max_lod = 1000;
    GLfloat lod_bias = 0;
    GLint base_level = 0;
    GLint max_level = 1000;
};

// One mipmap level as glTexImage specified it. Sizes include the border.
struct TextureLevel {
    GLsizei width = 0;
    GLsizei height = 0;
    GLint border = 0;
    GLint internal_format = 1;            // as the program named it
    const TexelFormat* format = nullptr;  // how texels are kept; null while nothing is specified
    pipeline::LevelImage image;           // null for an empty image and in proxies
};

struct TextureObject {
    GLuint name = 0;
    GLenum target = 0;  // GL_TEXTURE_1D or GL_TEXTURE_2D
    TextureParameters parameters;
    std::array<TextureLevel, kMaxTextureLevels> levels;
};

// The levels that sampling may touch under the current parameters (GL 1.5 §3.8.10). An incomplete texture
// behaves as if texturing were disabled.
struct TextureCompleteness {
    bool complete = false;
    int base = 0;  // first level
    int last = 0;  // last level; equals base when the minification filter uses no mipmaps
};
TextureCompleteness completeness(const TextureObject& object);

struct TextureUnit {
    TextureEnv env;
    TexgenState texgen;
    bool enabled_1d = false;
    bool enabled_2d = false;
    std::array<std::shared_ptr<TextureObject>, kTextureTargetCount>
        bound;  // never null after init_texture_state
};

struct TextureState {
    unsigned active_unit = 0;
    std::array<TextureUnit, kMaxTextureUnits> units;
    std::array<TextureObject, kTextureTargetCount> proxies;
};

// Texture objects by name, part of the share group. A name that GenTextures returned and nothing has bound
// yet maps to null. The default objects (name zero) are not in the map.
struct TextureNames {
    std::unordered_map<GLuint, std::shared_ptr<TextureObject>> objects;
    std::array<std::shared_ptr<TextureObject>, kTextureTargetCount> defaults;
    GLuint next_name = 1;
};

// Binds the default textures to all units; called once when a context is made, after `ctx.shared` is set.
void init_texture_state(Context& ctx);

std::unique_lock<std::mutex> lock_textures(Context& ctx);

// The object that commands naming `target` act on: the one bound to the active unit. Null when `target` is
// neither GL_TEXTURE_1D nor GL_TEXTURE_2D.
TextureObject* bound_texture(Context& ctx, GLenum target);

}  // namespace terrazzo::gl
