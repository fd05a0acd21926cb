#!/usr/bin/env python3
"""One report of how fast Terrazzo is beside Debian's Mesa: states, random states, MuJoCo, traces, programs with windows.

usage: report.py [--isa avx512,avx2,sse4] [--traces FOLDER] [--programs FOLDER] [--mujoco-python PATH] [--output FOLDER] ...
Writes FOLDER/report.html and FOLDER/report.json. Everything is measured in turn with the reference, with one thread;
ratios are medians. What is not installed is said in its part and left out. Run it on a machine that does nothing else.
"""

import argparse
import json
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent
sys.path[:0] = [str(HERE), str(HERE / "windows")]
import parts  # noqa: E402

PROGRAMS_ABOUT = ("Real programs, not changed: what they drew was recorded and is drawn again by both, as fast as they can, in a "
                  "window of one X server. Seconds a frame, the tool that reads the recording included; both with a thread a core.")


def mujoco_part(settings: parts.Settings, python: str) -> parts.Part:
    sys.path.insert(0, str(HERE / "mujoco"))
    try:
        import measure
    except ImportError as error:
        return parts.Part("MuJoCo", "", [], problem=f"not measured: {error.name} is not installed for {sys.executable}")
    return measure.part(settings, python)


def traces_parts(settings: parts.Settings, folder: pathlib.Path | None) -> list[parts.Part]:
    try:
        import traces
        return traces.measure(settings, folder)
    except ImportError as error:
        reason = f"{error.name} is not installed for {sys.executable}"
    except SystemExit:
        reason = "there is no X server to be had (Xvfb)"
    except RuntimeError as error:
        reason = str(error)
    return [parts.Part("Traces", "", [], problem=f"not measured: {reason}")]


def programs_row(program: dict) -> parts.Row:
    """From what bench/windows/programs.py says of one."""
    fps = program["fps"]
    times = {name: [1 / rate for rate in fps[side]] for name, side in (("terrazzo", "terrazzo"), ("mesa", "mesa"))}
    within = f"{100 * min(program['within_one']):.3f} % of the pixels within 1/255" if program["within_one"] else ""
    return parts.Row(program["name"], times, program.get("problem", within))


def programs_part(settings: parts.Settings, folder: pathlib.Path | None, output: pathlib.Path) -> parts.Part:
    result = parts.Part("Programs", PROGRAMS_ABOUT, ["terrazzo", "mesa"])
    if not folder:
        folder = output / "programs"
        command = [sys.executable, HERE / "windows/programs.py", "--build", settings.build, "--output", folder,
                   "--rounds", "1" if settings.smoke else "3", *(["--seconds", "0.1", "glxgears"] if settings.smoke else [])]
        done = subprocess.run(list(map(str, command)), capture_output=settings.smoke, text=True)
        if done.returncode != 0:
            result.problem = "not measured: bench/windows/programs.py did not end well"
            return result
    try:
        programs = json.loads((folder / "programs.json").read_text())
    except OSError as error:
        result.problem = f"not measured: {error}"
        return result
    result.rows = [programs_row(program) for program in programs["programs"]]
    if programs["absent"]:
        result.about += " Not installed and left out: " + ", ".join(programs["absent"]) + "."
    if not result.rows:
        result.problem = "not measured: none is installed"
    return result


def has_instruction_sets(options: argparse.Namespace) -> bool:
    """A library that has not one that is asked for takes another; asked before hours are measured."""
    command = [options.build / "tools/terrazzo/terrazzo", "bench", "states", "--smoke", "--quiet", "-f", "^plain/medium$",
               *(["--isa", options.isa] if options.isa else [])]
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    if done.returncode != 0:
        print(done.stderr.strip(), file=sys.stderr)
    return done.returncode == 0


def states_command(options: argparse.Namespace, output: pathlib.Path) -> list[str]:
    command = [options.build / "tools/terrazzo/terrazzo", "bench", "states", "--quiet", "--random", options.random, "--seed",
               options.seed, "--with", output / "parts.json", "--json", output / "report.json", "--html", output / "report.html"]
    if options.isa:
        command += ["--isa", options.isa]
    if options.filter:
        command += ["--filter", options.filter]
    command += ["--smoke", "--check"] if options.smoke else ["--rounds", options.rounds]
    return list(map(str, command))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("out/report"))
    parser.add_argument("--isa", default="", help="TERRAZZO_ISA, several between commas; the library's choice if not given")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--random", type=int, default=100, help="how many random states")
    parser.add_argument("--seed", type=int, default=1, help="of the random states")
    parser.add_argument("--filter", default="", help="only states whose names this regular expression finds")
    parser.add_argument("--traces", type=pathlib.Path, help="a folder of apitrace traces")
    parser.add_argument("--programs", type=pathlib.Path, help="a folder that bench/windows/programs.py wrote: not measured again")
    parser.add_argument("--mujoco-python", default=sys.executable, help="a Python that has the package mujoco")
    parser.add_argument("--only", nargs="*", default=["mujoco", "traces", "programs"], choices=["mujoco", "traces", "programs"],
                        help="of the parts beside states")
    parser.add_argument("--smoke", action="store_true", help="as little as shows that it runs; --check of states")
    options = parser.parse_args()
    options.build = options.build.resolve()
    output = options.output.resolve()
    output.mkdir(parents=True, exist_ok=True)
    settings = parts.Settings(options.build, [isa for isa in options.isa.split(",") if isa],
                              1 if options.smoke else options.rounds, options.smoke)
    if not has_instruction_sets(options):
        sys.exit(1)
    found = []
    if "mujoco" in options.only:
        found.append(mujoco_part(settings, options.mujoco_python))
    if "traces" in options.only:
        found += traces_parts(settings, options.traces)
    if "programs" in options.only:
        found.append(programs_part(settings, options.programs, output))
    parts.write(output / "parts.json", found)
    sys.exit(subprocess.run(states_command(options, output)).returncode)


if __name__ == "__main__":
    main()
