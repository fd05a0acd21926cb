#!/usr/bin/env python3
"""The benchmark's whole report, as little of it as shows that it runs: no figure is judged.

usage: report_test.py BUILD
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
BUILD = pathlib.Path(sys.argv.pop())
sys.path[:0] = [str(HERE), str(HERE / "null")]
import names  # noqa: E402
import parts  # noqa: E402
import report  # noqa: E402

LACKING = "/bin/false"  # as a Python: it has no MuJoCo


class Report(unittest.TestCase):
    """One run for all questions."""

    @classmethod
    def setUpClass(cls) -> None:
        with tempfile.TemporaryDirectory() as folder:
            cls.done = subprocess.run(
                [sys.executable, HERE / "report.py", "--build", BUILD, "--smoke", "--filter", "^(textured|lit|random.*)/(medium|large)$",
                 "--random", "6", "--seed", "11", "--mujoco-python", LACKING, "--output", folder], capture_output=True, text=True)
            cls.report, cls.page = {}, ""
            if cls.done.returncode == 0:
                cls.report = json.loads((pathlib.Path(folder) / "report.json").read_text())
                cls.page = (pathlib.Path(folder) / "report.html").read_text()

    def part(self, title: str) -> dict:
        return next(part for part in self.report["parts"] if part["title"] == title)

    def test_ends_well(self) -> None:
        self.assertEqual(self.done.returncode, 0, self.done.stdout + self.done.stderr)

    def test_random_states_are_a_population_with_their_seed(self) -> None:
        populations = {p["name"]: p for p in self.report["contenders"][0]["populations"]}
        self.assertEqual(set(populations), {"named", "random"})
        self.assertEqual(self.report["seed"], 11)
        self.assertIn("random states, seed 11", self.done.stdout)
        whole = populations["random"]["summaries"][-1]
        self.assertGreater(whole["geometric_mean"], 0)
        self.assertEqual(sum(bin["states"] for bin in whole["histogram"]), whole["states"])
        self.assertIn("random states</h2>", self.page)

    def test_an_instruction_set_that_is_not_there_is_no_report(self) -> None:
        done = subprocess.run([sys.executable, HERE / "report.py", "--build", BUILD, "--smoke", "--isa", "quantum", "--output",
                               tempfile.gettempdir()], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("not drawn with quantum", done.stderr)

    def test_slow_stages_are_counted(self) -> None:
        slow = self.report["contenders"][0]["populations"][0]["slow"]
        self.assertEqual(slow["of"], self.report["contenders"][0]["populations"][0]["summaries"][-1]["states"])
        self.assertRegex(self.done.stdout, rf"slow: {slow['states']} of {slow['of']} states")

    def test_what_is_missing_is_a_sentence(self) -> None:
        self.assertEqual(self.part("MuJoCo")["rows"], [])
        self.assertIn(f"{LACKING} has no MuJoCo", self.part("MuJoCo")["problem"])
        self.assertIn(f"{LACKING} has no MuJoCo", self.page)

    def test_each_part_has_rows_or_a_reason(self) -> None:
        titles = [part["title"] for part in self.report["parts"] if part["title"] != "Traces, without the start"]
        self.assertEqual(titles, ["MuJoCo", "Traces", "Programs"])
        for part in self.report["parts"]:
            self.assertTrue(part["rows"] or part["problem"], part["title"])
            for row in part["rows"]:
                self.assertTrue(all(run["rounds"] for run in row["runs"]) or row["note"], row)
                self.assertIn(f"<td>{row['name']}</td>", self.page)


class MuJoCo(unittest.TestCase):
    def test_draws_with_both_libraries_where_it_is_installed(self) -> None:
        settings = parts.Settings(BUILD.resolve(), [], rounds=1, smoke=True)
        part = report.mujoco_part(settings, sys.executable)
        if not part.rows:
            self.assertIn("not measured", part.problem)
            self.assertRegex(part.problem, "has no MuJoCo|is not installed")
            self.skipTest(part.problem)
        (row,) = part.rows
        self.assertEqual(set(row.times), {"terrazzo", "osmesa"})
        self.assertRegex(row.note, r"^\d")


class Pieces(unittest.TestCase):
    def test_each_round_has_all_in_turn(self) -> None:
        asked: list[str] = []
        times = parts.interleave(["a", "b"], 2, lambda name: asked.append(name) or float(len(asked)))
        self.assertEqual(asked, ["a", "b", "a", "b"])
        self.assertEqual(times, {"a": [1, 3], "b": [2, 4]})

    def test_each_instruction_set_is_a_contender(self) -> None:
        settings = parts.Settings(pathlib.Path("/"), ["avx2", "sse4"])
        self.assertEqual(settings.ours(), {"terrazzo avx2": {"TERRAZZO_ISA": "avx2", "TERRAZZO_THREADS": "0"},
                                           "terrazzo sse4": {"TERRAZZO_ISA": "sse4", "TERRAZZO_THREADS": "0"}})

    def test_the_tool_is_taken_off_replays(self) -> None:
        try:
            import traces
        except ImportError as error:
            self.skipTest(f"{error.name} is not installed")
        times = {"ours": [3.0, 1.0], "mesa": [5.0], traces.NULL: [0.5, 2.0, 0.25]}
        self.assertEqual(traces.net_of(times), {"ours": [2.5, 0.5], "mesa": [4.5]})
        self.assertEqual(traces.net_of({"ours": [1.0], traces.NULL: [2.0]}), {"ours": [traces.TICK]})

    def test_the_start_is_taken_off_where_enough_is_left(self) -> None:
        try:
            import traces
        except ImportError as error:
            self.skipTest(f"{error.name} is not installed")
        starts = {"ours": 0.5, "mesa": 1.0}
        self.assertEqual(traces.without_start(parts.Row("long", {"ours": [1.0], "mesa": [3.0]}), starts).times,
                         {"ours": [0.5], "mesa": [2.0]})
        short = traces.without_start(parts.Row("short", {"ours": [0.51], "mesa": [3.0]}), starts)
        self.assertEqual((short.times, short.note), ({}, "too short"))

    def test_programs_are_seconds_a_frame(self) -> None:
        program = {"name": "p", "fps": {"mesa": [50.0], "terrazzo": [100.0, 200.0]}, "within_one": [1.0, 0.999]}
        row = report.programs_row(program)
        self.assertEqual(row.times, {"mesa": [0.02], "terrazzo": [0.01, 0.005]})
        self.assertIn("99.900 %", row.note)
        self.assertEqual(report.programs_row(program | {"problem": "nothing seen", "within_one": []}).note, "nothing seen")

    def test_the_null_driver_leaves_out_what_its_source_defines(self) -> None:
        self.assertEqual(names.names(["EXPORT void* glMapBuffer(unsigned a);"], ["glEnd\nglMapBuffer\n", "eglFoo\nother\n"]),
                         ["eglFoo", "glEnd"])


unittest.main()
