#!/usr/bin/env python3
"""A MuJoCo scene that is asked to draw: bodies of every kind on a floor that mirrors them, with shadows, 4 samples a pixel.

usage: scene.py WIDTH HEIGHT SHADOW_SIZE
Answers a line on standard output to each on standard input: "frames N" with N processor times in ms of render() alone,
"picture FILE" with "saved" (NumPy, rows of RGB of the frames after a reset). Its first line is the renderer's name.
What a frame holds is the same in every process: simulation and seeds are.
"""

import os
import sys
import time

os.environ.setdefault("MUJOCO_GL", "osmesa")
os.environ.setdefault("PYOPENGL_PLATFORM", "osmesa")

import mujoco  # noqa: E402
import numpy  # noqa: E402
from OpenGL import GL  # noqa: E402

KINDS = {"sphere": ".14", "box": ".12 .1 .14", "capsule": ".08 .12", "cylinder": ".1 .12", "ellipsoid": ".1 .14 .12"}
SIDE = 6


def body(index: int, random: numpy.random.Generator) -> str:
    kind = list(KINDS)[index % len(KINDS)]
    x, y = (0.55 * (i - (SIDE - 1) / 2) for i in (index % SIDE, index // SIDE))
    z, first, second = 0.3 + 0.25 * random.random(), 90 * random.random(), 90 * random.random()
    colour = " ".join(f"{0.3 + 0.7 * random.random():.2f}" for _ in range(3))
    return (f'<body pos="{x:.3f} {y:.3f} {z:.3f}" euler="{first:.1f} {second:.1f} 0"><freejoint/>'
            f'<geom type="{kind}" size="{KINDS[kind]}" rgba="{colour} 1"/></body>')


def model(shadow_size: int) -> str:
    random = numpy.random.default_rng(7)
    bodies = "".join(body(i, random) for i in range(SIDE * SIDE))
    return f"""<mujoco>
  <visual><global offwidth="1024" offheight="1024"/><quality shadowsize="{shadow_size}" offsamples="4"/></visual>
  <asset>
    <texture name="tiles" type="2d" builtin="checker" rgb1=".2 .3 .4" rgb2=".1 .15 .2" width="512" height="512"/>
    <material name="tiles" texture="tiles" texrepeat="6 6" reflectance=".3"/>
    <texture type="skybox" builtin="gradient" rgb1=".4 .6 .8" rgb2="0 0 0" width="256" height="256"/>
  </asset>
  <worldbody>
    <light pos="1 -1.5 4" dir="-.2 .3 -1" castshadow="true"/>
    <geom type="plane" size="4 4 .1" material="tiles"/>{bodies}
  </worldbody>
</mujoco>"""


class Scene:
    def __init__(self, width: int, height: int, shadow_size: int) -> None:
        self.model = mujoco.MjModel.from_xml_string(model(shadow_size))
        self.data = mujoco.MjData(self.model)
        self.renderer = mujoco.Renderer(self.model, height, width)
        self.camera = mujoco.MjvCamera()
        self.camera.lookat[:] = [0, 0, 0.2]
        self.camera.distance, self.camera.azimuth, self.camera.elevation = 4.2, 120, -25

    def step(self) -> None:
        mujoco.mj_step(self.model, self.data)
        self.renderer.update_scene(self.data, self.camera)

    def frames(self, count: int) -> list[float]:
        times = []
        for _ in range(count):
            self.step()
            begin = time.process_time()
            self.renderer.render()
            times.append(1e3 * (time.process_time() - begin))
        return times

    def picture(self, path: str) -> None:
        mujoco.mj_resetData(self.model, self.data)
        pictures = []
        for _ in range(3):
            self.step()
            pictures.append(self.renderer.render())
        numpy.save(path, numpy.stack(pictures))


def main() -> None:
    scene = Scene(*map(int, sys.argv[1:4]))
    scene.frames(1)
    print(GL.glGetString(GL.GL_RENDERER).decode(), flush=True)
    for line in sys.stdin:
        word, argument = line.split()
        if word == "frames":
            print(*scene.frames(int(argument)), flush=True)
        else:
            scene.picture(argument)
            print("saved", flush=True)
    sys.stdout.flush()
    os._exit(0)  # MuJoCo's own end takes the context down a second time


if __name__ == "__main__":
    main()
