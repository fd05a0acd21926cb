#!/usr/bin/env python3
"""A known program, unmodified, on Terrazzo: it runs, and its pictures are Mesa's.

usage: compare_program.py --terrazzo COMMAND --vendor FOLDER [--seconds S] [--egl] [--exception WHY] PROGRAM [ARGUMENTS...]
First the program runs for some seconds under `terrazzo run`, which must be told of its frames (so they are ours and not
another vendor's) and of no command that is not implemented. Then what it does on Mesa is traced, and the trace replayed
on both: that makes its times and its random numbers the same. Exits with 77 when the program or apitrace is missing.
"""

import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "windows"))
import known  # noqa: E402
import on_display  # noqa: E402


def run_live(options, program, environment):
    """The program on Terrazzo, as its users would start it."""
    command = [options.terrazzo, "run", "--stats", "timeout", "-s", "TERM", str(options.seconds), program, *options.arguments]
    live = subprocess.run(command, env=environment | {"TERRAZZO_DEBUG": "1"}, capture_output=True, text=True,
                          errors="replace", timeout=options.seconds + 60)
    frames = re.search(r"terrazzo: (\d+) frames", live.stderr)
    missing = sorted(set(re.findall(r"terrazzo: (\w+): .*not implemented", live.stderr)))
    print(f"  live: {frames.group(1) if frames else 'no'} frames, exit status {live.returncode}"
          + (f", not implemented: {' '.join(missing)}" if missing else ""))
    crashed = live.returncode > 128 or live.returncode in (126, 127)
    if not frames or missing or crashed:
        print(live.stderr[-2000:])
        return False
    return int(frames.group(1)) >= 2


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--terrazzo", required=True)
    parser.add_argument("--vendor", required=True)
    parser.add_argument("--seconds", type=float, default=4)
    parser.add_argument("--egl", action="store_true")
    parser.add_argument("--exception", help="why the pictures differ; they are printed and not judged")
    parser.add_argument("program")
    parser.add_argument("arguments", nargs=argparse.REMAINDER)
    options = parser.parse_args()
    for tool in (options.program, "apitrace"):
        if not known.find(tool):
            on_display.skip(f"{tool} is not installed")
    program = known.find(options.program)
    try:
        import replay
    except ImportError as error:
        on_display.skip(f"{error.name} is not installed")

    with on_display.xvfb(size="1024x768") as display, tempfile.TemporaryDirectory() as home:
        mesa = on_display.environment(display) | known.belongings(home)
        ours = on_display.environment(display, vendor=options.vendor) | known.belongings(home)
        good = run_live(options, program, mesa)
        trace = pathlib.Path(home) / "program.trace"
        known.record(trace, [program, *options.arguments], options.seconds, mesa, options.egl)
        lines = replay.compare(trace, mesa, ours, 4) if trace.exists() else []
        if not lines:
            print("  nothing to compare: the program shows no frame that can be repeated")
        same = replay.judge(lines)
        if options.exception:
            print("  exception:", options.exception)
        else:
            good &= same
        sys.exit(not good)


if __name__ == "__main__":
    main()
