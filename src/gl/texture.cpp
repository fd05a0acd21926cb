// Texture objects: names, bindings, residence (GL 1.5 §3.8.12), completeness (§3.8.10).
#include "gl/texture.h"

#include <algorithm>
#include <bit>

#include "gl/context.h"
#include "gl/generated/commands.h"
#include "gl/share.h"

namespace terrazzo::gl {
namespace {

constexpr std::array<GLenum, kTextureTargetCount> kTargets{GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D,
                                                           GL_TEXTURE_CUBE_MAP};
constexpr std::array<GLenum, kTextureTargetCount> kProxies{GL_PROXY_TEXTURE_1D, GL_PROXY_TEXTURE_2D,
                                                           GL_PROXY_TEXTURE_3D, GL_PROXY_TEXTURE_CUBE_MAP};
constexpr std::array<int, kTextureTargetCount> kDimensions{1, 2, 3, 2};

// The index of a target in bindings; kTextureTargetCount when it is none.
size_t target_index(GLenum target) {
    return static_cast<size_t>(std::find(kTargets.begin(), kTargets.end(), target) - kTargets.begin());
}

std::shared_ptr<TextureObject> make_object(GLuint name, GLenum target) {
    auto object = std::make_shared<TextureObject>();
    object->name = name;
    object->target = target;
    if (target == GL_TEXTURE_CUBE_MAP)
        object->other_faces = std::make_unique<std::array<TextureLevels, kCubeFaces - 1>>();
    return object;
}

GLuint reserve_name(TextureNames& names) {
    while (names.next_name == 0 || names.objects.contains(names.next_name)) ++names.next_name;
    names.objects.emplace(names.next_name, nullptr);
    return names.next_name++;
}

// The object `name` stands for, made if this is the first binding. Null when it belongs to another target.
std::shared_ptr<TextureObject> object_to_bind(TextureNames& names, GLuint name, size_t target) {
    if (name == 0) return names.defaults[target];
    const auto found = names.objects.find(name);
    if (found != names.objects.end() && found->second) {
        return found->second->target == kTargets[target] ? found->second : nullptr;
    }
    return names.objects[name] = make_object(name, kTargets[target]);
}

// Null where there is none.
std::shared_ptr<TextureObject> object_named(const TextureNames& names, GLuint name) {
    const auto found = names.objects.find(name);
    return found == names.objects.end() ? nullptr : found->second;
}

// The same for as long as the names stay locked.
TextureObject* find_object(TextureNames& names, GLuint name) {
    const auto found = names.objects.find(name);
    return found == names.objects.end() ? nullptr : found->second.get();
}

bool uses_mipmaps(GLenum min_filter) {
    return min_filter != GL_NEAREST && min_filter != GL_LINEAR;
}

// Whether `level` can follow `base`, `steps` levels above it (GL 1.5 §3.8.10).
bool continues_mipmap(const TextureLevel& base, const TextureLevel& level, int steps) {
    if (!level.image || level.border != base.border) return false;
    // The formats as they were named, and what was made of them.
    if (level.internal_format != base.internal_format || level.format != base.format) return false;
    return level.image->width == std::max(1, base.image->width >> steps) &&
           level.image->height == std::max(1, base.image->height >> steps) &&
           level.image->depth == std::max(1, base.image->depth >> steps);
}

// GL 1.5 §3.8.10: all faces of a cube map are square and alike.
bool is_cube_complete(const TextureObject& object, size_t base) {
    const TextureLevel& first = object.levels[base];
    for (int face = 0; face < object.face_count(); ++face) {
        const TextureLevel& level = object.face(face)[base];
        if (!level.image || level.image->width != level.image->height || !continues_mipmap(first, level, 0))
            return false;
    }
    return true;
}

}  // namespace

void init_texture_state(Context& ctx) {
    const auto lock = lock_textures(ctx);
    for (size_t target = 0; target < kTextureTargetCount; ++target) {
        auto& object = ctx.shared->textures.defaults[target];
        if (!object) object = make_object(0, kTargets[target]);
        for (TextureUnit& unit : ctx.texture.units) unit.bound[target] = object;
        ctx.texture.proxies[target].target = kTargets[target];
    }
}

std::unique_lock<std::mutex> lock_textures(Context& ctx) {
    return std::unique_lock(ctx.shared->mutex);
}

TextureObject* bound_texture(Context& ctx, GLenum target) {
    const size_t index = target_index(target);
    if (index == kTextureTargetCount) return nullptr;
    return ctx.texture.units[ctx.texture.active_unit].bound[index].get();
}

ImageTarget find_image_target(Context& ctx, GLenum target) {
    const GLenum face = target - GL_TEXTURE_CUBE_MAP_POSITIVE_X;
    if (face < static_cast<GLenum>(kCubeFaces))
        return {bound_texture(ctx, GL_TEXTURE_CUBE_MAP), static_cast<int>(face), 2, false};
    const auto proxy =
        static_cast<size_t>(std::find(kProxies.begin(), kProxies.end(), target) - kProxies.begin());
    if (proxy < kTextureTargetCount) return {&ctx.texture.proxies[proxy], 0, kDimensions[proxy], true};
    const size_t index = target_index(target);
    if (index == kTextureTargetCount || target == GL_TEXTURE_CUBE_MAP) return {};
    return {bound_texture(ctx, target), 0, kDimensions[index], false};
}

TextureCompleteness completeness(const TextureObject& object) {
    const int base = object.parameters.base_level;
    if (base >= kMaxTextureLevels) return {};
    const TextureLevel& base_level = object.levels[static_cast<size_t>(base)];
    if (!base_level.image) return {};
    if (object.other_faces && !is_cube_complete(object, static_cast<size_t>(base))) return {};
    if (!uses_mipmaps(object.parameters.min_filter)) return {true, base, base};
    if (object.parameters.max_level < base) return {};
    const unsigned longest = static_cast<unsigned>(
        std::max({base_level.image->width, base_level.image->height, base_level.image->depth}));
    const int smallest = base + static_cast<int>(std::bit_width(longest)) - 1;
    const int last = std::min({smallest, object.parameters.max_level, kMaxTextureLevels - 1});
    for (int level = base + 1; level <= last; ++level) {
        for (int face = 0; face < object.face_count(); ++face) {
            if (!continues_mipmap(base_level, object.face(face)[static_cast<size_t>(level)], level - base))
                return {};
        }
    }
    return {true, base, last};
}

void active_texture(Context& ctx, GLenum texture) {
    if (texture - GL_TEXTURE0 >= static_cast<GLenum>(kMaxTextureUnits))
        return record_error(ctx, GL_INVALID_ENUM, "no such texture unit");
    ctx.texture.active_unit = texture - GL_TEXTURE0;
}

void gen_textures(Context& ctx, GLsizei n, GLuint* textures) {
    if (n < 0) return record_error(ctx, GL_INVALID_VALUE, "n is negative");
    const auto lock = lock_textures(ctx);
    TextureNames& names = ctx.shared->textures;
    GLsizei made = 0;
    try {
        for (; made < n; ++made) textures[made] = reserve_name(names);
    } catch (...) {
        while (made > 0) names.objects.erase(textures[--made]);
        throw;
    }
}

void delete_textures(Context& ctx, GLsizei n, const GLuint* textures) {
    if (n < 0) return record_error(ctx, GL_INVALID_VALUE, "n is negative");
    begin_change(ctx, Dirty::kTexture);
    const auto lock = lock_textures(ctx);
    TextureNames& names = ctx.shared->textures;
    for (GLsizei i = 0; i < n; ++i) {
        if (const TextureObject* object = find_object(names, textures[i])) {
            detach_texture(ctx, object);
            const size_t target = target_index(object->target);
            for (TextureUnit& unit : ctx.texture.units) {
                if (unit.bound[target].get() == object) unit.bound[target] = names.defaults[target];
            }
        }
        names.objects.erase(textures[i]);
    }
}

void bind_texture(Context& ctx, GLenum target, GLuint texture) {
    const size_t index = target_index(target);
    if (index == kTextureTargetCount) return record_error(ctx, GL_INVALID_ENUM, "unknown texture target");
    std::shared_ptr<TextureObject>& bound = ctx.texture.units[ctx.texture.active_unit].bound[index];
    auto lock = lock_textures(ctx);
    TextureNames& names = ctx.shared->textures;
    const std::shared_ptr<const TextureObject> known =
        texture ? object_named(names, texture) : names.defaults[index];
    lock.unlock();
    // Contexts that share textures see each other's changes when they bind.
    if (bound == known && ctx.shared.use_count() == 1) return;
    if (known && known->target != kTargets[index])
        return record_error(ctx, GL_INVALID_OPERATION, "the texture belongs to another target");
    begin_change(ctx, Dirty::kTexture);
    lock.lock();
    std::shared_ptr<TextureObject> object = object_to_bind(names, texture, index);
    lock.unlock();
    if (!object) return record_error(ctx, GL_INVALID_OPERATION, "the texture belongs to another target");
    bound = std::move(object);
}

GLboolean is_texture(Context& ctx, GLuint texture) {
    const auto lock = lock_textures(ctx);
    return find_object(ctx.shared->textures, texture) != nullptr;
}

// All textures are in memory that drawing reads directly, so all are resident.
GLboolean are_textures_resident(Context& ctx, GLsizei n, const GLuint* textures, GLboolean*) {
    if (n < 0) {
        record_error(ctx, GL_INVALID_VALUE, "n is negative");
        return GL_FALSE;
    }
    const auto lock = lock_textures(ctx);
    for (GLsizei i = 0; i < n; ++i) {
        if (!find_object(ctx.shared->textures, textures[i])) {
            record_error(ctx, GL_INVALID_VALUE, "a name is zero or not a texture's");
            return GL_FALSE;
        }
    }
    return GL_TRUE;
}

void prioritize_textures(Context& ctx, GLsizei n, const GLuint* textures, const GLfloat* priorities) {
    if (n < 0) return record_error(ctx, GL_INVALID_VALUE, "n is negative");
    const auto lock = lock_textures(ctx);
    for (GLsizei i = 0; i < n; ++i) {
        if (TextureObject* object = find_object(ctx.shared->textures, textures[i])) {
            object->parameters.priority = std::clamp(priorities[i], 0.0f, 1.0f);
        }
    }
}

}  // namespace terrazzo::gl
