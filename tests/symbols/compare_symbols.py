#!/usr/bin/env python3
"""Compares the names that a shared library exports with a list, and with another library's when that is there.

usage: compare_symbols.py LIBRARY LIST [OTHER_LIBRARY]
Fails when a name is missing, when there is one too many, or when a name is exported with a version or as data.
"""

import pathlib
import subprocess
import sys


def exported(library):
    """(type, name) pairs of the dynamic symbols that the library defines."""
    output = subprocess.run(["nm", "-D", "--defined-only", library], check=True, capture_output=True, text=True).stdout
    return {tuple(line.split()[1:3]) for line in output.splitlines()}


def report(title, names):
    for name in sorted(names):
        print(f"{title}: {name}")
    return bool(names)


def main():
    library, list_path, *others = sys.argv[1:]
    ours = exported(library)
    wanted = {("T", name) for name in pathlib.Path(list_path).read_text().split()}
    failed = report("missing", {n for _, n in wanted - ours}) | report("too many", {f"{t} {n}" for t, n in ours - wanted})
    for other in filter(lambda path: pathlib.Path(path).exists(), others):
        theirs = exported(other)
        failed |= report(f"missing, {other} has it", {n for _, n in theirs - ours})
    print(f"{len(ours)} names, {len(wanted)} wanted")
    sys.exit(failed)


if __name__ == "__main__":
    main()
