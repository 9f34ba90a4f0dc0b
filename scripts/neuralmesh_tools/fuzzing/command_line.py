# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line of `scripts/fuzz`."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

from neuralmesh_tools.fuzzing.run import BUILD, fuzz
from neuralmesh_tools.fuzzing.seeds import SEEDS
from neuralmesh_tools.project import ROOT

DESCRIPTION = """\
Fuzzes by libFuzzer, under address and undefined-behaviour sanitizers: operations on rings, headers
of point files, expressions, and whole reconstructions. Says how many inputs were tried and how many
branches of the code were taken.

What is worth keeping of a run is left in out/fuzz/TARGET/corpus, where the next one goes on, and
what breaks the code in out/fuzz/TARGET/findings: once it is mended, its input goes into
filter_neuralmesh/fuzz/regressions/TARGET, which tests run in every build.

Exit codes: 0 nothing was found, 1 something was, 2 there is no build of such a target."""


def _arguments(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="scripts/fuzz",
        description=DESCRIPTION,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument(
        "--minutes", type=float, required=True, metavar="N", help="for each target, by the clock"
    )
    parser.add_argument(
        "--target", action="append", choices=list(SEEDS), help="this one (may be repeated)"
    )
    parser.add_argument("--seed", type=int, default=0, metavar="N", help="0, the default: by time")
    parser.add_argument(
        "--out", type=Path, default=ROOT / "out" / "fuzz", metavar="DIR", help="default: out/fuzz"
    )
    return parser.parse_args(arguments)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command and return its exit code."""
    options = _arguments(arguments)
    is_clean = True
    for target in options.target or SEEDS:
        if not (BUILD / f"fuzz_{target}").is_file():
            print(f"There is no fuzz_{target}: run scripts/build fuzz.", file=sys.stderr)
            return 2
        done = fuzz(target, max(1, round(60 * options.minutes)), options.out, options.seed)
        print(done.line(), flush=True)
        if not done.is_clean:
            print(f"  {done.log} says how.", flush=True)
        is_clean = is_clean and done.is_clean
    return 0 if is_clean else 1
