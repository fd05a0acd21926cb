#!/usr/bin/env python3
"""Windows, measured beside Mesa's llvmpipe in one run: frames a second of glxgears, the cost of a swap, the time to the
first frame and, with --traces, the CPU time of replaying apitrace traces with one thread each, the tool's own taken off.

usage: windows.py [--build FOLDER] [--rounds N] [--traces FOLDER] [--only WORD...]
Everything is interleaved and the medians are printed with their ratio (above 1: Terrazzo is faster). Needs Xvfb,
mesa-utils and, for traces, apitrace. Run it on a machine that does nothing else.
"""

import argparse
import os
import pathlib
import re
import statistics
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent), str(HERE.parents[1] / "tests" / "windows")]
import on_display  # noqa: E402
import parts  # noqa: E402


def gears(environment, width, height, seconds=3):
    run = subprocess.run(["timeout", str(seconds + 3.5), "stdbuf", "-oL", "glxgears", "-geometry", f"{width}x{height}+0+0"],
                         env=environment | {"vblank_mode": "0"}, capture_output=True, text=True)
    rates = [float(r) for r in re.findall(r"= ([0-9.]+) FPS", run.stdout)]
    return statistics.median(rates)


def swap(environment, build):
    out = subprocess.run([build / "bench/swap_cost", "1920", "1080"], env=environment, capture_output=True, text=True).stdout
    drawn, swapped = map(float, out.splitlines()[-1].split())
    return swapped - drawn


def first_frame(environment, build):
    begin = time.perf_counter()
    subprocess.run(["glxgears"], env=environment | {"LD_PRELOAD": str(build / "bench/libfirst_swap.so")},
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return 1e3 * (time.perf_counter() - begin)


def measure(name, unit, function, theirs, ours, rounds, more_is_better=False):
    samples = {"theirs": [], "ours": []}
    for _ in range(rounds):
        samples["theirs"].append(function(theirs))
        samples["ours"].append(function(ours))
    a, b = (statistics.median(samples[key]) for key in ("theirs", "ours"))
    ratio = (b / a if more_is_better else a / b) if a > 0 and b > 0 else float("nan")
    print(f"{name:<34} {a:10.3f} {b:10.3f} {unit:<4} {ratio:6.2f}", flush=True)
    return ratio


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=HERE.parents[1] / "build")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--traces", type=pathlib.Path)
    parser.add_argument("--only", nargs="*", default=["gears", "swap", "first", "traces"])
    options = parser.parse_args()
    build = options.build.resolve()
    with on_display.xvfb(size="1920x1200") as display:
        theirs = on_display.environment(display)
        ours = on_display.environment(display, vendor=build / "src/frontends/vendor")
        print(f"{'':<34} {'Mesa':>10} {'Terrazzo':>10}      {'ratio':>6}")
        if "gears" in options.only:
            for width, height in ((300, 300), (1920, 1080)):
                measure(f"glxgears {width}x{height}", "FPS", lambda e: gears(e, width, height), theirs, ours,
                        options.rounds, True)
        if "swap" in options.only:
            measure("swap 1920x1080 beyond drawing", "ms", lambda e: swap(e, build), theirs, ours, options.rounds)
        if "first" in options.only:
            measure("glxgears, start to first frame", "ms", lambda e: first_frame(e, build), theirs, ours,
                    5 * options.rounds)
        if "traces" in options.only and options.traces:
            import traces
            part = traces.measure(parts.Settings(build, [], options.rounds), options.traces)[0]
            ratios = [statistics.median(row.times["mesa"]) / statistics.median(row.times["terrazzo"]) for row in part.rows]
            for row, ratio in zip(part.rows, ratios):
                print(f"{row.name:<34} {statistics.median(row.times['mesa']):10.3f} "
                      f"{statistics.median(row.times['terrazzo']):10.3f} s    {ratio:6.2f}")
            if not ratios:
                sys.exit(part.problem)
            print(f"geometric mean of {len(ratios)} traces: {statistics.geometric_mean(ratios):.2f}, "
                  f"lowest {min(ratios):.2f}")


if __name__ == "__main__":
    main()
