#!/usr/bin/env python3
"""Programs whose X server dies while they draw: they end as Xlib has it, or hear of it, and none runs on at full load.

usage: dead_server_test.py (--vendor FOLDER | --plain FOLDER) PROGRAM
PROGRAM is the one of dead_server.c. Exits with 77, which meson takes for "skipped", without Xvfb.
"""

import argparse
import os
import pathlib
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from on_display import environment, skip

# One that runs on for ever has to be told from a slow machine.
LONG = 300
MORE = 40
BAD_NATIVE_WINDOW = "0x300b"


def start_server():
    """The process, and the name of its display."""
    reader, writer = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(writer), "-screen", "0", "640x480x24", "-nolisten", "tcp"],
                              pass_fds=[writer], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(writer)
    with open(reader) as answer:
        number = answer.readline().strip()
    if not number:
        server.wait()
        skip("Xvfb does not start here")
    return server, ":" + number


def outlive(folders, program, way, handler):
    """Exit status, output and errors of a program whose server is killed once it draws."""
    server, display = start_server()
    try:
        with subprocess.Popen([program, way, handler], env=environment(display, **folders), stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True) as live:
            if live.stdout.readline() != "drawing\n":
                live.kill()
                sys.exit(f"{way}: does not draw: {live.stderr.read()}")
            server.terminate()
            server.wait()
            try:
                output, errors = live.communicate(timeout=LONG)
            except subprocess.TimeoutExpired:
                live.kill()
                sys.exit(f"{way} {handler}: runs on without a server")
            return live.returncode, output.split(), errors
    finally:
        server.terminate()
        server.wait()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--vendor")
    parser.add_argument("--plain")
    parser.add_argument("program")
    options = parser.parse_args()
    folders = {"vendor": options.vendor, "plain": options.plain}
    if not shutil.which("Xvfb"):
        skip("Xvfb is not installed")

    for way in ("glx", "glx-single", "egl", "egl-single"):
        status, output, errors = outlive(folders, options.program, way, "none")
        if status != 1 or output or "X connection" not in errors and "XIO" not in errors:
            sys.exit(f"{way}: Xlib's own handler ends programs with 1, not {status} {output} {errors}")
        status, output, errors = outlive(folders, options.program, way, "jump")
        if status != 0 or output[:2] != ["gone", "on"]:
            sys.exit(f"{way}: its handler was not called: {status} {output} {errors}")
    for way, handler in (("glx", "stay"), ("egl", "stay"), ("glx-single", "stay"), ("egl-xcb", "none")):
        status, output, errors = outlive(folders, options.program, way, handler)
        if status != 0 or output[:2] != ["gone", "on"]:
            sys.exit(f"{way} {handler}: {status} {output} {errors}")
        if way.startswith("egl") and output[2] != BAD_NATIVE_WINDOW:
            sys.exit(f"{way} {handler}: EGL says {output[2]}")
        # Each picture waits for a refresh; the first may have found one that was nearly there.
        if int(output[3]) < MORE - 1:
            sys.exit(f"{way} {handler}: {MORE} pictures in {output[3]} refreshes")


if __name__ == "__main__":
    main()
