#!/usr/bin/env python3
"""Writes Terrazzo's GL entry points into a build folder.

Input: the Khronos registry (gl.xml), the policy (tools/policy.toml) and the names to export
(tools/osmesa-exports.txt). Output: commands.h, dispatch.h, tables.cpp, entries.cpp, osmesa.map.
Every output is a function of these inputs alone.
"""

import argparse
import pathlib

from generator import emit
from generator.policy import Policy
from generator.registry import Registry


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--registry", required=True)
    parser.add_argument("--policy", required=True)
    parser.add_argument("--exports", required=True)
    parser.add_argument("--out", required=True, type=pathlib.Path)
    options = parser.parse_args()

    exports = pathlib.Path(options.exports).read_text().split()
    policy = Policy(options.policy, Registry(options.registry), exports)
    outputs = {
        "commands.h": emit.commands_header(policy),
        "dispatch.h": emit.dispatch_header(policy),
        "tables.cpp": emit.tables_source(policy),
        "entries.cpp": emit.entries_source(policy),
        "osmesa.map": emit.version_script(exports),
    }
    options.out.mkdir(parents=True, exist_ok=True)
    for name, text in outputs.items():
        (options.out / name).write_text(text)


if __name__ == "__main__":
    main()
