"""MuJoCo's classic renderer through OSMesa, ours beside Debian's: a part of the benchmark's report."""

import os
import pathlib
import subprocess
import tempfile

import numpy
import parts

HERE = pathlib.Path(__file__).resolve().parent
SIZES = [(640, 480), (64, 64)]
ABOUT = ("MuJoCo's renderer through OSMesa, one thread: 36 bodies, shadows (4096x4096), a floor that reflects, 4 samples a "
         "pixel. Processor time of render().")


class Child:
    def __init__(self, python: str, size: tuple[int, int], shadow: int, environment: dict[str, str]) -> None:
        self._process = subprocess.Popen([python, HERE / "scene.py", *map(str, size), str(shadow)], env=environment, text=True,
                                         stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        self.renderer = self._answer()

    def _answer(self) -> str:
        assert self._process.stdout
        return self._process.stdout.readline().strip()

    def ask(self, question: str) -> str:
        assert self._process.stdin
        self._process.stdin.write(question + "\n")
        self._process.stdin.flush()
        return self._answer()

    def frame(self, count: int) -> float:
        return float(numpy.median([float(word) for word in self.ask(f"frames {count}").split()])) / 1e3

    def picture(self) -> numpy.ndarray:
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "picture.npy"
            self.ask(f"picture {path}")
            return numpy.load(path).astype(int)

    def end(self) -> None:
        self._process.communicate(timeout=30)


def library_path(folder: pathlib.Path | None) -> dict[str, str]:
    rest = {name: value for name, value in os.environ.items() if name != "LD_LIBRARY_PATH"}
    rest |= {"MUJOCO_GL": "osmesa", "PYOPENGL_PLATFORM": "osmesa"}
    return rest | ({"LD_LIBRARY_PATH": str(folder)} if folder else {})


def has_mujoco(python: str) -> bool:
    try:
        return subprocess.run([python, "-c", "import mujoco, numpy, OpenGL"], env=library_path(None), capture_output=True,
                              timeout=60).returncode == 0
    except OSError:
        return False


def describe(ours: numpy.ndarray, theirs: numpy.ndarray) -> str:
    """In words, how far pictures are apart; both must show something."""
    if ours.shape != theirs.shape or ours.min() == ours.max():
        return "no picture"
    return f"{100 * (abs(ours - theirs) > 1).mean():.3f} % of the values differ by more than 1/255"


def measure_size(settings: parts.Settings, python: str, size: tuple[int, int]) -> parts.Row:
    folder = settings.build / "src/frontends/osmesa"
    environments = {name: library_path(folder) | variables for name, variables in settings.ours().items()}
    environments["osmesa"] = library_path(None) | parts.THEIRS
    shadow, frames = (256, 1) if settings.smoke else (4096, 4)
    children = {name: Child(python, size, shadow, environment) for name, environment in environments.items()}
    try:
        for name, child in children.items():
            if ("Terrazzo" in child.renderer) != (name != "osmesa"):
                raise RuntimeError(f"{name} is not what draws: {child.renderer or 'nothing does'}")
        theirs = children["osmesa"].picture()
        notes = [describe(child.picture(), theirs) for name, child in children.items() if name != "osmesa"]
        times = parts.interleave(list(children), settings.rounds, lambda name: children[name].frame(frames))
    finally:
        for child in children.values():
            child.end()
    return parts.Row(f"{size[0]}x{size[1]}", times, "; ".join(dict.fromkeys(notes)))


def part(settings: parts.Settings, python: str) -> parts.Part:
    result = parts.Part("MuJoCo", ABOUT, [*settings.ours(), "osmesa"])
    if not has_mujoco(python):
        result.problem = f"not measured: {python} has no MuJoCo (packages mujoco and PyOpenGL of PyPI)"
        return result
    try:
        result.rows = [measure_size(settings, python, size) for size in (SIZES[1:] if settings.smoke else SIZES)]
    except (RuntimeError, OSError, ValueError, subprocess.SubprocessError) as error:
        result.problem = f"not measured: {error}"
    return result
