#!/usr/bin/env python3
"""The fuzzer finds planted faults, says which episode shows them, and finds the few operations that matter.

usage: faults_test.py FUZZ FAULTY_LIBRARY
"""
import os
import re
import subprocess
import sys

# Fault, what must be said of it, options that find it soon.
FAULTS = [
    ("reads beyond", "failed", []),
    ("writes before", "failed", []),
    ("hangs", "glLineWidth does not return", ["--call-seconds", "1"]),
    ("crashes in order", "failed", []),
    ("changes in spite of an error", "changed by a call with error 0x501: GL_POINT_SIZE", ["--only", "glPointSize|glGetError"]),
]


def run(fault, *options):
    finished = subprocess.run([sys.argv[1], "--library", sys.argv[2], *options], env=os.environ | {"FAULT": fault},
                              capture_output=True, text=True)
    return finished.returncode, finished.stdout


def main():
    failures = []

    def expect(condition, what, output):
        if not condition:
            failures.append(what)
            print(f"{what}\n{output}")

    status, output = run("", "--episodes", "3", "--operations", "300")
    expect(status == 0 and "0 failures" in output, "without a fault there is a failure", output)
    for fault, said, options in FAULTS:
        status, output = run(fault, "--episodes", "60", "--failures", "1", "--operations", "600", *options)
        expect(status == 1 and said in output, f"a library that {fault} is not found out", output)
    status, output = run("crashes in order", "--episodes", "60", "--failures", "1", "--operations", "600")
    episode = re.search(r"Episode (\d+) failed", output)
    expect(episode, "no episode is named", output)
    if episode:
        status, output = run("crashes in order", "--minimise", "--seed", episode[1], "--operations", "600")
        few = re.search(r"(\d+) operations are enough", output)
        expect(status == 1 and few and int(few[1]) <= 2, "the operations that matter are not found", output)
        expect(re.search(r"glShadeModel\(GL_FLAT\);[^;]*\n(.*;\n)*.*glLineWidth\(", output), "the calls that matter are not printed", output)
    sys.exit(bool(failures))


if __name__ == "__main__":
    main()
