#!/usr/bin/env python3
"""Writes the functions that the null driver has no more to say about: NOTHING(name) for each that a library exports.

usage: names.py OUTPUT SOURCE.c... EXPORTS.txt...
"""

import pathlib
import re
import sys


def names(sources: list[str], exports: list[str]) -> list[str]:
    """Exported names that no source defines."""
    defined = {name for text in sources for name in re.findall(r"\b((?:gl|egl)[A-Z]\w*)\(", text)}
    return sorted({line for text in exports for line in text.split()
                   if re.fullmatch(r"(?:gl|egl)[A-Z]\w*", line)} - defined)


def main() -> None:
    files = [pathlib.Path(name) for name in sys.argv[2:]]
    found = names([f.read_text() for f in files if f.suffix == ".c"], [f.read_text() for f in files if f.suffix == ".txt"])
    pathlib.Path(sys.argv[1]).write_text("".join(f"NOTHING({name})\n" for name in found))


if __name__ == "__main__":
    main()
