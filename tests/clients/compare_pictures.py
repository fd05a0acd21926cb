#!/usr/bin/env python3
"""Runs an unmodified client with Terrazzo's library and with the system's and compares the pictures it writes.

usage: compare_pictures.py [--display] OUR_LIBRARY THEIR_LIBRARY COMMAND...
The command gets a file name as its last argument, writes a binary PPM there and prints "renderer: NAME". It finds the
library by its own means: ours is put before the system's with LD_LIBRARY_PATH. --display: it runs in an Xvfb of its own.
Exits with 77, which meson takes for "skipped", when something of the system's is missing.
"""

import contextlib
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

STEP = 1  # of 255


def skip(reason):
    print("skipped:", reason)
    sys.exit(77)


@contextlib.contextmanager
def xvfb():
    """The name of a display of our own."""
    if not shutil.which("Xvfb"):
        skip("Xvfb is not installed")
    reader, writer = os.pipe()
    arguments = ["-displayfd", str(writer), "-screen", "0", "640x480x24", "-nolisten", "tcp"]
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


def draw(command, library_path, display):
    """The renderer's name, the picture's header and the pixels' bytes."""
    environment = {name: value for name, value in os.environ.items() if name != "LD_LIBRARY_PATH"}
    if display:
        environment["DISPLAY"] = display
    if library_path:
        environment["LD_LIBRARY_PATH"] = str(library_path)
    with tempfile.TemporaryDirectory() as folder:
        picture = pathlib.Path(folder) / "picture.ppm"
        run = subprocess.run([*command, picture], env=environment, capture_output=True, text=True, timeout=100)
        if run.returncode == 77:
            skip((run.stdout + run.stderr).strip())
        if run.returncode != 0:
            sys.exit(f"{command[-1]}: exit status {run.returncode}\n{run.stdout}{run.stderr}")
        renderer = [line for line in run.stdout.splitlines() if line.startswith("renderer: ")][0]
        header, pixels = picture.read_bytes().split(b"\n255\n", 1)
    return renderer, header, pixels


def main():
    arguments = sys.argv[1:]
    display = arguments[0] == "--display"
    ours, theirs, *command = arguments[display:]
    command = [pathlib.Path(word).resolve() if pathlib.Path(word).exists() else word for word in command]
    if not pathlib.Path(theirs).exists():
        skip(f"{theirs} is not installed")
    with xvfb() if display else contextlib.nullcontext() as name:
        our_renderer, our_header, our_pixels = draw(command, pathlib.Path(ours).resolve().parent, name)
        their_renderer, their_header, their_pixels = draw(command, None, name)
    print(our_renderer, their_renderer, sep="\n")
    if "Terrazzo" not in our_renderer or "Terrazzo" in their_renderer:
        sys.exit("the libraries were not the two to be compared")
    if our_header != their_header or len(our_pixels) != len(their_pixels):
        sys.exit("the pictures differ in size")
    colours = len({their_pixels[i:i + 3] for i in range(0, len(their_pixels), 3)})
    if colours < 100:
        sys.exit(f"{colours} colours are no picture")
    differences = [abs(a - b) for a, b in zip(our_pixels, their_pixels)]
    print(f"{colours} colours, {sum(d > 0 for d in differences)} of {len(differences)} values differ, "
          f"by {max(differences)} at most")
    sys.exit(max(differences) > STEP)


if __name__ == "__main__":
    main()
