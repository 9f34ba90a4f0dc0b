# SPDX-License-Identifier: GPL-3.0-or-later
"""Which reader reads which file."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path

from .._core import InvalidInput
from .cloud import Chunk


class UnreadableFile(InvalidInput):
    """A file cannot be used; the message starts with its path and says why."""

    def __init__(self, path: Path, reason: str) -> None:
        super().__init__(f"'{path}': {reason}")
        self.reason = reason


@dataclass(frozen=True)
class Format:
    """A format and the module of this package that reads it."""

    name: str
    suffixes: tuple[str, ...]
    module: str
    """Has chunks(path), which yields the points in order."""
    extra: str | None = None
    """Of this package, that installs what the module needs."""

    def chunks(self, path: Path) -> Iterator[Chunk]:
        """Yield the points of a file in order; raises UnreadableFile, OSError."""
        try:
            reader: Callable[[Path], Iterator[Chunk]] = import_module(
                f"{__package__}.{self.module}"
            ).chunks
        except ModuleNotFoundError as error:
            install = f"pip install neuralmesh[{self.extra}]" if self.extra else "pip install"
            raise UnreadableFile(
                path, f"{self.name} needs the package {error.name}: {install}."
            ) from None
        return reader(path)


# The suffixes in the order in which folders and help texts list them.
FORMATS = (
    Format("PLY", (".ply",), "ply"),
    Format("LAS, LAZ or COPC", (".las", ".laz"), "lidar"),
    Format("E57", (".e57",), "e57", extra="e57"),
    Format("PCD", (".pcd",), "pcd"),
    Format("Leica's PTS", (".pts",), "text"),
    Format("points as text", (".xyz", ".xyzrgb", ".csv", ".txt", ".asc"), "text"),
    Format("NumPy's NPY or NPZ", (".npy", ".npz"), "arrays"),
    Format("OBJ", (".obj",), "obj"),
    Format("STL", (".stl",), "stl"),
    Format("OFF", (".off",), "off"),
    Format("GLB or glTF", (".glb", ".gltf"), "gltf"),
)
SUFFIXES = tuple(suffix for known in FORMATS for suffix in known.suffixes)


def format_of(path: Path) -> Format:
    """Return the format of a file, by its suffix; raises UnreadableFile for an unknown one."""
    suffix = path.suffix.lower()
    for known in FORMATS:
        if suffix in known.suffixes:
            return known
    listed = ", ".join(SUFFIXES)
    raise UnreadableFile(path, f"'{suffix}' is of no format that is read here: {listed}.")
