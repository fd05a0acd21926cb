#!/usr/bin/env python3
"""What the terrazzo command says to what it cannot do: a sentence on standard error and an exit code, never a signal.

usage: command_test.py TERRAZZO
"""

import concurrent.futures
import json
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

TERRAZZO = sys.argv[1]
failures, pending = [], []
workers = concurrent.futures.ThreadPoolExecutor(2)


def run(arguments, memory=None):
    def limit():
        if memory:
            resource.setrlimit(resource.RLIMIT_AS, (memory, memory))

    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    return subprocess.run([TERRAZZO, *map(str, arguments)], capture_output=True, text=True, timeout=100, env=environment,
                          preexec_fn=limit)


def expect(code, words, *arguments, memory=None):
    """`code` None: any but 0. Asked in the background; two at a time."""
    pending.append(workers.submit(ask, code, words, arguments, memory))


def ask(code, words, arguments, memory):
    done = run(arguments, memory)
    text = done.stdout + done.stderr
    right = done.returncode > 0 if code is None else done.returncode == code
    if not right or words not in text or "terminate called" in text:
        failures.append(f"{' '.join(map(str, arguments))}: exit code {done.returncode}, not {code}; no '{words}' in: {text}")


def triangle():
    # Positions (0,0,0) (1,0,0) (0,1,0) as floats, then indices 0 1 2 as shorts.
    data = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAABAAIA"
    return {"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                          {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}],
            "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
            "buffers": [{"byteLength": 42, "uri": "data:application/octet-stream;base64," + data}]}


def write(path, document):
    path.write_text(document if isinstance(document, str) else json.dumps(document))
    return path


def models(folder):
    picture = folder / "picture.png"
    good = write(folder / "good.GLTF", triangle())
    expect(0, "by Terrazzo", "draw", good, "-o", picture)
    odd = triangle()
    odd["nodes"][0]["children"] = [7]
    expect(0, "a child that is not there", "draw", write(folder / "odd.gltf", odd), "-o", picture)
    twice = triangle()
    twice["nodes"] = [{"children": [n + 1, n + 1]} for n in range(40)] + [{"mesh": 0}]
    expect(1, "form trees", "draw", write(folder / "twice.gltf", twice), "-o", picture)
    needs = triangle()
    needs["extensionsRequired"] = ["EXT_beauty"]
    expect(1, "requires EXT_beauty", "draw", write(folder / "needs.gltf", needs), "-o", picture)
    # A few bytes that ask for nine exabytes.
    huge = '{"asset":{"version":"2.0"},"buffers":[{"byteLength":9000000000000000000}]}'
    expect(1, "nothing to draw", "draw", write(folder / "huge.gltf", huge), "-o", picture)
    expect(1, "not glTF", "draw", write(folder / "text.gltf", "hello"), "-o", picture)
    expect(1, "no camera 5", "draw", good, "--camera", 5, "-o", picture)
    expect(1, "no scene 9", "draw", good, "--scene", 9, "-o", picture)
    expect(1, "--max-vertices", "draw", good, "--max-vertices", 2, "-o", picture)
    expect(None, "--max-pixels", "draw", good, "--max-pixels", -1, "-o", picture)
    expect(1, "form trees", "demo", folder / "twice.gltf", "--pictures-only", "-o", folder / "demo")
    expect(1, "form trees", "bench", folder / "twice.gltf")
    smoke = ("bench", "states", "--smoke")
    states = (*smoke, "-f", "^plain/medium$")
    expect(0, "1 states drawn", *states, "--check")
    expect(0, "plain/medium", *states, "--json", folder / "states.json", "--html", folder / "states.html")
    expect(1, "cannot read /no/parts.json", *states, "--with", "/no/parts.json")
    expect(1, "no state is called", *smoke, "-f", "^none$")
    expect(1, "no regular expression", *smoke, "-f", "(")
    expect(1, "two libraries", *states, "-l", "terrazzo")
    expect(1, "/no/such/library.so", *states, "-l", "/no/such/library.so", "-l", "terrazzo")
    expect(1, "not drawn with quantum", *states, "--isa", "quantum")
    expect(1, "there is no folder", *states, "--pictures", folder / "no")
    expect(1, "cannot write", *states, "--json", folder / "no" / "states.json")
    expect(0, "1 states drawn", *smoke, "--check", "--state", "fog=exp primitive=strips")
    expect(1, "fog has no value thick", *smoke, "--state", "fog=thick")
    expect(None, "--samples", *states, "--samples", 3)
    expect(None, "--size", *states, "--size", 0)
    expect(1, "there is no display", "view", "--system", good)
    expect(None, "--size", "view", good, "--size", "0x10")
    expect(None, "--size", "view", good, "--size", "12x34x56")
    expect(None, "does not exist", "view", folder / "none.gltf")
    expect(1, "there is no folder", "view", good, "--screenshot", folder / "no" / "a.png")


def pictures(folder):
    picture = folder / "picture.png"
    expect(1, "no scene or model file is called", "draw", "T99", "-o", picture)
    expect(1, "no scene or model file is called", "draw", "x" * 5000, "-o", picture)
    expect(1, "no scene or model file is called", "draw", folder, "-o", picture)
    expect(1, "there is no folder", "draw", "T1", "-o", folder / "no" / "picture.png")
    expect(1, "no known picture format", "draw", "T1", "-o", folder / "picture")
    expect(1, "it is a folder", "draw", "T1", "-o", write_folder(folder / "folder.png"))
    full = folder / "full.png"
    full.symlink_to("/dev/full")
    expect(1, "cannot write", "draw", "T1", "--width", 64, "--height", 64, "-o", full)
    for option in ("--width", "--height"):
        for size in (0, 16385, "99999999999999999999", "wide"):
            expect(None, option, "draw", "T1", option, size, "-o", picture)
    expect(None, "--threads", "draw", "T1", "--threads", -1, "-o", picture)
    expect(1, "/no/such/library.so", "draw", "T1", "-l", "/no/such/library.so", "-o", picture)
    expect(1, "invalid ELF header", "draw", "T1", "-l", "/etc/passwd", "-o", picture)
    expect(1, "not enough memory", "draw", "T1", "--width", 16384, "--height", 16384, "-o", picture, memory=900 << 20)
    expect(1, "/proc/no/report", "demo", "--pictures-only", "-o", "/proc/no/report")


def write_folder(path):
    path.mkdir()
    return path


def main():
    with tempfile.TemporaryDirectory() as name:
        models(pathlib.Path(name))
        pictures(pathlib.Path(name))
        for question in pending:
            question.result()
    print("\n".join(failures) or "every refusal is a sentence")
    return 1 if failures else 0


sys.exit(main())
