#!/usr/bin/env python3
"""Runs an unmodified client with Terrazzo's library and with the system's and compares the pictures it writes.

usage: compare_pictures.py [--display] [--osmesa OURS THEIRS | [--plain FOLDER] [--vendor FOLDER]] COMMAND...
The command gets a file name as its last argument, writes a binary PPM there and prints "renderer: NAME". It finds the
library by its own means: ours is put before the system's by the environment alone. --display, and every library but
OSMesa: it runs in an Xvfb of its own. Exits with 77, which meson takes for "skipped", when something of the system's is
missing.
"""

import argparse
import contextlib
import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "windows"))
from on_display import environment, skip, xvfb

STEP = 1  # of 255: two roundings of the same value


def draw(command, variables):
    """The renderer's name, the picture's header and the pixels' bytes."""
    with tempfile.TemporaryDirectory() as folder:
        picture = pathlib.Path(folder) / "picture.ppm"
        run = subprocess.run([*command, picture], env=variables, capture_output=True, text=True, timeout=100)
        if run.returncode == 77:
            skip((run.stdout + run.stderr).strip())
        if run.returncode != 0:
            sys.exit(f"{command[-1]}: exit status {run.returncode}\n{run.stdout}{run.stderr}")
        renderer = [line for line in run.stdout.splitlines() if line.startswith("renderer: ")][0]
        header, pixels = picture.read_bytes().split(b"\n255\n", 1)
    return renderer.removeprefix("renderer: "), header, pixels


def compare(ours, theirs, fewest_colours=100):
    """Prints how two answers of draw() differ; ends the program when it is by more than they may, or no picture."""
    (our_renderer, our_header, our_pixels), (their_renderer, their_header, their_pixels) = ours, theirs
    print(our_renderer, their_renderer, sep="\n")
    if not our_renderer.startswith("Terrazzo") or "Terrazzo" in their_renderer:
        sys.exit("the libraries were not the two to be compared")
    if our_header != their_header or len(our_pixels) != len(their_pixels):
        sys.exit("the pictures differ in size")
    colours = len({their_pixels[i:i + 3] for i in range(0, len(their_pixels), 3)})
    if colours < fewest_colours:
        sys.exit(f"{colours} colours are no picture")
    differences = [abs(a - b) for a, b in zip(our_pixels, their_pixels)]
    print(f"{colours} colours, {sum(d > 0 for d in differences)} of {len(differences)} values differ, "
          f"by {max(differences)} at most")
    if max(differences) > STEP:
        sys.exit(f"{sum(d > STEP for d in differences)} values differ by more than {STEP}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--display", action="store_true")
    parser.add_argument("--osmesa", nargs=2, metavar=("OURS", "THEIRS"))
    parser.add_argument("--vendor")
    parser.add_argument("--plain")
    parser.add_argument("command", nargs=argparse.REMAINDER)
    options = parser.parse_args()
    command = [pathlib.Path(word).resolve() if pathlib.Path(word).exists() else word for word in options.command]
    if options.osmesa and not pathlib.Path(options.osmesa[1]).exists():
        skip(f"{options.osmesa[1]} is not installed")
    needs_display = options.display or not options.osmesa
    with xvfb() if needs_display else contextlib.nullcontext() as display:
        theirs = environment(display)
        ours = environment(display, options.vendor, options.plain)
        if options.osmesa:
            ours["LD_LIBRARY_PATH"] = str(pathlib.Path(options.osmesa[0]).resolve().parent)
        compare(draw(command, ours), draw(command, theirs))


if __name__ == "__main__":
    main()
