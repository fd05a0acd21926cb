// Chapter: compressed textures (GL 1.5 §3.8.3, EXT_texture_compression_s3tc): blocks of all formats, parts,
// mipmaps, cube maps, and blocks given back.
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

constexpr GLenum kFormats[] = {GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GL_COMPRESSED_RGBA_S3TC_DXT1_EXT,
                               GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT};

int block_bytes(GLenum format) {
    return format == GL_COMPRESSED_RGB_S3TC_DXT1_EXT || format == GL_COMPRESSED_RGBA_S3TC_DXT1_EXT ? 8 : 16;
}

GLsizei image_bytes(GLenum format, int width, int height) {
    return (width + 3) / 4 * ((height + 3) / 4) * block_bytes(format);
}

// Blocks of anything.
std::vector<std::uint8_t> random_blocks(GLenum format, int width, int height, std::uint32_t seed) {
    Random random(seed);
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(image_bytes(format, width, height)));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.bits() >> 9);
    return bytes;
}

void upload(const Gl& gl, GLenum target, int level, GLenum format, int width, int height,
            std::uint32_t seed) {
    gl.CompressedTexImage2D(target, level, format, width, height, 0, image_bytes(format, width, height),
                            random_blocks(format, width, height, seed).data());
}

void filters(const Gl& gl, GLint filter) {
    gl.Enable(GL_TEXTURE_2D);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter == GL_NEAREST ? GL_NEAREST : GL_LINEAR);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
}

}  // namespace

SCENE(s3tc_formats, "random blocks of each format, nearest and linear, blended over stripes") {
    pixel_projection(gl);
    striped_backdrop(gl, 10);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for_cells(4, 2, [&](int cell, float x, float y, float w, float h) {
        filters(gl, cell / 4 ? GL_LINEAR : GL_NEAREST);
        upload(gl, GL_TEXTURE_2D, 0, kFormats[cell % 4], 32, 64, static_cast<std::uint32_t>(cell % 4) + 1);
        textured_rectangle(gl, x + 2, y + 2, x + w - 2, y + h - 2);
        gl.Disable(GL_TEXTURE_2D);
    });
}

SCENE(s3tc_sizes, "images that end within a block, and a part replaced") {
    pixel_projection(gl);
    filters(gl, GL_NEAREST);
    constexpr int kSizes[][2] = {{7, 5}, {2, 2}, {1, 9}, {13, 12}};
    for_cells(4, 2, [&](int cell, float x, float y, float w, float h) {
        const GLenum format = kFormats[(cell + 2) % 4];
        const auto [width, height] = kSizes[cell % 4];
        upload(gl, GL_TEXTURE_2D, 0, format, width, height, static_cast<std::uint32_t>(cell));
        if (cell > 3 && width > 4)
            gl.CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, width - 4, height - 4, format,
                                       image_bytes(format, width - 4, height - 4),
                                       random_blocks(format, width - 4, height - 4, 99).data());
        textured_rectangle(gl, x + 2, y + 2, x + w - 2, y + h - 2);
    });
}

SCENE(s3tc_mipmaps, "compressed levels on a floor, and the same in a display list") {
    for_viewports(gl, 2, 2, [&](int cell) {
        camera(gl, 60, 1);
        filters(gl, GL_LINEAR_MIPMAP_LINEAR);
        if (cell == 3) gl.NewList(1, GL_COMPILE);
        for (int level = 0; level < 6; ++level)
            upload(gl, GL_TEXTURE_2D, level, kFormats[cell], 32 >> level, 32 >> level,
                   static_cast<std::uint32_t>(level + cell));
        if (cell == 3) gl.EndList(), gl.CallList(1);
        receding_rectangle(gl, {2, -0.8F, -0.5F, 0.8F, -8}, 4, 8);
    });
}

SCENE(s3tc_queries, "what can be asked about compressed images, and errors", .draws_nothing_visible = true) {
    const auto query = [&](const char* name, GLenum pname) {
        GLint value = 0;
        gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, pname, &value);
        notes.value(name, value);
    };
    for (GLenum format : kFormats) {
        upload(gl, GL_TEXTURE_2D, 0, format, 12, 8, 5);
        query("format", GL_TEXTURE_INTERNAL_FORMAT);
        query("compressed", GL_TEXTURE_COMPRESSED);
        query("size", GL_TEXTURE_COMPRESSED_IMAGE_SIZE);
        query("red", GL_TEXTURE_RED_SIZE);
        query("alpha", GL_TEXTURE_ALPHA_SIZE);
        std::vector<std::uint8_t> back(static_cast<std::size_t>(image_bytes(format, 12, 8)));
        gl.GetCompressedTexImage(GL_TEXTURE_2D, 0, back.data());
        notes.value("same", back == random_blocks(format, 12, 8, 5));
    }
    const auto error = [&](const char* name) { notes.value(name, gl.GetError()); };
    const std::vector<std::uint8_t> bytes(256);
    const auto image = [&](GLenum format, GLint border, GLsizei size) {
        gl.CompressedTexImage2D(GL_TEXTURE_2D, 0, format, 8, 8, border, size, bytes.data());
    };
    const auto part = [&](GLint x, GLsizei width, GLenum format, GLsizei size) {
        gl.CompressedTexSubImage2D(GL_TEXTURE_2D, 0, x, 0, width, 4, format, size, bytes.data());
    };
    image(kFormats[0], 0, 31), error("a byte too few");
    image(kFormats[0], 1, 32), error("border");
    image(GL_COMPRESSED_RGB, 0, 32), error("generic format");
    image(GL_RGB8, 0, 192), error("no compressed format");
    image(kFormats[0], 0, -1), error("negative size");
    image(kFormats[0], 0, 32), error("good");
    part(2, 4, kFormats[0], 8), error("part within blocks");
    part(4, 2, kFormats[0], 8), error("part that ends within a block");
    part(4, 4, kFormats[1], 8), error("part of another format");
    part(4, 4, kFormats[0], 9), error("part of another size");
    gl.CompressedTexImage1D(GL_TEXTURE_1D, 0, kFormats[0], 8, 0, 16, bytes.data()), error("one dimension");
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    std::vector<std::uint8_t> unused(4096);
    gl.GetCompressedTexImage(GL_TEXTURE_2D, 0, unused.data()), error("blocks of an image without");
    query("size of an image without", GL_TEXTURE_COMPRESSED_IMAGE_SIZE), error("that query");
    gl.CompressedTexImage2D(GL_PROXY_TEXTURE_2D, 0, kFormats[3], 16, 16, 0, 256, nullptr), error("proxy");
    GLint width = 0;
    gl.GetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    notes.value("proxy's width", width);
}
