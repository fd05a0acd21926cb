// Compressed texture images: CompressedTexImage, CompressedTexSubImage, GetCompressedTexImage (GL 1.5 §3.8.3,
// §6.1.4, EXT_texture_compression_s3tc). The formats are those of 2D images, cube maps' faces among them;
// there are none of one or three dimensions.
#include <algorithm>
#include <cstring>
#include <new>

#include "gl/block_compression.h"
#include "gl/context.h"
#include "gl/generated/commands.h"
#include "gl/mipmap.h"
#include "gl/pixel_buffers.h"
#include "gl/texture_spec.h"

namespace terrazzo::gl {
namespace {

constexpr const char* kNoFormat = "no compressed format of images of so many dimensions";

const TexelFormat& texel_format(const BlockFormat& format) {
    return *choose_texel_format(static_cast<GLint>(format.name), format.base, GL_UNSIGNED_BYTE, false);
}

Rule check_image(const BlockFormat& format, const ImageTarget& target, const LevelSpec& spec, GLsizei size) {
    if (const Rule rule = check_level_spec(spec, target.is_cube()); rule.code != GL_NO_ERROR) return rule;
    if (spec.border != 0) return {GL_INVALID_OPERATION, "compressed images have no border"};
    if (size < 0 || static_cast<std::size_t>(size) != format.image_bytes(spec.width, spec.height))
        return {GL_INVALID_VALUE, "the size is not that of such an image"};
    return {};
}

// Puts the blocks of a part in their places.
void copy_blocks(const std::byte* from, const LevelBox& box, int image_width, CompressedBlocks& to) {
    const auto block = static_cast<std::size_t>(to.format->block_bytes);
    const auto across = static_cast<std::size_t>(to.format->blocks_across(box.width)),
               down = static_cast<std::size_t>(to.format->blocks_across(box.height)),
               pitch = static_cast<std::size_t>(to.format->blocks_across(image_width));
    const auto first =
        static_cast<std::size_t>(box.y / kBlockSize) * pitch + static_cast<std::size_t>(box.x / kBlockSize);
    for (std::size_t row = 0; row < down; ++row)
        std::memcpy(to.bytes.data() + (first + row * pitch) * block, from + row * across * block,
                    across * block);
}

}  // namespace

void compressed_tex_image_1d(Context& ctx, GLenum, GLint, GLenum, GLsizei, GLint, GLsizei, const void*) {
    record_error(ctx, GL_INVALID_ENUM, kNoFormat);
}

void compressed_tex_image_3d(Context& ctx, GLenum, GLint, GLenum, GLsizei, GLsizei, GLsizei, GLint, GLsizei,
                             const void*) {
    record_error(ctx, GL_INVALID_ENUM, kNoFormat);
}

void compressed_tex_image_2d(Context& ctx, GLenum target_name, GLint level_number, GLenum internalformat,
                             GLsizei width, GLsizei height, GLint border, GLsizei size, const void* data) {
    const BlockFormat* const format = find_block_format(internalformat);
    if (!format) return record_error(ctx, GL_INVALID_ENUM, kNoFormat);
    const ImageTarget target = find_image_target(ctx, target_name);
    if (!target.object || target.dimensions != 2)
        return record_error(ctx, GL_INVALID_ENUM, "unknown texture target");
    const LevelSpec spec{level_number, static_cast<GLint>(internalformat), width, height, 1, border, 2};
    if (const Rule rule = check_image(*format, target, spec, size); rule.code != GL_NO_ERROR)
        return record_error(ctx, rule.code, rule.words);
    const TexelFormat& texels = texel_format(*format);
    const bool supported = is_supported_size(spec, target.is_cube());
    if (target.is_proxy) {
        target.level(level_number) = {};
        if (supported && is_supported_memory(spec, texels))
            target.level(level_number) = {width,   height,  1,      0, spec.internal_format,
                                          &texels, nullptr, nullptr};
        return;
    }
    if (!supported) return record_error(ctx, GL_INVALID_VALUE, "the size is not supported");
    if (!is_supported_memory(spec, texels)) throw std::bad_alloc();
    const PixelMemory memory = find_elements(ctx, ctx.pixels.unpack, size, 1, data);
    if (!memory.is_usable()) return record_error(ctx, memory.rule.code, memory.rule.words);
    begin_change(ctx, Dirty::kTexture);
    TextureLevel made = make_level(spec, texels);
    const std::byte* const bytes = memory.data;
    auto blocks = std::make_shared<CompressedBlocks>();
    blocks->format = format;
    blocks->bytes.resize(static_cast<std::size_t>(size));
    if (bytes) std::copy_n(bytes, size, blocks->bytes.begin());
    if (made.image) decode_blocks(*format, blocks->bytes.data(), width, height, 0, 0, *made.image);
    made.blocks = std::move(blocks);
    const auto lock = lock_textures(ctx);
    DerivedLevels derived(target, level_number, made);
    target.level(level_number) = std::move(made);
    derived.store();
}

void compressed_tex_sub_image_1d(Context& ctx, GLenum, GLint, GLint, GLsizei, GLenum, GLsizei, const void*) {
    record_error(ctx, GL_INVALID_ENUM, kNoFormat);
}

void compressed_tex_sub_image_3d(Context& ctx, GLenum, GLint, GLint, GLint, GLint, GLsizei, GLsizei, GLsizei,
                                 GLenum, GLsizei, const void*) {
    record_error(ctx, GL_INVALID_ENUM, kNoFormat);
}

void compressed_tex_sub_image_2d(Context& ctx, GLenum target_name, GLint level_number, GLint xoffset,
                                 GLint yoffset, GLsizei width, GLsizei height, GLenum format_name,
                                 GLsizei size, const void* data) {
    const BlockFormat* const format = find_block_format(format_name);
    if (!format) return record_error(ctx, GL_INVALID_ENUM, kNoFormat);
    const ImageTarget target = find_image_target(ctx, target_name);
    if (!target.object || target.is_proxy || target.dimensions != 2)
        return record_error(ctx, GL_INVALID_ENUM, "unknown texture target");
    if (!is_level(level_number)) return record_error(ctx, GL_INVALID_VALUE, "no such mipmap level");
    if (width < 0 || height < 0) return record_error(ctx, GL_INVALID_VALUE, "the size is negative");
    if (size < 0 || static_cast<std::size_t>(size) != format->image_bytes(width, height))
        return record_error(ctx, GL_INVALID_VALUE, "the size is not that of such an image");
    const PixelMemory memory = find_elements(ctx, ctx.pixels.unpack, size, 1, data);
    if (!memory.is_usable()) return record_error(ctx, memory.rule.code, memory.rule.words);
    if (!memory.data && size > 0) return record_error(ctx, GL_INVALID_VALUE, "data is null");
    begin_change(ctx, Dirty::kTexture);
    const auto lock = lock_textures(ctx);
    TextureLevel& level = target.level(level_number);
    if (!level.blocks || level.blocks->format != format)
        return record_error(ctx, GL_INVALID_OPERATION, "the level's image has another format");
    const LevelBox box{xoffset, yoffset, 0, width, height, 1};
    if (!contains(level, box)) return record_error(ctx, GL_INVALID_VALUE, "the rectangle leaves the image");
    if (!is_whole_blocks(xoffset, width, level.width) || !is_whole_blocks(yoffset, height, level.height))
        return record_error(ctx, GL_INVALID_OPERATION, "the rectangle does not end with blocks");
    if (!level.image || box.is_empty()) return;
    const std::byte* const bytes = memory.data;
    auto blocks = std::make_shared<CompressedBlocks>(*level.blocks);
    copy_blocks(bytes, box, level.width, *blocks);
    raster::TextureImage& image = writable_image(ctx, level);
    DerivedLevels derived(target, level_number, level);
    decode_blocks(*format, bytes, width, height, xoffset, yoffset, image);
    level.blocks = std::move(blocks);
    derived.store();
}

void get_compressed_tex_image(Context& ctx, GLenum target_name, GLint level_number, void* image) {
    const ImageTarget target = find_image_target(ctx, target_name);
    if (!target.object || target.is_proxy)
        return record_error(ctx, GL_INVALID_ENUM, "unknown texture target");
    if (!is_level(level_number)) return record_error(ctx, GL_INVALID_VALUE, "no such mipmap level");
    PixelMemory memory = find_pixel_memory(ctx, ctx.pixels.pack, image, 1);
    const auto lock = lock_textures(ctx);
    const TextureLevel& level = target.level(level_number);
    if (!level.blocks) return record_error(ctx, GL_INVALID_OPERATION, "the level's image is not compressed");
    memory.require(level.blocks->bytes.size());
    if (!memory.is_usable()) return record_error(ctx, memory.rule.code, memory.rule.words);
    if (!memory.data) return record_error(ctx, GL_INVALID_VALUE, "image is null");
    std::ranges::copy(level.blocks->bytes, memory.data);
}

}  // namespace terrazzo::gl
