# SPDX-License-Identifier: GPL-3.0-or-later
"""What the outputs of a batch, and the clouds of a report, are called: no two of them the same."""

from __future__ import annotations

import hashlib
import os
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from neuralmesh_tools.files import is_foreign_byte


@dataclass(frozen=True)
class Source:
    """A file by its absolute path, and its place: its path in the folder that was given."""

    path: Path
    place: Path


def distinct_names(sources: Sequence[Source]) -> list[str]:
    """Return a name for each of the files: its place without ending, where it alone has that.

    Files of one name keep apart by their ending (`cloud.ply`, `cloud.xyz`), those of one ending
    too by as many folders above them as it takes (`a/cloud.ply`, `b/cloud.ply`), and what is left,
    such as two names that differ by case only, by a hash of their path. Case does not count: there
    are file systems where it does not.
    """
    ladders = [_candidates(source) for source in sources]
    names = [next(ladder) for ladder in ladders]
    while True:
        count = Counter(name.casefold() for name in names)
        clashes = [k for k, name in enumerate(names) if count[name.casefold()] > 1]
        if not clashes:
            return names
        for k in clashes:
            names[k] = next(ladders[k])


def _candidates(source: Source) -> Iterator[str]:
    """Names that a file may have, from the plain one to one that no other file has."""
    place = source.place
    # ..ply has a stem of one dot, which is no name but the folder itself.
    stem = place.stem if place.stem.strip(".") else place.name
    yield _text(place.parent / stem)
    yield _text(place)
    parts = [part for part in source.path.parts[1:] if part not in ("..", "/")]
    for count in range(len(place.parts) + 1, len(parts) + 1):
        yield "/".join(_text(part) for part in parts[-count:])
    digest = hashlib.sha256(os.fsencode(source.path)).hexdigest()
    for length in range(8, len(digest) + 1, 8):
        yield f"{_text(place)}-{digest[:length]}"


def _text(place: Path | str) -> str:
    """A place as text that any program reads: bytes that are no UTF-8 become %FF."""
    text = place.as_posix() if isinstance(place, Path) else place
    return "".join(
        f"%{ord(character) - 0xDC00:02X}" if is_foreign_byte(character) else character
        for character in text
    )
