#!/usr/bin/env python3
"""doc/walk*.md tell the truth: their files are there, and each name it mentions is in the files of its section.

usage: walk_test.py SOURCE_ROOT BUILD_ROOT
A section is headed "## 3. `src/gl/draw.cpp`". In its text `name(...)`, `name()` or `Class::name()` is a function,
`path/file.h` a file whose names may be mentioned too, and any other identifier between backticks a name.
"""
import pathlib
import re
import sys
import unittest

SOURCE, BUILD = map(pathlib.Path, sys.argv[1:])
MOST_FILES = 8
SPAN = re.compile(r"`([^`]+)`")
HEADING = re.compile(r"^## (\d+)\. `([^`]+)`$", re.MULTILINE)
FILE = re.compile(r"[\w./-]+\.(?:h|cpp|py|md|c)")
FUNCTION = re.compile(r"(?:[\w:]+::)?(~?\w+)\(.*\)")
NAME = re.compile(r"(?:[\w:]+::)?(\w+)")


def find(path):
    for root in (SOURCE, SOURCE / "src", BUILD, BUILD / "src"):
        if (root / path).is_file():
            return root / path
    return None


class Walk:
    """One page; a subclass a page says which."""
    name = ""

    def setUp(self):
        text = (SOURCE / "doc" / self.name).read_text()
        headings = list(HEADING.finditer(text))
        ends = [h.start() for h in headings[1:]] + [len(text)]
        self.sections = [(h.group(1), h.group(2), text[h.end():end]) for h, end in zip(headings, ends)]

    def test_length_of_the_walk(self):
        self.assertEqual([number for number, _, _ in self.sections], [str(i + 1) for i in range(len(self.sections))])
        self.assertGreaterEqual(len(self.sections), 5)
        self.assertLessEqual(len(self.sections), MOST_FILES)

    def test_files_exist(self):
        for _, path, body in self.sections:
            for name in [path] + [span for span in SPAN.findall(body) if FILE.fullmatch(span)]:
                with self.subTest(name):
                    self.assertIsNotNone(find(name))

    def test_names_exist(self):
        for number, path, body in self.sections:
            spans = SPAN.findall(body)
            files = [find(name) for name in [path] + [span for span in spans if FILE.fullmatch(span)]]
            code = "\n".join(file.read_text() for file in files if file)
            functions = 0
            for span in spans:
                if FILE.fullmatch(span):
                    continue
                if function := FUNCTION.fullmatch(span):
                    functions += 1
                    pattern = rf"\b{re.escape(function.group(1))}\s*(?:<[^;()]*>)?\("
                elif name := NAME.fullmatch(span):
                    pattern = rf"\b{name.group(1)}\b"
                else:
                    pattern = re.escape(span)
                with self.subTest(section=number, name=span):
                    self.assertTrue(re.search(pattern, code), f"not in the section's files: {span}")
            self.assertGreater(functions, 0, f"section {number} names no function")


PAGES = sorted(path.name for path in (SOURCE / "doc").glob("walk*.md"))
assert len(PAGES) == 3, PAGES
for page in PAGES:
    globals()[page] = type(page, (Walk, unittest.TestCase), {"name": page})

unittest.main(argv=sys.argv[:1])
