// Pixel buffer objects (ARB_pixel_buffer_object): every command that reads or writes the client's pixels, in
// and out of bounds, mapped and in display lists.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <gmock/gmock.h>

#include <array>
#include <functional>
#include <numeric>
#include <vector>

#include "attach_picture.h"
#include "gl_fixture.h"

namespace terrazzo::gl {
namespace {

using testing::Each;
using testing::ElementsAre;

constexpr int kSize = 8;
using Bytes = std::vector<GLubyte>;

const void* at(std::size_t offset) {
    return reinterpret_cast<const void*>(offset);
}
void* to(std::size_t offset) {
    return reinterpret_cast<void*>(offset);
}

class PixelBuffers : public GlTest {
  protected:
    PixelBuffers() {
        attach_picture(ctx(), kSize, kSize);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glRasterPos2f(-1, -1);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    }

    static GLuint bind(GLenum target, GLsizeiptr size, const void* data = nullptr) {
        GLuint name = 0;
        glGenBuffers(1, &name);
        glBindBuffer(target, name);
        glBufferData(target, size, data, GL_STREAM_COPY);
        return name;
    }
    static Bytes contents(GLenum target, std::size_t size) {
        Bytes bytes(size);
        glGetBufferSubData(target, 0, static_cast<GLsizeiptr>(size), bytes.data());
        return bytes;
    }
    static Bytes picture(int width, int height) {
        Bytes pixels(static_cast<std::size_t>(4 * width * height));
        glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
        glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        return pixels;
    }
    static Bytes counting(std::size_t size) {
        Bytes bytes(size);
        std::iota(bytes.begin(), bytes.end(), GLubyte{1});
        return bytes;
    }
};

TEST_F(PixelBuffers, BindingsAreQueriedAndSaved) {
    const GLuint pack = bind(GL_PIXEL_PACK_BUFFER, 4), unpack = bind(GL_PIXEL_UNPACK_BUFFER, 4);
    const auto bound = [](GLenum name) {
        GLint value = -1;
        glGetIntegerv(name, &value);
        return static_cast<GLuint>(value);
    };
    EXPECT_EQ(bound(GL_PIXEL_PACK_BUFFER_BINDING), pack);
    EXPECT_EQ(bound(GL_PIXEL_UNPACK_BUFFER_BINDING), unpack);
    glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    EXPECT_EQ(bound(GL_PIXEL_PACK_BUFFER_BINDING), 0u);
    glDeleteBuffers(1, &unpack);
    glPopClientAttrib();
    EXPECT_EQ(bound(GL_PIXEL_PACK_BUFFER_BINDING), pack);
    EXPECT_EQ(bound(GL_PIXEL_UNPACK_BUFFER_BINDING), 0u) << "deleted buffers stay deleted";
    glDeleteBuffers(1, &pack);
    EXPECT_EQ(bound(GL_PIXEL_PACK_BUFFER_BINDING), 0u);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
}

TEST_F(PixelBuffers, RectanglesAndBitmapsComeFromThem) {
    const Bytes bytes = counting(64);
    bind(GL_PIXEL_UNPACK_BUFFER, 64, bytes.data());
    glDrawPixels(2, 2, GL_RGBA, GL_UNSIGNED_BYTE, at(0));
    EXPECT_EQ(picture(2, 1), Bytes(bytes.begin(), bytes.begin() + 8));
    glDrawPixels(2, 2, GL_RGBA, GL_UNSIGNED_BYTE, at(48));
    EXPECT_EQ(picture(2, 1), Bytes(bytes.begin() + 48, bytes.begin() + 56));
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
    glDrawPixels(2, 2, GL_RGBA, GL_UNSIGNED_BYTE, at(49));
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});

    const GLubyte rows[] = {0x00, 0xc0, 0x40};
    bind(GL_PIXEL_UNPACK_BUFFER, sizeof rows, rows);
    glColor3f(1, 1, 1);
    glRasterPos2f(-1, -1);
    glBitmap(2, 2, 0, 0, 0, 0, static_cast<const GLubyte*>(at(1)));
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
    EXPECT_THAT(picture(2, 1), Each(255));
    glBitmap(2, 2, 0, 0, 5, 5, static_cast<const GLubyte*>(at(2)));
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
    GLfloat position[4];
    glGetFloatv(GL_CURRENT_RASTER_POSITION, position);
    EXPECT_EQ(position[0], 0) << "what fails moves nothing";
}

