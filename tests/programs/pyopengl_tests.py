#!/usr/bin/env python3
"""Runs the tests of PyOpenGL's own source archive with whatever library the environment gives them.

usage: pyopengl_tests.py FOLDER, the archive's folder "tests", with a python that has PyOpenGL, pygame, numpy, psutil,
       python-xlib and pytest.
Run by on_display.py, which chooses the library. Fails when a test fails that does not ask for something that is not there,
or the library that drew was not Terrazzo. Exits with 77 where the python has no such modules.
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

# What tests ask for that README does not promise.
BEYOND = {
    "test_checks.py": {
        "OpenGL ES": ["test_check_egl_es1", "test_check_egl_es2"],
        "contexts of OpenGL 3.1": ["test_check_glut_debug", "test_check_glut_fc"],
        "GL_SHADING_LANGUAGE_VERSION": ["test_check_glutinit"],
        "shaders": ["test_feedbackvarying", "test_test_glgetactiveuniform"],
        # It fails with Mesa as well.
        "a share of the machine's memory that stays the same to the last digit": ["test_test_glgetfloat_leak"],
    },
    "test_core.py": {
        # As libglvnd's library does, ours exports commands of later versions, and their addresses are what is asked for.
        "no addresses of commands that are not there": ["test_get_version"],
        "several colour attachments": ["test_glDrawBuffers_list_valid"],
        "vertex array objects": ["test_glbufferparameter_create", "test_glgetbufferparameter", "test_orinput_handling"],
        "shaders": ["test_shader_compile_string"],
    },
    "test_textures.py": {"GL_MAX_TEXTURE_IMAGE_UNITS": ["test_get_max_tex_units"]},
}
REASONS = {(file[:-3], test): reason for file, reasons in BEYOND.items() for reason, tests in reasons.items() for test in tests}
WHO = """
import pygame
from OpenGL.GL import GL_VENDOR, glGetString
pygame.display.init()
pygame.display.set_mode((30, 30), pygame.OPENGL | pygame.DOUBLEBUF)
print(glGetString(GL_VENDOR).decode())
"""


def main():
    folder = pathlib.Path(sys.argv[1])
    for module in ("OpenGL", "pygame", "numpy", "psutil", "Xlib", "pytest"):
        if subprocess.run([sys.executable, "-c", f"import {module}"], stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL).returncode != 0:
            print(f"skipped: {sys.executable} has no {module}")
            sys.exit(77)
    who = subprocess.run([sys.executable, "-c", WHO], cwd=folder, stdout=subprocess.PIPE, text=True).stdout.split()
    if "Terrazzo" not in who:
        sys.exit(f"not Terrazzo draws: {who[-1:]}")
    with tempfile.TemporaryDirectory() as scratch:
        report = pathlib.Path(scratch) / "report.xml"
        files = sorted(path.name for path in folder.glob("test_*.py"))
        subprocess.run([sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", f"--junitxml={report}", *files],
                       cwd=folder, stdout=subprocess.DEVNULL)
        cases = xml.etree.ElementTree.parse(report).getroot().iter("testcase")
        outcomes = {}
        for case in cases:
            name = re.sub(r"\W.*", "", case.get("name"))
            file = next((part for part in case.get("classname").split(".") if part.startswith("test_")), "")
            bad = next((child for child in case if child.tag in ("failure", "error")), None)
            skipped = case.find("skipped") is not None
            outcomes[file, name] = "skipped" if skipped else "passed" if bad is None else bad.get("message") or bad.tag
    wrong = {case: outcome for case, outcome in outcomes.items()
             if outcome not in ("passed", "skipped") and case not in REASONS}
    count = {outcome: list(outcomes.values()).count(outcome) for outcome in ("passed", "skipped")}
    print(f"{count['passed']} passed, {count['skipped']} skipped, of {len(outcomes)}")
    for case, outcome in wrong.items():
        print(f"FAILED {'.'.join(case)}: {outcome.splitlines()[0][:150]}")
    if count["passed"] < 50:
        sys.exit("fewer tests than there are in the archive: see what pytest says")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
