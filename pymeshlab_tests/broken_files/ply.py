# SPDX-License-Identifier: GPL-3.0-or-later
"""Broken PLY files."""

from __future__ import annotations

import math
from collections.abc import Iterator

from broken_files.common import CORNERS, floats, promise, with_value

XYZ = ("float x", "float y", "float z")
NO_END = "its header has no line end_header: the file is truncated or no PLY file."


def ply(
    *,
    form: str = "format binary_little_endian 1.0",
    before: tuple[str, ...] = (),
    count: object = len(CORNERS),
    properties: tuple[str, ...] = XYZ,
    after: tuple[str, ...] = (),
    body: bytes | None = None,
) -> bytes:
    """A PLY file of the cube's corners; each part may be replaced by a broken one."""
    lines = ["ply", form, *before, f"element vertex {count}"]
    lines += [f"property {each}" for each in properties]
    lines += [*after, "end_header", ""]
    return "\n".join(lines).encode() + (floats(CORNERS) if body is None else body)


def headers() -> Iterator[tuple[str, bytes, str]]:
    """Headers that do not follow the format."""
    text = "\n".join(" ".join(map(str, point)) for point in CORNERS).encode()
    yield (
        "ASCII",
        ply(form="format ascii 1.0", body=text),
        "it is a PLY file of text, of which no point can be read in place. Save it as binary PLY: "
        "open it in MeshLab and export it with binary encoding.",
    )
    yield "no end of header", ply().partition(b"end_header")[0], NO_END
    yield "magic only", b"ply\n", NO_END
    endless = b"ply\n" + b"comment and so on\n" * 10000
    yield "endless header", endless, NO_END
    yield "no line feeds", ply().replace(b"\n", b"\r"), NO_END
    yield "no format", ply(form=""), "its header does not say whether it is text or binary."
    yield (
        "unknown format",
        ply(form="format binary_middle_endian 1.0"),
        "its header has the unknown format 'binary_middle_endian'.",
    )
    yield (
        "unknown version",
        ply(form="format binary_little_endian 2.0"),
        "it is of PLY version '2.0'; there is only 1.0.",
    )
    twice = "format binary_little_endian 1.0\nformat binary_big_endian 1.0"
    yield "two formats", ply(form=twice), "its header has two lines of format."
    yield (
        "unknown line",
        ply(before=("elephant vertex 8",)),
        "its header has a line that PLY does not know: 'elephant vertex 8'.",
    )
    yield (
        "binary in the header",
        ply(before=("\x01\x02 \x7f" + "x" * 60,)),
        "its header has a line that PLY does not know: '?? ?" + "x" * 36 + "...'.",
    )
    yield (
        "property without element",
        ply(before=("property float x",)),
        "its header has a property before any element.",
    )
    yield (
        "list without element",
        ply(before=("property list uchar int x",)),
        "its header has a property before any element.",
    )


def counts() -> Iterator[tuple[str, bytes, str]]:
    """Counts that are wrong, and files shorter than their counts."""
    yield "zero vertices", ply(count=0), "it holds no points."
    yield "negative count", ply(count=-8), "its header has the negative count '-8'."
    yield "count no number", ply(count="many"), "its header has 'many' where a count belongs."
    yield "count with a fraction", ply(count="8.5"), "its header has '8.5' where a count belongs."
    yield "count in hexadecimal", ply(count="0x8"), "its header has '0x8' where a count belongs."
    yield (
        "count beyond 64 bits",
        ply(count=10**20),
        f"its header promises '{10**20}' elements, more than any file holds.",
    )
    for name, count in (
        ("huge count", 2**64 - 1),
        ("count whose bytes overflow to few", (2**64 + 96) // 12),
        ("count one too large", 9),
    ):
        yield name, ply(count=count), promise(count, 12, ply(count=count), 8)
    for name, kept in (("truncated in the last point", 95), ("truncated in the first point", 7)):
        content = ply(body=floats(CORNERS)[:kept])
        yield name, content, promise(8, 12, content, kept // 12)
    yield "header only", ply(body=b""), promise(8, 12, ply(body=b""), 0)
    huge = ply(before=(f"element camera {2**63}", "property double focus"))
    yield (
        "huge element before the vertices",
        huge,
        "its header promises more before the vertices than any file holds.",
    )
    beyond = ply(before=("element camera 1000", "property double focus"))
    yield "vertices beyond the end", beyond, promise(8, 12, beyond, 0)


def properties() -> Iterator[tuple[str, bytes, str]]:
    """Vertices that lack what is needed."""
    for axis in range(3):
        left = XYZ[:axis] + XYZ[axis + 1 :]
        yield (
            f"no {'xyz'[axis]}",
            ply(properties=left),
            f"its vertices have no property {'xyz'[axis]}.",
        )
    yield "no properties", ply(properties=()), "its vertices have no property x."
    yield "x twice", ply(properties=(*XYZ, "float x")), "its vertices have the property x twice."
    yield (
        "integer coordinates",
        ply(properties=("float x", "int y", "float z")),
        "its coordinate y is of type int; float or double is read.",
    )
    yield (
        "unknown type",
        ply(properties=("half x", "half y", "half z")),
        "its header has a property of the unknown type 'half'.",
    )
    yield (
        "unknown type in a list",
        ply(after=("element face 1", "property list uchar triangle vertex_indices")),
        "its header has a property of the unknown type 'triangle'.",
    )
    yield (
        "list in the vertices",
        ply(properties=(*XYZ, "list uchar int neighbours")),
        "its vertices have a list property: they differ in length, so none can be found in place. "
        "Save it without that property.",
    )
    yield (
        "faces before the vertices",
        ply(before=("element face 1", "property list uchar int vertex_indices")),
        "an element with a list comes before its vertices, so that their place is unknown. Save "
        "it with the vertices first.",
    )
    yield "no vertices", ply().replace(b"vertex", b"vortex"), "it has no vertices."
    yield (
        "vertices twice",
        ply(after=("element vertex 8", *(f"property {each}" for each in XYZ))),
        "its header has two elements of vertices.",
    )


def points() -> Iterator[tuple[str, bytes, str]]:
    """Headers in order, points not."""
    remedy = "Remove them and try again."
    for name, value in (("NaN", math.nan), ("infinite", math.inf), ("minus infinite", -math.inf)):
        yield (
            name,
            ply(body=floats(with_value(value, 2, 5))),
            "2 of 8 points have coordinates that are NaN or infinite (the first is point 2). "
            + remedy,
        )
    yield (
        "all NaN",
        ply(body=b"\xff" * 96),
        "8 of 8 points have coordinates that are NaN or infinite (the first is point 0). " + remedy,
    )
    yield (
        "all zero",
        ply(body=bytes(96)),
        "All points lie in one place: there is no surface to reconstruct.",
    )
    yield (
        "three points",
        ply(count=3),
        "Only 3 distinct points: a closed surface needs at least 4.",
    )
