# SPDX-License-Identifier: GPL-3.0-or-later
"""E57, by libe57 of pye57: in chunks, each scan in its place among the others."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pye57 import ScanHeader, libe57
from pye57.utils import convert_spherical_to_cartesian

from .cloud import Chunk
from .lines import cut_short
from .registry import UnreadableFile

POINTS = 200_000  # a tenth of a second, after which Ctrl-C is heard
CARTESIAN = ("cartesianX", "cartesianY", "cartesianZ")
SPHERICAL = ("sphericalRange", "sphericalAzimuth", "sphericalElevation")
COLOURS = ("colorRed", "colorGreen", "colorBlue")
Records = dict[str, NDArray[np.float64]]


def chunks(path: Path) -> Iterator[Chunk]:
    """Yield the valid points of each scan."""
    file = libe57.ImageFile(str(path), "r")
    try:
        scans = [ScanHeader(node) for node in file.root()["data3D"]]
        scans = [scan for scan in scans if scan.point_count > 0]  # libe57 cannot read of others
        total, read = sum(scan.point_count for scan in scans), 0
        for scan in scans:
            for records in _records(path, file, scan):
                read += len(next(iter(records.values())))
                yield _chunk(scan, records, read / total)
        if read < total:
            raise cut_short(path, total, read, "points")
    finally:
        file.close()


def _records(path: Path, file: Any, scan: ScanHeader) -> Iterator[Records]:
    """Coordinates, colours and whether they are invalid, as far as the scan has them."""
    has = set(scan.point_fields)
    places = next((names for names in (CARTESIAN, SPHERICAL) if has.issuperset(names)), None)
    if places is None:
        raise UnreadableFile(path, "a scan has neither Cartesian nor spherical coordinates.")
    wanted = (*places, _validity(places), *(COLOURS if has.issuperset(COLOURS) else ()))
    arrays = {name: np.empty(POINTS) for name in wanted if name in has}
    buffers = libe57.VectorSourceDestBuffer()
    for name, array in arrays.items():
        buffers.append(libe57.SourceDestBuffer(file, name, array, POINTS, True, True))
    reader = scan.node["points"].reader(buffers)
    try:
        while count := reader.read():
            yield {name: array[:count] for name, array in arrays.items()}
    finally:
        reader.close()


def _chunk(scan: ScanHeader, records: Records, done: float) -> Chunk:
    names = CARTESIAN if CARTESIAN[0] in records else SPHERICAL
    states = records.get(_validity(names))
    valid = slice(None) if states is None else states == 0
    points = np.column_stack([records[name][valid] for name in names])
    if names is SPHERICAL:
        points = convert_spherical_to_cartesian(points)
    if scan.has_pose():
        points = points @ scan.rotation_matrix.T + scan.translation
    colours = None
    if COLOURS[0] in records:
        shares = [records[name][valid] / _most(scan, name) for name in COLOURS]
        colours = np.clip(np.rint(255 * np.column_stack(shares)), 0, 255).astype(np.uint8)
    invalid = 0 if states is None else int((states != 0).sum())
    return Chunk(np.ascontiguousarray(points), colours, done, invalid)


def _validity(names: tuple[str, ...]) -> str:
    return "cartesianInvalidState" if names is CARTESIAN else "sphericalInvalidState"


def _most(scan: ScanHeader, colour: str) -> float:
    """The value that stands for full brightness: by the scan's limits, or by the field's type."""
    try:
        most = float(scan.node["colorLimits"][f"{colour}Maximum"].value())
    except libe57.E57Exception:
        field = libe57.StructureNode(scan.node["points"].prototype())[colour]
        most = float(field.maximum()) if isinstance(field, libe57.IntegerNode) else 1.0
    return most if most > 0 else 255.0
