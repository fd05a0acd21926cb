"""Traces of programs, replayed by both drivers and by one that does nothing: parts of the benchmark's report.

What a replay takes is the tool's time and the driver's. The tool's is what it takes with a driver that does nothing
(bench/null), and is taken off.
"""

import contextlib
import pathlib
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Iterator

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE.parents[1] / "tests" / "windows"), str(HERE.parents[1] / "tests" / "programs")]
import on_display  # noqa: E402
import parts  # noqa: E402

OTHER_APIS = "es1-"  # OpenGL ES 1.1 is not offered
NULL = "null driver"
SHORTEST = 0.02
TICK = 0.004
ABOUT = ("Traces of programs, replayed with one thread by Mesa's llvmpipe and by Terrazzo in windows of one X server. Processor "
         "time of the whole replay, without what it takes with a driver that does nothing.")


def cpu_of(command: list[str], environment: dict[str, str]) -> float:
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=900)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        raise RuntimeError(f"{command[0]} ended with {done.returncode}")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


@contextlib.contextmanager
def null_libraries(build: pathlib.Path) -> Iterator[str]:
    """A folder where a loader finds the null driver by the names of the system's libraries."""
    with tempfile.TemporaryDirectory() as folder:
        for name in ("libGL.so.1", "libEGL.so.1", "libGL.so", "libEGL.so"):
            (pathlib.Path(folder) / name).symlink_to(build / "bench/libnull_driver.so")
        yield folder


def net_of(times: dict[str, list[float]]) -> dict[str, list[float]]:
    """Without the null driver's median. Less than the scheduler's tick is no time to divide by."""
    tool = statistics.median(times[NULL])
    return {name: [max(time - tool, TICK) for time in values] for name, values in times.items() if name != NULL}


def without_start(row: parts.Row, starts: dict[str, float]) -> parts.Row:
    """The frames alone. What they take must be more than the start's own scatter."""
    times = {name: [time - starts[name] for time in values] for name, values in row.times.items()}
    if min(map(statistics.median, times.values())) < SHORTEST:
        return parts.Row(row.name, {}, "too short")
    return parts.Row(row.name, times)


class Replays:
    def __init__(self, environments: dict[str, dict[str, str]], rounds: int) -> None:
        self._environments = environments
        self._rounds = rounds

    def times(self, command: list[str]) -> dict[str, list[float]]:
        return parts.interleave(list(self._environments), self._rounds, lambda name: cpu_of(command, self._environments[name]))

    def row(self, trace: pathlib.Path, tool: str) -> parts.Row:
        times = self.times([tool, "--headless", "-b", str(trace)])
        return parts.Row(trace.stem, net_of(times), f"tool alone {statistics.median(times[NULL]):.3f} s")

    def starts(self, build: pathlib.Path) -> dict[str, float]:
        """What a context and a first small frame take."""
        times = net_of(self.times([str(build / "bench/swap_cost"), "16", "16", "1"]))
        return {name: statistics.median(values) for name, values in times.items()}


def missing(build: pathlib.Path) -> str:
    for tool in ("Xvfb", "apitrace", "glretrace", "eglretrace"):
        if not shutil.which(tool):
            return f"{tool} is not installed"
    built = all((build / "bench" / name).exists() for name in ("libnull_driver.so", "swap_cost"))
    return "" if built else f"{build} was built without windows"


def record_gears(folder: pathlib.Path, environment: dict[str, str]) -> None:
    """A trace of some frames, for a run that only shows that all is there."""
    import known
    known.record(folder / "glxgears.trace", ["glxgears", "-geometry", "64x64"], 0.2, environment | {"vblank_mode": "0"})


def frames_part(whole: parts.Part, starts: dict[str, float]) -> parts.Part:
    told = ", ".join(f"{name} {1e3 * time:.0f} ms" for name, time in starts.items())
    about = ("The same without what each driver takes to start, to compile its first shader and to show a first small frame "
             f"({told}), which is most of a trace of a few frames. Left out where less than {1e3 * SHORTEST:.0f} ms are left.")
    return parts.Part("Traces, without the start", about, whole.contenders, [without_start(row, starts) for row in whole.rows],
                      whole.problem)


def measure(settings: parts.Settings, folder: pathlib.Path | None) -> list[parts.Part]:
    result = parts.Part("Traces", ABOUT, [*settings.ours(), "mesa"])
    lacking = missing(settings.build)
    if lacking or not (folder or settings.smoke):
        result.problem = f"not measured: {lacking or 'no folder of traces was given (--traces)'}"
        return [result]
    import replay
    left_out = []
    with on_display.xvfb(size="1280x1024") as display, null_libraries(settings.build) as null, \
            tempfile.TemporaryDirectory() as recorded:
        system = on_display.environment(display)
        vendor = on_display.environment(display, vendor=settings.build / "src/frontends/vendor")
        environments = {name: vendor | variables for name, variables in settings.ours().items()}
        environments |= {"mesa": system | parts.THEIRS, NULL: system | {"LD_LIBRARY_PATH": null}}
        replays = Replays(environments, settings.rounds)
        starts = replays.starts(settings.build)
        if settings.smoke:
            folder = pathlib.Path(recorded)
            record_gears(folder, vendor)
        for trace in sorted(folder.glob("*.trace")) if folder else []:
            if trace.stem.startswith(OTHER_APIS) or not replay.frames_of(trace, system, 1)[0]:
                left_out.append(trace.stem)
                continue
            try:
                result.rows.append(replays.row(trace, replay.tool_for(trace, system)))
                print("trace", trace.stem, flush=True)
            except (RuntimeError, subprocess.SubprocessError) as error:
                left_out.append(f"{trace.stem} ({error})")
    if left_out:
        result.about += " Left out, of another interface or without a frame: " + ", ".join(left_out) + "."
    if not result.rows:
        result.problem = f"not measured: no trace in {'a recording' if settings.smoke else folder} could be replayed"
    return [result, frames_part(result, starts)]
