#!/usr/bin/env python3
"""Programs whose frames somebody asks for: slow watchers, dead ones, and such as have no right to see them.

usage: watch_test.py watchers|privileges PROGRAM LIBRARY
PROGRAM is the one of watched.cpp. Exits with 77, which meson takes for "skipped", where a program cannot be given rights
that its caller has not.
"""

import contextlib
import os
import pathlib
import shutil
import socket
import struct
import subprocess
import sys
import tempfile
import threading

SIZE = 512
HEADER = struct.Struct("=IIIIQQQQQQQ")  # WatchedFrame of src/frontends/window/watch.h
MAGIC = 0x315A5254
NOBODY = 65534
# A program that waits for a watcher waits for ever: this only has to be longer than any machine is slow.
LONG = 300


def skip(reason):
    print("skipped:", reason)
    sys.exit(77)


def expect(found, expected, what):
    if found != expected:
        sys.exit(f"{what}: {found!r}, not {expected!r}")


@contextlib.contextmanager
def listener(backlog=8):
    """A socket that waits for callers, and its path; anybody may call."""
    with tempfile.TemporaryDirectory() as folder, socket.socket(socket.AF_UNIX) as server:
        os.chmod(folder, 0o755)
        path = os.path.join(folder, "frames")
        server.bind(path)
        os.chmod(path, 0o777)
        server.listen(backlog)
        yield server, path


def run(program, library, path, *arguments, **options):
    environment = {**os.environ, "TERRAZZO_WATCH": path, "TERRAZZO_WATCH_PICTURES": "1", "TERRAZZO_DEBUG": "1"}
    return subprocess.run([program, library, *arguments], env=environment, capture_output=True, text=True, timeout=LONG,
                          **options)


def read_frames(connection, pause, frames):
    """Appends each frame's header and the colour of its first pixel; stops a while before each."""
    with connection.makefile("rb", buffering=0) as file:
        def read(count):
            parts = b""
            while len(parts) < count:
                part = file.read(count - len(parts))
                if not part:
                    return None
                parts += part
            return parts

        while True:
            pause.wait(0.05)
            header = read(HEADER.size)
            if header is None:
                return
            fields = HEADER.unpack(header)
            picture = read(fields[4])
            frames.append((fields[:5], picture[:4] if picture else None))


def check_slow_watcher(program, library, *arguments):
    """It gets every frame, whole."""
    count, frames = 30, []
    with listener() as (server, path):
        def serve():
            connection, _ = server.accept()
            with connection:
                read_frames(connection, threading.Event(), frames)

        reader = threading.Thread(target=serve, daemon=True)
        reader.start()
        done = run(program, library, path, str(count), *arguments)
        reader.join(LONG)
    expect((done.returncode, done.stdout), (0, "done\n"), f"the watched program ({done.stderr})")
    expect(len(frames), count, "frames")
    for number, ((magic, process, width, height, size), pixel) in enumerate(frames):
        expect((magic, width, height, size), (MAGIC, SIZE, SIZE, SIZE * SIZE * 4), f"header of frame {number}")
        expect(pixel, bytes((255, 255 * (number % 2), 0, 255)), f"picture {number}")
        expect(process > 0, True, "process")


def check_silent_watcher(program, library):
    """It takes the call and never reads: the program draws all its frames."""
    with listener() as (server, path):
        held = []
        threading.Thread(target=lambda: held.append(server.accept()), daemon=True).start()
        done = run(program, library, path, "100")
        expect((done.returncode, done.stdout), (0, "done\n"), f"a program whose watcher does not read ({done.stderr})")
        expect(len(held), 1, "calls")


def check_deaf_watcher(program, library):
    """Its queue of callers is full, and it never takes one."""
    with listener(backlog=0) as (_, path), contextlib.ExitStack() as callers:
        for _ in range(4):
            caller = callers.enter_context(socket.socket(socket.AF_UNIX))
            caller.setblocking(False)
            try:
                caller.connect(path)
            except BlockingIOError:
                break
        else:
            sys.exit("the queue of callers has no end")
        done = run(program, library, path, "3")
        expect((done.returncode, done.stdout), (0, "done\n"), f"a program that nobody takes a call of ({done.stderr})")


def calls(server):
    """How many programs have called."""
    server.setblocking(False)
    count = 0
    with contextlib.suppress(BlockingIOError):
        while True:
            server.accept()[0].close()
            count += 1
    return count


def check_privileges(program, library):
    """A program with its owner's rights shows its caller nothing; the same program without them does."""
    if os.geteuid() != 0:
        skip("only root can give a program rights that its caller has not")
    with tempfile.TemporaryDirectory() as folder:
        os.chmod(folder, 0o755)
        # Where the caller can read them, wherever the build is.
        own_library = shutil.copy(pathlib.Path(library).resolve(), os.path.join(folder, "library.so"))
        os.chmod(own_library, 0o755)
        told = []
        for mode in (0o755, 0o4755, 0o2755):
            copy = shutil.copy(program, os.path.join(folder, f"program-{mode:o}"))
            os.chmod(copy, mode)
            with listener() as (server, path):
                done = run(copy, own_library, path, "1", user=NOBODY, group=NOBODY, extra_groups=[])
                expect(done.returncode, 0, f"exit status with mode {mode:o} ({done.stderr})")
                privileged = done.stdout == "privileged done\n"
                if mode != 0o755 and not privileged:
                    skip(f"{folder} does not give programs the rights of their owner")
                told.append((calls(server), bool(done.stderr)))
    expect(told, [(1, True), (0, False), (0, False)], "calls, and errors told, of a program, set-user-ID and set-group-ID")


def main():
    what, program, library = sys.argv[1:4]
    if what == "privileges":
        return check_privileges(program, library)
    check_slow_watcher(program, library)
    check_slow_watcher(program, library, "interrupted")
    check_silent_watcher(program, library)
    check_deaf_watcher(program, library)


if __name__ == "__main__":
    main()
