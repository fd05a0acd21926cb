#!/usr/bin/env python3
"""What a front end's library costs its user: its size, what it needs at run time, and how it loads.

usage: library_test.py NM READELF STRIP LIBRARY
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

NM, READELF, STRIP, LIBRARY = sys.argv[1:]
LIMIT = 5 * 1000 * 1000
# The C library and its parts; on some systems the loader itself, which holds the thread-local storage.
ALLOWED = re.compile(r"lib(c|m|pthread|dl)\.so\.\d+|ld-linux[-\w]*\.so\.\d+")


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


class Library(unittest.TestCase):
    def test_size(self):
        with tempfile.TemporaryDirectory() as folder:
            stripped = pathlib.Path(folder) / "stripped"
            subprocess.run([STRIP, "-o", stripped, LIBRARY], check=True)
            size = stripped.stat().st_size
        print(f"{size / 1e6:.2f} MB stripped", file=sys.stderr)
        self.assertGreater(size, 100_000)
        self.assertLess(size, LIMIT)

    def test_needs_the_c_library_alone(self):
        needed = re.findall(r"\(NEEDED\).*\[(.*)\]", output(READELF, "-dW", LIBRARY))
        self.assertIn("libc.so.6", needed)
        self.assertEqual([name for name in needed if not ALLOWED.fullmatch(name)], [])

    def test_nothing_writable_is_executable(self):
        headers = output(READELF, "-lW", LIBRARY)
        self.assertIn("GNU_STACK", headers)
        self.assertNotIn("RWE", headers)
        self.assertNotIn("TEXTREL", output(READELF, "-dW", LIBRARY))

    def test_can_be_unloaded(self):
        # A symbol of type STB_GNU_UNIQUE pins its library in the process, and so does DF_1_NODELETE.
        symbols = [line.split() for line in output(NM, "-D", "--defined-only", LIBRARY).splitlines()]
        self.assertEqual([name for *_, kind, name in symbols if kind == "u"], [])
        self.assertNotIn("NODELETE", output(READELF, "-dW", LIBRARY))


unittest.main(argv=sys.argv[:1])
