# SPDX-License-Identifier: GPL-3.0-or-later
"""What the first bytes of a file say of its kind and length.

Libraries find out late, or not at all, that a file is cut short, and say it in words of their own.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from .lines import cut_short
from .registry import UnreadableFile


@dataclass(frozen=True)
class Signature:
    """The first bytes of a format, and where it says how many bytes there are at the least."""

    name: str
    magic: bytes
    length: tuple[int, int] = (0, 0)
    """Begin and end, in little-endian order; empty where the header does not say it."""


LIDAR = Signature("LAS or LAZ", b"LASF", (96, 100))  # up to the points
SIGNATURES = {
    ".las": LIDAR,
    ".laz": LIDAR,
    ".e57": Signature("E57", b"ASTM-E57", (16, 24)),
    ".glb": Signature("GLB", b"glTF", (8, 12)),
    ".npy": Signature("NPY", b"\x93NUMPY"),
    ".npz": Signature("NPZ", b"PK"),
    ".ply": Signature("PLY", b"ply"),
}


def require_whole(path: Path) -> None:
    """Refuse a file that begins otherwise than its format, or is shorter than its header says.

    Raises UnreadableFile, OSError.
    """
    signature = SIGNATURES.get(path.suffix.lower())
    if signature is None:
        return
    begin, end = signature.length
    needed = max(len(signature.magic), end)
    with path.open("rb") as file:
        head = file.read(needed)
    if not head.startswith(signature.magic[: len(head)]):
        raise UnreadableFile(path, f"it is no {signature.name} file: it does not begin as one.")
    if len(head) < needed:
        raise UnreadableFile(path, f"it is cut short: it ends after {len(head):,} bytes.")
    promised, held = int.from_bytes(head[begin:end], "little"), path.stat().st_size
    if held < promised:
        raise cut_short(path, promised, held, "bytes")
