// Texture objects: names, bindings, sharing, parameters, completeness, images that queued draws refer to.
#include "gl/texture.h"

#include <gmock/gmock.h>

#include <array>
#include <vector>

#include "gl/attrib.h"
#include "gl/generated/commands.h"
#include "gl/share.h"
#include "gl_fixture.h"

namespace terrazzo::gl {
namespace {

using testing::ElementsAre;

class TextureTest : public GlTest {
  protected:
    // A bound 2D texture of a new name.
    TextureObject& make_texture(GLenum min_filter = GL_NEAREST_MIPMAP_NEAREST) {
        GLuint name;
        gen_textures(ctx(), 1, &name);
        bind_texture(ctx(), GL_TEXTURE_2D, name);
        set(GL_TEXTURE_MIN_FILTER, static_cast<GLfloat>(min_filter));
        return *bound_texture(ctx(), GL_TEXTURE_2D);
    }

    void set(GLenum pname, GLfloat value) { tex_parameterfv(ctx(), GL_TEXTURE_2D, pname, &value); }

    void specify(GLint level, GLsizei width, GLsizei height, GLint internal_format = GL_RGBA,
                 GLint border = 0) {
        tex_image_2d(ctx(), GL_TEXTURE_2D, level, internal_format, width, height, border, GL_RGBA,
                     GL_UNSIGNED_BYTE, nullptr);
        ASSERT_EQ(take_error(), GLenum{GL_NO_ERROR});
    }
};

TEST_F(TextureTest, NamesBecomeTexturesWhenBound) {
    GLuint names[2];
    gen_textures(ctx(), 2, names);
    EXPECT_NE(names[0], names[1]);
    EXPECT_EQ(is_texture(ctx(), names[0]), GL_FALSE);
    bind_texture(ctx(), GL_TEXTURE_1D, names[0]);
    EXPECT_EQ(is_texture(ctx(), names[0]), GL_TRUE);
    EXPECT_EQ(is_texture(ctx(), names[1]), GL_FALSE);
    EXPECT_EQ(is_texture(ctx(), 0), GL_FALSE);
    bind_texture(ctx(), GL_TEXTURE_2D, names[0]);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
}

// What glXCopyContext does: the parameters come along, the objects of another share group do not.
TEST_F(TextureTest, CopiedAttributesLeaveTexturesInTheirGroup) {
    const auto stranger = create_context(Config{}, nullptr), sharer = create_context(Config{}, &ctx());
    set(GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    copy_attributes(ctx(), *stranger, GL_TEXTURE_BIT);
    copy_attributes(ctx(), *sharer, GL_TEXTURE_BIT);
    const TextureObject* const mine = bound_texture(ctx(), GL_TEXTURE_2D);
    EXPECT_EQ(bound_texture(*sharer, GL_TEXTURE_2D), mine);
    EXPECT_NE(bound_texture(*stranger, GL_TEXTURE_2D), mine);
    EXPECT_EQ(bound_texture(*stranger, GL_TEXTURE_2D)->parameters.min_filter, GLenum{GL_NEAREST});
    const TextureObject& named = make_texture();
    copy_attributes(ctx(), *stranger, GL_TEXTURE_BIT);
    copy_attributes(ctx(), *sharer, GL_TEXTURE_BIT);
    EXPECT_EQ(bound_texture(*sharer, GL_TEXTURE_2D), &named);
    EXPECT_EQ(bound_texture(*stranger, GL_TEXTURE_2D)->name, 0u);
    for (const TextureUnit& unit : stranger->texture.units)
        for (int target = 0; target < kTextureTargetCount; ++target)
            EXPECT_EQ(unit.bound[target], stranger->shared->textures.defaults[target]);
}

TEST_F(TextureTest, NamesNeedNotBeGenerated) {
    bind_texture(ctx(), GL_TEXTURE_2D, 1);
    bind_texture(ctx(), GL_TEXTURE_2D, 77);
    EXPECT_EQ(is_texture(ctx(), 77), GL_TRUE);
    GLuint name;
    gen_textures(ctx(), 1, &name);
    EXPECT_NE(name, 1u);
    EXPECT_NE(name, 77u);
}

TEST_F(TextureTest, DeletingUnbinds) {
    const TextureObject* default_texture = bound_texture(ctx(), GL_TEXTURE_2D);
    const GLuint names[] = {make_texture().name, 0, 12345};
    delete_textures(ctx(), 3, names);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
    EXPECT_EQ(bound_texture(ctx(), GL_TEXTURE_2D), default_texture);
    EXPECT_EQ(is_texture(ctx(), names[0]), GL_FALSE);
}

TEST_F(TextureTest, ContextsShareObjects) {
    TextureObject& object = make_texture();
    const std::unique_ptr<Context> other = create_context({}, &ctx());
    bind_texture(*other, GL_TEXTURE_2D, object.name);
    EXPECT_EQ(bound_texture(*other, GL_TEXTURE_2D), &object);
    // Deleted here, it stays for the other until that unbinds it.
    const GLuint name = object.name;
    delete_textures(ctx(), 1, &name);
    EXPECT_EQ(bound_texture(*other, GL_TEXTURE_2D), &object);
    EXPECT_EQ(is_texture(*other, name), GL_FALSE);
}

TEST_F(TextureTest, ResidenceAndPriorities) {
    const GLuint name = make_texture().name;
    GLboolean resident = GL_FALSE;
    EXPECT_EQ(are_textures_resident(ctx(), 1, &name, &resident), GL_TRUE);
    const GLuint unknown[] = {name, 999};
    EXPECT_EQ(are_textures_resident(ctx(), 2, unknown, &resident), GL_FALSE);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_VALUE});
    const GLfloat priorities[] = {7, 0.5f};
    prioritize_textures(ctx(), 2, unknown, priorities);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
    GLfloat priority = 0;
    get_tex_parameterfv(ctx(), GL_TEXTURE_2D, GL_TEXTURE_PRIORITY, &priority);
    EXPECT_EQ(priority, 1.0f);
}

TEST_F(TextureTest, BorderColorIsClamped) {
    const GLfloat color[] = {-1, 0.5f, 2, 1};
    tex_parameterfv(ctx(), GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, color);
    GLfloat kept[4];
    get_tex_parameterfv(ctx(), GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, kept);
    EXPECT_THAT(kept, ElementsAre(0, 0.5f, 1, 1));
}

// GL 1.5 §3.8.10, rule by rule.

TEST_F(TextureTest, WithoutBaseLevelIncomplete) {
    TextureObject& object = make_texture(GL_LINEAR);
    EXPECT_FALSE(completeness(object).complete);
    specify(1, 4, 4);
    EXPECT_FALSE(completeness(object).complete);
    set(GL_TEXTURE_BASE_LEVEL, 1);
    EXPECT_TRUE(completeness(object).complete);
    EXPECT_EQ(completeness(object).base, 1);
    set(GL_TEXTURE_BASE_LEVEL, 5000);
    EXPECT_FALSE(completeness(object).complete);
}

TEST_F(TextureTest, EmptyBaseLevelIncomplete) {
    TextureObject& object = make_texture(GL_LINEAR);
    specify(0, 0, 4);
    EXPECT_FALSE(completeness(object).complete);
}

TEST_F(TextureTest, MipmapsNeedEveryLevelDownToOneTexel) {
    TextureObject& object = make_texture();
    specify(0, 8, 2);
    specify(1, 4, 1);
    specify(2, 2, 1);
    EXPECT_FALSE(completeness(object).complete);
    set(GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    EXPECT_TRUE(completeness(object).complete);
    set(GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    specify(3, 1, 1);
    EXPECT_TRUE(completeness(object).complete);
    EXPECT_EQ(completeness(object).last, 3);
}

TEST_F(TextureTest, LevelsNeedTheSameInternalFormatByName) {
    TextureObject& object = make_texture();
    specify(0, 2, 2, GL_RGBA);
    specify(1, 1, 1, GL_RGBA8);
    EXPECT_FALSE(completeness(object).complete);
    specify(1, 1, 1, GL_RGBA);
    EXPECT_TRUE(completeness(object).complete);
}

TEST_F(TextureTest, UnitsHaveBindingsOfTheirOwn) {
    const GLuint first = make_texture().name;
    active_texture(ctx(), GL_TEXTURE7);
    const GLuint second = make_texture().name;
    EXPECT_EQ(bound_texture(ctx(), GL_TEXTURE_2D)->name, second);
    active_texture(ctx(), GL_TEXTURE7 + 1);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(bound_texture(ctx(), GL_TEXTURE_2D)->name, second);
    active_texture(ctx(), GL_TEXTURE0);
    EXPECT_EQ(bound_texture(ctx(), GL_TEXTURE_2D)->name, first);
    // Deleting unbinds from all units.
    delete_textures(ctx(), 1, &second);
    active_texture(ctx(), GL_TEXTURE7);
    EXPECT_EQ(bound_texture(ctx(), GL_TEXTURE_2D)->name, 0u);
}

TEST_F(TextureTest, MipmapsAreGeneratedUpToTheirEnds) {
    TextureObject& object = make_texture();
    set(GL_GENERATE_MIPMAP, GL_TRUE);
    set(GL_TEXTURE_BASE_LEVEL, 1);
    set(GL_TEXTURE_MAX_LEVEL, 3);
    specify(0, 32, 8);
    EXPECT_EQ(object.levels[1].image.operator->(), nullptr);
    specify(1, 16, 4, GL_LUMINANCE);
    EXPECT_EQ(object.levels[0].width, 32);
    EXPECT_EQ(object.levels[3].width, 4);
    EXPECT_EQ(object.levels[3].height, 1);
    EXPECT_EQ(object.levels[3].internal_format, GL_LUMINANCE);
    EXPECT_EQ(object.levels[4].image.operator->(), nullptr);
    EXPECT_TRUE(completeness(object).complete);
}

TEST_F(TextureTest, GeneratedTexelsAreMeansRoundedUpPairByPair) {
    make_texture();
    set(GL_GENERATE_MIPMAP, GL_TRUE);
    const GLubyte texels[] = {10, 13, 20, 21};
    pixel_storei(ctx(), GL_UNPACK_ALIGNMENT, 1);
    tex_image_2d(ctx(), GL_TEXTURE_2D, 0, GL_LUMINANCE8, 2, 2, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels);
    GLubyte mean = 0;
    get_tex_image(ctx(), GL_TEXTURE_2D, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, &mean);
    EXPECT_EQ(mean, 17);  // of (10 + 13 + 1) / 2 and (20 + 21 + 1) / 2
    const GLubyte changed = 90;
    tex_sub_image_2d(ctx(), GL_TEXTURE_2D, 0, 1, 1, 1, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, &changed);
    get_tex_image(ctx(), GL_TEXTURE_2D, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, &mean);
    EXPECT_EQ(mean, 34);
}

TEST_F(TextureTest, GenerateMipmapNeedsABaseLevel) {
    TextureObject& object = make_texture();
    generate_mipmap(ctx(), GL_TEXTURE_2D);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
    generate_mipmap(ctx(), GL_PROXY_TEXTURE_2D);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_ENUM});
    specify(0, 5, 3, GL_RGBA, 1);
    generate_mipmap(ctx(), GL_TEXTURE_2D);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
    EXPECT_TRUE(completeness(object).complete);
    EXPECT_EQ(object.levels[1].border, 1);
    GLuint cube = 0;
    gen_textures(ctx(), 1, &cube);
    bind_texture(ctx(), GL_TEXTURE_CUBE_MAP, cube);
    tex_image_2d(ctx(), GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_RGB, 4, 4, 0, GL_RGB, GL_UNSIGNED_BYTE,
                 nullptr);
    generate_mipmap(ctx(), GL_TEXTURE_CUBE_MAP);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
}

TEST_F(TextureTest, MaxLevelEndsTheMipmap) {
    TextureObject& object = make_texture();
    specify(0, 8, 8);
    specify(1, 4, 4);
    set(GL_TEXTURE_MAX_LEVEL, 1);
    EXPECT_TRUE(completeness(object).complete);
    EXPECT_EQ(completeness(object).last, 1);
    set(GL_TEXTURE_BASE_LEVEL, 2);
    EXPECT_FALSE(completeness(object).complete);
}

TEST_F(TextureTest, LevelsMustFitTheBase) {
    TextureObject& object = make_texture();
    specify(0, 2, 2);
    specify(1, 1, 1);
    EXPECT_TRUE(completeness(object).complete);
    specify(1, 2, 1);
    EXPECT_FALSE(completeness(object).complete);
    specify(1, 1, 1, GL_RGB);
    EXPECT_FALSE(completeness(object).complete);
    specify(1, 3, 3, GL_RGBA, 1);
    EXPECT_FALSE(completeness(object).complete);
    specify(0, 4, 4, GL_RGBA, 1);
    EXPECT_TRUE(completeness(object).complete);
}

TEST_F(TextureTest, OddSizesRoundDown) {
    TextureObject& object = make_texture();
    specify(0, 7, 5);
    specify(1, 3, 2);
    specify(2, 1, 1);
    EXPECT_TRUE(completeness(object).complete);
}

TEST_F(TextureTest, ImagesInUseAreNotWritten) {
    TextureObject& object = make_texture();
    const std::array<uint8_t, 16> white = [] {
        std::array<uint8_t, 16> a;
        a.fill(255);
        return a;
    }();
    specify(0, 2, 2);
    const std::shared_ptr<raster::TextureImage> in_use = object.levels[0].image.shared();
    tex_sub_image_2d(ctx(), GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
    EXPECT_NE(object.levels[0].image.shared(), in_use);
    EXPECT_EQ(in_use->rgba8(0, 0)[0], 0);
    EXPECT_EQ(object.levels[0].image->rgba8(0, 0)[0], 255);
    // Not in use any more, the same image is written in place.
    const raster::TextureImage* alone = &*object.levels[0].image;
    tex_sub_image_2d(ctx(), GL_TEXTURE_2D, 0, 1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
    EXPECT_EQ(&*object.levels[0].image, alone);
    EXPECT_EQ(alone->rgba8(1, 1)[3], 255);
}

TEST_F(TextureTest, TexelsMayBeReadPastTheirEnds) {
    const auto image = raster::TextureImage::create({3, 3, 1, 1, 1, 0}, raster::TexelStorage::kRgba8,
                                                    raster::BaseFormat::kRgba);
    EXPECT_EQ(reinterpret_cast<uintptr_t>(image->rgba8(-1, -1)) % 64, 0u);
    unsigned sum = 0;  // the sanitizer watches these
    const uint8_t* first = image->rgba8(-1, -1);
    const uint8_t* last = image->rgba8(3, 3) + 3;
    for (size_t i = 1; i <= raster::TextureImage::kPaddingBytes; ++i)
        sum += first[-static_cast<ptrdiff_t>(i)] + last[i];
    EXPECT_EQ(sum, 0u);
}

}  // namespace
}  // namespace terrazzo::gl
