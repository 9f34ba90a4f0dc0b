# SPDX-License-Identifier: GPL-3.0-or-later
"""What is switched off, where in the source, and which test is to notice.

A mechanism that is worth its lines has a mutant here. The text of a mutant stands exactly once in
its file: a refactoring that moves it moves it here too (pymeshlab_tests/test_mutants.py).
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from neuralmesh_tools.changed_build import changed_text

FOLDER = "filter_neuralmesh"


@dataclass(frozen=True)
class Mutant:
    """One change of one source file, and the C++ tests that fail with it."""

    name: str
    switches_off: str
    """A clause: what the core no longer does."""
    file: str
    """Below filter_neuralmesh."""
    text: str
    """Stands exactly once in the file."""
    replacement: str
    tests: tuple[str, ...]
    """Names as GoogleTest has them; each of them fails."""

    @property
    def path(self) -> str:
        """The file, from the root of the project."""
        return f"{FOLDER}/{self.file}"

    def applied(self, root: Path) -> str:
        """Return the text of the file with the change made.

        Raises Stale if the file is not there or does not hold the text exactly once.
        """
        return changed_text(root, self.path, self.text, self.replacement, self.name)
