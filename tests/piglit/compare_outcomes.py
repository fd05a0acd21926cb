#!/usr/bin/env python3
"""Runs Debian's piglit on the tests that outcomes.txt names and compares with the outcomes kept there.

usage: compare_outcomes.py --outcomes FILE [--filter REGEX] [--update] [--keep FOLDER]
Run by on_display.py, which chooses the library. Fails when a test ends worse than the file says, and when the library
that drew was not Terrazzo. --update writes what has come out into the file instead; --keep keeps piglit's own results.
Exits with 77, which meson takes for "skipped", when piglit is not installed.
"""
import argparse
import bz2
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

# From good to bad. A test that warns has passed.
ORDER = ["pass", "skip", "fail", "timeout", "crash", "notrun"]
PROGRESS = re.compile(r"\[(\d+)/(\d+)\]")


def read_outcomes(path):
    """Name -> outcome, in the file's order; lines that begin with # are for people."""
    out = {}
    for line in path.read_text().splitlines():
        if line and not line.startswith("#"):
            outcome, name = line.split(" ", 1)
            if outcome not in ORDER:
                sys.exit(f"{path}: no outcome: {line}")
            out[name] = outcome
    return out


def write_outcomes(path, found):
    lines = path.read_text().splitlines()
    kept = [line if not line or line.startswith("#") else f"{found.get(line.split(' ', 1)[1], line.split(' ', 1)[0])} "
            f"{line.split(' ', 1)[1]}" for line in lines]
    path.write_text("\n".join(kept) + "\n")


def run(names, folder):
    """Lets piglit run the tests one after the other; a line for every fiftieth says how far it is."""
    test_list = folder / "names.txt"
    test_list.write_text("\n".join(names) + "\n")
    command = ["piglit", "run", "opengl", "--platform", "mixed_glx_egl", "-1", "--timeout", "60", "-l", "quiet", "-o",
               "--test-list", str(test_list), str(folder / "results")]
    piglit = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    said = 0
    for line in piglit.stdout:
        done = PROGRESS.search(line)
        if done and int(done[1]) // 50 > said:
            said = int(done[1]) // 50
            print(line.strip(), flush=True)
    piglit.wait()
    results = next((folder / "results").glob("results.json*"), None)
    if not results:
        sys.exit("piglit left no results")
    with (bz2.open if results.suffix == ".bz2" else open)(results) as file:
        return json.load(file)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--outcomes", type=pathlib.Path, required=True)
    parser.add_argument("--filter", default="")
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_args()
    if not shutil.which("piglit"):
        print("skipped: piglit is not installed")
        sys.exit(77)
    expected = {n: o for n, o in read_outcomes(options.outcomes).items() if re.search(options.filter, n)}
    if not expected:
        sys.exit("no test matches")
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.keep or pathlib.Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        shutil.rmtree(folder / "results", ignore_errors=True)
        results = run(expected, folder)
    if "Terrazzo" not in json.dumps(results.get("info", {})):
        sys.exit("another library than Terrazzo answered")
    found = {name: "pass" if test["result"] == "warn" else test["result"] for name, test in results["tests"].items()}
    if options.update:
        return write_outcomes(options.outcomes, found)
    worse, better = [], []
    for name, outcome in expected.items():
        now = found.get(name, "notrun")
        rank = ORDER.index(now) if now in ORDER else len(ORDER)
        if rank > ORDER.index(outcome):
            worse.append(f"{name}: {now}, was {outcome}")
        elif rank < ORDER.index(outcome):
            better.append(f"{name}: {now}, was {outcome}")
    counts = {outcome: sum(found.get(name, "notrun") == outcome for name in expected) for outcome in ORDER}
    print(", ".join(f"{count} {outcome}" for outcome, count in counts.items() if count))
    for line in better:
        print("better:", line)
    for line in worse:
        print("worse:", line)
    sys.exit(1 if worse else 0)


if __name__ == "__main__":
    main()
