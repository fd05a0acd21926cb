#!/usr/bin/env python3
"""The rooms of src depend on one another in one direction, and only src/gl and above know GL's terms.

usage: rooms_test.py SOURCE_ROOT
Fails with a line per offence: an include of a room further up, an include of ours that does not exist, a GL type,
enumerant or header below src/gl, a look into the environment beside its one door, a file that does not open by saying
what it is.
"""
import re
import sys
import unittest

import source_text

ROOT = sys.argv.pop()
GL_TERMS = re.compile(r"\bGL(?:enum|bitfield|boolean|byte|short|int|sizei|u(?:byte|short|int)|float|double|clamp[fd])\b"
                      r"|\bGL_[A-Z0-9_]+|<(?:GL|KHR|EGL|GLES\d?)/")
ENVIRONMENT = re.compile(r"\b(?:\w*getenv\w*|environ)\b")


class Rooms(unittest.TestCase):
    def setUp(self):
        self.files = source_text.source_files(ROOT)
        self.assertGreater(len(self.files), 50, "the source was not found")

    def check(self, offences):
        self.assertFalse(offences, "\n" + "\n".join(offences))

    def test_includes_point_downwards(self):
        offences = []
        source = source_text.pathlib.Path(ROOT) / "src"
        for path in self.files:
            own = source_text.room_of(ROOT, path)
            for quote, name in source_text.INCLUDE.findall(path.read_text()):
                if quote != '"' or "/generated/" in name:
                    continue
                target = source / name
                if not target.is_file():
                    offences.append(f'{path}: "{name}" is no file under src')
                    continue
                room = source_text.room_of(ROOT, target)
                if source_text.ROOMS.index(room) < source_text.ROOMS.index(own):
                    offences.append(f"{path}: {own} includes {name} of {room}")
        self.check(offences)

    def test_generated_headers_belong_to_gl(self):
        self.check([f"{path}: includes {name}" for path in self.files
                    for _, name in source_text.INCLUDE.findall(path.read_text())
                    if "/generated/" in name and source_text.room_of(ROOT, path) not in ("gl", "frontends")])

    def test_gl_terms_end_at_gl(self):
        offences = []
        for path in self.files:
            if source_text.room_of(ROOT, path) in ("gl", "frontends"):
                continue
            text = source_text.without_comments(path.read_text())
            offences += [f"{path}: {term}" for term in GL_TERMS.findall(text)]
        self.check(offences)

    def test_one_door_to_the_environment(self):
        """Which privileged programs find shut: src/simd/environment.h."""
        self.check([f"{path}: {name}" for path in self.files if path.name != "environment.cpp"
                    for name in ENVIRONMENT.findall(source_text.without_comments(path.read_text()))])

    def test_every_file_says_what_it_is(self):
        self.check([f"{path}: does not open with a comment" for path in self.files
                    if not path.read_text().startswith("//")])


unittest.main()
