# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that others read: written in one step, known again by their SHA-256, named to be read."""

from __future__ import annotations

import hashlib
import os
import uuid
from pathlib import Path

# What file systems hold of a name, in bytes, less what somebody may put behind it (".mtl").
LONGEST_NAME = 250
BYTES_AT_A_TIME = 1 << 20


def write_in_one_step(path: Path, content: str | bytes) -> None:
    """Write a file so that it is there whole or not at all, even if the power fails.

    Text is written as UTF-8. The folder is made if it is missing. Raises OSError; the file is then
    as it was.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    # Of its own name: one made of the file's would be too long where that is nearly so.
    part = path.parent / f".{uuid.uuid4().hex}.part"
    try:
        with part.open("xb") as stream:
            stream.write(content.encode() if isinstance(content, str) else content)
            stream.flush()
            os.fsync(stream.fileno())
        part.replace(path)
    except BaseException:
        part.unlink(missing_ok=True)
        raise


def sha256_of(path: Path) -> str:
    """Return a file's SHA-256; raises OSError if it cannot be read."""
    digest = hashlib.sha256()
    with path.open("rb") as stream:
        while part := stream.read(BYTES_AT_A_TIME):
            digest.update(part)
    return digest.hexdigest()


def shown(text: object) -> str:
    r"""Text as a terminal, a table or a page can show it, such as the path of a file.

    A name may hold bytes that are no UTF-8 (Python has them as lone surrogates), line ends, and
    sequences that move a terminal's cursor: these become escapes such as \\xff.
    """
    return "".join(
        character if character.isprintable() else _escape(character) for character in str(text)
    )


def _escape(character: str) -> str:
    if is_foreign_byte(character):
        return f"\\x{ord(character) - 0xDC00:02x}"
    return character.encode("unicode_escape", "surrogatepass").decode("ascii")


def is_foreign_byte(character: str) -> bool:
    """Whether a character of a path stands for a byte that is no UTF-8."""
    return "\udc80" <= character <= "\udcff"


def fitting(name: str, ending: str) -> str:
    """The name of a file with an ending, cut to what file systems hold; a hash tells it apart."""
    whole = name + ending
    if len(os.fsencode(whole)) <= LONGEST_NAME:
        return whole
    mark = "-" + hashlib.sha256(os.fsencode(whole)).hexdigest()[:12]
    room = LONGEST_NAME - len(mark) - len(os.fsencode(ending))
    return os.fsencode(name)[:room].decode("utf-8", "ignore") + mark + ending
