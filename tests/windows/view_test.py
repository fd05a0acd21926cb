#!/usr/bin/env python3
"""Runs `terrazzo view` on an X server of its own, with nothing set that would make it find Terrazzo.

usage: view_test.py TERRAZZO
Pictures through GLX and EGL must be the same, and within one step of 255 those of the system's OpenGL; so must be what
the mouse and the keys made of them. Exits with 77, which meson takes for "skipped", without Xvfb or the model.
"""

import ctypes
import ctypes.util
import pathlib
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "clients"))
from compare_pictures import compare, draw
from on_display import environment, skip, xvfb

MODEL = pathlib.Path("/usr/share/assimp/models/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb")
TEXTURED = pathlib.Path("/usr/share/assimp/models/glTF2/BoxTextured-glTF-Binary/BoxTextured.glb")
SIZE = "320x240"
USED_SIZE = 250, 300
KEY_PRESS, BUTTON_PRESS, BUTTON_RELEASE, MOTION = 2, 4, 5, 6


class InputEvent(ctypes.Structure):
    """What Xlib's XKeyEvent, XButtonEvent and XMotionEvent have in common, as large as an XEvent."""
    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                ("display", ctypes.c_void_p), ("window", ctypes.c_ulong), ("root", ctypes.c_ulong),
                ("subwindow", ctypes.c_ulong), ("time", ctypes.c_ulong), ("x", ctypes.c_int), ("y", ctypes.c_int),
                ("x_root", ctypes.c_int), ("y_root", ctypes.c_int), ("state", ctypes.c_uint),
                ("detail", ctypes.c_uint), ("same_screen", ctypes.c_int), ("padding", ctypes.c_long * 24)]


class User:
    """Sends events to the window of a title."""

    def __init__(self, display_name, title):
        self.x11 = ctypes.CDLL(ctypes.util.find_library("X11"))
        self.x11.XOpenDisplay.restype = ctypes.c_void_p
        self.x11.XDefaultRootWindow.restype = ctypes.c_ulong
        self.display = ctypes.c_void_p(self.x11.XOpenDisplay(display_name.encode()))
        self.time = 0
        self.window = None
        end = time.monotonic() + 30
        while not self.window and time.monotonic() < end:
            self.window = self.find(title.encode())
            time.sleep(0.05)
        if not self.window:
            sys.exit(f"no window is called {title}")

    def find(self, title):
        one, children, count = ctypes.c_ulong(), ctypes.POINTER(ctypes.c_ulong)(), ctypes.c_uint()
        root = ctypes.c_ulong(self.x11.XDefaultRootWindow(self.display))
        self.x11.XQueryTree(self.display, root, ctypes.byref(one), ctypes.byref(one), ctypes.byref(children),
                            ctypes.byref(count))
        for window in children[:count.value]:
            name = ctypes.c_char_p()
            self.x11.XFetchName(self.display, ctypes.c_ulong(window), ctypes.byref(name))
            if name.value and name.value.startswith(title):
                return window
        return None

    def send(self, kind, detail=0, x=0, y=0):
        self.time += 10
        event = InputEvent(type=kind, window=self.window, time=self.time, x=x, y=y, detail=detail, same_screen=1)
        self.x11.XSendEvent(self.display, ctypes.c_ulong(self.window), 1, 0, ctypes.byref(event))
        self.x11.XFlush(self.display)

    def press(self, key):
        self.send(KEY_PRESS, self.x11.XKeysymToKeycode(self.display, ctypes.c_ulong(ord(key))) & 255)

    def drag(self, button, start, end):
        self.send(MOTION, x=start[0], y=start[1])
        self.send(BUTTON_PRESS, button, *start)
        self.send(MOTION, x=end[0], y=end[1])
        self.send(BUTTON_RELEASE, button, *end)

    def resize(self, width, height):
        self.x11.XResizeWindow(self.display, ctypes.c_ulong(self.window), width, height)
        self.x11.XFlush(self.display)

    def turn_wheel(self, button):
        self.send(BUTTON_PRESS, button)
        self.send(BUTTON_RELEASE, button)


def view(terrazzo, model, *options):
    return [terrazzo, "view", model, "--size", SIZE, *options, "--screenshot"]


def used(terrazzo, display, keys, *options):
    """As draw(), of a window that somebody uses: another size, drags, the wheel, some keys, then q."""
    with tempfile.TemporaryDirectory() as folder:
        picture = pathlib.Path(folder) / "picture.ppm"
        program = subprocess.Popen([*view(terrazzo, TEXTURED, *options), picture], env=environment(display), cwd=folder,
                                   stdout=subprocess.PIPE, text=True)
        renderer = program.stdout.readline().strip().removeprefix("renderer: ")
        user = User(display, TEXTURED.stem)
        user.resize(*USED_SIZE)
        user.drag(1, (100, 100), (160, 130))
        user.drag(3, (100, 100), (120, 90))
        user.turn_wheel(4)
        user.turn_wheel(4)
        user.turn_wheel(5)
        for key in keys + "sq":
            user.press(key)
        rest, _ = program.communicate(timeout=60)
        if program.returncode != 0:
            sys.exit(f"exit status {program.returncode}\n{rest}")
        saved = pathlib.Path(folder) / f"{TEXTURED.stem}-1.png"
        if rest.splitlines()[-1:] != [saved.name] or not saved.read_bytes().startswith(b"\x89PNG"):
            sys.exit(f"no screenshot at a key: {rest}")
        header, pixels = picture.read_bytes().split(b"\n255\n", 1)
    return renderer, header, pixels


def main():
    terrazzo = pathlib.Path(sys.argv[1]).resolve()
    for model in (MODEL, TEXTURED):
        if not model.exists():
            skip(f"{model} is not installed")
    with xvfb() as display:
        for model in (MODEL, TEXTURED):
            glx = draw(view(terrazzo, model, "--frames", "3"), environment(display))
            egl = draw(view(terrazzo, model, "--frames", "3", "--egl"), environment(display))
            if glx != egl:
                sys.exit("GLX and EGL show other pictures")
            compare(glx, draw(view(terrazzo, model, "--frames", "3", "--system"), environment(display)))
        seen = [glx[2]]
        for keys in ("", "t", "l", "w"):
            ours = used(terrazzo, display, keys)
            compare(ours, used(terrazzo, display, keys, "--system"), fewest_colours=3)  # the ground and two faces
            if ours[1] != b"P6\n%d %d" % USED_SIZE:
                sys.exit(f"a picture of another size than the window's: {ours[1]}")
            if ours[2] in seen:
                sys.exit(f"the keys {keys or 'and the mouse'} change nothing")
            seen.append(ours[2])


if __name__ == "__main__":
    main()
