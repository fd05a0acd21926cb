#!/usr/bin/env python3
"""Writes Terrazzo's GL entry points into a build folder.

Input: the Khronos registry (gl.xml), the policy (tools/policy.toml) and the names to export
(tools/osmesa-exports.txt, tools/libgl-exports.txt, tools/libegl-exports.txt,
tools/vendor-exports.txt). Output: the headers and sources that src/gl/generated/meson.build lists, or the fuzzer's
table of commands.
Every output is a function of these inputs alone.
"""

import argparse
import pathlib
import sys

from generator import calls, dispatch, fuzz_table, lists
from generator.policy import Policy, PolicyError
from generator.registry import Registry


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--registry", required=True)
    parser.add_argument("--policy", required=True)
    parser.add_argument("--osmesa-exports", required=True)
    parser.add_argument("--libgl-exports", required=True)
    parser.add_argument("--libegl-exports", required=True)
    parser.add_argument("--vendor-exports", required=True)
    parser.add_argument("--fuzz-table", action="store_true", help="write the fuzzer's table instead")
    parser.add_argument("--out", required=True, type=pathlib.Path)
    options = parser.parse_args()

    osmesa, libgl, libegl, vendor = (pathlib.Path(path).read_text().split()
                                     for path in (options.osmesa_exports, options.libgl_exports,
                                                  options.libegl_exports, options.vendor_exports))
    try:
        policy = Policy(options.policy, Registry(options.registry), osmesa, libgl)
        if options.fuzz_table:
            outputs = fuzz_table.outputs(policy)
        else:
            outputs = dispatch.outputs(policy, libegl, vendor) | lists.outputs(policy) | calls.outputs(policy)
    except PolicyError as error:
        sys.exit(f"{options.policy}: {error}")
    options.out.mkdir(parents=True, exist_ok=True)
    for name, text in outputs.items():
        (options.out / name).write_text(text)


if __name__ == "__main__":
    main()