TEST_F(PixelBuffers, TexturesComeFromThem) {
    const Bytes bytes = counting(32);
    bind(GL_PIXEL_UNPACK_BUFFER, 32, bytes.data());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, at(0));
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 1, 2, 1, GL_RGBA, GL_UNSIGNED_BYTE, at(24));
    glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, at(0));
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 2, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, at(0));
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
    Bytes texels(16);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    EXPECT_EQ(Bytes(texels.begin(), texels.begin() + 8), Bytes(bytes.begin(), bytes.begin() + 8));
    EXPECT_EQ(Bytes(texels.begin() + 8, texels.end()), Bytes(bytes.begin() + 24, bytes.end()));
}

TEST_F(PixelBuffers, PixelsGoToThem) {
    glClearColor(1, 0.2f, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    bind(GL_PIXEL_PACK_BUFFER, 12);
    glReadPixels(0, 0, 2, 1, GL_RGBA, GL_UNSIGNED_BYTE, to(4));
    EXPECT_THAT(contents(GL_PIXEL_PACK_BUFFER, 12),
                ElementsAre(0, 0, 0, 0, 255, 51, 0, 255, 255, 51, 0, 255));
    const GLubyte texel[] = {9, 8, 7, 6};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    EXPECT_THAT(contents(GL_PIXEL_PACK_BUFFER, 4), ElementsAre(9, 8, 7, 6));
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
}

TEST_F(PixelBuffers, MapsAndStipplesGoBothWays) {
    const GLfloat values[] = {0.25f, 0.5f};
    bind(GL_PIXEL_UNPACK_BUFFER, sizeof values, values);
    glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 2, nullptr);
    Bytes pattern = counting(128);
    bind(GL_PIXEL_UNPACK_BUFFER, 128, pattern.data());
    glPolygonStipple(nullptr);
    bind(GL_PIXEL_PACK_BUFFER, 140);
    glGetPixelMapfv(GL_PIXEL_MAP_R_TO_R, static_cast<GLfloat*>(to(132)));
    glGetPolygonStipple(nullptr);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
    GLfloat map[2];
    glGetBufferSubData(GL_PIXEL_PACK_BUFFER, 132, sizeof map, map);
    EXPECT_THAT(map, ElementsAre(0.25f, 0.5f));
    EXPECT_EQ(contents(GL_PIXEL_PACK_BUFFER, 128), pattern);
}

TEST_F(PixelBuffers, CompressedImagesGoBothWays) {
    const Bytes block = counting(24);
    bind(GL_PIXEL_UNPACK_BUFFER, 24, block.data());
    glCompressedTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 4, 4, 0, 8, at(3));
    glCompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 8, nullptr);
    bind(GL_PIXEL_PACK_BUFFER, 9);
    glGetCompressedTexImage(GL_TEXTURE_2D, 0, to(1));
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
    const Bytes packed = contents(GL_PIXEL_PACK_BUFFER, 9);
    EXPECT_EQ(Bytes(packed.begin() + 1, packed.end()), Bytes(block.begin(), block.begin() + 8));
    glGetCompressedTexImage(GL_TEXTURE_2D, 0, to(2));
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
}

// Bounds follow the pixel store modes to the last pixel and no further.
TEST_F(PixelBuffers, BoundsAreThoseOfThePixels) {
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 5);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 1);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 2);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 8);
    constexpr GLsizeiptr kEnd = 24 * 2 + (2 + 3) * 4;  // rows of 5 pixels, 24 bytes each
    for (const GLsizeiptr size : {kEnd - 1, kEnd}) {
        bind(GL_PIXEL_UNPACK_BUFFER, size);
        glDrawPixels(3, 2, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        EXPECT_EQ(take_error(), GLenum(size < kEnd ? GL_INVALID_OPERATION : GL_NO_ERROR));
    }
    for (const GLenum parameter : {GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_IMAGES,
                                   GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_PIXELS})
        glPixelStorei(parameter, 0x7fffffff);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 2, 2, 2, 0, GL_RGBA, GL_FLOAT, nullptr);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION}) << "sizes do not wrap round";
}

