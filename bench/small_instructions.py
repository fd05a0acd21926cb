"""Instructions that small frames take, by callgrind: small_instructions.py SMALL_FRAMES LIBRARY FRAME...

Each frame is drawn a number of times and twice as often; the difference is that of frames alone.
"""

import os
import re
import subprocess
import sys
import tempfile


def instructions(program: str, library: str, frame: str, count: int) -> int:
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "callgrind")
        environment = dict(os.environ, TERRAZZO_THREADS="1", LP_NUM_THREADS="0")
        environment.setdefault("TERRAZZO_ISA", "avx2")  # what valgrind knows
        command = ["valgrind", "-q", "--tool=callgrind", f"--callgrind-out-file={out}", program, library, frame, str(count)]
        subprocess.run(command, env=environment, check=True)
        with open(out, encoding="utf-8") as text:
            return int(re.search(r"^(?:summary|totals): (\d+)", text.read(), re.MULTILINE)[1])


def main() -> None:
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    program, library, *frames = sys.argv[1:]
    for frame in frames:
        count = 50 if frame.startswith(("empty", "triangle")) else 4
        once, twice = (instructions(program, library, frame, n) for n in (count, 2 * count))
        print(f"{frame:26} {(twice - once) // count:>12}")


main()
