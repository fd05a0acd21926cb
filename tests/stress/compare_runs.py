#!/usr/bin/env python3
"""The same seeds on every instruction set and thread count: the checksums of all pictures must be equal.

Every instruction set draws them with the first thread count, and the first instruction set with every thread count: the
two choices do not know of each other. With --every-pair all of them.

usage: compare_runs.py [--every-pair] PROGRAM FIRST COUNT ISA,... THREADS,... [COMMAND...]
COMMAND runs the program where the machine cannot by itself (an emulator). Every run is one process; the first ISA and
thread count are what the others are compared with. A seed that differs is reported with the line that repeats it.
"""
import itertools
import os
import subprocess
import sys


def run(program, wrapper, first, count, isa, threads):
    environment = {**os.environ, "TERRAZZO_ISA": isa, "TERRAZZO_THREADS": threads}
    result = subprocess.run([*wrapper, program, first, count], env=environment, capture_output=True, text=True)
    lines = result.stdout.splitlines()
    if result.returncode != 0 or len(lines) != int(count):
        print(f"TERRAZZO_ISA={isa} TERRAZZO_THREADS={threads} {program} {first} {count}: ended with "
              f"{result.returncode} after {len(lines)} seeds\n{result.stderr}")
        sys.exit(1)
    return lines


def main():
    arguments = sys.argv[1:]
    every_pair = arguments[0] == "--every-pair"
    program, first, count, isas, threads, *wrapper = arguments[every_pair:]
    isas, threads = isas.split(","), threads.split(",")
    choices = [(isa, number) for isa, number in itertools.product(isas, threads)
               if every_pair or number == threads[0] or isa == isas[0]]
    expected = run(program, wrapper, first, count, *choices[0])
    for line in expected:
        if len(line.split()) > 2:
            print(f"a GL error: {line}")
            sys.exit(1)
    # All pictures alike would mean that nothing was drawn.
    if len({line.split()[1] for line in expected}) < int(count) * 3 // 4:
        print("too few different pictures")
        sys.exit(1)
    differences = 0
    for isa, thread_count in choices[1:]:
        for line, wanted in zip(run(program, wrapper, first, count, isa, thread_count), expected):
            if line != wanted:
                differences += 1
                print(f"seed differs from {choices[0]}: TERRAZZO_ISA={isa} TERRAZZO_THREADS={thread_count} "
                      f"{program} {line.split()[0]} 1")
    print(f"{count} seeds from {first}, {len(choices)} runs, {differences} differences")
    sys.exit(differences != 0)


main()
