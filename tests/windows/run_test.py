#!/usr/bin/env python3
"""What `terrazzo run` tells of a program's frames: their number, primitives and pixels, and the pictures it records.

usage: run_test.py TERRAZZO PROGRAM
PROGRAM is the one of frames.c. Exits with 77, which meson takes for "skipped", without Xvfb or PIL.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from on_display import environment, skip, xvfb

try:
    from PIL import Image
except ImportError:
    skip("PIL is not installed")

FRAMES, SIZE = 3, (160, 120)
RED, GREEN = 110 * 60 - 20 * 10, 20 * 10
# A rectangle is two triangles: two rectangles are seen, one lies behind them. What is covered later counts.
BACKGROUND = (49, 89, 206)
PRIMITIVES, PIXELS = 3 * 2, 110 * 60 + 20 * 10


def run(terrazzo, program, display, *options):
    """Standard error of the program under `terrazzo run`."""
    live = subprocess.run([terrazzo, "run", *options, program], env=environment(display), capture_output=True, text=True,
                          timeout=100)
    if live.returncode == 77:
        skip("there is no display")
    if live.returncode != 0:
        sys.exit(f"exit status {live.returncode}\n{live.stdout}{live.stderr}")
    return live.stderr


def expect(found, expected, what):
    if found != expected:
        sys.exit(f"{what}: {found}, not {expected}")


def check_statistics(text):
    frames, width, height = re.search(r"terrazzo: (\d+) frames in .* (\d+)x(\d+) at last", text).groups()
    expect((int(frames), int(width), int(height)), (FRAMES, *SIZE), "frames and their size")
    counts = {what: int(number) for number, what in re.findall(r"(\d+) (primitives|pixels)$", text, re.MULTILINE)}
    expect(counts, {"primitives": PRIMITIVES, "pixels": PIXELS}, "counted a frame")
    expect(len(re.findall(r"[\d.]+ ms ", text)), 4, "times")


def check_pictures(folder):
    pictures = sorted(folder.iterdir())
    expect([path.name for path in pictures], [f"{number:06}.png" for number in range(1, FRAMES + 1)], "pictures")
    for frame, path in enumerate(pictures):
        picture = Image.open(path).convert("RGB")
        expect(picture.size, SIZE, f"size of {path.name}")
        colours = {colour: count for count, colour in picture.getcolors()}
        rest = SIZE[0] * SIZE[1] - RED - GREEN
        expect(colours, {(255, 0, 0): RED, (0, 255, 0): GREEN, BACKGROUND: rest}, f"colours of {path.name}")
        # The red rectangle moves on from frame to frame; its lowest row is 20 above the window's.
        red = picture.getchannel("R").point(lambda value: value == 255 and 255)
        expect(red.getbbox(), (10 + frame, SIZE[1] - 80, 120 + frame, SIZE[1] - 20), f"place in {path.name}")


def main():
    terrazzo, program = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    with xvfb(depth=16) as display, tempfile.TemporaryDirectory() as folder:
        check_statistics(run(terrazzo, program, display, "--stats", "--record", folder))
        check_pictures(pathlib.Path(folder))
    with xvfb() as display, tempfile.TemporaryDirectory() as folder:
        check_statistics(run(terrazzo, program, display, "--stats"))
        check_statistics(run(terrazzo, program, display, "--threads", "2", "--stats", "--record", folder))
        check_pictures(pathlib.Path(folder))
        silent = run(terrazzo, program, display)
        expect(silent, "", "said without being asked")


if __name__ == "__main__":
    main()
