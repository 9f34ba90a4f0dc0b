# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of points and meshes: one registry of formats, read in chunks, and the writers."""

from .cloud import Cloud, most_points_for
from .folders import Folder, look_into
from .in_place import is_read_in_place
from .reading import describe, read, read_merged
from .registry import FORMATS, UnreadableFile
from .writing import WRITTEN, write

__all__ = [
    "FORMATS",
    "WRITTEN",
    "Cloud",
    "Folder",
    "UnreadableFile",
    "describe",
    "is_read_in_place",
    "look_into",
    "most_points_for",
    "read",
    "read_merged",
    "write",
]
