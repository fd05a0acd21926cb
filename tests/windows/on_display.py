#!/usr/bin/env python3
"""Runs a test on an X server of its own, with Terrazzo as libglvnd's vendor or as libGL and libEGL themselves.

usage: on_display.py [--without EXTENSION]... [--size WxH] (--vendor FOLDER | --plain FOLDER) COMMAND...
Exits with 77, which meson takes for "skipped", when there is no Xvfb.
"""

import argparse
import contextlib
import os
import pathlib
import shutil
import subprocess
import sys


def skip(reason):
    print("skipped:", reason)
    sys.exit(77)


@contextlib.contextmanager
def xvfb(without=(), size="1280x1024", depth=24):
    """The name of a display of our own; `without` names extensions that its server does not offer."""
    if not shutil.which("Xvfb"):
        skip("Xvfb is not installed")
    reader, writer = os.pipe()
    arguments = ["-displayfd", str(writer), "-screen", "0", f"{size}x{depth}", "-nolisten", "tcp", "-noreset"]
    for extension in without:
        arguments += ["-extension", extension]
    server = subprocess.Popen(["Xvfb", *arguments], pass_fds=[writer], stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL)
    os.close(writer)
    try:
        with open(reader) as answer:
            number = answer.readline().strip()
        if not number:
            skip("Xvfb does not start here")
        yield ":" + number
    finally:
        server.terminate()
        server.wait()


def environment(display, vendor=None, plain=None):
    """What makes a program load our libraries; with neither folder, the system's. With both, as `terrazzo run` does it."""
    out = {name: value for name, value in os.environ.items()
           if name not in ("LD_LIBRARY_PATH", "LIBGL_ALWAYS_INDIRECT") and not name.startswith(("__GLX", "__EGL"))}
    if display:
        out["DISPLAY"] = display
    if vendor:
        out["__GLX_VENDOR_LIBRARY_NAME"] = "terrazzo"
        out["__EGL_VENDOR_LIBRARY_FILENAMES"] = str(pathlib.Path(vendor) / "terrazzo.json")
    if vendor or plain:
        out["LD_LIBRARY_PATH"] = ":".join(str(folder) for folder in (plain, vendor) if folder)
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--without", action="append", default=[])
    parser.add_argument("--size", default="1280x1024")
    parser.add_argument("--depth", type=int, default=24)
    parser.add_argument("--vendor")
    parser.add_argument("--plain")
    parser.add_argument("command", nargs=argparse.REMAINDER)
    options = parser.parse_args()
    with xvfb(options.without, options.size, options.depth) as display:
        sys.exit(subprocess.run(options.command, env=environment(display, options.vendor, options.plain)).returncode)


if __name__ == "__main__":
    main()
