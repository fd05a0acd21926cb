#!/usr/bin/env python3
"""Programs with windows, drawn by Terrazzo and by Mesa's llvmpipe: pictures and frames a second, for the demo's report.

usage: programs.py [--build FOLDER] [--output FOLDER] [--rounds N] [NAME...]
Each program runs on Terrazzo for some seconds, on an X server of its own, while apitrace writes down what it draws. That
is then drawn again by both, so that both draw the same frames: pictures of some, and all of them as fast as they can,
interleaved. Output: FOLDER/programs.json and the pictures it names. What is not installed is said and left out. Nothing
but glxgears and `terrazzo view` comes with the demo's own packages; the others are the group "programs" in
tools/packages.sh.
"""

import argparse
import json
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parents[1] / "tests" / "windows"), str(HERE.parents[1] / "tests" / "programs")]
import known  # noqa: E402
import on_display  # noqa: E402

PICTURES = 3
MODELS = pathlib.Path("/usr/share/assimp/models/glTF2")
# name: seconds, whether through EGL, command, description. Few seconds for those that draw thousands of frames in one.
PROGRAMS = {
    "glxgears": (0.7, False, ["glxgears", "-geometry", "800x600"], "The program everybody starts first. GLX, display lists"),
    "terrazzo view": (2.5, False, ["terrazzo", "view", "--system", "--fps", "--size", "800x600",
                                   str(MODELS / "2CylinderEngine-glTF-Binary/2CylinderEngine.glb")],
                      "The model viewer of this project, a GLFW program like any other. GLX, vertex arrays"),
    "moebiusgears": (3, True, ["moebiusgears", "-window"], "A screen saver: a ring of an odd number of gears. EGL, display lists"),
    "glschool": (3, True, ["glschool", "-window"], "A screen saver: a school of fish in fog. EGL, display lists"),
    "endgame": (3, True, ["endgame", "-window"], "A screen saver: endings of games of chess. EGL, reflections through the stencil buffer"),
    "lattice": (3, False, ["lattice", "-window"], "A screen saver: a flight through a lattice of rings. GLX, display lists"),
    "osgshape": (3, False, ["osgshape"], "OpenSceneGraph shows the shapes it knows. GLX"),
    "gltron": (5, False, ["gltron"], "A game on light cycles: its first menu. SDL 1.2"),
    "chromium-bsu": (6, False, ["chromium-bsu", "--noaudio"], "A shooting game: its title. SDL 2, blended sprites"),
    "billard-gl": (5, False, ["billard-gl"], "A game of billiards. GLUT"),
    "neverball": (8, False, ["neverball"], "A game: the flight behind its title. SDL 2, buffer objects, sphere maps, shadows through the stencil buffer"),
}


def command_of(command, build):
    """With the program's path; None when something that it names is not there."""
    program = build / "tools/terrazzo/terrazzo" if command[0] == "terrazzo" else known.find(command[0])
    there = program and all(pathlib.Path(word).exists() for word in command[1:] if word.startswith("/"))
    return [str(program), *command[1:]] if there else None


def renderer_of(environment):
    answer = subprocess.run(["glxinfo", "-B"], env=environment, capture_output=True, text=True).stdout
    found = re.search(r"OpenGL renderer string: (.*)", answer)
    return found.group(1) if found else "none"


def frames_a_second(trace, environment, replay):
    tool = replay.tool_for(trace, environment)
    output = replay.run([tool, "--benchmark", str(trace)], environment, timeout=120).stdout
    found = re.search(r"average of ([\d.]+) fps", output)
    return float(found.group(1)) if found else None


def draw(name, command, environments, output, rounds, replay, seconds=None):
    """What the report says of one program."""
    usual, egl, _, about = PROGRAMS[name]
    seconds = seconds or usual
    report = {"name": name, "about": about, "frames": 0, "within_one": [], "largest": 0, "fps": {"mesa": [], "terrazzo": []}}
    with tempfile.TemporaryDirectory() as home:
        mesa, ours = (environment | known.belongings(home) for environment in environments)
        trace = pathlib.Path(home) / "program.trace"
        known.record(trace, command, seconds, ours | {"vblank_mode": "0"}, egl)
        pictures = pathlib.Path(home) / "pictures"
        lines = replay.compare(trace, mesa, ours, PICTURES, keep=pictures) if trace.exists() else []
        if not lines:
            return report | {"problem": "it showed no frame that can be repeated"}
        report["frames"] = len(replay.calls_named(trace, "SwapBuffers", mesa))
        report["within_one"] = [share for _, share, _, _ in lines]
        report["largest"] = max(largest for _, _, largest, _ in lines)
        call = lines[len(lines) // 2][0]
        for side, folder in (("mesa", "theirs"), ("terrazzo", "ours")):
            for picture in (pictures / folder).glob("*.png"):
                if int(picture.stem) == call:
                    report[side] = f"{name.replace(' ', '-')}-{side}.png"
                    shutil.copy(picture, output / report[side])
        for _ in range(rounds):
            for side, environment in (("mesa", mesa), ("terrazzo", ours)):
                rate = frames_a_second(trace, environment, replay)
                if rate:
                    report["fps"][side].append(rate)
    return report


def summary(report):
    if "problem" in report:
        return f"{report['name']:<15} {report['problem']}"
    mesa, ours = (statistics.median(report["fps"][side]) if report["fps"][side] else 0 for side in ("mesa", "terrazzo"))
    ratio = f"{ours / mesa:.2f}x" if mesa and ours else "-"
    return (f"{report['name']:<15} {100 * min(report['within_one']):.3f} % within 1/255    Mesa {mesa:7.1f}   "
            f"Terrazzo {ours:7.1f} frames a second   {ratio}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=HERE.parents[1] / "build")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("out/demo/programs"))
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--seconds", type=float, help="how long each program is recorded, instead of its own time")
    parser.add_argument("names", nargs="*", default=list(PROGRAMS), metavar="NAME")
    options = parser.parse_args()
    try:
        import replay
    except ImportError as error:
        sys.exit(f"{error.name} is not installed")
    build, output = options.build.resolve(), options.output.resolve()
    output.mkdir(parents=True, exist_ok=True)
    commands = {name: command_of(PROGRAMS[name][2], build) for name in options.names}
    absent = [name for name, command in commands.items() if not command]
    report = {"absent": absent, "programs": []}
    with on_display.xvfb(size="1280x1024") as display:
        environments = [on_display.environment(display),
                        on_display.environment(display, vendor=build / "src/frontends/vendor")]
        report["renderers"] = [renderer_of(environment) for environment in environments]
        if "Terrazzo" in report["renderers"][0] or not report["renderers"][1].startswith("Terrazzo"):
            sys.exit(f"the libraries are not the two to be compared: {report['renderers']}")
        for name, command in commands.items():
            if command:
                report["programs"].append(draw(name, command, environments, output, options.rounds, replay, options.seconds))
                print(summary(report["programs"][-1]), flush=True)
    if absent:
        print("not installed and left out:", ", ".join(absent))
    (output / "programs.json").write_text(json.dumps(report, indent=1) + "\n")


if __name__ == "__main__":
    main()
