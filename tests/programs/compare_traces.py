#!/usr/bin/env python3
"""Traces of programs, replayed on Mesa and on Terrazzo: the same pictures.

usage: compare_traces.py --vendor FOLDER FOLDER_OF_TRACES [NAME...]
Exits with 77 when there are no traces, apitrace or server.
"""

import argparse
import pathlib
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "windows"))
import on_display  # noqa: E402

# OpenGL ES 1.1 is not offered yet.
OTHER_APIS = "es1-"
# What differs, and why. Traces were recorded on Mesa, with all that it offers: the programs themselves do without.
EXCEPTIONS = {
    "mujoco-win": "uses 32-bit float depth, which is not offered",
    "osgspotlight": "Mesa keeps the old ambient when GL_COLOR_MATERIAL is enabled again with the same colour",
    "osgteapot": "Mesa keeps the old ambient when GL_COLOR_MATERIAL is enabled again with the same colour",
}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--vendor", required=True)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    traces = [t for t in sorted(options.folder.glob("*.trace")) if not t.stem.startswith(OTHER_APIS)]
    if options.names:
        traces = [t for t in traces if t.stem in options.names]
    if not traces:
        on_display.skip(f"no traces in {options.folder}")
    if not shutil.which("glretrace"):
        on_display.skip("apitrace is not installed")
    try:
        import replay
    except ImportError as error:
        on_display.skip(f"{error.name} is not installed")

    failed = []
    with on_display.xvfb(size="1280x1024") as display:
        mesa = on_display.environment(display)
        ours = on_display.environment(display, vendor=options.vendor)
        for trace in traces:
            print(trace.stem, flush=True)
            lines = replay.compare(trace, mesa, ours, 3)
            if trace.stem in EXCEPTIONS:
                print("  exception:", EXCEPTIONS[trace.stem])
            elif not replay.judge(lines):
                failed.append(trace.stem)
    print(f"{len(traces)} traces, {len(failed)} failed: {' '.join(failed)}")
    sys.exit(bool(failed))


if __name__ == "__main__":
    main()
