#!/usr/bin/env python3
"""What `terrazzo info` says of libraries' commands.

usage: info_test.py TERRAZZO LIBRARY FORGETFUL_LIBRARY REGISTRY
FORGETFUL_LIBRARY is the one of forgetful.cpp. What OpenGL 1.0-1.5 has is read from the registry once more.
"""

import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

TERRAZZO, LIBRARY, FORGETFUL, REGISTRY = sys.argv[1:5]
FORGOTTEN = ["glBlitFramebuffer", "glFogCoordf"]


def info(*options):
    done = subprocess.run([TERRAZZO, "info", *options], capture_output=True, text=True, timeout=100)
    if done.returncode != 0:
        sys.exit(f"info {options}: exit status {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout.splitlines()


def expect(found, expected, what):
    if found != expected:
        sys.exit(f"{what}: {found}, not {expected}")


def counts(*options):
    """(missing, asked) of OpenGL 1.0-1.5, of extensions, of the system's library."""
    found = re.findall(r"not implemented: (\d+) of (\d+) ", "\n".join(info(*options)))
    return [(int(missing), int(asked)) for missing, asked in found]


def main():
    features = ElementTree.parse(REGISTRY).getroot().findall("feature[@api='gl']")
    commands = {feature.get("number"): {c.get("name") for c in feature.findall("require/command")}
                for feature in features}
    core = set().union(*(names for version, names in commands.items() if version <= "1.5"))
    later = set().union(*commands.values()) - core

    expect(info("--missing", "--library", LIBRARY), [], "missing")
    expect(info("--missing", "--library", FORGETFUL), FORGOTTEN, "missing from a library without them")
    everything = info("--missing", "--later", "--library", LIBRARY)
    expect(sorted(core.intersection(everything)), [], "of OpenGL 1.0-1.5 among later ones")
    if len(later.intersection(everything)) < 100 or "glCreateShader" not in everything:
        sys.exit(f"of later versions: {everything}")

    ours, forgetful = counts("--library", LIBRARY), counts("--library", FORGETFUL)
    expect(ours[0], (0, len(core)), "commands of OpenGL 1.0-1.5")
    expect(ours[1][0], 0, "missing commands of extensions")
    expect(ours[2][0], len(everything), "missing commands of the system's library")
    expect(forgetful[0], (1, len(core)), "commands of OpenGL 1.0-1.5, one forgotten")
    expect(forgetful[1], (1, ours[1][1]), "commands of extensions, one forgotten")


if __name__ == "__main__":
    main()
