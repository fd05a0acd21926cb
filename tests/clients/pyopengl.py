#!/usr/bin/env python3
"""A PyOpenGL program. usage: pyopengl.py osmesa|glx|egl PICTURE

It draws through OSMesa, or through GLX or EGL in a window of GLFW's. Exits with 77 without PyOpenGL, GLFW or a display.
"""

import contextlib
import ctypes
import os
import sys

PLATFORM = sys.argv[1]
os.environ["PYOPENGL_PLATFORM"] = PLATFORM
try:
    from OpenGL import GL, arrays
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


@contextlib.contextmanager
def osmesa_context():
    from OpenGL import osmesa
    context = osmesa.OSMesaCreateContextExt(osmesa.OSMESA_RGBA, 24, 8, 0, None)
    buffer = arrays.GLubyteArray.zeros((HEIGHT, WIDTH, 4))
    assert osmesa.OSMesaMakeCurrent(context, buffer, GL.GL_UNSIGNED_BYTE, WIDTH, HEIGHT)
    yield
    osmesa.OSMesaDestroyContext(context)


@contextlib.contextmanager
def window_context():
    resizable, context_creation_api, native_context_api, egl_context_api = 0x00020003, 0x0002200B, 0x00036001, 0x00036002
    try:
        glfw = ctypes.CDLL("libglfw.so.3")
    except OSError as error:
        print(f"no GLFW: {error}")
        sys.exit(77)
    if not glfw.glfwInit():
        print("no display")
        sys.exit(77)
    glfw.glfwCreateWindow.restype = ctypes.c_void_p
    glfw.glfwWindowHint(resizable, 0)
    glfw.glfwWindowHint(context_creation_api, egl_context_api if PLATFORM == "egl" else native_context_api)
    window = ctypes.c_void_p(glfw.glfwCreateWindow(WIDTH, HEIGHT, b"Terrazzo", None, None))
    assert window
    glfw.glfwMakeContextCurrent(window)
    yield
    glfw.glfwSwapBuffers(window)
    glfw.glfwTerminate()


def draw(path):
    GL.glClearColor(0.1, 0.2, 0.3, 1)
    GL.glEnable(GL.GL_DEPTH_TEST)
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    draw_arrays()
    draw_texture()
    check_queries()
    pixels = GL.glReadPixels(0, 0, WIDTH, HEIGHT, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)
    print("renderer:", GL.glGetString(GL.GL_RENDERER).decode())
    with open(path, "wb") as file:
        file.write(b"P6\n%d %d\n255\n" % (WIDTH, HEIGHT) + bytes(pixels))


with osmesa_context() if PLATFORM == "osmesa" else window_context():
    draw(sys.argv[2])
