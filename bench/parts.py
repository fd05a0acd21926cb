"""What the report of the benchmark takes besides states: a part is a table of times, read by `terrazzo bench states --with`.

A part has contenders, the last of which is the baseline, and rows with each contender's times in seconds, one a round,
measured in turn. What cannot be measured here is a part without rows, and a sentence that says why.
"""

import dataclasses
import json
import pathlib
from collections.abc import Callable, Sequence


@dataclasses.dataclass
class Row:
    name: str
    times: dict[str, list[float]]  # by contender
    note: str = ""


@dataclasses.dataclass
class Part:
    title: str
    about: str
    contenders: list[str]
    rows: list[Row] = dataclasses.field(default_factory=list)
    problem: str = ""


def interleave(contenders: Sequence[str], rounds: int, measure: Callable[[str], float]) -> dict[str, list[float]]:
    """Times by contender; each round has all of them in turn, so that a machine that slows down slows all."""
    times: dict[str, list[float]] = {name: [] for name in contenders}
    for _ in range(rounds):
        for name in contenders:
            times[name].append(measure(name))
    return times


def write(path: pathlib.Path, parts: Sequence[Part]) -> None:
    path.write_text(json.dumps([dataclasses.asdict(part) for part in parts], indent=1) + "\n")


@dataclasses.dataclass
class Settings:
    """What every part is measured with."""

    build: pathlib.Path
    isas: list[str]  # TERRAZZO_ISA of each contender of ours; empty: the library's choice alone
    rounds: int = 5
    smoke: bool = False  # as little as shows that it runs

    def ours(self) -> dict[str, dict[str, str]]:
        """The variables that make each contender of ours, one thread."""
        names = {f"terrazzo {isa}": {"TERRAZZO_ISA": isa} for isa in self.isas} or {"terrazzo": {}}
        return {name: variables | {"TERRAZZO_THREADS": "0"} for name, variables in names.items()}


THEIRS = {"LP_NUM_THREADS": "0"}
