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
#include "raster/target/texture_image.h"

namespace terrazzo::gl {

struct Context;
struct CompressedBlocks;

// Indices of the texture targets in bindings and default objects. The later one has precedence when several
// are enabled (GL 1.5 §3.8.15).
enum TextureTarget : int { kTexture1D, kTexture2D, kTexture3D, kTextureCube, kTextureTargetCount };

// The part of a texture object that glPushAttrib(GL_TEXTURE_BIT) saves.
struct TextureParameters {
    std::array<GLfloat, 4> border_color{};
    GLenum min_filter = GL_NEAREST_MIPMAP_LINEAR;
    GLenum mag_filter = GL_LINEAR;
    GLenum wrap_s = GL_REPEAT;
    GLenum wrap_t = GL_REPEAT;
    GLenum wrap_r = GL_REPEAT;
    GLenum depth_mode = GL_LUMINANCE;  // of depth textures: what a depth, or a comparison's result, becomes
    GLenum compare_mode = GL_NONE;
    GLenum compare_func = GL_LEQUAL;
    GLfloat priority = 1;
    GLfloat min_lod = -1000;
    GLfloat max_lod = 1000;
    GLfloat lod_bias = 0;
    GLfloat max_anisotropy = 1;
    bool generate_mipmap = false;
    GLint base_level = 0;
    GLint max_level = 1000;
};

// One mipmap level as glTexImage specified it. Sizes include the border.
struct TextureLevel {
    GLsizei width = 0;
    GLsizei height = 0;
    GLsizei depth = 0;
    GLint border = 0;
    GLint internal_format = 1;            // as the program named it
    const TexelFormat* format = nullptr;  // how texels are kept; null while nothing is specified
    raster::LevelImage image;             // null for an empty image and in proxies
    std::shared_ptr<const CompressedBlocks>
        blocks;  // what the texels were decoded from; null where from none
};

using TextureLevels = std::array<TextureLevel, kMaxTextureLevels>;
inline constexpr int kCubeFaces = 6;

struct TextureObject {
    GLuint name = 0;
    GLenum target = 0;  // GL_TEXTURE_1D, _2D, _3D or _CUBE_MAP
    TextureParameters parameters;
    TextureLevels levels;  // of a cube map: of the face in positive x
    std::unique_ptr<std::array<TextureLevels, kCubeFaces - 1>> other_faces;  // of cube maps alone

    int face_count() const { return other_faces ? kCubeFaces : 1; }
    TextureLevels& face(int index) {
        return index == 0 ? levels : (*other_faces)[static_cast<std::size_t>(index - 1)];
    }
    const TextureLevels& face(int index) const { return const_cast<TextureObject*>(this)->face(index); }
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
    std::array<bool, kTextureTargetCount> enabled{};
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
// none of the four.
TextureObject* bound_texture(Context& ctx, GLenum target);

// What commands that work on images mean by `target`: a level of a texture's face, or of a proxy.
struct ImageTarget {
    TextureObject* object = nullptr;  // null: no such target
    int face = 0;
    int dimensions = 0;
    bool is_proxy = false;

    bool is_cube() const { return object->target == GL_TEXTURE_CUBE_MAP; }
    TextureLevel& level(GLint number) const { return object->face(face)[static_cast<std::size_t>(number)]; }
};
ImageTarget find_image_target(Context& ctx, GLenum target);

}  // namespace terrazzo::gl
