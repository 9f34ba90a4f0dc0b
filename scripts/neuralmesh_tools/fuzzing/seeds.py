# SPDX-License-Identifier: GPL-3.0-or-later
"""What fuzzing starts from: a few valid inputs of each target, and hints for its mutations.

`python -m neuralmesh_tools.fuzzing.seeds TARGET FOLDER` writes them, by the standard library alone.
"""

from __future__ import annotations

import itertools
import math
import struct
import sys
from collections.abc import Iterator
from pathlib import Path

from neuralmesh_tools.project import ROOT

# Of the expressions: after the byte for kind and range, an expression or three.
IMPLICIT, PARAMETRIC, EVALUATED = b"\x01\x04", b"\x02\x04", b"\x00\x04"
EXPRESSIONS = (
    EVALUATED + b"x*x + y*y + z*z - 1",
    EVALUATED + b"sin(x) + cos(y)^2 > 0.5 ? exp(z) : sqrt(abs(x))",
    EVALUATED + b"min(x, y, z, 1e-3) && rint(_pi) || ln(_e)",
    EVALUATED + b"a = x, b = 2",
    EVALUATED + b"((((x))",
    EVALUATED + b"x / 0 + 1e999",
    IMPLICIT + b"x*x + y*y + z*z - 0.25",
    IMPLICIT + b"sin(9*x) * sin(9*y) * sin(9*z)",
    IMPLICIT + b"1",
    PARAMETRIC + b"cos(u)\nsin(u)\nv",
    PARAMETRIC + b"u\nv\n1/(u-v)",
    PARAMETRIC + b"u\nu\nu",
)
WORDS = (
    *("sin", "cos", "tan", "exp", "ln", "sqrt", "abs", "min(", "max(", "sum(", "avg(", "rint"),
    *("_pi", "_e", "&&", "||", "==", "?", ":", "^", "e+308", "1e-320", "x", "y", "z", "u", "v"),
)
HEADER_WORDS = (
    *("ply\\x0a", "format binary_little_endian 1.0\\x0a", "format binary_big_endian 1.0\\x0a"),
    *("element vertex ", "element face ", "property double x\\x0a", "property float y\\x0a"),
    *("property list uchar int vertex_indices\\x0a", "end_header\\x0a", "comment ", "obj_info "),
    *("\\x93NUMPY", "'descr': '<f8'", "'fortran_order': True", "'shape': (2, 3)", "LASF"),
)


def ring_operations() -> Iterator[bytes]:
    """Programs: which mesh, then operation, vertex, neighbour and more."""
    for mesh in range(8):
        steps = itertools.product(range(8), (0, 3), (0, 1))
        yield bytes([mesh, *itertools.chain.from_iterable(steps)])
        yield bytes([mesh]) + b"\x02\x00\x01\x01" * 9 + b"\x00\x01\x00\x04\x02\x00\x06\x00"


def point_file_headers() -> Iterator[bytes]:
    """Valid files, and the broken ones that tests have sentences for."""
    sys.path.append(str(ROOT / "pymeshlab_tests"))
    from broken_files import las, npy, ply
    from broken_point_files import corpus

    yield from (ply.ply(), npy.npy(), npy.npy("'>f8'", "True"), las.las())
    yield from (file.content for file in corpus() if len(file.content) < 2000)


def expressions() -> Iterator[bytes]:
    """Expressions, implicit and parametric surfaces."""
    yield from EXPRESSIONS


def reconstructions() -> Iterator[bytes]:
    """Fourteen bytes of parameters, a unit, and points of three bytes."""
    rates = [15, 12, 250]
    for switches, start, count in itertools.product((0, 1, 2, 21), (0, 2, 4), (6, 40)):
        parameters = [12, switches, start, 4, 60, 11, *rates, 6, 1, 0, 30]
        yield bytes(parameters) + _sphere(count)
    # From a tetrahedron that is given.
    corners = bytes([4, 0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2])
    places = bytes([4, 0, 0, 0, 16, 0, 0, 0, 16, 0, 0, 0, 16])
    start = bytes([12, 0, 3, 4, 60, 11, *rates, 6, 1, 0]) + corners + places
    yield start + bytes([30]) + _sphere(40)


def _sphere(count: int) -> bytes:
    """Points of three signed bytes on a spiral from pole to pole."""
    steps = []
    for i in range(count):
        z = 1 - (2 * i + 1) / count
        r = math.sqrt(1 - z * z)
        steps += [r * math.cos(2.4 * i), r * math.sin(2.4 * i), z]
    return struct.pack(f"{len(steps)}b", *(round(100 * step) for step in steps))


SEEDS = {
    "ring_operations": ring_operations,
    "point_file_headers": point_file_headers,
    "expressions": expressions,
    "reconstructions": reconstructions,
}
DICTIONARIES = {"point_file_headers": HEADER_WORDS, "expressions": WORDS}


def write_seeds(target: str, folder: Path) -> None:
    """Write the seeds of a target, and the words of its dictionary, if it has one."""
    seeds = folder / "seeds"
    seeds.mkdir(parents=True, exist_ok=True)
    for number, content in enumerate(SEEDS[target]()):
        (seeds / f"{number:03}").write_bytes(content)
    if words := DICTIONARIES.get(target):
        lines = "".join(f'"{word}"\n' for word in words)
        (folder / "dictionary").write_text(lines, encoding="utf-8")


if __name__ == "__main__":
    write_seeds(sys.argv[1], Path(sys.argv[2]))
