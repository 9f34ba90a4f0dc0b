# SPDX-License-Identifier: GPL-3.0-or-later
"""Which files of a folder are points, and what else is there."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from .registry import SUFFIXES, UnreadableFile

# Endings that notes have, too: such a file is left out where its first lines are no points.
OF_NOTES = (".txt", ".asc", ".csv")


@dataclass
class Folder:
    """The files of a folder that can be read, by name, and the others, each with its kind."""

    files: list[Path] = field(default_factory=list)
    left_out: list[tuple[Path, str]] = field(default_factory=list)
    """The kind is an ending, or what is wrong."""


def look_into(path: Path) -> Folder:
    """Return what a folder holds, without its subfolders; of a file, the file itself.

    Raises UnreadableFile where none can be read, OSError where the folder cannot.
    """
    if not path.is_dir():
        return Folder([path])
    found = Folder()
    for entry in sorted(path.iterdir()):
        if kind := _why_not(entry):
            found.left_out.append((entry, kind))
        else:
            found.files.append(entry)
    if not found.files:
        raise UnreadableFile(path, "the folder holds no file that can be read.")
    return found


def _why_not(path: Path) -> str:
    """Why an entry of a folder is no input; empty if it is one."""
    suffix = path.suffix.lower()
    if path.is_dir():
        return "subfolder"
    if path.name.startswith("."):  # of a program's, as ._x.ply beside x.ply on disks of macOS
        return "hidden"
    if suffix not in SUFFIXES:
        return suffix or "no ending"
    return "text without points" if suffix in OF_NOTES and not _begins_with_points(path) else ""


def _begins_with_points(path: Path) -> bool:
    from .text import begins_with_points

    try:
        return begins_with_points(path)
    except OSError:
        return True  # which the reader tells
