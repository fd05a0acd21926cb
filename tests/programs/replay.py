"""Replays apitrace traces on two drivers and compares the pictures.

A trace is what one program asked of GL; replayed on another driver it shows what that driver makes of the same calls.
"""

import pathlib
import re
import shutil
import subprocess
import tempfile

import numpy
from PIL import Image


WITHIN_ONE = 0.999  # of a frame's pixels
# In a trace's first picture Mesa often has the size and the pixels that the window had before the tool resized it: black,
# or filled in one corner. Where that is all there is to compare, what differs is told and not judged.
STALE = "(Mesa's first picture may be stale: not judged)"


def run(command, environment, **options):
    return subprocess.run(command, env=environment, capture_output=True, text=True, errors="replace", **options)


def tool_for(trace, environment):
    head = run(["apitrace", "dump", "--color=never", "--calls=0-60", str(trace)], environment).stdout
    return "eglretrace" if re.search(r"\begl[A-Z]", head) else "glretrace"


def calls_named(trace, name, environment):
    dump = run(["apitrace", "dump", "--color=never", "--grep=" + name, str(trace)], environment).stdout
    return [int(line.split()[0]) for line in dump.splitlines() if line[:1].isdigit()]


def frames_of(trace, environment, wanted):
    """Numbers of calls that end a frame, spread over the trace; and whether there is but one, the first."""
    swaps = calls_named(trace, "SwapBuffers", environment)
    if not swaps:
        flushes = calls_named(trace, "glFlush", environment) or calls_named(trace, "glFinish", environment)
        return flushes[-1:], True
    swaps = swaps[1:] or swaps
    last = len(swaps) - 1
    return sorted({swaps[i * last // max(1, wanted - 1)] for i in range(min(wanted, len(swaps)))}), len(swaps) == 1


def pictures(tool, trace, calls, folder, environment):
    """Pictures by number of call."""
    folder.mkdir(parents=True)
    prefix = f"{folder}/"
    result = run([tool, "--headless", "-s", prefix, "-S", ",".join(map(str, calls)), str(trace)], environment, timeout=900)
    return {int(path.stem): numpy.asarray(Image.open(path).convert("RGB")).astype(int)
            for path in folder.glob("*.png")}, result


def compare(trace, theirs, ours, wanted=5, keep=None):
    """A line for each frame: (call, share of pixels within 1 of 255, largest difference, text)."""
    folder = pathlib.Path(tempfile.mkdtemp(prefix="replay-"))
    try:
        tool = tool_for(trace, theirs)
        calls, single = frames_of(trace, theirs, wanted)
        if not calls:
            return []
        expected, _ = pictures(tool, trace, calls, folder / "theirs", theirs)
        if single:
            # Mesa's first pictures race with the X server: only those that repeat, and show something, count.
            again, _ = pictures(tool, trace, calls, folder / "again", theirs)
            expected = {call: picture for call, picture in expected.items()
                        if call in again and numpy.array_equal(picture, again[call]) and picture.any()}
        actual, result = pictures(tool, trace, calls, folder / "ours", ours)
        lines = []
        for call, picture in sorted(expected.items()):
            other = actual.get(call)
            if other is None or other.shape != picture.shape:
                lines.append((call, 0.0, 255, "no picture: " + result.stderr.strip()[-300:]))
                continue
            difference = numpy.abs(picture - other).max(2)
            within = float((difference <= 1).mean())
            text = STALE if single and within < WITHIN_ONE and other.any() else ""
            lines.append((call, within, int(difference.max()), text))
        return lines
    finally:
        if keep:
            shutil.copytree(folder, keep, dirs_exist_ok=True)
        shutil.rmtree(folder)


def judge(lines):
    """Prints the lines; whether all are good."""
    good = True
    for call, within, largest, text in lines:
        bad = within < WITHIN_ONE and text != STALE
        good &= not bad
        print(f"  call {call}: {100 * within:.3f} % within 1, largest difference {largest} {text}{' FAILED' if bad else ''}")
    return good
