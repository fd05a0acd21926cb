#!/usr/bin/env python3
"""A PyOpenGL program that draws through OSMesa. usage: offscreen.py PICTURE. Exits with 77 without PyOpenGL."""

import os
import sys

os.environ["PYOPENGL_PLATFORM"] = "osmesa"
try:
    from OpenGL import GL, arrays, osmesa
except ImportError as error:
    print(f"no PyOpenGL: {error}")
    sys.exit(77)

WIDTH, HEIGHT = 200, 150
CORNERS = ((-0.9, -0.9), (0.9, -0.8), (0.7, 0.9), (-0.8, 0.6))
COLOURS = ((1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0))


def draw_arrays():
    """A smooth polygon from arrays of Python's, whose conversion is PyOpenGL's."""
    vertices = arrays.GLfloatArray.asArray([component for corner in CORNERS for component in corner])
    colours = arrays.GLfloatArray.asArray([component for colour in COLOURS for component in colour])
    GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
    GL.glEnableClientState(GL.GL_COLOR_ARRAY)
    GL.glVertexPointer(2, GL.GL_FLOAT, 0, vertices)
    GL.glColorPointer(3, GL.GL_FLOAT, 0, colours)
    GL.glDrawArrays(GL.GL_QUADS, 0, 4)
    GL.glDisableClientState(GL.GL_COLOR_ARRAY)
    GL.glDisableClientState(GL.GL_VERTEX_ARRAY)


def draw_texture():
    texels = bytes((x * 32 ^ y * 32) & 255 for y in range(8) for x in range(8))
    texture = GL.glGenTextures(1)
    GL.glBindTexture(GL.GL_TEXTURE_2D, texture)
    GL.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MIN_FILTER, GL.GL_NEAREST)
    GL.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MAG_FILTER, GL.GL_NEAREST)
    GL.glTexImage2D(GL.GL_TEXTURE_2D, 0, GL.GL_LUMINANCE, 8, 8, 0, GL.GL_LUMINANCE, GL.GL_UNSIGNED_BYTE, texels)
    GL.glEnable(GL.GL_TEXTURE_2D)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glPushMatrix()
    GL.glRotated(20, 0, 0, 1)
    GL.glBegin(GL.GL_TRIANGLE_STRIP)
    for s, t in ((0, 0), (1, 0), (0, 1), (1, 1)):
        GL.glColor3f(1, 1 - s / 2, 1 - t / 2)
        GL.glTexCoord2f(s, t)
        GL.glVertex3f(s - 0.6, t - 0.5, -0.5)
    GL.glEnd()
    GL.glPopMatrix()
    GL.glDisable(GL.GL_TEXTURE_2D)
    GL.glDeleteTextures([texture])


def check_queries():
    """Answers go through PyOpenGL's tables of sizes; errors are raised by its checker."""
    assert list(GL.glGetIntegerv(GL.GL_VIEWPORT)) == [0, 0, WIDTH, HEIGHT]
    assert GL.glGetFloatv(GL.GL_MODELVIEW_MATRIX)[3][3] == 1
    try:
        GL.glBlendFunc(0xDEAD, GL.GL_ONE)
    except GL.GLError as error:
        assert error.err == GL.GL_INVALID_ENUM
    else:
        raise AssertionError("an unknown enumerant was accepted")


def main():
    context = osmesa.OSMesaCreateContextExt(osmesa.OSMESA_RGBA, 24, 8, 0, None)
    buffer = arrays.GLubyteArray.zeros((HEIGHT, WIDTH, 4))
    assert osmesa.OSMesaMakeCurrent(context, buffer, GL.GL_UNSIGNED_BYTE, WIDTH, HEIGHT)
    GL.glClearColor(0.1, 0.2, 0.3, 1)
    GL.glEnable(GL.GL_DEPTH_TEST)
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    draw_arrays()
    draw_texture()
    check_queries()
    pixels = GL.glReadPixels(0, 0, WIDTH, HEIGHT, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)
    print("renderer:", GL.glGetString(GL.GL_RENDERER).decode())
    with open(sys.argv[1], "wb") as file:
        file.write(b"P6\n%d %d\n255\n" % (WIDTH, HEIGHT) + bytes(pixels))
    osmesa.OSMesaDestroyContext(context)


main()
