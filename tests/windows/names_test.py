#!/usr/bin/env python3
"""Whoever loads OpenGL by a name gets Terrazzo, whatever the name, and whatever else is loaded before or after.

usage: names_test.py PLAIN_FOLDER OSMESA_FOLDER
Each name is opened alone and with each other, in both orders, in a process of its own; the functions of all of them must
be of one file. The names are those that GLFW, SDL, GLEW, libepoxy, glad, LWJGL, PyOpenGL and pyglet try, that waffle and
programs are linked with, and that Debian's packages have.
"""

import ctypes
import itertools
import os
import pathlib
import subprocess
import sys

WINDOWS = {
    "libGL.so.1": ("glClear", "glXSwapBuffers", "glXGetProcAddressARB"),
    "libGL.so": ("glClear", "glXSwapBuffers", "glXGetProcAddressARB"),
    "libGLX.so.0": ("glXSwapBuffers", "glXGetProcAddressARB"),
    "libGLX.so": ("glXSwapBuffers", "glXGetProcAddressARB"),
    "libOpenGL.so.0": ("glClear",),
    "libOpenGL.so": ("glClear",),
    "libEGL.so.1": ("eglSwapBuffers", "eglGetProcAddress"),
    "libEGL.so": ("eglSwapBuffers", "eglGetProcAddress"),
}
OSMESA = {name: ("glClear", "OSMesaMakeCurrent") for name in ("libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so")}


class DlInfo(ctypes.Structure):
    _fields_ = [("file", ctypes.c_char_p), ("base", ctypes.c_void_p), ("name", ctypes.c_char_p),
                ("address", ctypes.c_void_p)]


def file_of(function):
    """The library that a function lies in, whatever name it was loaded by."""
    info = DlInfo()
    address = ctypes.cast(function, ctypes.c_void_p)
    if not ctypes.CDLL(None).dladdr(address, ctypes.byref(info)):
        return None
    return os.path.realpath(info.file.decode())


def gl_libraries():
    """All files of this process that are a GL of some kind."""
    with open("/proc/self/maps") as maps:
        files = {line.split(maxsplit=5)[5].strip() for line in maps if line.count("/")}
    kinds = ("libGL.so", "libGLX", "libGLdispatch", "libOpenGL", "libEGL", "libOSMesa", "libterrazzo", "libglapi")
    return {os.path.realpath(file) for file in files if pathlib.Path(file).name.startswith(kinds)}


def answers(names, mode):
    """In a new process: the files that the functions of these names come from, and what was loaded altogether."""
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            found = []
            for name in names:
                library = ctypes.CDLL(name, mode=mode)
                found += [file_of(getattr(library, function)) for function in KNOWN[name]]
                # PyOpenGL and others look for functions with what they were given for another name.
                renderer = getattr(library, "glXGetProcAddressARB", None) or getattr(library, "eglGetProcAddress", None)
                if renderer:
                    renderer.restype = ctypes.c_void_p
                    found.append(file_of(renderer(b"glBlendFunc")))
            text = "\n".join(sorted(set(map(str, found)) | gl_libraries()))
        except Exception as error:
            text = f"{type(error).__name__}: {error}"
        os.write(writer, text.encode())
        os._exit(0)
    os.close(writer)
    with open(reader) as file:
        text = file.read()
    os.waitpid(child, 0)
    return text.splitlines()


KNOWN = {**WINDOWS, **OSMESA}


def check(names, library):
    wrong = []
    for count in (1, 2):
        for chosen in itertools.permutations(names, count):
            for mode in (ctypes.RTLD_LOCAL, ctypes.RTLD_GLOBAL):
                found = answers(chosen, mode)
                if found != [library]:
                    wrong.append(f"{' and '.join(chosen)}: {found}")
    return wrong


def main():
    plain, osmesa = (pathlib.Path(folder).resolve() for folder in sys.argv[1:3])
    if os.environ.get("LD_LIBRARY_PATH") != f"{plain}:{osmesa}":
        # The loader reads it when a process starts.
        environment = {**os.environ, "LD_LIBRARY_PATH": f"{plain}:{osmesa}"}
        sys.exit(subprocess.run([sys.executable, *sys.argv], env=environment).returncode)
    windows_library, osmesa_library = (os.path.realpath(path) for path in (plain / "libGL.so.1", osmesa / "libOSMesa.so.8"))
    if pathlib.Path(windows_library).parent.parent != plain.parent.parent or windows_library == osmesa_library:
        sys.exit(f"{plain} leads to {windows_library}")
    wrong = check(WINDOWS, windows_library) + check(OSMESA, osmesa_library)
    if wrong:
        sys.exit("\n".join(wrong))


if __name__ == "__main__":
    main()
