# SPDX-License-Identifier: GPL-3.0-or-later
"""Broken NumPy files."""

from __future__ import annotations

import math
import struct
from collections.abc import Iterator

from broken_files.common import CORNERS, floats, promise, with_value

BAD_NPY = "its NPY header cannot be understood."


def npy(
    descr: str = "'<f4'",
    fortran: str = "False",
    shape: str = "(8, 3)",
    *,
    header: str | None = None,
    version: int = 1,
    body: bytes | None = None,
) -> bytes:
    """A NumPy file of the cube's corners; each part may be replaced by a broken one."""
    text = f"{{'descr': {descr}, 'fortran_order': {fortran}, 'shape': {shape}, }}"
    raw = ((text if header is None else header).ljust(117) + "\n").encode()
    length = struct.pack("<H" if version == 1 else "<I", len(raw))
    start = b"\x93NUMPY" + bytes([version, 0]) + length + raw
    return start + (floats(CORNERS) if body is None else body)


def headers() -> Iterator[tuple[str, bytes, str]]:
    """Headers that do not follow the format."""
    yield "magic only", b"\x93NUMPY", "its NPY header is truncated."
    yield (
        "cut in the header",
        npy()[:60],
        "its NPY header of 118 bytes is truncated: the file ends after 60.",
    )
    yield (
        "version 4",
        npy(version=4),
        "it is of version 4 of the NPY format; versions 1 to 3 are read.",
    )
    huge = b"\x93NUMPY\x02\x00\xff\xff\xff\xff" + npy()[10:]
    yield (
        "header of 4 GB",
        huge,
        "its NPY header of 4294967295 bytes is truncated: the file ends after 226.",
    )
    yield (
        "header of 20 KB",
        npy(header=" " * 20000),
        "its NPY header is 20001 bytes long; NumPy writes up to 10000.",
    )
    for name, header in (
        ("no dictionary", "import this"),
        ("empty header", ""),
        ("dictionary not closed", "{'descr': '<f4', 'fortran_order': False, 'shape': (8, 3)"),
        ("string not closed", "{'descr': '<f4, }"),
        ("entry missing", "{'descr': '<f4', 'shape': (8, 3), }"),
        ("entry twice", "{'descr': '<f4', 'descr': '<f4', 'shape': (8, 3), }"),
        ("unknown entry", "{'descr': '<f4', 'sheep': (8, 3), 'fortran_order': False}"),
        ("shape no numbers", "{'descr': '<f4', 'fortran_order': False, 'shape': (N, 3), }"),
        ("negative shape", "{'descr': '<f4', 'fortran_order': False, 'shape': (-8, 3), }"),
        ("order neither true nor false", "{'descr': '<f4', 'fortran_order': 0, 'shape': (8, 3), }"),
    ):
        yield name, npy(header=header), BAD_NPY


def arrays() -> Iterator[tuple[str, bytes, str]]:
    """Arrays that are not N by 3 float32 or float64, or not all there."""
    for kind in ("<i4", "<f2", "|O", "<c8", "|b1", "f4", ""):
        yield (
            f"numbers of type {kind}",
            npy(descr=f"'{kind}'"),
            f"its numbers are of type '{kind}'; float32 and float64 are read. Convert the array "
            "with astype.",
        )
    yield (
        "named fields",
        npy(descr="[('x', '<f4'), ('y', '<f4')]"),
        "its array has named fields; an array of N by 3 numbers is read. Save the coordinates "
        "alone.",
    )
    for shape in ("()", "(24,)", "(3, 8)", "(8, 4)", "(2, 4, 3)"):
        yield (
            f"shape {shape}",
            npy(shape=shape),
            f"its array has the shape '{shape}'; (N, 3) is read, a point a row.",
        )
    yield (
        "Fortran order",
        npy(fortran="True"),
        "its array is in Fortran order, a coordinate after the other. Save it in C order: "
        "numpy.save(file, numpy.ascontiguousarray(points))",
    )
    yield "no rows", npy(shape="(0, 3)"), "it holds no points."
    yield (
        "rows beyond 64 bits",
        npy(shape=f"({10**20}, 3)"),
        "its NPY header promises more numbers than any file holds.",
    )
    many = npy(shape=f"({2**62}, 3)")
    yield "huge array", many, promise(2**62, 12, many, 8)
    yield "truncated", npy()[:-1], promise(8, 12, npy()[:-1], 7)
    doubles = npy(descr="'<f8'")
    yield "double promised, float held", doubles, promise(8, 24, doubles, 4)
    yield (
        "NaN",
        npy(body=floats(with_value(math.nan, 7))),
        "1 of 8 points have coordinates that are NaN or infinite (the first is point 7). "
        "Remove them and try again.",
    )
