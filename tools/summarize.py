#!/usr/bin/env python3
"""Closing lines of ./check: the time of each suite, what failed, by name, and the line "N passed, N failed, N skipped".

Input: build folders in which `meson test` ran. Meson's testlog.json says how each test program ended; where a program
names its test cases (gtest), testlog.junit.xml has them and they are counted instead of the program. A program that
fails without naming a failed case (a crash, a time-out) counts as one failure. A folder without a log is one failure:
something that should have run did not. The time of a suite is the sum over its programs, of which several run at once; a
program of two suites counts in the first that its meson.build names.
"""
import json
import pathlib
import sys
import xml.etree.ElementTree as ElementTree

GOOD = {"OK", "EXPECTEDFAIL"}


def case_outcome(case):
    if case.find("failure") is not None or case.find("error") is not None:
        return "failed"
    return "skipped" if case.find("skipped") is not None or case.get("result") == "suppressed" else "passed"


def cases_by_program(junit):
    """Program name -> [(case name, outcome)] for programs that report their own cases."""
    programs = {}
    if not junit.is_file():
        return programs
    for suite in ElementTree.parse(junit).getroot().iter("testsuite"):
        name = suite.get("name", "")
        program, dot, _ = name.partition(".")[2].rpartition(".")
        if not dot:
            continue  # meson's own grouping of programs that report nothing but an exit code
        programs.setdefault(program, []).extend(
            (f"{case.get('classname')}.{case.get('name')}", case_outcome(case)) for case in suite.iter("testcase"))
    return programs


def outcomes_of(folder):
    logs = pathlib.Path(folder) / "meson-logs"
    log = logs / "testlog.json"
    if not log.is_file():
        yield f"{folder}: built or ran no test", "failed"
        return
    inner = cases_by_program(logs / "testlog.junit.xml")
    for line in log.read_text().splitlines():
        test = json.loads(line)
        name, result = test["name"], test["result"]
        cases = inner.get(name, [])
        yield from ((f"{folder}: {name}: {case}", outcome) for case, outcome in cases)
        if result == "SKIP":
            yield f"{folder}: {name}", "skipped"
        elif result not in GOOD:
            if not any(outcome == "failed" for _, outcome in cases):
                yield f"{folder}: {name} ({result.lower()})", "failed"
        elif not cases:
            yield f"{folder}: {name}", "passed"


def seconds_by_suite(folder):
    """Suite -> seconds that its programs ran, the longest first."""
    log = pathlib.Path(folder) / "meson-logs" / "testlog.json"
    seconds = {}
    for line in log.read_text().splitlines() if log.is_file() else ():
        test = json.loads(line)
        # "project:suite+suite / name"
        suite = test["name"].partition(" / ")[0].rpartition(":")[2].partition("+")[0]
        seconds[suite] = seconds.get(suite, 0) + test["duration"]
    return dict(sorted(seconds.items(), key=lambda item: -item[1]))


def main():
    counts = dict.fromkeys(("passed", "failed", "skipped"), 0)
    for folder in sys.argv[1:]:
        times = [f"{suite} {seconds:.0f} s" for suite, seconds in seconds_by_suite(folder).items()]
        if times:
            print(f"{folder}: " + ", ".join(times))
        for name, outcome in outcomes_of(folder):
            counts[outcome] += 1
            if outcome != "passed":
                print(f"{outcome}: {name}")
    print(", ".join(f"{count} {outcome}" for outcome, count in counts.items()))
    sys.exit(1 if counts["failed"] or not counts["passed"] else 0)


main()
