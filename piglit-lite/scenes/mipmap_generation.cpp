// Chapter: automatic mipmap generation (GL 1.5 §3.8.8): formats, sizes, parts of the base level, copies,
// volumes.
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

void filters(const Gl& gl, GLenum target) {
    gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl.TexParameteri(target, GL_GENERATE_MIPMAP, GL_TRUE);
}

// A quad that shows several levels, far side up.
void floor_quad(const Gl& gl, float tiles) {
    camera(gl, 60, 1);
    gl.Begin(GL_QUADS);
    gl.TexCoord3f(0, 0, 0.2F), gl.Vertex3f(-2, -0.8F, -0.5F);
    gl.TexCoord3f(tiles, 0, 0.8F), gl.Vertex3f(2, -0.8F, -0.5F);
    gl.TexCoord3f(tiles, 2 * tiles, 0.8F), gl.Vertex3f(2, 0.8F, -8);
    gl.TexCoord3f(0, 2 * tiles, 0.2F), gl.Vertex3f(-2, 0.8F, -8);
    gl.End();
}

}  // namespace

SCENE(generated_formats, "mipmaps of every base format and of few and many bits") {
    constexpr GLint kFormats[] = {
        GL_RGBA8, GL_RGB8, GL_LUMINANCE8, GL_ALPHA8, GL_INTENSITY8, GL_LUMINANCE8_ALPHA8,
        GL_RGBA4, GL_RGB5, GL_R3_G3_B2,   GL_RGB10,  GL_RGBA16,     GL_LUMINANCE16};
    gl.Enable(GL_TEXTURE_2D);
    for_viewports(gl, 4, 3, [&](int cell) {
        filters(gl, GL_TEXTURE_2D);
        gl.TexImage2D(GL_TEXTURE_2D, 0, kFormats[cell], 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                      painted_texels(32, 32).data());
        floor_quad(gl, 3);
    });
}

SCENE(generated_sizes, "mipmaps of sizes that are odd, no squares, one texel high") {
    constexpr int kSizes[][2] = {{64, 64}, {33, 17}, {7, 40}, {1, 64}, {100, 1}, {63, 31}};
    gl.Enable(GL_TEXTURE_2D);
    for_viewports(gl, 3, 2, [&](int cell) {
        filters(gl, GL_TEXTURE_2D);
        const auto [width, height] = kSizes[cell];
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                      painted_texels(width, height).data());
        floor_quad(gl, 3);
    });
}

SCENE(generated_after_changes, "mipmaps follow parts of the base level and copies, and no other level") {
    gl.ClearColor(0.9F, 0.3F, 0.1F, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Enable(GL_TEXTURE_2D);
    for_viewports(gl, 2, 2, [&](int cell) {
        filters(gl, GL_TEXTURE_2D);
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                      painted_texels(32, 32).data());
        const std::vector<std::uint8_t> white(32 * 32 * 4, 255);
        if (cell == 1)
            gl.TexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 20, 11, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
        if (cell == 2) gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 2, 8, 100, 130, 20, 20);
        if (cell == 3)
            gl.TexSubImage2D(GL_TEXTURE_2D, 1, 0, 0, 16, 16, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
        floor_quad(gl, 2);
    });
}

SCENE(generated_base_and_max, "mipmaps from a base level other than 0 up to the maximal level") {
    gl.Enable(GL_TEXTURE_2D);
    filters(gl, GL_TEXTURE_2D);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 2);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 4);
    gl.TexImage2D(GL_TEXTURE_2D, 2, GL_RGBA8, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  painted_texels(32, 32).data());
    floor_quad(gl, 3);
    for (int level = 0; level < 6; ++level) {
        GLint width = 0;
        gl.GetTexLevelParameteriv(GL_TEXTURE_2D, level, GL_TEXTURE_WIDTH, &width);
        notes.value("width of level " + std::to_string(level), width);
    }
}

SCENE(generated_volume_and_line, "mipmaps of a 3D texture and of a 1D texture") {
    for_viewports(gl, 1, 2, [&](int cell) {
        const GLenum target = cell ? GL_TEXTURE_3D : GL_TEXTURE_1D;
        gl.Disable(GL_TEXTURE_1D);
        gl.Enable(target);
        filters(gl, target);
        const auto texels = painted_texels(32, 32 * 8);
        if (cell)
            gl.TexImage3D(target, 0, GL_RGBA8, 32, 32, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
        else
            gl.TexImage1D(target, 0, GL_RGBA8, 50, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
        floor_quad(gl, 4);
    });
}
