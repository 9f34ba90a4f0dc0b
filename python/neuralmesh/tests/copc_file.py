# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a COPC file, which laspy only reads: LAZ whose chunks are the cells of an octree.

https://copc.io: a LAS 1.4 file by LAZ in chunks of variable size, its first VLR tells where the
octree's root lies, and an EVLR holds for each cell its key, place, length and number of points.
"""

from __future__ import annotations

import io
import struct
from pathlib import Path

import laspy
import lazrs
import numpy as np
from numpy.typing import NDArray

LASZIP = ("laszip encoded", 22204)
Key = tuple[int, int, int, int]


def copc(path: Path, points: NDArray[np.float64], colours: NDArray[np.uint8]) -> None:
    """Write points (n, 3), in their order, with colours (n, 3).

    The octree's cube is twice as wide as the points, which lie in its lowest octant: so the first
    tenth can be the root's, all others one cell's of the next level, and the order stays.
    """
    las = laspy.create(point_format=7, file_version="1.4")
    las.header.scales, las.header.offsets = [1e-6] * 3, [0.0] * 3
    las.x, las.y, las.z = points.T
    las.red, las.green, las.blue = colours.T.astype(np.uint16) * 256
    las.update_header()
    half = float(np.ptp(points, axis=0).max()) + 1e-6
    centre = points.min(axis=0) + half
    tenth = len(points) // 10
    cells: dict[Key, slice] = {(0, 0, 0, 0): slice(tenth), (1, 0, 0, 0): slice(tenth, None)}
    stream = io.BytesIO()
    packer = lazrs.LazVlr.new_for_compression(7, 0, True)

    def write_head(hierarchy: int, length: int) -> None:
        info = struct.pack("<5d2Q2d88x", *centre, half, half / 10, hierarchy, length, 0, 0)
        header = las.header
        header.vlrs.clear()
        header.vlrs.append(laspy.VLR("copc", 1, "", info))
        header.vlrs.append(laspy.VLR(*LASZIP, "", packer.record_data()))
        header.are_points_compressed = True
        header.start_of_first_evlr, header.number_of_evlrs = hierarchy - 60, 1
        stream.seek(0)
        header.write_to(stream)

    write_head(60, 0)
    entries = _write_chunks(stream, packer, las.points.array, cells)
    begin = stream.seek(0, io.SEEK_END) + 60
    stream.write(struct.pack("<H16sHQ32s", 0, b"copc", 1000, len(entries), b"") + entries)
    write_head(begin, len(entries))
    path.write_bytes(stream.getvalue())


def _write_chunks(
    stream: io.BytesIO, packer: lazrs.LazVlr, records: NDArray, cells: dict[Key, slice]
) -> bytes:
    """Write the cells as chunks; return the hierarchy."""
    writer = lazrs.LasZipCompressor(stream, packer)
    writer.reserve_offset_to_chunk_table()
    entries = b""
    for key, part in cells.items():
        begin = stream.tell()
        chunk = records[part]
        writer.compress_many(np.frombuffer(chunk.tobytes(), np.uint8))
        writer.finish_current_chunk()
        entries += struct.pack("<4iQ2i", *key, begin, stream.tell() - begin, len(chunk))
    writer.done()
    return entries
