# SPDX-License-Identifier: GPL-3.0-or-later
"""What folders hold that a batch leaves out: named and counted."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

# Of one kind, in a line on the screen; the report names all.
NAMES_SHOWN = 3


@dataclass(frozen=True)
class LeftOut:
    """A file or a folder that is no input, and its kind: an ending, or what is wrong with it."""

    path: Path
    kind: str


def left_out_text(left_out: Sequence[LeftOut]) -> str:
    """Return a sentence with the number of each kind and some names; empty if there is nothing."""
    kinds = Counter(found.kind for found in left_out)
    parts = []
    for kind, count in sorted(kinds.items(), key=lambda pair: (-pair[1], pair[0])):
        names = [found.path.name for found in left_out if found.kind == kind]
        more = ", …" if count > NAMES_SHOWN else ""
        parts.append(f"{count} × {kind} ({', '.join(names[:NAMES_SHOWN])}{more})")
    return f"Left out: {'; '.join(parts)}." if parts else ""
