# SPDX-License-Identifier: GPL-3.0-or-later
"""Which scans a batch holds: files, globs, folders and lists become items, each with its name."""

from __future__ import annotations

import glob
import os
from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from neuralmesh_tools.batching.folder import REPORTS, STATE, OutFolder
from neuralmesh_tools.batching.left_out import LeftOut, left_out_text
from neuralmesh_tools.batching.names import Source, distinct_names

# The formats with points or triangles that PyMeshLab reads.
PYMESHLAB_SUFFIXES = {
    f".{ending}"
    for ending in (
        *("3ds", "apts", "asc", "bre", "ctm", "dae", "e57", "fbx", "glb", "gltf", "gts", "nxs"),
        *("obj", "off", "ply", "pts", "ptx", "qobj", "stl", "tri", "vmi", "wrl", "x3d", "xyz"),
    )
}

# The kind of what a batch left behind.
WRITTEN = "written by a batch"


class InputError(ValueError):
    """The inputs make no batch; the message is a sentence for the user."""


@dataclass(frozen=True)
class Item:
    """A scan, by absolute path, and the name of its output: a relative path without ending."""

    source: Path
    name: str


@dataclass
class Inputs:
    """The batch's items, in the order given, and what folders hold that is none of them."""

    items: list[Item] = field(default_factory=list)
    left_out: list[LeftOut] = field(default_factory=list)


def find_items(
    arguments: Iterable[str],
    lists: Iterable[Path],
    out: Path,
    suffixes: Collection[str] = PYMESHLAB_SUFFIXES,
) -> Inputs:
    """Return the batch's items, in the order given, each file once.

    A folder stands for the scans in and under it, files whose ending is one of suffixes; their
    outputs keep their place relative to it. A file that is named outright may have any ending. What
    a batch wrote in out is no scan of a folder or a glob: a folder out inside the inputs is passed
    over, and where out is a folder of scans itself, records tell. Files that do not exist become
    items too: they fail, each with its sentence, and the rest goes on. Names are told apart as
    names.py says.
    Raises InputError if an input is empty, if a folder or a glob holds nothing, or if a list cannot
    be read.
    """
    folder = OutFolder(out.resolve())
    written = folder.written()
    entries = [*arguments, *(line for path in lists for line in read_list(path))]
    sources: dict[Path, Source] = {}
    left_out: dict[Path, LeftOut] = {}
    for entry in entries:
        for found in _found_in(entry, folder.root, written, suffixes):
            if isinstance(found, LeftOut):
                left_out.setdefault(found.path, found)
            else:
                sources.setdefault(found.path, found)
    if not sources:
        raise InputError("There are no inputs.")
    names = distinct_names(list(sources.values()))
    items = [Item(path, name) for path, name in zip(sources, names, strict=True)]
    # What one folder leaves out, another entry may have named.
    return Inputs(items, [found for path, found in left_out.items() if path not in sources])


def read_list(path: Path) -> list[str]:
    """Return the lines of a list, one input a line, without empty lines and # comments."""
    try:
        # Names of files are bytes: what is no UTF-8 is kept as it is. Only line ends divide them.
        text = os.fsdecode(path.read_bytes()).removeprefix("\ufeff")
    except OSError as problem:
        raise InputError(f"The list {path} cannot be read: {problem.strerror}.") from problem
    if "\0" in text:
        raise InputError(f"The list {path} is no text: it holds zero bytes.")
    stripped = (line.strip() for line in text.split("\n"))
    return [line for line in stripped if line and not line.startswith("#")]


def _found_in(
    entry: str, out: Path, written: Collection[Path], suffixes: Collection[str]
) -> Iterator[Source | LeftOut]:
    if not entry.strip():
        raise InputError("An input is empty: it names no file. Is a variable not set?")
    path = Path(entry)
    if _is_folder(path):
        yield from _scans_in(path, out, written, suffixes)
    elif os.path.lexists(entry) or not glob.has_magic(entry):
        yield Source(_absolute(path), Path(path.name))
    else:
        found = sorted(Path(name) for name in glob.glob(entry, recursive=True))
        files = [file for file in found if file.is_file()]
        if not files:
            raise InputError(f"Nothing matches {entry}.")
        for file in files:
            path = _absolute(file)
            is_scan = path not in written
            yield Source(path, Path(file.name)) if is_scan else LeftOut(path, WRITTEN)


def _scans_in(
    folder: Path, out: Path, written: Collection[Path], suffixes: Collection[str]
) -> Iterator[Source | LeftOut]:
    """The scans in and under a folder, and what else is there; links to folders are not followed.

    Raises InputError if there is no scan.
    """
    sources, left_out = [], []
    unreadable: list[OSError] = []
    for root, folders, files in os.walk(folder, onerror=unreadable.append):
        here = Path(root)
        # A batch's own files are no inputs: neither this one's nor those of another one.
        reports = {_absolute(here) / name for name in REPORTS} if STATE in folders else set()
        entered = []
        for name in sorted(folders):
            if name == STATE or _absolute(here / name) == out:
                continue
            if reason := _why_not_entered(here / name):
                left_out.append(LeftOut(_absolute(here) / name, reason))
            else:
                entered.append(name)
        folders[:] = entered
        for path in (here / name for name in sorted(files)):
            place = _absolute(here) / path.name
            is_written = place in written or place in reports
            if reason := WRITTEN if is_written else _why_not(path, suffixes):
                left_out.append(LeftOut(place, reason))
            else:
                sources.append(Source(_absolute(path), path.relative_to(folder)))
    left_out += [
        LeftOut(Path(problem.filename), f"cannot be read: {problem.strerror}")
        for problem in unreadable
    ]
    if not sources:
        raise InputError(f"The folder {folder} holds no scans. {left_out_text(left_out)}".rstrip())
    yield from sources
    yield from left_out


def _why_not_entered(folder: Path) -> str:
    """Why scans are not looked for in a folder; empty if they are."""
    if folder.is_symlink():
        return "a link to a folder"
    return "a hidden folder" if folder.name.startswith(".") else ""


def _why_not(path: Path, suffixes: Collection[str]) -> str:
    """Why a file of a folder is no scan; empty if it is one."""
    if path.name.startswith("."):  # of a program's, as ._x.ply beside x.ply on disks of macOS
        return "hidden"
    if path.suffix.lower() not in suffixes:
        return path.suffix.lower() or "no ending"
    if path.is_file():
        return ""
    return "a link that leads nowhere" if path.is_symlink() else "not a file"


def _is_folder(path: Path) -> bool:
    try:
        return path.is_dir()
    except OSError:  # such as a name that is too long
        return False


def _absolute(path: Path) -> Path:
    try:
        return path.resolve()
    except (OSError, RuntimeError):  # a name that is too long, a link to itself
        return path.absolute()
