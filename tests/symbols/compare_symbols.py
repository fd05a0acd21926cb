#!/usr/bin/env python3
"""Compares the names that a shared library exports with a list, and with another library's when that is there.

usage: compare_symbols.py LIBRARY LIST... [-- OTHER_LIBRARY...]
Fails when a name is missing, when there is one too many, or when a name is exported with a version or as data.
"""

import pathlib
import subprocess
import sys


def exported(library):
    """(type, name) pairs of the dynamic symbols that the library defines."""
    output = subprocess.run(["nm", "-D", "--defined-only", library], check=True, capture_output=True, text=True).stdout
    # Weak functions are functions; others' libraries have linker's marks among their data.
    fields = [line.split()[1:3] for line in output.splitlines()]
    return {(type.replace("W", "T"), name) for type, name in fields if not name.startswith(("_edata", "_end", "__bss"))}


def report(title, names):
    for name in sorted(names):
        print(f"{title}: {name}")
    return bool(names)


def main():
    library, *lists = sys.argv[1:]
    others = lists[lists.index("--") + 1:] if "--" in lists else []
    lists = [path for path in lists if path not in ("--", *others)]
    ours = exported(library)
    wanted = {("T", name) for path in lists for name in pathlib.Path(path).read_text().split()}
    failed = report("missing", {n for _, n in wanted - ours}) | report("too many", {f"{t} {n}" for t, n in ours - wanted})
    for other in filter(lambda path: pathlib.Path(path).exists(), others):
        theirs = exported(other)
        failed |= report(f"missing, {other} has it", {n for _, n in theirs - ours})
    print(f"{len(ours)} names, {len(wanted)} wanted")
    sys.exit(failed)


if __name__ == "__main__":
    main()
