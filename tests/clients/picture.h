/* The picture that the clients offscreen and window draw, and how they hand it over. GL(Name) is the
 * includer's way to the command glName; all are of GL 1.1. */
#ifndef TERRAZZO_TESTS_CLIENTS_PICTURE_H
#define TERRAZZO_TESTS_CLIENTS_PICTURE_H

#include <stdio.h>
#include <stdlib.h>

enum { kPictureWidth = 320, kPictureHeight = 240 };

static GLuint make_checkerboard(void) {
    unsigned char texels[16][16][3];
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) {
            const unsigned char light = (x / 2 + y / 2) % 2 ? 255 : 90;
            texels[y][x][0] = light;
            texels[y][x][1] = (unsigned char)(x * 16);
            texels[y][x][2] = (unsigned char)(y * 16);
        }
    }
    GLuint name = 0;
    GL(GenTextures)(1, &name);
    GL(BindTexture)(GL_TEXTURE_2D, name);
    GL(TexParameteri)(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    GL(TexParameteri)(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    GL(PixelStorei)(GL_UNPACK_ALIGNMENT, 1);
    GL(TexImage2D)(GL_TEXTURE_2D, 0, GL_RGB, 16, 16, 0, GL_RGB, GL_UNSIGNED_BYTE, texels);
    return name;
}

static GLuint make_cube(void) {
    static const GLfloat normals[6][3] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                          {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    static const GLfloat corners[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const GLuint list = GL(GenLists)(1);
    GL(NewList)(list, GL_COMPILE);
    GL(Begin)(GL_QUADS);
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
        GL(Normal3fv)(normals[face]);
        for (int i = 0; i < 4; ++i) {
            const int corner = face % 2 ? 3 - i : i; /* counter-clockwise from outside */
            GLfloat position[3];
            position[axis] = normals[face][axis];
            position[u] = corners[corner][0];
            position[v] = corners[corner][1];
            GL(TexCoord2f)(corners[corner][0] * 0.5f + 0.5f, corners[corner][1] * 0.5f + 0.5f);
            GL(Vertex3fv)(position);
        }
    }
    GL(End)();
    GL(EndList)();
    return list;
}

/* Two lit cubes that cut each other, one with a texture, in fog; lines; a blended rectangle over all. */
static void draw_picture(void) {
    static const GLfloat light[] = {2, 3, 4, 1}, fog[] = {0.2f, 0.3f, 0.4f, 1}, red[] = {0.9f, 0.3f, 0.2f, 1};
    static const GLfloat white[] = {1, 1, 1, 1};
    const GLuint texture = make_checkerboard(), cube = make_cube();
    GL(Viewport)(0, 0, kPictureWidth, kPictureHeight);
    GL(ClearColor)(fog[0], fog[1], fog[2], 1);
    GL(Clear)(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    GL(MatrixMode)(GL_PROJECTION);
    GL(LoadIdentity)();
    GL(Frustum)(-0.8, 0.8, -0.6, 0.6, 1.5, 20);
    GL(MatrixMode)(GL_MODELVIEW);
    GL(LoadIdentity)();
    GL(Lightfv)(GL_LIGHT0, GL_POSITION, light);
    GL(Translatef)(0, 0, -6);
    GL(Rotatef)(35, 1, 0.7f, 0.1f);

    GL(Enable)(GL_DEPTH_TEST);
    GL(Enable)(GL_CULL_FACE);
    GL(Enable)(GL_LIGHTING);
    GL(Enable)(GL_LIGHT0);
    GL(Enable)(GL_FOG);
    GL(Fogi)(GL_FOG_MODE, GL_LINEAR);
    GL(Fogf)(GL_FOG_START, 4);
    GL(Fogf)(GL_FOG_END, 12);
    GL(Fogfv)(GL_FOG_COLOR, fog);
    GL(Materialfv)(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, white);
    GL(Enable)(GL_TEXTURE_2D);
    GL(CallList)(cube);
    GL(Disable)(GL_TEXTURE_2D);
    GL(Materialfv)(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, red);
    GL(PushMatrix)();
    GL(Translatef)(1, 0.8f, 0.5f);
    GL(Rotatef)(50, 0, 1, 1);
    GL(CallList)(cube);
    GL(PopMatrix)();

    GL(Disable)(GL_LIGHTING);
    GL(Color3f)(1, 1, 0);
    GL(LineWidth)(3);
    GL(Begin)(GL_LINE_LOOP);
    for (int i = 0; i < 4; ++i) GL(Vertex3f)(i == 1 || i == 2 ? 2 : -2, i > 1 ? 2 : -2, 0);
    GL(End)();

    GL(Disable)(GL_FOG);
    GL(Disable)(GL_DEPTH_TEST);
    GL(Enable)(GL_BLEND);
    GL(BlendFunc)(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    GL(LoadIdentity)();
    GL(Translatef)(0, 0, -2);
    GL(Color4f)(0.1f, 0.9f, 0.3f, 0.5f);
    GL(Rectf)(-1, -0.75f, -0.2f, -0.25f);
    GL(DeleteTextures)(1, &texture);
    GL(DeleteLists)(cube, 1);
}

/* Prints who drew and writes the picture, bottom row first, as a PPM file. Returns the program's exit status.
 */
static int hand_over(const char* path, const unsigned char* rgba) {
    const GLenum error = GL(GetError)();
    printf("renderer: %s\n", (const char*)GL(GetString)(GL_RENDERER));
    FILE* file = error == GL_NO_ERROR ? fopen(path, "wb") : NULL;
    if (!file) {
        fprintf(stderr, "error %x, or %s cannot be written\n", error, path);
        return EXIT_FAILURE;
    }
    fprintf(file, "P6\n%d %d\n255\n", kPictureWidth, kPictureHeight);
    for (int i = 0; i < kPictureWidth * kPictureHeight; ++i) fwrite(rgba + 4 * i, 1, 3, file);
    return fclose(file) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

#endif
