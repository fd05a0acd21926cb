#!/usr/bin/env python3
"""A pyglet program: batches of coloured and textured vertices, sprites, shapes. usage: pyglet_window.py PICTURE

Exits with 77 without pyglet.
"""

import sys

try:
    import pyglet
except ImportError as error:
    print(f"no pyglet: {error}")
    sys.exit(77)

# Every error is raised.
pyglet.options["debug_gl"] = True
from pyglet import gl, shapes

WIDTH, HEIGHT = 320, 240


def make_image():
    size = 32
    texels = bytes(component for y in range(size) for x in range(size)
                   for component in (x * 8, y * 8, 255 if (x // 4 + y // 4) % 2 else 40, 255 - x * 4))
    return pyglet.image.ImageData(size, size, "RGBA", texels)


def add_shapes(batch):
    return [shapes.Rectangle(10, 10, 80, 50, color=(200, 60, 30), batch=batch),
            shapes.Circle(150, 60, 40, color=(40, 180, 90), batch=batch),
            shapes.Line(10, 120, 200, 230, width=3, color=(250, 220, 60), batch=batch),
            shapes.Triangle(200, 20, 300, 40, 240, 110, color=(80, 90, 230), batch=batch)]


def add_sprites(batch, image):
    sprites = [pyglet.sprite.Sprite(image, x=30 + 60 * i, y=130, batch=batch) for i in range(4)]
    sprites[1].rotation = 30
    sprites[2].scale = 2
    sprites[3].color, sprites[3].opacity = (255, 120, 120), 160
    return sprites


def draw_smooth():
    pyglet.graphics.draw(4, gl.GL_QUADS,
                         ("v2f", (220, 120, 310, 130, 300, 230, 230, 210)),
                         ("c4B", (255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 0, 100)))
    pyglet.graphics.draw_indexed(4, gl.GL_TRIANGLES, [0, 1, 2, 0, 2, 3],
                                 ("v2i", (100, 90, 130, 90, 130, 120, 100, 120)),
                                 ("c3f", (1, 1, 1, .2, .4, .6, 0, 0, 0, .8, .1, .5)))


def read():
    pixels = (gl.GLubyte * (WIDTH * HEIGHT * 3))()
    gl.glPixelStorei(gl.GL_PACK_ALIGNMENT, 1)
    gl.glReadPixels(0, 0, WIDTH, HEIGHT, gl.GL_RGB, gl.GL_UNSIGNED_BYTE, pixels)
    return bytes(pixels)


def main():
    window = pyglet.window.Window(WIDTH, HEIGHT, "Terrazzo", vsync=False)
    print("renderer:", gl.gl_info.get_renderer())
    print("version:", gl.gl_info.get_version())
    batch, front = pyglet.graphics.Batch(), pyglet.graphics.Batch()
    kept = add_shapes(batch) + add_sprites(front, make_image())
    for _ in range(2):
        window.switch_to()
        window.dispatch_events()
        gl.glClearColor(0.1, 0.15, 0.2, 1)
        window.clear()
        batch.draw()
        front.draw()
        gl.glEnable(gl.GL_BLEND)
        gl.glBlendFunc(gl.GL_SRC_ALPHA, gl.GL_ONE_MINUS_SRC_ALPHA)
        draw_smooth()
        pixels = read()
        window.flip()
    del kept
    with open(sys.argv[1], "wb") as file:
        file.write(b"P6\n%d %d\n255\n" % (WIDTH, HEIGHT) + pixels)
    window.close()


main()
