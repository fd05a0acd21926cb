#!/usr/bin/env python3
"""Runs a program with two libraries of the same name and compares what it prints.

usage: compare_libraries.py PROGRAM OUR_LIBRARY THEIR_LIBRARY
Exits with 77, which meson takes for "skipped", when their library is not installed.
"""

import difflib
import os
import pathlib
import subprocess
import sys


def output(program, library):
    # Preloaded, a library takes the place of whatever the program was linked with under the same name.
    environment = os.environ | {"LD_PRELOAD": str(pathlib.Path(library).resolve())}
    run = subprocess.run([program], env=environment, capture_output=True, text=True, timeout=60)
    if run.returncode != 0:
        sys.exit(f"{library}: exit status {run.returncode}\n{run.stderr}")
    return run.stdout.splitlines()


def main():
    program, ours, theirs = sys.argv[1:]
    if not pathlib.Path(theirs).exists():
        print(f"{theirs} is not installed")
        sys.exit(77)
    lines = output(program, ours)
    differences = list(difflib.unified_diff(output(program, theirs), lines, theirs, ours, lineterm="", n=3))
    print("\n".join(differences) or f"{len(lines)} lines, all the same")
    sys.exit(bool(differences))


if __name__ == "__main__":
    main()
