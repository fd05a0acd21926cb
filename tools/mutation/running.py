"""Runs the tests of a build folder, one program at a time, with a fault on or with the places it comes by noted.

Input: a configured and built folder, suites. Output: for each test how long it takes and which faults it reaches; for
a fault the first test that notices it. Tests that reach a fault are tried cheapest first; one that fails without any
fault is left out and named.
"""
import dataclasses
import json
import os
import signal
import subprocess
import tempfile
import time


@dataclasses.dataclass
class Test:
    name: str
    command: list
    environment: dict
    folder: str
    suites: set
    targets: set  # what must be built for it
    seconds: float = 0.0
    reached: frozenset = frozenset()
    usable: bool = False


def introspect(folder, what):
    answer = subprocess.run(["meson", "introspect", what, str(folder)], check=True, capture_output=True, text=True)
    return json.loads(answer.stdout)


def targets_of(folder):
    """Identification -> (type, file) of what can be built, the file relative to the folder."""
    return {target["id"]: (target["type"], os.path.relpath(target["filename"][0], folder))
            for target in introspect(folder, "--targets")}


def tests_of(folder):
    targets = targets_of(folder)
    for entry in introspect(folder, "--tests"):
        suites = {suite.split(":")[-1] for suite in entry["suite"]}
        name = f"{sorted(suites)[0]}:{entry['name']}"
        yield Test(name, lean([str(part) for part in entry["cmd"]]), dict(entry["env"]), entry["workdir"] or str(folder), suites,
                   {targets[target][1] for target in entry["depends"]})


def lean(command):
    """One instruction set is built, and faults are the same for all: the scenes are drawn with the widest alone."""
    if not any(part.endswith("/piglit-lite") for part in command) or "--isa" not in command:
        return command
    place = command.index("--isa")
    return command[:place] + command[place + 2:]


def run(test, limit, more):
    """passed, failed or hangs; and the seconds it took."""
    environment = {**os.environ, **test.environment, "GTEST_FAIL_FAST": "1", "GTEST_BRIEF": "1", **more}
    begin = time.monotonic()
    process = subprocess.Popen(test.command, cwd=test.folder, env=environment, stdin=subprocess.DEVNULL,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
    try:
        code = process.wait(timeout=limit)
        outcome = "passed" if code in (0, 77) else "failed"
    except subprocess.TimeoutExpired:
        outcome = "hangs"
    try:
        os.killpg(process.pid, signal.SIGKILL)  # what the test left behind, in the group that was made for it
    except ProcessLookupError:
        pass
    process.wait()
    return outcome, time.monotonic() - begin


def measure(test, count):
    """Without a fault: the time, and the places that the test comes by."""
    with tempfile.NamedTemporaryFile() as reached:
        reached.write(bytes(count + 1))
        reached.flush()
        # Threads that come by the same place note it at the same time: no race of the library's.
        outcome, test.seconds = run(test, 900, {"TERRAZZO_MUTANTS_REACHED": reached.name, "TSAN_OPTIONS": "report_bugs=0"})
        with open(reached.name, "rb") as file:
            test.reached = frozenset(number for number, hit in enumerate(file.read()) if hit)
    test.usable = outcome == "passed"
    return test


def judge(fault, tests):
    """-> (outcome, test that noticed it, seconds)."""
    able = sorted((test for test in tests if test.usable and fault.number in test.reached), key=lambda t: t.seconds)
    begin = time.monotonic()
    for test in able:
        outcome, _ = run(test, 30 + 8 * test.seconds, {"TERRAZZO_MUTANT": str(fault.number)})
        if outcome != "passed":
            return "noticed", f"{test.name}{' (hangs)' if outcome == 'hangs' else ''}", time.monotonic() - begin
    return ("survived" if able else "not reached"), "", time.monotonic() - begin
