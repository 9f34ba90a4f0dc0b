# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line of `scripts/soak`."""

from __future__ import annotations

import argparse
import random
import sys
import time
from collections import Counter
from collections.abc import Sequence

import psutil

from neuralmesh_tools.properties.inputs import pick_case
from neuralmesh_tools.properties.judging import judge_run, new_process
from neuralmesh_tools.properties.runs import Run

DESCRIPTION = """\
Runs random clouds with random legal parameters, one after the other in one process. Each has to end
in a mesh that keeps every promise, or in a sentence that is true; a few such runs are a test,
pymeshlab_tests/test_properties.py. In the end the process may not be larger than it was after a
tenth of the runs, but for the slack of an allocator.

Exit codes: 0 all went well, 1 a run did not, or the process grew."""
# Of resident memory, which the largest clouds of 100,000 points leave scattered.
SLACK = 32 * 2**20


def _arguments(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="scripts/soak",
        description=DESCRIPTION,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--runs", type=int, required=True, metavar="N", help="how many")
    parser.add_argument("--seed", type=int, default=1, metavar="N", help="other runs (default 1)")
    parser.add_argument(
        "--by",
        choices=["package", "plugin"],
        default="package",
        help="neuralmesh, or the plugin in PyMeshLab (default: package)",
    )
    return parser.parse_args(arguments)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command and return its exit code."""
    options = _arguments(arguments)
    picking = random.Random(options.seed)
    ends: Counter[str] = Counter()
    sizes: list[int] = []
    begin = time.perf_counter()
    with new_process() as process:
        for number in range(options.runs):
            case = pick_case(picking.choice)
            run, fault = judge_run(process, f"by_{options.by}", case)
            ends["faults" if fault else _end_of(run)] += 1
            if fault:
                print(f"run {number}: {fault}\n  {case}", flush=True)
            if process.pid is not None:
                sizes.append(psutil.Process(process.pid).memory_info().rss)
    seconds = time.perf_counter() - begin
    first, last = (sizes[len(sizes) // 10] / 2**20, sizes[-1] / 2**20) if sizes else (0.0, 0.0)
    print(
        f"{options.runs:,} runs in {seconds:.0f} s: {ends['meshes']:,} meshes, "
        f"{ends['refusals']:,} refusals, {ends['faults']:,} faults; {first:.0f} MB resident after "
        f"a tenth of them, {last:.0f} MB in the end"
    )
    return 1 if ends["faults"] or last - first > SLACK / 2**20 else 0


def _end_of(run: Run | None) -> str:
    return "refusals" if run is not None and run.refusal else "meshes"


if __name__ == "__main__":
    sys.exit(main())
