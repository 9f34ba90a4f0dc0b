# SPDX-License-Identifier: GPL-3.0-or-later
"""What a plugin or module needs of a machine, read by pyelftools, which auditwheel brings."""

from __future__ import annotations

from pathlib import Path

from elftools.elf.elffile import ELFFile

# The C and C++ run-time libraries of any Linux. MeshLab's and Qt's are the host's own.
RUNTIME = {
    "libc.so.6",
    "libm.so.6",
    "libgcc_s.so.1",
    "libstdc++.so.6",
    "ld-linux-x86-64.so.2",
    "ld-linux-aarch64.so.1",
}
HOST = "libmeshlab-common.so"


def superfluous(library: Path) -> set[str]:
    """The libraries that it cannot be loaded without, other than the run time's and the host's."""
    return _dynamic(library, "needed") - RUNTIME - {HOST}


def search_path(library: Path) -> set[str]:
    """The folders of the machine that built it in which it looks for libraries."""
    return _dynamic(library, "rpath") | _dynamic(library, "runpath")


def _dynamic(library: Path, kind: str) -> set[str]:
    with library.open("rb") as file:
        tags = ELFFile(file).get_section_by_name(".dynamic").iter_tags(f"DT_{kind.upper()}")
        return {getattr(tag, kind) for tag in tags}
