// Every error rule of the texture and pixel commands (GL 1.5 §3.6, §3.8, §4.3, §6.1): the code, and nothing
// changed.
#include <gmock/gmock.h>

#include <functional>
#include <vector>

#include "attach_picture.h"
#include "gl/generated/commands.h"
#include "gl/surface.h"
#include "gl_fixture.h"

namespace terrazzo::gl {
namespace {

uint8_t pixels[4 * 16 * 16 * 16];
GLuint names[4] = {11, 12, 13, 14};
GLfloat floats[300];
GLuint integers[300];

struct BadCall {
    const char* text;
    GLenum error;
    std::function<void(Context& ctx)> call;
};

// The fixture has a 4x4 RGBA texture with level 0 bound to GL_TEXTURE_2D and a window without depth and
// stencil.
const BadCall kBadCalls[] = {
    {"GenTextures, n < 0", GL_INVALID_VALUE, [](Context& ctx) { gen_textures(ctx, -1, names); }},
    {"DeleteTextures, n < 0", GL_INVALID_VALUE, [](Context& ctx) { delete_textures(ctx, -1, names); }},
    {"BindTexture, target", GL_INVALID_ENUM, [](Context& ctx) { bind_texture(ctx, GL_PROXY_TEXTURE_2D, 1); }},
    {"BindTexture to another target", GL_INVALID_OPERATION,
     [](Context& ctx) { bind_texture(ctx, GL_TEXTURE_1D, 10); }},
    {"PrioritizeTextures, n < 0", GL_INVALID_VALUE,
     [](Context& ctx) { prioritize_textures(ctx, -1, names, floats); }},
    {"AreTexturesResident, n < 0", GL_INVALID_VALUE,
     [](Context& ctx) { are_textures_resident(ctx, -1, names, nullptr); }},

    {"TexParameter, target", GL_INVALID_ENUM,
     [](Context& ctx) { tex_parameterfv(ctx, GL_PROXY_TEXTURE_2D, GL_TEXTURE_PRIORITY, floats); }},
    {"TexParameter, name", GL_INVALID_ENUM,
     [](Context& ctx) { tex_parameterfv(ctx, GL_TEXTURE_2D, GL_TEXTURE_RESIDENT, floats); }},
    {"TexParameter, minification filter", GL_INVALID_ENUM,
     [](Context& ctx) {
         const GLfloat value = GL_REPEAT;
         tex_parameterfv(ctx, GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, &value);
     }},
    {"TexParameter, mipmaps for magnification", GL_INVALID_ENUM,
     [](Context& ctx) {
         const GLfloat value = GL_LINEAR_MIPMAP_LINEAR;
         tex_parameterfv(ctx, GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, &value);
     }},
    {"TexParameter, wrap mode", GL_INVALID_ENUM,
     [](Context& ctx) {
         const GLfloat value = GL_LINEAR;
         tex_parameterfv(ctx, GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, &value);
     }},
    {"TexParameter, base level < 0", GL_INVALID_VALUE,
     [](Context& ctx) {
         const GLfloat value = -1;
         tex_parameterfv(ctx, GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, &value);
     }},
    {"TexParameter, degree of anisotropy < 1", GL_INVALID_VALUE,
     [](Context& ctx) {
         const GLfloat value = 0.5f;
         tex_parameterfv(ctx, GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, &value);
     }},
    {"DrawPixels, depth and stencil without buffers", GL_INVALID_OPERATION,
     [](Context& ctx) { draw_pixels(ctx, 1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, pixels); }},
    {"ReadPixels, depth and stencil without buffers", GL_INVALID_OPERATION,
     [](Context& ctx) { read_pixels(ctx, 0, 0, 1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, pixels); }},
    {"CopyPixels, depth and stencil without buffers", GL_INVALID_OPERATION,
     [](Context& ctx) { copy_pixels(ctx, 0, 0, 1, 1, GL_DEPTH_STENCIL); }},
    {"DrawPixels, depth and stencil as floats", GL_INVALID_ENUM,
     [](Context& ctx) { draw_pixels(ctx, 1, 1, GL_DEPTH_STENCIL, GL_FLOAT, pixels); }},
    {"TexImage2D, colours as depth and stencil", GL_INVALID_OPERATION,
     [](Context& ctx) {
         tex_image_2d(ctx, GL_TEXTURE_2D, 0, 4, 1, 1, 0, GL_RGBA, GL_UNSIGNED_INT_24_8, pixels);
     }},
    {"GetTexImage, stencil values of colours", GL_INVALID_OPERATION,
     [](Context& ctx) {
         get_tex_image(ctx, GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, pixels);
     }},
    {"GetTexParameter, target", GL_INVALID_ENUM,
     [](Context& ctx) { get_tex_parameterfv(ctx, GL_PROXY_TEXTURE_2D, GL_TEXTURE_PRIORITY, floats); }},
    {"GetTexParameter, name", GL_INVALID_ENUM,
     [](Context& ctx) { get_tex_parameterfv(ctx, GL_TEXTURE_2D, GL_TEXTURE_WIDTH, floats); }},
    {"GetTexLevelParameter, target", GL_INVALID_ENUM,
     [](Context& ctx) {
         get_tex_level_parameterfv(ctx, GL_TEXTURE_BINDING_2D, 0, GL_TEXTURE_WIDTH, floats);
     }},
    {"GetTexLevelParameter, level < 0", GL_INVALID_VALUE,
     [](Context& ctx) { get_tex_level_parameterfv(ctx, GL_TEXTURE_2D, -1, GL_TEXTURE_WIDTH, floats); }},
    {"GetTexLevelParameter, level too high", GL_INVALID_VALUE,
     [](Context& ctx) {
         get_tex_level_parameterfv(ctx, GL_TEXTURE_2D, kMaxTextureLevels, GL_TEXTURE_WIDTH, floats);
     }},
    {"GetTexLevelParameter, name", GL_INVALID_ENUM,
     [](Context& ctx) { get_tex_level_parameterfv(ctx, GL_TEXTURE_2D, 0, GL_TEXTURE_PRIORITY, floats); }},

    {"TexImage2D, target", GL_INVALID_ENUM,
     [](Context& ctx) {
         tex_image_2d(ctx, GL_TEXTURE_1D, 0, 4, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
     }},
    {"TexImage1D, target", GL_INVALID_ENUM,
     [](Context& ctx) { tex_image_1d(ctx, GL_TEXTURE_2D, 0, 4, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels); }},
    {"TexImage2D, level < 0", GL_INVALID_VALUE,
     [](Context& ctx) {
         tex_image_2d(ctx, GL_TEXTURE_2D, -1, 4, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
     }},
    {"TexImage2D, level too high", GL_INVALID_VALUE,
     [](Context& ctx) {
         tex_image_2d(ctx, GL_TEXTURE_2D, kMaxTextureLevels, 4, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
     }},
    {"TexImage2D, width < 0", GL_INVALID_VALUE,
     [](Context& ctx) {
         tex_image_2d(ctx, GL_TEXTURE_2D, 0, 4, -8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
     }},
    {"TexImage2D, too wide", GL_INVALID_VALUE,
     [](Context& ctx) {
         tex_image_2d(ctx, GL_TEXTURE_2D, 0, 4, kMaxTextureSize + 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                      nullptr);
     }},
    {"TexImage2D, too wide for its level", GL_INVALID_VALUE,
     [](Context& ctx) {
         tex_image_2d(ctx, GL_TEXTURE_2D, 1, 4, kMaxTextureSize, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
     }},
    {"TexImage2D, as wide as can be", GL_INVALID_VALUE,
     [](Context& ctx) {
         tex_image_2d(ctx, GL_TEXTURE_2D, 0, 4, 0x7fffffff, 0x7fffffff, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                      nullptr);
     }},
    {"TexImage2D, smaller than its border", GL_INVALID_VALUE,
     [](Context& ctx) {
         tex_image_2d(ctx, GL_TEXTURE_2D, 0, 4, 1, 8, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
     }},
    {"TexImage2D, border", GL_INVALID_VALUE,
     [](Context& ctx) {
         tex_image_2d(ctx, GL_TEXTURE_2D, 0, 4, 8, 8, 2, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
     }},
    {"TexImage2D, internal format", GL_INVALID_VALUE,
     [](Context& ctx) {
         tex_image_2d(ctx, GL_TEXTURE_2D, 0, 5, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
     }},
    {"TexImage2D, format", GL_INVALID_ENUM,
     [](Context& ctx) {
         tex_image_2d(ctx, GL_TEXTURE_2D, 0, 4, 8, 8, 0, GL_INTENSITY, GL_UNSIGNED_BYTE, pixels);
     }},
    {"TexImage2D, stencil", GL_INVALID_ENUM,
     [](Context& ctx) {
         tex_image_2d(ctx, GL_TEXTURE_2D, 0, 4, 8, 8, 0, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, pixels);
     }},
    {"TexImage2D, depth for colour", GL_INVALID_OPERATION,
     [](Context& ctx) {
         tex_image_2d(ctx, GL_TEXTURE_2D, 0, 4, 8, 8, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE, pixels);
     }},
    {"TexImage2D, type", GL_INVALID_ENUM,
     [](Context& ctx) { tex_image_2d(ctx, GL_TEXTURE_2D, 0, 4, 8, 8, 0, GL_RGBA, GL_DOUBLE, pixels); }},
    {"TexImage2D, bitmap of colours", GL_INVALID_ENUM,
     [](Context& ctx) { tex_image_2d(ctx, GL_TEXTURE_2D, 0, 4, 8, 8, 0, GL_RGBA, GL_BITMAP, pixels); }},
    {"TexImage2D, packed type of another format", GL_INVALID_OPERATION,
     [](Context& ctx) {
         tex_image_2d(ctx, GL_TEXTURE_2D, 0, 4, 8, 8, 0, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5, pixels);
     }},
    {"TexImage2D to a proxy, border", GL_INVALID_VALUE,
     [](Context& ctx) {
         tex_image_2d(ctx, GL_PROXY_TEXTURE_2D, 0, 4, 8, 8, 2, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
     }},

    {"TexSubImage2D, target", GL_INVALID_ENUM,
     [](Context& ctx) {
         tex_sub_image_2d(ctx, GL_PROXY_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
     }},
    {"TexSubImage1D, target", GL_INVALID_ENUM,
     [](Context& ctx) { tex_sub_image_1d(ctx, GL_TEXTURE_2D, 0, 0, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels); }},
    {"TexSubImage2D, level", GL_INVALID_VALUE,
     [](Context& ctx) {
         tex_sub_image_2d(ctx, GL_TEXTURE_2D, kMaxTextureLevels, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                          pixels);
     }},
    {"TexSubImage2D of a level without image", GL_INVALID_OPERATION,
     [](Context& ctx) {
         tex_sub_image_2d(ctx, GL_TEXTURE_2D, 1, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
     }},
    {"TexSubImage1D of a texture without image", GL_INVALID_OPERATION,
     [](Context& ctx) { tex_sub_image_1d(ctx, GL_TEXTURE_1D, 0, 0, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels); }},
    {"TexSubImage2D, width < 0", GL_INVALID_VALUE,
     [](Context& ctx) {
         tex_sub_image_2d(ctx, GL_TEXTURE_2D, 0, 2, 2, -1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
     }},
    {"TexSubImage2D, left of the image", GL_INVALID_VALUE,
     [](Context& ctx) {
         tex_sub_image_2d(ctx, GL_TEXTURE_2D, 0, -1, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
     }},
    {"TexSubImage2D, above the image", GL_INVALID_VALUE,
     [](Context& ctx) {
         tex_sub_image_2d(ctx, GL_TEXTURE_2D, 0, 0, 2, 1, 3, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
     }},
    {"TexSubImage2D, sum beyond 32 bits", GL_INVALID_VALUE,
     [](Context& ctx) {
         tex_sub_image_2d(ctx, GL_TEXTURE_2D, 0, 0x7fffffff, 0, 0x7fffffff, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                          pixels);
     }},
    {"TexSubImage2D, format", GL_INVALID_ENUM,
     [](Context& ctx) { tex_sub_image_2d(ctx, GL_TEXTURE_2D, 0, 0, 0, 1, 1, 4, GL_UNSIGNED_BYTE, pixels); }},

    {"CopyTexImage2D, target", GL_INVALID_ENUM,
     [](Context& ctx) { copy_tex_image_2d(ctx, GL_PROXY_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, 4, 0); }},
    {"CopyTexImage2D, component count", GL_INVALID_ENUM,
     [](Context& ctx) { copy_tex_image_2d(ctx, GL_TEXTURE_2D, 0, 3, 0, 0, 4, 4, 0); }},
    {"CopyTexImage2D, internal format", GL_INVALID_ENUM,
     [](Context& ctx) { copy_tex_image_2d(ctx, GL_TEXTURE_2D, 0, GL_BGRA, 0, 0, 4, 4, 0); }},
    {"CopyTexImage2D, level", GL_INVALID_VALUE,
     [](Context& ctx) { copy_tex_image_2d(ctx, GL_TEXTURE_2D, -1, GL_RGBA, 0, 0, 4, 4, 0); }},
    {"CopyTexImage2D, height < 0", GL_INVALID_VALUE,
     [](Context& ctx) { copy_tex_image_2d(ctx, GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, -4, 0); }},
    {"CopyTexImage2D, border", GL_INVALID_VALUE,
     [](Context& ctx) { copy_tex_image_2d(ctx, GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, 4, -1); }},
    {"CopyTexImage1D, too wide", GL_INVALID_VALUE,
     [](Context& ctx) { copy_tex_image_1d(ctx, GL_TEXTURE_1D, 0, GL_RGBA, 0, 0, kMaxTextureSize + 1, 0); }},
    {"CopyTexSubImage2D, target", GL_INVALID_ENUM,
     [](Context& ctx) { copy_tex_sub_image_2d(ctx, GL_TEXTURE_1D, 0, 0, 0, 0, 0, 1, 1); }},
    {"CopyTexSubImage2D of a level without image", GL_INVALID_OPERATION,
     [](Context& ctx) { copy_tex_sub_image_2d(ctx, GL_TEXTURE_2D, 2, 0, 0, 0, 0, 1, 1); }},
    {"CopyTexSubImage2D, beyond the image", GL_INVALID_VALUE,
     [](Context& ctx) { copy_tex_sub_image_2d(ctx, GL_TEXTURE_2D, 0, 1, 0, 0, 0, 4, 1); }},
    {"CopyTexSubImage1D of a texture without image", GL_INVALID_OPERATION,
     [](Context& ctx) { copy_tex_sub_image_1d(ctx, GL_TEXTURE_1D, 0, 0, 0, 0, 1); }},

    {"GetTexImage, target", GL_INVALID_ENUM,
     [](Context& ctx) { get_tex_image(ctx, GL_PROXY_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels); }},
    {"GetTexImage, level", GL_INVALID_VALUE,
     [](Context& ctx) {
         get_tex_image(ctx, GL_TEXTURE_2D, kMaxTextureLevels, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
     }},
    {"GetTexImage, stencil", GL_INVALID_ENUM,
     [](Context& ctx) { get_tex_image(ctx, GL_TEXTURE_2D, 0, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, pixels); }},
    {"GetTexImage, colour index", GL_INVALID_ENUM,
     [](Context& ctx) { get_tex_image(ctx, GL_TEXTURE_2D, 0, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, pixels); }},
    {"GetTexImage, packed type of another format", GL_INVALID_OPERATION,
     [](Context& ctx) { get_tex_image(ctx, GL_TEXTURE_2D, 0, GL_RGB, GL_UNSIGNED_INT_8_8_8_8, pixels); }},

    {"ReadPixels, width < 0", GL_INVALID_VALUE,
     [](Context& ctx) { read_pixels(ctx, 0, 0, -1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels); }},
    {"ReadPixels, format", GL_INVALID_ENUM,
     [](Context& ctx) { read_pixels(ctx, 0, 0, 1, 1, GL_INTENSITY, GL_UNSIGNED_BYTE, pixels); }},
    {"ReadPixels, type", GL_INVALID_ENUM,
     [](Context& ctx) { read_pixels(ctx, 0, 0, 1, 1, GL_RGBA, GL_DOUBLE, pixels); }},
    {"ReadPixels, bitmap of colours", GL_INVALID_ENUM,
     [](Context& ctx) { read_pixels(ctx, 0, 0, 1, 1, GL_RED, GL_BITMAP, pixels); }},
    {"ReadPixels, packed type of another format", GL_INVALID_OPERATION,
     [](Context& ctx) { read_pixels(ctx, 0, 0, 1, 1, GL_BGR, GL_UNSIGNED_SHORT_5_6_5, pixels); }},
    {"ReadPixels, colour indices of RGBA", GL_INVALID_OPERATION,
     [](Context& ctx) { read_pixels(ctx, 0, 0, 1, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, pixels); }},
    {"ReadPixels, no depth buffer", GL_INVALID_OPERATION,
     [](Context& ctx) { read_pixels(ctx, 0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, pixels); }},
    {"ReadPixels, no stencil buffer", GL_INVALID_OPERATION,
     [](Context& ctx) { read_pixels(ctx, 0, 0, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, pixels); }},

    {"PixelStore, name", GL_INVALID_ENUM, [](Context& ctx) { pixel_storei(ctx, GL_RED_SCALE, 1); }},
    {"PixelStore, alignment", GL_INVALID_VALUE,
     [](Context& ctx) { pixel_storei(ctx, GL_PACK_ALIGNMENT, 3); }},
    {"PixelStore, row length", GL_INVALID_VALUE,
     [](Context& ctx) { pixel_storei(ctx, GL_UNPACK_ROW_LENGTH, -1); }},
    {"PixelStore, skip", GL_INVALID_VALUE, [](Context& ctx) { pixel_storei(ctx, GL_PACK_SKIP_PIXELS, -1); }},
    {"PixelTransfer, name", GL_INVALID_ENUM,
     [](Context& ctx) { pixel_transferf(ctx, GL_PACK_ALIGNMENT, 1); }},
    {"PixelMap, name", GL_INVALID_ENUM, [](Context& ctx) { pixel_mapfv(ctx, GL_MAP_COLOR, 1, floats); }},
    {"PixelMap, empty", GL_INVALID_VALUE,
     [](Context& ctx) { pixel_mapfv(ctx, GL_PIXEL_MAP_R_TO_R, 0, floats); }},
    {"PixelMap, too big", GL_INVALID_VALUE,
     [](Context& ctx) { pixel_mapuiv(ctx, GL_PIXEL_MAP_R_TO_R, kMaxPixelMapTable + 1, integers); }},
    {"PixelMap from indices, no power of two", GL_INVALID_VALUE,
     [](Context& ctx) { pixel_mapfv(ctx, GL_PIXEL_MAP_I_TO_R, 3, floats); }},
    {"PixelMap of stencil, no power of two", GL_INVALID_VALUE,
     [](Context& ctx) { pixel_mapfv(ctx, GL_PIXEL_MAP_S_TO_S, 5, floats); }},
    {"GetPixelMap, name", GL_INVALID_ENUM,
     [](Context& ctx) { get_pixel_mapfv(ctx, GL_PIXEL_MAP_I_TO_I_SIZE, floats); }},
};

class TextureErrors : public GlTest {
  protected:
    TextureErrors() {
        attach_picture(ctx(), 16, 16, {raster::ColorFormat::kRgba8, true, 0, 0});
        bind_texture(ctx(), GL_TEXTURE_2D, 10);
        for (size_t i = 0; i < sizeof texels; ++i) texels[i] = static_cast<uint8_t>(i);
        tex_image_2d(ctx(), GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    }

    // What the calls above could have changed.
    std::vector<double> state() {
        std::vector<double> values{double(ctx().shared.use_count()),
                                   double(ctx().texture.proxies[kTexture2D].levels[0].width),
                                   double(bound_texture(ctx(), GL_TEXTURE_1D)->name)};
        const TextureObject& object = *bound_texture(ctx(), GL_TEXTURE_2D);
        const TextureParameters& p = object.parameters;
        values.insert(values.end(), {double(object.name), double(p.min_filter), double(p.mag_filter),
                                     double(p.wrap_t), double(p.base_level), p.priority});
        for (const TextureLevel& level : object.levels) {
            values.insert(values.end(),
                          {double(level.width), double(level.height), double(level.internal_format)});
        }
        uint8_t now[sizeof texels];
        get_tex_image(ctx(), GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, now);
        values.insert(values.end(), now, now + sizeof now);
        for (const PixelStore* store : {&ctx().pixels.pack, &ctx().pixels.unpack}) {
            values.insert(values.end(),
                          {double(store->alignment), double(store->row_length), double(store->skip_pixels)});
        }
        for (const PixelMap& map : ctx().pixels.maps) values.push_back(map.size);
        return values;
    }

    uint8_t texels[64];
};

TEST_F(TextureErrors, AreRecordedAndChangeNothing) {
    const std::vector<double> before = state();
    for (const BadCall& bad : kBadCalls) {
        std::fill(std::begin(pixels), std::end(pixels), 0xcd);
        bad.call(ctx());
        EXPECT_EQ(take_error(), bad.error) << bad.text;
        EXPECT_EQ(state(), before) << bad.text;
        EXPECT_THAT(pixels, testing::Each(0xcd)) << bad.text;
    }
}

TEST_F(TextureErrors, ProxiesAnswerWithoutError) {
    const auto width = [&](GLsizei size, GLint internal_format) {
        tex_image_2d(ctx(), GL_PROXY_TEXTURE_2D, 0, internal_format, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     nullptr);
        EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
        GLfloat answer = -1;
        get_tex_level_parameterfv(ctx(), GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &answer);
        return answer;
    };
    EXPECT_EQ(width(64, GL_RGBA), 64);
    EXPECT_EQ(width(kMaxTextureSize, GL_RGBA), kMaxTextureSize);
    EXPECT_EQ(width(kMaxTextureSize + 1, GL_RGBA), 0);
    EXPECT_EQ(width(kMaxTextureSize, GL_RGBA16), 0);  // 4 GB
}

TEST_F(TextureErrors, TooMuchMemoryIsOutOfMemory) {
    EXPECT_THROW(tex_image_2d(ctx(), GL_TEXTURE_2D, 0, GL_RGBA16, kMaxTextureSize, kMaxTextureSize, 0,
                              GL_RGBA, GL_UNSIGNED_BYTE, nullptr),
                 std::bad_alloc);
    EXPECT_EQ(bound_texture(ctx(), GL_TEXTURE_2D)->levels[0].width, 4);
}

}  // namespace
}  // namespace terrazzo::gl
