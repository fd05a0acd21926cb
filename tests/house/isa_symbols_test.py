#!/usr/bin/env python3
"""What is compiled once per instruction set keeps its symbols to itself.

usage: isa_symbols_test.py NM ISA=ARCHIVE...
The linker keeps one copy of an inline function that several objects define. Were it the one compiled for AVX-512,
every other processor would meet an illegal instruction. So each external symbol that such an archive defines must
carry the archive's own namespace isa_<name> in its mangled name; anything else (an inline function of std:: or of a
header shared with other code) has to be inlined by force or moved.
"""
import re
import subprocess
import sys

DEFINED = re.compile(r"^[0-9a-f]+ ([A-TV-Zuvw]) (\S+)$")


def foreign_symbols(nm, isa, archive):
    own = f"isa_{isa}"
    marker = f"{len(own)}{own}"
    output = subprocess.run([nm, "--extern-only", "--defined-only", archive], check=True, capture_output=True, text=True).stdout
    symbols = [match.group(2) for line in output.splitlines() if (match := DEFINED.match(line))]
    if not any(marker in symbol for symbol in symbols):
        yield f"{archive}: no symbol in namespace {own}"
    # Data that the compiler pools by content (DW.ref.*, .LC*) is the same whoever compiled it.
    yield from (f"{archive}: {symbol}" for symbol in symbols
                if marker not in symbol and not symbol.startswith("DW.ref."))


def main():
    nm, *archives = sys.argv[1:]
    offences = [offence for argument in archives for offence in foreign_symbols(nm, *argument.split("=", 1))]
    print(*offences, sep="\n")
    print(f"{len(archives)} archives, {len(offences)} foreign symbols")
    sys.exit(bool(offences) or not archives)


main()
