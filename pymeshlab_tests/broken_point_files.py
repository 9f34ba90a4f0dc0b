#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A corpus of broken point files, each with the sentence that has to answer it.

The tests in PyMeshLab import it; the C++ tests, under sanitizers too, run it as a script, with the
program that opens the files:

    broken_point_files.py --probe build/release/filter_neuralmesh/tests/point_file_probe

Exit codes: 0 each file got its sentence, 1 one did not. Needs the standard library only.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from broken_files import las, npy, ply

OTHER_FORMAT = (
    "it is of another format than those read in place: binary PLY, LAS and NPY. "
    "Its first bytes are those of none."
)


@dataclass(frozen=True)
class BrokenFile:
    """A file to be refused: a name that says what is wrong, its bytes, the refusal."""

    name: str
    content: bytes
    sentence: str


def other_formats() -> Iterator[tuple[str, bytes, str]]:
    """Files of no format that is read in place."""
    yield "empty", b"", "the file is empty."
    yield "one byte", b"p", OTHER_FORMAT
    yield "no PLY but nearly", b"plywood", OTHER_FORMAT
    yield "text", b"0 0 0\n1 0 0\n", OTHER_FORMAT
    yield "zeros", bytes(1000), OTHER_FORMAT
    yield "OFF", b"OFF\n8 0 0\n", OTHER_FORMAT
    yield (
        "E57",
        b"ASTM-E57" + bytes(1016),
        "it is an E57 file, whose points are packed in pages, so that none can be read in place. "
        "Convert it first: open it in MeshLab and export it as PLY with binary encoding.",
    )
    yield (
        "NPZ",
        b"PK\x03\x04" + bytes(100),
        "it is a ZIP archive (NPZ is one too), so that no point can be read in place. Unpack it "
        "first.",
    )
    yield (
        "gzip",
        b"\x1f\x8b\x08" + bytes(100),
        "it is compressed by gzip, so that no point can be read in place. Unpack it first.",
    )


def corpus() -> list[BrokenFile]:
    """All broken files, in a fixed order, with names of their own."""
    groups = {
        "PLY": (ply.headers, ply.counts, ply.properties, ply.points),
        "LAS": (las.headers, las.counts, las.coordinates, las.compressed),
        "NPY": (npy.headers, npy.arrays),
        "other": (other_formats,),
    }
    return [
        BrokenFile(f"{group}: {name}", content, sentence)
        for group, makers in groups.items()
        for maker in makers
        for name, content, sentence in maker()
    ]


VALID = {
    "PLY": ply.ply(),
    "LAS 1.2": las.las(),
    "LAS 1.4": las.las(4),
    "NPY": npy.npy(),
    "NPY 3": npy.npy(version=3),
}


def check(probe: Path) -> int:
    """Write the corpus, run the program on all of it; return the exit code."""
    cases = [(file.name, file.content, file.sentence) for file in corpus()]
    cases += [(name, content, None) for name, content in VALID.items()]
    with tempfile.TemporaryDirectory() as folder:
        paths = [Path(folder) / str(i) for i in range(len(cases))]
        for path, (_, content, _) in zip(paths, cases, strict=True):
            path.write_bytes(content)
        run = subprocess.run([probe, *paths], capture_output=True, text=True, check=False)
    answers = run.stdout.splitlines()
    if run.returncode != 0 or len(answers) != len(cases):
        print(f"crashed (exit code {run.returncode}) after {len(answers)} files: {run.stderr}")
        return 1
    wrong = 0
    for path, (name, _, sentence), answer in zip(paths, cases, answers, strict=True):
        expected = "accepted" if sentence is None else f"PointFile '{path}': {sentence}"
        if answer != expected:
            print(f"{name}\n  expected: {expected}\n  got:      {answer}")
            wrong += 1
    print(f"{len(cases) - wrong} of {len(cases)} files were answered as they should.")
    return 1 if wrong else 0


def main() -> int:
    """Run the command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--probe", type=Path, required=True, help="opens each file it is given")
    return check(parser.parse_args().probe)


if __name__ == "__main__":
    sys.exit(main())
