"""Programs that people know, as Debian installs them: where they are, what they need to start, a trace of what they draw."""

import os
import shutil
import subprocess

PLACES = ["/usr/games", "/usr/libexec/xscreensaver", "/usr/lib/xscreensaver"]


def find(program):
    """Its path; None when it is not installed."""
    return shutil.which(program, path=os.pathsep.join([os.environ.get("PATH", ""), *PLACES]))


def belongings(home):
    """Variables that give a program a home and a language of its own, and no sound: some do not start without."""
    return {"HOME": str(home), "LANG": "C.UTF-8", "USER": "user", "SDL_AUDIODRIVER": "dummy", "ALSOFT_DRIVERS": "null"}


def record(trace, command, seconds, environment, egl=False):
    """Traces what a program does in its first seconds with whatever library `environment` gives it."""
    subprocess.run(["timeout", "-s", "TERM", str(seconds), "apitrace", "trace", "--api", "egl" if egl else "gl", "-o", trace,
                    *command], env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=seconds + 60)