struct Access {
    const char* text;
    std::function<void()> call;
};
GLubyte* const kOffset = nullptr;
const Access kReads[] = {
    {"DrawPixels", [] { glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, kOffset); }},
    {"Bitmap", [] { glBitmap(8, 1, 0, 0, 1, 0, kOffset); }},
    {"PolygonStipple", [] { glPolygonStipple(kOffset); }},
    {"PixelMapfv", [] { glPixelMapfv(GL_PIXEL_MAP_I_TO_I, 1, nullptr); }},
    {"PixelMapuiv", [] { glPixelMapuiv(GL_PIXEL_MAP_I_TO_I, 1, nullptr); }},
    {"PixelMapusv", [] { glPixelMapusv(GL_PIXEL_MAP_I_TO_I, 1, nullptr); }},
    {"TexImage1D", [] { glTexImage1D(GL_TEXTURE_1D, 0, 4, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, kOffset); }},
    {"TexImage2D", [] { glTexImage2D(GL_TEXTURE_2D, 1, 4, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, kOffset); }},
    {"TexImage3D", [] { glTexImage3D(GL_TEXTURE_3D, 0, 4, 1, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, kOffset); }},
    {"TexSubImage2D",
     [] { glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, kOffset); }},
    {"CompressedTexImage2D",
     [] { glCompressedTexImage2D(GL_TEXTURE_2D, 2, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 1, 1, 0, 8, kOffset); }},
};
const Access kWrites[] = {
    {"ReadPixels", [] { glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, kOffset); }},
    {"GetTexImage", [] { glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, kOffset); }},
    {"GetPolygonStipple", [] { glGetPolygonStipple(kOffset); }},
    {"GetPixelMapfv", [] { glGetPixelMapfv(GL_PIXEL_MAP_R_TO_R, nullptr); }},
    {"GetPixelMapuiv", [] { glGetPixelMapuiv(GL_PIXEL_MAP_R_TO_R, nullptr); }},
    {"GetPixelMapusv", [] { glGetPixelMapusv(GL_PIXEL_MAP_R_TO_R, nullptr); }},
};

TEST_F(PixelBuffers, WhatIsMappedOrMissingIsNotTouched) {
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    const auto expect_errors = [&](GLenum target, const auto& calls) {
        for (const Access& access : calls) {
            bind(target, 512);
            access.call();
            EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR}) << access.text;
            glMapBuffer(target, GL_READ_WRITE);
            access.call();
            EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION}) << access.text << ", mapped";
            bind(target, 0);
            access.call();
            EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION}) << access.text << ", empty";
            glBindBuffer(target, 0);
        }
    };
    expect_errors(GL_PIXEL_UNPACK_BUFFER, kReads);
    expect_errors(GL_PIXEL_PACK_BUFFER, kWrites);
}

TEST_F(PixelBuffers, ListsReadThemWhenTheyAreCompiled) {
    const GLubyte red[] = {255, 0, 0, 255};
    const GLfloat map[] = {0.75f};
    bind(GL_PIXEL_UNPACK_BUFFER, sizeof red, red);
    glNewList(1, GL_COMPILE);
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    bind(GL_PIXEL_UNPACK_BUFFER, sizeof map, map);
    glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 1, nullptr);
    glEndList();
    // What is bound now is not what the list means.
    bind(GL_PIXEL_UNPACK_BUFFER, 1);
    glCallList(1);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
    EXPECT_THAT(picture(1, 1), ElementsAre(255, 0, 0, 255));
    GLfloat value = 0;
    glGetPixelMapfv(GL_PIXEL_MAP_R_TO_R, &value);
    EXPECT_EQ(value, 0.75f);

    glNewList(2, GL_COMPILE);
    for (const Access& access : kReads) {
        if (access.text == std::string("Bitmap")) continue;  // one byte is enough for it
        access.call();
        EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION}) << access.text;
    }
    glEndList();
    glCallList(2);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR}) << "what failed is not in the list";
}

TEST_F(PixelBuffers, OffsetsFitTheType) {
    bind(GL_PIXEL_UNPACK_BUFFER, 64);
    glDrawPixels(1, 1, GL_RGBA, GL_FLOAT, at(2));
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_SHORT, at(2));
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
}

}  // namespace
}  // namespace terrazzo::gl
