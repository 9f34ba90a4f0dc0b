# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that others read: written in one step, known again by their SHA-256."""

from __future__ import annotations

import hashlib
import os
from pathlib import Path


def write_in_one_step(path: Path, content: str | bytes) -> None:
    """Write a file so that it is there whole or not at all, even if the power fails.

    Text is written as UTF-8. The folder is made if it is missing.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(f"{path.name}.{os.getpid()}.part")
    with part.open("wb") as stream:
        stream.write(content.encode() if isinstance(content, str) else content)
        stream.flush()
        os.fsync(stream.fileno())
    part.replace(path)


def sha256_of(path: Path) -> str:
    """Return a file's SHA-256; raises OSError if it cannot be read."""
    with path.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()
