# SPDX-License-Identifier: GPL-3.0-or-later
"""Which scans a batch holds: files, globs, folders and lists become items, each with its name."""

from __future__ import annotations

import glob
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

# What is taken from a folder: the formats with points or triangles that PyMeshLab reads. A file
# that is named outright may have any ending.
SCAN_SUFFIXES = {
    f".{ending}"
    for ending in (
        *("3ds", "apts", "asc", "bre", "ctm", "dae", "e57", "fbx", "glb", "gltf", "gts", "nxs"),
        *("obj", "off", "ply", "pts", "ptx", "qobj", "stl", "tri", "vmi", "wrl", "x3d", "xyz"),
    )
}


class InputError(ValueError):
    """The inputs make no batch; the message is a sentence for the user."""


@dataclass(frozen=True)
class Item:
    """A scan, by absolute path, and the name of its output: a relative path without ending."""

    source: Path
    name: str


def find_items(arguments: Iterable[str], lists: Iterable[Path], out: Path) -> list[Item]:
    """Return the batch's items, in the order given, each file once.

    A folder stands for the scans in and under it, whose outputs keep their place relative to it;
    what lies in out is left out. Files that do not exist become items too: they fail, each with
    its sentence, and the rest goes on.
    Raises InputError if a folder or a glob holds nothing, if a list cannot be read, or if two
    inputs would write the same output.
    """
    entries = [*arguments, *(line for path in lists for line in read_list(path))]
    items: dict[Path, Item] = {}
    for entry in entries:
        for item in _items_of(entry, out.resolve()):
            items.setdefault(item.source, item)
    if not items:
        raise InputError("There are no inputs.")
    refuse_collisions(items.values())
    return list(items.values())


def read_list(path: Path) -> list[str]:
    """Return the lines of a list, one input a line, without empty lines and # comments."""
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as problem:
        raise InputError(f"The list {path} cannot be read: {problem}.") from problem
    stripped = (line.strip() for line in lines)
    return [line for line in stripped if line and not line.startswith("#")]


def _items_of(entry: str, out: Path) -> Iterator[Item]:
    path = Path(entry)
    if path.is_dir():
        scans = [scan for scan in sorted(path.rglob("*")) if _is_scan(scan, out)]
        if not scans:
            raise InputError(f"The folder {entry} holds no scans.")
        for scan in scans:
            yield Item(scan.resolve(), scan.relative_to(path).with_suffix("").as_posix())
    elif path.exists() or not glob.has_magic(entry):
        yield Item(path.resolve(), path.stem)
    else:
        found = sorted(Path(name) for name in glob.glob(entry, recursive=True))
        files = [file for file in found if file.is_file()]
        if not files:
            raise InputError(f"Nothing matches {entry}.")
        for file in files:
            yield Item(file.resolve(), file.stem)


def _is_scan(path: Path, out: Path) -> bool:
    return (
        path.suffix.lower() in SCAN_SUFFIXES
        and path.is_file()
        and not path.resolve().is_relative_to(out)
    )


def refuse_collisions(items: Iterable[Item]) -> None:
    """Raise InputError, naming both inputs, if two items have the same name.

    Case does not count: there are file systems where it does not.
    """
    taken: dict[str, Item] = {}
    for item in items:
        if PurePosixPath(item.name).parts[0] in ("logs", ".batch"):
            raise InputError(f"{item.source}: its output would lie among the batch's own files.")
        first = taken.setdefault(item.name.casefold(), item)
        if first is not item:
            raise InputError(
                f"{first.source} and {item.source} would both become {item.name}: give the folder "
                "that holds them, so that outputs keep their place in it, or rename one."
            )
